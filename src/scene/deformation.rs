use crate::character::Character;
use crate::math::Aabb;
use glam::{Mat4, Vec3};
use std::sync::{Arc, OnceLock};

/// How a pose deforms a character's mesh: the transforms of its joints, and what follows from them
/// for vertices.
///
/// Vertices are worked out when they are first asked for, and then kept: where the graphics card
/// deforms the mesh for drawing, only picking, export and the like ask for them.
#[derive(Clone, Debug)]
pub struct Deformation {
    character: Arc<Character>,
    model_from_joint: Vec<Mat4>,
    positions: OnceLock<Vec<Vec3>>,
    normals: OnceLock<Option<Vec<Vec3>>>,
}

impl Deformation {
    /// Of `character`, whose joints stand at `model_from_joint`, one a joint.
    pub(super) fn new(character: Arc<Character>, model_from_joint: Vec<Mat4>) -> Self {
        Self {
            character,
            model_from_joint,
            positions: OnceLock::new(),
            normals: OnceLock::new(),
        }
    }

    /// What is deformed.
    pub fn character(&self) -> &Arc<Character> {
        &self.character
    }

    /// From each joint's frame to model space.
    pub fn model_from_joint(&self) -> &[Mat4] {
        &self.model_from_joint
    }

    /// `T · B⁻¹` of every joint, which takes what it holds from the bind pose to where it is.
    pub fn palette(&self) -> Vec<Mat4> {
        self.character.skeleton().palette(&self.model_from_joint)
    }

    /// The deformed positions, as many as the mesh has, in model space.
    pub fn positions(&self) -> &[Vec3] {
        self.positions
            .get_or_init(|| self.character.skin(&self.model_from_joint))
    }

    /// The deformed normals, as many as the mesh has vertices; `None` where its triangles are flat.
    pub fn normals(&self) -> Option<&[Vec3]> {
        self.normals
            .get_or_init(|| self.character.skin_normals(&self.model_from_joint))
            .as_deref()
    }

    /// A box that the mesh does not leave, in model space, found without moving a vertex.
    pub fn reach(&self) -> Aabb {
        self.character.reach(&self.model_from_joint)
    }

    /// Whether the positions have been worked out.
    pub fn is_worked_out(&self) -> bool {
        self.positions.get().is_some()
    }
}
