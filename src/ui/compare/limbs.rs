//! Which limbs of a figure differ, by the bones of the characters in view.

use super::bones_seen::{BoneSeen, CharacterSeen, characters_seen, extent};
use super::elsewhere::is_elsewhere;
use super::owned::Owned;
use super::pixel_map::PixelMaps;
use super::turned::{Certainty, Instead, Turned, above, turned};
use crate::compare::FigureOff;
use crate::editor::Session;
use crate::math::distance_from_segment;
use crate::scene::{Seen, ShapeId};
use glam::Vec2;

/// How much higher a picture is than the bones in it of which it is the scale: that of smaller ones is less.
const FILLS: f32 = 2.0;
/// How far from its bones a limb reaches, by that scale.
const THICK: f32 = 0.06;

/// A limb that differs: what a joint turns.
pub(super) struct Limb {
    /// Name of the joint, with the character's if there are several.
    pub name: String,
    pub body: Body,
    /// The character, and the joint that turns it.
    shape: ShapeId,
    turned_by: usize,
    /// All joints that move with it.
    joints: Vec<usize>,
    /// What else may be turned, in a sentence.
    pub instead: Option<String>,
    /// Where the joint is.
    joint: Vec2,
    /// How far from there its own pixels are known to be.
    farthest: f32,
}

impl Limb {
    /// Whether what was at a pixel can be the limb, turned otherwise.
    pub fn may_have_been_at(&self, pixel: Vec2) -> bool {
        let ends = self.body.lines.iter().flatten();
        let reach = ends.map(|end| end.distance(self.joint)).fold(0.0, f32::max);
        pixel.distance(self.joint) <= self.farthest.max(reach + self.body.thick)
    }

    /// Whether it moves what is seen of a mesh.
    pub fn moves(&self, seen: &Seen) -> bool {
        match seen {
            Seen::Mesh(shape, Some(influence)) => {
                *shape == self.shape && self.joints.contains(&(influence.joint as usize))
            }
            _ => false,
        }
    }

    /// Extends it to a pixel of its own, which may lie beside its bones.
    pub fn extend_to(&mut self, pixel: Vec2) {
        self.farthest = self.farthest.max(pixel.distance(self.joint));
    }
}

/// The limbs of the characters in view that differ.
pub(super) struct Limbs {
    pub all: Vec<Limb>,
    /// What joints move that may be turned instead, besides limbs.
    pub trunks: Vec<Body>,
    /// Characters of which more than limbs differs.
    pub whole: Vec<ShapeId>,
    /// Whether something that is seen stands still, so that the camera is where it was.
    pub is_camera_right: bool,
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
        let lines = self.lines.iter();
        let distances = lines.map(|line| distance_from_segment(pixel, *line));
        distances.fold(f32::INFINITY, f32::min) / self.thick
    }
}

/// The scale of a character in a picture of such a height: that, or less where the character is small.
pub(super) fn scale(character: &CharacterSeen, height: f32) -> f32 {
    let bones = character.bones.iter();
    let size = extent(bones.flat_map(|bone| bone.pixels.iter().copied()));
    size.map_or(height, |size| height.min(FILLS * size))
}

/// The limbs that differ in a live view of `size` pixels: those of the joints nearest to the root that turn bones which are at
/// pixels that are `off`, while others are at such that are right.
pub(super) fn limbs(
    session: &Session,
    owned: &Owned,
    off: &FigureOff,
    maps: &PixelMaps,
    size: Vec2,
    certainty: Certainty,
) -> Limbs {
    let characters = characters_seen(session, size).into_iter();
    let characters = characters.map(|character| {
        let scale = scale(&character, size.y);
        let turned = turned(&character, maps, owned, scale, certainty);
        (character, scale, turned)
    });
    let characters: Vec<_> = characters.collect();
    let mut turned = characters.iter().map(|(.., turned)| turned);
    let is_camera_right =
        off.is_camera_right || owned.has_still() || turned.any(Turned::is_none_of_known);
    let mut limbs = Limbs {
        all: Vec::new(),
        trunks: Vec::new(),
        whole: Vec::new(),
        is_camera_right,
    };
    for (character, scale, turned) in characters {
        let of_character = limbs_of(&character, &turned, scale).filter(|of_character| {
            let may_be_elsewhere = of_character.len() > 1 && is_camera_right;
            let is_elsewhere =
                || may_be_elsewhere && is_elsewhere(owned, character.shape, off, size);
            !turned.is_whole && !is_elsewhere()
        });
        match of_character {
            Some(mut of_character) => {
                for instead in &turned.instead {
                    let bones = character.bones.iter();
                    let of_trunk = bones.filter(|bone| instead.joints.contains(&bone.joint));
                    limbs.trunks.push(Body {
                        lines: of_trunk.filter_map(BoneSeen::line).collect(),
                        thick: THICK * scale,
                    });
                    let mut last = of_character.iter_mut().rev();
                    let last = last.find(|limb| instead.limbs.contains(&limb.turned_by));
                    if let Some(limb) = last {
                        limb.instead = Some(in_words(instead, &character));
                    }
                }
                limbs.all.extend(of_character);
            }
            None => limbs.whole.push(character.shape),
        }
    }
    limbs
}

/// What may be turned instead of limbs.
fn in_words(instead: &Instead, character: &CharacterSeen) -> String {
    let limbs = character.names_of(&instead.limbs);
    let hang = if instead.limbs.len() == 1 {
        "hangs"
    } else {
        "hang"
    };
    let it = if instead.joints.len() == 1 {
        "that"
    } else {
        "one of these"
    };
    let joints = instead.joints.iter().map(|&it| &*character.joints[it].name);
    let joints = joints.collect::<Vec<&str>>().join(" and ");
    format!("{limbs} {hang} on {joints}: {it} may be turned instead.")
}

/// Those of one character of which these joints are `turned`; `None` where a root is.
fn limbs_of(character: &CharacterSeen, turned: &Turned, scale: f32) -> Option<Vec<Limb>> {
    let mut limbs: Vec<(usize, Limb)> = Vec::new();
    for bone in &character.bones {
        let above = above(character, bone.joint);
        let (Some(top), Some(line)) = (
            above.filter(|&joint| turned.joints[joint]).last(),
            bone.line(),
        ) else {
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
                    farthest: 0.0,
                    shape: character.shape,
                    turned_by: top,
                    joints: (0..character.joints.len())
                        .filter(|&joint| self::above(character, joint).any(|it| it == top))
                        .collect(),
                    instead: None,
                };
                limbs.push((top, limb));
            }
        }
    }
    Some(limbs.into_iter().map(|(_, limb)| limb).collect())
}
