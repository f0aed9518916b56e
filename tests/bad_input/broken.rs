//! Files cut off or changed at random.

use crate::bad_input::everything::{Table, good, names, open, with};
use editor_core::io::export_obj;
use proptest::prelude::*;
use std::path::Path;

/// Opens everything, and uses what comes of it; an error must say something about some file.
fn survives(files: &Table) {
    match open(files) {
        Ok((session, _)) => {
            // What lies too far out is refused.
            let exported = export_obj(session.scene(), session.evaluated());
            assert!(exported != Ok(String::new()) || session.scene().shapes().is_empty());
        }
        Err(error) => assert!(!error.message.is_empty() && !error.path.as_os_str().is_empty()),
    }
}

#[test]
fn the_good_files_are_good() {
    let (session, warnings) = open(&good()).unwrap();
    assert_eq!(session.scene().shapes().len(), 3);
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    let expected = [
        "man.attach:5:1: 1 vertex with weights that do not sum up to 1",
        "box.obj: expected a picture, found no file “box.png”",
    ];
    assert_eq!(warnings, expected);
}

#[test]
fn every_prefix_is_an_error_or_a_smaller_result() {
    for name in names() {
        let whole = good()[Path::new(name)].clone();
        for length in 0..whole.len() {
            survives(&with(name, &whole[..length]));
        }
    }
}

#[test]
fn what_is_no_text_is_told_with_its_place() {
    for name in names() {
        let mut bytes = good()[Path::new(name)].clone();
        bytes.truncate(3);
        bytes.extend(b"\xFF\xFE\0");
        let result = open(&with(name, bytes));
        let told = match result {
            Err(error) => error.to_string(),
            // A material library that cannot be read is left out.
            Ok((_, warnings)) => warnings[1].to_string(),
        };
        let message = format!("{name}:1:4: expected text in UTF-8, found the byte 0xff");
        assert!(told.ends_with(&message), "{told}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn changed_bytes_stop_nothing(
        file in 0..names().count(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let name = names().nth(file).unwrap();
        let mut bytes = good()[Path::new(name)].clone();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        survives(&with(name, bytes));
    }

    #[test]
    fn words_moved_about_stop_nothing(
        file in 0..names().count(),
        picks in prop::collection::vec((any::<prop::sample::Index>(), any::<bool>()), 0..60),
    ) {
        const ODD: &[&str] = &["-1", "0", "1e39", "nan", "99999999999999999999", "f", "v", "usemtl", "/", "//", "#", "Kd"];
        let name = names().nth(file).unwrap();
        let text = String::from_utf8(good()[Path::new(name)].clone()).unwrap();
        let words: Vec<&str> = text.split(' ').chain(ODD.iter().copied()).collect();
        let moved: Vec<&str> = picks
            .iter()
            .flat_map(|(pick, newline)| [words[pick.index(words.len())], if *newline { "\n" } else { " " }])
            .collect();
        survives(&with(name, moved.concat()));
    }
}
