/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Something was done.
    Info,
    /// Something was odd.
    Warning,
    /// Something failed, and nothing was changed.
    Error,
}

/// Something told to the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// How serious it is.
    pub severity: Severity,
    /// In plain words.
    pub text: String,
}

/// Everything told to the user, oldest first; the newest is shown in the status line.
#[derive(Clone, Debug, Default)]
pub struct Messages {
    history: Vec<Message>,
    dismissed: usize,
}

/// Older messages than this are forgotten.
const KEPT: usize = 500;

impl Messages {
    /// Tells something.
    pub fn tell(&mut self, severity: Severity, text: impl Into<String>) {
        if self.history.len() == KEPT {
            self.history.remove(0);
            self.dismissed = self.dismissed.saturating_sub(1);
        }
        self.history.push(Message {
            severity,
            text: text.into(),
        });
    }

    /// Everything told, oldest first.
    pub fn history(&self) -> &[Message] {
        &self.history
    }

    /// What was told since the last [`Messages::dismiss`], oldest first.
    pub fn fresh(&self) -> &[Message] {
        &self.history[self.dismissed..]
    }

    /// Takes the fresh messages from the view; the history keeps them.
    pub fn dismiss(&mut self) {
        self.dismissed = self.history.len();
    }
}
