//! Arrow keys in menus: Up and Down go from item to item and around, Right opens a submenu or the next menu of the
//! bar, Left leaves it. egui by itself goes to whatever widget lies that way, out of the menu too.

use egui::containers::menu::{MenuState, SubMenu};
use egui::{Context, EventFilter, FocusDirection, Id, Key, Modifiers, Response, Ui, Vec2};

/// Which items open menus have, and what keys have asked for.
#[derive(Clone, Debug, Default)]
struct MenuKeys {
    /// Menus that were shown in the last frame, outer ones first.
    last: Vec<Level>,
    /// Menus of this frame so far.
    levels: Vec<Level>,
    /// Places in `levels` of those that are being filled, innermost last.
    filled: Vec<usize>,
    /// Items whose submenus are open because of a key, until the pointer moves.
    held_open: Vec<Id>,
    /// The item whose submenu a key has closed, until egui is told.
    closes: Option<Id>,
    /// Whether the next menu that is filled gives the keyboard to its first item: one that this item opens, or any.
    enters: Option<Option<Id>>,
    /// By how many menus to go along the bar.
    along_bar: Option<isize>,
}

/// A menu.
#[derive(Clone, Debug, Default)]
struct Level {
    /// The item that opens it; `None` for one that is no submenu.
    opener: Option<Id>,
    items: Vec<Item>,
}

#[derive(Clone, Copy, Debug)]
struct Item {
    id: Id,
    is_enabled: bool,
    opens: bool,
    /// Whether keys go on from it while no item has the keyboard.
    is_current: bool,
}

impl MenuKeys {
    fn update<R>(ctx: &Context, change: impl FnOnce(&mut Self) -> R) -> R {
        ctx.data_mut(|data| change(data.get_temp_mut_or_default(Id::new("menu keys"))))
    }

    /// Carries out an arrow key while `focused` has the keyboard; the item that gets it.
    fn press(&mut self, key: Key, focused: Option<Id>) -> Option<Id> {
        let of = |level: &Level| level.items.iter().position(|item| Some(item.id) == focused);
        let place = (0..self.last.len())
            .rev()
            .find_map(|level| Some((level, of(&self.last[level])?)));
        let current = || {
            let level = self.last.len().checked_sub(1)?;
            let mut items = self.last[level].items.iter();
            Some((level, items.position(|item| item.is_current)?))
        };
        let Some((level, place)) = place.or_else(current) else {
            return self.enter_deepest(key);
        };
        let items = &self.last[level].items;
        let item = items[place];
        match key {
            Key::ArrowDown | Key::ArrowUp => {
                let count = items.len();
                let step = if key == Key::ArrowDown { 1 } else { count - 1 };
                let places = (1..=count).map(|times| (place + step * times) % count);
                let mut others = places.map(|place| items[place]);
                return Some(others.find(|item| item.is_enabled)?.id);
            }
            Key::ArrowRight if item.opens => self.open(item.id),
            Key::ArrowRight => self.along_bar = Some(1),
            _ => match self.last[level].opener {
                Some(opener) => {
                    self.held_open.retain(|&held| held != opener);
                    self.closes = Some(opener);
                    return Some(opener);
                }
                None => self.along_bar = Some(-1),
            },
        }
        None
    }

    /// The first item of the innermost menu, or the last one for Up; keys along the bar go to other menus.
    fn enter_deepest(&mut self, key: Key) -> Option<Id> {
        let mut items = self
            .last
            .last()?
            .items
            .iter()
            .filter(|item| item.is_enabled);
        match key {
            Key::ArrowDown => Some(items.next()?.id),
            Key::ArrowUp => Some(items.next_back()?.id),
            _ => {
                self.along_bar = Some(if key == Key::ArrowRight { 1 } else { -1 });
                None
            }
        }
    }

    fn open(&mut self, opener: Id) {
        self.held_open.push(opener);
        self.enters = Some(Some(opener));
    }
}

