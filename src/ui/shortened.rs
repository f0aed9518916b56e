//! Names that are longer than the room for them.

use egui::{Color32, FontId, Ui};

/// Width of `text` in one line, in points.
pub(super) fn text_width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    ui.painter()
        .layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE)
        .size()
        .x
}

/// `text`, or as much of its beginning and end as fits into `room` points, with a mark between
/// them: joints of one name differ at its end.
pub(super) fn shortened(ui: &Ui, text: &str, font: &FontId, room: f32) -> String {
    if text_width(ui, text, font) <= room {
        return text.to_owned();
    }
    shortened_to(text, |text| text_width(ui, text, font) <= room)
}

fn shortened_to(text: &str, fits: impl Fn(&str) -> bool) -> String {
    let letters: Vec<char> = text.chars().collect();
    let with = |kept: usize| -> String {
        let start = kept.div_ceil(2);
        let end = letters.len() - kept / 2;
        let (start, end) = (letters[..start].iter(), letters[end..].iter());
        start.chain(&['…']).chain(end).collect()
    };
    // Less is never wider. Names may be of any length, so that not every one is tried.
    let (mut fitting, mut too_long) = (0, letters.len());
    while fitting + 1 < too_long {
        let middle = fitting.midpoint(too_long);
        if fits(&with(middle)) {
            fitting = middle;
        } else {
            too_long = middle;
        }
    }
    with(fitting)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_too_long_keeps_its_beginning_and_its_end() {
        let up_to = |count: usize| move |text: &str| text.chars().count() <= count;
        assert_eq!(shortened_to("RightToeBase_End", up_to(9)), "Righ…_End");
        assert_eq!(shortened_to("RightToeBase_End", up_to(1)), "…");
        assert_eq!(shortened_to("é", up_to(0)), "…");
    }
}
