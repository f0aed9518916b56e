//! The view of documents that have none of their own, and of what is imported.

use super::comparison::Comparison;
use super::running::Program;
use crate::character::Facing;
use crate::editor::{Severity, View, bounds_of, is_deep, put_on_ground, set_among};
use crate::io;
use crate::math::{Aabb, Ray};
use crate::render::MANNEQUIN_LIGHT;
use crate::scene::{
    Camera, FitArea, Importer, Look, NewShape, ShapeColor, ShapeId, ShapeKind, ViewSettings,
};
use crate::ui::Navigation;
use glam::{Quat, Vec3};
use std::path::Path;

/// Angle from which the ground is seen, in radians: level with it, it would be a line.
const ABOVE: f32 = 0.18;
/// The same where the light from above is to be seen on textures.
const ABOVE_TEXTURES: f32 = 0.5;
/// Angle between the front and where textures are seen from in the Mannequin look, in radians. Its light comes
/// from behind what has its front at +Z.
const ASIDE: f32 = 0.9;
/// Part of a figure that is added that has to be in the picture.
const WHOLE: f32 = 0.95;
/// Width over height of the course's window.
const COURSE_ASPECT: f32 = 4.0 / 3.0;
/// Least share of the course's picture that a character takes up there, to be seen well.
const LEAST_SHARE: f32 = 0.15;
/// The color preset of imported characters outside of the course's look: Light Gray.
const NEUTRAL: usize = 30;

impl Program {
    /// View of a document without shapes.
    pub(super) fn view_without_scene(&self) -> ViewSettings {
        let look = self.ui.look_of_new.unwrap_or(Look::Studio);
        ViewSettings {
            look,
            axis: look.has_axes(),
            camera: Camera {
                phi: ABOVE,
                ..Camera::default()
            },
            ..ViewSettings::default()
        }
    }

    /// Shows a document of `shapes` in the place of the one before: through its own `view`, or through
    /// a first one, for being `compared` with a picture or not.
    pub(super) fn show_opened(
        &mut self,
        mut shapes: Vec<NewShape>,
        view: Option<ViewSettings>,
        compared: bool,
    ) {
        let first = view.unwrap_or_else(|| self.first_view(&mut shapes, compared));
        self.session.open(shapes, first);
        self.ui.suit_navigation(first.look);
        self.fit_due = false;
        self.views_before.clear();
        self.own_view_due = view.is_some() && !compared;
        if view.is_none() && !compared {
            self.show_whole();
        }
    }

    /// View of a document of `shapes` that has none of its own. What is compared with a picture, and
    /// the course's characters unless another look is chosen for what is opened, are seen as in the course's
    /// editor; all else in neutral colors, from the front. The camera is still to be fitted then: see [`Program::show_whole`].
    pub(super) fn first_view(&self, shapes: &mut [NewShape], compared: bool) -> ViewSettings {
        if compared {
            return ViewSettings::default();
        }
        let look = self.ui.look_of_new.unwrap_or(Look::Course);
        if look == Look::Course && shapes.iter().any(is_of_the_course) {
            return ViewSettings::default();
        }
        let mut view = self.view_without_scene();
        // Who has the Virtual Mannequin's keys from the document before, without having chosen them, goes on
        // with them.
        let has_its_keys = self.ui.has_navigation_of_document(Navigation::Mannequin);
        if has_its_keys && self.ui.look_of_new.is_none() {
            view.look = Look::Mannequin;
        }
        let front = front(shapes);
        let (from, above) = if view.look == Look::Mannequin && shapes.iter().any(is_textured) {
            (beside(front, MANNEQUIN_LIGHT), ABOVE_TEXTURES)
        } else if is_deep(&bounds_of(shapes), front) {
            (Quat::from_rotation_y(-ASIDE) * front, ABOVE)
        } else {
            (front, ABOVE)
        };
        view.camera = view.camera.facing(from, above);
        self.make_neutral(shapes, view.look);
        view
    }

