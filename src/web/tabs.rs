//! Several pages of the program in one browser: each keeps its unsaved work in a slot of its own, which
//! is locked as long as the page is there.

use super::browser;
use crate::program::StorageKey;
use js_sys::{Array, Function, Object, Promise, Reflect};
use std::collections::VecDeque;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;

/// Slots for unsaved work, at most.
const SLOTS: usize = 16;

/// Slots of this page, which no other page has. That of a page that keeps nothing has none.
#[derive(Clone, Debug, Default)]
pub(super) struct Slots {
    /// Those with the work of pages that are gone, the next to be offered first.
    left: VecDeque<usize>,
    /// One without work.
    spare: usize,
}

impl Slots {
    /// Takes the slots that no other page has and that have work: first that of the same page before
    /// it was loaded again, so that it is offered first.
    pub async fn take() -> Self {
        let before = browser::of_this_tab(TAB).and_then(|slot| slot.parse().ok());
        let others = (0..SLOTS).filter(|slot| Some(*slot) != before);
        let (with_work, without): (Vec<usize>, Vec<usize>) = before
            .into_iter()
            .chain(others)
            .partition(|slot| is_used(*slot));
        let mut left = VecDeque::new();
        for slot in with_work {
            if lock(slot).await {
                left.push_back(slot);
            }
        }
        // Where there is none, the last one is shared.
        let mut spare = SLOTS;
        for slot in without {
            if lock(slot).await {
                spare = slot;
                break;
            }
        }
        let slots = Self { left, spare };
        slots.remember();
        slots
    }

    /// The slot whose work is offered, and where work is kept.
    pub fn own(&self) -> usize {
        self.left.front().copied().unwrap_or(self.spare)
    }

    /// Leaves the work in the own slot as it is, and goes on to the next one.
    pub fn pass(&mut self) {
        self.left.pop_front();
        self.remember();
    }

    fn remember(&self) {
        browser::remember_for_tab(TAB, &self.own().to_string());
    }
}

/// Entry with the slot of a tab.
const TAB: &str = "slot";

/// Whether any page, also one that is still there, has unsaved work.
pub(super) fn has_work() -> bool {
    (0..=SLOTS).any(is_used)
}

fn is_used(slot: usize) -> bool {
    browser::stored(&entry(slot)).is_some()
}

/// Name of a slot's entry in the browser's storage.
pub(super) fn entry(slot: usize) -> String {
    format!("{slot}-{}", StorageKey::Autosave.name())
}

/// Whether this page has the lock of a slot from now on, until it is gone. Browsers without locks give
/// it to everybody.
async fn lock(slot: usize) -> bool {
    match ask_for(&format!("editor slot {slot}")) {
        Ok(asked) => JsFuture::from(asked)
            .await
            .map_or(true, |had| had.is_truthy()),
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
    let mut refused = JsValue::UNDEFINED;
    let had = Promise::new(&mut |answer, _| {
        let take = Closure::once_into_js(move |lock: JsValue| {
            // Only a page that is gone does not hear the answer.
            let _ = answer.call1(&JsValue::NULL, &JsValue::from_bool(!lock.is_null()));
            // A lock is held until what its taker promises has come, which is never.
            if lock.is_null() {
                JsValue::NULL
            } else {
                Promise::new(&mut |_, _| {}).into()
            }
        });
        refused = match request.call3(&locks, &name, &options, &take) {
            Ok(requested) => requested,
            Err(error) => Promise::reject(&error).into(),
        };
    });
    // A request that is refused, as where pages may store nothing, never asks its taker.
    Ok(Promise::race(&Array::of2(&had, &refused)))
}
