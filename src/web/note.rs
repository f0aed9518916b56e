//! The note: what the page says while the program itself cannot.

use super::{browser, rescue};
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;

/// Element of the page with the note.
const NOTE: &str = "note";

fn element() -> Option<HtmlElement> {
    let element = browser::document()?.get_element_by_id(NOTE)?;
    element.dyn_into().ok()
}

/// Says `text` in place of the program.
pub(super) fn show(text: &str) {
    if let Some(note) = element() {
        note.set_text_content(Some(text));
        note.set_hidden(false);
    }
}

/// Says nothing any more.
pub(super) fn hide() {
    if let Some(note) = element() {
        note.set_hidden(true);
    }
}

/// Says on the page when the program has stopped by a mistake of its own, and keeps unsaved work.
pub(super) fn tell_panics() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        before(panic);
        rescue::store_latest();
        show(
            "The editor has stopped because of a mistake of its own. Reload the page: work that was \
             kept is offered back.",
        );
    }));
}
