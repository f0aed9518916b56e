use super::bones::bones;
use super::dual_quaternions;
use super::skinning::{self, ConservativeBounds};
use super::{
    Attachments, AttachmentsError, FileFrames, JointBone, Pose, SkeletalModel, Skinned,
    SkinningBlocks,
};
use crate::geometry::{Mesh, Normals, SharedMesh};
use crate::math::Aabb;
use fearless_simd::Level;
use glam::{Mat4, Vec3};
use std::sync::{Arc, OnceLock};

/// Character: a skeleton with a mesh bound to it.
#[derive(Clone, Debug)]
#[doc(alias = "ImportCharacter")]
pub struct Character {
    skeleton: SkeletalModel,
    attachments: Attachments,
    bind_mesh: SharedMesh,
    bones: Vec<JointBone>,
    bounds: ConservativeBounds,
    /// The weights once more, for skinning; made when they are first needed, which is never where the
    /// graphics card skins. `None` if it has no use for blocks.
    blocks: OnceLock<Option<SkinningBlocks>>,
    /// Frames of its file, if they are others.
    file_frames: Option<Arc<FileFrames>>,
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
        let blocks = self.blocks.get().and_then(Option::as_ref);
        let blocks = blocks.map_or(0, SkinningBlocks::memory);
        self.attachments.memory() + blocks
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
            blocks: OnceLock::new(),
            file_frames: None,
        })
    }

    /// The same with the frames that its file has, one for each joint.
    #[must_use]
    pub fn with_file_frames(self, frames: FileFrames) -> Self {
        Self {
            file_frames: Some(Arc::new(frames)),
            ..self
        }
    }

    /// Frames of its file, if they are others.
    pub fn file_frames(&self) -> Option<&FileFrames> {
        self.file_frames.as_deref()
    }

    /// The same with some of its vertices: those of `bind_mesh`, with their rows.
    pub(super) fn with_some_vertices(
        &self,
        attachments: Attachments,
        bind_mesh: SharedMesh,
    ) -> Self {
        Self {
            skeleton: self.skeleton.clone(),
            attachments,
            bind_mesh,
            bones: self.bones.clone(),
            bounds: self.bounds.clone(),
            blocks: OnceLock::new(),
            file_frames: self.file_frames.clone(),
        }
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

    /// Skinned vertices with the joints' frames at `model_from_joint`: those of
    /// [`Character::skin_one_by_one`], bit for bit, many vertices at once.
    pub fn skin(&self, model_from_joint: &[Mat4]) -> Skinned {
        let palette = self.skeleton.palette(model_from_joint);
        let blocks = || SkinningBlocks::new(&self.attachments, &self.bind_mesh, Level::new());
        let is_finite = palette.iter().all(Mat4::is_finite);
        match self.blocks.get_or_init(blocks) {
            Some(blocks) if is_finite => {
                let mut skinned = Skinned::default();
                blocks.skin(&palette, &mut skinned);
                skinned
            }
            _ => self.skin_one_by_one(model_from_joint),
        }
    }

    /// Skinned vertices with the joints' frames at `model_from_joint`, one after the other by the
    /// formulas of [`skinning`]: the reference.
    pub fn skin_one_by_one(&self, model_from_joint: &[Mat4]) -> Skinned {
        let palette = self.skeleton.palette(model_from_joint);
        let mesh = &self.bind_mesh;
        let mut positions = vec![Vec3::ZERO; mesh.positions.len()];
        skinning::skin_positions(&palette, &self.attachments, &mesh.positions, &mut positions);
        let normals = match &mesh.normals {
            Normals::Flat => None,
            Normals::PerVertex(bind) => {
                let vertices = mesh.position_of_vertices().zip(bind.iter().copied());
                Some(skinning::skin_normals(
                    &palette,
                    &self.attachments,
                    vertices,
                ))
            }
        };
        Skinned { positions, normals }
    }

    /// Skinned vertices with the joints' frames at `model_from_joint`, with dual quaternions: the mesh
    /// keeps its volume where joints twist. Scale and shear in a joint's matrix are left out.
    pub fn skin_by_dual_quaternions(&self, model_from_joint: &[Mat4]) -> Skinned {
        let palette = self.skeleton.palette(model_from_joint);
        let mesh = &self.bind_mesh;
        let positions =
            dual_quaternions::skin_positions(&palette, &self.attachments, &mesh.positions);
        let normals = match &mesh.normals {
            Normals::Flat => None,
            Normals::PerVertex(bind) => {
                let vertices = mesh.position_of_vertices().zip(bind.iter().copied());
                Some(dual_quaternions::skin_normals(
                    &palette,
                    &self.attachments,
                    vertices,
                ))
            }
        };
        Skinned { positions, normals }
    }

    /// Conservative bounds of the mesh, in model space, with the joints' frames at
    /// `model_from_joint`: larger than the tightest box, but found without skinning a vertex.
    pub fn conservative_bounds(&self, model_from_joint: &[Mat4]) -> Aabb {
        self.bounds.under(&self.skeleton.palette(model_from_joint))
    }

    /// The same character with at most `most` influences per vertex, see [`Attachments::limited`].
    pub fn limited(&self, most: usize) -> Self {
        let attachments = self.attachments.limited(most);
        let joints = self.skeleton.joints().len();
        Self {
            bounds: ConservativeBounds::new(&attachments, &self.bind_mesh.positions, joints),
            attachments,
            blocks: OnceLock::new(),
            ..self.clone()
        }
    }

    /// Skinned vertices under `pose`, in model space and in the order of the file.
    pub fn skin_pose(&self, pose: &Pose) -> Vec<Vec3> {
        let model_from_joint = self.skeleton.update_current_joint_to_world_transforms(pose);
        self.skin(&model_from_joint).positions
    }
}
