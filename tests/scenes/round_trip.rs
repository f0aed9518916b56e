//! What is saved comes back as it was: for every document, and byte for byte.

use super::documents::{imported, scene, view};
use super::support::{FOLDER, SCENE, Table, assert_same, files, read, saved_and_read};
use editor_core::io::{Missing, scene_text};
use editor_core::scene::{Scene, ViewSettings};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::path::{Path, PathBuf};

fn text(scene: &Scene, view: &ViewSettings) -> String {
    scene_text(scene, view, Some(Path::new(FOLDER))).unwrap()
}

/// Calls `holds` with the files, and documents made of them at random.
fn for_documents(cases: u32, holds: impl Fn(&Table, Scene, ViewSettings)) {
    let files = files();
    let documents = (scene(imported(&files)), view());
    let mut runner = TestRunner::new(ProptestConfig {
        cases,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let result = runner.run(&documents, |(scene, view)| {
        holds(&files, scene, view);
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_document_that_was_saved_is_read_as_it_was_and_saved_again_byte_for_byte() {
    for_documents(400, |files, scene, view| {
        let (read, read_view, saved) = saved_and_read(&mut files.clone(), &scene, &view);
        assert_same(&read, &scene, &saved);
        assert_eq!(read_view, view);
        assert_eq!(text(&read, &read_view), saved);
    });
}

#[test]
fn a_document_whose_files_are_all_gone_is_saved_as_it_was_and_is_whole_when_they_are_back() {
    for_documents(100, |files, scene, view| {
        let saved = text(&scene, &view);
        let mut alone = files.clone();
        alone.0.clear();
        alone.0.insert(PathBuf::from(SCENE), saved.clone().into());
        let (without, without_view, _) = read(&alone, SCENE, Missing::StandIn).unwrap();
        let again = text(&without, &without_view);
        assert_eq!(again, saved);

        let mut back = files.clone();
        back.0.insert(PathBuf::from(SCENE), again.into());
        let (whole, ..) = read(&back, SCENE, Missing::Refuse).unwrap();
        assert_same(&whole, &scene, &saved);
    });
}
