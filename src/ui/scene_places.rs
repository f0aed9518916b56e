use egui::{Pos2, Rect};
use glam::Vec2;

/// Where pictures of the scene are shown, so that what the pointer does finds its way into them.
#[derive(Clone, Debug, PartialEq)]
pub struct ScenePlaces {
    /// In points. All show the scene in the same size, and do not overlap.
    pub rects: Vec<Rect>,
    /// Length of a pixel of the picture, in points, as far as gestures are concerned.
    pub points_per_pixel: f32,
}

impl ScenePlaces {
    /// The scene fills `rect`, and a point of the screen counts as a pixel.
    pub fn whole(rect: Rect) -> Self {
        Self {
            rects: vec![rect],
            points_per_pixel: 1.0,
        }
    }

    /// Which of the pictures is under a point of the screen.
    pub fn index_at(&self, position: Pos2) -> Option<usize> {
        self.rects.iter().position(|rect| rect.contains(position))
    }

    /// Where a point of the screen lies in the picture with this index (from its upper left
    /// corner; it may lie outside of it), and the picture's size; both in points.
    pub fn pixel(&self, index: usize, position: Pos2) -> Option<(Vec2, Vec2)> {
        let rect = self.rects.get(index)?;
        let from_corner = position - rect.min;
        Some((
            Vec2::new(from_corner.x, from_corner.y),
            Vec2::new(rect.width(), rect.height()),
        ))
    }
}
