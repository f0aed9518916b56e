//! The view from before it was fitted to what had been added, which comes back when that is taken back.

use super::running::Program;
use crate::editor::View;
use crate::revision::Revision;
use crate::scene::Camera;

/// A view that was fitted to what had been added.
#[derive(Clone, Copy, Debug)]
pub(super) struct ViewBefore {
    /// The document with what had been added.
    document: Revision,
    /// The camera before, and where the document started.
    camera: Camera,
    start: Camera,
    /// The camera that was fitted.
    fitted: Camera,
}

impl Program {
    /// Fits everything into the picture, in which something has just been added.
    pub(super) fn fit_added(&mut self) {
        let (camera, start) = (self.session.view().camera, *self.session.start_camera());
        self.fit_all(self.fit_area);
        self.views_before.push(ViewBefore {
            document: self.session.document(),
            camera,
            start,
            fitted: self.session.view().camera,
        });
    }

    /// Takes back the last step, and with it the view that was fitted to what that added, unless the camera was moved since.
    pub(super) fn undo(&mut self) {
        let document = self.session.document();
        self.session.undo();
        let mut views = self.views_before.iter();
        let fitted = views.position(|view| view.document == document);
        if let Some(index) = fitted.filter(|_| self.session.document() != document) {
            let before = self.views_before.remove(index);
            if self.session.view().camera == before.fitted {
                self.session.look(View::BeginAt(before.start));
                self.session.look(View::SetCamera(before.camera));
            }
        }
    }
}
