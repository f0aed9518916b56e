//! Folders that are dropped on the page. eframe takes files alone.

use super::browser;
use super::page::Page;
use js_sys::{Array, Promise};
use std::cell::RefCell;
use std::path::PathBuf;
use std::rc::Rc;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    DragEvent, Event, File, FileSystemDirectoryEntry, FileSystemEntry, FileSystemFileEntry,
};

/// Most files that are read from dropped folders.
const MOST_FILES: usize = 2000;

/// Reads folders that are dropped on the page, with all that is in them.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn take_dropped(page: &Rc<RefCell<Page>>) -> Result<(), JsValue> {
    let window = browser::window().ok_or("There is no page.")?;
    let page = Rc::clone(page);
    browser::listen(&window, "drop", move |event: Event| {
        let entries = event.dyn_ref::<DragEvent>().map(entries);
        let entries = entries.unwrap_or_default();
        if !entries.iter().any(FileSystemEntry::is_directory) {
            return;
        }
        event.prevent_default();
        event.stop_propagation();
        let page = Rc::clone(&page);
        spawn_local(async move {
            let files = read_all(entries).await;
            if let Ok(mut page) = page.try_borrow_mut()
                && let Some((_, host)) = page.running()
            {
                host.take_files(files);
            }
        });
    })
}

/// What was dropped, as files and folders.
fn entries(event: &DragEvent) -> Vec<FileSystemEntry> {
    let Some(items) = event.data_transfer().map(|data| data.items()) else {
        return Vec::new();
    };
    let items = (0..items.length()).filter_map(|i| items.get(i));
    items
        .filter_map(|item| item.webkit_get_as_entry().ok().flatten())
        .collect()
}

/// The files of `entries` and of all folders below them, by their ways from where they were dropped.
async fn read_all(entries: Vec<FileSystemEntry>) -> Vec<(PathBuf, Result<Vec<u8>, String>)> {
    let mut left = entries;
    let mut files = Vec::new();
    while let Some(entry) = left.pop() {
        let path = entry.full_path();
        let path = PathBuf::from(path.trim_start_matches('/'));
        // Programs keep what is not for people in such folders.
        let is_hidden = entry.name().starts_with('.');
        if is_hidden {
            continue;
        }
        if files.len() == MOST_FILES {
            let error = format!("the page reads at most {MOST_FILES} files at once");
            files.push((path, Err(error)));
            break;
        }
        if !entry.is_directory() {
            let bytes = read(entry.unchecked_into()).await;
            files.push((path, bytes.map_err(|error| browser::words(&error))));
            continue;
        }
        match list(entry.unchecked_ref()).await {
            Ok(inner) => left.extend(inner),
            Err(error) => files.push((path, Err(browser::words(&error)))),
        }
    }
    files
}

async fn list(folder: &FileSystemDirectoryEntry) -> Result<Vec<FileSystemEntry>, JsValue> {
    let reader = folder.create_reader();
    let mut all = Vec::new();
    loop {
        let part = Promise::new(&mut |done, failed| {
            if let Err(error) = reader.read_entries_with_callback_and_callback(&done, &failed) {
                // The promise is rejected, and whoever waits for it hears of it.
                let _ = failed.call1(&JsValue::NULL, &error);
            }
        });
        let part: Array = JsFuture::from(part).await?.unchecked_into();
        if part.length() == 0 {
            return Ok(all);
        }
        all.extend(part.iter().map(JsCast::unchecked_into::<FileSystemEntry>));
    }
}

async fn read(file: FileSystemFileEntry) -> Result<Vec<u8>, JsValue> {
    let file = Promise::new(&mut |done, failed| {
        file.file_with_callback_and_callback(&done, &failed);
    });
    let file: File = JsFuture::from(file).await?.unchecked_into();
    browser::bytes(&file).await
}
