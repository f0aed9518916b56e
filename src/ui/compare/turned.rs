//! Which joints of a character are turned, where the pixels of the live view that are off and that are right are known.

use super::bones_seen::{BoneSeen, CharacterSeen, extent};
use super::owned::{Owned, Ownership};
use super::pixel_map::{PixelMap, PixelMaps};
use glam::Vec2;
use std::collections::HashSet;

/// How far from a bone's line a pixel may be that is off where the bone is, by the figure's scale: the line runs through the
/// middle of a limb, which is off unless the limb has hardly moved.
const AT_BONE: f32 = 0.012;
/// Share of a bone's line that is off where the joint before it is turned: its beginning stays where it is.
const IS_OFF: f32 = 0.4;
/// Share of a bone's line from which on it is right, so that the joint above that it hangs on is not turned.
const IS_RIGHT: f32 = 0.5;
/// Share of what is seen of a joint's mesh that is off where the joint is turned: what turns a little covers much of where it
/// was. Of a joint that nothing hangs on as much as of a line, for it may be covered by what was elsewhere.
const MESH_IS_OFF: f32 = 0.12;
/// Share of what is seen besides turned limbs that is off where the character is moved or turned as a whole. Where one was
/// moved by a fiftieth of its height, that was 0.37; of one that dances, with all limbs turned, 0.18, by their shadows.
const WHOLE_IS_OFF: f32 = 0.25;
/// Share of the bones that hang on a joint which may be right where it is turned: where they are now, others were.
const RIGHT_BELOW: f32 = 0.4;
/// Length of a bone, by the longest one of the figure, below which it is inside of the limb that hangs on it, as at hips.
const SHORT: f32 = 0.25;
/// How far what hangs on a joint reaches, by the figure's scale, up to which several of its ends that are off are turned by it: a hand
/// that turns about itself stays where it is, while fingers go round.
const SMALL: f32 = 0.08;
/// Share of what is seen of a joint's mesh that is off from which on it may be turned though it is less than that of one that is, where all
/// that hangs on it is off: hips that turn about themselves. Of what stands still it is less.
const HARDLY_OFF: f32 = 0.02;

/// How far from all that the other picture shows what hangs on a joint is where that is turned much, by the figure's scale, and the share
/// of its pixels above which so many are. Where its beginning is right, the end of a limb above follows then, or is covered: of knees
/// that were turned by 100 degrees a fifth was that far and more, and of thighs with a beginning that looked right none.
const FAR: f32 = 0.02;
const ARE_FAR: f32 = 0.1;

/// How sure it has to be that a joint is turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Certainty {
    /// Where less of the mesh of a joint that nothing hangs on is off than of a line, it may as well be covered by what was elsewhere.
    Sure,
    /// It is turned rather than covered: the camera is right, and what is turned for sure does not explain all.
    Likely,
}

/// What differs of a bone.
struct Told<'a> {
    bone: &'a BoneSeen,
    /// Whether it is off, and whether it is right. Nothing is known of what is hidden, and where the figure is thin.
    is_off: bool,
    is_right: bool,
    /// Whether so much of it is off that it is hardly covered by something else alone.
    is_off_by_itself: bool,
    /// Share of the joint's mesh that is off, if enough of that is seen.
    of_mesh: Option<f32>,
}

impl<'a> Told<'a> {
    /// What is told by this share of the mesh of the bone's joint that is off, of which what was elsewhere covers less than
    /// `most_covered`.
    fn by_mesh(bone: &'a BoneSeen, off: f32, most_covered: f32) -> Self {
        Self {
            bone,
            is_off: off >= MESH_IS_OFF,
            is_right: off < MESH_IS_OFF,
            is_off_by_itself: off >= most_covered,
            of_mesh: Some(off),
        }
    }

    /// What is told along the bone's line, where it `is_seen`, by the nearest pixels that are off and right, of those within
    /// `reach`.
    fn by_line(
        bone: &'a BoneSeen,
        [off, right]: &[PixelMap; 2],
        reach: f32,
        is_seen: impl Fn(Vec2) -> bool,
    ) -> Self {
        let (mut of_off, mut of_right) = (0, 0);
        for at in bone.pixels.iter().copied().filter(|&at| is_seen(at)) {
            match (off.nearest(at, reach), right.nearest(at, reach)) {
                (Some(off), right) if right.is_none_or(|right| off <= right) => of_off += 1,
                (_, Some(_)) => of_right += 1,
                _ => {}
            }
        }
        let share = |count: usize| count as f32 / bone.pixels.len().max(1) as f32;
        let (off, right) = (share(of_off), share(of_right));
        let is_off = off >= IS_OFF && off > right;
        Self {
            bone,
            is_off,
            is_right: right >= IS_RIGHT,
            is_off_by_itself: is_off,
            of_mesh: None,
        }
    }

    fn nothing(bone: &'a BoneSeen) -> Self {
        Self {
            bone,
            is_off: false,
            is_right: false,
            is_off_by_itself: false,
            of_mesh: None,
        }
    }

    fn is_known(&self) -> bool {
        self.is_off || self.is_right
    }
}

