//! Turns that joints in one place share: no vertex tells how, so that the plainest way is told.

use super::fit::Posed;
use super::{TOLD_APART, degrees_between};
use crate::diagnose::model::Model;
use glam::DMat3;

/// Parents of which no more share turns with their children where all ways to share them are tried.
const MOST_PARENTS: usize = 4;
/// How far a joint that is at rest and not as expected is from plain.
const AT_REST: u32 = 1;
/// How far a joint is from plain that has angles of which nobody knows: farther than all of the joints at rest that may
/// come of one slip, such as a torso that is not turned.
const TURNED: u32 = 4;

/// A joint that moves no vertex but by joints that hang on it at its own place: a turn of it can as well be theirs.
#[derive(Debug)]
pub(super) struct SharedTurn {
    parent: usize,
    /// The joints that hang on it and move vertices.
    children: Vec<usize>,
}

impl SharedTurn {
    /// All of a model, from the root on. Places within `tolerance` are the same.
    pub(super) fn all(model: &Model, tolerance: f64) -> Vec<Self> {
        let joints = model.skeleton().joints();
        let (own, below) = (&model.moves, model.moving_or_below());
        let of_parent = model.by_depth.iter().filter_map(|&parent| {
            let children = model.skeleton().children(parent).iter().copied();
            let children: Vec<usize> = children.filter(|&child| below[child]).collect();
            let is_here = |&child: &usize| joints[child].offset.as_dvec3().length() <= tolerance;
            let is_shared = !own[parent] && !children.is_empty() && children.iter().all(is_here);
            is_shared.then_some(Self { parent, children })
        });
        of_parent.collect()
    }

    /// The joints that share the turn.
    pub(super) fn joints(&self) -> impl Iterator<Item = usize> {
        self.children.iter().copied().chain([self.parent])
    }

    /// Ways to share it: as `posed` has it, or so that one of the joints is as expected or at rest.
    fn ways(&self, posed: &Posed, expected: &Posed) -> Vec<Posed> {
        let mut ways = vec![posed.clone()];
        for joint in self.joints() {
            let own = posed.rotations[joint];
            for wanted in [expected.rotations[joint], DMat3::IDENTITY] {
                // The parent turns by this before its children, which turn back.
                let more = if joint == self.parent {
                    own.transpose() * wanted
                } else {
                    own * wanted.transpose()
                };
                let mut way = posed.clone();
                way.rotations[self.parent] *= more;
                for &child in &self.children {
                    way.rotations[child] = more.transpose() * way.rotations[child];
                }
                ways.push(way);
            }
        }
        ways
    }
}

/// The pose `posed` with the turns `shared` so divided that as many joints as possible are as expected, and as many of
/// the others as possible at rest.
pub(super) fn plainest(shared: &[SharedTurn], posed: &Posed, expected: &Posed) -> Posed {
    if shared.len() > MOST_PARENTS {
        return posed.clone();
    }
    let Some((first, others)) = shared.split_first() else {
        return posed.clone();
    };
    let ways = first.ways(posed, expected);
    let ways = ways.iter().map(|way| plainest(others, way, expected));
    // Of equals the first.
    let best = ways.min_by_key(|way| from_plain(way, expected));
    best.unwrap_or_else(|| posed.clone())
}

/// How far all joints are from plain.
fn from_plain(posed: &Posed, expected: &Posed) -> u32 {
    let rotations = posed.rotations.iter().zip(&expected.rotations);
    let of_joint = rotations.map(|(rotation, expected)| {
        let is = |other: DMat3| degrees_between(*rotation, other) <= TOLD_APART;
        if is(*expected) {
            0
        } else if is(DMat3::IDENTITY) {
            AT_REST
        } else {
            TURNED
        }
    });
    of_joint.sum()
}
