//! Differences placed by the bones of the characters in view.

use super::bones_seen::characters_seen;
use super::parts::{of_shapes, parts};
use crate::character::Joint;
use crate::compare::{Area, FigureOff, about, sentence};
use crate::editor::Session;
use glam::Vec2;
use std::collections::BTreeMap;

/// How far outside an area a bone may be, by the picture's height: limbs are so thick.
const NEAR: f32 = 0.04;

/// Sentence about where `area` of the live view is, which is a picture of `size` pixels, in words: by the joint that
/// turns the bone nearest to its middle, or else by where it lies in `figure`, the area round all
/// that is drawn.
pub(super) fn place(session: &Session, area: Area, figure: Area, size: (u32, u32)) -> String {
    let joint = if area.is_all_over(figure) {
        None
    } else {
        nearest_joint(session, area, size)
    };
    match joint {
        Some(joint) => near(&joint, &area.part_of(figure)),
        None => sentence(&area.place_in(figure)),
    }
}

/// A place in which pictures differ.
pub(super) struct Place {
    pub told: String,
    pub area: Area,
}

/// The parts that differ in a live view of `size` pixels, if there are some that explain what does.
pub(super) fn of_parts(session: &Session, off: &FigureOff, size: (u32, u32)) -> Vec<Place> {
    let parts = parts(session, off, size).into_iter();
    let places = parts.map(|part| Place {
        told: near(&part.name, &about(part.percent)),
        area: part.area,
    });
    places.collect()
}

/// Pixels, of those that stand for what is off, up to which places apart from one another are sought.
const MOST_PIXELS: usize = 8000;
/// Most places apart from one another that are told one by one, …
const MOST_APART: usize = 4;
/// … and how far they are apart, by the picture's height.
const APART: f32 = 0.025;

/// The places apart from one another in which what is drawn differs, which has `figure` round it: parts of the scene, or else
/// where a bone is near, or where they lie in the figure. None if there are too many.
pub(super) fn apart(
    session: &Session,
    off: &FigureOff,
    figure: Area,
    size: (u32, u32),
) -> Vec<Place> {
    // Where so much is off, no parts are, and to look for some would take longer than a frame.
    if off.ours.len() + off.theirs.len() > MOST_PIXELS {
        return Vec::new();
    }
    let off = of_shapes(session, off, size);
    let of_parts = of_parts(session, &off, size);
    if !of_parts.is_empty() {
        return of_parts;
    }
    let apart = areas_apart(&off, (APART * size.1 as f32).max(1.0) as u32);
    if apart.len() > MOST_APART {
        return Vec::new();
    }
    let places = apart.into_iter().map(|(area, is_ours)| {
        // Bones are where the live view has them.
        let told = match is_ours {
            true => place(session, area, figure, size),
            false => sentence(&area.place_in(figure)),
        };
        Place { told, area }
    });
    places.collect()
}

/// The areas round pixels that are off which are at least about `cell` pixels apart, from the top down, and whether some of
/// these are of the live view. Where it is not known what is behind shapes, only such.
fn areas_apart(off: &FigureOff, cell: u32) -> Vec<(Area, bool)> {
    let mut cells: BTreeMap<[u32; 2], Vec<(u32, u32, bool)>> = BTreeMap::new();
    for (pixels, is_ours) in [(&off.ours, true), (&off.theirs, false)] {
        for &[x, y] in pixels {
            let of_cell = cells.entry([y / cell, x / cell]).or_default();
            of_cell.push((x, y, is_ours));
        }
    }
    let mut areas = Vec::new();
    while let Some((first, pixels)) = cells.pop_first() {
        let (mut of_place, mut next) = (pixels, vec![first]);
        while let Some([row, column]) = next.pop() {
            let rows = row.saturating_sub(1)..=row + 1;
            let columns = column.saturating_sub(1)..=column + 1;
            for beside in rows.flat_map(|row| columns.clone().map(move |column| [row, column])) {
                if let Some(pixels) = cells.remove(&beside) {
                    of_place.extend(pixels);
                    next.push(beside);
                }
            }
        }
        let is_ours = of_place.iter().any(|(.., is_ours)| *is_ours);
        let area = Area::around(of_place.into_iter().map(|(x, y, _)| (x, y)));
        areas.extend(
            area.filter(|_| is_ours || off.has_outline)
                .map(|area| (area, is_ours)),
        );
    }
    areas
}

/// Sentence about what is near `joint`, which is such a `part` of the figure in words.
pub(super) fn near(joint: &str, part: &str) -> String {
    sentence(&format!("near {joint}, in {part} of the figure"))
}

