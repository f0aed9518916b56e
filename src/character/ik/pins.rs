use super::frames::frame;
use super::{IkChain, IkGoal};
use crate::character::{Pose, SkeletalModel};
use std::collections::BTreeSet;

/// A pinned joint that has moved or turned by less than this (of the skeleton's own units, or
/// radians) has not.
const STILL: f64 = 1e-6;

/// Brings pinned joints back to where they were, and turned as they were, in model space, after
/// others have been turned or moved: `before` is the pose of then, `after` that of now. The
/// joints between a pin and the joints of `busy` make up for what these did; those and other
/// pins are left alone. A pin that gets out of reach is pointed at.
pub fn hold_pins(
    skeleton: &SkeletalModel,
    before: &Pose,
    after: &Pose,
    pins: &BTreeSet<usize>,
    busy: &[usize],
) -> Pose {
    let mut pose = after.clone();
    let exists = |pin: &usize| *pin < skeleton.joints().len() && !busy.contains(pin);
    let mut fixed = pins.clone();
    fixed.extend(busy);
    // From the roots outwards: what brings back a pin takes along those below it.
    let mut order: Vec<usize> = pins.iter().copied().filter(exists).collect();
    order.sort_by_key(|&pin| depth(skeleton, pin));
    for pin in order {
        let was = frame(skeleton, before, Some(pin));
        let now = frame(skeleton, &pose, Some(pin));
        let moved = !was.origin.abs_diff_eq(now.origin, STILL);
        if !moved && was.rotation.abs_diff_eq(now.rotation, STILL) {
            continue;
        }
        let chain = IkChain::to_joint(skeleton, before, pin, usize::MAX, &fixed);
        let goal = IkGoal::to(was.origin.as_vec3());
        let solution = chain.and_then(|chain| chain.solve(skeleton, &pose, &goal));
        if let Some(solution) = solution {
            pose = solution.pose;
        }
        super::solve::orient(skeleton, &mut pose, pin, was.rotation);
    }
    pose
}

fn depth(skeleton: &SkeletalModel, joint: usize) -> usize {
    let parent = |&joint: &usize| skeleton.joints()[joint].parent;
    std::iter::successors(Some(joint), parent).count()
}
