//! Pages that are left: the browser asks first where work is unsaved, and the work is kept.

use super::browser;
use super::page::Page;
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{BeforeUnloadEvent, Event, VisibilityState};

/// Keeps unsaved work when the page is left or hidden, since a hidden page may end unannounced.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn keep_work(page: &Rc<RefCell<Page>>) -> Result<(), JsValue> {
    let window = browser::window().ok_or("There is no page.")?;
    let document = browser::document().ok_or("There is no page.")?;
    let asked = Rc::clone(page);
    browser::listen(&window, "beforeunload", move |event: Event| {
        if asked.try_borrow().is_ok_and(|page| page.is_modified()) {
            event.prevent_default();
            // Older browsers ask for any text at all.
            if let Ok(event) = event.dyn_into::<BeforeUnloadEvent>() {
                event.set_return_value("unsaved");
            }
        }
    })?;
    let left = Rc::clone(page);
    browser::listen(&window, "pagehide", move |_| keep(&left))?;
    let hidden = Rc::clone(page);
    browser::listen(&document, "visibilitychange", move |_| {
        let state = browser::document().map(|document| document.visibility_state());
        if state == Some(VisibilityState::Hidden) {
            keep(&hidden);
        }
    })
}

fn keep(page: &RefCell<Page>) {
    // A frame under way keeps its work itself.
    if let Ok(mut page) = page.try_borrow_mut()
        && let Some((program, host)) = page.running()
    {
        program.keep(host);
    }
}
