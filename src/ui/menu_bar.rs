use super::command_search::BUILTIN_TIP;
use super::commands::{Command, Entry, Menu, full_label, full_tooltip, is_on, run, why_disabled};
use super::context_menu::OpenMenu;
use super::key_commands::is_there;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::{named, tip_beside};
use super::{Action, Ask, ViewInput, commands, menu_keys};
use crate::editor::Session;
use crate::scene::{Source, name_of_import};
use egui::containers::menu::{MenuBar, MenuConfig, menu_style};
use egui::{
    Button, Context, Frame, Id, Label, Layout, Margin, Panel, Popup, PopupAnchor,
    PopupCloseBehavior, PopupKind, Rect, Response, RichText, ScrollArea, SetOpenCommand, Ui, Vec2,
};

/// Height of what is around a row in the bar and of a menu's margins, in points.
const MARGINS: f32 = 28.0;
/// Height of the tallest menu, by that from row to row.
const HIGHEST: f32 = 25.0;
/// Before a switch that is on, and as wide before what is not.
const MARK: &str = "✔ ";
const NO_MARK: &str = "     ";

/// Everything that the items of the menus need.
struct Items<'a> {
    session: &'a Session,
    state: &'a mut UiState,
    input: &'a ViewInput<'a>,
    aspect: f32,
    /// Whether items leave room for the marks of switches beside them.
    is_marked: bool,
    actions: &'a mut Vec<Action>,
}

/// The menu bar, with the window's title at the right if there is room for it.
pub(super) fn show(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    aspect: f32,
    actions: &mut Vec<Action>,
) {
    let mut items = Items {
        session,
        state,
        input,
        aspect,
        is_marked: false,
        actions,
    };
    menu_keys::begin(root.ctx());
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 2));
    Panel::top("menu bar").frame(frame).show(root, |ui| {
        let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClick);
        MenuBar::new().config(config).ui(ui, |ui| {
            ui.spacing_mut().button_padding = egui::vec2(8.0, 2.0);
            let menus = [
                ui.menu_button("File", |ui| scrolled(ui, |ui| items.file(ui))),
                ui.menu_button("Edit", |ui| scrolled(ui, |ui| items.edit(ui))),
                ui.menu_button("Insert", |ui| scrolled(ui, |ui| items.insert(ui))),
                ui.menu_button("View", |ui| scrolled(ui, |ui| items.view(ui))),
                ui.menu_button("Pose", |ui| scrolled(ui, |ui| items.pose(ui))),
                ui.menu_button("Help", |ui| scrolled(ui, |ui| items.all(ui, Menu::Help))),
            ];
            let menus = menus.map(|menu| menu.response);
            let titles = menus.iter().map(|menu| menu.rect);
            items.state.menu_titles = titles.fold(Rect::NOTHING, Rect::union);
            follow_pointer(ui.ctx(), &menus);
            follow_keys(ui.ctx(), &menus);
            title(ui, items.input.title);
        });
    });
    insert_at_pointer(root, &mut items);
    context_menu(root, &mut items);
}

/// Opens the menu whose title comes under the pointer while another one is open, as menu bars do.
fn follow_pointer(ctx: &Context, menus: &[Response]) {
    let is_open = |menu: &&Response| Popup::is_id_open(ctx, Popup::default_response_id(menu));
    let moves = ctx.input(|input| input.pointer.delta() != Vec2::ZERO);
    let pointed = menus.iter().find(|menu| menu.hovered() && moves);
    if let (Some(pointed), Some(open)) = (pointed, menus.iter().find(is_open))
        && pointed.id != open.id
    {
        Popup::open_id(ctx, Popup::default_response_id(pointed));
    }
}

/// Opens the menu beside the open one where keys go along the bar.
fn follow_keys(ctx: &Context, menus: &[Response]) {
    let Some(by) = menu_keys::along_bar(ctx) else {
        return;
    };
    let is_open = |menu: &Response| Popup::is_id_open(ctx, Popup::default_response_id(menu));
    if let Some(open) = menus.iter().position(is_open) {
        let next = (open as isize + by).rem_euclid(menus.len() as isize) as usize;
        Popup::open_id(ctx, Popup::default_response_id(&menus[next]));
        menu_keys::enter_next(ctx);
    }
}

/// The menu Insert where the pointer was when the command asked for it, while it is open. Its first item
/// has the keyboard then, since a key opened it: arrow keys and Return choose.
fn insert_at_pointer(root: &Ui, items: &mut Items) {
    let opens = std::mem::take(&mut items.state.opens_insert_menu);
    // Behind a dialog the pointer is forgotten until it moves.
    let pointer = root.input(|input| input.pointer.latest_pos());
    items.state.pointer_was = pointer.or(items.state.pointer_was);
    if opens {
        menu_keys::enter_next(root.ctx());
        let middle = items.state.view_rect.center();
        items.state.insert_menu_at = items.state.pointer_was.unwrap_or(middle);
    }
    let place = PopupAnchor::Position(items.state.insert_menu_at);
    popup_menu(root, ("insert at pointer", place), opens, |ui| {
        items.insertable(ui);
    });
}

