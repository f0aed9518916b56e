//! What the page asks of the browser.

use js_sys::{ArrayBuffer, Promise, Uint8Array};
use std::time::Duration;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{
    Blob, Clipboard, Document, Event, EventTarget, File, HtmlAnchorElement, HtmlCanvasElement,
    HtmlInputElement, ReadableStream, ReadableStreamDefaultReader, ReadableStreamReadResult,
    Storage, Url, WebGl2RenderingContext, Window,
};

/// Element of the page that the program is shown in.
const CANVAS: &str = "editor";

/// Element with which files are chosen.
const CHOOSER: &str = "chooser";

/// Time after which a download has begun.
const DOWNLOAD_BEGINS: Duration = Duration::from_secs(60);

pub(super) fn window() -> Option<Window> {
    web_sys::window()
}

pub(super) fn document() -> Option<Document> {
    window()?.document()
}

/// The canvas of the page.
///
/// # Errors
/// If it has none, in words.
pub(super) fn canvas() -> Result<HtmlCanvasElement, JsValue> {
    document()
        .and_then(|document| document.get_element_by_id(CANVAS))
        .and_then(|element| element.dyn_into().ok())
        .ok_or_else(|| "The page has no canvas for the editor.".into())
}

/// What a failure of the browser says.
pub(super) fn words(error: &JsValue) -> String {
    let message = || {
        error
            .dyn_ref()
            .map(|error: &js_sys::Error| String::from(error.message()))
    };
    let text = error.as_string().or_else(message);
    text.unwrap_or_else(|| format!("{error:?}"))
}

/// Calls `work` at each event called `name`, as long as the page is there, before anybody within
/// `target` hears of it.
///
/// # Errors
/// If the browser refuses.
pub(super) fn listen(
    target: &EventTarget,
    name: &str,
    work: impl FnMut(Event) + 'static,
) -> Result<(), JsValue> {
    let work = Closure::<dyn FnMut(Event)>::new(work);
    let callback = work.as_ref().unchecked_ref();
    target.add_event_listener_with_callback_and_bool(name, callback, true)?;
    // JavaScript keeps it from now on.
    work.forget();
    Ok(())
}

/// Time since the page was opened.
pub(super) fn now() -> Duration {
    let clock = window().and_then(|window| window.performance());
    Duration::from_secs_f64(clock.map_or(0.0, |clock| clock.now() / 1000.0))
}

/// Text that is stored as `entry`, if any.
pub(super) fn stored(entry: &str) -> Option<String> {
    storage()?.get_item(&key(entry)).ok()?
}

/// Stores `text` as `entry` for later visits; whether there is room for it.
pub(super) fn store(entry: &str, text: &str) -> bool {
    storage().is_some_and(|storage| storage.set_item(&key(entry), text).is_ok())
}

/// Text that is stored as `entry` for this tab alone, if any.
pub(super) fn of_this_tab(entry: &str) -> Option<String> {
    let storage = window()?.session_storage().ok().flatten()?;
    storage.get_item(&key(entry)).ok()?
}

/// Stores `text` as `entry` for as long as this tab is there, also when its page is loaded again.
pub(super) fn remember_for_tab(entry: &str, text: &str) {
    let storage = window().and_then(|window| window.session_storage().ok().flatten());
    if let Some(storage) = storage {
        // A browser that keeps nothing for tabs has one slot after the other.
        let _ = storage.set_item(&key(entry), text);
    }
}

/// Removes what is stored as `entry`.
pub(super) fn remove(entry: &str) {
    if let Some(storage) = storage() {
        // What does not exist need not be removed.
        let _ = storage.remove_item(&key(entry));
    }
}

/// Key of an entry, apart from those of other pages of the same site.
fn key(entry: &str) -> String {
    format!("editor/{entry}")
}

/// The browser's storage for this page; `None` where it is forbidden.
fn storage() -> Option<Storage> {
    window()?.local_storage().ok().flatten()
}

/// Writes to the browser's console.
pub(super) fn warn(text: &str) {
    web_sys::console::warn_1(&JsValue::from_str(text));
}

