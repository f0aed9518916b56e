//! View ▸ Explain Skinning: the formula at work on a vertex, mistakes made on purpose, and the matrix
//! stack step by step. All of it is a view: the document knows nothing of it.

mod arrows;
mod banner;
mod digits;
mod letters;
mod matrices;
mod mistakes;
mod panel;
mod shown;
mod stack;
mod steps;
mod table;
mod vertex;
mod words;

pub(super) use panel::show;
pub(super) use vertex::pointer;

use super::scene_places::ScenePlaces;
use crate::editor::Session;
use crate::revision::Revision;
use crate::scene::{CharacterShape, Evaluated, EvaluatedGeometry, EvaluatedShape, ShapeId};
use egui::{Rect, Ui};
use shown::{Made, Mistaken};
use std::collections::BTreeSet;
use steps::Stepper;
use vertex::Told;

/// What the panel explains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Topic {
    /// The formula of a vertex, and mistakes in it.
    #[default]
    Formula,
    /// The way of the matrix stack over the joints.
    Stack,
}

/// State of the panel. What it shows follows from the session and is kept by revision.
#[derive(Clone, Debug, Default)]
pub(super) struct ExplainState {
    is_open: bool,
    topic: Topic,
    /// The character that is explained: the one that was selected last.
    character: Option<ShapeId>,
    /// The vertex that was clicked last.
    picked: Option<(ShapeId, usize)>,
    /// The mistake that is made on purpose.
    made: Option<Made>,
    /// Whether a mesh is compared with the character, for which it has to be shown right.
    compares: bool,
    /// The character and its mesh when it was seen last.
    seen: Option<(ShapeId, Revision)>,
    /// Whether the pose has changed while the panel is open.
    was_posed: bool,
    /// The mesh with it.
    mistaken: Option<Mistaken>,
    /// The formula at work on the vertex.
    told: Option<Told>,
    /// Joints whose matrices are shown.
    unfolded: BTreeSet<usize>,
    /// Joint whose row is under the pointer.
    hovered: Option<usize>,
    stepper: Stepper,
    /// How often a vertex was picked in the view or in a comparison: the formula of each begins at its top.
    picks: usize,
    /// The vertex that is explained of a mesh until one is picked.
    first_vertex: Option<(Revision, usize)>,
}

/// The character that is explained.
#[derive(Clone, Copy)]
struct Explained<'a> {
    id: ShapeId,
    shape: &'a CharacterShape,
    /// As the exact formula has it.
    evaluated: &'a EvaluatedShape,
}

impl Explained<'_> {
    /// Revision of all that its mesh follows from.
    fn revision(&self) -> Revision {
        self.evaluated.geometry.revision
    }
}

impl ExplainState {
    pub(super) fn is_open(&self) -> bool {
        self.is_open
    }

    /// Whether the formula of this vertex is shown.
    pub(super) fn tells_of(&self, vertex: usize) -> bool {
        let told = self.told.as_ref().map(|told| told.vertex.vertex);
        self.is_open && self.topic == Topic::Formula && told == Some(vertex)
    }

    /// Opens the panel, or closes it with all that it shows.
    pub(super) fn set_open(&mut self, open: bool) {
        *self = Self {
            is_open: open,
            topic: self.topic,
            character: self.character,
            picked: self.picked,
            picks: self.picks,
            ..Self::default()
        };
    }

    /// Opens the panel with the formula of a vertex.
    pub(super) fn show_formula(&mut self) {
        self.set_open(true);
        self.topic = Topic::Formula;
    }

    /// Drops everything about shapes, and the mistake that is made.
    pub(super) fn forget_shapes(&mut self) {
        *self = Self {
            is_open: self.is_open,
            topic: self.topic,
            picks: self.picks,
            ..Self::default()
        };
    }

    /// Takes note of whether a mesh is compared with the character: that ends the mistake that is made.
    pub(super) fn set_compares(&mut self, compares: bool) {
        if compares && !self.compares {
            self.made = None;
        }
        self.compares = compares;
    }

    /// Ends the mistake that is made, or else closes the panel; whether there was anything to end.
    pub(super) fn end_last(&mut self) -> bool {
        if self.made.take().is_none() {
            let was_open = self.is_open;
            self.set_open(false);
            return was_open;
        }
        true
    }

