//! The matrix stack step by step: buttons, the tree of the joints, and the stack beside it.

use super::digits::Digits;
use super::steps::{StackStep, Stepper, stack_after, steps_of};
use super::{Explained, matrices};
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use egui::{
    Button, Label, RichText, ScrollArea, Sense, TextStyle, Ui, UiBuilder, WidgetInfo, WidgetType,
    pos2, vec2,
};
use std::collections::BTreeSet;
use std::time::Duration;

/// Width of the tree, in points.
const TREE: f32 = 200.0;
const ROW: f32 = 18.0;
const INDENT: f32 = 12.0;

/// Shows the stack after the steps that are done.
pub(super) fn show(ui: &mut Ui, explained: &Explained, stepper: &mut Stepper, digits: Digits) {
    let skeleton = explained.shape.character.skeleton();
    let steps = steps_of(skeleton);
    let before = stepper.done;
    buttons(ui, stepper, steps.len());
    let now = ui.input(|input| input.time);
    stepper.advance(&steps, now);
    if let Some(wait) = stepper.wait(now) {
        ui.ctx()
            .request_repaint_after(Duration::from_secs_f64(wait));
    }
    let done = &steps[..stepper.done];
    let words = match done.last() {
        None => "Nothing is pushed yet: top() of an empty stack is the identity".to_owned(),
        Some(_) if done.len() == steps.len() => {
            "Every joint is drawn, and the stack is empty again".to_owned()
        }
        Some(step) => step.words(skeleton),
    };
    let text = format!("Step {} of {}: {words}", done.len(), steps.len());
    ui.add(Label::new(text).wrap());
    ui.add_space(2.0);
    let room = ui.available_rect_before_wrap();
    let (left, right) = room.split_left_right_at_x(room.left() + TREE.min(room.width() * 0.4));
    let moved = before != stepper.done;
    ui.scope_builder(UiBuilder::new().max_rect(left), |ui| {
        ScrollArea::vertical()
            .id_salt("tree")
            .auto_shrink(false)
            .show(ui, |ui| {
                tree(ui, explained, done, moved);
            });
    });
    let right = right.with_min_x(right.left() + 8.0);
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| {
        let area = ScrollArea::both().id_salt("stack").auto_shrink(false);
        area.stick_to_right(true).show(ui, |ui| {
            ui.horizontal_top(|ui| entries(ui, explained, done, digits));
        });
    });
}

fn buttons(ui: &mut Ui, stepper: &mut Stepper, count: usize) {
    ui.horizontal_wrapped(|ui| {
        let mut button = |label: &str, enabled: bool, tip: &str| {
            let button = ui.add_enabled(enabled, Button::new(label));
            button.on_hover_text(tip).clicked()
        };
        let (has_done, has_more) = (stepper.done > 0, stepper.done < count);
        if button("Step", has_more, "Do the next step") {
            (stepper.done, stepper.plays) = (stepper.done + 1, false);
        }
        if button("Back", has_done, "Take back the last step") {
            (stepper.done, stepper.plays) = (stepper.done - 1, false);
        }
        let play = if stepper.plays { "Pause" } else { "Play" };
        if button(play, has_more, "One step after the other") {
            stepper.plays = !stepper.plays;
        }
        if button("To Start", has_done, "Begin with an empty stack") {
            (stepper.done, stepper.plays) = (0, false);
        }
    });
}

/// The joints as a tree: those on the stack stand out, a dot is before those that have been drawn. If a
/// step has `moved` on, its joint scrolls into sight, or the first one before any step.
fn tree(ui: &mut Ui, explained: &Explained, done: &[StackStep], moved: bool) {
    let skeleton = explained.shape.character.skeleton();
    let palette = Palette::of(ui.visuals());
    let drawn: BTreeSet<usize> = done
        .iter()
        .filter(|step| matches!(step, StackStep::Draw(_)))
        .map(|step| step.joint())
        .collect();
    let stack = stack_after(done, skeleton, explained.shape.pose());
    let on_stack: BTreeSet<usize> = stack.iter().map(|&(joint, _)| joint).collect();
    let lit = done.last().map(|step| step.joint());
    let steps = steps_of(skeleton);
    let in_sight = lit.or_else(|| Some(steps.first()?.joint()));
    let mut depth = 0;
    for step in steps {
        let joint = match step {
            StackStep::Push(joint) => joint,
            StackStep::Draw(_) => continue,
            StackStep::Pop(_) => {
                depth -= 1;
                continue;
            }
        };
        let (rect, row) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
        let is_lit = lit == Some(joint);
        if is_lit {
            ui.painter().rect_filled(rect, 3.0, palette.selection);
        }
        if moved && in_sight == Some(joint) {
            row.scroll_to_me(None);
        }
        let color = match (is_lit, on_stack.contains(&joint)) {
            (true, _) => palette.on_selection,
            (false, true) => palette.strong,
            (false, false) => palette.weak,
        };
        let left = rect.left() + 6.0 + INDENT * depth as f32;
        let dot = pos2(left, rect.center().y);
        if drawn.contains(&joint) {
            ui.painter().circle_filled(dot, 3.0, color);
        } else {
            ui.painter()
                .circle_stroke(dot, 3.0, egui::Stroke::new(1.0, color));
        }
        let name = &skeleton.joints()[joint].name;
        let font = TextStyle::Small.resolve(ui.style());
        let at = pos2(left + 8.0, rect.center().y);
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        painter.text(at, egui::Align2::LEFT_CENTER, name, font, color);
        let state = match (on_stack.contains(&joint), drawn.contains(&joint)) {
            (true, _) => "on the stack",
            (false, true) => "drawn",
            (false, false) => "not yet",
        };
        let called = format!("{name}, {state}");
        row.widget_info(|| WidgetInfo::selected(WidgetType::Other, true, is_lit, &called));
        depth += 1;
    }
}

/// The stack from the bottom at the left to the top at the right. After a push the joint's own
/// transform stands before the product.
fn entries(ui: &mut Ui, explained: &Explained, done: &[StackStep], digits: Digits) {
    let (skeleton, pose) = (explained.shape.character.skeleton(), explained.shape.pose());
    let stack = stack_after(done, skeleton, pose);
    let weak = Palette::of(ui.visuals()).weak;
    if stack.is_empty() {
        ui.label(RichText::new("The stack is empty.").color(weak));
    }
    for (index, (joint, matrix)) in stack.iter().enumerate() {
        let name = &skeleton.joints()[*joint].name;
        let is_top = index + 1 == stack.len();
        if is_top && matches!(done.last(), Some(StackStep::Push(_))) {
            let own = skeleton.parent_from_joint(*joint, pose).as_dmat4();
            ui.label(RichText::new("·").heading());
            let called = format!("Own transform of {name}");
            matrices::show(
                ui,
                RichText::new(format!("{name}, own")).small(),
                &called,
                &own,
                digits,
                false,
            );
            ui.label(RichText::new("=").heading());
        }
        let (title, called) = if is_top {
            (format!("Top: {name}"), format!("Top of the stack, {name}"))
        } else {
            (name.clone(), format!("On the stack, {name}"))
        };
        matrices::show(
            ui,
            RichText::new(title).small(),
            &called,
            &matrix.as_dmat4(),
            digits,
            is_top,
        );
    }
    // Scrolled to the top of the stack, which is where it changes.
    named(ui.label(""), "End of the stack");
}
