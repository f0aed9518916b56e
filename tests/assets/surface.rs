//! Faces and what can be said of them.
use glam::DVec3;
use std::collections::HashMap;

/// The positions and faces of an `.obj`.
pub struct Surface {
    pub positions: Vec<DVec3>,
    pub faces: Vec<Vec<usize>>,
}

impl Surface {
    pub fn read(text: &str) -> Self {
        let mut surface = Self {
            positions: Vec::new(),
            faces: Vec::new(),
        };
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["v", x, y, z] => surface
                    .positions
                    .push(DVec3::new(float(x), float(y), float(z))),
                ["f", corners @ ..] => surface
                    .faces
                    .push(corners.iter().map(|c| index(c)).collect()),
                _ => {}
            }
        }
        surface
    }

    /// Edges, undirected, with the number of faces on them.
    pub fn edges(&self) -> HashMap<(usize, usize), usize> {
        let mut edges = HashMap::new();
        for (a, b) in self.directed_edges() {
            *edges.entry((a.min(b), a.max(b))).or_insert(0) += 1;
        }
        edges
    }

    /// Every face's edges in the order of its corners.
    pub fn directed_edges(&self) -> impl Iterator<Item = (usize, usize)> {
        self.faces
            .iter()
            .flat_map(|face| (0..face.len()).map(move |i| (face[i], face[(i + 1) % face.len()])))
    }

    pub fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.faces
            .iter()
            .flat_map(|face| (1..face.len() - 1).map(move |i| [face[0], face[i], face[i + 1]]))
    }

    /// Twice the area of a triangle, along its normal.
    pub fn cross(&self, [a, b, c]: [usize; 3]) -> DVec3 {
        let p = |i: usize| self.positions[i];
        (p(b) - p(a)).cross(p(c) - p(a))
    }

    pub fn volume(&self) -> f64 {
        let origin_to = |[a, b, c]: [usize; 3]| {
            self.positions[a].dot(self.positions[b].cross(self.positions[c])) / 6.0
        };
        self.triangles().map(origin_to).sum()
    }

    /// For each vertex the smallest vertex that it hangs together with.
    pub fn parts(&self) -> Vec<usize> {
        let mut part: Vec<usize> = (0..self.positions.len()).collect();
        loop {
            let mut changed = false;
            for (a, b) in self.directed_edges() {
                let least = part[a].min(part[b]);
                changed |= part[a] != least || part[b] != least;
                (part[a], part[b]) = (least, least);
            }
            if !changed {
                return part;
            }
        }
    }

    /// Fails unless every edge has two faces that run along it in opposite directions.
    pub fn assert_closed(&self, name: &str) {
        let open = self.edges().values().filter(|&&n| n != 2).count();
        assert_eq!(open, 0, "{name}: edges without exactly two faces");
        let mut once = HashMap::new();
        self.directed_edges()
            .for_each(|e| *once.entry(e).or_insert(0) += 1);
        assert!(
            once.values().all(|&n| n == 1),
            "{name}: faces that do not agree on their side"
        );
    }
}

pub fn float(word: &str) -> f64 {
    word.parse().unwrap_or(f64::NAN)
}

fn index(corner: &str) -> usize {
    let position = corner.split('/').next().unwrap_or_default();
    position
        .parse::<usize>()
        .map_or(usize::MAX, |i| i.wrapping_sub(1))
}
