//! Where the pages about single submissions are.

use crate::disk::plain_name;
use std::collections::BTreeSet;

/// Folder of these pages in that of the report.
const PAGES: &str = "pages";

/// Paths of the pages about the submissions of these names from the folder of the report, no two alike, each with as much of the name
/// as a file's can have. Names that need no change have the first choice, so that no other one has the page of theirs.
pub(super) fn page_paths(names: &[&str]) -> Vec<String> {
    let names: Vec<(&str, String)> = names.iter().map(|name| (*name, plain_name(name))).collect();
    let mut paths = vec![String::new(); names.len()];
    let mut taken = BTreeSet::new();
    for is_unchanged in [true, false] {
        for ((name, plain), path) in names.iter().zip(&mut paths) {
            if (*name == plain) == is_unchanged {
                *path = format!("{PAGES}/{}.html", free_stem(plain, &mut taken));
            }
        }
    }
    paths
}

/// `plain`, with a number if it is empty or one of those `taken`, to which it is added.
fn free_stem(plain: &str, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2..).map(|number| format!("{plain}-{number}"));
    let mut stems = std::iter::once(plain.to_owned()).chain(numbered);
    // File systems may not tell capitals from small letters.
    let free = stems.find(|stem| !stem.is_empty() && taken.insert(stem.to_lowercase()));
    free.unwrap_or_else(|| plain.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_changed_takes_no_page_of_another_one() {
        let names = ["-Fox", "Fox", "fox", "a b", "a-b", "Eriksen Ø", "??"];
        let files = ["Fox-3", "Fox", "fox-2", "a-b-2", "a-b", "Eriksen-Ø", "-2"];
        let expected = files.map(|file| format!("pages/{file}.html"));
        assert_eq!(page_paths(&names), expected);
    }
}
