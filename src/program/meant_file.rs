//! Files as they were meant by names that were typed in a dialog.

use super::Purpose;
use crate::io::Files;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

impl Purpose {
    /// `path` as it was meant, if the file is to be written: with the extension where it has none of
    /// its formats, as in Blender, so that `v1.2` and `Dr. No` are names; or once with one that was
    /// given twice. Dialogs select a name without its extension, so that one that is typed with it
    /// comes out as `my.scene.scene`. An extension of another format of this program gives way: who types
    /// `turn.png` for an animation, to which a dialog adds `.gif`, wants no file called `turn.png.gif`; and who types
    /// `a.jpg` for a picture, to which it adds `.png`, wants that.
    pub fn completed(self, path: &Path) -> Option<PathBuf> {
        let (_, extension) = self.written().first()?;
        let stem = path.file_stem().map(Path::new)?;
        if path.extension().is_some() && path.extension() == stem.extension() {
            return Some(path.with_file_name(stem));
        }
        if matches!(self, Self::SaveScreenshot(_) | Self::SaveComparison)
            && path.extension().is_some_and(|end| self.writes(end))
            && stem.extension().is_some_and(|typed| self.writes(typed))
        {
            return Some(path.with_file_name(stem));
        }
        let is_other = |end: &OsStr| is_known(end) && !self.writes(end);
        if let Some(end) = path.extension().filter(|end| self.writes(end)) {
            let gives_way = stem.extension().is_some_and(is_other);
            return gives_way.then(|| path.with_file_name(stem.with_extension(end)));
        }
        if path.extension().is_some_and(is_other) {
            return Some(path.with_extension(extension));
        }
        let mut name = path.file_name()?.to_owned();
        name.push(format!(".{extension}"));
        Some(path.with_file_name(name))
    }

    /// `path` as it was meant, if the file is to be read and is not there: with the extension of the one
    /// file of its formats that is, since dialogs let a path be typed without.
    pub fn found(self, files: &dyn Files, path: &Path) -> Option<PathBuf> {
        if !self.written().is_empty() || files.exists(path) {
            return None;
        }
        let name = path.file_name()?;
        let with = |extension: &&str| {
            let mut name = name.to_owned();
            name.push(".");
            name.push(extension);
            path.with_file_name(name)
        };
        let is_there = |path: &PathBuf| files.exists(path) && self.offers(files, path);
        let mut found = self.offered().iter().map(with).filter(is_there);
        found.next().filter(|_| found.next().is_none())
    }

    /// Whether files with this extension may be written.
    fn writes(self, extension: &OsStr) -> bool {
        let extension = extension.to_string_lossy().to_lowercase();
        let as_listed = match &*extension {
            "jpeg" => "jpg",
            other => other,
        };
        self.written().iter().any(|(_, own)| *own == as_listed)
    }
}

/// Whether files of this program have this extension, or pictures of others.
fn is_known(extension: &OsStr) -> bool {
    const KNOWN: &[&str] = &[
        "scene", "zip", "obj", "mtl", "dae", "swp", "skel", "attach", "json", "png", "jpg", "jpeg",
        "gif", "bmp", "webp", "tif", "tiff",
    ];
    let extension = extension.to_string_lossy().to_lowercase();
    KNOWN.contains(&&*extension)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ShapeId;
    use crate::ui::{Screenshot, Turntable};
    use std::collections::HashMap;

    #[test]
    fn a_file_to_read_is_found_without_its_extension_where_only_one_is_meant() {
        let names = ["a/man.obj", "a/man.skel", "a/man.json", "a/v1.2.dae", "a/b"];
        let names = names.into_iter().chain(["a/two.obj", "a/two.dae"]);
        let files: HashMap<PathBuf, Vec<u8>> =
            names.map(|name| (name.into(), Vec::new())).collect();
        let found = |purpose: Purpose, name| {
            let path = purpose.found(&files, Path::new(name))?;
            Some(path.display().to_string())
        };
        let pose = Purpose::LoadPose(ShapeId(1));
        assert_eq!(found(Purpose::Open, "a/man").unwrap(), "a/man.obj");
        assert_eq!(found(pose, "a/man").unwrap(), "a/man.json");
        assert_eq!(found(Purpose::Open, "a/v1.2").unwrap(), "a/v1.2.dae");
        for (purpose, name) in [
            (Purpose::Open, "a/man.obj"),
            (Purpose::Open, "a/b"),
            (Purpose::Open, "a/two"),
            (Purpose::Open, "a/none"),
            (Purpose::ImportCurve, "a/man"),
            (Purpose::ExportGeometry, "a/man"),
        ] {
            assert_eq!(found(purpose, name), None, "{name}");
        }
    }

    #[test]
    fn a_name_to_save_that_has_none_of_its_extensions_gets_the_first() {
        let save = Purpose::SavePose(ShapeId(1), None);
        let walk = PathBuf::from("poses/walk.json");
        assert_eq!(save.completed(Path::new("poses/walk")), Some(walk));
        for name in ["v1.2", "Dr. No", "a.", "walk.txt", "a.b"] {
            let complete = PathBuf::from(format!("poses/{name}.json"));
            assert_eq!(
                save.completed(&Path::new("poses").join(name)),
                Some(complete)
            );
        }
        assert_eq!(save.completed(Path::new("poses/walk.json")), None);
        let twice = Path::new("poses/walk.json.json");
        assert_eq!(save.completed(twice), Some("poses/walk.json".into()));
        let picture = Purpose::SaveComparison;
        for name in ["a.PNG", "a.jpeg", "a.gif"] {
            assert_eq!(picture.completed(Path::new(name)), None);
        }
        assert_eq!(Purpose::Compare.completed(Path::new("picture")), None);
    }

    #[test]
    fn the_extension_of_another_format_gives_way_to_that_which_is_written() {
        let turning = Purpose::SaveScreenshot(Screenshot {
            turntable: Some(Turntable {
                frames: 36,
                fit: true,
            }),
            ..Screenshot::default()
        });
        let pose = Purpose::SavePose(ShapeId(1), None);
        for (purpose, typed, meant) in [
            (turning, "x.png", "x.gif"),
            // As a dialog hands it over that adds what it takes to be missing.
            (turning, "x.png.gif", "x.gif"),
            (turning, "x.JPG", "x.gif"),
            (Purpose::SaveComparison, "a.bmp", "a.png"),
            (Purpose::SaveComparison, "a.jpg.png", "a.jpg"),
            (Purpose::ExportGeometry, "man.json", "man.obj"),
            (Purpose::ExportGeometry, "man.v2.dae.obj", "man.v2.obj"),
            (pose, "q.zip", "q.json"),
        ] {
            let completed = purpose.completed(&Path::new("a b").join(typed));
            assert_eq!(completed, Some(Path::new("a b").join(meant)), "{typed}");
        }
        for (purpose, name) in [
            (turning, "x.gif"),
            (turning, "v1.2.gif"),
            (Purpose::SaveComparison, "a.v2.jpg"),
            (Purpose::SaveWithFiles, "my.scene.zip"),
        ] {
            assert_eq!(purpose.completed(Path::new(name)), None, "{name}");
        }
    }
}
