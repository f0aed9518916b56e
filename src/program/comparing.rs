//! Beginning and ending a comparison with a picture.

use super::comparison::Comparison;
use super::files::file_name;
use super::page_floor::shows_floor_of_page;
use super::page_screenshot::{has_sky_of_page, view_of_page};
use super::running::Program;
use crate::editor::{Severity, View};
use crate::geometry::Picture;
use crate::render::Backdrop;
use crate::scene::{Camera, Look};
use std::path::PathBuf;

impl Program {
    /// Begins a comparison with the picture `reference` from the file `path`: in the Studio look if that is what
    /// the picture has, else in the look of the program that it may be from. That is the Virtual Mannequin's for a
    /// screenshot of its page or of the view there, and where the document is shown in its look unless the picture
    /// has the course's background; otherwise it is the course's. Of a screenshot of the page the view is compared,
    /// from where the page starts if the camera has not been moved.
    pub(super) fn begin_comparison(&mut self, path: PathBuf, reference: Picture) {
        let before = self.comparison.as_ref();
        let before = before.map_or(self.session.view().look, |before| before.look_before);
        self.end_mesh_comparison();
        let studio = Backdrop::of_studio(&reference);
        let of_page = view_of_page(&reference);
        let is_cut = of_page.is_some();
        let is_in_look = || before == Look::Mannequin && shows_floor_of_page(&reference);
        let is_page = is_cut || has_sky_of_page(&reference) || studio.is_none() && is_in_look();
        let look = match (studio, before) {
            _ if is_page => Look::Mannequin,
            (Some(_), _) => Look::Studio,
            (None, Look::Mannequin) if !Backdrop::is_of_course(&reference) => Look::Mannequin,
            (None, _) => Look::Course,
        };
        self.session.look(View::SetLook(look));
        let reference = of_page.unwrap_or(reference);
        let running = self.comparison.as_ref();
        let settings = running.map(|running| running.settings_for(&reference));
        let earlier = running.and_then(|it| it.camera_before);
        let mut comparison = Comparison::new(path, reference, settings.unwrap_or_default(), before);
        comparison.looks = (look, studio.unwrap_or_default());
        comparison.is_cut = is_cut;
        comparison.is_page = is_page;
        comparison.camera_before = earlier;
        let camera = self.session.view().camera;
        if is_cut && camera == *self.session.start_camera() {
            comparison.camera_before = Some(camera);
            self.session.look(View::SetCamera(Camera::of_mannequin()));
        }
        if is_cut {
            let name = file_name(comparison.path());
            let told = format!(
                "{name} is compared without what is around its view, such as the keyframes below; the camera stands where the page starts, unless you \
                 had moved it, and goes back afterwards"
            );
            self.tell(Severity::Info, told);
        }
        self.comparison = Some(comparison);
    }

    /// Ends the comparison, and goes back to the look from before it unless another was chosen.
    pub(super) fn end_comparison(&mut self) {
        if let Some(comparison) = self.comparison.take() {
            let view = *self.session.view();
            self.session
                .look(View::SetLook(comparison.look_after(view.look)));
            let camera = comparison.camera_after(view.camera);
            self.session.look(View::SetCamera(camera));
        }
    }
}
