use super::measurer::Measurer;
use super::{Comparison, Textured};
use crate::app::application::Wake;
use crate::app::file_dialogs::Purpose;
use crate::app::workspace::Workspace;
use crate::compare::{CompareError, Pair, side_by_side};
use crate::disk::files;
use crate::editor::Severity;
use crate::geometry::Picture;
use crate::gpu::Framebuffer;
use crate::io::{Diagnostic, Files, image};
use crate::ui::{CompareAction, CompareReport, CompareSettings};
use std::path::Path;

impl Workspace {
    /// Does what the Compare panel asks for.
    pub(in crate::app) fn compare(&mut self, action: CompareAction) {
        let folder = self.preferences.last_folder.as_deref();
        match action {
            CompareAction::Choose => self.dialogs.open(Purpose::Compare, folder),
            CompareAction::Save => {
                let purpose = Purpose::SaveComparison;
                self.dialogs.open_to_save(purpose, folder, "comparison.png");
            }
            CompareAction::Close => self.comparison = None,
            CompareAction::Set(settings) => {
                if let Some(comparison) = &mut self.comparison {
                    comparison.set(settings);
                }
            }
        }
    }

    /// Compares the view with the picture at `path` from now on, with what was chosen before.
    pub(in crate::app) fn compare_with(&mut self, path: &Path) {
        match self.comparison_with(path) {
            Ok(comparison) => self.comparison = Some(comparison),
            Err(error) => self
                .session
                .messages
                .tell(Severity::Error, error.to_string()),
        }
        self.request_redraw();
    }

    fn comparison_with(&self, path: &Path) -> Result<Comparison, Diagnostic> {
        let picture = image::decode(path, &files().read(path)?)?;
        let (width, height) = (picture.width, picture.height);
        let wrong = |message: String| Diagnostic::new(path, message);
        let most = self.painter.max_texture_side();
        if width.max(height) as usize > most {
            return Err(wrong(format!(
                "expected a picture of at most {most} pixels a side, found {width}×{height}"
            )));
        }
        let target = Framebuffer::new(self.window.gl(), width, height, 0)
            .map_err(|error| wrong(error.to_string()))?;
        let proxy = self.proxy.clone();
        // A loop that is gone needs no waking.
        let wake = move || drop(proxy.send_event(Wake::Measured));
        let measurer = Measurer::new(wake)
            .map_err(|error| wrong(format!("it cannot be compared with: {error}")))?;
        let name = path.file_name().unwrap_or(path.as_os_str());
        let before = self.comparison.as_ref().map(|before| &before.settings);
        let mut settings: CompareSettings = before.cloned().unwrap_or_default();
        for mask in &mut settings.masks {
            *mask = mask.inside((width, height));
        }
        Ok(Comparison {
            target,
            name: name.to_string_lossy().into_owned(),
            reference: Textured::new(self.egui.egui_ctx(), "reference", picture),
            live: None,
            difference: None,
            drawn: None,
            settings,
            report: CompareReport::default(),
            measurer,
            job: 0,
        })
    }

    /// Saves the reference, the live view and their differences side by side.
    pub(in crate::app) fn save_comparison(&mut self, path: &Path) {
        let picture = self.comparison.as_ref().and_then(Comparison::picture);
        match picture {
            Some(Ok(picture)) => self.save_picture(path, &picture),
            Some(Err(error)) => {
                let text = format!("Not saved: {error}");
                self.session.messages.tell(Severity::Error, text);
            }
            None => {}
        }
    }
}

impl Comparison {
    /// What `editor compare -o` writes; `None` before the view has been drawn.
    fn picture(&self) -> Option<Result<Picture, CompareError>> {
        let live = self.live.as_ref()?;
        let (a, b) = (&*self.reference.picture, &*live.picture);
        let pair = Pair::new(a, b, &self.settings.masks);
        Some(pair.map(|pair| side_by_side(&[a, b, &pair.heat_map()])))
    }
}
