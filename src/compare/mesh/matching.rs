use crate::compare::Alike;
use glam::{DVec3, I64Vec3};
use std::collections::HashMap;

/// Which vertex of A each vertex of B is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Matching {
    /// The one with the same index, as far as can be told.
    InOrder,
    /// Another.
    Permuted {
        /// For each vertex of B its index in A.
        from_a: Vec<u32>,
        /// For each vertex of A the first that lies in the same place: which of those a face
        /// uses cannot be told apart.
        places: Vec<u32>,
    },
}

impl Matching {
    /// Finds for each of `b` one of `a` of its own within `tolerance`. Unless all have one, and
    /// some another than their own, the order is what it is; so it is where too many lie within
    /// the tolerance of one another for it to mean anything.
    pub(super) fn find(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Self {
        let mut grid = Grid::new(a, tolerance);
        let first = |(own, &point)| grid.nearest(point).map_or(own, |index| index as u32);
        let places = (0..).zip(a).map(first).collect();
        // Those that are where they belong keep their vertex, so that twins are not mixed up.
        let mut found: Vec<Option<u32>> = (0..b.len())
            .map(|index| {
                let own = a[index].distance(b[index]) <= tolerance;
                own.then(|| grid.take(index))?
            })
            .collect();
        for (found, &point) in found.iter_mut().zip(b) {
            if found.is_none() {
                *found = grid.nearest(point).and_then(|index| grid.take(index));
            }
        }
        let found: Option<Vec<u32>> = found.into_iter().collect();
        match found.filter(|_| !grid.is_spent()) {
            Some(from_a) if moved(&from_a) > 0 => Self::Permuted { from_a, places },
            _ => Self::InOrder,
        }
    }

    /// What stands for the vertex with this index in A when faces are compared.
    pub(super) fn place_of_a(&self, index: u32) -> u32 {
        match self {
            Self::InOrder => index,
            Self::Permuted { places, .. } => places[index as usize],
        }
    }

    /// The same for the vertex with this index in B.
    pub(super) fn place_of_b(&self, index: u32) -> u32 {
        match self {
            Self::InOrder => index,
            Self::Permuted { from_a, .. } => self.place_of_a(from_a[index as usize]),
        }
    }

    /// Number of vertices that have another index in B than in A.
    pub(super) fn moved(&self) -> u64 {
        match self {
            Self::InOrder => 0,
            Self::Permuted { from_a, .. } => moved(from_a),
        }
    }
}

fn moved(from_a: &[u32]) -> u64 {
    let order = from_a.iter().zip(0..);
    order.filter(|&(&index, own)| index != own).count() as u64
}

/// What two meshes of different numbers of vertices have in common.
pub(super) fn alike(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Alike {
    let is_same = |(a, b): (&DVec3, &DVec3)| a.distance(*b) <= tolerance;
    let has_some = !a.is_empty() && !b.is_empty();
    if has_some && a.iter().zip(b).all(is_same) {
        Alike::Beginning
    } else if same_places(a, b, tolerance) {
        Alike::Places
    } else {
        Alike::Nothing
    }
}

/// Whether every place of each mesh is one of the other, however often. Not if too many lie within
/// the tolerance of one another for it to mean anything.
fn same_places(a: &[DVec3], b: &[DVec3], tolerance: f64) -> bool {
    let holds = |grid: &mut Grid, points: &[DVec3]| {
        points.iter().all(|&point| grid.nearest(point).is_some()) && !grid.is_spent()
    };
    holds(&mut Grid::new(a, tolerance), b) && holds(&mut Grid::new(b, tolerance), a)
}

/// How many neighbors are looked at for each point, on average, before the search is given up:
/// where cells hold that many the time would grow with the square of the points.
const MOST_NEIGHBORS: usize = 256;

/// Points by the cell they lie in. Cells are as wide as twice the tolerance, so that what is
/// within the tolerance of a point lies in one of eight cells.
struct Grid<'a> {
    points: &'a [DVec3],
    tolerance: f64,
    cells: HashMap<I64Vec3, Vec<u32>>,
    /// How many neighbors may still be looked at.
    left: usize,
}

impl<'a> Grid<'a> {
    fn new(points: &'a [DVec3], tolerance: f64) -> Self {
        let mut cells: HashMap<I64Vec3, Vec<u32>> = HashMap::new();
        for (index, &point) in (0..).zip(points) {
            cells.entry(cell(point, tolerance)).or_default().push(index);
        }
        Self {
            points,
            tolerance,
            cells,
            left: points.len().saturating_mul(MOST_NEIGHBORS),
        }
    }

    /// Whether the search was given up: then nothing that it found counts.
    fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// The nearest point within the tolerance that was not taken; the first of equals.
    fn nearest(&mut self, point: DVec3) -> Option<usize> {
        let low = cell(point - self.tolerance, self.tolerance);
        let high = cell(point + self.tolerance, self.tolerance);
        let mut best: Option<(f64, u32)> = None;
        for x in low.x..=high.x {
            for y in low.y..=high.y {
                for z in low.z..=high.z {
                    let Some(members) = self.cells.get(&I64Vec3::new(x, y, z)) else {
                        continue;
                    };
                    self.left = self.left.saturating_sub(members.len());
                    if self.left == 0 {
                        return None;
                    }
                    for &index in members {
                        let distance = point.distance(self.points[index as usize]);
                        let nearer = best.is_none_or(|best| (distance, index) < best);
                        if distance <= self.tolerance && nearer {
                            best = Some((distance, index));
                        }
                    }
                }
            }
        }
        best.map(|(_, index)| index as usize)
    }

