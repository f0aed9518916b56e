//! Characters in the colors of numbers, and their bind pose beside them.

use super::running::Program;
use crate::character::Character;
use crate::editor::Session;
use crate::render::{Ghost, GhostPaint, Marks, ShapeNumbers};
use crate::scene::{CharacterNumber, CharacterShape, EvaluatedGeometry, ShapeId, VertexNumbers};
use crate::ui::{Legend, MeshColors};
use glam::Vec3;
use std::sync::Arc;
use std::time::Duration;

/// Color of the bind pose.
const BIND: Vec3 = Vec3::new(0.45, 0.7, 1.0);

/// What is drawn of meshes besides themselves, kept while it stays the same.
#[derive(Default)]
pub(super) struct MeshMarks {
    shown: Option<Shown>,
    numbers: Vec<ShapeNumbers>,
    legend: Option<Legend>,
    /// The bind poses that are shown as ghosts.
    bind_poses: Vec<(Arc<Character>, Arc<EvaluatedGeometry>)>,
}

/// Everything that the numbers follow from.
struct Shown {
    number: Option<CharacterNumber>,
    of: Vec<(ShapeId, Arc<Character>)>,
}

impl Shown {
    fn is_as(&self, other: &Self) -> bool {
        let pairs = || self.of.iter().zip(&other.of);
        self.number == other.number
            && self.of.len() == other.of.len()
            && pairs().all(|(a, b)| a.0 == b.0 && Arc::ptr_eq(&a.1, &b.1))
    }
}

impl MeshMarks {
    /// Words about the colors, if there are any.
    pub fn legend(&self) -> Option<&Legend> {
        self.legend.as_ref()
    }

    /// Works out the numbers of `colors` for `session`, unless they are as before.
    fn update(&mut self, session: &Session, colors: MeshColors) {
        let joint = session.selected().zip(session.selected_joint());
        let (number, of) = match colors {
            MeshColors::Materials => (None, Vec::new()),
            MeshColors::Weight => {
                let number = joint.map(|(_, joint)| CharacterNumber::Weight(joint));
                let own = characters(session).filter(|(id, _)| joint.is_some_and(|j| j.0 == *id));
                (number, own.collect())
            }
            MeshColors::Influences => (
                Some(CharacterNumber::Influences),
                characters(session).collect(),
            ),
            MeshColors::LostAtFour => (
                Some(CharacterNumber::LostAtFour),
                characters(session).collect(),
            ),
        };
        let of = of.into_iter();
        let shown = Shown {
            number,
            of: of
                .map(|(id, shape)| (id, Arc::clone(&shape.character)))
                .collect(),
        };
        if colors == MeshColors::Materials {
            *self = Self {
                bind_poses: std::mem::take(&mut self.bind_poses),
                ..Self::default()
            };
            return;
        }
        if self.shown.as_ref().is_some_and(|known| known.is_as(&shown)) && self.legend.is_some() {
            return;
        }
        let of = shown.of.iter();
        let of = of.filter_map(|(shape, character)| Some((*shape, shown.number?, &**character)));
        self.numbers = ShapeNumbers::on_one_scale(of);
        let first = self.numbers.first().map(|first| &*first.numbers);
        self.legend = Some(words(colors, &shown, first));
        self.shown = Some(shown);
    }

