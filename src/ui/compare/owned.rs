//! Which joints move what is seen at pixels of the live view.

use crate::editor::Session;
use crate::scene::{ShapeId, joint_seen_by};
use glam::Vec2;
use std::collections::HashMap;

/// Most pixels that are looked at: each takes a few microseconds.
const MOST: usize = 3000;
/// Fewest of them that tell something of a joint.
const FEWEST: usize = 5;
/// Weight from which on a joint moves a vertex by itself: what it shares with the next one moves with that, too.
const OWN: f32 = 0.8;

/// What is known of a joint.
pub(super) enum Ownership {
    /// Share of its pixels that are off; the others are right.
    Off(f32),
    /// It shows too little.
    Little,
    /// Nothing of the character's mesh is seen.
    Unknown,
}

/// How many pixels that are off, and how many that are right, show the mesh of a character where each of its joints moves
/// it most.
pub(super) struct Owned<'a> {
    session: &'a Session,
    size: Vec2,
    counts: HashMap<(ShapeId, usize), [usize; 2]>,
}

impl<'a> Owned<'a> {
    /// Of the pixels that are off and of those that are right in a live view of `size` pixels.
    pub fn new(session: &'a Session, pixels: [&[Vec2]; 2], size: Vec2) -> Self {
        let (scene, evaluated) = (session.scene(), session.evaluated());
        let camera = &session.view().camera;
        let step = (pixels[0].len() + pixels[1].len()).div_ceil(MOST).max(1);
        let mut counts: HashMap<(ShapeId, usize), [usize; 2]> = HashMap::new();
        for (which, pixels) in pixels.into_iter().enumerate() {
            for &pixel in pixels.iter().step_by(step) {
                let ray = camera.ray(pixel + 0.5, size);
                if let Some((shape, Some(influence))) = joint_seen_by(scene, evaluated, &ray)
                    && influence.weight >= OWN
                {
                    let joint = influence.joint as usize;
                    counts.entry((shape, joint)).or_default()[which] += 1;
                }
            }
        }
        Self {
            session,
            size,
            counts,
        }
    }

    /// What is known of a joint of a shape.
    pub fn of(&self, shape: ShapeId, joint: usize) -> Ownership {
        let counts = self.counts.get(&(shape, joint));
        let counts = counts.copied().unwrap_or_default();
        let all: usize = counts.iter().sum();
        if all >= FEWEST {
            Ownership::Off(counts[0] as f32 / all as f32)
        } else if self.counts.keys().any(|(of, _)| *of == shape) {
            Ownership::Little
        } else {
            Ownership::Unknown
        }
    }

    /// The joint of a shape that moves what is seen at a pixel more than others do; `None` if something else is seen there.
    pub fn joint_at(&self, pixel: Vec2, shape: ShapeId) -> Option<usize> {
        let (scene, evaluated) = (self.session.scene(), self.session.evaluated());
        let ray = self.session.view().camera.ray(pixel + 0.5, self.size);
        let (seen, influence) = joint_seen_by(scene, evaluated, &ray)?;
        let influence = influence.filter(|_| seen == shape)?;
        Some(influence.joint as usize)
    }
}
