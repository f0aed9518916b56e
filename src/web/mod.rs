//! The page: the program in a browser, in a canvas that eframe looks after.

mod address;
mod application;
mod browser;
mod error_watch;
mod fetching;
mod folders;
mod fonts;
mod given_files;
mod kept_files;
mod keys;
mod leaving;
mod note;
mod page;
mod page_host;
mod rescue;
mod resolution;
mod scrolling;
mod showing;
mod tabs;

use page::Page;
use wasm_bindgen::JsValue;

/// Starts the program in the canvas of the page. What stands in its way is said on the page.
pub fn run() {
    note::tell_panics();
    wasm_bindgen_futures::spawn_local(async {
        if let Err(error) = start().await {
            note::show(&browser::words(&error));
        }
    });
}

async fn start() -> Result<(), JsValue> {
    let canvas = browser::canvas()?;
    let page = Page::of_earlier_visit().await;
    showing::show(&canvas, &page).await?;
    showing::look_after_context(&canvas, &page)?;
    address::follow_links()?;
    folders::take_dropped(&page)?;
    keys::keep_for_commands()?;
    if browser::in_address(page::VIEWER).is_some() {
        scrolling::leave_to_page()?;
    }
    leaving::keep_work(&page)
}
