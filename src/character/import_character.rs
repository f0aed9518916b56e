use super::reach::Reach;
use super::{Attachments, AttachmentsError, JointBone, Pose, SkeletalModel, bone, skinning};
use crate::geometry::{Mesh, Normals, SharedMesh};
use crate::math::Aabb;
use glam::{Mat4, Vec3};

/// A skeleton with the mesh bound to it: what Import Character brings in.
#[derive(Clone, Debug)]
#[doc(alias = "ImportCharacter")]
pub struct Character {
    skeleton: SkeletalModel,
    attachments: Attachments,
    bind_mesh: SharedMesh,
    bones: Vec<JointBone>,
    reach: Reach,
}

/// Why mesh, weights and skeleton do not make a character.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CharacterError {
    /// Not as many rows of weights as vertices.
    #[error("expected weights for {vertices} vertices, found {rows}")]
    RowCount {
        /// Vertices of the mesh.
        vertices: usize,
        /// Rows of weights.
        rows: usize,
    },
    /// Weights that name no joint.
    #[error(transparent)]
    Attachments(#[from] AttachmentsError),
}

impl Character {
    /// Binds `bind_mesh` (positions in model space, in the order of the rows of `attachments`)
    /// to `skeleton`.
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
        let reach = Reach::new(&attachments, &bind_mesh.positions, joints);
        let bones = bone::bones(&skeleton, &attachments, &bind_mesh.positions);
        Ok(Self {
            skeleton,
            attachments,
            bind_mesh: SharedMesh::new(bind_mesh),
            bones,
            reach,
        })
    }

    /// The skeleton.
    pub fn skeleton(&self) -> &SkeletalModel {
        &self.skeleton
    }

    /// The weights, one run a vertex of the mesh.
    pub fn attachments(&self) -> &Attachments {
        &self.attachments
    }

    /// The mesh in the bind pose.
    pub fn bind_mesh(&self) -> &SharedMesh {
        &self.bind_mesh
    }

    /// The bones that a hand can take, ordered by joint.
    pub fn bones(&self) -> &[JointBone] {
        &self.bones
    }

    /// The mesh's vertices, in the order of the file, where the joints stand at
    /// `model_from_joint`.
    pub fn skin(&self, model_from_joint: &[Mat4]) -> Vec<Vec3> {
        let palette = self.skeleton.palette(model_from_joint);
        let bind = &self.bind_mesh.positions;
        let mut skinned = vec![Vec3::ZERO; bind.len()];
        skinning::skin_positions(&palette, &self.attachments, bind, &mut skinned);
        skinned
    }

    /// A box that the mesh does not leave where the joints stand at `model_from_joint`: larger than
    /// the tightest one, but found without moving a vertex.
    pub fn reach(&self, model_from_joint: &[Mat4]) -> Aabb {
        self.reach.around(&self.skeleton.palette(model_from_joint))
    }

    /// The mesh's normals, one a vertex of the mesh, where the joints stand at
    /// `model_from_joint`; `None` for a mesh whose triangles are flat, whose normals follow from
    /// their corners.
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

    /// The same character with at most `most` influences a vertex, see [`Attachments::limited`].
    pub fn limited(&self, most: usize) -> Self {
        let attachments = self.attachments.limited(most);
        let joints = self.skeleton.joints().len();
        Self {
            reach: Reach::new(&attachments, &self.bind_mesh.positions, joints),
            attachments,
            ..self.clone()
        }
    }

    /// The mesh's vertices under `pose`, in the order of the file.
    pub fn skin_pose(&self, pose: &Pose) -> Vec<Vec3> {
        self.skin(&self.skeleton.update_current_joint_to_world_transforms(pose))
    }
}
