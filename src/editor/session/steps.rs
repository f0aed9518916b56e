//! Gestures, and the steps that are undone and done again.

use super::{Gesture, Session};
use crate::scene::Scene;

impl Session {
    /// Begins a gesture: the edits that follow are one step, and can be canceled together. A
    /// gesture in progress is committed.
    pub fn begin_gesture(&mut self) {
        self.commit_gesture();
        self.gesture = Some(Gesture {
            state: self.present(),
            selection: self.selection.clone(),
            canceled: None,
        });
    }

    /// Begins a gesture that is one step with the last one, such as a movement with the insertion of what is moved.
    /// Canceled, it leaves that step as it was.
    pub fn begin_gesture_on_last_step(&mut self) {
        self.begin_gesture();
        let present = self.present();
        if let (Some(gesture), Some((state, selection))) =
            (&mut self.gesture, self.history.take_last())
        {
            *gesture = Gesture {
                state,
                selection,
                canceled: Some(present),
            };
        }
    }

    /// Ends the gesture and keeps its edits, as one step that can be undone; none if they changed
    /// nothing in the end.
    pub fn commit_gesture(&mut self) {
        if let Some(Gesture {
            state, selection, ..
        }) = self.gesture.take()
        {
            if state.scene == self.scene {
                self.document = state.document;
            } else {
                self.record(&state, selection);
            }
        }
    }

    /// Ends the gesture and restores the document as it was when it began. Does nothing if none is
    /// in progress.
    pub fn cancel_gesture(&mut self) {
        let Some(gesture) = self.gesture.take() else {
            return;
        };
        match gesture.canceled {
            None => self.restore(&gesture.state),
            Some(state) => {
                self.restore(&state);
                self.record(&gesture.state, gesture.selection);
            }
        }
    }

    /// Undoes the last step, or cancels the gesture in progress. Returns the step's name; `None` if
    /// there is none.
    pub fn undo(&mut self) -> Option<String> {
        if self.gesture.is_some() {
            self.cancel_gesture();
            return None;
        }
        let last = self.history.done().checked_sub(1)?;
        let name = self.steps().nth(last).map(str::to_owned);
        self.go_to_step(last);
        name
    }

    /// Does the step again that was undone last, or cancels the gesture in progress. Returns the
    /// step's name; `None` if there is none.
    pub fn redo(&mut self) -> Option<String> {
        if self.gesture.is_some() {
            self.cancel_gesture();
            return None;
        }
        let name = self.steps().nth(self.history.done()).map(str::to_owned);
        self.go_to_step(self.history.done() + 1);
        name
    }

    /// Goes to the document after the first `done` of [`Session::steps`], with the selection of that
    /// time. A gesture in progress is canceled. Does nothing if there are fewer steps.
    pub fn go_to_step(&mut self, done: usize) {
        self.cancel_gesture();
        if let Some((state, selection)) = self.history.go_to(done) {
            let state = state.clone();
            self.select(selection.shape);
            self.selection = selection;
            self.restore(&state);
        }
    }

    /// Names of the steps since the document was opened, oldest first: those that were undone come
    /// last, [`Session::done_steps`] before them. At most 200 are kept.
    pub fn steps(&self) -> impl ExactSizeIterator<Item = &str> {
        self.history.names()
    }

    /// The scene, and all scenes to which undoing and redoing lead.
    pub fn remembered_scenes(&self) -> impl Iterator<Item = &Scene> {
        let states = self.history.states().map(|state| &state.scene);
        std::iter::once(&self.scene).chain(states)
    }

    /// Number of steps that can be undone.
    pub fn done_steps(&self) -> usize {
        self.history.done()
    }

    /// Whether a gesture is in progress.
    pub fn is_in_gesture(&self) -> bool {
        self.gesture.is_some()
    }
}
