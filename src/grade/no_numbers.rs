//! Vertices that a program has written as what is no number.

/// A mesh in text, in which vertices are no numbers.
#[derive(Debug, PartialEq)]
pub(super) struct NoNumbers {
    /// The same with numbers in their place that lie outside of the mesh: these vertices are right by no chance, and all
    /// others can be looked at.
    pub without: Vec<u8>,
    /// How many vertices, and the line of the first, from 1.
    vertices: usize,
    first: usize,
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
        let (mut without, mut vertices) = (String::with_capacity(text.len()), 0);
        for line in text.split_inclusive('\n') {
            match words_of_vertex(line).filter(|_| has_none(line)) {
                Some(words) => {
                    let numbers = words.map(|word| if is_none(word) { &*outside } else { word });
                    without += &format!("v {}\n", numbers.collect::<Vec<_>>().join(" "));
                    vertices += 1;
                }
                None => without += line,
            }
        }
        Some(Self {
            without: without.into_bytes(),
            vertices,
            first,
        })
    }

    /// In words, of a file called `name`.
    pub fn told(&self, name: &str) -> String {
        let what = match self.vertices {
            1 => "1 vertex is no number (nan or infinite)".to_owned(),
            all => format!("{all} vertices are no numbers (nan or infinite)"),
        };
        let first = self.first;
        format!(
            "{name}:{first}: {what}, which counts as wrong: a division by zero, or a root of what is negative?"
        )
    }
}

/// What follows `v` in a line of a vertex; `None` of another line.
fn words_of_vertex(line: &str) -> Option<impl Iterator<Item = &str>> {
    let mut words = line.split_whitespace();
    (words.next() == Some("v")).then_some(words)
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
        assert!(
            found
                .told("a.obj")
                .starts_with("a.obj:3: 2 vertices are no numbers")
        );
        assert_eq!(NoNumbers::find(b"v 1 2 3\nf 1 2 3\n"), None);
    }
}