/// Which joints of a character are turned.
pub(super) struct Turned {
    /// Whether each joint is.
    pub joints: Vec<bool>,
    /// Whether what does not hang on these is off as well, and nothing is known to be right: the character stands elsewhere,
    /// or is turned as a whole.
    pub is_whole: bool,
    /// Whether some joints are known not to be turned.
    has_right: bool,
    /// What may be turned instead.
    pub instead: Vec<Instead>,
}

/// Joints of the trunk of which too little is seen, one of which may be turned instead of all limbs that hang on it.
pub(super) struct Instead {
    /// The joints, from the limbs up.
    pub joints: Vec<usize>,
    /// The joints that turn the limbs.
    pub limbs: Vec<usize>,
}

impl Turned {
    /// Whether some joints are known not to be turned, and none is.
    pub fn is_none_of_known(&self) -> bool {
        self.has_right && !self.joints.contains(&true)
    }
}

/// Which joints of a character are turned, as far as the mesh and the bones tell.
pub(super) fn turned(
    character: &CharacterSeen,
    maps: &PixelMaps,
    owned: &Owned,
    scale: f32,
    certainty: Certainty,
) -> Turned {
    let most_covered = match certainty {
        Certainty::Sure => IS_OFF,
        Certainty::Likely => MESH_IS_OFF,
    };
    let reach = AT_BONE * scale;
    let parent = |joint: usize| character.joints[joint].parent;
    let follows = |bone: &BoneSeen| follows_what_hangs_on_it(character, bone, owned, maps, scale);
    let told = character.bones.iter().map(|bone| {
        let (shape, joint) = (character.shape, bone.joint);
        match owned.of(shape, joint) {
            // Its own movement is none.
            Ownership::Off(share) if share < IS_OFF && follows(bone) => {
                Told::by_mesh(bone, 0.0, most_covered)
            }
            Ownership::Off(share) => Told::by_mesh(bone, share, most_covered),
            // Where it is seen, and not hidden, the one above may move more.
            Ownership::Little if is_last(character, joint) => {
                Told::by_line(bone, &maps.ours, reach, |at| {
                    let seen = owned.joint_at(at, shape);
                    seen.is_some_and(|seen| seen == joint || parent(joint) == Some(seen))
                })
            }
            // What hangs on it tells more.
            Ownership::Little => Told::nothing(bone),
            Ownership::Unknown => Told::by_line(bone, &maps.ours, reach, |_| true),
        }
    });
    let told: Vec<Told> = told.collect();
    let mut joints = turned_by(character, &told);
    turn_small_ones(character, &told, scale, &mut joints);
    let has_right = told.iter().any(|told| told.is_right);
    let hangs_on_none = |joint: usize| !above(character, joint).any(|joint| joints[joint]);
    let off_besides = owned.off_of(character.shape, hangs_on_none);
    Turned {
        is_whole: !has_right && off_besides.is_some_and(|off| off >= WHOLE_IS_OFF),
        instead: instead(character, &told, &joints),
        joints,
        has_right,
    }
}

/// Whether only the end of a bone's mesh is off, at what hangs on it, which is far from all that the other picture shows.
fn follows_what_hangs_on_it(
    character: &CharacterSeen,
    bone: &BoneSeen,
    owned: &Owned,
    maps: &PixelMaps,
    scale: f32,
) -> bool {
    let is_beginning_right = bone.line().is_some_and(|[start, end]| {
        let is_nearer = |at: Vec2| at.distance(start) < at.distance(end);
        let off = owned.off_where(character.shape, bone.joint, is_nearer);
        off.is_some_and(|off| off < HARDLY_OFF)
    });
    let is_below = |it: &usize| hangs_on(character, *it, bone.joint);
    let below = (0..character.joints.len()).filter(is_below);
    let below = below.flat_map(|it| owned.off_pixels(character.shape, it));
    let far = below.clone();
    let far = far.filter(|at| maps.is_far_from_theirs(**at, FAR * scale));
    is_beginning_right && far.count() as f32 > ARE_FAR * below.count() as f32
}

/// What may be turned instead of joints that are.
fn instead(character: &CharacterSeen, told: &[Told], turned: &[bool]) -> Vec<Instead> {
    let mut all: Vec<Instead> = Vec::new();
    // A joint comes before those that hang on it, so that from the end these come first.
    for joint in (0..character.joints.len()).rev() {
        let mut own = told.iter().filter(|told| told.bone.joint == joint);
        let is_hardly_off =
            own.any(|told| told.is_right && told.of_mesh.is_some_and(|off| off >= HARDLY_OFF));
        // A root of which nothing is seen turns all that hangs on it, and is turned then.
        let may_be_turned = match character.joints[joint].parent {
            Some(_) => is_hardly_off || !is_known(told, joint),
            None => is_hardly_off,
        };
        if turned[joint] || !may_be_turned {
            continue;
        }
        let below = || {
            let told = told.iter();
            told.filter(|told| hangs_on(character, told.bone.joint, joint))
        };
        let ends = below().filter(|told| is_last(character, told.bone.joint));
        let ends = ends.count();
        let is_right = |told: &Told| {
            let mut above = above(character, told.bone.joint).take_while(|it| *it != joint);
            told.is_right && !above.any(|it| turned[it])
        };
        // A limb hangs on few that are seen as little, such as a collarbone; what other limbs hang on as well is the trunk.
        if ends < 2 || below().any(is_right) {
            continue;
        }
        let is_top = |limb: &usize| {
            let mut above = above(character, *limb).skip(1);
            turned[*limb] && hangs_on(character, *limb, joint) && !above.any(|it| turned[it])
        };
        let limbs: Vec<usize> = (0..turned.len()).filter(is_top).collect();
        match all.iter_mut().find(|known| known.limbs == limbs) {
            _ if limbs.is_empty() => {}
            Some(known) => known.joints.push(joint),
            None => all.push(Instead {
                joints: vec![joint],
                limbs,
            }),
        }
    }
    all
}

