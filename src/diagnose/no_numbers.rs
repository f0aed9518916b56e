//! Vertices that a program has written as what is no number.

use super::Diagnosis;
use glam::Vec3;
use std::collections::BTreeMap;

/// A mesh in text, in which vertices are no numbers.
#[derive(Debug, PartialEq)]
pub struct NoNumbers {
    /// The same with numbers in their place that lie outside of the mesh: these vertices are right by no chance, and all
    /// others can be looked at.
    pub without: Vec<u8>,
    /// The vertices, from 0, and what the file has for them.
    vertices: BTreeMap<usize, [f64; 3]>,
    /// The line of the first, from 1.
    first: usize,
    /// How many vertices the file has.
    all: usize,
}

impl NoNumbers {
    /// Those of a file, if it has any.
    pub fn find(bytes: &[u8]) -> Option<Self> {
        let text = std::str::from_utf8(bytes).ok()?;
        let has_none =
            |line: &str| words_of_vertex(line).is_some_and(|mut words| words.any(is_none));
        let first = text.lines().position(has_none)? + 1;
        let numbers = text.lines().filter_map(words_of_vertex).flatten();
        let sizes = numbers
            .filter_map(|word| word.parse::<f32>().ok())
            .map(f32::abs);
        let outside = 1.0 + 2.0 * sizes.filter(|size| size.is_finite()).fold(0.0, f32::max);
        let outside = outside.min(f32::MAX).to_string();
        let mut without = String::with_capacity(text.len());
        let (mut vertices, mut all) = (BTreeMap::new(), 0);
        for line in text.split_inclusive('\n') {
            let Some(words) = words_of_vertex(line) else {
                without += line;
                continue;
            };
            let words: Vec<&str> = words.collect();
            if words.iter().copied().any(is_none) {
                let number = |axis: usize| words.get(axis).map_or(f64::NAN, |word| value(word));
                vertices.insert(all, [0, 1, 2].map(number));
                let numbers = words.iter();
                let numbers = numbers.map(|word| if is_none(word) { &*outside } else { *word });
                without += &format!("v {}\n", numbers.collect::<Vec<_>>().join(" "));
            } else {
                without += line;
            }
            all += 1;
        }
        Some(Self {
            without: without.into_bytes(),
            vertices,
            first,
            all,
        })
    }

    /// Those of a file that has others, which are numbers.
    pub fn among_numbers(bytes: &[u8]) -> Option<Self> {
        Self::find(bytes).filter(|found| !found.are_all())
    }

    /// Whether no vertex of the file is a number.
    pub fn are_all(&self) -> bool {
        self.vertices.len() == self.all
    }

    /// Has the vertices of a mesh that are no numbers in the file be none, of which `places` are those of the mesh that is
    /// [`Self::without`] them.
    pub fn put_back_among(&self, places: &mut [Vec3]) {
        for &vertex in self.vertices.keys() {
            if let Some(place) = places.get_mut(vertex) {
                *place = Vec3::NAN;
            }
        }
    }

    /// A diagnosis of the mesh that is [`Self::without`] them, with what the file has in place of the numbers that stand
    /// for it.
    pub fn put_back_into(&self, found: &Diagnosis) -> Diagnosis {
        let mut found = found.clone();
        if let Some(first) = &mut found.first
            && let Some(place) = self.vertices.get(&first.vertex)
        {
            first.theirs = *place;
            first.error = f64::INFINITY;
        }
        let regions = found.regions.iter_mut();
        for region in regions.filter(|region| self.vertices.contains_key(&region.worst_vertex)) {
            region.worst = f64::INFINITY;
        }
        found.no_numbers = self.vertices.len();
        found.error = f64::INFINITY;
        found.error_from_exact = f64::INFINITY;
        found
    }

    /// How many they are, in words.
    pub fn what(&self) -> String {
        in_words(self.vertices.len())
    }

    /// In words, of a file called `name`.
    pub fn told(&self, name: &str) -> String {
        let (what, first) = (self.what(), self.first);
        format!(
            "{name}:{first}: {what}, which counts as wrong: a division by zero, or a root of what is negative?"
        )
    }
}

/// That so many vertices are none.
pub(super) fn in_words(vertices: usize) -> String {
    match vertices {
        1 => "1 vertex is no number (nan or infinite)".to_owned(),
        all => format!("{all} vertices are no numbers (nan or infinite)"),
    }
}

/// What follows `v` in a line of a vertex; `None` of another line.
fn words_of_vertex(line: &str) -> Option<impl Iterator<Item = &str>> {
    let mut words = line.split_whitespace();
    (words.next() == Some("v")).then_some(words)
}

/// The number that a word stands for, or that it is none.
fn value(word: &str) -> f64 {
    let is_infinite = word.to_ascii_lowercase().contains("inf");
    match word.parse() {
        Ok(value) => value,
        Err(_) if is_infinite && word.starts_with('-') => f64::NEG_INFINITY,
        Err(_) if is_infinite => f64::INFINITY,
        Err(_) => f64::NAN,
    }
}

/// Whether a word is what programs write for what is no number, as `nan`, `-inf` or `1.#QNAN`.
fn is_none(word: &str) -> bool {
    let word = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
    word.starts_with("nan") || word.starts_with("inf") || word.contains(".#")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_counted_and_set_outside_of_the_mesh() {
        let text = b"# nan\nv 1 2 3\nv -nan(ind) 2 -1.#IND\nv 1 INF 3\r\nf 1 2 3\n";
        let found = NoNumbers::find(text).unwrap();
        let without = "# nan\nv 1 2 3\nv 7 2 7\nv 1 7 3\nf 1 2 3\n";
        assert_eq!(String::from_utf8_lossy(&found.without), without);
        let vertices = format!("{:?}", found.vertices);
        assert_eq!(vertices, "{1: [NaN, 2.0, NaN], 2: [1.0, inf, 3.0]}");
        let none = b"v nan nan nan\nv 1 inf 2\n";
        assert!(NoNumbers::find(none).unwrap().are_all());
        assert_eq!(NoNumbers::among_numbers(none), None);
        assert!(
            found
                .told("a.obj")
                .starts_with("a.obj:3: 2 vertices are no numbers")
        );
        assert!(NoNumbers::among_numbers(text).is_some());
        assert_eq!(NoNumbers::find(b"v 1 2 3\nf 1 2 3\n"), None);
    }
}
