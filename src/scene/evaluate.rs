use super::evaluate_curves::{EvaluatedCurves, evaluate_curves};
use super::{CharacterShape, Deformation, Scene, Shape, ShapeId, ShapeKind};
use crate::character::StickFigure;
use crate::geometry::{Normals, SharedMesh};
use crate::math::Aabb;
use crate::revision::Revision;
use glam::{Mat4, Vec3};
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, OnceLock};

/// Everything that follows from a scene: matrices, deformed vertices, bounds.
#[derive(Clone, Debug, Default)]
pub struct Evaluated {
    /// One a shape, in the order of the scene.
    pub shapes: Vec<EvaluatedShape>,
}

/// What follows from one shape.
#[derive(Clone, Debug)]
pub struct EvaluatedShape {
    /// Which shape.
    pub id: ShapeId,
    /// Whether it is drawn.
    pub visible: bool,
    /// Whether the pointer finds it in the view: it is drawn and not locked.
    pub pickable: bool,
    /// Where it stands.
    pub world_from_model: Mat4,
    /// Its geometry under its current pose, in model space.
    pub geometry: Arc<EvaluatedGeometry>,
}

/// A shape's geometry in model space; the same `Arc` for as long as nothing changes it.
#[derive(Clone, Debug)]
pub struct EvaluatedGeometry {
    /// Triangles, materials and undeformed vertices; of curves, all their surfaces.
    pub mesh: SharedMesh,
    /// What joints do to the mesh; `None` where nothing deforms it.
    pub deformation: Option<Deformation>,
    /// Joints and bones of a character.
    pub figure: Option<StickFigure>,
    /// Curves, control points, wireframe and parts of a shape made of curves.
    pub curves: Option<EvaluatedCurves>,
    /// Changes whenever positions do.
    pub revision: Revision,
    /// Around all but a deformed mesh, whose bounds are worked out when they are asked for.
    pub(super) fixed_bounds: Aabb,
    pub(super) bounds: OnceLock<Aabb>,
}

impl EvaluatedGeometry {
    /// What nothing deforms, with `bounds` around all of it.
    pub(super) fn rigid(mesh: SharedMesh, bounds: Aabb, revision: Revision) -> Self {
        Self {
            mesh,
            deformation: None,
            figure: None,
            curves: None,
            revision,
            fixed_bounds: bounds,
            bounds: OnceLock::new(),
        }
    }

    /// The current positions, in the order of the file.
    pub fn positions(&self) -> &[Vec3] {
        self.deformation
            .as_ref()
            .map_or(&self.mesh.positions, Deformation::positions)
    }

    /// The current normals, one a vertex of the mesh; `None` where its triangles are flat.
    pub fn normals(&self) -> Option<&[Vec3]> {
        match (&self.deformation, &self.mesh.normals) {
            (_, Normals::Flat) => None,
            (Some(deformation), _) => deformation.normals(),
            (None, Normals::PerVertex(normals)) => Some(normals),
        }
    }

    /// Around the mesh, the joints and the curves, in model space; not around control points.
    pub fn bounds(&self) -> Aabb {
        *self.bounds.get_or_init(|| match &self.deformation {
            Some(deformation) => {
                let deformed = deformation.positions().iter().copied();
                self.fixed_bounds.union(Aabb::from_points(deformed))
            }
            None => self.fixed_bounds,
        })
    }

    /// A box that the mesh does not leave, in model space: what is around it where that is known,
    /// else a larger one that follows from the joints, without moving a vertex.
    pub(super) fn reach(&self) -> Aabb {
        match &self.deformation {
            Some(deformation) if !deformation.is_worked_out() => deformation.reach(),
            _ => self.bounds(),
        }
    }
}

impl EvaluatedShape {
    /// The box around the shape in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.geometry.bounds().transformed(self.world_from_model)
    }
}

impl Evaluated {
    /// The shape called `id`.
    pub fn shape(&self, id: ShapeId) -> Option<&EvaluatedShape> {
        self.shapes.iter().find(|shape| shape.id == id)
    }

    /// The box around everything that is visible, in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.shapes
            .iter()
            .filter(|shape| shape.visible)
            .fold(Aabb::EMPTY, |all, shape| all.union(shape.world_bounds()))
    }
}