fn turned_by(character: &CharacterSeen, told: &[Told]) -> Vec<bool> {
    let joints = character.joints;
    let is_turned = |joint: usize| {
        let mut own = told.iter().filter(|told| told.bone.joint == joint);
        let below = told.iter();
        let below = below.filter(|told| hangs_on(character, told.bone.joint, joint));
        let below: Vec<&Told> = below.collect();
        let right = below.iter().filter(|told| told.is_right).count();
        // The first ones that something is known of on the way down.
        let is_next = |one: &&&Told| {
            let above = above(character, one.bone.joint).skip(1);
            one.is_known()
                && !above
                    .take_while(|it| *it != joint)
                    .any(|it| is_known(told, it))
        };
        let next: Vec<&&Told> = below.iter().filter(is_next).collect();
        let is_off = if is_known(told, joint) {
            own.any(|told| told.is_off && (told.is_off_by_itself || !next.is_empty()))
        } else {
            // A root of which nothing is seen turns all that hangs on it.
            joints[joint].parent.is_none() && !next.is_empty()
        };
        is_off
            && !next.iter().any(|told| told.is_right)
            && right as f32 <= RIGHT_BELOW * below.len() as f32
    };
    let turned: Vec<bool> = (0..joints.len()).map(is_turned).collect();
    let bones = || character.bones.iter();
    let longest = bones().map(|bone| bone.length).fold(0.0, f32::max);
    // A joint with short bones cannot be told from the one that hangs on it, which is what is posed.
    let is_of_child = |joint: usize| {
        let mut own = bones().filter(|bone| bone.joint == joint);
        let below = turned.iter().zip(joints);
        let turned = below.filter(|(turned, below)| **turned && below.parent == Some(joint));
        let mut told = told.iter().filter(|told| told.bone.joint == joint);
        // Unless its own mesh tells.
        let is_off = told.any(|told| told.of_mesh.is_some_and(|off| off >= IS_OFF));
        !is_off && own.all(|bone| bone.length < SHORT * longest) && turned.count() == 1
    };
    let all = turned.iter().enumerate();
    all.map(|(joint, turned)| *turned && !is_of_child(joint))
        .collect()
}

/// Adds joints that carry little of the figure, of which several ends are off and few are right.
fn turn_small_ones(character: &CharacterSeen, told: &[Told], scale: f32, turned: &mut [bool]) {
    for (joint, turned) in turned.iter_mut().enumerate() {
        if *turned || character.joints[joint].parent.is_none() {
            continue;
        }
        let below = told.iter();
        let below = below.filter(|told| hangs_on(character, told.bone.joint, joint));
        let below: Vec<&Told> = below.collect();
        let pixels = below
            .iter()
            .flat_map(|told| told.bone.pixels.iter().copied());
        let is_small = extent(pixels).is_some_and(|extent| extent <= SMALL * scale);
        let branch = |told: &&&Told| {
            let mut above = above(character, told.bone.joint);
            above.find(|&it| character.joints[it].parent == Some(joint))
        };
        let off = below.iter().filter(|told| told.is_off);
        let right = below.iter().filter(|told| told.is_right).count();
        let all = off.clone().count() + right;
        let branches: HashSet<usize> = off.filter_map(|told| branch(&told)).collect();
        *turned = is_small && right as f32 <= RIGHT_BELOW * all as f32 && branches.len() > 1;
    }
}

/// Whether something is known of a joint.
fn is_known(told: &[Told], joint: usize) -> bool {
    let mut own = told.iter().filter(|told| told.bone.joint == joint);
    own.any(Told::is_known)
}

/// Whether no bone hangs on a joint.
fn is_last(character: &CharacterSeen, joint: usize) -> bool {
    let mut bones = character.bones.iter();
    !bones.any(|bone| character.joints[bone.joint].parent == Some(joint))
}

/// Whether a joint hangs on another one.
fn hangs_on(character: &CharacterSeen, joint: usize, on: usize) -> bool {
    above(character, joint).skip(1).any(|it| it == on)
}

/// A joint and all that it hangs on.
pub(super) fn above(character: &CharacterSeen, joint: usize) -> impl Iterator<Item = usize> {
    let joints = character.joints;
    std::iter::successors(Some(joint), |&joint| joints[joint].parent)
}
