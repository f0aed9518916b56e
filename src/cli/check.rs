//! `editor check`: what is in a file, and what is wrong with it.

mod collada;
mod names;
mod oddities;

use super::output::{DiagnosticJson, eprint_line, json_text, visible};
use super::pipes::Ends;
use super::{CliError, print};
use crate::character::{Influence, SkeletalModel};
use crate::disk::{as_given, files};
use crate::editor::Session;
use crate::io::{Diagnostic, Files, Loaded, PoseFile, TestsFile, builtin, import_collada};
use crate::scene::{EvaluatedShape, Shape, ShapeKind, ViewSettings};
use collada::ColladaReport;
use names::Asked;
use oddities::oddities;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Say what is in each FILE and what is odd about it.
///
/// Mistakes are reported as path:line:column with what was expected and what was found; with --json
/// errors and warnings are objects {"file", "line", "column", "message"}, where line and column are
/// null if it is about the file as a whole. Odd are, too, a mesh and a skeleton of quite different sizes, faces that
/// are turned inside out, and names of files that fit but for capitals. Poses are checked against the characters among
/// the files.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), poses (.json), builtin:NAME, or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// Output of `--json`.
#[derive(Debug, Serialize)]
struct Report {
    files: Vec<FileReport>,
}

#[derive(Debug, Serialize)]
struct FileReport {
    path: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<DiagnosticJson>,
    shapes: Vec<ShapeReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    posed_joints: Option<usize>,
    /// Number of joints in each pose of a file with several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    poses: Vec<PoseReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    collada: Option<ColladaReport>,
    warnings: Vec<DiagnosticJson>,
}

/// Contents of a shape; bounds are in the world.
#[derive(Debug, Serialize)]
struct ShapeReport {
    name: String,
    kind: &'static str,
    vertices: usize,
    triangles: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    skeleton: Option<SkeletonReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curves: Option<CurvesReport>,
    materials: Vec<String>,
    bounds: Option<[[f32; 3]; 2]>,
}

/// A pose of a file with several.
#[derive(Debug, Serialize)]
struct PoseReport {
    name: String,
    joints: usize,
}

#[derive(Debug, Serialize)]
struct CurvesReport {
    curves: usize,
    points: usize,
    surfaces: usize,
}

#[derive(Debug, Serialize)]
struct SkeletonReport {
    joints: usize,
    roots: usize,
    most_influences: usize,
    weight_sums: Option<[f32; 2]>,
}

impl Args {
    /// What may be standard input or output.
    pub(super) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: self.files.iter_mut().collect(),
            output: None,
        }
    }
}

/// Carries the command out.
///
/// # Errors
/// If a file is wrong, or a pose has a joint that no character among the files has; the others are
/// checked all the same.
pub fn run(args: &Args) -> Result<(), CliError> {
    let files = files();
    let mut report = Report { files: Vec::new() };
    let mut failed = false;
    let checked: Vec<Result<Checked, Diagnostic>> =
        args.files.iter().map(|path| check(&files, path)).collect();
    let sound: Vec<&Checked> = checked.iter().flatten().collect();
    let skeletons: Vec<&SkeletalModel> = sound.iter().flat_map(|file| &file.skeletons).collect();
    // A file that is wrong may be the character that has the joint.
    let are_known = sound.len() == checked.len() && !skeletons.is_empty();
    let misfits: Vec<Option<Diagnostic>> = checked
        .iter()
        .map(|file| {
            let mut poses = file.as_ref().ok()?.poses.iter().filter(|_| are_known);
            poses.find_map(|pose| pose.poses_of(&skeletons).err())
        })
        .collect();
    for ((path, checked), misfit) in args.files.iter().zip(checked).zip(misfits) {
        let (of_file, error) = match checked {
            Ok(checked) => (checked.report, misfit),
            Err(error) => (FileReport::new(path), Some(error)),
        };
        if let Some(error) = &error {
            eprint_line(format_args!("error: {error}"));
            failed = true;
        }
        report.files.push(FileReport {
            error: error.as_ref().map(DiagnosticJson::from),
            ..of_file
        });
    }
    let text = if args.json {
        json_text(&report)?
    } else {
        let sound = report.files.iter().filter(|file| file.error.is_none());
        sound.map(in_words).collect::<Vec<_>>().join("\n")
    };
    print(&text)?;
    if failed {
        Err(CliError::Reported)
    } else {
        Ok(())
    }
}