/// The menu for what was under the pointer at a right click, while it is open.
fn context_menu(root: &Ui, items: &mut Items) {
    let Some(OpenMenu { menu, at, opens }) = items.state.context_menu else {
        return;
    };
    items.state.context_menu = Some(OpenMenu {
        menu,
        at,
        opens: false,
    });
    let tool = items.state.pose.tool;
    let mut shown: Vec<Command> = Vec::new();
    let place = ("context menu", PopupAnchor::Position(at));
    popup_menu(root, place, opens, |ui| {
        for (index, part) in menu.parts().iter().enumerate() {
            if index > 0 {
                ui.separator();
            }
            let entries = part
                .iter()
                .filter_map(|&command| commands::entry_of(command));
            for entry in entries {
                // Delete puts a joint back while a figure is posed.
                let meant = commands::meant(entry.command, items.session, tool);
                if !shown.contains(&meant) {
                    shown.push(meant);
                    items.item(ui, entry);
                }
            }
        }
    });
}

/// A menu called `name` at `place` from when it `opens` on, while it is open.
fn popup_menu(
    root: &Ui,
    (name, place): (&str, PopupAnchor),
    opens: bool,
    items: impl FnOnce(&mut Ui),
) {
    Popup::new(Id::new(name), root.ctx().clone(), place, root.layer_id())
        .kind(PopupKind::Menu)
        .layout(Layout::top_down_justified(egui::Align::Min))
        .style(menu_style)
        .open_memory(opens.then_some(SetOpenCommand::Bool(true)))
        .show(|ui| scrolled(ui, items));
}

fn title(ui: &mut Ui, title: &str) {
    ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
        let color = Palette::of(ui.visuals()).weak;
        ui.add(Label::new(RichText::new(title).color(color)).truncate());
    });
}

