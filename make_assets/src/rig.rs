//! A skeleton and the character that hangs on it, as the files describe them.
use super::mesh::Mesh;
use glam::DVec3;

/// A joint; its place in the list is its index.
pub struct Joint {
    pub name: &'static str,
    /// Offset from the parent; a root's is its place in the world.
    pub offset: DVec3,
    pub parent: Option<usize>,
    /// The joint of the other side of the body; its own index where it lies in the middle.
    pub twin: usize,
}

/// Joints from rows of name, parent (−1 for the root), and the place at rest in the world.
/// `Left …` and `Right …` are each other's reflection.
pub fn joints(rows: &[(&'static str, i32, DVec3)]) -> Vec<Joint> {
    let place = |name: &str| rows.iter().position(|row| row.0 == name);
    let other_side = |name: &str| {
        let (left, right) = (name.strip_prefix("Left "), name.strip_prefix("Right "));
        let swapped = left
            .map(|x| format!("Right {x}"))
            .or(right.map(|x| format!("Left {x}")))?;
        place(&swapped)
    };
    rows.iter()
        .enumerate()
        .map(|(i, &(name, parent, at))| {
            let parent = usize::try_from(parent).ok();
            Joint {
                name,
                offset: at - parent.map_or(DVec3::ZERO, |p| rows[p].2),
                parent,
                twin: other_side(name).unwrap_or(i),
            }
        })
        .collect()
}

/// A mesh bound to a skeleton.
pub struct Character {
    pub joints: Vec<Joint>,
    pub mesh: Mesh,
    /// For each vertex its weight for each joint but the root, summing to 1.
    pub weights: Vec<Vec<f64>>,
}