/// Carries out the arrow keys of this frame if a menu is open. To be called before all menus.
pub(super) fn begin(ctx: &Context) {
    let moves = ctx.input(|input| input.pointer.delta() != Vec2::ZERO);
    let focused = ctx.memory(|memory| memory.focused());
    let is_open = MenuKeys::update(ctx, |keys| {
        keys.last = std::mem::take(&mut keys.levels);
        keys.filled.clear();
        keys.along_bar = None;
        if moves || keys.last.is_empty() {
            keys.held_open.clear();
        }
        if keys.last.is_empty() {
            keys.enters = None;
        }
        !keys.last.is_empty()
    });
    if !is_open {
        return;
    }
    for key in [
        Key::ArrowDown,
        Key::ArrowUp,
        Key::ArrowRight,
        Key::ArrowLeft,
    ] {
        if ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
            let item = MenuKeys::update(ctx, |keys| keys.press(key, focused));
            ctx.memory_mut(|memory| {
                // egui would go on from the item to what lies that way.
                memory.move_focus(FocusDirection::None);
                if let Some(item) = item {
                    memory.request_focus(item);
                }
            });
        }
    }
}

/// By how many menus keys go along the bar in this frame.
pub(super) fn along_bar(ctx: &Context) -> Option<isize> {
    MenuKeys::update(ctx, |keys| keys.along_bar.take())
}

/// Gives the keyboard to the first item of the next menu that is filled.
pub(super) fn enter_next(ctx: &Context) {
    MenuKeys::update(ctx, |keys| keys.enters = Some(None));
}

/// Fills a menu, which `opener` opens if it is a submenu. The pointer takes over once it moves in the menu, so that only
/// one item is lit.
pub(super) fn level(ui: &mut Ui, opener: Option<Id>, items: impl FnOnce(&mut Ui)) {
    MenuKeys::update(ui.ctx(), |keys| {
        keys.filled.push(keys.levels.len());
        keys.levels.push(Level {
            opener,
            items: Vec::new(),
        });
    });
    items(ui);
    let first = MenuKeys::update(ui.ctx(), |keys| {
        let level = &keys.levels[keys.filled.pop()?];
        let first = level.items.iter().find(|item| item.is_enabled)?;
        let enters = keys.enters.is_some_and(|of| of == opener);
        enters.then(|| {
            keys.enters = None;
            first.id
        })
    });
    let moves = ui.input(|input| input.pointer.delta() != Vec2::ZERO);
    if let Some(first) = first {
        ui.memory_mut(|memory| memory.request_focus(first));
    } else if moves && ui.rect_contains_pointer(ui.min_rect()) {
        // By its name only from text, but it takes the focus from any item.
        ui.memory_mut(|memory| memory.stop_text_input());
    }
}

/// Whether an item of the menu or list that is being filled is chosen, of which arrow keys take note, and which closes its
/// menu: by itself it closes for the pointer alone, not for Return. Keys go on from the item of a list that `is_current`.
pub(super) fn is_chosen(ui: &Ui, item: &Response, is_current: bool) -> bool {
    note(item, false, is_current);
    let is_chosen = item.clicked();
    if is_chosen {
        ui.close();
    }
    is_chosen
}

fn note(response: &Response, opens: bool, is_current: bool) {
    let item = Item {
        id: response.id,
        is_enabled: response.enabled(),
        opens,
        is_current,
    };
    MenuKeys::update(&response.ctx, |keys| {
        let level = keys.filled.last().copied();
        if let Some(level) = level.and_then(|level| keys.levels.get_mut(level)) {
            level.items.push(item);
        }
    });
    if response.has_focus() {
        let arrows = EventFilter {
            vertical_arrows: true,
            horizontal_arrows: true,
            ..EventFilter::default()
        };
        response
            .ctx
            .memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    }
}

/// A submenu, which keys open and leave.
pub(super) fn submenu(ui: &mut Ui, label: &str, contents: impl FnOnce(&mut Ui)) -> Response {
    let id = ui.next_auto_id();
    let (is_held, closes) = MenuKeys::update(ui.ctx(), |keys| {
        let closes = keys.closes.take_if(|closed| *closed == id).is_some();
        (keys.held_open.contains(&id), closes)
    });
    let menu = SubMenu::id_from_widget_id(id);
    if is_held {
        // egui takes an open submenu that was not shown in the last frame, or that the pointer is beside, for one to
        // close.
        MenuState::mark_shown(ui.ctx(), menu);
        MenuState::from_ui(ui, |state, _| state.open_item = Some(menu));
    } else if closes {
        MenuState::from_ui(ui, |state, _| {
            state.open_item = state.open_item.filter(|open| *open != menu);
        });
    }
    let button = ui.menu_button(label, |ui| level(ui, Some(id), contents));
    let is_open = button.inner.is_some();
    let response = button.response;
    note(&response, true, false);
    if response.clicked() && response.has_focus() && is_open {
        MenuKeys::update(ui.ctx(), |keys| keys.open(id));
    }
    response
}
