//! What stays on the page when the graphics come and go.

use super::given_files::{GivenFiles, main_files};
use super::page_host::PageHost;
use super::{browser, kept_files};
use crate::editor::Severity;
use crate::io::scene_link;
use crate::program::{GraphicsInfo, Host as _, Options, Program, StorageKey};
use egui::Context;
use std::cell::RefCell;
use std::path::PathBuf;
use std::rc::Rc;
use wasm_bindgen::JsValue;

/// Most bytes of files that are kept while no unsaved work needs them.
const MOST_KEPT: usize = 64 << 20;

/// Name of the file that a scene in a link becomes.
const LINKED: &str = "shared.scene";

/// What is before a scene in the fragment of the page's address.
const SCENE: &str = "scene=";

/// The program and its host, which outlive a context of WebGL that the browser takes away.
pub(super) struct Page {
    /// None before there are graphics for the first time.
    program: Option<Program>,
    host: PageHost,
    options: Options,
    /// Why files of the page's address could not be had.
    refused: Vec<String>,
}

impl Page {
    /// A page with the files that were given to it before and those that its address names.
    pub async fn of_earlier_visit() -> Rc<RefCell<Self>> {
        let mut kept = kept_files::load().await;
        let size: usize = kept.values().map(Vec::len).sum();
        let host = PageHost::new(GivenFiles::default());
        if size > MOST_KEPT && host.load(StorageKey::Autosave).is_none() {
            kept.clear();
            // What could not be forgotten is forgotten at the next visit.
            let _ = kept_files::forget().await;
        }
        let given = GivenFiles::of(kept);
        let (mut files, mut refused) = in_address(&given).await;
        match linked_scene() {
            Some(Ok(text)) => {
                given.add(vec![(PathBuf::from(LINKED), text.into_bytes())]);
                files.push(PathBuf::from(LINKED));
            }
            Some(Err(error)) => refused.push(format!("The link cannot be opened: {error}")),
            None => {}
        }
        let host = PageHost::new(given);
        let options = Options {
            files,
            ..Options::default()
        };
        host.fetch_for(&options.files_at_start(&host)).await;
        Rc::new(RefCell::new(Self {
            program: None,
            host,
            options,
            refused,
        }))
    }

    /// Goes on with new graphics in a new context of egui; the first time this starts the program.
    pub fn use_graphics(&mut self, graphics: GraphicsInfo, context: &Context) {
        self.host.wake(context);
        if let Some(program) = &mut self.program {
            return program.replace_graphics(graphics);
        }
        let mut program = Program::start(&self.options, graphics, &mut self.host);
        for text in self.refused.drain(..) {
            let messages = &mut program.session_mut().messages;
            messages.tell(Severity::Error, text);
        }
        self.program = Some(program);
    }

    /// The program, once there is one, with its host.
    pub fn running(&mut self) -> Option<(&mut Program, &mut PageHost)> {
        Some((self.program.as_mut()?, &mut self.host))
    }

    /// Whether there is work that no file has.
    pub fn is_modified(&self) -> bool {
        self.program.as_ref().is_some_and(Program::is_modified)
    }
}

/// The text of the scene in the page's address, as in `#scene=…`, if there is one.
fn linked_scene() -> Option<Result<String, String>> {
    let fragment = browser::fragment();
    Some(scene_link::from_link(fragment.strip_prefix(SCENE)?))
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

/// Fetches the files that the page's address names, as in `?open=man.obj,man.skel,man.attach`.
/// Returns those to open, and why others could not be had.
async fn in_address(given: &GivenFiles) -> (Vec<PathBuf>, Vec<String>) {
    let (mut files, mut refused) = (Vec::new(), Vec::new());
    let names = browser::in_address("open").unwrap_or_default();
    for name in names.split(',').filter(|name| !name.is_empty()) {
        let fetched = match browser::beside(name) {
            Ok(address) => browser::fetch(&address, |_| {}).await,
            Err(error) => Err(error),
        };
        match fetched {
            Ok(bytes) => files.push((PathBuf::from(name), bytes)),
            Err(error) => refused.push(format!("{name}: {error}")),
        }
    }
    let names: Vec<PathBuf> = files.iter().map(|(path, _)| path.clone()).collect();
    if !files.is_empty() {
        given.add(files);
    }
    (main_files(&names), refused)
}
