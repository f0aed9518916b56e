//! Reading files elsewhere than where that was asked for.

use super::file_importer::{import_any_by, import_character_by, import_shape_by};
use super::{Diagnostic, Files, Imported, Loaded, Missing, import_curve};
use crate::scene::NewShape;
use crate::steps::{Pace, Steps};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes that a step reads.
const STEP: usize = 1 << 16;

/// Triangles of meshes whose order for rays is worked out with the reading: the pointer would have to
/// wait for it.
const LARGE: usize = 1 << 16;

/// Files that are read one after the other.
#[derive(Clone)]
pub struct ReadJob {
    /// Where they are read.
    pub files: Arc<dyn Files>,
    /// Their paths, in order.
    pub paths: Vec<PathBuf>,
    /// What is wanted of them.
    pub wanted: Wanted,
}

/// What is wanted of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// All that can be opened, as [`Loaded::add`] reads it.
    Document(Missing),
    /// All that [`import_any`](super::import_any) finds.
    Any,
    /// What [`import_shape`](super::import_shape) finds.
    Shape,
    /// What [`import_character`](super::import_character) finds.
    Character,
    /// What [`import_curve`] finds.
    Curve,
}

/// Content of the files of a job.
#[derive(Clone, Debug, Default)]
pub struct ReadFiles {
    /// What could be read.
    pub loaded: Loaded,
    /// Number of shapes from each file, in the order of the files.
    pub counts: Vec<usize>,
    /// Why others could not, in their order.
    pub failed: Vec<Diagnostic>,
}

impl fmt::Debug for ReadJob {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("ReadJob");
        shown.field("paths", &self.paths);
        shown.field("wanted", &self.wanted).finish_non_exhaustive()
    }
}

