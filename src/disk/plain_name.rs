//! Names of files that every system takes.

/// `name` as a part of a file's name on every system: letters, digits, and `-` for all else.
pub fn plain_name(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_becomes_a_part_of_a_files_name() {
        assert_eq!(plain_name("Ada  Lovelace"), "Ada-Lovelace");
        assert_eq!(plain_name("../Jörg O'Neill/"), "Jörg-O-Neill");
    }
}