    /// Gives characters that are to be shown in `look` a neutral color, unless they have one of their
    /// own or are the course's.
    fn make_neutral(&self, shapes: &mut [NewShape], look: Look) {
        if look == Look::Course {
            return;
        }
        let green = ShapeColor::Preset(Importer::Character.start_color());
        let is_green = |shape: &&mut NewShape| {
            let is_character = matches!(shape.kind, ShapeKind::Character(_));
            is_character && shape.start.color == green && shape.placement.color == green
        };
        for shape in shapes.iter_mut().filter(is_green) {
            if !is_of_the_course(shape) {
                shape.placement.color = ShapeColor::Preset(NEUTRAL);
                shape.start.color = shape.placement.color;
            }
        }
    }

    /// Prepares `shapes` for being imported into the document: they get their colors and, unless the
    /// view is compared with a picture, their places among those that are there. Returns the view
    /// that the document has with them, if they are the first in it.
    pub(super) fn view_of_import(&mut self, shapes: &mut [NewShape]) -> Option<ViewSettings> {
        let is_first = self.session.scene().shapes().is_empty();
        if is_first {
            return Some(self.view_of_first_import(shapes));
        }
        let view = *self.session.view();
        self.make_neutral(shapes, view.look);
        if self.comparison.is_none() {
            self.place_import(shapes, &view.camera);
        }
        None
    }

    /// View of an empty document with the first shapes that are imported. Beside a picture it has the look that this is
    /// compared in: the course's with the course's camera, another as without the picture, but where the camera stands as
    /// the page's does.
    fn view_of_first_import(&self, shapes: &mut [NewShape]) -> ViewSettings {
        let compared = self.comparison.as_ref();
        let look = compared.map(|it| it.looks.0);
        let mut view = self.first_view(shapes, look == Some(Look::Course));
        view.look = look.unwrap_or(view.look);
        if compared.is_some_and(|it| it.is_cut) {
            view.camera = self.session.view().camera;
        }
        view
    }

    /// Gives shapes that are imported their places among those that are there, as `camera` sees them.
    fn place_import(&mut self, shapes: &mut [NewShape], camera: &Camera) {
        let place = |shapes: &[NewShape]| shapes.first().map(|it| it.placement.transform.position);
        let before = place(shapes);
        let is_beside = set_among(&self.session, shapes, camera);
        put_on_ground(&self.session, shapes);
        // Set around the eye, it would be all that is seen.
        self.fit_due |= before != place(shapes) && bounds_of(shapes).contains(camera.eye());
        if let (true, Some(first), Some(before)) = (is_beside, shapes.first(), before) {
            let [x, y, z] = before.to_array();
            let text = format!(
                "{} is set beside the character that it would hide. Position {x}, {y}, {z} has it where its file does",
                first.name
            );
            self.tell(Severity::Info, text);
        }
    }

    /// Shows shapes that have just been added: the first that are imported into a document through its `first`
    /// view, others through the view as it is, if most of them can be seen in it.
    pub(super) fn show_added(&mut self, added: &[ShapeId], first: Option<ViewSettings>) {
        if let Some(view) = first {
            self.session.look(View::SetLook(view.look));
            self.session.look(View::SetAxis(view.axis));
            self.session.look(View::BeginAt(view.camera));
        }
        // Under a hand that is about to move what was added, the view stands still, and so it does beside a picture,
        // unless that was there before everything else and says nothing about the camera.
        let has_camera = |it: &Comparison| it.looks.0 == Look::Course || it.is_cut;
        let compared = self.comparison.as_ref();
        let stands_still = compared.is_some_and(|it| first.is_none() || has_camera(it));
        if stands_still || self.ui.is_beginning() {
            return;
        }
        if first.is_some() {
            self.show_whole();
        } else {
            let evaluated = self.session.evaluated();
            let shapes = added.iter().filter_map(|&id| evaluated.shape(id));
            let meets = |ray: &Ray| shapes.clone().any(|shape| shape.is_met_by(ray));
            let bounds = shapes
                .clone()
                .fold(Aabb::EMPTY, |all, shape| all.union(shape.world_bounds()));
            let camera = &self.session.view().camera;
            let aspect = self.fit_area.aspect;
            let scene = self.session.scene();
            let mut fronts = added.iter().filter_map(|&id| scene.shape(id)?.front());
            // A figure that fills the view is too near, and hides what was there; a room may be all around.
            let is_whole = fronts.next().is_none() || camera.seen_part(&bounds, aspect) >= WHOLE;
            let is_seen = camera.sees(&bounds, aspect, meets) && is_whole;
            self.fit_due |= !is_seen && !bounds.is_empty();
        }
    }

