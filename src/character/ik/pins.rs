use super::chain::{IkChain, IkGoal, frame, orient};
use crate::character::{Pose, SkeletalModel};
use glam::DVec3;
use std::collections::BTreeSet;

/// Movement (in units of model space) or rotation (in entries of the matrix) of a pinned joint
/// below which it counts as still.
const STILL: f64 = 1e-6;

/// Distance, in model space, from its place beyond which more joints are needed to hold a pin.
const HELD: f32 = 1e-5;

/// Returns the pose `after` with pinned joints back at the position and orientation, in model
/// space, that they have under `before`.
///
/// The joints above a pin compensate for what the joints of `busy` did, which do not change, nor do
/// joints above several pins: the two next to it if that is enough, as in an arm or a leg; else the
/// whole limb, up to where others branch off; else all of them except those that would turn the
/// whole figure. The limb of a pin out of reach points at it.
pub fn hold_pins(
    skeleton: &SkeletalModel,
    before: &Pose,
    after: &Pose,
    pins: &BTreeSet<usize>,
    busy: &[usize],
) -> Pose {
    let mut pose = after.clone();
    let exists = |pin: &usize| *pin < skeleton.joints().len() && !busy.contains(pin);
    // From the roots outward: moving back a pin moves those below it.
    let mut order: Vec<usize> = pins.iter().copied().filter(exists).collect();
    order.sort_by_key(|&pin| above(skeleton, pin).count());
    let mut fixed = above_several(skeleton, &order);
    fixed.extend(order.iter().chain(busy));
    for pin in order {
        let was = frame(skeleton, before, Some(pin));
        let now = frame(skeleton, &pose, Some(pin));
        let moved = !was.origin.abs_diff_eq(now.origin, STILL);
        if moved || !was.rotation.abs_diff_eq(now.rotation, STILL) {
            pose = restore_position(skeleton, before, pose, pin, was.origin, &fixed);
            orient(skeleton, &mut pose, pin, was.rotation);
        }
    }
    pose
}

/// Moves `pin` back to `place`, in model space, by the joints above it that are not `fixed`.
fn restore_position(
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
    // A step that is too long for the legs must not tip the figure over.
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

/// Indices of the joints above one, the nearest first.
fn above(skeleton: &SkeletalModel, joint: usize) -> impl Iterator<Item = usize> {
    let parent = |&joint: &usize| skeleton.joints()[joint].parent;
    std::iter::successors(parent(&joint), parent)
}

/// Indices of the joints that are above two pins or more.
fn above_several(skeleton: &SkeletalModel, pins: &[usize]) -> BTreeSet<usize> {
    let mut once = BTreeSet::new();
    let all = pins.iter().flat_map(|&pin| above(skeleton, pin));
    all.filter(|&joint| !once.insert(joint)).collect()
}
