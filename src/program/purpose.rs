//! Purposes for which files are chosen: which files suit them, and what they are called.

use crate::io::Files;
use crate::revision::Revision;
use crate::scene::ShapeId;
use crate::ui::Screenshot;
use std::path::{Path, PathBuf};

/// Places and a name that a host suggests to whoever chooses a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Suggested {
    /// Folder to begin in, if the host knows it.
    pub folder: Option<PathBuf>,
    /// Folders that were used last, the newest first.
    pub recent: Vec<PathBuf>,
    /// Name of a file that is to be written.
    pub name: String,
}

/// Kind of files that people keep together in a folder.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum FileKind {
    /// Scenes and archives of them.
    Scenes,
    /// Shapes and characters.
    Models,
    /// Shapes and characters that are written: what others have made is not to be written among.
    Exports,
    /// Curves and surfaces, which the course has in a folder of their own.
    Curves,
    /// Poses.
    Poses,
    /// Pictures.
    Pictures,
    /// Pictures and meshes of other programs, which are compared with: what is handed in is not to come among them.
    References,
}

/// Request for a file. A host keeps it, and gives it back with the answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileRequest {
    /// Purpose for which the file is chosen.
    pub purpose: Purpose,
    /// The scene that was open, since shapes are named by their place in it: an answer that comes
    /// after another was opened is about none of its shapes.
    pub(crate) opened: Revision,
}

/// Purpose for which a file is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// File ▸ Open.
    Open,
    /// File ▸ Save As, or Save for the first time.
    SaveScene,
    /// File ▸ Save with Files.
    SaveWithFiles,
    /// Finding the file that a shape came from.
    FindSource(ShapeId),
    /// Import ▸ Import Shape.
    ImportShape,
    /// Import ▸ Import Curve.
    ImportCurve,
    /// Import ▸ Import Character.
    ImportCharacter,
    /// Writing the curves of a shape.
    ExportCurve(ShapeId),
    /// Writing the geometry of the scene.
    ExportGeometry,
    /// Writing the geometry of the selected shapes.
    ExportSelected,
    /// Writing the geometry of the scene with its materials.
    ExportMaterials,
    /// Writing a character as `.skel`, `.attach` and `.obj`.
    ExportCharacter(ShapeId),
    /// Writing a picture of the view or of the window.
    SaveScreenshot(Screenshot),
    /// Reading a picture to compare the view with.
    Compare,
    /// Reading a mesh to compare a character with.
    CompareMesh(ShapeId),
    /// Writing a comparison as a picture.
    SaveComparison,
    /// Writing the pose of a character, or the kept one with this index.
    SavePose(ShapeId, Option<usize>),
    /// Reading a pose for a character.
    LoadPose(ShapeId),
}