impl Items<'_> {
    fn file(&mut self, ui: &mut Ui) {
        self.all(ui, Menu::Document);
        ui.separator();
        self.recent(ui);
        submenu(ui, "Built-in Scene", |ui| self.all(ui, Menu::Scenes));
        ui.separator();
        self.all(ui, Menu::File);
    }

    /// File ▸ Open Recent, if there are any.
    fn recent(&mut self, ui: &mut Ui) {
        if self.input.recent.is_empty() {
            return;
        }
        submenu(ui, "Open Recent", |ui| {
            for path in self.input.recent {
                let name = path.file_name().unwrap_or(path.as_os_str());
                let item = Button::new(name.to_string_lossy().into_owned())
                    .wrap_mode(egui::TextWrapMode::Extend);
                let item = ui.add(item);
                tip_beside(&item, &path.to_string_lossy(), None);
                if menu_keys::is_chosen(ui, &item, false) {
                    self.actions
                        .push(Action::Ask(Ask::OpenRecent(path.clone())));
                }
            }
        });
    }

    fn edit(&mut self, ui: &mut Ui) {
        self.all(ui, Menu::Edit);
        ui.separator();
        self.all(ui, Menu::Clipboard);
        ui.separator();
        self.all(ui, Menu::Shape);
        submenu(ui, "Reset Transform", |ui| self.all(ui, Menu::Transform));
        ui.separator();
        self.all(ui, Menu::Preferences);
    }

    fn insert(&mut self, ui: &mut Ui) {
        self.all(ui, Menu::Insert);
        self.insertable_besides(ui);
    }

    /// Everything that can be inserted, without the command that shows this menu elsewhere.
    fn insertable(&mut self, ui: &mut Ui) {
        let is_shape = |entry: &&Entry| entry.command != Command::InsertMenu;
        for entry in commands::entries(Menu::Insert).filter(is_shape) {
            self.item(ui, entry);
        }
        self.insertable_besides(ui);
    }

    /// What can be inserted besides the shapes of the course.
    fn insertable_besides(&mut self, ui: &mut Ui) {
        ui.separator();
        self.all(ui, Menu::Curves);
        ui.separator();
        let (characters, curves) = (self.input.builtin_characters, self.input.builtin_curves);
        self.builtins(ui, "Built-in Character", characters);
        self.builtins(ui, "Built-in Curve", curves);
        submenu(ui, "Import", |ui| self.all(ui, Menu::Import));
    }

    /// A submenu of built-in files, if there are any.
    fn builtins(&mut self, ui: &mut Ui, label: &str, names: &[&'static str]) {
        if names.is_empty() {
            return;
        }
        submenu(ui, label, |ui| {
            for &name in names {
                let item = ui.button(name_of_import(name));
                tip_beside(&item, BUILTIN_TIP, None);
                if menu_keys::is_chosen(ui, &item, false) {
                    self.actions.push(Action::Ask(Ask::InsertBuiltin(name)));
                }
            }
        });
    }

    fn view(&mut self, ui: &mut Ui) {
        self.is_marked = true;
        self.choices(ui, "View from", Menu::Directions);
        self.all(ui, Menu::View);
        ui.separator();
        self.choices(ui, "Look", Menu::Look);
        self.choices(ui, "Shading", Menu::Shading);
        self.choices(ui, "Colors", Menu::Colors);
        self.all(ui, Menu::Ground);
        ui.separator();
        self.all(ui, Menu::Compare);
        self.all(ui, Menu::Explain);
        ui.separator();
        self.choices(ui, "Navigation", Menu::Navigation);
        self.choices(ui, "Theme", Menu::Theme);
        self.choices(ui, "Skinning", Menu::Skinning);
        self.is_marked = false;
    }

    /// A submenu beside switches, in line with their words.
    fn choices(&mut self, ui: &mut Ui, label: &str, menu: Menu) {
        let label_in_line = format!("{NO_MARK}{label}");
        let button = menu_keys::submenu(ui, &label_in_line, |ui| self.all(ui, menu));
        named(button, label);
    }

    fn pose(&mut self, ui: &mut Ui) {
        self.all(ui, Menu::Tools);
        ui.separator();
        self.all(ui, Menu::Pose);
        self.builtin_poses(ui);
    }

    /// A submenu of the built-in poses of the selected character, if there are any.
    fn builtin_poses(&mut self, ui: &mut Ui) {
        let Some((shape, _)) = commands::selected_character(self.session) else {
            return;
        };
        let scene = self.session.scene();
        let source = scene.shape(shape).and_then(|shape| shape.source.as_ref());
        let Some(stem) = source
            .filter(|source| source.is_builtin())
            .map(Source::stem)
        else {
            return;
        };
        let of_character =
            |name: &&'static str| Some((*name, name.strip_prefix(stem)?.strip_prefix('-')?));
        let poses: Vec<_> = self
            .input
            .builtin_poses
            .iter()
            .filter_map(of_character)
            .collect();
        if poses.is_empty() {
            return;
        }
        submenu(ui, "Built-in Pose", |ui| {
            for (name, pose) in poses {
                let item = ui.button(name_of_import(pose));
                if menu_keys::is_chosen(ui, &item, false) {
                    self.actions
                        .push(Action::Ask(Ask::UseBuiltinPose(shape, name)));
                }
            }
        });
    }

    /// All commands of one menu, from the table.
    fn all(&mut self, ui: &mut Ui, menu: Menu) {
        let input = self.input;
        for entry in commands::entries(menu).filter(|entry| is_there(entry.command, input)) {
            self.item(ui, entry);
        }
    }

    /// An item for a row of the table: for what its key does at the moment in place of Delete, which must not
    /// surprise, and without a key that does something else elsewhere.
    fn item(&mut self, ui: &mut Ui, row: &Entry) -> Response {
        let meant = commands::meant(row.command, self.session, self.state.pose.tool);
        let replaces = row.command == Command::Delete;
        let entry = commands::entry_of(meant)
            .filter(|_| replaces)
            .unwrap_or(row);
        let (navigation, tool) = (self.state.navigation, self.state.pose.tool);
        let row = (row, entry.command);
        let key = commands::key_now(ui.ctx(), navigation, row, self.session, tool);
        let why = why_disabled(entry.command, self.session, self.state);
        let on = is_on(entry.command, self.session, self.state);
        let mark = match on {
            Some(true) => format!("{MARK}{}", entry.label),
            Some(false) => format!("{NO_MARK}{}", entry.label),
            None => {
                let room = if self.is_marked { NO_MARK } else { "" };
                format!(
                    "{room}{}",
                    full_label(entry.command, self.session, self.state)
                )
            }
        };
        // What Undo and Redo are about is no part of what they are called; what else is added to labels is.
        let name = match entry.command {
            Command::Undo | Command::Redo => entry.label.to_owned(),
            command => full_label(command, self.session, self.state),
        };
        let button = Button::new(mark)
            .shortcut_text(key)
            .wrap_mode(egui::TextWrapMode::Extend);
        let item = named(ui.add_enabled(why.is_none(), button), &name);
        if let Some(on) = on {
            let toggled = egui::accesskit::Toggled::from(on);
            ui.ctx()
                .accesskit_node_builder(item.id, |node| node.set_toggled(toggled));
        }
        tip_beside(&item, full_tooltip(entry, self.session, self.state), why);
        if menu_keys::is_chosen(ui, &item, false) {
            self.run(entry.command);
        }
        item
    }

    fn run(&mut self, command: Command) {
        let action = run(command, self.session, self.state, self.aspect);
        self.actions.extend(action);
    }
}

/// The items of a menu, which scroll if the window is too low for them.
fn scrolled(ui: &mut Ui, items: impl FnOnce(&mut Ui)) {
    let items = |ui: &mut Ui| menu_keys::level(ui, None, items);
    let row = ui.spacing().interact_size.y;
    let room = ui.ctx().content_rect().height() - MARGINS - row;
    if room > HIGHEST * (row + ui.spacing().item_spacing.y) {
        items(ui);
    } else {
        // A menu is as high as it was last, or as egui thinks that menus are.
        ui.set_max_height(room);
        ScrollArea::vertical().max_height(room).show(ui, items);
    }
}

/// A submenu, whose name for assistive technology is without the arrow.
fn submenu(ui: &mut Ui, label: &str, contents: impl FnOnce(&mut Ui)) {
    let button = menu_keys::submenu(ui, label, contents);
    named(button, label);
}