/// Evaluates scenes and keeps what did not change: only a shape whose pose or
/// curves have a new revision is worked out again.
#[derive(Debug, Default)]
pub struct Evaluator {
    cache: HashMap<ShapeId, Arc<EvaluatedGeometry>>,
}

impl Evaluator {
    /// One that has seen nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Works out all that follows from `scene` at `time`, in seconds of playback.
    pub fn evaluate(&mut self, scene: &Scene, time: f64) -> Evaluated {
        let there: HashSet<ShapeId> = scene.shapes().iter().map(|shape| shape.id).collect();
        self.cache.retain(|id, _| there.contains(id));
        let shapes = scene
            .shapes()
            .iter()
            .map(|shape| EvaluatedShape {
                id: shape.id,
                visible: shape.visible,
                pickable: shape.visible && !shape.locked,
                world_from_model: shape.placement.transform.world_from_model(),
                geometry: self.geometry(shape, time),
            })
            .collect();
        Evaluated { shapes }
    }

    fn geometry(&mut self, shape: &Shape, time: f64) -> Arc<EvaluatedGeometry> {
        let revision = match &shape.kind {
            ShapeKind::Character(character) => character.pose_revision(),
            ShapeKind::Curve(curve) => curve.revision(),
            other => other.mesh().revision(),
        };
        if let Some(known) = self.cache.get(&shape.id)
            && known.revision == revision
        {
            return known.clone();
        }
        let geometry = Arc::new(match &shape.kind {
            ShapeKind::Character(character) => evaluate_character(character, time),
            ShapeKind::Curve(curve) => evaluate_curves(curve),
            other => {
                let mesh = other.mesh();
                let bounds = mesh.bounds();
                EvaluatedGeometry::rigid(mesh, bounds, revision)
            }
        });
        self.cache.insert(shape.id, geometry.clone());
        geometry
    }
}

fn evaluate_character(shape: &CharacterShape, time: f64) -> EvaluatedGeometry {
    let character = &shape.character;
    let skeleton = character.skeleton();
    let model_from_joint = skeleton.update_current_joint_to_world_transforms(shape.pose_at(time));
    let figure = StickFigure::new(skeleton, &model_from_joint);
    let around_joints = Aabb::from_points(figure.joints.iter().copied());
    let mesh = character.bind_mesh().clone();
    EvaluatedGeometry {
        deformation: Some(Deformation::new(character.clone(), model_from_joint)),
        figure: Some(figure),
        ..EvaluatedGeometry::rigid(mesh, around_joints, shape.pose_revision())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::NewShape;

    #[test]
    fn vertices_are_deformed_when_they_are_asked_for_and_not_before() {
        let joint = crate::character::Joint::default();
        let skeleton = crate::character::SkeletalModel::new(vec![joint]).unwrap();
        let mut attachments = crate::character::Attachments::new();
        attachments.push_vertex([crate::character::Influence {
            joint: 0,
            weight: 1.0,
        }]);
        let mesh = crate::geometry::Mesh::new(vec![Vec3::X * 2.0], Vec::new());
        let character = crate::character::Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = crate::character::Pose::new();
        pose.set_root_offset(0, Vec3::Y);
        shape.set_pose(pose);
        let mut scene = Scene::new();
        scene.add(NewShape::new("Dot", ShapeKind::Character(shape)));
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let geometry = &evaluated.shapes[0].geometry;
        let deformation = geometry.deformation.as_ref().unwrap();
        assert!(!deformation.is_worked_out());
        assert_eq!(geometry.bounds().max, Vec3::new(2.0, 1.0, 0.0));
        assert!(deformation.is_worked_out());
    }

    #[test]
    fn what_did_not_change_is_not_worked_out_again() {
        let mut scene = Scene::new();
        let cube = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let mut evaluator = Evaluator::new();
        let first = evaluator.evaluate(&scene, 0.0);
        if let Some(shape) = scene.shape_mut(cube) {
            shape.placement.transform.position = Vec3::X;
        }
        let second = evaluator.evaluate(&scene, 0.0);
        assert!(Arc::ptr_eq(
            &first.shapes[0].geometry,
            &second.shapes[0].geometry
        ));
        assert_eq!(second.shapes[0].world_bounds().center(), Vec3::X);
    }
}
