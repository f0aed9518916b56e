//! The camera while a character is compared with a mesh: what fits the scene fits that mesh, too, where it is shown.

use super::running::Program;
use crate::editor::View;
use crate::math::Aabb;
use crate::scene::{Camera, EvaluatedShape};
use crate::ui::MeshesShown;

/// Share of the picture below which a character is too small to see its colors.
const SMALL: f32 = 0.5;

/// Part of a mesh that has to be in the picture.
const SEEN: f32 = 0.7;

/// How many times as large as the character a mesh may be that is brought into the picture beside it: beside a larger
/// one it could not be seen.
const LARGEST: f32 = 10.0;

impl Program {
    /// `view`, or what it is in a comparison: what fits shapes fits what is shown of a mesh that is compared, and beside a
    /// screenshot of the Virtual Mannequin's page the camera goes back to where that starts.
    pub(super) fn with_compared(&self, view: View) -> View {
        let is_page = self.comparison.as_ref().is_some_and(|it| it.is_cut);
        if is_page && matches!(view, View::ResetCamera) {
            return View::SetCamera(Camera::of_mannequin());
        }
        let (area, all) = match view {
            View::Fit(area) => (area, false),
            View::FitAll(area) => (area, true),
            _ => return view,
        };
        let Some(shown) = self.compared_shapes(all) else {
            return view;
        };
        let mut camera = self.session.view().camera;
        camera.fit_shapes(shown.iter(), area);
        View::SetCamera(camera)
    }

    /// All that is visible, or else what of it is selected, with the compared mesh in place of the character or beside
    /// it; `None` if that mesh is not among it.
    fn compared_shapes(&self, all: bool) -> Option<Vec<EvaluatedShape>> {
        let comparison = self.mesh_comparison.as_ref()?;
        let (id, shown) = comparison.shown();
        let all = all || self.session.selected().is_none();
        if shown == MeshesShown::Ours || !(all || self.session.is_selected(id)) {
            return None;
        }
        let is_meant = |shape: &&EvaluatedShape| {
            let is_shown = shape.visible && (shape.id != id || shown == MeshesShown::Both);
            is_shown && (all || self.session.is_selected(shape.id))
        };
        let shapes = self.session.evaluated().shapes.iter().filter(is_meant);
        let theirs = comparison.their_shape(&self.session)?;
        Some(shapes.cloned().chain([theirs]).collect())
    }

    /// Fits the character of a comparison that has begun into the picture if all of it is seen, but small, and with the
    /// mesh where little of that is seen; whether the view changed. Who sees only a part of the character looks at
    /// that part, and goes on to.
    pub(super) fn come_closer(&mut self) -> bool {
        let shape = self.closer_due.take();
        let Some(shape) = shape.and_then(|id| self.session.evaluated().shape(id)) else {
            return false;
        };
        let mut camera = self.session.view().camera;
        let (ours, aspect) = (shape.world_bounds(), self.fit_area.aspect);
        let comparison = self.mesh_comparison.as_ref();
        let theirs = comparison.and_then(|comparison| comparison.their_shape(&self.session));
        let theirs = theirs.map(|theirs| theirs.world_bounds());
        let is_far = |theirs: &Aabb| {
            let size = theirs.size().length();
            size <= LARGEST * ours.size().length() && camera.seen_part(theirs, aspect) < SEEN
        };
        let share = camera.share(&ours, aspect);
        if let Some(theirs) = theirs.filter(is_far)
            && share.is_some()
        {
            camera.fit(&ours.union(theirs), self.fit_area);
        } else if share.is_some_and(|share| share < SMALL) {
            camera.fit_shapes(std::iter::once(shape), self.fit_area);
        } else {
            return false;
        }
        self.look_for_comparison(camera);
        true
    }
}
