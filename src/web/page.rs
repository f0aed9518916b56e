//! What stays on the page when the graphics come and go.

use super::given_files::{GivenFiles, main_files};
use super::page_host::PageHost;
use super::tabs::{self, Slots};
use super::{browser, kept_files};
use crate::editor::Severity;
use crate::io::builtin::is_builtin;
use crate::io::scene_link;
use crate::program::{GraphicsInfo, Options, Program};
use egui::Context;
use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use wasm_bindgen::JsValue;

/// Most bytes of files that are kept while no unsaved work needs them.
const MOST_KEPT: usize = 64 << 20;

/// What the address of a page without panels has.
const VIEWER: &str = "view";

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
        let is_viewer = browser::in_address(VIEWER).is_some();
        // A scene in somebody else's page knows none of the user's files.
        let mut kept = if is_viewer {
            HashMap::new()
        } else {
            kept_files::load().await
        };
        let size: usize = kept.values().map(Vec::len).sum();
        let slots = if is_viewer {
            Slots::default()
        } else {
            Slots::take().await
        };
        if size > MOST_KEPT && !tabs::has_work() {
            kept.clear();
            // What could not be forgotten is forgotten at the next visit.
            let _ = kept_files::forget().await;
        }
        let given = GivenFiles::of(kept, !is_viewer);
        let (mut files, mut refused) = in_address(&given).await;
        match linked_scene() {
            Some(Ok(text)) => {
                given.add(vec![(PathBuf::from(LINKED), text.into_bytes())]);
                files.push(PathBuf::from(LINKED));
            }
            Some(Err(error)) => refused.push(format!("The link cannot be opened: {error}")),
            None => {}
        }
        let mut host = PageHost::new(given, slots);
        let options = Options {
            files,
            is_viewer,
            ..Options::default()
        };
        if options.is_viewer {
            host = host.forgetting();
        }
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
        !self.options.is_viewer && self.program.as_ref().is_some_and(Program::is_modified)
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
    let mut builtin = Vec::new();
    for name in names.split(',').filter(|name| !name.is_empty()) {
        if is_builtin(Path::new(name)) {
            builtin.push(PathBuf::from(name));
            continue;
        }
        let fetched = match browser::of_site(name) {
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
    let opened = if names.is_empty() {
        Vec::new()
    } else {
        main_files(&names)
    };
    (builtin.into_iter().chain(opened).collect(), refused)
}
