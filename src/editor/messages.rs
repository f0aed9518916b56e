use std::ops::Range;

/// Severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Something was done.
    Info,
    /// Something is unusual or was left out.
    Warning,
    /// Something failed, and nothing was changed.
    Error,
}

/// Message to the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// Severity.
    pub severity: Severity,
    /// Text, in plain words.
    pub text: String,
    /// Number of messages before it since the start.
    pub number: u64,
}

/// Messages to the user, oldest first.
#[derive(Clone, Debug, Default)]
pub struct Messages {
    history: Vec<Message>,
    fresh: Vec<Message>,
    count: u64,
}

/// Number of messages that are kept.
const KEPT: usize = 500;

impl Messages {
    /// Appends a message. Of the fresh ones that say the same only the newest stays.
    pub fn tell(&mut self, severity: Severity, text: impl Into<String>) {
        let message = Message {
            severity,
            text: text.into(),
            number: self.count,
        };
        self.count += 1;
        self.fresh
            .retain(|fresh| (fresh.severity, &fresh.text) != (message.severity, &message.text));
        for list in [&mut self.history, &mut self.fresh] {
            if list.len() == KEPT {
                list.remove(0);
            }
            list.push(message.clone());
        }
    }

    /// Number of messages since the start, those that are not kept any more included.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Recent messages, oldest first.
    pub fn history(&self) -> &[Message] {
        &self.history
    }

    /// Messages that have not been dismissed, oldest first.
    pub fn fresh(&self) -> &[Message] {
        &self.fresh
    }

    /// Dismisses all fresh messages; the history keeps them.
    pub fn dismiss_all(&mut self) {
        self.fresh.clear();
    }

    /// Dismisses those whose [`Message::number`] is one of `numbers`.
    pub fn dismiss_numbers(&mut self, numbers: &Range<u64>) {
        self.fresh
            .retain(|message| !numbers.contains(&message.number));
    }

    /// Dismisses the fresh message at `index`; the history keeps it.
    pub fn dismiss(&mut self, index: usize) {
        if index < self.fresh.len() {
            self.fresh.remove(index);
        }
    }
}
