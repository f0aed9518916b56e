use crate::editor::Screenshot;
use crate::scene::ShapeId;
use egui_file_dialog::{DialogState, FileDialog, Filter};
use std::path::{Path, PathBuf};

/// What a chosen file is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Purpose {
    ImportShape,
    ImportCurve,
    ImportCharacter,
    ExportCurve(ShapeId),
    ExportGeometry,
    SaveScreenshot(Screenshot),
    Compare,
    SaveComparison,
    SavePose(ShapeId, Option<usize>),
    LoadPose(ShapeId),
}

impl Purpose {
    fn title(self) -> &'static str {
        match self {
            Self::ImportShape => "Import Shape",
            Self::ImportCharacter => {
                "Import Character (.dae, or .obj with .skel and .attach beside it)"
            }
            Self::ImportCurve => "Import Curve",
            Self::ExportCurve(_) => "Export Curve",
            Self::ExportGeometry => "Export Geometry",
            Self::SaveScreenshot(_) => "Save Screenshot",
            Self::Compare => "Compare with Picture",
            Self::SaveComparison => "Save Comparison",
            Self::SavePose(..) => "Save Pose",
            Self::LoadPose(_) => "Load Pose",
        }
    }

    fn filter(self) -> &'static str {
        match self {
            Self::ImportShape => "Shapes (.obj, .dae)",
            Self::ImportCharacter => "Characters (.obj, .dae)",
            Self::ImportCurve | Self::ExportCurve(_) => "Curves (.swp)",
            Self::ExportGeometry => "Geometry (.obj)",
            Self::SavePose(..) | Self::LoadPose(_) => "Poses (.json)",
            Self::SaveScreenshot(_) | Self::Compare | Self::SaveComparison => {
                "Pictures (.png, .jpg, .gif)"
            }
        }
    }

    /// What may be written, by name and extension; the first until another is chosen.
    fn written(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::ExportCurve(_) => &[("Curves", "swp")],
            Self::ExportGeometry => &[("Geometry", "obj")],
            Self::SavePose(..) => &[("Poses", "json")],
            Self::SaveScreenshot(_) | Self::SaveComparison => {
                &[("PNG", "png"), ("JPEG", "jpg"), ("GIF", "gif")]
            }
            Self::ImportShape
            | Self::ImportCurve
            | Self::ImportCharacter
            | Self::Compare
            | Self::LoadPose(_) => &[],
        }
    }

    /// Whether `path` is listed. AppleDouble files, which archives from some systems carry
    /// beside the real ones, never are.
    fn lists(self, path: &Path) -> bool {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("._") {
            return false;
        }
        let extension = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        let has = |other: &str| path.with_extension(other).is_file();
        match self {
            Self::ImportShape => extension == "obj" || extension == "dae",
            Self::ImportCharacter => {
                extension == "dae" || extension == "obj" && (has("skel") || has("attach"))
            }
            Self::ExportGeometry => extension == "obj",
            Self::SavePose(..) | Self::LoadPose(_) => extension == "json",
            Self::ImportCurve | Self::ExportCurve(_) => extension == "swp",
            Self::SaveScreenshot(_) | Self::Compare | Self::SaveComparison => {
                ["png", "jpg", "jpeg", "gif"].contains(&&*extension)
            }
        }
    }
}

/// The one file dialog of the program, inside its window.
pub(super) struct FileDialogs {
    open: Option<(Purpose, FileDialog)>,
}

impl FileDialogs {
    pub fn new() -> Self {
        Self { open: None }
    }

    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Opens it in `folder`, in place of one that is open already, to choose a file.
    pub fn open(&mut self, purpose: Purpose, folder: Option<&Path>) {
        let mut dialog = Self::dialog(purpose, folder);
        dialog.pick_file();
        self.open = Some((purpose, dialog));
    }

    /// Opens it to write a file, which it calls `name` until the user does otherwise.
    pub fn open_to_save(&mut self, purpose: Purpose, folder: Option<&Path>, name: &str) {
        let mut dialog = Self::dialog(purpose, folder).default_file_name(name);
        for (name, extension) in purpose.written() {
            dialog = dialog.add_save_extension(name, extension);
        }
        if let Some((first, _)) = purpose.written().first() {
            dialog = dialog.default_save_extension(first);
        }
        dialog.save_file();
        self.open = Some((purpose, dialog));
    }

    fn dialog(purpose: Purpose, folder: Option<&Path>) -> FileDialog {
        let filter = Filter::new(move |path: &Path| purpose.lists(path));
        let dialog = FileDialog::new()
            .title(purpose.title())
            .id("file dialog")
            .add_file_filter(purpose.filter(), filter)
            .default_file_filter(purpose.filter())
            .anchor(egui::Align2::CENTER_CENTER, egui::Vec2::ZERO)
            .default_size([640.0, 440.0]);
        match folder.filter(|folder| folder.is_dir()) {
            Some(folder) => dialog.initial_directory(folder.to_owned()),
            None => dialog,
        }
    }

    /// Shows the dialog if it is open; returns the file once one is chosen.
    pub fn show(&mut self, context: &egui::Context) -> Option<(Purpose, PathBuf)> {
        let (purpose, dialog) = self.open.as_mut()?;
        dialog.update(context);
        let chosen = dialog.take_picked().map(|path| (*purpose, path));
        if chosen.is_some() || !matches!(dialog.state(), DialogState::Open) {
            self.open = None;
        }
        chosen
    }
}
