//! What is saved comes back as it was: for every document, and byte for byte.

use super::documents::{imported, scene, view};
use super::support::{FOLDER, assert_same, files, saved_and_read};
use editor_core::io::scene_text;
use proptest::prelude::*;
use std::path::Path;

#[test]
fn a_document_that_was_saved_is_read_as_it_was_and_saved_again_byte_for_byte() {
    let files = files();
    let imported = imported(&files);
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 400,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let documents = (scene(imported), view());
    let result = runner.run(&documents, |(scene, view)| {
        let (read, read_view, text) = saved_and_read(&mut files.clone(), &scene, &view);
        assert_same(&read, &scene, &text);
        prop_assert_eq!(read_view, view);
        let again = scene_text(&read, &read_view, Some(Path::new(FOLDER))).unwrap();
        prop_assert_eq!(again, text);
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
}
