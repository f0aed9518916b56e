//! Questions that are asked before unsaved work is lost, and their texts.

use super::autosave::Kept;
use super::document::Next;
use super::exports::Together;
use super::files::{file_name, listed};
use crate::ui::{Answer, Question, scene_label};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Question that waits for its answer.
pub(super) enum Asked {
    /// There are unsaved changes.
    Unsaved(Next),
    /// The file was changed by another program since it was read or written here.
    Overwrite(PathBuf, Option<Next>),
    /// Files that are written together with the one that was chosen are there already.
    Replace(Together),
    /// An earlier run did not end in order, and left unsaved work, this long ago if that is known.
    Restore(Kept, Option<Duration>),
}

impl Asked {
    /// The question about a document called `name`.
    pub fn question(&self, name: &str) -> Question {
        match self {
            Self::Unsaved(next) => unsaved(next, name),
            Self::Overwrite(path, _) => Question {
                title: "Overwrite the file?".to_owned(),
                text: format!(
                    "Another program or window has changed {} since it was opened here. \
                     Overwriting replaces what it wrote.",
                    path.display()
                ),
                answers: vec![Answer::SaveAs, Answer::Overwrite, Answer::Cancel],
            },
            Self::Replace(together) => Question {
                title: "Replace these files, too?".to_owned(),
                text: replace_text(&together.path, &together.replaced),
                answers: vec![Answer::Overwrite, Answer::Cancel],
            },
            Self::Restore(kept, since) => Question {
                title: "Restore unsaved changes?".to_owned(),
                text: restore_text(kept.name().as_deref(), &kept.shape_names(), *since),
                answers: vec![Answer::Restore, Answer::Later, Answer::Forget],
            },
        }
    }
}

/// The question before `next` about unsaved changes of the document called `name`.
fn unsaved(next: &Next, name: &str) -> Question {
    let mut answers = vec![Answer::Save, Answer::Discard, Answer::Cancel];
    let loses = match next {
        Next::New => "begin another document".to_owned(),
        Next::Open | Next::OpenFiles(..) | Next::Show(_) => "open another document".to_owned(),
        Next::OpenBuiltin(name) => {
            // A digit is the key of some: one that was meant for a number, with Enter after it, must overwrite no file.
            answers.rotate_right(1);
            format!("open {}", scene_label(name).unwrap_or(name))
        }
        Next::Quit => "quit".to_owned(),
        // Saving would overwrite what is to come back.
        Next::Revert(..) => {
            return Question {
                title: "Go back to the file?".to_owned(),
                text: format!("What has changed since “{name}” was saved is lost then."),
                answers: vec![Answer::Cancel, Answer::Revert],
            };
        }
    };
    Question {
        title: "Save changes?".to_owned(),
        text: format!(
            "“{name}” has changes that are not saved. They are lost if you {loses} without saving."
        ),
        answers,
    }
}

/// Text of the question about files at `replaced` that are written with the one at `path`.
fn replace_text(path: &Path, replaced: &[PathBuf]) -> String {
    let folder = path.parent().unwrap_or(Path::new(""));
    let inner = |file: &PathBuf| {
        let inner = file.strip_prefix(folder).unwrap_or(file);
        inner.display().to_string()
    };
    let names: Vec<String> = replaced.iter().map(inner).collect();
    format!(
        "{} is written together with files that are there already, with other contents: {}.",
        file_name(path),
        listed(&names),
    )
}

/// Text of the question about what an earlier run left of the document of this name, or else of one with shapes of
/// these names, `since` then.
fn restore_text(name: Option<&str>, shapes: &[String], since: Option<Duration>) -> String {
    let ended = match name {
        Some(name) => format!("The editor ended before changes to {name} were saved."),
        None if shapes.is_empty() => "The editor ended before a new document was saved.".to_owned(),
        None => {
            let names = listed(shapes);
            format!("The editor ended before a new document was saved: one with {names}.")
        }
    };
    match since {
        Some(since) => format!("{ended} The changes were kept {}.", ago(since)),
        None => ended,
    }
}

/// A time in the past, in words.
fn ago(since: Duration) -> String {
    let minutes = since.as_secs() / 60;
    let (count, unit) = match minutes {
        0 => return "less than a minute ago".to_owned(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {unit}{plural} ago")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_since_work_was_kept_is_told_in_the_largest_unit_that_fits() {
        for (seconds, words) in [
            (0, "less than a minute ago"),
            (59, "less than a minute ago"),
            (60, "1 minute ago"),
            (185, "3 minutes ago"),
            (3600, "1 hour ago"),
            (86_399, "23 hours ago"),
            (200_000, "2 days ago"),
        ] {
            assert_eq!(ago(Duration::from_secs(seconds)), words);
        }
        let told = restore_text(Some("a.scene"), &[], Some(Duration::from_secs(185)));
        assert!(told.ends_with("a.scene were saved. The changes were kept 3 minutes ago."));
        assert!(!restore_text(None, &[], None).contains("kept"));
        let names = ["Robot", "Cube", "Ball", "Head", "Dog"].map(str::to_owned);
        for (count, words) in [
            (1, "with Robot."),
            (2, "with Robot, Cube."),
            (5, "with Robot, Cube, Ball and 2 more."),
        ] {
            let told = restore_text(None, &names[..count], None);
            assert!(told.ends_with(words), "{told}");
        }
    }
}
