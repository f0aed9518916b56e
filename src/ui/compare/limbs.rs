//! Which limbs of a figure differ, by the bones of the characters in view.

use super::bones_seen::{BoneSeen, CharacterSeen, characters_seen};
use crate::editor::Session;
use glam::Vec2;

/// How far from a bone's line a pixel may be that is off where the bone is, by the figure's scale: the line runs through the
/// middle of a limb, which is off unless the limb has hardly moved.
const AT_BONE: f32 = 0.012;
/// How far from its bones a limb reaches, by that scale.
const THICK: f32 = 0.06;
/// How much higher a picture is than the bones in it of which it is the scale: that of smaller ones is less.
const FILLS: f32 = 2.0;
/// Share of a bone's line that is off where the joint before it is turned: its beginning stays where it is.
const IS_OFF: f32 = 0.4;
/// Share of a bone's line from which on it is right, so that the joint above that it hangs on is not turned.
const IS_RIGHT: f32 = 0.5;
/// Share of the bones that hang on a joint which may be right where it is turned: where they are now, others were.
const RIGHT_BELOW: f32 = 0.4;
/// Length of a bone, by the longest one of the figure, below which it is inside of the limb that hangs on it, as at hips.
const SHORT: f32 = 0.25;

/// A limb that differs: what a joint turns.
pub(super) struct Limb {
    /// Name of the joint, with the character's if there are several.
    pub name: String,
    pub body: Body,
    /// Where the joint is.
    joint: Vec2,
}

impl Limb {
    /// Whether what was at a pixel can be the limb, turned otherwise.
    pub fn may_have_been_at(&self, pixel: Vec2) -> bool {
        let ends = self.body.lines.iter().flatten();
        let reach = ends.map(|end| end.distance(self.joint)).fold(0.0, f32::max);
        pixel.distance(self.joint) <= reach + self.body.thick
    }
}

/// What is around bones.
pub(super) struct Body {
    lines: Vec<[Vec2; 2]>,
    /// How far it reaches from there.
    thick: f32,
}

impl Body {
    /// That of a character in a picture of such a height.
    pub fn of(character: &CharacterSeen, height: f32) -> Self {
        Self {
            lines: character.bones.iter().filter_map(BoneSeen::line).collect(),
            thick: THICK * scale(character, height),
        }
    }

    /// How far a pixel is, by how far the body reaches.
    pub fn distance(&self, pixel: Vec2) -> f32 {
        let distances = self.lines.iter().map(|line| distance_from(*line, pixel));
        distances.fold(f32::INFINITY, f32::min) / self.thick
    }
}

/// Distance of a pixel from the line between two.
fn distance_from([start, end]: [Vec2; 2], pixel: Vec2) -> f32 {
    let along = end - start;
    let part = (pixel - start).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    (start + along * part.clamp(0.0, 1.0)).distance(pixel)
}

/// The scale of a character in a picture of such a height: that, or less where the character is small.
fn scale(character: &CharacterSeen, height: f32) -> f32 {
    let pixels = || character.bones.iter().flat_map(|bone| bone.pixels.clone());
    let ends = pixels().reduce(Vec2::min).zip(pixels().reduce(Vec2::max));
    let size = ends.map(|(least, most)| (most - least).max_element());
    size.map_or(height, |size| height.min(FILLS * size))
}

/// The limbs that differ in a live view of `size` pixels: those of the joints nearest to the root that turn bones which are at
/// pixels that are `off`, while others are at such that are `right`. `None` where a root is turned.
pub(super) fn limbs(
    session: &Session,
    [off, right]: [&[Vec2]; 2],
    size: Vec2,
) -> Option<Vec<Limb>> {
    let maps = [off, right].map(|pixels| PixelMap::new(pixels, size));
    let mut limbs = Vec::new();
    for character in characters_seen(session, size) {
        limbs.extend(limbs_of(&character, &maps, size.y)?);
    }
    Some(limbs)
}

/// What differs along a bone.
struct Along<'a> {
    bone: &'a BoneSeen,
    /// Shares of its line that are off and that are right, 0 to 1. Nothing is known of where the figure is thin.
    off: f32,
    right: f32,
}

impl<'a> Along<'a> {
    /// That of a bone with the nearest pixels that are off and right, of those within `reach`.
    fn new(bone: &'a BoneSeen, [off, right]: &[PixelMap; 2], reach: f32) -> Self {
        let (mut of_off, mut of_right) = (0, 0);
        for &at in &bone.pixels {
            match (off.nearest(at, reach), right.nearest(at, reach)) {
                (Some(off), right) if right.is_none_or(|right| off <= right) => of_off += 1,
                (_, Some(_)) => of_right += 1,
                _ => {}
            }
        }
        let share = |count: usize| count as f32 / bone.pixels.len().max(1) as f32;
        Self {
            bone,
            off: share(of_off),
            right: share(of_right),
        }
    }
}

