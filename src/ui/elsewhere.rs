//! What people search for among the commands and what is elsewhere: in a panel, in a terminal, or nowhere.

/// Words that people search for, and where that is.
const ELSEWHERE: &[(&[&str], &str)] = &[
    (
        &["submit", "submission", "hand in", "turn in", "homework"],
        "The program packs what is handed in when it is called in a terminal: editor submit --help. \
         Screenshot… saves the picture for it.",
    ),
    (
        &["grade", "grading"],
        "The program grades a class when it is called in a terminal: editor grade --help",
    ),
    (
        &["slider", "angle", "joint list"],
        "The panel at the right has the sliders of the joints while a character is selected.",
    ),
    (
        &["wireframe"],
        "Surface Visibility in the panel shows surfaces of curves as a wireframe. Other meshes have none: \
         flat shading shows their triangles.",
    ),
    (
        &["skeleton", "stick figure", "transparency", "x-ray", "xray"],
        "Model Display Mode in the panel shows the skeleton of the selected character.",
    ),
    (
        &["color", "colour", "material"],
        "The panel at the right has the color of the selected shape.",
    ),
    (
        &["orthographic", "perspective", "parallel projection"],
        "The camera is always in perspective.",
    ),
    (
        &[
            "apply transform",
            "apply scale",
            "apply rotation",
            "apply location",
        ],
        "A transform stays with its shape as numbers in the panel. Export writes shapes as they stand.",
    ),
    (
        &["paint", "vertex group"],
        "Weights come with the file of a character: they are shown, by Colors, and not painted.",
    ),
    (
        &["parent", "unparent"],
        "Shapes have no parents: those that are selected together move together.",
    ),
    (
        &["keyframe", "timeline", "animation"],
        "Poses are kept one by one, without an animation between them. Screenshot… saves a turntable.",
    ),
];

/// Words that mean something else where no more follows.
const MORE_FOLLOWS: [&str; 2] = ["turn", "hand"];

/// Fewest letters that say what is searched for.
const FEWEST: usize = 4;

/// Where that is what `searched` begins to say or has in it, if that is no command or not only one.
pub(super) fn elsewhere(searched: &str) -> Option<&'static str> {
    let searched = searched.trim().to_lowercase();
    if searched.chars().count() < FEWEST || MORE_FOLLOWS.contains(&&*searched) {
        return None;
    }
    // At the beginning of a word: "rectangle" has another one in it.
    let words = format!(" {searched}");
    let is_meant = |word: &&str| word.starts_with(&searched) || words.contains(&format!(" {word}"));
    let mut all = ELSEWHERE.iter();
    let found = all.find(|(words, _)| words.iter().any(is_meant))?;
    Some(found.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_command_is_found_by_the_beginning_of_its_word_or_in_a_sentence() {
        for searched in ["subm", "Submit", "how do I hand in", "turn in "] {
            let found = elsewhere(searched).unwrap_or_else(|| panic!("{searched}"));
            assert!(found.contains("editor submit"), "{found}");
        }
        assert_eq!(elsewhere("sub"), None, "as subdivide begins");
        assert_eq!(elsewhere("turn"), None, "a joint, or the view");
        assert_eq!(elsewhere(""), None);
        for searched in ["teapot", "rectangle", "triangle", "control point"] {
            assert_eq!(elsewhere(searched), None, "{searched}");
        }
    }

    #[test]
    fn no_word_is_in_two_places() {
        for (words, told) in ELSEWHERE {
            for word in *words {
                assert_eq!(elsewhere(word), Some(*told), "{word}");
            }
        }
    }
}
