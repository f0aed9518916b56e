//! What the page's address asks for: files of its site with all that these name, and a scene in a link.

use super::browser;
use super::fetching::fetch_from_site;
use super::given_files::{GivenFiles, main_files};
use crate::io::builtin::is_builtin;
use crate::io::{missed_files, scene_link};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use wasm_bindgen::JsValue;

/// Name of the file that a scene in a link becomes.
const LINKED: &str = "shared.scene";

/// What is before a scene in the fragment of the page's address.
const SCENE: &str = "scene=";

/// Most files that are fetched because others name them, and most times that files name others: a
/// scene names models, and these materials, which name pictures.
const MOST_FILES: usize = 200;
const MOST_ROUNDS: usize = 8;

/// What the page's address asks for.
#[derive(Default)]
pub(super) struct Asked {
    /// Files to open.
    pub files: Vec<PathBuf>,
    /// Why others could not be had.
    pub refused: Vec<String>,
}

impl Asked {
    /// Fetches the files that the page's address names, as in `?open=man.obj,man.skel,man.attach`, and what
    /// they name, and adds them to `given`.
    pub async fn for_page(given: &GivenFiles) -> Self {
        let mut asked = Self::default();
        let names = browser::in_address("open").unwrap_or_default();
        let mut fetched = Vec::new();
        for name in names.split(',').filter(|name| !name.is_empty()) {
            if is_builtin(Path::new(name)) {
                asked.files.push(PathBuf::from(name));
                continue;
            }
            match browser::fetch_of_site(name).await {
                Ok(bytes) => fetched.push((PathBuf::from(name), bytes)),
                Err(error) => asked.refused.push(format!("{name}: {error}")),
            }
        }
        if !fetched.is_empty() {
            let names: Vec<PathBuf> = fetched.iter().map(|(path, _)| path.clone()).collect();
            let opened = main_files(&names);
            let (fetched, absent) = with_named(fetched, &opened).await;
            let folder = given.place(fetched).await;
            given.note_absent(absent.iter().map(|path| folder.join(path)));
            let opened = opened.into_iter().map(|path| folder.join(path));
            asked.files.extend(opened);
        }
        match linked_scene() {
            Some(Ok(text)) => {
                given.add(vec![(PathBuf::from(LINKED), text.into_bytes())]);
                asked.files.push(PathBuf::from(LINKED));
            }
            Some(Err(error)) => {
                let text = format!("The link cannot be opened: {error}");
                asked.refused.push(text);
            }
            None => {}
        }
        asked
    }

    /// Whether it asks for anything.
    pub fn is_any(&self) -> bool {
        !self.files.is_empty() || !self.refused.is_empty()
    }
}

/// `files` with those of the page's site that are read with them when `opened` are opened, and the paths of those
/// that are not there, which is told when they are read.
async fn with_named(
    files: Vec<(PathBuf, Vec<u8>)>,
    opened: &[PathBuf],
) -> (Vec<(PathBuf, Vec<u8>)>, HashSet<PathBuf>) {
    let mut files: HashMap<PathBuf, Vec<u8>> = files.into_iter().collect();
    let mut looked_for = HashSet::new();
    for _ in 0..MOST_ROUNDS {
        let mut missed = missed_files(&files, opened);
        missed.retain(|path| looked_for.len() < MOST_FILES && looked_for.insert(path.clone()));
        let fetched = fetch_from_site(missed).await;
        if fetched.is_empty() {
            break;
        }
        files.extend(fetched);
    }
    looked_for.retain(|path| !files.contains_key(path));
    (files.into_iter().collect(), looked_for)
}

/// The text of the scene in the page's address, as in `#scene=…`, if there is one.
fn linked_scene() -> Option<Result<String, String>> {
    let fragment = browser::fragment();
    Some(scene_link::from_link(fragment.strip_prefix(SCENE)?))
}

/// Takes the scene of a link out of the page's address: another document is open by now, which a reload must not put
/// that scene in the place of.
pub(super) fn leave_link() {
    if browser::fragment().starts_with(SCENE) {
        browser::clear_fragment();
    }
}

/// Opens the scenes of links that are followed to the page while it is open.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn follow_links() -> Result<(), JsValue> {
    let window = browser::window().ok_or("There is no page.")?;
    browser::listen(&window, "hashchange", |_| {
        if browser::fragment().starts_with(SCENE) {
            browser::reload();
        }
    })
}