    /// Takes the point with this index out; returns it if it was still there.
    fn take(&mut self, index: usize) -> Option<u32> {
        let members = self
            .cells
            .get_mut(&cell(self.points[index], self.tolerance))?;
        self.left = self.left.saturating_sub(members.len());
        if self.left == 0 {
            return None;
        }
        let place = members
            .iter()
            .position(|&member| member as usize == index)?;
        Some(members.swap_remove(place))
    }
}

fn cell(point: DVec3, tolerance: f64) -> I64Vec3 {
    // Without a tolerance points are their own cells, as far as they are told apart.
    let width = if tolerance > 0.0 {
        2.0 * tolerance
    } else {
        1.0
    };
    (point / width).floor().as_i64vec3()
}

/// Comparison of the triangles of two meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Triangles {
    /// Number of those of B that wind the other way round in A.
    pub(super) reversed: u64,
    /// Number of those that only A has.
    pub(super) only_a: u64,
    /// Number of those that only B has.
    pub(super) only_b: u64,
    /// Number of all in B.
    pub(super) in_b: u64,
    /// Whether both have the same ones in the same order.
    pub(super) in_order: bool,
}

/// Compares triangles by their corners, whichever comes first; vertices are
/// taken for the same as `matching` says.
pub(super) fn compare_triangles(a: &[[u32; 3]], b: &[[u32; 3]], matching: &Matching) -> Triangles {
    let b: Vec<[u32; 3]> = b
        .iter()
        .map(|corners| smallest_first(corners.map(|index| matching.place_of_b(index))))
        .collect();
    let a = a
        .iter()
        .map(|corners| smallest_first(corners.map(|index| matching.place_of_a(index))));
    let in_order = a.clone().eq(b.iter().copied());
    let mut left: HashMap<[u32; 3], u64> = HashMap::new();
    for triangle in a {
        *left.entry(triangle).or_default() += 1;
    }
    let mut take = |triangle: [u32; 3]| match left.get_mut(&triangle) {
        Some(count) if *count > 0 => {
            *count -= 1;
            true
        }
        _ => false,
    };
    // All that wind alike go first, for a two-sided mesh has both.
    let others: Vec<[u32; 3]> = b
        .iter()
        .copied()
        .filter(|&corners| !take(corners))
        .collect();
    let reversed = others
        .iter()
        .filter(|&&[a, b, c]| take(smallest_first([a, c, b])))
        .count() as u64;
    Triangles {
        reversed,
        only_a: left.values().sum(),
        only_b: others.len() as u64 - reversed,
        in_b: b.len() as u64,
        in_order,
    }
}

impl Triangles {
    /// Whether both have the same, wound alike.
    pub(super) fn are_same(&self) -> bool {
        self.reversed == 0 && self.only_a == 0 && self.only_b == 0
    }
}

/// The same corners, wound alike, from the smallest index on.
fn smallest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a <= b && a <= c {
        [a, b, c]
    } else if b <= c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twins_keep_their_own_place() {
        let a = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y];
        let b = [DVec3::ZERO, DVec3::ZERO, DVec3::Y, DVec3::X];
        assert_eq!(
            Matching::find(&a, &b, 1e-6),
            Matching::Permuted {
                from_a: vec![0, 1, 3, 2],
                places: vec![0, 0, 2, 3],
            }
        );
    }

    #[test]
    fn a_vertex_without_counterpart_leaves_the_order_unknown() {
        let a = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let b = [DVec3::X, DVec3::ZERO, DVec3::Y * 2.0];
        assert_eq!(Matching::find(&a, &b, 1e-6), Matching::InOrder);
        let twice = [DVec3::X, DVec3::X, DVec3::Y];
        assert_eq!(Matching::find(&a, &twice, 1e-6), Matching::InOrder);
    }

    #[test]
    fn points_on_both_sides_of_a_cell_wall_meet() {
        let a = [DVec3::splat(2e-3 - 1e-5)];
        let b = [DVec3::splat(2e-3 + 1e-5)];
        assert!(same_places(&a, &b, 1e-3));
        assert!(!same_places(&a, &b, 3e-5));
    }

    #[test]
    fn points_closer_than_the_tolerance_leave_the_order_unknown() {
        let b: Vec<DVec3> = (0..1_000).map(|i| DVec3::X * f64::from(i) * 1e-4).collect();
        let mut a = b.clone();
        a.swap(1, 990);
        assert_eq!(Matching::find(&a, &b, 0.5), Matching::InOrder);
        assert!(!same_places(&a, &b[1..], 0.5));
        assert_ne!(Matching::find(&a, &b, 1e-5), Matching::InOrder);
    }

    #[test]
    fn a_search_is_given_up_after_256_neighbors_a_point() {
        let crowd = vec![DVec3::ZERO; 300];
        let mut grid = Grid::new(&crowd, 1.0);
        // Each search looks at all 300.
        let found = (0..1_000).filter(|_| grid.nearest(DVec3::ZERO).is_some());
        assert_eq!(found.count(), 255);
        assert!(grid.is_spent());
    }

    #[test]
    fn points_that_are_no_numbers_have_no_place() {
        let nan = [DVec3::NAN, DVec3::X];
        assert_eq!(Matching::find(&nan, &nan, 1e-6), Matching::InOrder);
        assert!(!same_places(&nan, &nan, 1e-6));
        assert!(!same_places(&[DVec3::INFINITY], &[DVec3::ZERO], 0.0));
    }
}
