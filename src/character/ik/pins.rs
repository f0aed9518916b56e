use super::frames::frame;
use super::{IkChain, IkGoal};
use crate::character::{Pose, SkeletalModel};
use glam::DVec3;
use std::collections::BTreeSet;

/// A pinned joint that has moved or turned by less than this (of the skeleton's own units, or
/// radians) has not.
const STILL: f64 = 1e-6;

/// A pin that cannot be brought nearer than this by some joints needs more of them.
const HELD: f32 = 1e-5;

/// Brings pinned joints back to where they were, and turned as they were, in model space, after
/// others have been turned or moved: `before` is the pose of then, `after` that of now.
///
/// The joints above a pin make up for what those of `busy` did, which are left alone, as are
/// joints above several pins: the two next to it if they can, as those of an arm or a leg; else
/// the whole limb, up to where others branch off; else as many as there are, but for those that
/// would turn the whole figure. A pin that gets out of reach is pointed at.
pub fn hold_pins(
    skeleton: &SkeletalModel,
    before: &Pose,
    after: &Pose,
    pins: &BTreeSet<usize>,
    busy: &[usize],
) -> Pose {
    let mut pose = after.clone();
    let exists = |pin: &usize| *pin < skeleton.joints().len() && !busy.contains(pin);
    // From the roots outwards: what brings back a pin takes along those below it.
    let mut order: Vec<usize> = pins.iter().copied().filter(exists).collect();
    order.sort_by_key(|&pin| above(skeleton, pin).count());
    let mut fixed = above_several(skeleton, &order);
    fixed.extend(order.iter().chain(busy));
    for pin in order {
        let was = frame(skeleton, before, Some(pin));
        let now = frame(skeleton, &pose, Some(pin));
        let moved = !was.origin.abs_diff_eq(now.origin, STILL);
        if moved || !was.rotation.abs_diff_eq(now.rotation, STILL) {
            pose = brought_back(skeleton, before, pose, pin, was.origin, &fixed);
            super::solve::orient(skeleton, &mut pose, pin, was.rotation);
        }
    }
    pose
}

fn brought_back(
    skeleton: &SkeletalModel,
    before: &Pose,
    mut pose: Pose,
    pin: usize,
    place: DVec3,
    fixed: &BTreeSet<usize>,
) -> Pose {
    let goal = IkGoal::to(place.as_vec3());
    let branches = |joint: &usize| skeleton.children(*joint).len() > 1;
    let mut limb = fixed.clone();
    limb.extend(above(skeleton, pin).filter(branches));
    // A step too long for the legs shall not tip the figure over.
    let mut figure = fixed.clone();
    if let Some(base) = above(skeleton, pin).filter(branches).last() {
        figure.insert(base);
        figure.extend(above(skeleton, base));
    }
    for (length, fixed) in [(2, &limb), (usize::MAX, &limb), (usize::MAX, &figure)] {
        let chain = IkChain::to_joint(skeleton, before, pin, length, fixed);
        let solution = chain.and_then(|chain| chain.solve(skeleton, &pose, &goal));
        if let Some(solution) = solution {
            pose = solution.pose;
            if solution.off < HELD {
                break;
            }
        }
    }
    pose
}

/// The joints above one, the nearest first.
fn above(skeleton: &SkeletalModel, joint: usize) -> impl Iterator<Item = usize> {
    let parent = |&joint: &usize| skeleton.joints()[joint].parent;
    std::iter::successors(parent(&joint), parent)
}

/// The joints that are above two pins or more.
fn above_several(skeleton: &SkeletalModel, pins: &[usize]) -> BTreeSet<usize> {
    let mut once = BTreeSet::new();
    let all = pins.iter().flat_map(|&pin| above(skeleton, pin));
    all.filter(|&joint| !once.insert(joint)).collect()
}