/// The same of one character in a picture of such a height.
fn limbs_of(character: &CharacterSeen, maps: &[PixelMap; 2], height: f32) -> Option<Vec<Limb>> {
    let scale = scale(character, height);
    let bones = character.bones.iter();
    let seen = bones.map(|bone| Along::new(bone, maps, AT_BONE * scale));
    let turned = turned(character, &seen.collect::<Vec<_>>());
    let mut limbs: Vec<(usize, Limb)> = Vec::new();
    for bone in &character.bones {
        let above = above(character, bone.joint);
        let (Some(top), Some(line)) = (above.filter(|&joint| turned[joint]).last(), bone.line())
        else {
            continue;
        };
        // What a root turns is all of the figure.
        character.joints[top].parent?;
        match limbs.iter_mut().find(|(joint, _)| *joint == top) {
            Some((_, limb)) => limb.body.lines.push(line),
            None => {
                let mut own = character.bones.iter().filter(|bone| bone.joint == top);
                let [start, _] = own.find_map(BoneSeen::line).unwrap_or(line);
                let limb = Limb {
                    name: character.name_of(top),
                    body: Body {
                        lines: vec![line],
                        thick: THICK * scale,
                    },
                    joint: start,
                };
                limbs.push((top, limb));
            }
        }
    }
    Some(limbs.into_iter().map(|(_, limb)| limb).collect())
}

/// A joint and all that it hangs on.
fn above(character: &CharacterSeen, joint: usize) -> impl Iterator<Item = usize> {
    let joints = character.joints;
    std::iter::successors(Some(joint), |&joint| joints[joint].parent)
}

/// Whether each joint is turned, as far as its bones tell.
fn turned(character: &CharacterSeen, seen: &[Along]) -> Vec<bool> {
    let joints = character.joints;
    let is_turned = |joint: usize| {
        let mut own = seen.iter().filter(|along| along.bone.joint == joint);
        let hangs_on = |along: &&Along| {
            along.bone.joint != joint && above(character, along.bone.joint).any(|it| it == joint)
        };
        let below: Vec<&Along> = seen.iter().filter(hangs_on).collect();
        let is_right = |along: &&&Along| along.right >= IS_RIGHT;
        let right = below.iter().filter(is_right).count();
        let mut next = below
            .iter()
            .filter(|along| joints[along.bone.joint].parent == Some(joint));
        own.any(|along| along.off >= IS_OFF && along.off > along.right)
            && !next.any(|along| is_right(&along))
            && right as f32 <= RIGHT_BELOW * below.len() as f32
    };
    let turned: Vec<bool> = (0..joints.len()).map(is_turned).collect();
    let bones = || character.bones.iter();
    let longest = bones().map(|bone| bone.length).fold(0.0, f32::max);
    // A joint with short bones cannot be told from what hangs on it, which is what is posed.
    let is_of_child = |joint: usize| {
        let mut own = bones().filter(|bone| bone.joint == joint);
        let mut below = turned.iter().zip(joints);
        own.all(|bone| bone.length < SHORT * longest)
            && below.any(|(turned, below)| *turned && below.parent == Some(joint))
    };
    let all = turned.iter().enumerate();
    all.map(|(joint, turned)| *turned && !is_of_child(joint))
        .collect()
}

/// Pixels by where they are.
struct PixelMap {
    is_in: Vec<bool>,
    size: [usize; 2],
}

impl PixelMap {
    fn new(pixels: &[Vec2], size: Vec2) -> Self {
        let size = [size.x as usize, size.y as usize];
        let mut is_in = vec![false; size[0] * size[1]];
        for pixel in pixels {
            is_in[pixel.y as usize * size[0] + pixel.x as usize] = true;
        }
        Self { is_in, size }
    }

    /// Distance of the nearest pixel, if there is one within `most`.
    fn nearest(&self, at: Vec2, most: f32) -> Option<f32> {
        let along = |at: f32, size: usize| {
            let end = (at + most).floor().max(-1.0) + 1.0;
            (at - most).ceil().max(0.0) as usize..size.min(end as usize)
        };
        let rows = along(at.y, self.size[1]);
        let pixels = rows.flat_map(|y| along(at.x, self.size[0]).map(move |x| (x, y)));
        let known = pixels.filter(|(x, y)| self.is_in[y * self.size[0] + x]);
        let distances = known.map(|(x, y)| Vec2::new(x as f32, y as f32).distance(at));
        distances
            .filter(|distance| *distance <= most)
            .reduce(f32::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_pixel_is_found_at_the_edges_of_a_picture_and_none_outside() {
        let map = PixelMap::new(&[Vec2::ZERO, Vec2::new(9.0, 4.0)], Vec2::new(10.0, 5.0));
        let nearest = |x: f32, y: f32| map.nearest(Vec2::new(x, y), 3.0);
        assert_eq!(nearest(0.0, 2.0), Some(2.0));
        assert_eq!(nearest(-3.0, 0.0), Some(3.0));
        assert_eq!(nearest(9.0, 6.5), Some(2.5));
        for (x, y) in [(-9.0, -9.0), (-3.0, -3.0), (50.0, 2.0), (5.0, 2.0)] {
            assert_eq!(nearest(x, y), None, "{x}, {y}");
        }
    }
}
