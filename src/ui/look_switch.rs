use super::commands::{self, Command};
use super::theme::Palette;
use super::widgets::named;
use super::{Action, axis_ball};
use crate::editor::View;
use crate::scene::Look;
use egui::{Button, Frame, Margin, Pos2, Rect, RichText, Sense, Ui, UiBuilder, pos2, vec2};

/// The looks, with their words in the switch and their names.
const LOOKS: [(Look, &str, &str); 3] = [
    (Look::Course, "Course", "Course look"),
    (Look::Studio, "Studio", "Studio look"),
    (Look::Mannequin, "Mannequin", "Mannequin look"),
];
/// Width and height, in points.
const SIZE: egui::Vec2 = vec2(184.0, 24.0);
/// Views smaller than this, in points, have no switch, which would lie over their figures.
const ROOM: egui::Vec2 = vec2(320.0, 380.0);

/// What it takes up together with the axis ball above it, to the upper right corner of the `view`, if there is room for it.
pub(super) fn corner(view: Rect) -> Option<Rect> {
    let has_room = view.size().min(ROOM) == ROOM;
    has_room.then(|| {
        let left_bottom = left_top(view) + vec2(0.0, SIZE.y);
        Rect::from_two_pos(left_bottom, view.right_top())
    })
}

fn left_top(view: Rect) -> Pos2 {
    pos2(view.right() - SIZE.x - 8.0, axis_ball::bottom(view) + 4.0)
}

/// The switch between the looks, below the axis ball.
pub(super) fn show(ui: &mut Ui, view: Rect, look: Look, actions: &mut Vec<Action>) {
    if corner(view).is_none() {
        return;
    }
    let place = Rect::from_min_size(left_top(view), SIZE);
    // Clicks between the buttons must not reach the scene behind them.
    let builder = UiBuilder::new()
        .id_salt("looks")
        .max_rect(place)
        .sense(Sense::click_and_drag());
    let mut inner = ui.new_child(builder);
    let frame = Frame::new()
        .fill(Palette::of(inner.visuals()).panel)
        .corner_radius(4)
        .inner_margin(Margin::same(2));
    frame.show(&mut inner, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            for (own, word, name) in LOOKS {
                let button = Button::selectable(look == own, RichText::new(word).small());
                let button = named(ui.add(button), name);
                let tip = commands::tooltip(ui.ctx(), Command::SetLook(own));
                if button.on_hover_text(tip).clicked() {
                    actions.push(Action::View(View::ChooseLook(own)));
                }
            }
        });
    });
}