impl Purpose {
    /// Title of a dialog.
    pub fn title(self) -> &'static str {
        match self {
            Self::Open => "Open",
            Self::SaveScene => "Save As",
            Self::SaveWithFiles => "Save with Files",
            Self::FindSource(_) => "Find the File of a Shape",
            Self::ImportShape => "Import Shape",
            Self::ImportCharacter => {
                "Import Character (.dae, or .obj with .skel and .attach beside it)"
            }
            Self::ImportCurve => "Import Curve",
            Self::ExportCurve(_) => "Export Curve",
            Self::ExportGeometry => "Export Geometry of All Shapes",
            Self::ExportSelected => "Export Geometry of the Selected Shapes",
            Self::ExportMaterials => {
                "Export All Shapes with Materials (.obj, with .mtl and pictures beside it)"
            }
            Self::ExportCharacter(_) => {
                "Export Character (.skel, with .attach, .obj and .json beside it)"
            }
            Self::SaveScreenshot(_) => "Save Screenshot",
            Self::Compare => "Compare with Picture",
            Self::CompareMesh(_) => {
                "Compare with Mesh (.obj or .txt, as another program posed the character)"
            }
            Self::SaveComparison => "Save Comparison",
            Self::SavePose(..) => "Save Pose",
            Self::LoadPose(_) => "Load Pose",
        }
    }

    /// Name of the kind of files, with their extensions.
    pub fn filter(self) -> &'static str {
        match self {
            Self::Open => "Scenes and models (.scene, .zip, .obj, .dae, .swp)",
            Self::SaveWithFiles => "Archives and scenes (.zip, .scene)",
            Self::FindSource(_) => "Models (.obj, .dae, .swp)",
            Self::SaveScene => "Scenes (.scene)",
            Self::ImportShape => "Shapes (.obj, .dae)",
            Self::ImportCharacter => "Characters (.obj, .dae)",
            Self::ImportCurve | Self::ExportCurve(_) => "Curves (.swp)",
            Self::ExportGeometry | Self::ExportSelected | Self::ExportMaterials => {
                "Geometry (.obj)"
            }
            Self::CompareMesh(_) => "Meshes (.obj, .txt)",
            Self::ExportCharacter(_) => "Skeletons (.skel)",
            Self::SaveScreenshot(shot) if shot.turntable.is_some() => "Animations (.gif)",
            Self::SaveScreenshot(shot) if shot.transparent => "Pictures (.png)",
            Self::SavePose(..) | Self::LoadPose(_) => "Poses (.json)",
            Self::SaveScreenshot(_) | Self::Compare | Self::SaveComparison => {
                "Pictures (.png, .jpg, .gif)"
            }
        }
    }

    /// Formats that may be written, by name and extension, the default first; none if the file is
    /// read.
    pub fn written(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::SaveScene => &[("Scenes", "scene")],
            Self::SaveWithFiles => &[("Archives", "zip"), ("Scene with a folder", "scene")],
            Self::ExportCurve(_) => &[("Curves", "swp")],
            Self::ExportGeometry | Self::ExportSelected | Self::ExportMaterials => {
                &[("Geometry", "obj")]
            }
            Self::ExportCharacter(_) => &[("Skeletons", "skel")],
            Self::SaveScreenshot(shot) if shot.turntable.is_some() => &[("GIF", "gif")],
            Self::SaveScreenshot(shot) if shot.transparent => &[("PNG", "png")],
            Self::SavePose(..) => &[("Poses", "json")],
            Self::SaveScreenshot(_) | Self::SaveComparison => {
                &[("PNG", "png"), ("JPEG", "jpg"), ("GIF", "gif")]
            }
            Self::Open
            | Self::FindSource(_)
            | Self::ImportShape
            | Self::ImportCurve
            | Self::ImportCharacter
            | Self::Compare
            | Self::CompareMesh(_)
            | Self::LoadPose(_) => &[],
        }
    }

    /// Kind of the files, for which a folder of its own is remembered.
    pub fn kind(self) -> FileKind {
        match self {
            Self::Open | Self::SaveScene | Self::SaveWithFiles => FileKind::Scenes,
            Self::FindSource(_) | Self::ImportShape | Self::ImportCharacter => FileKind::Models,
            Self::ExportGeometry
            | Self::ExportSelected
            | Self::ExportMaterials
            | Self::ExportCharacter(_) => FileKind::Exports,
            Self::ImportCurve | Self::ExportCurve(_) => FileKind::Curves,
            Self::SavePose(..) | Self::LoadPose(_) => FileKind::Poses,
            Self::SaveScreenshot(_) | Self::SaveComparison => FileKind::Pictures,
            Self::Compare | Self::CompareMesh(_) => FileKind::References,
        }
    }

    /// The shape that the file is about, if it is about one.
    pub(super) fn shape(self) -> Option<ShapeId> {
        match self {
            Self::ExportCurve(id)
            | Self::ExportCharacter(id)
            | Self::SavePose(id, _)
            | Self::LoadPose(id)
            | Self::CompareMesh(id)
            | Self::FindSource(id) => Some(id),
            Self::Open
            | Self::SaveScene
            | Self::SaveWithFiles
            | Self::ImportShape
            | Self::ImportCurve
            | Self::ImportCharacter
            | Self::ExportGeometry
            | Self::ExportSelected
            | Self::ExportMaterials
            | Self::SaveScreenshot(_)
            | Self::Compare
            | Self::SaveComparison => None,
        }
    }

    /// Whether what is written is for other programs, and no document of this one.
    pub fn is_export(self) -> bool {
        matches!(
            self,
            Self::ExportCurve(_)
                | Self::ExportGeometry
                | Self::ExportSelected
                | Self::ExportMaterials
                | Self::ExportCharacter(_)
        )
    }

    /// Whether a dialog offers `path`. AppleDouble files, which archives from some systems carry
    /// beside the real ones, are never offered.
    pub fn offers(self, files: &dyn Files, path: &Path) -> bool {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("._") {
            return false;
        }
        let extension = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        let has = |other: &str| files.exists(&path.with_extension(other));
        let is_character = extension != "obj" || has("skel") || has("attach");
        self.offered().contains(&&*extension) && (self != Self::ImportCharacter || is_character)
    }

    /// Extensions of the files that a dialog offers.
    pub(super) fn offered(self) -> &'static [&'static str] {
        match self {
            Self::Open => &["scene", "zip", "obj", "dae", "swp"],
            Self::SaveWithFiles => &["zip", "scene"],
            Self::FindSource(_) => &["obj", "dae", "swp"],
            Self::SaveScene => &["scene"],
            Self::ImportShape | Self::ImportCharacter => &["obj", "dae"],
            Self::ExportGeometry | Self::ExportSelected | Self::ExportMaterials => &["obj"],
            Self::CompareMesh(_) => &["obj", "txt"],
            Self::ExportCharacter(_) => &["skel"],
            Self::SavePose(..) | Self::LoadPose(_) => &["json"],
            Self::ImportCurve | Self::ExportCurve(_) => &["swp"],
            Self::SaveScreenshot(_) | Self::Compare | Self::SaveComparison => {
                &["png", "jpg", "jpeg", "gif"]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    fn offered(purpose: Purpose) -> Vec<&'static str> {
        let names = [
            "man.obj",
            "man.skel",
            "cup.obj",
            "rig.DAE",
            "a.swp",
            "a.json",
            "a.png",
            "a.JPG",
            "a.gif",
            "a.txt",
            "._man.obj",
            "._a.png",
            "tube.obj",
            "tube.attach",
            "noext",
        ];
        let files: HashMap<PathBuf, Vec<u8>> =
            names.iter().map(|name| (name.into(), Vec::new())).collect();
        let offered = |name: &&str| purpose.offers(&files, Path::new(name));
        names.into_iter().filter(offered).collect()
    }

    #[test]
    fn a_dialog_offers_the_files_that_its_purpose_can_read_or_write() {
        assert_eq!(
            offered(Purpose::ImportShape),
            ["man.obj", "cup.obj", "rig.DAE", "tube.obj"]
        );
        assert_eq!(
            offered(Purpose::ImportCharacter),
            ["man.obj", "rig.DAE", "tube.obj"]
        );
        assert_eq!(offered(Purpose::ImportCurve), ["a.swp"]);
        assert_eq!(offered(Purpose::ExportCurve(ShapeId(1))), ["a.swp"]);
        assert_eq!(
            offered(Purpose::ExportGeometry),
            ["man.obj", "cup.obj", "tube.obj"]
        );
        assert_eq!(
            offered(Purpose::CompareMesh(ShapeId(1))),
            ["man.obj", "cup.obj", "a.txt", "tube.obj"]
        );
        assert_eq!(offered(Purpose::LoadPose(ShapeId(1))), ["a.json"]);
        assert_eq!(offered(Purpose::SavePose(ShapeId(1), None)), ["a.json"]);
        assert_eq!(offered(Purpose::Compare), ["a.png", "a.JPG", "a.gif"]);
        assert_eq!(
            offered(Purpose::SaveComparison),
            ["a.png", "a.JPG", "a.gif"]
        );
    }
}
