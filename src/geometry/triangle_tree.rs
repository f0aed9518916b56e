//! A hierarchy of boxes over the triangles of a mesh, for rays.
//!
//! Triangles are sorted along a space-filling curve (Morton, "A computer oriented geodetic data base",
//! 1966), and every eight neighbors share a box, every eight boxes a larger one, and so on. The order is
//! that of the mesh at rest and stays; where joints move the mesh only the boxes are made anew, in one
//! pass. Nothing but boxes is kept: neither pointers nor counts. Crates for such hierarchies build better
//! ones, in several times the time, and copy them to refit them.

use crate::math::{Aabb, Ray, TriangleHit};
use glam::Vec3;

/// Triangles of a box at the bottom, and boxes of a larger one.
const FANOUT: usize = 8;
/// Bits of each coordinate along the curve.
const BITS: u32 = 10;
/// Share of its size by which a box is larger than its triangles: a ray may meet one by rounding where
/// it just misses the box.
const PADDING: f32 = 1e-3;
/// The same of the distance at which a ray enters a box.
const ROUNDING: f32 = 1e-5;

/// Indices of triangles in an order in which neighbors are near each other.
#[derive(Clone, Debug)]
pub struct TriangleOrder(Vec<u32>);

/// Boxes over triangles in a [`TriangleOrder`], in the space of their positions.
#[derive(Clone, Debug)]
pub struct TriangleBoxes {
    /// Boxes over triangles, then boxes over those, up to a single one.
    levels: Vec<Vec<Aabb>>,
}

impl TriangleOrder {
    /// Order of `triangles`, which are indices into `positions`.
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let bounds = Aabb::from_points(positions.iter().copied());
        let per_cell = (bounds.max - bounds.min) / ((1 << BITS) - 1) as f32;
        let cell_of = |corners: &[u32; 3]| {
            let sum: Vec3 = corners.iter().map(|&i| positions[i as usize]).sum();
            // NaN, where a box is flat, becomes 0.
            ((sum / 3.0 - bounds.min) / per_cell).as_uvec3()
        };
        let mut order: Vec<(u32, u32)> = triangles
            .iter()
            .map(|corners| morton(cell_of(corners).to_array()))
            .zip(0..)
            .collect();
        order.sort_unstable();
        Self(order.into_iter().map(|(_, index)| index).collect())
    }

    /// Boxes over the triangles where their corners are now.
    pub fn boxes(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> TriangleBoxes {
        let around = |indices: &[u32]| {
            let corners = indices.iter().flat_map(|&index| triangles[index as usize]);
            padded(Aabb::from_points(
                corners.map(|corner| positions[corner as usize]),
            ))
        };
        let mut levels: Vec<Vec<Aabb>> = vec![self.0.chunks(FANOUT).map(around).collect()];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            let all = |boxes: &[Aabb]| boxes.iter().fold(Aabb::EMPTY, |all, one| all.union(*one));
            let level = below.chunks(FANOUT).map(all).collect();
            levels.push(level);
        }
        TriangleBoxes { levels }
    }

    /// Nearest intersection of `ray` with the triangles, with the index of the triangle: the first, if
    /// several are as near. `boxes` are those of `positions`, and all are in one space.
    pub fn nearest(
        &self,
        boxes: &TriangleBoxes,
        ray: &Ray,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
    ) -> Option<(usize, TriangleHit)> {
        let mut nearest: Option<(usize, TriangleHit)> = None;
        let mut waiting: Vec<Entered> = Vec::new();
        let top = boxes.levels.len() - 1;
        boxes.enter(ray, top, 0..boxes.levels[top].len(), &mut waiting);
        while let Some(entered) = waiting.pop() {
            let is_behind = |(_, hit): (_, TriangleHit)| entered.distance > hit.distance;
            if nearest.is_some_and(is_behind) {
                continue;
            }
            let first = entered.index * FANOUT;
            if entered.level > 0 {
                let below = entered.level - 1;
                let end = boxes.levels[below].len().min(first + FANOUT);
                boxes.enter(ray, below, first..end, &mut waiting);
                continue;
            }
            for &index in &self.0[first..self.0.len().min(first + FANOUT)] {
                let corners = triangles[index as usize].map(|corner| positions[corner as usize]);
                let found = ray.triangle(corners).map(|hit| (index as usize, hit));
                nearest = [nearest, found].into_iter().flatten().min_by(|a, b| {
                    let by_distance = a.1.distance.total_cmp(&b.1.distance);
                    by_distance.then(a.0.cmp(&b.0))
                });
            }
        }
        nearest
    }
}

