//! The letters of the panels.

use super::browser;
use egui::{Context, FontData, FontDefinitions, FontFamily, FontTweak};
use std::cell::OnceCell;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Beside the page: signs that names may have and that the first picture can do without.
const EMOJI: &str = "fonts/NotoEmoji-Regular.ttf";

thread_local! {
    static FETCHED: OnceCell<Vec<u8>> = const { OnceCell::new() };
}

/// Gives `context` the fonts of egui, in its order and sizes, but for the one with letters of one
/// width, which no panel uses, and as long as it has not been fetched that with most of the signs.
pub(super) fn set(context: &Context) {
    context.set_fonts(definitions());
}

/// Fetches the font with most of the signs, for `context` and all later ones.
pub(super) fn fetch_signs(context: &Context) {
    if FETCHED.with(|fetched| fetched.get().is_some()) {
        return;
    }
    let context = context.clone();
    spawn_local(async move {
        // Without it there are frames in the place of some signs.
        if let Ok(bytes) = browser::fetch(EMOJI, |_| {}).await {
            FETCHED.with(|fetched| drop(fetched.set(bytes)));
            set(&context);
            context.request_repaint();
        }
    });
}

fn definitions() -> FontDefinitions {
    let scaled = |font: FontData, scale| {
        font.tweak(FontTweak {
            scale,
            ..FontTweak::default()
        })
    };
    let letters = FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT);
    let icons = FontData::from_static(epaint_default_fonts::EMOJI_ICON);
    let emoji = FETCHED.with(|fetched| fetched.get().cloned());
    let emoji = emoji.map(|bytes| scaled(FontData::from_owned(bytes), 0.81));
    let fonts = [
        Some(("letters", letters)),
        emoji.map(|emoji| ("emoji", emoji)),
        Some(("icons", scaled(icons, 0.9))),
    ];
    let mut definitions = FontDefinitions::empty();
    for (name, font) in fonts.into_iter().flatten() {
        for family in [FontFamily::Proportional, FontFamily::Monospace] {
            let names = definitions.families.entry(family).or_default();
            names.push(name.to_owned());
        }
        definitions
            .font_data
            .insert(name.to_owned(), Arc::new(font));
    }
    definitions
}