impl ReadJob {
    /// The content of the files, in steps of some milliseconds: the same as if each was read at once.
    pub fn read(self) -> Steps<'static, ReadFiles> {
        self.read_in(STEP)
    }

    fn read_in(self, step: usize) -> Steps<'static, ReadFiles> {
        Steps::new(step, |pace| async move {
            let mut read = ReadFiles::default();
            if let Wanted::Document(missing) = self.wanted {
                read.loaded.missing = missing;
            }
            let count = self.paths.len() as f32;
            for (index, path) in self.paths.iter().enumerate() {
                let share = index as f32 / count..(index + 1) as f32 / count;
                let added = self.add(path, &mut read.loaded, &pace);
                read.failed.extend(pace.within(share, added).await.err());
                let before: usize = read.counts.iter().sum();
                read.counts.push(read.loaded.shapes.len() - before);
            }
            for shape in &read.loaded.shapes {
                let mesh = shape.kind.mesh();
                if mesh.triangles.len() > LARGE {
                    pace.after(step).await;
                    mesh.triangle_order();
                }
            }
            read
        })
    }

    async fn add(&self, path: &Path, loaded: &mut Loaded, pace: &Pace) -> Result<(), Diagnostic> {
        let files = &*self.files;
        let imported: Imported<Vec<NewShape>> = match self.wanted {
            Wanted::Document(_) => return loaded.add_by(files, path, pace).await,
            Wanted::Any => import_any_by(files, path, pace).await?,
            Wanted::Shape => import_shape_by(files, path, pace).await?,
            Wanted::Character => import_character_by(files, path, pace).await?,
            Wanted::Curve => import_curve(files, path)?,
        };
        loaded.add_imported(imported);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::builtin::{self, PREFIX, WithBuiltin};
    use proptest::prelude::*;
    use std::collections::HashMap;
    use std::fmt::Write;

    type Table = HashMap<PathBuf, Vec<u8>>;

    fn job(files: Table, paths: &[&str], wanted: Wanted) -> ReadJob {
        ReadJob {
            files: Arc::new(WithBuiltin(files)),
            paths: paths.iter().map(PathBuf::from).collect(),
            wanted,
        }
    }

    /// All that was read, with the bits of all numbers, and the number of steps.
    fn read_in(job: &ReadJob, step: usize) -> (String, usize) {
        let mut steps = job.clone().read_in(step);
        let (mut count, mut part) = (1, 0.0);
        let read = loop {
            match steps.step() {
                Some(read) => break read,
                None => count += 1,
            }
            assert!(part <= steps.part() && steps.part() <= 1.0);
            part = steps.part();
        };
        let ReadFiles { loaded, failed, .. } = read;
        let told = loaded.warnings.iter().chain(&failed);
        let told: Vec<String> = told.map(ToString::to_string).collect();
        let shapes = format!("{:?}", loaded.shapes);
        (format!("{} {told:?}", without_revisions(&shapes)), count)
    }

    /// The revisions of two that were read are never the same.
    fn without_revisions(shown: &str) -> String {
        let digit = |c: char| c.is_ascii_digit();
        let parts = shown.split("Revision(");
        parts.map(|part| part.trim_start_matches(digit)).collect()
    }

    #[test]
    fn every_built_in_file_is_the_same_in_steps_as_at_once() {
        let document = Wanted::Document(Missing::StandIn);
        let (mut files, mut interrupted) = (0, 0);
        for builtin in builtin::catalogue() {
            if builtin.kind == builtin::BuiltinKind::Pose {
                continue;
            }
            let path = format!("{PREFIX}{}", builtin.name);
            let job = job(Table::new(), &[&path], document);
            let (whole, one) = read_in(&job, usize::MAX);
            let (read, count) = read_in(&job, 1);
            assert!(read == whole, "{path}");
            assert_eq!(one, 1, "{path}");
            files += 1;
            interrupted += usize::from(count > 1);
        }
        assert!(
            files > 20 && interrupted > files / 2,
            "{interrupted} of {files}"
        );
    }

    /// An `.obj` file of a grid with so many rows, and lines of all kinds in it.
    fn grid(rows: usize) -> String {
        let mut text = String::from("mtllib a.mtl\nvt 0 0\nvt 1e-3 .5\nvn 0 0 1\n");
        for y in 0..rows {
            for x in 0..8 {
                let _ = writeln!(text, "v {}.{y}5 {x} -0.{y} # {x}", x * y);
            }
        }
        for y in 1..rows {
            for x in 1..8 {
                let [a, b] = [8 * (y - 1) + x, 8 * y + x];
                let face = match (x + y) % 4 {
                    0 => format!("{a} {b} {}", b + 1),
                    1 => format!("{a}/1 {b}/2 {}/1 {}/2", b + 1, a + 1),
                    2 => format!("{a}/1/1 {b}//1 {}", b + 1),
                    _ => format!("{a}"),
                };
                let _ = writeln!(text, "usemtl m{}\nf {face}", x % 3);
            }
        }
        text
    }

    proptest! {
        #[test]
        fn any_size_of_steps_gives_the_same_shapes_warnings_and_errors(
            rows in 2..400_usize,
            step in 1..200_000_usize,
            fault in prop::option::of(0.0..1.0_f64),
        ) {
            let mut text = grid(rows);
            if let Some(part) = fault {
                let at = (part * text.len() as f64) as usize;
                text.replace_range(at..=at, "x");
            }
            let mtl = b"newmtl m0\nKd 1 0 0\nnewmtl m2\nKd oops\n".to_vec();
            let files = [("a.obj", text.into_bytes()), ("a.mtl", mtl)];
            let files = files.map(|(path, bytes)| (PathBuf::from(path), bytes));
            let paths = ["gone.obj", "a.obj", "builtin:gem"];
            for wanted in [Wanted::Any, Wanted::Shape] {
                let job = job(files.clone().into(), &paths, wanted);
                prop_assert_eq!(read_in(&job, step).0, read_in(&job, usize::MAX).0);
            }
        }
    }

    #[test]
    fn a_step_reads_no_more_than_its_share() {
        let text = grid(10_000);
        let length = text.len();
        let job = job(
            [("a.obj".into(), text.into_bytes())].into(),
            &["a.obj"],
            Wanted::Any,
        );
        let (_, count) = read_in(&job, STEP);
        assert!(count > length / STEP, "{count} steps for {length} bytes");
    }
}
