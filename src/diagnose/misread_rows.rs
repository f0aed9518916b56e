//! Numbers of the weights that are taken from other places than the rows of the file have them: rows with one number too
//! many or too few, or one array in which a column that is shifted ends in the next row.

use super::formula::{Columns, Rows};
use super::found_otherwise::WEIGHT_ROWS_DRIFT;
use super::made_alone::MadeAlone;
use super::mistake::Mistake;
use super::model::Model;
use super::search::Explanation;
use super::skin::Skinner;
use super::ways::{Made, formula, ways};
use crate::character::{Attachments, Character, Influence};
use crate::geometry::Mesh;
use crate::steps::Pace;

/// Numbers of the largest weights of which it is tried whether they were read as other rows.
const MOST_NUMBERS: usize = 1 << 25;

/// A way to read the numbers of the file, one after the other.
struct Way {
    /// Id of the mistake.
    id: &'static str,
    /// By how many numbers a row is wider than it is in the file. Rows of the file's own width are parts of one array: a
    /// joint beyond their end has a number of the next one.
    wider: isize,
    /// The first joint that is given a number, …
    first: u32,
    /// … and which of the row; those after it have the next ones.
    from: usize,
    /// The way in words, after the numbers of a row where these are not the file's.
    how: &'static str,
}

const fn way(
    id: &'static str,
    wider: isize,
    (first, from): (u32, usize),
    how: &'static str,
) -> Way {
    Way {
        id,
        wider,
        first,
        from,
        how,
    }
}

const DRIFT: &str = WEIGHT_ROWS_DRIFT.id;
const SHIFTED: &str = "weights-shifted";

const WAYS: [Way; 6] = [
    way(DRIFT, 1, (0, 0), ", the first for the root"),
    way(DRIFT, 1, (1, 0), ", the first for the joint after the root"),
    way(
        DRIFT,
        1,
        (1, 1),
        ", the first for the root, which the sum leaves out",
    ),
    way(DRIFT, -1, (1, 0), ""),
    way(
        SHIFTED,
        0,
        (1, 1),
        "the first one not at all, and the last joint has the first number of the next row",
    ),
    way(
        SHIFTED,
        0,
        (0, 0),
        "the first one for the root, and the last joint has the first number of the next row",
    ),
];

/// A character whose weights are read in a way.
struct Misread {
    mistake: &'static Mistake,
    /// The way in words.
    how: String,
    character: Character,
}

/// The readings that give the mesh by themselves, or else beside another mistake.
pub(super) async fn find(alone: &MadeAlone<'_>, pace: &Pace) -> Vec<Explanation> {
    if alone.has_many_joints() {
        return Vec::new();
    }
    let misread = misread(alone.search.model.character, pace).await;
    let found = given_beside(&[None], &misread, alone, pace).await;
    if !found.is_empty() {
        return found;
    }
    let beside = ways().filter(|other| {
        let weights = formula(&[*other]).weights;
        weights.rows == Rows::Exact && weights.columns == Columns::Exact
    });
    let beside: Vec<Option<Made>> = beside.map(Some).collect();
    given_beside(&beside, &misread, alone, pace).await
}

/// The character with its weights read in each of the ways.
async fn misread(character: &Character, pace: &Pace) -> Vec<Misread> {
    let Some(numbers) = numbers(character) else {
        return Vec::new();
    };
    // A stream that has ended leaves the variable that is read as it is: what follows is the last number, or 0 if the
    // variable is a new one each time.
    let mut followed_by = vec![0.0];
    followed_by.extend(numbers.last().filter(|last| **last != 0.0));
    let mut misread = Vec::new();
    for way in &WAYS {
        let mistake = Mistake::find(way.id);
        let Some((mistake, stride)) = mistake.zip(way.stride(character)) else {
            continue;
        };
        for &after in &followed_by {
            pace.after(numbers.len()).await;
            let read = way.read(&numbers, stride, after, character);
            misread.extend(read.map(|character| Misread {
                mistake,
                how: way.told(stride),
                character,
            }));
        }
    }
    misread
}

/// Those of `misread` that give the mesh beside one of `others`.
async fn given_beside(
    others: &[Option<Made>],
    misread: &[Misread],
    alone: &MadeAlone<'_>,
    pace: &Pace,
) -> Vec<Explanation> {
    let mut found = Vec::new();
    for read in misread {
        let model = Model::new(&read.character);
        for other in others {
            let mut formula = formula(other.as_slice());
            formula.vertex_order = alone.formula().vertex_order;
            let mut made = vec![Made::by_numbers(read.mistake)];
            made.extend(other);
            let mut skinner = Skinner::new(&model, alone.search.pose, &formula);
            let given = alone.search.explained_by(&mut skinner, made, pace).await;
            found.extend(given.map(|given| Explanation {
                how: Some(read.how.clone()),
                ..given
            }));
        }
    }
    found
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
    /// Numbers from the beginning of one row to that of the next, of which there is at least one.
    fn stride(&self, character: &Character) -> Option<usize> {
        let stride = columns(character)?.checked_add_signed(self.wider)?;
        (stride > 0).then_some(stride)
    }

    /// The way in words.
    fn told(&self, stride: usize) -> String {
        match self.wider {
            0 => self.how.to_owned(),
            _ => format!("{stride} numbers a row{}", self.how),
        }
    }

    /// The character with the weights that are read, where `after` follows the last of the `numbers`.
    fn read(
        &self,
        numbers: &[f32],
        stride: usize,
        after: f32,
        character: &Character,
    ) -> Option<Character> {
        let joints = self.first..character.skeleton().joints().len() as u32;
        let most = match self.wider {
            0 => joints.len(),
            _ => stride - self.from,
        };
        let mut misread = Attachments::new();
        for row in 0..character.attachments().vertex_count() {
            let of_joints = numbers.iter().skip(row * stride + self.from).copied();
            let of_joints = of_joints.chain(std::iter::repeat(after)).take(most);
            let influences = joints.clone().zip(of_joints);
            let weighted = influences.filter(|(_, weight)| *weight != 0.0);
            misread.push_vertex(weighted.map(|(joint, weight)| Influence { joint, weight }));
        }
        let bind = character.bind_mesh();
        let mesh = Mesh::new(bind.positions.clone(), bind.triangles.clone());
        Character::new(character.skeleton().clone(), misread, mesh).ok()
    }
}
