//! The pictures of the scene in the view: one, or two side by side in a comparison.

use crate::editor::{Screen, Session};
use crate::revision::Revision;
use crate::scene::{Camera, ShapeId, pick_shape};
use egui::{Pos2, Rect, pos2};
use glam::{Vec2, Vec3};

/// Rectangles of the view that show the scene, so that gestures can be mapped into it.
#[derive(Clone, Debug, PartialEq)]
pub struct ScenePlaces {
    /// In points. All have the same size, and do not overlap.
    pub rects: Vec<Rect>,
    /// Part of each, in points, that is the live view, in which bones and the like can be taken; none where
    /// another picture is.
    live: Vec<Rect>,
    /// Whether that is seen now. Of two pictures that blink, the live view is only in turn.
    is_live_seen: bool,
    /// Size of a pixel of the picture, in points, for drags that move the camera.
    pub points_per_pixel: f32,
}

impl ScenePlaces {
    /// The scene fills `rect`, and a point counts as a pixel.
    pub fn whole(rect: Rect) -> Self {
        Self {
            rects: vec![rect],
            live: vec![rect],
            is_live_seen: true,
            points_per_pixel: 1.0,
        }
    }

    /// The pictures of a comparison in `rects`, whose parts `live` are the live view.
    pub(super) fn compared(
        rects: Vec<Rect>,
        points_per_pixel: f32,
        live: Vec<Rect>,
        is_live_seen: bool,
    ) -> Self {
        Self {
            rects,
            live,
            is_live_seen,
            points_per_pixel,
        }
    }

    /// Index of the picture under a point of the window.
    pub fn index_at(&self, position: Pos2) -> Option<usize> {
        self.rects.iter().position(|rect| rect.contains(position))
    }

    /// The nearest point of a surface under a point of the window, in the world.
    pub(super) fn surface_at(&self, session: &Session, position: Pos2) -> Option<Vec3> {
        let place = self.at(position)?;
        let camera = &session.view().camera;
        let ray = camera.ray(place.pixel(position), place.size());
        pick_shape(session.evaluated(), &ray).map(|(_, distance)| ray.at(distance))
    }

    /// The same, or beside all surfaces the point there that is as far away as the camera's target.
    pub(super) fn point_at(&self, session: &Session, position: Pos2) -> Option<Vec3> {
        let place = self.at(position)?;
        let camera = &session.view().camera;
        let beside = || camera.point_at_target(place.pixel(position), place.size());
        Some((self.surface_at(session, position)).unwrap_or_else(beside))
    }

    /// Height of a picture in its pixels.
    pub(super) fn height(&self) -> f32 {
        let height = self.rects.first().map_or(1.0, Rect::height);
        (height / self.points_per_pixel).max(1.0)
    }

    /// Index of the picture whose live view is under a point of the window.
    pub(super) fn live_index_at(&self, position: Pos2) -> Option<usize> {
        self.live.iter().position(|live| live.contains(position))
    }

    /// The picture whose live view is under a point of the window.
    pub(super) fn live_at(&self, position: Pos2) -> Option<Place> {
        self.get(self.live_index_at(position)?)
    }

    /// The picture under a point of the window.
    pub(super) fn at(&self, position: Pos2) -> Option<Place> {
        self.get(self.index_at(position)?)
    }

    /// The picture with this index.
    pub(super) fn get(&self, index: usize) -> Option<Place> {
        self.iter().nth(index)
    }

    /// All pictures.
    pub(super) fn iter(&self) -> impl Iterator<Item = Place> {
        let parts = self.rects.iter().zip(&self.live);
        parts.map(|(&rect, &live)| Place {
            rect,
            live,
            seen: if self.is_live_seen {
                live
            } else {
                Rect::NOTHING
            },
        })
    }
}

/// One picture of the scene. Its pixels are points of the window, from its upper left corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// In points of the window.
    pub rect: Rect,
    /// Part of it that is the live view.
    pub live: Rect,
    /// Part of it in which the live view is seen now, and marks belong.
    pub seen: Rect,
}

impl Place {
    /// A point of the window as a pixel, which may lie outside the picture.
    pub(super) fn pixel(self, position: Pos2) -> Vec2 {
        let from_corner = position - self.rect.min;
        Vec2::new(from_corner.x, from_corner.y)
    }

    /// A pixel as a point of the window.
    pub(super) fn position(self, pixel: Vec2) -> Pos2 {
        pos2(self.rect.min.x + pixel.x, self.rect.min.y + pixel.y)
    }

    /// Width and height, at least 1.
    pub(super) fn size(self) -> Vec2 {
        Vec2::new(self.rect.width().max(1.0), self.rect.height().max(1.0))
    }

    /// The picture as the session's camera sees it.
    pub(super) fn screen(self, session: &Session) -> Screen {
        Screen {
            camera: session.view().camera,
            size: self.size(),
        }
    }
}

/// Cache of the shape under the pointer: picked anew only when the pointer, the camera or the
/// document has changed.
#[derive(Clone, Debug, Default)]
pub(super) struct Picked {
    last: Option<(PickedFor, Option<ShapeId>)>,
}

/// Everything that the shape under a pixel depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PickedFor {
    document: Revision,
    camera: Camera,
    pixel: Vec2,
    size: Vec2,
}

impl Picked {
    /// The shape at a point of the window, in whichever of `places` that is.
    pub(super) fn shape_at_point(
        &mut self,
        session: &Session,
        places: &ScenePlaces,
        position: Pos2,
    ) -> Option<ShapeId> {
        let place = places.at(position)?;
        self.shape_at(session, place.pixel(position), place.size())
    }

    /// The shape under `pixel` in a picture of `size`.
    pub(super) fn shape_at(
        &mut self,
        session: &Session,
        pixel: Vec2,
        size: Vec2,
    ) -> Option<ShapeId> {
        let wanted = PickedFor {
            document: session.document(),
            camera: session.view().camera,
            pixel,
            size,
        };
        if let Some((found_for, shape)) = self.last
            && found_for == wanted
        {
            return shape;
        }
        let ray = wanted.camera.ray(pixel, size);
        let shape = pick_shape(session.evaluated(), &ray).map(|(shape, _)| shape);
        self.last = Some((wanted, shape));
        shape
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::{Edit, View};
    use crate::scene::{NewShape, ShapeKind};

    #[test]
    fn a_shape_is_picked_again_once_pointer_camera_or_scene_moved_and_not_before() {
        let mut session = Session::new();
        let insert = Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]);
        session.edit(insert).unwrap();
        let cube = session.selected();
        let (size, middle) = (Vec2::new(800.0, 600.0), Vec2::new(400.0, 300.0));
        let mut picked = Picked::default();
        assert_eq!(picked.shape_at(&session, middle, size), cube);
        // The cached answer is given again, whatever it is.
        picked.last = picked.last.map(|(found_for, _)| (found_for, None));
        assert_eq!(picked.shape_at(&session, middle, size), None);
        assert_eq!(picked.shape_at(&session, middle + Vec2::X, size), cube);
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), None);
        let mut camera = session.view().camera;
        camera.pan_with_pointer(Vec2::ONE - middle, size.y, camera.target);
        session.look(View::SetCamera(camera));
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), cube);
        if let Some(id) = cube {
            session.edit(Edit::Delete(id)).unwrap();
        }
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), None);
    }
}
