use super::CompareView;
use super::settings::{course_panels, mannequin_panels};
use crate::compare::Area as Mask;
use crate::scene::Look;
use crate::ui::ScenePlaces;
use crate::ui::number_field::NumberField;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use egui::{
    Align2, Button, Color32, CursorIcon, FontId, Id, Rect, Sense, Stroke, StrokeKind, Ui, Vec2,
    pos2, vec2,
};

/// More would be a picture of their own.
const MOST: usize = 32;
/// How far from an edge it can be taken hold of, in points.
const GRIP: f32 = 4.0;
/// The label that a mask is moved by, in points.
const LABEL: Vec2 = vec2(56.0, 18.0);

/// What adds masks, and takes those of panels away again.
pub(super) fn buttons(ui: &mut Ui, compare: &CompareView<'_>, look: Look, masks: &mut Vec<Mask>) {
    let size = compare.size();
    let room = masks.len() < MOST;
    let (panels, whose) = match look {
        Look::Mannequin => (
            mannequin_panels(size).to_vec(),
            "Leave out what the keyframes of the Virtual Mannequin cover in a screenshot of its window",
        ),
        Look::Course | Look::Studio => (
            course_panels(size).to_vec(),
            "Leave out what the panels of the course's editor cover in a screenshot of its window",
        ),
    };
    let masked = panels.iter().all(|panel| masks.contains(panel));
    let full = "There are as many masks as can be";
    if masked {
        // The next picture may have no panels.
        let unmask = ui.button("Unmask its panels");
        if unmask.on_hover_text("Remove these masks").clicked() {
            masks.retain(|mask| !panels.contains(mask));
        }
    } else {
        let gone = if compare.is_cut {
            "They are cut off"
        } else {
            full
        };
        let mask = ui
            .add_enabled(room && !compare.is_cut, Button::new("Mask its panels"))
            .on_hover_text(whose)
            .on_disabled_hover_text(gone);
        if mask.clicked() {
            let new = panels.iter().filter(|panel| !masks.contains(panel));
            let new: Vec<Mask> = new.copied().collect();
            masks.extend(new);
        }
    }
    let add = ui
        .add_enabled(room, Button::new("Add mask"))
        .on_hover_text("Leave out a part of the pictures; drag its edges in the view")
        .on_disabled_hover_text(full);
    if add.clicked() {
        masks.push(Mask::in_the_middle(size));
    }
}

/// The numbers of each mask.
pub(super) fn list(ui: &mut Ui, size: (u32, u32), masks: &mut Vec<Mask>) {
    let mut removed = None;
    for (index, mask) in masks.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            let name = format!("Mask {}", index + 1);
            ui.label(&name)
                .on_hover_text("First column and row, width × height, in pixels");
            let mut edited = *mask;
            // What moves it keeps its size.
            let farthest = (
                size.0.saturating_sub(mask.width),
                size.1.saturating_sub(mask.height),
            );
            let sides = [
                ("", "X", &mut edited.x, farthest.0),
                (",", "Y", &mut edited.y, farthest.1),
                ("·", "width", &mut edited.width, size.0),
                ("×", "height", &mut edited.height, size.1),
            ];
            for (before, side, value, most) in sides {
                ui.label(before);
                number(ui, &format!("{name} {side}"), value, most);
            }
            *mask = edited.inside(size);
            let remove = named(
                ui.add(Button::new("×")),
                &format!("Remove mask {}", index + 1),
            );
            if remove.on_hover_text("Remove this mask").clicked() {
                removed = Some(index);
            }
        });
    }
    if let Some(index) = removed {
        masks.remove(index);
    }
}

