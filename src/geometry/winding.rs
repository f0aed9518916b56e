//! Which way round triangles go, held against their neighbors.

use std::collections::HashMap;

/// Number of triangles that go the other way round than most of those that they hang together with, over edges that
/// two triangles share. Neighbors go the same way round if they pass the edge between them in opposite directions.
/// Edges of one triangle, or of more than two, say nothing, nor does a surface with only one side.
pub fn opposed_triangles(triangles: &[[u32; 3]]) -> usize {
    let mut parts = Parts::new(triangles.len());
    let mut with_one_side = Vec::new();
    for edge in edges(triangles).into_values() {
        if let Edge::Two([a, b]) = edge
            && !parts.join(a.triangle, b.triangle, a.is_upwards == b.is_upwards)
        {
            with_one_side.push(a.triangle);
        }
    }
    let mut counts: HashMap<usize, [usize; 2]> = HashMap::new();
    for triangle in 0..triangles.len() {
        let (part, is_opposed) = parts.of(triangle);
        counts.entry(part).or_default()[usize::from(is_opposed)] += 1;
    }
    for triangle in with_one_side {
        counts.remove(&parts.of(triangle).0);
    }
    counts.into_values().map(|[a, b]| a.min(b)).sum()
}

/// A triangle at an edge.
#[derive(Clone, Copy)]
struct Side {
    triangle: usize,
    /// Whether it passes the edge from the lower to the higher index.
    is_upwards: bool,
}

enum Edge {
    One(Side),
    Two([Side; 2]),
    More,
}

fn edges(triangles: &[[u32; 3]]) -> HashMap<[u32; 2], Edge> {
    let mut edges = HashMap::new();
    for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let side = Side {
                triangle,
                is_upwards: from < to,
            };
            edges
                .entry([from.min(to), from.max(to)])
                .and_modify(|edge| {
                    *edge = match edge {
                        Edge::One(other) => Edge::Two([*other, side]),
                        Edge::Two(_) | Edge::More => Edge::More,
                    }
                })
                .or_insert(Edge::One(side));
        }
    }
    edges
}

/// Triangles that hang together, each going the same way round as the first of its part or the other way.
struct Parts {
    /// A triangle nearer to the first one, and whether this one goes the other way round than that.
    towards: Vec<(usize, bool)>,
}

impl Parts {
    fn new(triangles: usize) -> Self {
        Self {
            towards: (0..triangles).map(|triangle| (triangle, false)).collect(),
        }
    }

    /// The first triangle of the part, and whether `triangle` goes the other way round.
    fn of(&mut self, triangle: usize) -> (usize, bool) {
        let (mut at, mut is_opposed) = (triangle, false);
        while self.towards[at].0 != at {
            let (next, turns) = self.towards[at];
            // Half of the way is cut off, so that ways stay short.
            let (after, turns_after) = self.towards[next];
            self.towards[at] = (after, turns != turns_after);
            (at, is_opposed) = (after, is_opposed != (turns != turns_after));
        }
        (at, is_opposed)
    }

    /// Joins the parts of two triangles; whether that agrees with what was joined before.
    fn join(&mut self, a: usize, b: usize, are_opposed: bool) -> bool {
        let ((a, turns_a), (b, turns_b)) = (self.of(a), self.of(b));
        if a == b {
            return are_opposed == (turns_a != turns_b);
        }
        self.towards[b] = (a, are_opposed != (turns_a != turns_b));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{icosahedron, teapot};

    #[test]
    fn turned_triangles_are_counted_wherever_they_are_and_however_many_parts_there_are() {
        let whole = icosahedron().triangles;
        assert_eq!(opposed_triangles(&whole), 0);
        let turned = |count: usize| {
            let mut triangles = whole.clone();
            triangles[3..3 + count]
                .iter_mut()
                .for_each(|triangle| triangle.reverse());
            triangles
        };
        assert_eq!(opposed_triangles(&turned(1)), 1);
        assert_eq!(opposed_triangles(&turned(7)), 7);
        // All of a part together go one way round, whichever that is.
        assert_eq!(opposed_triangles(&turned(17)), 3);
        let apart = turned(2).into_iter().map(|t| t.map(|corner| corner + 100));
        let both: Vec<_> = turned(4).into_iter().chain(apart).collect();
        assert_eq!(opposed_triangles(&both), 6);
    }

    #[test]
    fn an_open_surface_and_one_with_a_single_side_oppose_nothing_that_they_need_not() {
        assert_eq!(opposed_triangles(&teapot().triangles), 0);
        assert_eq!(opposed_triangles(&[[0, 1, 2], [2, 1, 0], [0, 1, 3]]), 0);
        assert_eq!(opposed_triangles(&[]), 0);
        // A band with half a twist.
        let band = [
            [0, 1, 2],
            [2, 1, 3],
            [2, 3, 4],
            [4, 3, 5],
            [4, 5, 1],
            [1, 5, 0],
        ];
        assert_eq!(opposed_triangles(&band), 0);
    }
}
