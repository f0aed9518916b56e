//! A character's mesh as a program with a mistake draws it.

use super::formula::{Formula, VertexOrder};
use super::model::Model;
use super::skin::Skinner;
use crate::character::{Character, Pose};
use crate::geometry::Normals;
use crate::math::cofactors;
use glam::{Mat3, Vec3};

/// Where a formula puts the vertices of a character, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct MistakenMesh {
    /// Positions in model space.
    pub positions: Vec<Vec3>,
    /// Unit normals, one for each vertex that is drawn; `None` for a mesh with flat triangles.
    pub normals: Option<Vec<Vec3>>,
}

impl Formula {
    /// The same with the vertices in the order of the file, in which a view has the triangles: what
    /// only numbers vertices anew is not seen, and weights that belong to other vertices are.
    pub fn in_order_of_file(&self) -> Self {
        let vertex_order = match self.vertex_order {
            VertexOrder::File | VertexOrder::FirstUse | VertexOrder::Corners => VertexOrder::File,
            VertexOrder::FirstUseOfPositions | VertexOrder::FirstUseInside => {
                VertexOrder::FirstUseInside
            }
        };
        Self {
            vertex_order,
            ..self.clone()
        }
    }
}

/// Skins `character` in `pose` by `formula`, as a view shows it: with the triangles of the file.
pub fn skin_by(character: &Character, pose: &Pose, formula: &Formula) -> MistakenMesh {
    skin_after(character, &[], pose, formula)
}

/// The same by a program that multiplies the rotations of `pose` onto those of the poses `before`.
pub fn skin_after(
    character: &Character,
    before: &[&Pose],
    pose: &Pose,
    formula: &Formula,
) -> MistakenMesh {
    let model = Model::new(character);
    let mut skinner = Skinner::after(&model, before, pose, &formula.in_order_of_file());
    let vertices = 0..skinner.count();
    let positions = vertices
        .clone()
        .map(|index| skinner.place(index).at.as_vec3());
    let positions = positions.collect();
    let mesh = character.bind_mesh();
    let normals = match &mesh.normals {
        Normals::Flat => None,
        Normals::PerVertex(bind) => {
            let turns: Vec<Mat3> = vertices
                .map(|index| cofactors(skinner.linear(index).as_mat3()))
                .collect();
            let turned = mesh.position_of_vertices().zip(bind);
            let turned = turned.map(|(at, &bind)| (turns[at as usize] * bind).normalize_or(bind));
            Some(turned.collect())
        }
    };
    MistakenMesh { positions, normals }
}