fn number(ui: &mut Ui, name: &str, value: &mut u32, most: u32) {
    let field = NumberField::new(name, *value as f32, 1.0)
        .rest(*value as f32)
        .range(0.0..=f64::from(most))
        .decimals(0..=0);
    if let Some(given) = field.show(ui, vec2(44.0, 20.0)) {
        *value = given.round().max(0.0) as u32;
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    Left,
    Right,
    Top,
    Bottom,
}

impl Edge {
    const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Top, Self::Bottom];

    fn strip(self, rect: Rect) -> Rect {
        let (min, max) = (rect.min, rect.max);
        let line = match self {
            Self::Left => Rect::from_min_max(min, pos2(min.x, max.y)),
            Self::Right => Rect::from_min_max(pos2(max.x, min.y), max),
            Self::Top => Rect::from_min_max(min, pos2(max.x, min.y)),
            Self::Bottom => Rect::from_min_max(pos2(min.x, max.y), max),
        };
        line.expand(GRIP)
    }

    fn cursor(self) -> CursorIcon {
        match self {
            Self::Left | Self::Right => CursorIcon::ResizeHorizontal,
            Self::Top | Self::Bottom => CursorIcon::ResizeVertical,
        }
    }
}

/// The masks over the pictures. Their edges and labels can be dragged; all else in them is still
/// the view's.
pub(super) fn show_over(ui: &mut Ui, places: &ScenePlaces, size: (u32, u32), masks: &mut [Mask]) {
    for (p, &place) in places.rects.iter().enumerate() {
        for (index, mask) in masks.iter_mut().enumerate() {
            let rect = shown(*mask, place, places.points_per_pixel);
            paint(ui, rect, index);
            let id = ui.id().with(("mask", p, index));
            edges(ui, id, rect, place, size, mask);
            label(ui, id, rect, size, places.points_per_pixel, index, mask);
        }
    }
}

/// Where an area of pixels lies in a picture that is shown in `place`.
pub(super) fn shown(mask: Mask, place: Rect, points_per_pixel: f32) -> Rect {
    let corner = vec2(mask.x as f32, mask.y as f32) * points_per_pixel;
    let size = vec2(mask.width as f32, mask.height as f32) * points_per_pixel;
    Rect::from_min_size(place.min + corner, size).intersect(place)
}

fn paint(ui: &Ui, rect: Rect, index: usize) {
    let painter = ui.painter();
    painter.rect_filled(rect, 0, Color32::from_black_alpha(150));
    painter.rect_stroke(
        rect,
        0,
        Stroke::new(1.0, Palette::of(ui.visuals()).accent),
        StrokeKind::Inside,
    );
    let middle = rect.top() + LABEL.y.min(rect.height()) * 0.5;
    painter.with_clip_rect(rect.intersect(ui.clip_rect())).text(
        pos2(rect.left() + 6.0, middle),
        Align2::LEFT_CENTER,
        format!("Mask {}", index + 1),
        FontId::proportional(rect.height().clamp(8.0, 12.0)),
        Color32::WHITE,
    );
}

fn edges(ui: &Ui, id: Id, rect: Rect, place: Rect, size: (u32, u32), mask: &mut Mask) {
    for (e, edge) in Edge::ALL.into_iter().enumerate() {
        let grip = ui
            .interact(edge.strip(rect), id.with(e), Sense::drag())
            .on_hover_and_drag_cursor(edge.cursor());
        let Some(pointer) = grip.interact_pointer_pos().filter(|_| grip.dragged()) else {
            continue;
        };
        let along = (pointer - place.min) / place.size();
        let to = match edge {
            Edge::Left | Edge::Right => along.x * size.0 as f32,
            Edge::Top | Edge::Bottom => along.y * size.1 as f32,
        };
        *mask = with_edge(*mask, edge, to.round().max(0.0) as u32).inside(size);
    }
}

