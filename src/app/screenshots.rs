use super::globals;
use super::workspace::Workspace;
use crate::disk;
use crate::editor::{Screenshot, Severity};
use crate::geometry::Picture;
use crate::gpu::Framebuffer;
use crate::io::Diagnostic;
use crate::io::image::{self, PictureFormat};
use crate::render::{Frame, Marks, RenderError, read_picture};
use std::path::Path;

impl Workspace {
    /// Saves the view without panels and marks, as it is or in another size.
    pub(super) fn save_view(&mut self, path: &Path, shot: Screenshot) {
        // Large pictures take their time: what cannot be written is told before.
        if let Err(error) = PictureFormat::of(path) {
            self.tell_saved(path, Err(error));
            return;
        }
        let view = self.pictures.view_size().unwrap_or((800, 600));
        match self.view_picture(shot.size.unwrap_or(view)) {
            Ok(picture) => self.save_picture(path, &picture),
            Err(error) => self.tell_undrawn(&error),
        }
    }

    pub(super) fn tell_undrawn(&mut self, error: &RenderError) {
        let text = format!("The picture could not be drawn: {error}");
        self.session.messages.tell(Severity::Error, text);
        self.request_redraw();
    }

    /// Writes a picture in the format of its name, and tells how that went.
    pub(super) fn save_picture(&mut self, path: &Path, picture: &Picture) {
        let written = encode(path, picture).and_then(|bytes| disk::write_whole(path, &bytes));
        self.tell_saved(path, written);
    }

    fn view_picture(&mut self, (width, height): (u32, u32)) -> Result<Picture, RenderError> {
        let gl = self.window.gl();
        let samples = globals::SAMPLES.min(gl.info().max_samples);
        let target = Framebuffer::new(gl, width, height, samples)?;
        let frame = Frame {
            scene: self.session.scene(),
            evaluated: self.session.evaluated(),
            view: self.session.view(),
            marks: Marks::default(),
        };
        self.renderer.draw(&frame, &target)?;
        Ok(read_picture(&target)?)
    }
}

fn encode(path: &Path, picture: &Picture) -> Result<Vec<u8>, Diagnostic> {
    let format = PictureFormat::of(path)?;
    image::encode(picture, format).map_err(|message| Diagnostic::new(path, message))
}