/// Share of the bone of a joint that is in the area of what the joint has turned, but for its beginning; and of bones that
/// hang on that, which may have gone out of it.
const OWN: f32 = 0.75;
const BELOW: f32 = 0.5;

/// How much farther from the middle of the area a bone may be than what hangs on it and be named in its place, by the
/// picture's height: a thumb lies along its hand, and the hand is what is seen to move. The hand of a robot was up to 3.3
/// of 600 pixels farther than its thumb, and its forearm 24.
const AS_NEAR: f32 = 0.006;

/// A bone beside an area of a picture.
#[derive(Clone, Copy, Debug)]
struct BoneBeside {
    /// Whether a part of it is in the area, or near it.
    is_near: bool,
    /// Share of it that is in the area, 0 to 1.
    inside: f32,
    /// Mean distance from the middle of the area, in pixels. Of the whole bone: a shin ends where the foot begins, which
    /// alone may be off.
    distance: f32,
}

impl BoneBeside {
    /// A bone with points at `pixels`, beside the area that reaches `half` to all sides of `middle`.
    fn new(pixels: &[Vec2], middle: Vec2, half: Vec2, near: f32) -> Self {
        let outside = |pixel: &Vec2| ((pixel - middle).abs() - half).max(Vec2::ZERO).length();
        let inside = pixels.iter().filter(|pixel| outside(pixel) == 0.0).count();
        let distances = pixels.iter().map(|pixel| (pixel - middle).length());
        Self {
            is_near: pixels.iter().any(|pixel| outside(pixel) <= near),
            inside: inside as f32 / pixels.len().max(1) as f32,
            distance: distances.sum::<f32>() / pixels.len().max(1) as f32,
        }
    }
}

/// Name of the joint, with the character's if there are several: of those that have all of their bones and of those that
/// hang on them in the area the one nearest to the root, since a joint takes along what hangs on it; or else the one whose
/// bone is nearest to the middle, or as near as that.
fn nearest_joint(session: &Session, area: Area, size: (u32, u32)) -> Option<String> {
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let half = Vec2::new(area.width as f32, area.height as f32) / 2.0;
    let middle = Vec2::new(area.x as f32, area.y as f32) + half;
    let mut nearest: Option<((usize, f32), String)> = None;
    for character in characters_seen(session, size) {
        let bones = character.bones.iter().map(|(joint, pixels)| {
            let beside = BoneBeside::new(pixels, middle, half, NEAR * size.y);
            (*joint, beside)
        });
        let bones: Vec<(usize, BoneBeside)> = bones.collect();
        let found = nearest_of(character.joints, &bones, AS_NEAR * size.y);
        let Some((place, joint)) = found else {
            continue;
        };
        if nearest.as_ref().is_none_or(|(least, _)| *least > place) {
            nearest = Some((place, character.name_of(joint)));
        }
    }
    nearest.map(|(_, joint)| joint)
}

/// The same of one character with `bones`: a joint, and how far it is from being that which is meant. One that is up to
/// `as_near` farther than the nearest counts as near as that.
fn nearest_of(
    joints: &[Joint],
    bones: &[(usize, BoneBeside)],
    as_near: f32,
) -> Option<((usize, f32), usize)> {
    let above = |joint| std::iter::successors(Some(joint), |&joint: &usize| joints[joint].parent);
    let near = bones.iter().filter(|(_, seen)| seen.is_near);
    let places = near.clone().map(|&(joint, seen)| {
        let mut below = bones
            .iter()
            .filter(|(other, _)| above(*other).any(|a| a == joint));
        let takes_all = seen.inside >= OWN && below.all(|(_, seen)| seen.inside >= BELOW);
        let rank = if takes_all {
            above(joint).count()
        } else {
            usize::MAX
        };
        ((rank, seen.distance), joint)
    });
    let (place, nearest) = places.min_by(|(a, _), (b, _)| {
        let ranks = a.0.cmp(&b.0);
        ranks.then(a.1.total_cmp(&b.1))
    })?;
    if place.0 < usize::MAX {
        return Some((place, nearest));
    }
    let is_as_near = |joint: &usize| {
        let mut own = near.clone().filter(|(of, _)| of == joint);
        own.any(|(_, seen)| seen.distance <= place.1 + as_near)
    };
    let joint = above(nearest).take_while(|joint| *joint == nearest || is_as_near(joint));
    Some((place, joint.last()?))
}