    /// Fits everything into the picture, once its size is known, unless it is seen well in a view of
    /// the course.
    fn show_whole(&mut self) {
        let camera = &self.session.view().camera;
        let bounds = self.session.evaluated().world_bounds();
        let is_of_the_course = *camera == Camera::default();
        let is_right = is_of_the_course && is_seen_well(camera, &bounds);
        self.fit_due = !bounds.is_empty() && !is_right;
        if self.fit_due {
            self.fit_all(self.fit_area);
        }
    }

    /// Has the camera of a document's own view go back where the picture is higher than wide, as on a phone, so that
    /// as much is seen as in a window, which the view was made in; but no further than all needs, since the view may
    /// have been kept as it was here. Returns whether it did.
    pub(super) fn suit_own_view(&mut self) -> bool {
        let is_due = std::mem::take(&mut self.own_view_due);
        if !is_due || self.fit_area.aspect >= 1.0 {
            return false;
        }
        let mut camera = self.session.view().camera;
        let fitted = |area| {
            let mut fitted = camera;
            let shapes = self.session.evaluated().shapes.iter();
            fitted.fit_shapes(shapes.filter(|shape| shape.visible), area);
            fitted.radius
        };
        let enough = fitted(self.fit_area);
        let further = enough / fitted(FitArea::whole(COURSE_ASPECT));
        let radius = (camera.radius * further).min(enough);
        let goes_back = radius > camera.radius;
        if goes_back {
            camera.radius = radius;
            self.session.look(View::BeginAt(camera));
        }
        goes_back
    }

    /// Fits everything into the picture `area`, in which the document is shown first.
    pub(super) fn fit_all(&mut self, area: FitArea) {
        let mut camera = self.session.view().camera;
        let shapes = self.session.evaluated().shapes.iter();
        camera.fit_shapes(shapes.filter(|shape| shape.visible), area);
        self.session.look(View::BeginAt(camera));
    }
}

/// Whether a shape is to be seen as in the course's editor: a character in the course's format, from
/// the user's disk, that is seen well there.
fn is_of_the_course(shape: &NewShape) -> bool {
    let ShapeKind::Character(character) = &shape.kind else {
        return false;
    };
    let Some(source) = &shape.source else {
        return false;
    };
    let path = Path::new(&source.file);
    let has_format = io::expect_extension(path, "obj").is_ok() && !io::builtin::is_builtin(path);
    let bounds = character.character.bind_mesh().bounds();
    let world_from_model = shape.placement.transform.world_from_model();
    has_format && is_seen_well(&Camera::default(), &bounds.transformed(world_from_model))
}

/// Whether `bounds` is neither cut off nor tiny in the course's window.
fn is_seen_well(camera: &Camera, bounds: &Aabb) -> bool {
    let share = camera.share(bounds, COURSE_ASPECT);
    share.is_some_and(|share| share >= LEAST_SHARE)
}

fn is_textured(shape: &NewShape) -> bool {
    let mesh = match &shape.kind {
        ShapeKind::Mesh(mesh) => mesh,
        ShapeKind::Character(character) => character.character.bind_mesh(),
        _ => return false,
    };
    let mut groups = mesh.groups.iter();
    groups.any(|group| group.material.texture.is_some())
}

/// `front`, turned about +Y to the side that is nearer to `light`.
fn beside(front: Vec3, light: Vec3) -> Vec3 {
    let [one, other] = [-ASIDE, ASIDE].map(|angle| Quat::from_rotation_y(angle) * front);
    if one.dot(light) > other.dot(light) {
        one
    } else {
        other
    }
}

/// The front of the first character among `shapes`, in the world; +Z if there is none.
fn front(shapes: &[NewShape]) -> Vec3 {
    let first = shapes.iter().find_map(NewShape::front);
    first.unwrap_or_else(|| Facing::default().front())
}
