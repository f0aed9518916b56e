use crate::character::{Attachments, Character, Influence};

/// Influences a vertex in programs with a fixed number of them.
const FOUR: usize = 4;

/// One number for each position of a mesh, to be shown by a scale of colors.
#[derive(Clone, Debug, PartialEq)]
pub struct VertexNumbers {
    /// One for each position, in the order of the mesh.
    pub values: Vec<f32>,
    /// The number at the dark end of the scale.
    pub low: f32,
    /// The number at the bright end.
    pub high: f32,
    /// Numbers up to this one count as nothing, and are gray instead of a color of the scale.
    pub gray_up_to: Option<f32>,
}

/// Number of each vertex of a character by which its mesh can be colored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CharacterNumber {
    /// Weight of the joint with this index.
    Weight(usize),
    /// Number of joints that move it.
    Influences,
    /// The sum of all weights but the four largest, by the sum of all: what is lost where a vertex
    /// has at most four influences.
    LostAtFour,
}

impl CharacterNumber {
    /// The numbers of the vertices of each character, all on one scale.
    pub fn on_one_scale<'a>(
        of: impl IntoIterator<Item = (Self, &'a Character)>,
    ) -> Vec<VertexNumbers> {
        let numbers = of
            .into_iter()
            .map(|(number, character)| number.of(character));
        let mut all: Vec<VertexNumbers> = numbers.collect();
        let low = all.iter().map(|one| one.low).fold(f32::MAX, f32::min);
        let high = all.iter().map(|one| one.high).fold(0.0, f32::max);
        for one in &mut all {
            (one.low, one.high) = (low, high);
        }
        all
    }

    /// The number of each vertex of `character`, on a scale from 0 to 1, or to the largest number
    /// where that says nothing.
    fn of(self, character: &Character) -> VertexNumbers {
        let attachments = character.attachments();
        let values = match self {
            Self::Weight(joint) => of_each(attachments, |influences| weight(influences, joint)),
            Self::Influences => of_each(attachments, |influences| influences.len() as f32),
            Self::LostAtFour => of_each(attachments, lost_at_four),
        };
        let most = values.iter().copied().fold(0.0, f32::max);
        let least = values.iter().copied().fold(most, f32::min);
        let (low, high, gray_up_to) = match self {
            Self::Weight(_) => (0.0, 1.0, Some(0.0)),
            Self::Influences => (least.min(1.0), most.max(1.0), None),
            Self::LostAtFour => (0.0, most, Some(0.0)),
        };
        VertexNumbers {
            values,
            low,
            high,
            gray_up_to,
        }
    }
}

fn of_each(attachments: &Attachments, number: impl Fn(&[Influence]) -> f32) -> Vec<f32> {
    attachments.vertices().map(number).collect()
}

fn weight(influences: &[Influence], joint: usize) -> f32 {
    let of_joint = influences.iter().filter(|i| i.joint as usize == joint);
    of_joint.map(|influence| influence.weight).sum()
}

fn lost_at_four(influences: &[Influence]) -> f32 {
    let mut weights: Vec<f32> = influences.iter().map(|i| i.weight).collect();
    weights.sort_by(|a, b| b.total_cmp(a));
    let all: f32 = weights.iter().sum();
    let lost: f32 = weights.iter().skip(FOUR).sum();
    if all > 0.0 { lost / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Joint, SkeletalModel};
    use crate::geometry::Mesh;
    use glam::Vec3;

    fn character() -> Character {
        let joint = |index: usize| Joint {
            parent: index.checked_sub(1),
            ..Joint::default()
        };
        let skeleton = SkeletalModel::new((0..6).map(joint).collect()).unwrap();
        let mut attachments = Attachments::new();
        for weights in [&[1.0][..], &[0.25, 0.75], &[0.1, 0.2, 0.3, 0.2, 0.15, 0.05]] {
            attachments.push_vertex(
                (0..)
                    .zip(weights)
                    .map(|(joint, &weight)| Influence { joint, weight }),
            );
        }
        let mesh = Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]);
        Character::new(skeleton, attachments, mesh).unwrap()
    }

    #[test]
    fn weights_are_those_of_the_one_joint() {
        let character = character();
        let of = |joint| CharacterNumber::Weight(joint).of(&character).values;
        assert_eq!(of(0), [1.0, 0.25, 0.1]);
        assert_eq!(of(1), [0.0, 0.75, 0.2]);
        assert_eq!(of(5), [0.0, 0.0, 0.05]);
    }

    #[test]
    fn influences_are_counted_on_a_scale_from_one_to_the_most() {
        let found = CharacterNumber::Influences.of(&character());
        assert_eq!(found.values, [1.0, 2.0, 6.0]);
        assert_eq!((found.low, found.high), (1.0, 6.0));
    }

    #[test]
    fn what_is_lost_at_four_is_the_share_of_all_but_the_largest() {
        let found = CharacterNumber::LostAtFour.of(&character());
        assert_eq!(found.values[..2], [0.0, 0.0]);
        // 0.05 and 0.1 of weights that add up to 1.
        assert!((found.values[2] - 0.15).abs() < 1e-6, "{found:?}");
        assert_eq!(found.high, found.values[2]);
    }
}
