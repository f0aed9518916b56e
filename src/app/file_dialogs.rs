use crate::scene::ShapeId;
use crate::ui;
use crate::ui::Screenshot;
use egui::{Key, Modifiers};
use egui_file_dialog::{DialogState, FileDialog, FileDialogKeyBindings, Filter, KeyBinding};
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

    /// `path` with the extension that was left out, if one is to be written.
    fn completed(self, path: &Path) -> Option<PathBuf> {
        let (_, extension) = self.written().first()?;
        let complete = path.with_extension(extension);
        path.extension().is_none().then_some(complete)
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
        // What is typed belongs to the name, not to a search that would choose another file.
        let mut dialog = Self::dialog(purpose, folder)
            .show_search(false)
            // Without the search it would stand out of the dialog.
            .show_menu_button(false)
            .default_file_name(name);
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
            .keybindings(keys())
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
        let purpose = *purpose;
        ui::in_colors_of_file_dialogs(context, || {
            dialog.update(context);
        });
        let Some(path) = dialog.take_picked() else {
            if !matches!(dialog.state(), DialogState::Open) {
                self.open = None;
            }
            return None;
        };
        self.open = None;
        match purpose.completed(&path) {
            None => Some((purpose, path)),
            Some(complete) if !complete.exists() => Some((purpose, complete)),
            Some(complete) => {
                // The dialog has asked about another file: let it ask about this one.
                let name = complete.file_name().unwrap_or_default().to_string_lossy();
                self.open_to_save(purpose, complete.parent(), &name);
                None
            }
        }
    }
}

/// The dialog's keys, with Ctrl+L for the path, as other file dialogs have it. The slash, which
/// would open the path of the current folder and be lost, is typed like any other letter.
fn keys() -> FileDialogKeyBindings {
    FileDialogKeyBindings {
        edit_path: vec![KeyBinding::keyboard_shortcut(Modifiers::COMMAND, Key::L)],
        ..FileDialogKeyBindings::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_to_save_that_has_no_extension_gets_the_first_that_suits() {
        let save = Purpose::SavePose(ShapeId(1), None);
        let walk = PathBuf::from("poses/walk.json");
        assert_eq!(save.completed(Path::new("poses/walk")), Some(walk));
        assert_eq!(save.completed(Path::new("poses/walk.txt")), None);
        assert_eq!(Purpose::Compare.completed(Path::new("picture")), None);
    }
}
