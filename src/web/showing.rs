//! Showing the program in the canvas, and showing it anew after the browser took WebGL away.

use super::application::Application;
use super::page::Page;
use super::{browser, note};
use eframe::{AppCreator, WebGlContextOption, WebOptions, WebRunner};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Event, HtmlCanvasElement};

thread_local! {
    /// Whatever runs egui in the canvas now. It can be stopped, and then another takes its place.
    static RUNNER: RefCell<Option<WebRunner>> = const { RefCell::new(None) };
}

/// Shows `page` in `canvas`.
///
/// # Errors
/// If the browser has no WebGL 2, or it refuses something that every picture needs.
pub(super) async fn show(
    canvas: &HtmlCanvasElement,
    page: &Rc<RefCell<Page>>,
) -> Result<(), JsValue> {
    let context = browser::webgl(canvas)
        .ok_or("This browser has no WebGL 2, which the editor draws with.")?;
    let options = WebOptions {
        webgl_context_option: WebGlContextOption::WebGl2,
        dithering: false,
        ..WebOptions::default()
    };
    let page = Rc::clone(page);
    let create: AppCreator<'static> =
        Box::new(move |creation| Ok(Box::new(Application::new(creation, context, page)?)));
    let runner = WebRunner::new();
    runner.start(canvas.clone(), options, create).await?;
    RUNNER.with(|kept| *kept.borrow_mut() = Some(runner));
    note::hide();
    Ok(())
}

fn stop() {
    if let Some(runner) = RUNNER.with(|kept| kept.borrow_mut().take()) {
        runner.destroy();
    }
}

/// Stops when the browser takes the context of `canvas` away, and shows `page` anew, with everything
/// uploaded again, when it gives one back.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn look_after_context(
    canvas: &HtmlCanvasElement,
    page: &Rc<RefCell<Page>>,
) -> Result<(), JsValue> {
    browser::listen(canvas, "webglcontextlost", |event: Event| {
        // Otherwise the browser never gives it back.
        event.prevent_default();
        stop();
        note::show(
            "The browser has taken the graphics away for a moment. Nothing is lost; the picture comes \
             back by itself.",
        );
    })?;
    let (shown, page) = (canvas.clone(), Rc::clone(page));
    browser::listen(canvas, "webglcontextrestored", move |_| {
        let (canvas, page) = (shown.clone(), Rc::clone(&page));
        spawn_local(async move {
            if let Err(error) = show(&canvas, &page).await {
                note::show(&browser::words(&error));
            }
        });
    })
}
