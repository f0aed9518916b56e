//! The dialog of a question that has to be answered before anything else.

use super::{Action, Answer, Ask, Question};
use egui::{Align, Button, Frame, Id, Key, Layout, Modal, Modifiers, RichText, Ui, vec2};

/// Width of the text in points, in windows that have room for it.
const WIDTH: f32 = 400.0;

/// Shows the question; Enter gives the first answer, which stands out, Esc cancels, or else puts it off.
pub(super) fn show(root: &Ui, question: &Question, actions: &mut Vec<Action>) {
    let frame = Frame::popup(root.style()).inner_margin(16);
    let modal = Modal::new(Id::new("question")).frame(frame);
    let modal = modal.show(root.ctx(), |ui| {
        let room = ui.ctx().content_rect().width() - 64.0;
        ui.set_width(WIDTH.min(room));
        ui.heading(&question.title);
        ui.add_space(4.0);
        ui.label(&question.text);
        ui.add_space(12.0);
        buttons(ui, &question.answers)
    });
    let is_offered = |answer: &Answer| question.answers.contains(answer);
    let closes = modal.should_close();
    // A click beside it may not have been meant for it.
    let puts_off = closes && !modal.backdrop_response.clicked();
    let cancel = Some(Answer::Cancel).filter(|_| closes).filter(is_offered);
    let later = Some(Answer::Later).filter(|_| puts_off).filter(is_offered);
    let answer = modal.inner.or(cancel).or(later);
    actions.extend(answer.map(|answer| Action::Ask(Ask::Answer(answer))));
}

/// One button an answer, the first at the right, as in the file dialog; the answer that was given.
fn buttons(ui: &mut Ui, answers: &[Answer]) -> Option<Answer> {
    let elsewhere = ui.memory(|memory| memory.focused().is_some());
    // A button that has the keyboard is pressed by Enter itself.
    let enter = !elsewhere && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    let mut given = answers.first().copied().filter(|_| enter);
    let line = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let layout = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(line, layout, |ui| {
        for (index, &answer) in answers.iter().enumerate() {
            let is_first = index == 0;
            let id = ui.next_auto_id();
            let is_given_by_enter = match elsewhere {
                true => ui.memory(|memory| memory.has_focus(id)),
                false => is_first,
            };
            let strong = ui.visuals().selection;
            let button = match is_given_by_enter {
                true => Button::new(RichText::new(answer.label()).color(strong.stroke.color))
                    .fill(strong.bg_fill),
                false => Button::new(answer.label()),
            };
            let button = ui.add(button);
            // Tab leads on from the one that Enter gives.
            if is_first && !elsewhere {
                button.request_focus();
            }
            // The second click of a double one was not meant for the next question.
            if button.clicked() && !button.double_clicked() {
                given = Some(answer);
            }
        }
    });
    given
}
