//! The wheel over a scene in somebody else's page.

use super::browser;
use wasm_bindgen::JsValue;
use web_sys::Event;

/// Has the wheel scroll the page around until a click in the frame gives that the keyboard: who reads on with the
/// pointer over the scene is not to get stuck there.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn leave_to_page() -> Result<(), JsValue> {
    let window = browser::window().ok_or("There is no page.")?;
    browser::listen(&window, "wheel", |event: Event| {
        let document = browser::window().and_then(|window| window.document());
        if !document.is_some_and(|document| document.has_focus().unwrap_or(true)) {
            event.stop_immediate_propagation();
        }
    })
}