/// Calls `work` after a time, and once the browser has shown what it has to show.
pub(super) fn after(delay: Duration, work: impl FnOnce() + 'static) {
    let delay = i32::try_from(delay.as_millis()).unwrap_or(i32::MAX);
    let work = Closure::once_into_js(work);
    if let Some(window) = window() {
        // It takes any function.
        let _ = window
            .set_timeout_with_callback_and_timeout_and_arguments_0(work.unchecked_ref(), delay);
    }
}

/// Calls `work` before the browser draws the page the next time, which it does not before what was drawn
/// last is shown.
pub(super) fn at_next_frame(work: impl FnOnce() + 'static) {
    let work = Closure::once_into_js(work);
    if let Some(window) = window() {
        // It takes any function.
        let _ = window.request_animation_frame(work.unchecked_ref());
    }
}

/// WebGL 2 in `canvas`, without samples of its own: pictures are drawn with theirs before they come
/// into it, and could not be copied there otherwise.
pub(super) fn webgl(canvas: &HtmlCanvasElement) -> Option<WebGl2RenderingContext> {
    let options = js_sys::Object::new();
    js_sys::Reflect::set(&options, &"antialias".into(), &JsValue::FALSE).ok()?;
    let context = canvas.get_context_with_context_options("webgl2", &options);
    context.ok().flatten()?.dyn_into().ok()
}

/// Has the user choose files; `chosen` gets them, if there are any.
pub(super) fn choose_files(chosen: impl FnOnce(Vec<File>) + 'static) {
    let Some(input) = chooser() else {
        return;
    };
    let source = input.clone();
    let on_change = Closure::once_into_js(move || {
        let Some(files) = source.files() else {
            return;
        };
        chosen((0..files.length()).filter_map(|i| files.get(i)).collect());
    });
    input.set_onchange(Some(on_change.unchecked_ref()));
    input.click();
}

/// A new chooser on the page, in place of the one before, which nobody answered.
fn chooser() -> Option<HtmlInputElement> {
    let document = document()?;
    if let Some(before) = document.get_element_by_id(CHOOSER) {
        before.remove();
    }
    let input: HtmlInputElement = document.create_element("input").ok()?.dyn_into().ok()?;
    input.set_id(CHOOSER);
    input.set_type("file");
    input.set_multiple(true);
    input.set_hidden(true);
    document.body()?.append_child(&input).ok()?;
    Some(input)
}

/// The content of a file.
///
/// # Errors
/// If the browser cannot read it.
pub(super) async fn bytes(file: &Blob) -> Result<Vec<u8>, JsValue> {
    buffered(file.array_buffer()).await
}

