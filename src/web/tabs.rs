//! Several pages of the program in one browser: each keeps its unsaved work in a slot of its own, which
//! is locked as long as the page is there.

use super::browser;
use crate::program::StorageKey;
use js_sys::{Function, Object, Promise, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;

/// Slots for unsaved work, at most.
const SLOTS: usize = 16;

/// Slots of this page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slots {
    /// The one whose work is offered, and where work is kept.
    pub own: usize,
    /// Where work is kept once that of the other is left for later.
    pub spare: usize,
}

impl Slots {
    /// Slots that no other page has: first that of the same page before it was loaded again, then those
    /// with the work of pages that are gone.
    pub async fn take() -> Self {
        let before = browser::of_this_tab(TAB).and_then(|slot| slot.parse().ok());
        let has_work = |slot: &usize| browser::stored(&entry(*slot)).is_some();
        let (with_work, free): (Vec<usize>, Vec<usize>) = before
            .into_iter()
            .chain((0..SLOTS).filter(|slot| Some(*slot) != before))
            .partition(has_work);
        let own = first_free(with_work.iter().chain(&free)).await;
        let others = free.iter().filter(|slot| Some(**slot) != own);
        // Where there is none, the last one is shared.
        let spare = first_free(others).await.unwrap_or(SLOTS);
        let own = own.unwrap_or(spare);
        browser::remember_for_tab(TAB, &own.to_string());
        Self { own, spare }
    }

    /// Leaves the work in the own slot for later.
    pub fn leave(&mut self) {
        self.own = self.spare;
        browser::remember_for_tab(TAB, &self.own.to_string());
    }
}

/// Entry with the slot of a tab.
const TAB: &str = "slot";

/// Name of a slot's entry in the browser's storage.
pub(super) fn entry(slot: usize) -> String {
    format!("{slot}-{}", StorageKey::Autosave.name())
}

async fn first_free<'a>(slots: impl Iterator<Item = &'a usize>) -> Option<usize> {
    for &slot in slots {
        if lock(&format!("editor slot {slot}")).await {
            return Some(slot);
        }
    }
    None
}

/// Whether this page has the lock `name` from now on, until it is gone. Browsers without locks give it
/// to everybody.
async fn lock(name: &str) -> bool {
    match ask_for(name) {
        Ok(asked) => JsFuture::from(asked).await.is_ok_and(|had| had.is_truthy()),
        Err(_) => true,
    }
}

/// A promise of whether this page has the lock.
fn ask_for(name: &str) -> Result<Promise, JsValue> {
    let window = browser::window().ok_or("there is no page")?;
    let locks = Reflect::get(&window.navigator(), &"locks".into())?;
    let request: Function = Reflect::get(&locks, &"request".into())?.dyn_into()?;
    let options = Object::new();
    Reflect::set(&options, &"ifAvailable".into(), &JsValue::TRUE)?;
    let name = JsValue::from_str(name);
    Ok(Promise::new(&mut |answer, _| {
        let had = answer.clone();
        let take = Closure::once_into_js(move |lock: JsValue| {
            // Only a page that is gone does not hear the answer.
            let _ = had.call1(&JsValue::NULL, &JsValue::from_bool(!lock.is_null()));
            // A lock is held until what its taker promises has come, which is never.
            if lock.is_null() {
                JsValue::NULL
            } else {
                Promise::new(&mut |_, _| {}).into()
            }
        });
        if request.call3(&locks, &name, &options, &take).is_err() {
            let _ = answer.call1(&JsValue::NULL, &JsValue::TRUE);
        }
    }))
}
