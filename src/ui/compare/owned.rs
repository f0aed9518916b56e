//! What is seen at pixels of the live view, and which joints move it.

use crate::character::Influence;
use crate::editor::Session;
use crate::scene::{Seen, ShapeId, seen_by};
use glam::Vec2;
use std::collections::HashMap;

/// Most pixels that are looked at: each takes a few microseconds.
const MOST: usize = 3000;
/// Fewest of them that tell something of a joint, or of a shape.
const FEWEST: usize = 5;
/// Weight from which on a joint moves a vertex by itself: what it shares with the next one moves with that, too.
const OWN: f32 = 0.8;
/// Share of what is seen that may be off where it stands still.
const STILL: f32 = 0.02;

/// Share of a shape that something else may have been before.
const COVERED: f32 = 0.25;

/// What is known of a joint.
pub(super) enum Ownership {
    /// Share of its pixels that are off; the others are right.
    Off(f32),
    /// It shows too little.
    Little,
    /// Nothing of the character's mesh is seen.
    Unknown,
}

/// How many pixels are off, and how many are right.
type Counts = [usize; 2];

/// What the pixels show that are off, and those that are right.
pub(super) struct Owned<'a> {
    session: &'a Session,
    size: Vec2,
    /// Shapes without bones, and characters whose skeletons are seen.
    others: HashMap<ShapeId, Counts>,
    /// Meshes of characters by the joint that moves them most, where it moves them by itself: pixels that are off, and right …
    own: HashMap<(ShapeId, usize), [Vec<Vec2>; 2]>,
    /// … and anywhere.
    strongest: HashMap<(ShapeId, usize), Counts>,
}

impl<'a> Owned<'a> {
    /// Of the pixels that are off and of those that are right in a live view of `size` pixels.
    pub fn new(session: &'a Session, pixels: [&[Vec2]; 2], size: Vec2) -> Self {
        let step = (pixels[0].len() + pixels[1].len()).div_ceil(MOST).max(1);
        let mut owned = Self {
            session,
            size,
            others: HashMap::new(),
            own: HashMap::new(),
            strongest: HashMap::new(),
        };
        for (which, pixels) in pixels.into_iter().enumerate() {
            for &pixel in pixels.iter().step_by(step) {
                match owned.seen_at(pixel) {
                    Some(Seen::Other(shape)) => {
                        owned.others.entry(shape).or_default()[which] += 1;
                    }
                    Some(Seen::Mesh(shape, Some(Influence { joint, weight }))) => {
                        let key = (shape, joint as usize);
                        owned.strongest.entry(key).or_default()[which] += 1;
                        if weight >= OWN {
                            owned.own.entry(key).or_default()[which].push(pixel);
                        }
                    }
                    Some(Seen::Mesh(_, None)) | None => {}
                }
            }
        }
        owned
    }

    fn seen_at(&self, pixel: Vec2) -> Option<Seen> {
        seen_at(self.session, pixel, self.size)
    }

    /// Whether the mesh of a character is seen at a pixel.
    pub fn is_seen_at(&self, [x, y]: [u32; 2], character: ShapeId) -> bool {
        let seen = self.seen_at(Vec2::new(x as f32, y as f32));
        matches!(seen, Some(Seen::Mesh(shape, _)) if shape == character)
    }

    /// What is known of a joint of a shape.
    pub fn of(&self, shape: ShapeId, joint: usize) -> Ownership {
        match self.off_where(shape, joint, |_| true) {
            Some(share) => Ownership::Off(share),
            None if self.own.keys().any(|(of, _)| *of == shape) => Ownership::Little,
            None => Ownership::Unknown,
        }
    }

    /// Pixels of a joint that are off.
    pub fn off_pixels(&self, shape: ShapeId, joint: usize) -> &[Vec2] {
        self.own.get(&(shape, joint)).map_or(&[], |[off, _]| off)
    }

    /// Share of the pixels of a joint that is off, of those that are such; `None` if they are too few.
    pub fn off_where(
        &self,
        shape: ShapeId,
        joint: usize,
        is_such: impl Fn(Vec2) -> bool,
    ) -> Option<f32> {
        let own = self.own.get(&(shape, joint))?;
        share_off([0, 1].map(|which| own[which].iter().filter(|at| is_such(**at)).count()))
    }

    /// Share of what is seen of a shape that is off where such joints move it more than others do; `None` if that is too
    /// little.
    pub fn off_of(&self, shape: ShapeId, is_such: impl Fn(usize) -> bool) -> Option<f32> {
        let of_such = self.strongest.iter();
        let of_such = of_such.filter(|((of, joint), _)| *of == shape && is_such(*joint));
        let counts = of_such.fold(Counts::default(), |[off, right], (_, of)| {
            [off + of[0], right + of[1]]
        });
        share_off(counts)
    }

    /// Whether something that is seen stands still, so that the camera is where it was: a shape without bones, or most joints
    /// of a character.
    pub fn has_still(&self) -> bool {
        let is_still = |counts: &Counts| share_off(*counts).map(|off| off <= STILL);
        let mut joints: HashMap<ShapeId, Counts> = HashMap::new();
        for ((shape, _), counts) in &self.own {
            if let Some(is_still) = is_still(&[0, 1].map(|which| counts[which].len())) {
                joints.entry(*shape).or_default()[usize::from(is_still)] += 1;
            }
        }
        self.others.values().any(|of| is_still(of) == Some(true))
            || joints.values().any(|[moved, still]| still > moved)
    }

    /// Whether all of some shape stands still, which none does that another camera shows.
    pub fn has_still_shape(&self) -> bool {
        let mut characters = self.strongest.keys().map(|(shape, _)| *shape);
        self.others.keys().any(|shape| self.is_still(*shape))
            || characters.any(|shape| self.off_of(shape, |_| true).is_some_and(|off| off <= STILL))
    }

    /// Whether a shape without bones stands still.
    pub fn is_still(&self, shape: ShapeId) -> bool {
        self.off_of_other(shape).is_some_and(|off| off <= STILL)
    }

    /// Whether most of what is seen of it is right, so that what is off may be what was before it.
    pub fn is_mostly_right(&self, shape: ShapeId) -> bool {
        self.off_of_other(shape).is_some_and(|off| off <= COVERED)
    }

    pub fn off_of_other(&self, shape: ShapeId) -> Option<f32> {
        share_off(*self.others.get(&shape)?)
    }

    /// The joint of a shape that moves what is seen at a pixel more than others do; `None` if something else is seen there.
    pub fn joint_at(&self, pixel: Vec2, shape: ShapeId) -> Option<usize> {
        match self.seen_at(pixel)? {
            Seen::Mesh(seen, Some(influence)) if seen == shape => Some(influence.joint as usize),
            _ => None,
        }
    }
}

/// What is seen at a pixel of a live view of `size` pixels; `None` if that is nothing.
pub(super) fn seen_at(session: &Session, pixel: Vec2, size: Vec2) -> Option<Seen> {
    let ray = session.view().camera.ray(pixel + 0.5, size);
    seen_by(session.scene(), session.evaluated(), &ray)
}

/// Share that is off; `None` of too few.
fn share_off([off, right]: Counts) -> Option<f32> {
    let all = off + right;
    (all >= FEWEST).then(|| off as f32 / all as f32)
}
