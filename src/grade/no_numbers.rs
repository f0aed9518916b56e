//! Vertices that a program has written as what is no number.

/// A mesh in text, in which vertices are no numbers.
#[derive(Debug, PartialEq)]
pub(super) struct NoNumbers {
    /// The same with zeros in their place, so that all others can be looked at.
    pub without: Vec<u8>,
    /// How many vertices, and the line of the first, from 1.
    vertices: usize,
    first: usize,
}

impl NoNumbers {
    /// Those of a file, if it has any.
    pub fn find(bytes: &[u8]) -> Option<Self> {
        let text = std::str::from_utf8(bytes).ok()?;
        let (mut without, mut vertices, mut first) = (String::with_capacity(text.len()), 0, 0);
        for (number, line) in (1..).zip(text.split_inclusive('\n')) {
            let mut words = line.split_whitespace();
            if words.next() == Some("v") && words.clone().any(is_none) {
                let numbers = words.map(|word| if is_none(word) { "0" } else { word });
                without += &format!("v {}\n", numbers.collect::<Vec<_>>().join(" "));
                vertices += 1;
                first = if first == 0 { number } else { first };
            } else {
                without += line;
            }
        }
        (vertices > 0).then(|| Self {
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

/// Whether a word is what programs write for what is no number, as `nan`, `-inf` or `1.#QNAN`.
fn is_none(word: &str) -> bool {
    let word = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
    word.starts_with("nan") || word.starts_with("inf") || word.contains(".#")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_counted_and_set_to_zero() {
        let text = b"# nan\nv 1 2 3\nv -nan(ind) 2 -1.#IND\nv 1 INF 3\r\nf 1 2 3\n";
        let found = NoNumbers::find(text).unwrap();
        let without = "# nan\nv 1 2 3\nv 0 2 0\nv 1 0 3\nf 1 2 3\n";
        assert_eq!(String::from_utf8_lossy(&found.without), without);
        assert!(
            found
                .told("a.obj")
                .starts_with("a.obj:3: 2 vertices are no numbers")
        );
        assert_eq!(NoNumbers::find(b"v 1 2 3\nf 1 2 3\n"), None);
    }
}