    /// The selected characters of `session` in their bind pose, or all if none is selected.
    fn bind_ghosts(&mut self, session: &Session) -> Vec<Ghost> {
        let is_any_selected = characters(session).any(|(id, _)| session.is_selected(id));
        let wanted = characters(session);
        let wanted: Vec<(ShapeId, &CharacterShape)> = wanted
            .filter(|(id, _)| !is_any_selected || session.is_selected(*id))
            .collect();
        let known = std::mem::take(&mut self.bind_poses);
        let mut ghosts = Vec::with_capacity(wanted.len());
        for (id, shape) in wanted {
            let Some(evaluated) = session.evaluated().shape(id) else {
                continue;
            };
            let character = &shape.character;
            let is_own = |(of, _): &&(Arc<Character>, _)| Arc::ptr_eq(of, character);
            let mut all = self.bind_poses.iter().chain(&known);
            let geometry = match all.find(is_own) {
                Some((_, geometry)) => Arc::clone(geometry),
                None => {
                    let mesh = character.bind_mesh().clone();
                    let (bounds, revision) = (mesh.bounds(), mesh.revision());
                    Arc::new(EvaluatedGeometry::rigid(mesh, bounds, revision))
                }
            };
            ghosts.push(Ghost {
                geometry: Arc::clone(&geometry),
                world_from_model: evaluated.world_from_model,
                paint: GhostPaint::Translucent(BIND),
            });
            self.bind_poses.push((Arc::clone(character), geometry));
        }
        ghosts
    }
}

/// The visible characters.
fn characters(session: &Session) -> impl Iterator<Item = (ShapeId, &CharacterShape)> {
    let scene = session.scene();
    let visible = scene.shapes().iter().filter(|shape| shape.visible);
    visible.filter_map(|shape| Some((shape.id, scene.character(shape.id)?)))
}

fn words(colors: MeshColors, shown: &Shown, numbers: Option<&VertexNumbers>) -> Legend {
    let (low, high) = numbers.map_or((0.0, 0.0), |numbers| (numbers.low, numbers.high));
    let named = |title: &str, note: &str| Legend {
        title: title.to_owned(),
        note: Some(note.to_owned()).filter(|note| !note.is_empty()),
        ..Legend::default()
    };
    let Some((_, character)) = shown.of.first() else {
        return match colors {
            MeshColors::Weight => named(
                "Weight",
                "Select a joint of a character to see what it moves",
            ),
            _ => named("Influences", "There is no character to see"),
        };
    };
    match shown.number {
        Some(CharacterNumber::Weight(joint)) => {
            let joints = character.skeleton().joints();
            let name = joints.get(joint).map_or("", |joint| &joint.name);
            Legend {
                ends: Some(["0".to_owned(), "1".to_owned()]),
                gray: Some("not moved by it".to_owned()),
                ..named(&format!("Weight of {name}"), "")
            }
        }
        Some(CharacterNumber::LostAtFour) if high > 0.0 => Legend {
            ends: Some(["0 %".to_owned(), format!("{:.1} %", 100.0 * high)]),
            gray: Some("nothing is lost".to_owned()),
            ..named(
                "Lost at four influences",
                "Of the weights of each vertex, all but the four largest",
            )
        },
        Some(CharacterNumber::LostAtFour) => named(
            "Lost at four influences",
            "Nothing: no vertex has more than four",
        ),
        _ => Legend {
            ends: Some([format!("{low:.0}"), format!("{high:.0}")]),
            ..named("Joints that move a vertex", "")
        },
    }
}

impl Program {
    /// Works out what is drawn of meshes besides themselves.
    pub(super) fn update_mesh_marks(&mut self) {
        self.mesh_marks.update(&self.session, self.ui.colors);
    }

    /// What is drawn of meshes besides themselves, as marks of the scene alone.
    pub(super) fn marks_of_meshes(&mut self, now: Duration) -> Marks {
        self.update_mesh_marks();
        self.update_mesh_comparison(now);
        let ghosts = if self.ui.bind_ghost {
            self.mesh_marks.bind_ghosts(&self.session)
        } else {
            self.mesh_marks.bind_poses.clear();
            Vec::new()
        };
        let mut marks = match &self.mesh_comparison {
            Some(comparison) => comparison.marks(&self.session),
            None => Marks {
                numbers: self.mesh_marks.numbers.clone(),
                ..Marks::default()
            },
        };
        marks.ghosts.extend(ghosts);
        marks
    }
}