/// `mask` with one edge on column or row `to`, the others where they were.
fn with_edge(mask: Mask, edge: Edge, to: u32) -> Mask {
    let right = mask.x.saturating_add(mask.width);
    let bottom = mask.y.saturating_add(mask.height);
    match edge {
        Edge::Left => {
            let x = to.min(right.saturating_sub(1));
            let width = right - x;
            Mask { x, width, ..mask }
        }
        Edge::Top => {
            let y = to.min(bottom.saturating_sub(1));
            let height = bottom - y;
            Mask { y, height, ..mask }
        }
        Edge::Right => Mask {
            width: to.saturating_sub(mask.x).max(1),
            ..mask
        },
        Edge::Bottom => Mask {
            height: to.saturating_sub(mask.y).max(1),
            ..mask
        },
    }
}

/// The label, by which the mask is moved.
fn label(
    ui: &Ui,
    id: Id,
    rect: Rect,
    size: (u32, u32),
    points_per_pixel: f32,
    index: usize,
    mask: &mut Mask,
) {
    let handle = Rect::from_min_size(rect.min, LABEL.min(rect.size())).shrink(GRIP);
    if !handle.is_positive() {
        return;
    }
    let start = id.with("before the drag");
    let grip = ui
        .interact(handle, id.with("move"), Sense::drag())
        .on_hover_and_drag_cursor(CursorIcon::Move);
    let grip = named(grip, &format!("Move mask {}", index + 1));
    if grip.drag_started() {
        ui.data_mut(|data| data.insert_temp(start, *mask));
    }
    let Some(moved) = grip.total_drag_delta().filter(|_| grip.dragged()) else {
        return;
    };
    let before: Mask = ui.data(|data| data.get_temp(start)).unwrap_or(*mask);
    *mask = moved_by(before, moved / points_per_pixel, size);
}

/// `mask` moved by so many pixels, but not out of the picture.
fn moved_by(mask: Mask, by: Vec2, size: (u32, u32)) -> Mask {
    let along = |from: u32, by: f32, length: u32, side: u32| {
        let farthest = side.saturating_sub(length) as f32;
        (from as f32 + by.round()).clamp(0.0, farthest) as u32
    };
    Mask {
        x: along(mask.x, by.x, mask.width, size.0),
        y: along(mask.y, by.y, mask.height, size.1),
        ..mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MASK: Mask = Mask {
        x: 10,
        y: 20,
        width: 30,
        height: 40,
    };

    #[test]
    fn an_edge_moves_alone_and_never_past_the_other() {
        let moved = |edge, to| with_edge(MASK, edge, to);
        assert_eq!(
            moved(Edge::Left, 15),
            Mask {
                x: 15,
                width: 25,
                ..MASK
            }
        );
        assert_eq!(
            moved(Edge::Left, 99),
            Mask {
                x: 39,
                width: 1,
                ..MASK
            }
        );
        assert_eq!(
            moved(Edge::Top, 0),
            Mask {
                y: 0,
                height: 60,
                ..MASK
            }
        );
        assert_eq!(moved(Edge::Right, 45), Mask { width: 35, ..MASK });
        assert_eq!(moved(Edge::Right, 3), Mask { width: 1, ..MASK });
        assert_eq!(moved(Edge::Bottom, 21), Mask { height: 1, ..MASK });
    }

    #[test]
    fn a_mask_is_moved_within_the_picture() {
        let to = |x, y| moved_by(MASK, vec2(x, y), (80, 60));
        assert_eq!(
            to(3.4, -2.6),
            Mask {
                x: 13,
                y: 17,
                ..MASK
            }
        );
        assert_eq!(
            to(-500.0, 500.0),
            Mask {
                x: 0,
                y: 20,
                ..MASK
            }
        );
    }

    #[test]
    fn a_mask_is_shown_at_the_scale_of_the_picture() {
        let place = Rect::from_min_size(pos2(5.0, 6.0), vec2(40.0, 30.0));
        let rect = shown(MASK, place, 0.5);
        assert_eq!(
            rect,
            Rect::from_min_size(pos2(10.0, 16.0), vec2(15.0, 20.0))
        );
    }
}
