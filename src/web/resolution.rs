//! Screens of another resolution, to which the page is moved.

use super::browser;
use egui::Context;
use wasm_bindgen::JsCast;
use web_sys::MediaQueryList;

/// Has `context` draw whenever a point comes to have another number of pixels: eframe makes the canvas anew then, which
/// is empty, and where its size in points stays no frame would come before the next input.
pub(super) fn draw_on_change(context: &Context) {
    let Some(window) = browser::window() else {
        return;
    };
    // It holds for this number alone.
    let query = format!("(resolution: {}dppx)", window.device_pixel_ratio());
    let Ok(Some(list)) = window.match_media(&query) else {
        return;
    };
    let context = context.clone();
    // Where the browser refuses, the next input draws.
    let _ = browser::listen(&list, "change", move |event| {
        let list = event
            .target()
            .and_then(|target| target.dyn_into::<MediaQueryList>().ok());
        if list.is_some_and(|list| !list.matches()) {
            context.request_repaint();
            draw_on_change(&context);
        }
    });
}
