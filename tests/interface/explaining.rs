//! The panel of View ▸ Explain Skinning.

use crate::interface::{Editor, figure};
use egui::{Key, Rect, vec2};

/// Texts on the same line as one that starts with `start`, from the left to the right.
fn line(editor: &Editor, start: &str) -> Vec<(String, Rect)> {
    let painted = editor.painted();
    let edge = editor.harness.state().view.right();
    let own = painted.iter().find(|(text, _)| text.starts_with(start));
    let middle = own.unwrap_or_else(|| panic!("no {start}")).1.center().y;
    let is_on_it = |(_, place): &&(String, Rect)| {
        (place.center().y - middle).abs() < 3.0 && place.left() < edge
    };
    let mut line: Vec<_> = painted.iter().filter(is_on_it).cloned().collect();
    line.sort_by(|a, b| a.1.left().total_cmp(&b.1.left()));
    line
}

#[test]
fn a_long_name_is_shortened_where_the_numbers_begin() {
    let mut editor = Editor::sized(vec2(1280.0, 800.0));
    let names: Vec<String> = (0..18)
        .map(|joint| format!("The joint that is called number {joint}"))
        .collect();
    let names: Vec<&str> = names.iter().map(|name| &**name).collect();
    editor.add_character(figure::figure_called(names[..].try_into().expect("18")));
    editor.key(Key::K);
    assert!(
        line(&editor, "The joi")
            .iter()
            .any(|(text, _)| text.contains('…'))
    );
    editor.click("Vertices are moved by T alone, without the inverse of B");
    for start in ["The joi", "v' should be here"] {
        let line = line(&editor, start);
        assert!(line.len() >= 4, "{line:?}");
        for pair in line.windows(2) {
            assert!(pair[0].1.right() <= pair[1].1.left(), "{pair:?}");
        }
    }
    assert!(
        line(&editor, "v' should be here")
            .iter()
            .all(|(text, _)| !text.contains('…'))
    );
}