    /// Whether a mistake is made on purpose.
    pub(super) fn makes_mistake(&self) -> bool {
        self.made.is_some()
    }

    /// Whether a click on a character explains the vertex there.
    pub(super) fn takes_clicks(&self) -> bool {
        self.is_open && self.topic == Topic::Formula
    }

    /// Joint that is lit in the view and in the list of joints.
    pub(super) fn lit(&self) -> Option<usize> {
        match self.topic {
            _ if !self.is_open => None,
            Topic::Formula => self.hovered,
            Topic::Stack => self.stepper.lit(),
        }
    }

    /// The scene as the view shows it while a mistake is made; `None` while all is right.
    pub(super) fn evaluated(&mut self, session: &Session) -> Option<Evaluated> {
        self.update(session);
        let (id, mistaken) = self.character.zip(self.mistaken.as_ref())?;
        let mut evaluated = session.evaluated().clone();
        let shape = evaluated.shapes.iter_mut().find(|shape| shape.id == id)?;
        shape.geometry = mistaken.geometry.clone();
        Some(evaluated)
    }

    /// What the character `id` looks like with the mistake that is made; `None` while it has none.
    pub(super) fn mistaken(
        &mut self,
        session: &Session,
        id: ShapeId,
    ) -> Option<&EvaluatedGeometry> {
        self.update(session);
        let mistaken = self
            .mistaken
            .as_ref()
            .filter(|_| self.character == Some(id));
        Some(&mistaken?.geometry)
    }

    /// The character that is explained.
    fn explained<'a>(&self, session: &'a Session) -> Option<Explained<'a>> {
        let id = self.character?;
        Some(Explained {
            id,
            shape: session.scene().character(id)?,
            evaluated: session.evaluated().shape(id)?,
        })
    }

    /// Works out what is shown, as far as it has changed.
    fn update(&mut self, session: &Session) {
        if !self.is_open {
            return;
        }
        let is_character = |id: &ShapeId| session.scene().character(*id).is_some();
        let selected = session.selected().filter(is_character);
        let kept = self.character.filter(is_character);
        let first = || {
            let mut shapes = session.scene().shapes().iter().map(|shape| shape.id);
            shapes.find(is_character)
        };
        self.character = selected.or(kept).or_else(first);
        let Some(explained) = self.explained(session) else {
            (self.mistaken, self.told) = (None, None);
            return;
        };
        let seen = (explained.id, explained.revision());
        self.was_posed |= self
            .seen
            .is_some_and(|(id, of)| id == seen.0 && of != seen.1);
        self.seen = Some(seen);
        let made = self.made;
        let is_of = |mistaken: &Mistaken| Some(mistaken.made) == made && mistaken.is_of(&explained);
        if !self.mistaken.as_ref().is_some_and(is_of) {
            self.mistaken = made.and_then(|made| Mistaken::new(made, &explained));
        }
        let joint = session.selected_joint().filter(|_| selected.is_some());
        let vertex = self.vertex(&explained, joint);
        let is_told = |told: &Told| told.is_of(&explained, vertex, made);
        if !self.told.as_ref().is_some_and(is_told) {
            self.told = Told::new(&explained, vertex, made);
        }
    }
}

/// Shows over the view what is explained in the panel, with words from `top` points below its upper edge on.
/// Returns where other words may begin.
pub(super) fn over_view(
    ui: &mut Ui,
    (view, top): (Rect, f32),
    places: &ScenePlaces,
    session: &Session,
    state: &mut ExplainState,
) -> f32 {
    let Some(explained) = state.explained(session).filter(|_| state.is_open) else {
        return top;
    };
    if explained.evaluated.visible {
        for place in places.iter() {
            let painter = ui
                .painter()
                .with_clip_rect(place.rect.intersect(ui.clip_rect()));
            match (state.topic, &state.told) {
                (Topic::Formula, Some(told)) => {
                    arrows::paint(&painter, place, session, &explained, told, state.hovered);
                }
                (Topic::Formula, None) => {}
                (Topic::Stack, _) => {
                    steps::paint_drawn(&painter, place, session, &explained, &state.stepper);
                }
            }
        }
    }
    let Some(mistaken) = &state.mistaken else {
        return top;
    };
    let banner = banner::show(ui, view, top, session, &explained, mistaken);
    if banner.ends {
        state.made = None;
    }
    top + banner.height + 8.0
}
