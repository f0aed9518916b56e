//! What may be a part that differs, and which of these is at a pixel.

use super::how::{how_of_character, how_of_shape};
use super::limbs::Limb;
use super::owned::{Owned, seen_at};
use super::part::Kind;
use super::seen_in_cells::SeenInCells;
use super::shapes_seen::ShapeSeen;
use crate::compare::FigureOff;
use crate::scene::Seen;
use glam::Vec2;

/// What may be a part.
pub(super) enum Candidate<'a> {
    Limb(Limb),
    Shape(ShapeSeen<'a>),
}

impl Candidate<'_> {
    /// How far a pixel is, by how far the part reaches: 1 at most where the part is.
    pub fn distance(&self, pixel: Vec2) -> f32 {
        match self {
            Self::Limb(limb) => limb.body.distance(pixel),
            Self::Shape(shape) => shape.distance(pixel),
        }
    }

    /// Whether what was at a pixel can be the part, turned otherwise or moved.
    pub fn may_have_been_at(&self, pixel: Vec2) -> bool {
        match self {
            Self::Limb(limb) => limb.may_have_been_at(pixel),
            Self::Shape(_) => true,
        }
    }

    /// Whether it is a limb whose joint moves what is seen of a mesh.
    fn moves(&self, seen: &Seen) -> bool {
        match self {
            Self::Limb(limb) => limb.moves(seen),
            Self::Shape(_) => false,
        }
    }

    /// Its name, and what it is where these pixels of what is `off` in the live view are its own, and those of the other picture.
    pub fn told(
        self,
        pixels: &[Vec<(u32, u32)>; 2],
        (owned, seen): (&Owned, &SeenInCells),
        off: &FigureOff,
    ) -> (String, Kind) {
        match self {
            Self::Limb(limb) => {
                let instead = limb.instead;
                (limb.name, Kind::Limb { instead })
            }
            Self::Shape(shape) => {
                let kind = match shape.is_character {
                    true => Kind::Character(how_of_character(shape.id, (owned, seen), pixels, off)),
                    false => {
                        let share = owned.off_of_other(shape.id).unwrap_or(1.0);
                        Kind::Shape(how_of_shape(pixels, shape.is_curve.then_some(share)))
                    }
                };
                (shape.name.to_owned(), kind)
            }
        }
    }
}

/// The index of the candidate that is nearest to a pixel, and how far that is by how far it reaches: 1 at most where it is.
pub(super) type Nearest = Option<(usize, f32)>;

/// The candidate nearest to a pixel of those that `may_be` there. Where boxes round shapes lie over one another, it is the shape that
/// is seen there in the live view.
pub(super) fn nearest(
    candidates: &[Candidate],
    pixel: Vec2,
    may_be: impl Fn(&Candidate) -> bool,
    seen: &SeenInCells,
) -> Nearest {
    let all = candidates.iter().enumerate().filter(|(_, it)| may_be(it));
    let distances = all.map(|(part, it)| (part, it.distance(pixel)));
    let nearest = distances.clone().min_by(|(_, a), (_, b)| a.total_cmp(b))?;
    let mut as_near = distances.filter(|(_, distance)| *distance == nearest.1);
    let is_one = as_near.clone().nth(1).is_none();
    let seen = if is_one { None } else { seen.shape_at(pixel) };
    let is_seen = |part: usize| match &candidates[part] {
        Candidate::Limb(_) => false,
        Candidate::Shape(shape) => Some(shape.id) == seen,
    };
    as_near.find(|(part, _)| is_seen(*part)).or(Some(nearest))
}

/// The same for a pixel of the live view, where none is near: the limb whose joint moves what is seen there, however far that is
/// from its bones.
pub(super) fn moved_or_nearest(
    candidates: &[Candidate],
    pixel: Vec2,
    seen: &SeenInCells,
) -> Nearest {
    let nearest = nearest(candidates, pixel, |_| true, seen);
    let is_near = nearest.is_some_and(|(_, distance)| distance <= 1.0);
    let moved = || {
        let (session, size) = seen.view();
        let mesh = seen_at(session, pixel, size).filter(|_| !is_near)?;
        let part = candidates.iter().position(|it| it.moves(&mesh))?;
        Some((part, 1.0))
    };
    if is_near {
        nearest
    } else {
        moved().or(nearest)
    }
}