/// A box that a ray enters.
#[derive(Clone, Copy)]
struct Entered {
    level: usize,
    index: usize,
    /// Along the ray, rounded down.
    distance: f32,
}

impl TriangleBoxes {
    /// Adds the boxes of a level that `ray` enters to those that wait, so that the nearest comes first.
    fn enter(
        &self,
        ray: &Ray,
        level: usize,
        boxes: std::ops::Range<usize>,
        waiting: &mut Vec<Entered>,
    ) {
        let begin = waiting.len();
        let entered = boxes.filter_map(|index| {
            let distance = ray.entry(&self.levels[level][index])? * (1.0 - ROUNDING);
            Some(Entered {
                level,
                index,
                distance,
            })
        });
        waiting.extend(entered);
        waiting[begin..].sort_unstable_by(|a, b| b.distance.total_cmp(&a.distance));
    }
}

fn padded(aabb: Aabb) -> Aabb {
    if aabb.is_empty() {
        return aabb;
    }
    let size = (aabb.max - aabb.min).max_element();
    let farthest = aabb.min.abs().max(aabb.max.abs()).max_element();
    let padding = Vec3::splat(PADDING * size + ROUNDING * farthest);
    Aabb {
        min: aabb.min - padding,
        max: aabb.max + padding,
    }
}

/// Place of a cell along the curve: the bits of its coordinates in turn.
fn morton(cell: [u32; 3]) -> u32 {
    let [x, y, z] = cell.map(|coordinate| spread(coordinate.min((1 << BITS) - 1)));
    x | y << 1 | z << 2
}

/// The lowest ten bits, each followed by two zeros.
fn spread(bits: u32) -> u32 {
    let bits = (bits | bits << 16) & 0x0300_00ff;
    let bits = (bits | bits << 8) & 0x0300_f00f;
    let bits = (bits | bits << 4) & 0x030c_30c3;
    (bits | bits << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// What the hierarchy stands for: every triangle is tried.
    fn nearest_of_all(
        ray: &Ray,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
    ) -> Option<(usize, TriangleHit)> {
        let hits = triangles.iter().enumerate().filter_map(|(index, corners)| {
            let hit = ray.triangle(corners.map(|corner| positions[corner as usize]))?;
            Some((index, hit))
        });
        hits.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))
    }

    fn vector(within: f32) -> impl Strategy<Value = Vec3> {
        [-within..within, -within..within, -within..within].prop_map(Vec3::from)
    }

    #[test]
    fn bits_of_coordinates_take_turns() {
        assert_eq!(morton([1, 0, 0]), 0b001);
        assert_eq!(morton([0, 1, 3]), 0b100_110);
        assert_eq!(morton([1023; 3]), (1 << 30) - 1);
        assert_eq!(morton([u32::MAX; 3]), (1 << 30) - 1);
    }

    #[test]
    fn a_mesh_without_triangles_is_never_met() {
        let order = TriangleOrder::new(&[Vec3::X], &[]);
        let boxes = order.boxes(&[Vec3::X], &[]);
        let ray = Ray {
            origin: Vec3::ZERO,
            direction: Vec3::X,
        };
        assert!(order.nearest(&boxes, &ray, &[Vec3::X], &[]).is_none());
    }

    proptest! {
        #[test]
        fn the_nearest_triangle_is_that_of_all_of_them_also_after_they_have_moved(
            positions in prop::collection::vec(vector(3.0), 3..60),
            picked in prop::collection::vec(any::<[prop::sample::Index; 3]>(), 1..400),
            moved in prop::collection::vec(vector(1.0), 60),
            rays in prop::collection::vec((vector(8.0), vector(1.0)), 20),
            grid in any::<bool>(),
        ) {
            // On a grid, triangles share planes with their boxes and with each other.
            let place = |point: Vec3| if grid { point.round() } else { point };
            let positions: Vec<Vec3> = positions.into_iter().map(place).collect();
            let corner = |index: prop::sample::Index| index.index(positions.len()) as u32;
            let triangles: Vec<_> = picked.into_iter().map(|t| t.map(corner)).collect();
            let order = TriangleOrder::new(&positions, &triangles);
            let later = positions.iter().zip(moved).map(|(at, by)| place(at + by)).collect();
            for positions in [positions.clone(), later] {
                let boxes = order.boxes(&positions, &triangles);
                for &(origin, direction) in &rays {
                    let ray = Ray { origin: place(origin), direction: place(direction * 3.0) };
                    prop_assert_eq!(
                        order.nearest(&boxes, &ray, &positions, &triangles),
                        nearest_of_all(&ray, &positions, &triangles)
                    );
                }
            }
        }
    }
}
