//! Rows of weights that are read with one number too many or too few, so that each begins elsewhere than in the file.

use super::found_otherwise::WEIGHT_ROWS_DRIFT;
use super::made_alone::MadeAlone;
use super::model::Model;
use super::search::{Explanation, Made};
use super::skin::Skinner;
use crate::character::{Attachments, Character, Influence};
use crate::geometry::Mesh;
use crate::steps::Pace;

/// Numbers of the largest weights of which it is tried whether they were read as other rows.
const MOST_NUMBERS: usize = 1 << 25;

/// A way to read the rows.
struct Way {
    /// By how many numbers a row is wider than it is in the file.
    wider: isize,
    /// The joint of a row's first number.
    first: u32,
    /// Whether the sum goes over all joints, or leaves the root out.
    with_root: bool,
    /// The way in words, which follow the count of numbers.
    how: &'static str,
}

const WAYS: [Way; 4] = [
    Way {
        wider: 1,
        first: 0,
        with_root: true,
        how: ", the first for the root",
    },
    Way {
        wider: 1,
        first: 1,
        with_root: false,
        how: ", the first for the joint after the root",
    },
    Way {
        wider: 1,
        first: 0,
        with_root: false,
        how: ", the first for the root, which the sum leaves out",
    },
    Way {
        wider: -1,
        first: 1,
        with_root: false,
        how: "",
    },
];

/// The reading that gives the mesh, if one does.
pub(super) async fn find(alone: &MadeAlone<'_>, pace: &Pace) -> Option<Explanation> {
    if alone.has_many_joints() {
        return None;
    }
    let character = alone.search.model.character;
    let numbers = numbers(character)?;
    // A stream that has ended leaves the variable that is read as it is: what follows is the last number, or 0 if the
    // variable is a new one each time.
    let mut followed_by = vec![0.0];
    followed_by.extend(numbers.last().filter(|last| **last != 0.0));
    for way in &WAYS {
        for &after in &followed_by {
            let Some(drifting) = way.read(&numbers, after, character) else {
                continue;
            };
            let model = Model::new(&drifting);
            let mut skinner = Skinner::new(&model, alone.search.pose, &alone.formula());
            let made = vec![Made::by_numbers(&WEIGHT_ROWS_DRIFT)];
            let given = alone.search.explained_by(&mut skinner, made, pace).await;
            if let Some(given) = given {
                let wide = way.width(character).unwrap_or(0);
                return Some(Explanation {
                    how: Some(format!("{wide} numbers a row{}", way.how)),
                    ..given
                });
            }
        }
    }
    None
}

/// All numbers of the file, whose rows have one for each joint but the root; none of a character with other weights.
fn numbers(character: &Character) -> Option<Vec<f32>> {
    let columns = columns(character)?;
    let rows = character.attachments();
    let count = rows.vertex_count() * columns;
    if count > MOST_NUMBERS {
        return None;
    }
    let mut numbers = vec![0.0; count];
    for (row, influences) in rows.vertices().enumerate() {
        for influence in influences {
            let column = (influence.joint as usize).checked_sub(1)?;
            numbers[row * columns + column] = influence.weight;
        }
    }
    Some(numbers)
}

/// Numbers of a row in the file.
fn columns(character: &Character) -> Option<usize> {
    character.skeleton().joints().len().checked_sub(1)
}

impl Way {
    /// Numbers of a row as it is read, which is never empty.
    fn width(&self, character: &Character) -> Option<usize> {
        let width = columns(character)?.checked_add_signed(self.wider)?;
        (width > 0).then_some(width)
    }

    /// The character with the weights that are read, where `after` follows the last of the `numbers`.
    fn read(&self, numbers: &[f32], after: f32, character: &Character) -> Option<Character> {
        let width = self.width(character)?;
        let joints = character.skeleton().joints().len();
        let mut drifting = Attachments::new();
        for row in 0..character.attachments().vertex_count() {
            let read = numbers.iter().skip(row * width).copied();
            let read = read.chain(std::iter::repeat(after)).take(width);
            let joints_of_row = (self.first..).take_while(|joint| (*joint as usize) < joints);
            let influences = joints_of_row.zip(read);
            let weighted = influences
                .filter(|(joint, weight)| *weight != 0.0 && (self.with_root || *joint != 0));
            drifting.push_vertex(weighted.map(|(joint, weight)| Influence { joint, weight }));
        }
        let bind = character.bind_mesh();
        let mesh = Mesh::new(bind.positions.clone(), bind.triangles.clone());
        Character::new(character.skeleton().clone(), drifting, mesh).ok()
    }
}