impl FileReport {
    fn new(path: &Path) -> Self {
        Self {
            path: as_given(path).to_string(),
            error: None,
            shapes: Vec::new(),
            posed_joints: None,
            poses: Vec::new(),
            collada: None,
            warnings: Vec::new(),
        }
    }
}

/// A file that is sound by itself.
struct Checked {
    report: FileReport,
    /// Skeletons of the characters in it.
    skeletons: Vec<SkeletalModel>,
    poses: Vec<PoseFile>,
}

/// Checks a file, and whether it and what it names are called as they are looked for.
fn check(files: &dyn Files, path: &Path) -> Result<Checked, Diagnostic> {
    let asked = Asked::new(files);
    let checked = check_content(&asked, path);
    let names = asked.other_capitals(path).into_iter();
    match checked {
        Ok(mut checked) => {
            let warnings = names.map(|what| Diagnostic::new(path, what));
            let warnings = warnings.map(|warning| DiagnosticJson::from(&warning));
            checked.report.warnings.extend(warnings);
            Ok(checked)
        }
        // The name may be why it is wrong.
        Err(mut error) => {
            names.for_each(|what| error.message += &format!("; {what}"));
            Err(error)
        }
    }
}

fn check_content(files: &dyn Files, path: &Path) -> Result<Checked, Diagnostic> {
    let file = builtin::resolve(path)?;
    let is = |extension: &str| {
        file.extension()
            .is_some_and(|found| found.eq_ignore_ascii_case(extension))
    };
    if is("json") {
        return check_poses(path, &file, &files.read(&file)?);
    }
    let mut loaded = Loaded::default();
    let mut collada = None;
    if is("dae") {
        let read = import_collada(files, path)?;
        loaded.add_imported(read.map(|(shapes, report)| {
            collada = Some(ColladaReport::from(report));
            shapes
        }));
    } else {
        loaded.add(files, path)?;
    }
    let session = Session::with_shapes(loaded.shapes, ViewSettings::default());
    let shapes = session.scene().shapes().iter();
    let evaluated = &session.evaluated().shapes;
    let skeletons = shapes.clone().filter_map(|shape| match &shape.kind {
        ShapeKind::Character(shape) => Some(shape.character.skeleton().clone()),
        _ => None,
    });
    let odd = shapes.clone().filter(|shape| shape.source.is_some());
    let odd = odd
        .flat_map(oddities)
        .map(|what| Diagnostic::new(path, what));
    let odd: Vec<Diagnostic> = odd.collect();
    Ok(Checked {
        report: FileReport {
            shapes: shapes
                .clone()
                .zip(evaluated)
                .map(|(shape, evaluated)| shape_report(shape, evaluated))
                .collect(),
            collada,
            warnings: (loaded.warnings.iter().chain(&odd))
                .map(DiagnosticJson::from)
                .collect(),
            ..FileReport::new(path)
        },
        skeletons: skeletons.collect(),
        poses: Vec::new(),
    })
}

/// Checks the content of `file`, called `path`, which has one pose or several.
fn check_poses(path: &Path, file: &Path, bytes: &[u8]) -> Result<Checked, Diagnostic> {
    let mut report = FileReport::new(path);
    let mut poses = Vec::new();
    match PoseFile::read_several(file, bytes)? {
        Some(several) => {
            for (name, pose) in several {
                let joints = posed_joints(&pose);
                report.poses.push(PoseReport { name, joints });
                poses.push(pose);
            }
        }
        None => {
            let pose = PoseFile::read(file, bytes);
            let pose = pose.map_err(|error| match TestsFile::read(file, bytes) {
                Ok(_) => Diagnostic::new(file, "expected a pose, found tests for editor grade"),
                Err(_) => error,
            })?;
            report.posed_joints = Some(posed_joints(&pose));
            poses.push(pose);
        }
    }
    Ok(Checked {
        report,
        skeletons: Vec::new(),
        poses,
    })
}

fn posed_joints(pose: &PoseFile) -> usize {
    let data = pose.data();
    let keys = data.joints.keys().chain(data.roots.keys());
    keys.map(|joint| joint.as_str())
        .collect::<BTreeSet<_>>()
        .len()
}

