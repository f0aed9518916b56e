//! Vertices that follow from a pose.

use super::SkinningMethod;
use crate::character::{Character, Skinned};
use crate::math::Aabb;
use glam::{Mat4, Vec3};
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

/// Deformation of a character's mesh by a pose: frames of its joints, and the vertices that follow.
///
/// Vertices are computed on demand and then kept: where the graphics card deforms the mesh for
/// drawing, only picking, export and the like need them.
#[derive(Clone, Debug)]
pub struct Deformation {
    character: Arc<Character>,
    model_from_joint: Vec<Mat4>,
    skinned: OnceLock<Skinned>,
    /// Way in which the vertices follow from the frames; `None` if they were put elsewhere.
    method: Option<SkinningMethod>,
}

impl Deformation {
    /// Deformation of `character` by `method` with the joints' frames at `model_from_joint`, one per
    /// joint.
    pub(super) fn new(
        character: Arc<Character>,
        model_from_joint: Vec<Mat4>,
        method: SkinningMethod,
    ) -> Self {
        Self {
            character,
            model_from_joint,
            skinned: OnceLock::new(),
            method: Some(method),
        }
    }

    /// The same with other vertices.
    pub(super) fn with_vertices(&self, vertices: Skinned) -> Self {
        Self {
            skinned: vertices.into(),
            method: None,
            ..self.clone()
        }
    }

    /// The same of another character with the same joints.
    pub(super) fn of_character(&self, character: &Arc<Character>) -> Self {
        Self {
            character: Arc::clone(character),
            model_from_joint: self.model_from_joint.clone(),
            skinned: OnceLock::new(),
            method: self.method,
        }
    }

    /// Whether the vertices follow from the frames at all.
    pub(super) fn is_by_joints(&self) -> bool {
        self.method.is_some()
    }

    /// Whether the vertices follow from the frames by the exact formula of linear blending, as a
    /// vertex shader computes it; not so with dual quaternions, nor after
    /// [`EvaluatedGeometry::with_vertices`](super::EvaluatedGeometry::with_vertices).
    pub fn is_exact(&self) -> bool {
        self.method == Some(SkinningMethod::LinearBlend)
    }

    /// Character that is deformed.
    pub fn character(&self) -> &Arc<Character> {
        &self.character
    }

    /// Matrices from each joint's frame to model space.
    pub fn model_from_joint(&self) -> &[Mat4] {
        &self.model_from_joint
    }

    /// `T · B⁻¹` of every joint: from the bind pose to the current pose, both in model space.
    pub fn palette(&self) -> Vec<Mat4> {
        self.character.skeleton().palette(&self.model_from_joint)
    }

    fn skinned(&self) -> &Skinned {
        // Vertices that were put elsewhere are there from the start.
        let method = self.method.unwrap_or(SkinningMethod::LinearBlend);
        self.skinned.get_or_init(|| self.skin(method))
    }

    fn skin(&self, method: SkinningMethod) -> Skinned {
        match method {
            SkinningMethod::LinearBlend => self.character.skin(&self.model_from_joint),
            SkinningMethod::DualQuaternion => {
                (self.character).skin_by_dual_quaternions(&self.model_from_joint)
            }
        }
    }

    /// The vertices as `method` has them: those that are kept, if it is the deformation's own.
    pub(super) fn skinned_by(&self, method: SkinningMethod) -> Cow<'_, Skinned> {
        if self.method == Some(method) {
            Cow::Borrowed(self.skinned())
        } else {
            Cow::Owned(self.skin(method))
        }
    }

    /// Deformed positions, as many as the mesh has, in model space.
    pub fn positions(&self) -> &[Vec3] {
        &self.skinned().positions
    }

    /// Deformed normals, one per vertex of the mesh; `None` if its triangles are flat.
    pub fn normals(&self) -> Option<&[Vec3]> {
        self.skinned().normals.as_deref()
    }

    /// Box that contains the mesh, in model space, found without skinning a vertex where
    /// they are blended linearly. Others may lie outside of that box, and count.
    pub fn conservative_bounds(&self) -> Aabb {
        if self.is_exact() {
            self.character.conservative_bounds(&self.model_from_joint)
        } else {
            Aabb::from_points(self.positions().iter().copied())
        }
    }

    /// Whether the positions have been computed.
    pub fn is_worked_out(&self) -> bool {
        self.skinned.get().is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::Mesh;
    use crate::math::Euler;
    use crate::scene::{CharacterShape, Evaluator, NewShape, Scene, ShapeKind};

    #[test]
    fn bounds_hold_what_bulges_by_dual_quaternions() {
        // A joint at rest and its child, which turns by 170°, share a vertex at distance 1: it
        // keeps that distance, while the box of where either joint carries it is flat.
        let child = Joint {
            parent: Some(0),
            ..Joint::default()
        };
        let skeleton = SkeletalModel::new(vec![Joint::default(), child]).unwrap();
        let mut attachments = Attachments::new();
        attachments.push_vertex([0, 1].map(|joint| Influence { joint, weight: 0.5 }));
        let mesh = Mesh::new(vec![Vec3::X], Vec::new());
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(Vec3::Z * 170.0));
        shape.set_pose(pose);
        for (method, highest) in [
            (SkinningMethod::LinearBlend, 170_f32.to_radians().sin()),
            (SkinningMethod::DualQuaternion, 85_f32.to_radians().sin()),
        ] {
            shape.set_skinning_method(method);
            let mut scene = Scene::new();
            scene.add(NewShape::new("Dot", ShapeKind::Character(shape.clone())));
            let evaluated = Evaluator::new().evaluate(&scene, 0.0);
            let deformation = evaluated.shapes[0].geometry.deformation.as_ref().unwrap();
            let bounds = deformation.conservative_bounds();
            assert!(
                (bounds.max.y - highest).abs() < 1e-5,
                "{method:?}: {bounds:?}"
            );
            let at = deformation.positions()[0];
            assert!(at.y <= bounds.max.y + 1e-6, "{method:?}: {at}");
        }
    }
}
