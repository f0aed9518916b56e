use super::evaluate_curves::{EvaluatedCurves, evaluate_curves};
use super::{CharacterShape, Scene, Shape, ShapeId, ShapeKind};
use crate::character::StickFigure;
use crate::geometry::{Normals, Revision, SharedMesh};
use crate::math::Aabb;
use glam::{Mat4, Vec3};
use std::collections::HashMap;
use std::sync::Arc;

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
    /// The deformed positions, as many as the mesh has; `None` where nothing deforms it.
    pub skinned: Option<Vec<Vec3>>,
    /// The deformed normals, as many as the mesh has vertices; `None` where nothing deforms it or
    /// its triangles are flat.
    pub skinned_normals: Option<Vec<Vec3>>,
    /// Joints and bones of a character.
    pub figure: Option<StickFigure>,
    /// Curves, control points, wireframe and parts of a shape made of curves.
    pub curves: Option<EvaluatedCurves>,
    /// Changes whenever positions do.
    pub revision: Revision,
    /// Around the mesh, the joints and the curves, in model space; not around control points.
    pub bounds: Aabb,
}

impl EvaluatedGeometry {
    /// The current positions, in the order of the file.
    pub fn positions(&self) -> &[Vec3] {
        self.skinned.as_deref().unwrap_or(&self.mesh.positions)
    }

    /// The current normals, one a vertex of the mesh; `None` where its triangles are flat.
    pub fn normals(&self) -> Option<&[Vec3]> {
        match (&self.skinned_normals, &self.mesh.normals) {
            (Some(skinned), _) => Some(skinned),
            (None, Normals::PerVertex(normals)) => Some(normals),
            (None, Normals::Flat) => None,
        }
    }
}

impl EvaluatedShape {
    /// The box around the shape in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.geometry.bounds.transformed(self.world_from_model)
    }
}

impl Evaluated {
    /// The shape called `id`.
    pub fn shape(&self, id: ShapeId) -> Option<&EvaluatedShape> {
        self.shapes.iter().find(|shape| shape.id == id)
    }

    /// The box around everything, in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.shapes
            .iter()
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

    /// Works out all that follows from `scene`.
    pub fn evaluate(&mut self, scene: &Scene) -> Evaluated {
        self.cache.retain(|&id, _| scene.shape(id).is_some());
        let shapes = scene
            .shapes()
            .iter()
            .map(|shape| EvaluatedShape {
                id: shape.id,
                world_from_model: shape.placement.transform.world_from_model(),
                geometry: self.geometry(shape),
            })
            .collect();
        Evaluated { shapes }
    }

    fn geometry(&mut self, shape: &Shape) -> Arc<EvaluatedGeometry> {
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
            ShapeKind::Character(character) => evaluate_character(character),
            ShapeKind::Curve(curve) => evaluate_curves(curve),
            other => {
                let mesh = other.mesh();
                EvaluatedGeometry {
                    bounds: mesh.bounds(),
                    mesh,
                    skinned: None,
                    skinned_normals: None,
                    figure: None,
                    curves: None,
                    revision,
                }
            }
        });
        self.cache.insert(shape.id, geometry.clone());
        geometry
    }
}

fn evaluate_character(shape: &CharacterShape) -> EvaluatedGeometry {
    let character = &shape.character;
    let skeleton = character.skeleton();
    let model_from_joint = skeleton.update_current_joint_to_world_transforms(shape.pose());
    let skinned = character.skin(&model_from_joint);
    let figure = StickFigure::new(skeleton, &model_from_joint);
    let around = skinned.iter().chain(&figure.joints).copied();
    EvaluatedGeometry {
        mesh: character.bind_mesh().clone(),
        bounds: Aabb::from_points(around),
        skinned: Some(skinned),
        skinned_normals: character.skin_normals(&model_from_joint),
        figure: Some(figure),
        curves: None,
        revision: shape.pose_revision(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_did_not_change_is_not_worked_out_again() {
        let mut scene = Scene::new();
        let cube = scene.add("Cube".into(), ShapeKind::Cube, None);
        let mut evaluator = Evaluator::new();
        let first = evaluator.evaluate(&scene);
        if let Some(shape) = scene.shape_mut(cube) {
            shape.placement.transform.position = Vec3::X;
        }
        let second = evaluator.evaluate(&scene);
        assert!(Arc::ptr_eq(
            &first.shapes[0].geometry,
            &second.shapes[0].geometry
        ));
        assert_eq!(second.shapes[0].world_bounds().center(), Vec3::X);
    }
}
