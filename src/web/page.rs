//! What stays on the page when the graphics come and go.

use super::address::Asked;
use super::given_files::GivenFiles;
use super::page_host::PageHost;
use super::tabs::{self, Slots};
use super::{browser, kept_files};
use crate::editor::Severity;
use crate::program::{GraphicsInfo, Options, Program};
use egui::Context;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Most bytes of files that are kept while no unsaved work needs them.
const MOST_KEPT: usize = 64 << 20;

/// What the address of a page without panels has.
pub(super) const VIEWER: &str = "view";

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
        let asked = Asked::for_page(&given).await;
        let mut host = PageHost::new(given, slots);
        let options = Options {
            asks_for_files: asked.is_any(),
            files: asked.files,
            is_viewer,
            has_fingers_first: browser::has_fingers_first(),
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
            refused: asked.refused,
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
