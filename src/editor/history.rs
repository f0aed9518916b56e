use super::selection::Selection;
use crate::revision::Revision;
use crate::scene::Scene;
use std::collections::{HashSet, VecDeque};

/// Steps that can be undone, at most.
pub(super) const MOST_STEPS: usize = 200;

/// Estimated memory of all kept states together, in bytes. Meshes are shared between states, so
/// this is reached only by large meshes that were deleted or replaced, and by thousands of shapes.
const MOST_BYTES: usize = 256 << 20;

/// Document at a moment. A scene is cheap to clone, since its heavy data is shared.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub scene: Scene,
    pub document: Revision,
}

/// Step that can be undone.
#[derive(Clone, Debug)]
struct Step {
    name: String,
    /// Selection when the step began.
    before: Selection,
    /// Selection when the step had ended.
    after: Selection,
    /// Document after the step.
    state: State,
}

/// States of a document from its opening on, as far as they are kept, and the steps between them.
#[derive(Clone, Debug)]
pub(super) struct History {
    /// Document before the first step that is kept.
    first: State,
    steps: VecDeque<Step>,
    /// Number of steps that are done; those after them have been undone.
    done: usize,
    most_bytes: usize,
}

impl History {
    pub fn new(first: State) -> Self {
        Self {
            first,
            steps: VecDeque::new(),
            done: 0,
            most_bytes: MOST_BYTES,
        }
    }

    /// Adds a step that leads to `state`. What was undone can no longer be redone, and the oldest
    /// steps are dropped beyond the bounds.
    pub fn push(&mut self, name: String, before: Selection, after: Selection, state: State) {
        self.steps.truncate(self.done);
        self.steps.push_back(Step {
            name,
            before,
            after,
            state,
        });
        while self.steps.len() > MOST_STEPS
            || self.steps.len() > 1 && self.memory() > self.most_bytes
        {
            if let Some(step) = self.steps.pop_front() {
                self.first = step.state;
            }
        }
        self.done = self.steps.len();
    }

    /// Takes the last step out, unless some have been undone: the state before it, and the selection when it began.
    pub fn take_last(&mut self) -> Option<(State, Selection)> {
        if self.done < self.steps.len() {
            return None;
        }
        let last = self.steps.pop_back()?;
        self.done = self.steps.len();
        let state = self.steps.back().map_or(&self.first, |step| &step.state);
        Some((state.clone(), last.before))
    }

    /// Goes to the state after the first `done` steps. Returns it with the selection that belongs
    /// to it; `None` if it is the present one or does not exist.
    pub fn go_to(&mut self, done: usize) -> Option<(&State, Selection)> {
        if done == self.done || done > self.steps.len() {
            return None;
        }
        let selection = if done < self.done {
            self.steps[done].before.clone()
        } else {
            self.steps[done - 1].after.clone()
        };
        self.done = done;
        let state = match done.checked_sub(1) {
            Some(last) => &self.steps[last].state,
            None => &self.first,
        };
        Some((state, selection))
    }

    /// All states that can be gone to.
    pub fn states(&self) -> impl Iterator<Item = &State> {
        let after = self.steps.iter().map(|step| &step.state);
        std::iter::once(&self.first).chain(after)
    }

    /// Number of steps that are done and can be undone.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Names of all steps, oldest first, those that were undone included.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.steps.iter().map(|step| step.name.as_str())
    }

    /// Memory of all kept states, in bytes; what several share counts once.
    fn memory(&self) -> usize {
        let mut counted = HashSet::new();
        self.states()
            .map(|state| state.scene.memory(&mut counted))
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, SharedMesh};
    use crate::scene::{NewShape, ShapeKind};
    use glam::Vec3;

    fn state(kind: ShapeKind) -> State {
        State {
            scene: [NewShape::new("A", kind)].into_iter().collect(),
            document: Revision::new(),
        }
    }

    fn push(history: &mut History, state: &State) {
        let none = Selection::default();
        history.push("A step".into(), none.clone(), none, state.clone());
    }

    #[test]
    fn the_oldest_steps_are_dropped_beyond_two_hundred() {
        let mut history = History::new(state(ShapeKind::Cube));
        let states: Vec<State> = (0..205).map(|_| state(ShapeKind::Cube)).collect();
        for state in &states {
            push(&mut history, state);
        }
        assert_eq!(history.done(), 200);
        let (oldest, _) = history.go_to(0).unwrap();
        assert_eq!(oldest.document, states[4].document);
    }

    #[test]
    fn meshes_count_once_and_those_that_take_too_much_memory_are_dropped() {
        let mesh = |count: usize| {
            let positions = vec![Vec3::ZERO; count];
            let mesh = Mesh {
                positions,
                ..Mesh::default()
            };
            ShapeKind::Mesh(SharedMesh::new(mesh))
        };
        let shared = state(mesh(1000));
        let mut history = History::new(shared.clone());
        history.most_bytes = 40_000;
        for _ in 0..20 {
            push(&mut history, &shared);
        }
        assert_eq!(history.done(), 20, "12 kB in all states together");
        for _ in 0..20 {
            push(&mut history, &state(mesh(1000)));
        }
        let kept = history.done();
        assert!((1..=2).contains(&kept), "{kept}");
        push(&mut history, &state(mesh(1_000_000)));
        assert_eq!(history.done(), 1, "the last step can always be undone");
    }

    #[test]
    fn a_state_that_does_not_exist_or_is_the_present_one_is_not_gone_to() {
        let mut history = History::new(state(ShapeKind::Cube));
        push(&mut history, &state(ShapeKind::Sphere));
        assert!(history.go_to(1).is_none());
        assert!(history.go_to(2).is_none());
        assert!(history.go_to(0).is_some());
        assert_eq!(history.done(), 0);
    }
}
