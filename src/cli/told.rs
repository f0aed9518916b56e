use crate::io::Diagnostic;
use serde::Serialize;

/// A mistake, or what is odd, as `--json` prints it: with its place in parts, for a script to
/// read without cutting a sentence up.
#[derive(Debug, Serialize)]
pub struct Told {
    /// None where no single file is at fault.
    pub file: Option<String>,
    /// Counted from 1, as the column is; none for the file as a whole.
    pub line: Option<usize>,
    /// See [`Told::line`].
    pub column: Option<usize>,
    /// What is wrong, without the place.
    pub message: String,
    /// The same in one line, for people.
    #[serde(skip)]
    pub in_words: String,
}

impl Told {
    /// What is wrong with no file to name.
    pub fn without_file(message: String) -> Self {
        Self {
            file: None,
            line: None,
            column: None,
            in_words: message.clone(),
            message,
        }
    }
}

impl From<&Diagnostic> for Told {
    fn from(told: &Diagnostic) -> Self {
        Self {
            file: Some(told.path.display().to_string()),
            line: told.position.map(|position| position.line),
            column: told.position.map(|position| position.column),
            message: told.message.clone(),
            in_words: told.to_string(),
        }
    }
}
