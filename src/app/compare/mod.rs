//! The comparison of the view with a picture: its pictures, its measuring, its files.

mod actions;
mod drawing;
mod measurer;

use crate::compare::PictureJob;
use crate::geometry::{Picture, Revision};
use crate::gpu::Framebuffer;
use crate::ui::{self, CompareReport, CompareSettings, CompareView, ShownPicture};
use egui::TextureHandle;
use measurer::{Job, Measurer};
use std::sync::Arc;

/// A comparison that is under way.
pub(super) struct Comparison {
    /// Made with OpenGL, so that it must go before the window does.
    target: Framebuffer,
    name: String,
    reference: Textured,
    live: Option<Textured>,
    difference: Option<TextureHandle>,
    /// What `live` shows: drawn again only when this changes.
    drawn: Option<(Revision, bool)>,
    settings: CompareSettings,
    report: CompareReport,
    measurer: Measurer,
    /// Number of the newest job of the measurer.
    job: u64,
}

/// A picture with the texture that shows it.
struct Textured {
    picture: Arc<Picture>,
    texture: TextureHandle,
}

impl Textured {
    fn new(context: &egui::Context, name: &str, picture: Picture) -> Self {
        Self {
            texture: ui::picture_texture(context, name, &picture),
            picture: Arc::new(picture),
        }
    }

    fn shown(&self) -> ShownPicture<'_> {
        ShownPicture {
            picture: &self.picture,
            texture: self.texture.id(),
        }
    }
}

impl Comparison {
    /// As the panels show it.
    pub fn view(&self) -> CompareView<'_> {
        CompareView {
            name: &self.name,
            settings: &self.settings,
            reference: self.reference.shown(),
            live: self.live.as_ref().map(Textured::shown),
            difference: self.difference.as_ref().map(TextureHandle::id),
            report: &self.report,
        }
    }

    /// Takes what was chosen in the panel; what depends on it is measured anew.
    fn set(&mut self, settings: CompareSettings) {
        let measured_by = |s: &CompareSettings| (s.threshold, s.masks.clone());
        let measures_change = measured_by(&settings) != measured_by(&self.settings);
        self.settings = settings;
        if measures_change {
            self.measure();
        }
    }

    /// Has the pictures measured as they are now.
    fn measure(&mut self) {
        let Some(live) = &self.live else {
            return;
        };
        self.job += 1;
        self.report.measuring = true;
        self.measurer.start(Job {
            number: self.job,
            pictures: PictureJob {
                a: Arc::clone(&self.reference.picture),
                b: Arc::clone(&live.picture),
                threshold: self.settings.threshold,
                ignore: self.settings.masks.clone(),
            },
        });
    }

    /// Takes in what has been measured since.
    pub fn take_results(&mut self, context: &egui::Context) {
        while let Some(measured) = self.measurer.result() {
            if let Some(heat) = &measured.heat_map {
                self.difference = Some(ui::picture_texture(context, "differences", heat));
            }
            measured.into_report(&mut self.report, self.job);
        }
    }
}
