//! `editor check`: what is in a file, and what is wrong with it.

use super::output::{DiagnosticJson, eprint_line, json_text, visible};
use super::{CliError, print};
use crate::character::Influence;
use crate::disk::files;
use crate::editor::Session;
use crate::io::dae::{DaeReport, UpAxis};
use crate::io::{Diagnostic, Files, Loaded, PoseFile, builtin, import_collada};
use crate::scene::{EvaluatedShape, Shape, ShapeKind, ViewSettings};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Say what is in each FILE and what is odd about it.
///
/// Mistakes are reported as path:line:column with what was expected and what was found; with --json
/// errors and warnings are objects {"file", "line", "column", "message"}, where line and column are
/// null if it is about the file as a whole.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), poses (.json), or builtin:NAME
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

/// Carries the command out.
///
/// # Errors
/// If a file is wrong; the others are checked all the same.
pub fn run(args: &Args) -> Result<(), CliError> {
    let files = files();
    let mut report = Report { files: Vec::new() };
    let mut failed = false;
    for path in &args.files {
        let (of_file, error) = match check(&files, path) {
            Ok(of_file) => (of_file, None),
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
            path: path.display().to_string(),
            error: None,
            shapes: Vec::new(),
            posed_joints: None,
            collada: None,
            warnings: Vec::new(),
        }
    }
}

fn check(files: &dyn Files, path: &Path) -> Result<FileReport, Diagnostic> {
    let file = builtin::resolve(path)?;
    let is = |extension: &str| {
        file.extension()
            .is_some_and(|found| found.eq_ignore_ascii_case(extension))
    };
    if is("json") {
        let pose = PoseFile::read(&file, &files.read(&file)?)?;
        let data = pose.data();
        let keys = data.joints.keys().chain(data.roots.keys());
        let joints: BTreeSet<&str> = keys.map(|joint| joint.as_str()).collect();
        return Ok(FileReport {
            posed_joints: Some(joints.len()),
            ..FileReport::new(path)
        });
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
    let shapes = session
        .scene()
        .shapes()
        .iter()
        .zip(&session.evaluated().shapes);
    Ok(FileReport {
        shapes: shapes
            .map(|(shape, evaluated)| shape_report(shape, evaluated))
            .collect(),
        collada,
        warnings: loaded.warnings.iter().map(DiagnosticJson::from).collect(),
        ..FileReport::new(path)
    })
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
    if let Some(joints) = file.posed_joints {
        let noun = if joints == 1 { "joint" } else { "joints" };
        line("pose", format!("of {joints} {noun}"));
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

/// Contents of a Collada file besides its shapes.
#[derive(Debug, Serialize)]
struct ColladaReport {
    up_axis: &'static str,
    meters_per_unit: f64,
    skins: usize,
    /// Range in the file; the shapes' weights have been divided by their sums.
    weight_sums: Option<[f32; 2]>,
    unweighted_vertices: usize,
    inverse_bind_difference: Option<Difference>,
    ignored: BTreeMap<String, usize>,
}

/// Largest difference between inverse bind matrices and scene.
#[derive(Debug, Serialize)]
struct Difference {
    joint: String,
    difference: f64,
}

impl ColladaReport {
    /// Lines of the report as text: label and value.
    fn in_words(&self) -> Vec<(&'static str, String)> {
        let mut lines = vec![(
            "collada",
            format!("{} up, {} m a unit", self.up_axis, self.meters_per_unit),
        )];
        if self.skins > 0 {
            lines.push(("  skins", self.skins.to_string()));
        }
        if let Some([low, high]) = self.weight_sums {
            lines.push((
                "  weight sums",
                format!("{low:.4} to {high:.4} in the file"),
            ));
        }
        if self.unweighted_vertices > 0 {
            let count = self.unweighted_vertices;
            let which = if count == 1 {
                "vertex stays"
            } else {
                "vertices stay"
            };
            lines.push(("  unweighted", format!("{count} {which} at rest")));
        }
        if let Some(Difference { joint, difference }) = &self.inverse_bind_difference {
            let most = if *difference == 0.0 {
                "as in the scene".to_owned()
            } else {
                format!("differs from the scene by at most {difference:.1e}, at {joint}")
            };
            lines.push(("  bind pose", most));
        }
        for (what, count) in &self.ignored {
            lines.push(("  ignored", format!("{count} × {what}")));
        }
        lines
    }
}

impl From<DaeReport> for ColladaReport {
    fn from(report: DaeReport) -> Self {
        Self {
            up_axis: match report.space.up {
                UpAxis::X => "X",
                UpAxis::Y => "Y",
                UpAxis::Z => "Z",
            },
            meters_per_unit: report.space.meters,
            skins: report.skins,
            weight_sums: report.weight_sums.map(|(low, high)| [low, high]),
            unweighted_vertices: report.unweighted,
            inverse_bind_difference: report.worst_inverse_bind.map(|worst| Difference {
                joint: worst.joint,
                difference: worst.difference,
            }),
            ignored: report.ignored,
        }
    }
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
        let report = check(&files, Path::new("builtin:rigs/crate")).unwrap();
        assert!(!report.collada.unwrap().in_words().is_empty());
        assert_eq!(report.shapes[0].kind, "Character");
        let read = files.0.into_inner().unwrap();
        assert_eq!(read.len(), 2, "{read:?}");
    }

    #[test]
    fn a_bind_pose_without_a_difference_is_reported_as_equal() {
        let lines = |difference| {
            let report = ColladaReport {
                up_axis: "Y",
                meters_per_unit: 1.0,
                skins: 1,
                weight_sums: None,
                unweighted_vertices: 1,
                inverse_bind_difference: Some(Difference {
                    joint: "Bone.002".to_owned(),
                    difference,
                }),
                ignored: BTreeMap::new(),
            };
            report.in_words()[2..]
                .iter()
                .map(|(_, words)| words.clone())
                .collect::<Vec<_>>()
        };
        assert_eq!(lines(0.0), ["1 vertex stays at rest", "as in the scene"]);
        let most = "differs from the scene by at most 1.5e-3, at Bone.002";
        assert_eq!(lines(0.0015)[1], most);
    }
}
