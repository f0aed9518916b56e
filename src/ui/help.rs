use super::Navigation;
use super::keys::{GESTURES, Menu, entries};
use super::theme::Palette;
use egui::{Grid, RichText, ScrollArea, Ui};

/// Help ▸ Keys and Mouse, straight from the table of commands.
pub(super) fn show(ui: &mut Ui, navigation: Navigation) {
    let context = ui.ctx().clone();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        heading(ui, "Mouse");
        table("gestures").show(ui, |ui| {
            for gesture in navigation.gestures().chain(GESTURES) {
                ui.label(key(ui, gesture.gesture));
                ui.label(gesture.does);
                ui.end_row();
            }
        });
        for &menu in Menu::ALL {
            let mut entries = entries(menu)
                .map(|entry| (entry.keys(&context, navigation), entry))
                .filter(|(keys, _)| !keys.is_empty())
                .peekable();
            if entries.peek().is_none() {
                continue;
            }
            heading(ui, title(menu));
            table(title(menu)).show(ui, |ui| {
                for (keys, entry) in entries {
                    ui.label(key(ui, &keys));
                    ui.label(entry.label).on_hover_text(entry.tooltip);
                    ui.end_row();
                }
            });
        }
    });
}

fn table(id: &str) -> Grid {
    Grid::new(id)
        .num_columns(2)
        .min_col_width(176.0)
        .spacing([8.0, 4.0])
}

fn title(menu: Menu) -> &'static str {
    match menu {
        Menu::File => "File",
        Menu::Scenes => "File ⏵ Built-in Scene",
        Menu::Insert => "Insert",
        Menu::Curves => "Insert, curves",
        Menu::Import => "Insert ⏵ Import",
        Menu::Shape => "Selected shape",
        Menu::View => "View",
        Menu::Look => "View ⏵ Look",
        Menu::Shading => "View ⏵ Shading",
        Menu::Ground => "View ⏵ Ground",
        Menu::Compare => "View ⏵ Compare",
        Menu::Navigation => "View ⏵ Navigation",
        Menu::Theme => "View ⏵ Theme",
        Menu::Skinning => "View ⏵ Skinning",
        Menu::Tools => "Pose",
        Menu::Pose => "Pose, selected character",
        Menu::Help => "Help",
    }
}

fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    let color = Palette::of(ui.visuals()).strong;
    ui.label(RichText::new(text).color(color));
}

fn key(ui: &Ui, text: &str) -> RichText {
    RichText::new(text).color(Palette::of(ui.visuals()).accent)
}
