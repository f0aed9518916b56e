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

/// Everything told to the user, oldest first.
#[derive(Clone, Debug, Default)]
pub struct Messages {
    history: Vec<Message>,
    fresh: Vec<Message>,
}

/// Older messages than this are forgotten.
const KEPT: usize = 500;

impl Messages {
    /// Tells something.
    pub fn tell(&mut self, severity: Severity, text: impl Into<String>) {
        let message = Message {
            severity,
            text: text.into(),
        };
        for list in [&mut self.history, &mut self.fresh] {
            if list.len() == KEPT {
                list.remove(0);
            }
            list.push(message.clone());
        }
    }

    /// Everything told, oldest first.
    pub fn history(&self) -> &[Message] {
        &self.history
    }

    /// What was told and not yet dismissed, oldest first.
    pub fn fresh(&self) -> &[Message] {
        &self.fresh
    }

    /// Takes the fresh message at `index` from the view; the history keeps it.
    pub fn dismiss(&mut self, index: usize) {
        if index < self.fresh.len() {
            self.fresh.remove(index);
        }
    }

    /// Takes all fresh messages from the view; the history keeps them.
    pub fn dismiss_all(&mut self) {
        self.fresh.clear();
    }
}
