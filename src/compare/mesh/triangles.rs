use super::MeshFinding;
use super::matching::Matching;
use std::collections::HashMap;

/// How the triangles of two meshes relate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Triangles {
    reversed: u64,
    only_a: u64,
    only_b: u64,
    in_b: u64,
    in_order: bool,
}

/// Compares triangles by their corners, whichever comes first; vertices are
/// taken for the same as `matching` says.
pub(super) fn compare(a: &[[u32; 3]], b: &[[u32; 3]], matching: &Matching) -> Triangles {
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

    pub(super) fn findings(&self) -> impl Iterator<Item = MeshFinding> {
        let &Self {
            reversed,
            only_a,
            only_b,
            in_b,
            in_order,
        } = self;
        let winding = (reversed > 0).then_some(MeshFinding::Winding { reversed, of: in_b });
        let others = (only_a + only_b > 0).then_some(MeshFinding::Triangles { only_a, only_b });
        let order = (self.are_same() && !in_order).then_some(MeshFinding::TriangleOrder);
        winding.into_iter().chain(others).chain(order)
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
