use super::bones::bones;
use super::skinning::{self, ConservativeBounds};
use super::{Attachments, AttachmentsError, JointBone, Pose, SkeletalModel};
use crate::geometry::{Mesh, Normals, SharedMesh};
use crate::math::Aabb;
use glam::{Mat4, Vec3};

/// Character: a skeleton with a mesh bound to it.
#[derive(Clone, Debug)]
#[doc(alias = "ImportCharacter")]
pub struct Character {
    skeleton: SkeletalModel,
    attachments: Attachments,
    bind_mesh: SharedMesh,
    bones: Vec<JointBone>,
    bounds: ConservativeBounds,
}

/// Reason why mesh, weights and skeleton do not make a character.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CharacterError {
    /// The number of rows of weights differs from the number of vertices.
    #[error("expected weights for {vertices} vertices, found {rows}")]
    RowCount {
        /// Number of vertices of the mesh.
        vertices: usize,
        /// Number of rows of weights.
        rows: usize,
    },
    /// A weight names a joint that does not exist.
    #[error(transparent)]
    Attachments(#[from] AttachmentsError),
}

impl Character {
    /// Estimated memory of the weights, in bytes: all that is heavy beside the mesh.
    pub fn weights_memory(&self) -> usize {
        self.attachments.memory()
    }

    /// Binds `bind_mesh` (positions in model space, in the order of the rows of `attachments`) to
    /// `skeleton`.
    ///
    /// # Errors
    /// If the counts differ or a weight names a joint that does not exist.
    pub fn new(
        skeleton: SkeletalModel,
        attachments: Attachments,
        bind_mesh: Mesh,
    ) -> Result<Self, CharacterError> {
        let (vertices, rows) = (bind_mesh.positions.len(), attachments.vertex_count());
        if vertices != rows {
            return Err(CharacterError::RowCount { vertices, rows });
        }
        attachments.check(skeleton.joints().len())?;
        let joints = skeleton.joints().len();
        let bounds = ConservativeBounds::new(&attachments, &bind_mesh.positions, joints);
        let bones = bones(&skeleton, &attachments, &bind_mesh.positions);
        Ok(Self {
            skeleton,
            attachments,
            bind_mesh: SharedMesh::new(bind_mesh),
            bones,
            bounds,
        })
    }

    /// Skeleton, at rest.
    pub fn skeleton(&self) -> &SkeletalModel {
        &self.skeleton
    }

    /// Weights, one run per vertex of the mesh.
    pub fn attachments(&self) -> &Attachments {
        &self.attachments
    }

    /// Mesh in the bind pose, in model space.
    pub fn bind_mesh(&self) -> &SharedMesh {
        &self.bind_mesh
    }

    /// Bones that can be grabbed, ordered by joint.
    pub fn bones(&self) -> &[JointBone] {
        &self.bones
    }

    /// Skinned vertices of the mesh, in model space and in the order of the file, with the joints'
    /// frames at `model_from_joint`.
    pub fn skin(&self, model_from_joint: &[Mat4]) -> Vec<Vec3> {
        let palette = self.skeleton.palette(model_from_joint);
        let bind = &self.bind_mesh.positions;
        let mut skinned = vec![Vec3::ZERO; bind.len()];
        skinning::skin_positions(&palette, &self.attachments, bind, &mut skinned);
        skinned
    }

    /// Conservative bounds of the mesh, in model space, with the joints' frames at
    /// `model_from_joint`: larger than the tightest box, but found without skinning a vertex.
    pub fn conservative_bounds(&self, model_from_joint: &[Mat4]) -> Aabb {
        self.bounds.under(&self.skeleton.palette(model_from_joint))
    }

    /// Skinned normals, one per vertex of the mesh, with the joints' frames at `model_from_joint`;
    /// `None` for a mesh with flat triangles, whose normals follow from their corners.
    pub fn skin_normals(&self, model_from_joint: &[Mat4]) -> Option<Vec<Vec3>> {
        let Normals::PerVertex(bind) = &self.bind_mesh.normals else {
            return None;
        };
        let palette = self.skeleton.palette(model_from_joint);
        let positions = self.bind_mesh.position_of_vertices();
        Some(skinning::skin_normals(
            &palette,
            &self.attachments,
            positions.zip(bind.iter().copied()),
        ))
    }

    /// The same character with at most `most` influences per vertex, see [`Attachments::limited`].
    pub fn limited(&self, most: usize) -> Self {
        let attachments = self.attachments.limited(most);
        let joints = self.skeleton.joints().len();
        Self {
            bounds: ConservativeBounds::new(&attachments, &self.bind_mesh.positions, joints),
            attachments,
            ..self.clone()
        }
    }

    /// Skinned vertices under `pose`, in model space and in the order of the file.
    pub fn skin_pose(&self, pose: &Pose) -> Vec<Vec3> {
        self.skin(&self.skeleton.update_current_joint_to_world_transforms(pose))
    }
}