fn shape_report(shape: &Shape, evaluated: &EvaluatedShape) -> ShapeReport {
    let mesh = &evaluated.geometry.mesh;
    let bounds = evaluated.world_bounds();
    let mut materials: Vec<String> = Vec::new();
    for group in &mesh.groups {
        if !materials.contains(&group.material.name) {
            materials.push(group.material.name.clone());
        }
    }
    ShapeReport {
        name: shape.name.clone(),
        kind: shape.kind.label(),
        vertices: mesh.positions.len(),
        triangles: mesh.triangles.len(),
        skeleton: skeleton(&shape.kind),
        curves: evaluated.geometry.curves.as_ref().map(|all| CurvesReport {
            curves: all.curves.len(),
            points: all.curves.iter().map(|curve| curve.points.len()).sum(),
            surfaces: all.surfaces.len(),
        }),
        materials,
        bounds: (!bounds.is_empty()).then(|| [bounds.min.to_array(), bounds.max.to_array()]),
    }
}

fn skeleton(kind: &ShapeKind) -> Option<SkeletonReport> {
    let ShapeKind::Character(shape) = kind else {
        return None;
    };
    let character = &shape.character;
    let attachments = character.attachments();
    let weighed = attachments.vertices().filter(|run| !run.is_empty());
    let sums = weighed.map(|run: &[Influence]| run.iter().map(|i| f64::from(i.weight)).sum());
    let range = sums.fold(None, |range: Option<[f32; 2]>, sum: f64| {
        let sum = sum as f32;
        Some(range.map_or([sum; 2], |[low, high]| [low.min(sum), high.max(sum)]))
    });
    Some(SkeletonReport {
        joints: character.skeleton().joints().len(),
        roots: character.skeleton().roots().len(),
        most_influences: attachments.most_influences(),
        weight_sums: range,
    })
}

fn in_words(file: &FileReport) -> String {
    let mut out = format!("{}\n", visible(&file.path));
    // Writing to a string cannot fail.
    let mut line = |name: &str, value: String| {
        let _ = writeln!(out, "  {name:<16} {}", visible(&value));
    };
    let of_joints = |joints: usize| match joints {
        1 => "of 1 joint".to_owned(),
        joints => format!("of {joints} joints"),
    };
    if let Some(joints) = file.posed_joints {
        line("pose", of_joints(joints));
    }
    for PoseReport { name, joints } in &file.poses {
        line("pose", format!("{name}, {}", of_joints(*joints)));
    }
    for shape in &file.shapes {
        line(&shape.kind.to_lowercase(), shape.name.clone());
        line("  vertices", shape.vertices.to_string());
        line("  triangles", shape.triangles.to_string());
        if let Some(skeleton) = &shape.skeleton {
            let roots = if skeleton.roots == 1 { "root" } else { "roots" };
            let joints = format!("{} ({} {roots})", skeleton.joints, skeleton.roots);
            line("  joints", joints);
            let most = skeleton.most_influences;
            line("  influences", format!("at most {most} a vertex"));
            if let Some([low, high]) = skeleton.weight_sums {
                line("  weight sums", format!("{low:.4} to {high:.4}"));
            }
        }
        if let Some(curves) = &shape.curves {
            let points = format!("{} ({} points)", curves.curves, curves.points);
            line("  curves", points);
            line("  surfaces", curves.surfaces.to_string());
        }
        if !shape.materials.is_empty() {
            line("  materials", shape.materials.join(", "));
        }
        if let Some([min, max]) = shape.bounds {
            let corner = |of: [f32; 3]| {
                // What rounds to zero has no sign.
                let [x, y, z] = of.map(|value| if value.abs() <= 5e-5 { 0.0 } else { value });
                format!("({x:.4}, {y:.4}, {z:.4})")
            };
            line("  bounds", format!("{} to {}", corner(min), corner(max)));
        }
    }
    for (name, value) in file.collada.iter().flat_map(ColladaReport::in_words) {
        line(name, value);
    }
    for warning in &file.warnings {
        line("warning", warning.in_words.clone());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    /// Files of the disk, with a record of those that were read.
    #[derive(Default)]
    struct Counted(Mutex<Vec<PathBuf>>);

    impl Files for Counted {
        fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
            self.0.lock().unwrap().push(path.to_owned());
            crate::disk::files().read(path)
        }

        fn exists(&self, path: &Path) -> bool {
            crate::disk::files().exists(path)
        }
    }

    #[test]
    fn a_collada_file_and_its_picture_are_read_once() {
        let files = Counted::default();
        let report = check(&files, Path::new("builtin:rigs/crate"))
            .unwrap()
            .report;
        assert!(!report.collada.unwrap().in_words().is_empty());
        assert_eq!(report.shapes[0].kind, "Character");
        let read = files.0.into_inner().unwrap();
        assert_eq!(read.len(), 2, "{read:?}");
    }
}
