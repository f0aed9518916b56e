//! What the other picture shows where the live view has nothing.

use super::clusters::clusters;
use super::how::EMPTY;
use super::part::Pixels;
use super::shapes_seen::box_of;
use crate::compare::{Area, FigureOff};
use crate::editor::Session;
use glam::Vec2;
use std::collections::HashSet;

/// How far apart groups of pixels are of which each may be a shape, by how far apart the pixels are.
const CLUSTER: u32 = 4;
/// How many times as large as a shape what is elsewhere of it may be in the other picture: nearer to the eye.
const LARGER: f64 = 2.5;
/// Share of what the other picture shows from which on something is told that the live view has not.
const LEAST: f64 = 0.02;
/// Share of the boxes round a hidden shape and round what is absent that both have, where that is it.
const OVERLAP: f32 = 0.4;

/// A pixel of the other picture that is off, and the part of the live view that may have been there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Attributed {
    pub pixel: (u32, u32),
    /// Index of the part, if it can be one.
    pub part: Option<usize>,
}

/// The pixels without groups of them that can be none of the parts, and these groups. `sizes` has for each part how many pixels of
/// the live view are off, or `None` for a limb, of which the other picture may show much more. Where figures are not told from what is behind them, nothing is absent.
pub(super) fn without_absent(
    theirs: impl Iterator<Item = Attributed>,
    sizes: &[Option<usize>],
    off: &FigureOff,
) -> (Vec<Attributed>, Vec<Vec<(u32, u32)>>) {
    if !off.has_outline {
        return (theirs.collect(), Vec::new());
    }
    let least = LEAST * (off.theirs.len() + off.right.len()) as f64;
    let mut groups = clusters(theirs, |it| it.pixel, CLUSTER * off.apart.max(1));
    // Small groups first: they fill up what a shape can account for, and larger ones are left.
    groups.sort_by_key(Vec::len);
    let mut counts = vec![0; sizes.len()];
    let (mut of_parts, mut absent) = (Vec::new(), Vec::new());
    for group in groups {
        let is_of_none = |part: usize| {
            let size = sizes[part];
            size.is_some_and(|size| (counts[part] + group.len()) as f64 > LARGER * size as f64)
        };
        let of_none = group.iter().filter(|it| it.part.is_none_or(is_of_none));
        if 2 * of_none.count() > group.len() && group.len() as f64 >= least {
            absent.push(group.into_iter().map(|it| it.pixel).collect());
            continue;
        }
        for part in group.iter().filter_map(|it| it.part) {
            counts[part] += 1;
        }
        of_parts.extend(group);
    }
    (of_parts, absent)
}

/// Takes from the groups of what is `absent` those that are the `shapes` of which these pixels of the live view and of the other
/// picture are off: what covers some of a shape there of which nothing else is, is that shape, together with what is before it.
pub(super) fn give_back<'a>(
    absent: &mut Vec<Vec<(u32, u32)>>,
    shapes: impl Iterator<Item = &'a mut Pixels>,
) {
    for [ours, theirs] in shapes.filter(|[_, theirs]| theirs.is_empty()) {
        let is_over = |group: &Vec<(u32, u32)>| {
            let group: HashSet<&(u32, u32)> = group.iter().collect();
            let both = ours.iter().filter(|pixel| group.contains(pixel));
            both.count() as f64 >= EMPTY * ours.len().max(1) as f64
        };
        if let Some(group) = absent.iter().position(is_over) {
            *theirs = absent.remove(group);
        }
    }
}

/// The hidden shape whose box in a view of `size` pixels is about `area`.
pub(super) fn hidden_at(session: &Session, area: Area, size: Vec2) -> Option<&str> {
    let camera = &session.view().camera;
    let shapes = session.scene().shapes().iter();
    let overlaps = shapes.filter(|shape| !shape.visible).filter_map(|shape| {
        let [least, most] = box_of(session.evaluated().shape(shape.id)?, camera, size)?;
        let (least, most) = (least.max(Vec2::ZERO), most.min(size));
        let [from, to] = area.corners();
        let both = (most.min(to) - least.max(from)).max(Vec2::ZERO);
        let both = both.element_product();
        let either = (to - from).element_product() + (most - least).element_product() - both;
        Some((both / either.max(1.0), &*shape.name))
    });
    let best = overlaps.max_by(|(a, _), (b, _)| a.total_cmp(b));
    best.filter(|(overlap, _)| *overlap >= OVERLAP)
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pixels of a square with this corner, of so many pixels along, all of which may be of `part`.
    fn square(corner: (u32, u32), side: u32, part: Option<usize>) -> Vec<Attributed> {
        let along = (0..side).step_by(3);
        let pixels = along
            .clone()
            .flat_map(|y| along.clone().map(move |x| (x, y)));
        let pixels = pixels.map(|(x, y)| Attributed {
            pixel: (corner.0 + x, corner.1 + y),
            part,
        });
        pixels.collect()
    }

    #[test]
    fn what_is_much_larger_than_a_shape_or_of_none_is_absent() {
        let moved = square((0, 0), 60, Some(0));
        let larger = square((300, 0), 120, Some(0));
        let of_none = square((600, 0), 60, None);
        let of_limb = square((900, 0), 120, Some(1));
        let theirs = [moved, larger, of_none, of_limb].concat();
        let off = FigureOff {
            area: "0,0,1020,120".parse().unwrap(),
            ours: Vec::new(),
            theirs: theirs.iter().map(|it| it.pixel.into()).collect(),
            thin: None,
            right: Vec::new(),
            outlines: [const { Vec::new() }; 2],
            apart: 3,
            has_outline: true,
            is_camera_right: false,
        };
        let sizes = [Some(400), None];
        let found = |off: &FigureOff| without_absent(theirs.iter().copied(), &sizes, off);
        let (of_parts, absent) = found(&off);
        let begins: Vec<_> = absent.iter().map(|group| group[0]).collect();
        assert_eq!(begins, [(600, 0), (300, 0)]);
        assert_eq!(of_parts.len(), 400 + 1600);
        // Where it is not known what is behind shapes, nothing is.
        let has_outline = false;
        let (of_parts, absent) = found(&FigureOff { has_outline, ..off });
        assert_eq!((of_parts.len(), absent.len()), (theirs.len(), 0));
    }
}
