//! Triangles by the indices of their corners, whichever comes first, and the polygons that are cut into them.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::hash::Hash;

/// Indices of corners, the smallest first: neither where a triangle begins nor how it winds counts.
pub(super) type Triangle = [u32; 3];
/// Indices of ends, the smaller first.
type Edge = [u32; 2];

/// Corners of a triangle, the smallest index first, and whether an even number of swaps brings them into that order.
pub(super) type Wound = (Triangle, bool);

/// Triangles without a corner twice, in a form that is the same wherever they begin.
pub(super) fn wound(triangles: &[Triangle]) -> impl Iterator<Item = Wound> + '_ {
    let real = triangles
        .iter()
        .filter(|[a, b, c]| a != b && b != c && c != a);
    real.map(|&(mut corners)| {
        let [a, b, c] = corners;
        let swaps = [a > b, a > c, b > c]
            .into_iter()
            .filter(|&swap| swap)
            .count();
        corners.sort_unstable();
        (corners, swaps % 2 == 0)
    })
}

/// The same however they wind.
pub(super) fn sorted(triangles: &[Triangle]) -> impl Iterator<Item = Triangle> + '_ {
    wound(triangles).map(|(corners, _)| corners)
}

fn edges([a, b, c]: Triangle) -> [Edge; 3] {
    [[a, b], [b, c], [a, c]]
}

/// Takes one of those that are counted by what they are; whether there was one left.
pub(super) fn take<K: Hash + Eq>(left: &mut HashMap<K, usize>, what: &K) -> bool {
    match left.get_mut(what) {
        Some(count) if *count > 0 => {
            *count -= 1;
            true
        }
        _ => false,
    }
}

/// How many triangles, of those that only one mesh has, make polygons that both meshes have. Each mesh
/// comes with these triangles first, and then with all of them.
pub(super) fn cut_otherwise(
    (missing, model): (&[Triangle], &[Triangle]),
    (other, theirs): (&[Triangle], &[Triangle]),
) -> usize {
    if outline(missing).is_some_and(|all| outline(other) == Some(all)) {
        return missing.len();
    }
    let mut left: HashMap<Outline, usize> = HashMap::new();
    for outline in patches(missing, theirs).iter().filter_map(|it| outline(it)) {
        *left.entry(outline).or_default() += 1;
    }
    let others = patches(other, model);
    let others = others.iter().filter_map(|it| outline(it));
    let same = others.filter(|outline| take(&mut left, outline));
    same.map(|outline| outline.triangles).sum()
}

/// What is the same for a polygon along whatever diagonals it is cut.
#[derive(PartialEq, Eq, Hash)]
struct Outline {
    /// Edges of a single triangle.
    edges: BTreeSet<Edge>,
    corners: BTreeSet<u32>,
    triangles: usize,
}

/// The outline of triangles; `None` for those that are closed.
fn outline(triangles: &[Triangle]) -> Option<Outline> {
    let mut open: BTreeSet<Edge> = BTreeSet::new();
    for edge in triangles.iter().copied().flat_map(edges) {
        if !open.remove(&edge) {
            open.insert(edge);
        }
    }
    (!open.is_empty()).then_some(Outline {
        edges: open,
        corners: triangles.iter().flatten().copied().collect(),
        triangles: triangles.len(),
    })
}

/// Parts of `triangles` that hang together by edges that another mesh with the triangles `beside` does
/// not have, as those of a polygon do that is cut otherwise there.
fn patches(triangles: &[Triangle], beside: &[Triangle]) -> Vec<Vec<Triangle>> {
    let known: HashSet<Edge> = sorted(beside).flat_map(edges).collect();
    let mut at_edge: HashMap<Edge, Vec<usize>> = HashMap::new();
    for (index, &triangle) in triangles.iter().enumerate() {
        for edge in edges(triangle)
            .into_iter()
            .filter(|edge| !known.contains(edge))
        {
            at_edge.entry(edge).or_default().push(index);
        }
    }
    let mut is_seen = vec![false; triangles.len()];
    let mut patches = Vec::new();
    for start in 0..triangles.len() {
        let (mut open, mut patch) = (vec![start], Vec::new());
        while let Some(index) = open.pop() {
            if std::mem::replace(&mut is_seen[index], true) {
                continue;
            }
            patch.push(triangles[index]);
            // All at an edge are found with the first one, however many there are.
            let beside = edges(triangles[index]).map(|edge| at_edge.remove(&edge));
            open.extend(beside.into_iter().flatten().flatten());
        }
        if !patch.is_empty() {
            patches.push(patch);
        }
    }
    patches
}
