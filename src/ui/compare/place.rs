//! Differences placed by the bones of the characters in view.

use super::apart::CameraTold;
use super::bones_seen::{CharacterSeen, characters_seen, extent};
use super::limbs::scale;
use super::other_camera::OtherCamera;
use super::turned::above;
use crate::character::Joint;
use crate::compare::{Area, sentence};
use crate::editor::Session;
use glam::Vec2;

/// How far outside an area a bone may be, by the picture's height: limbs are so thick.
const NEAR: f32 = 0.04;

/// Share of the box round a figure that differs, where no limbs explain it, from which on the camera may be what is turned:
/// a drag over a tenth of the window made it 64 %, and a hand that is too small for a limb less than 1 %.
pub(super) const MUCH: f64 = 0.25;

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
        Some(joint) => near(&joint, &area.part_of(figure), None),
        None => sentence(&area.place_in(figure)),
    }
}

/// Sentence about what is near a joint or a shape called `name`, which is such a `part` of the figure in words, and `how` it
/// differs, if that is known.
pub(super) fn near(name: &str, part: &str, how: Option<&str>) -> String {
    let near = format!("near {name}, in {part} of the figure");
    sentence(&how.map_or_else(|| near.clone(), |how| format!("{near}: {how}")))
}

/// Sentence about a character that differs as a whole, which is such a `part` of the figure in words, and `how` it differs if it
/// does not stand elsewhere.
pub(super) fn whole(character: &str, part: &str, how: Option<&str>) -> String {
    const ELSEWHERE: &str = "it is moved, turned or scaled as a whole, or its root joint is turned";
    let how = how.unwrap_or(ELSEWHERE);
    sentence(&format!(
        "all of {character}, in {part} of the figure: {how}"
    ))
}

/// Sentence about something in the other picture, such a `part` of the figure in words, where the live view has nothing, or hides
/// a shape of this name.
pub(super) fn absent(hidden: &str, part: &str) -> String {
    let reason = match hidden {
        "" => "a shape is missing there, or hidden".to_owned(),
        hidden => format!("{hidden} is hidden there"),
    };
    format!("A shows something where B has nothing, in {part} of the figure: {reason}.")
}

/// Sentence about all that is drawn, whose outline is so placed in the live view, in words, `within` so many pixels.
pub(super) fn placed_elsewhere(placement: &str, within: u32, camera: CameraTold) -> String {
    let within = match within {
        0 | 1 => String::new(),
        within => format!(" (to within {within} pixels)"),
    };
    let reason = match camera {
        CameraTold::Right => {
            "the floor is where A has it, so that it is the shape or its root that stands elsewhere"
        }
        CameraTold::Other | CameraTold::Home => {
            "the floor is elsewhere as well, so that it is another camera"
        }
        CameraTold::Unknown => "another camera, or another place or size of the shape",
    };
    sentence(&format!(
        "in B the whole figure is {placement}{within}: {reason}"
    ))
}

/// Sentence about much of a figure, at this place in words, that differs though the camera is right.
pub(super) fn much_differs(place: &str) -> String {
    sentence(&format!(
        "{place}: the floor is where A has it, so that the shape or its root is turned or moved, or limbs are turned"
    ))
}

/// The same without a floor, where a camera is right or may be another one.
pub(super) fn much_is_off(place: &str, camera: CameraTold) -> String {
    const OTHERWISE: &str = "shapes are moved, turned or scaled, several joints are turned, or the skinning differs: Compare with Mesh tells how";
    let reason = match camera {
        CameraTold::Right => OTHERWISE.to_owned(),
        CameraTold::Other | CameraTold::Home | CameraTold::Unknown => {
            format!("A may be seen by another camera than B, or {OTHERWISE}")
        }
    };
    sentence(&format!("{place}: {reason}"))
}

/// Sentence about what is drawn, all or most of which is where the other picture has it when another camera sees it.
pub(super) fn seen_from_elsewhere(camera: &OtherCamera) -> String {
    let share = match camera.explains_all {
        true => "all",
        false => "most",
    };
    let home = match camera.homes {
        None => None,
        Some(1) => Some("Home leads there"),
        Some(_) => Some("Home, pressed twice, leads there"),
    };
    let besides = match (camera.explains_all, home) {
        (true, None) => ".".to_owned(),
        (true, Some(home)) => format!(". {home}."),
        (false, None) => ", but not all: limbs are turned as well, or shapes differ.".to_owned(),
        // There it is known for sure.
        (false, Some(home)) => {
            format!(". {home}, and shows whether limbs are turned as well or shapes differ.")
        }
    };
    format!(
        "A is seen by another camera than B: {}. From there {share} of the outline is where A has it{besides} Or all of it is \
         turned, moved or scaled.",
        camera.told
    )
}

/// Share of the bone of a joint that is in the area of what the joint has turned, but for its beginning; and of bones that
/// hang on that, which may have gone out of it.
const OWN: f32 = 0.75;
const BELOW: f32 = 0.5;

/// How much farther from the middle of the area a bone may be than what hangs on it and be named in its place, by the
/// picture's height: a thumb lies along its hand, and the hand is what is seen to move. The hand of a robot was up to 3.3
/// of 600 pixels farther than its thumb, and its forearm 24.
const AS_NEAR: f32 = 0.006;

/// How large an extremity with its bones is at most, by the figure's scale, of which what carries it is named, where it is not known
/// which of its joints are turned: of a hand that turns about itself fingers are seen to move.
const EXTREMITY: f32 = 0.1;

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
    let [least, most] = area.corners();
    let (half, middle) = ((most - least) / 2.0, (least + most) / 2.0);
    let mut nearest: Option<((usize, f32), String)> = None;
    for character in characters_seen(session, size) {
        let bones = character.bones.iter().map(|bone| {
            let beside = BoneBeside::new(&bone.pixels, middle, half, NEAR * size.y);
            (bone.joint, beside)
        });
        let bones: Vec<(usize, BoneBeside)> = bones.collect();
        let found = nearest_of(character.joints, &bones, AS_NEAR * size.y);
        let Some((place, joint)) = found else {
            continue;
        };
        if nearest.as_ref().is_none_or(|(least, _)| *least > place) {
            let carrier = carrier_of(&character, joint, EXTREMITY * scale(&character, size.y));
            nearest = Some((place, character.name_of(carrier)));
        }
    }
    nearest.map(|(_, joint)| joint)
}

/// The joint that carries all ends of the extremity, up to so many pixels large, that a joint of a character is in; or itself.
fn carrier_of(character: &CharacterSeen, joint: usize, largest: f32) -> usize {
    let is_small = |joint: &usize| {
        let bones = character.bones.iter();
        let carried = bones.filter(|bone| above(character, bone.joint).any(|it| it == *joint));
        let extent = extent(carried.flat_map(|bone| bone.pixels.iter().copied()));
        let is_root = character.joints[*joint].parent.is_none();
        !is_root && extent.is_some_and(|extent| extent <= largest)
    };
    let has_several = |joint: &usize| {
        let joints = character.joints.iter();
        joints.filter(|it| it.parent == Some(*joint)).count() > 1
    };
    let mut carriers = above(character, joint).take_while(is_small);
    carriers.find(has_several).unwrap_or(joint)
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