/// Hands `bytes` to the user as a file called `name`.
///
/// # Errors
/// If the browser refuses.
pub(super) fn download(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = document().ok_or("there is no page")?;
    let parts = js_sys::Array::of1(&Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence(&parts)?;
    let url = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = document.create_element("a")?.dyn_into()?;
    link.set_href(&url);
    link.set_download(name);
    link.click();
    after(DOWNLOAD_BEGINS, move || {
        // Otherwise its memory is free when the page is left.
        let _ = Url::revoke_object_url(&url);
    });
    Ok(())
}

/// The content of a file beside the page. `here` is told how many of its bytes have come.
///
/// # Errors
/// If there is none, in words.
pub(super) async fn fetch(address: &str, here: impl FnMut(usize)) -> Result<Vec<u8>, String> {
    let window = window().ok_or("there is no page")?;
    let failed = |error: JsValue| words(&error);
    let response = JsFuture::from(window.fetch_with_str(address)).await;
    let response = response.map_err(failed)?;
    let response: web_sys::Response = response.unchecked_into();
    if !response.ok() {
        return Err("there is no such file beside the page".to_owned());
    }
    let body = response.body().ok_or("it is empty")?;
    streamed(body, here).await.map_err(failed)
}

/// All that comes from `stream`.
async fn streamed(stream: ReadableStream, mut here: impl FnMut(usize)) -> Result<Vec<u8>, JsValue> {
    let reader: ReadableStreamDefaultReader = stream.get_reader().unchecked_into();
    let mut bytes = Vec::new();
    loop {
        let part = JsFuture::from(reader.read()).await?;
        let part: ReadableStreamReadResult = part.unchecked_into();
        if part.get_done() == Some(true) {
            return Ok(bytes);
        }
        bytes.extend(Uint8Array::new(&part.get_value()).to_vec());
        here(bytes.len());
    }
}

/// The bytes that are promised.
async fn buffered(buffer: Promise) -> Result<Vec<u8>, JsValue> {
    let buffer: ArrayBuffer = JsFuture::from(buffer).await?.unchecked_into();
    Ok(Uint8Array::new(&buffer).to_vec())
}

/// The page's address with `fragment` behind it, and nothing else.
pub(super) fn link(fragment: &str) -> Option<String> {
    let location = window()?.location();
    let (origin, path) = (location.origin().ok()?, location.pathname().ok()?);
    Some(format!("{origin}{path}#{fragment}"))
}

/// What the page's address has behind `#`, without that; empty if nothing.
pub(super) fn fragment() -> String {
    let hash = window().and_then(|window| window.location().hash().ok());
    let hash = hash.unwrap_or_default();
    hash.strip_prefix('#').unwrap_or_default().to_owned()
}

/// Takes what is behind `#` out of the page's address; the browser's way back has it still.
pub(super) fn clear_fragment() {
    if let Some(window) = window() {
        // Nothing depends on it.
        let _ = window.location().set_hash("");
    }
}

/// Opens the page anew.
pub(super) fn reload() {
    if let Some(window) = window() {
        // A browser that refuses shows what it has shown.
        let _ = window.location().reload();
    }
}

/// Whether the machine is pointed at with fingers first of all, as a phone is.
pub(super) fn has_fingers_first() -> bool {
    let query = window().and_then(|window| window.match_media("(pointer: coarse)").ok()?);
    query.is_some_and(|query| query.matches())
}

/// Values of `name` in the page's address, as `?open=a.obj,b.scene`.
pub(super) fn in_address(name: &str) -> Option<String> {
    let query = window()?.location().search().ok()?;
    web_sys::UrlSearchParams::new_with_str(&query)
        .ok()?
        .get(name)
}

/// The content of a file of the page's site, by its way from the page.
///
/// # Errors
/// If there is none, or `name` leads anywhere else, in words.
pub(super) async fn fetch_of_site(name: &str) -> Result<Vec<u8>, String> {
    fetch(&of_site(name)?, |_| {}).await
}

/// The address of a file of the page's site.
fn of_site(name: &str) -> Result<String, String> {
    let base = || document()?.base_uri().ok().flatten();
    let base = base().ok_or("there is no page")?;
    let url = Url::new_with_base(name, &base).map_err(|error| words(&error))?;
    let page = Url::new(&base).map_err(|error| words(&error))?;
    if url.origin() == page.origin() {
        Ok(url.href())
    } else {
        Err("the page opens only files of its own site".to_owned())
    }
}

/// Says that the first picture is there: `editor-shown`, as an event and in the browser's measures.
pub(super) fn tell_shown() {
    const NAME: &str = "editor-shown";
    let Some(window) = window() else {
        return;
    };
    if let Some(clock) = window.performance() {
        // Without it nobody can measure.
        let _ = clock.mark(NAME);
    }
    if let Ok(event) = Event::new(NAME) {
        // Nobody can refuse it.
        let _ = window.dispatch_event(&event);
    }
}

/// Says in the browser's measures that `name` begins.
pub(super) fn begin_measure(name: &str) {
    if let Some(clock) = window().and_then(|window| window.performance()) {
        let _ = clock.mark(name);
    }
}

/// Adds to the browser's measures the time since `name` began last.
pub(super) fn end_measure(name: &str) {
    if let Some(clock) = window().and_then(|window| window.performance()) {
        let _ = clock.measure_with_start_mark(name, name);
    }
}

fn clipboard() -> Option<Clipboard> {
    Some(window()?.navigator().clipboard())
}

/// Puts text on the clipboard.
pub(super) fn copy_text(text: &str) {
    if let Some(clipboard) = clipboard() {
        // Where it is refused, nothing is on the clipboard, as the browser says.
        drop(clipboard.write_text(text));
    }
}

/// The text on the clipboard; `None` where the user does not allow it.
pub(super) async fn pasted_text() -> Option<String> {
    let text = JsFuture::from(clipboard()?.read_text()).await.ok()?;
    text.as_string()
}
