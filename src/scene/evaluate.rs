use super::deformation::Deformation;
use super::evaluate_curves::{EvaluatedCurves, evaluate_curves};
use super::ground::ground;
use super::{CharacterShape, Scene, Shape, ShapeId, ShapeKind};
use crate::character::{Skinned, StickFigure};
use crate::geometry::{Normals, SharedMesh, TriangleBoxes, enclosed_volume};
use crate::math::{Aabb, Ray, TriangleHit};
use crate::revision::Revision;
use glam::{Mat4, Vec3};
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, OnceLock};

/// Evaluated scene: matrices, deformed vertices, bounds.
#[derive(Clone, Debug, Default)]
pub struct Evaluated {
    /// Evaluated shapes, in the order of the scene.
    pub shapes: Vec<EvaluatedShape>,
}

/// Evaluated shape.
#[derive(Clone, Debug)]
pub struct EvaluatedShape {
    /// Identifier of the shape.
    pub id: ShapeId,
    /// Whether it is drawn.
    pub visible: bool,
    /// Whether it can be picked in the view: it is drawn and not locked.
    pub pickable: bool,
    /// Transform from model space to the world.
    pub world_from_model: Mat4,
    /// Height, in the world, of the ground below it: of its lowest vertex at rest, or of the box round a curve, but for how far it
    /// was moved down from where it was inserted. Infinite if it has neither.
    pub ground: f32,
    /// Geometry under the current pose, in model space.
    pub geometry: Arc<EvaluatedGeometry>,
}

/// Geometry of a shape in model space; the same `Arc` until something changes it.
#[derive(Clone, Debug)]
pub struct EvaluatedGeometry {
    /// Triangles, materials and undeformed vertices; of curves, all their surfaces.
    pub mesh: SharedMesh,
    /// Deformation of the mesh by joints; `None` if it is rigid.
    pub deformation: Option<Deformation>,
    /// Joints and bones of a character.
    pub figure: Option<StickFigure>,
    /// Curves, control points, wireframe and parts of a shape made of curves.
    pub curves: Option<EvaluatedCurves>,
    /// Revision, which changes whenever positions do.
    pub revision: Revision,
    /// Bounds of all but a deformed mesh, whose bounds are computed on demand.
    pub(super) fixed_bounds: Aabb,
    pub(super) bounds: OnceLock<Aabb>,
    /// See [`EvaluatedGeometry::conservative_bounds`].
    pub(super) conservative_bounds: OnceLock<Aabb>,
    /// Boxes over the triangles for rays.
    pub(super) boxes: OnceLock<TriangleBoxes>,
    /// See [`EvaluatedGeometry::volume_kept`].
    pub(super) volume_kept: OnceLock<Option<f64>>,
}

impl EvaluatedGeometry {
    /// Rigid geometry within `bounds`, in model space.
    pub fn rigid(mesh: SharedMesh, bounds: Aabb, revision: Revision) -> Self {
        Self {
            mesh,
            deformation: None,
            figure: None,
            curves: None,
            revision,
            fixed_bounds: bounds,
            bounds: OnceLock::new(),
            conservative_bounds: OnceLock::new(),
            boxes: OnceLock::new(),
            volume_kept: OnceLock::new(),
        }
    }

    /// The same character with its vertices elsewhere than where its joints take them: `positions`, one
    /// for each of the mesh, and unit `normals`, one for each vertex, or none if its triangles are flat.
    /// `None` for a shape without joints.
    pub fn with_vertices(&self, positions: Vec<Vec3>, normals: Option<Vec<Vec3>>) -> Option<Self> {
        let deformation = self.deformation.as_ref()?;
        Some(Self {
            deformation: Some(deformation.with_vertices(Skinned { positions, normals })),
            revision: Revision::new(),
            bounds: OnceLock::new(),
            conservative_bounds: OnceLock::new(),
            boxes: OnceLock::new(),
            volume_kept: OnceLock::new(),
            ..self.clone()
        })
    }

    /// The same with another mesh, whose vertices are some of this one's.
    pub(super) fn with_mesh(&self, mesh: SharedMesh, deformation: Option<Deformation>) -> Self {
        Self {
            deformation,
            figure: self.figure.clone(),
            ..Self::rigid(mesh, self.fixed_bounds, self.revision)
        }
    }

    /// Current positions in model space, in the order of the file.
    pub fn positions(&self) -> &[Vec3] {
        self.deformation
            .as_ref()
            .map_or(&self.mesh.positions, Deformation::positions)
    }

    /// Current normals, one per vertex of the mesh; `None` if its triangles are flat.
    pub fn normals(&self) -> Option<&[Vec3]> {
        match (&self.deformation, &self.mesh.normals) {
            (_, Normals::Flat) => None,
            (Some(deformation), _) => deformation.normals(),
            (None, Normals::PerVertex(normals)) => Some(normals),
        }
    }

    /// Bounds of mesh, joints and curves, in model space; control points do not count.
    pub fn bounds(&self) -> Aabb {
        *self.bounds.get_or_init(|| match &self.deformation {
            Some(deformation) => {
                let deformed = deformation.positions().iter().copied();
                self.fixed_bounds.union(Aabb::from_points(deformed))
            }
            None => self.fixed_bounds,
        })
    }

    /// Volume of the mesh relative to that of the bind pose; `None` if the mesh is not closed.
    pub fn volume_kept(&self) -> Option<f64> {
        *self.volume_kept.get_or_init(|| {
            let triangles = &self.mesh.triangles;
            let bind = enclosed_volume(&self.mesh.positions, triangles)?;
            let kept = enclosed_volume(self.positions(), triangles)? / bind;
            kept.is_finite().then_some(kept)
        })
    }

    /// Distance at which `ray`, in model space, first meets the surface.
    pub fn nearest_surface(&self, ray: &Ray) -> Option<f32> {
        let (_, hit) = self.nearest_triangle(ray)?;
        Some(hit.distance)
    }

    /// Index of the position nearest to where `ray`, in model space, first meets the surface, of the
    /// three that the triangle there has.
    pub fn nearest_vertex(&self, ray: &Ray) -> Option<usize> {
        let (triangle, hit) = self.nearest_triangle(ray)?;
        let (at, positions) = (ray.at(hit.distance), self.positions());
        let corners = self.mesh.triangles[triangle].map(|corner| corner as usize);
        let distance = |corner: &usize| positions[*corner].distance(at);
        corners
            .into_iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Index of the position that is the nearest to the line of `ray`, in model space, seen from where that begins.
    pub fn vertex_beside(&self, ray: &Ray) -> Option<usize> {
        let along = ray.direction.normalize_or_zero();
        let angle = |at: Vec3| {
            let from = at - ray.origin;
            from.reject_from_normalized(along).length() / from.length()
        };
        let positions = self.positions().iter().enumerate();
        let nearest = positions.min_by(|a, b| angle(*a.1).total_cmp(&angle(*b.1)));
        nearest.map(|(index, _)| index)
    }

    /// Index of the triangle that `ray`, in model space, meets first, and where.
    pub(super) fn nearest_triangle(&self, ray: &Ray) -> Option<(usize, TriangleHit)> {
        let (positions, triangles) = (self.positions(), &self.mesh.triangles);
        let order = self.mesh.triangle_order();
        let boxes = self.boxes.get_or_init(|| order.boxes(positions, triangles));
        order.nearest(boxes, ray, positions, triangles)
    }

    /// Box that contains the mesh, in model space: its bounds if they are known, else a larger box
    /// that follows from the joints, without skinning a vertex.
    pub(super) fn conservative_bounds(&self) -> Aabb {
        match &self.deformation {
            Some(deformation) if !deformation.is_worked_out() => {
                let without_vertices = || deformation.conservative_bounds();
                *self.conservative_bounds.get_or_init(without_vertices)
            }
            _ => self.bounds(),
        }
    }
}

impl EvaluatedShape {
    /// Bounds of the shape, in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.geometry.bounds().transformed(self.world_from_model)
    }

    /// How many times as long as in the model lengths are in the world, in the mean of all directions.
    pub fn scale(&self) -> f32 {
        self.world_from_model.determinant().abs().cbrt()
    }

    /// Whether `ray`, in the world, meets the surface.
    pub fn is_met_by(&self, ray: &Ray) -> bool {
        let ray = ray.transformed(self.world_from_model.inverse());
        self.geometry.nearest_surface(&ray).is_some()
    }

    /// Box in the world that contains the shape, but for its control points: its bounds if they are
    /// known, else a larger one for which no vertex is skinned.
    pub fn world_box(&self) -> Aabb {
        let inside = self.geometry.conservative_bounds();
        inside.transformed(self.world_from_model)
    }
}

impl Evaluated {
    /// Evaluated shape of this identifier.
    pub fn shape(&self, id: ShapeId) -> Option<&EvaluatedShape> {
        self.shapes.iter().find(|shape| shape.id == id)
    }

    /// Bounds of everything that is visible, in the world.
    pub fn world_bounds(&self) -> Aabb {
        self.shapes
            .iter()
            .filter(|shape| shape.visible)
            .fold(Aabb::EMPTY, |all, shape| all.union(shape.world_bounds()))
    }
}

/// Evaluator of scenes, which caches what did not change: only a shape whose pose or curves have a
/// new revision is evaluated again.
#[derive(Debug, Default)]
pub struct Evaluator {
    cache: HashMap<ShapeId, Arc<EvaluatedGeometry>>,
}

impl Evaluator {
    /// An evaluator with an empty cache.
    pub fn new() -> Self {
        Self::default()
    }

    /// Evaluates `scene` at `time`, in seconds of playback.
    pub fn evaluate(&mut self, scene: &Scene, time: f64) -> Evaluated {
        let there: HashSet<ShapeId> = scene.shapes().iter().map(|shape| shape.id).collect();
        self.cache.retain(|id, _| there.contains(id));
        let shapes = scene
            .shapes()
            .iter()
            .map(|shape| {
                let geometry = self.geometry(shape, time);
                EvaluatedShape {
                    id: shape.id,
                    visible: shape.visible,
                    pickable: shape.visible && !shape.locked,
                    world_from_model: shape.placement.transform.world_from_model(),
                    ground: ground(shape, &geometry),
                    geometry,
                }
            })
            .collect();
        Evaluated { shapes }
    }

    fn geometry(&mut self, shape: &Shape, time: f64) -> Arc<EvaluatedGeometry> {
        let revision = match &shape.kind {
            ShapeKind::Character(character) => character.revision_at(time),
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
    let figure = StickFigure::new(skeleton, &model_from_joint).with_lone_joints(character);
    let around_joints = Aabb::from_points(figure.joints.iter().copied());
    let mesh = character.bind_mesh().clone();
    EvaluatedGeometry {
        deformation: Some(Deformation::new(
            character.clone(),
            model_from_joint,
            shape.skinning_method(),
        )),
        figure: Some(figure),
        ..EvaluatedGeometry::rigid(mesh, around_joints, shape.revision_at(time))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::Mesh;
    use crate::scene::NewShape;

    #[test]
    fn vertices_are_deformed_when_they_are_asked_for_and_not_before() {
        let skeleton = SkeletalModel::new(vec![Joint::default()]).unwrap();
        let mut attachments = Attachments::new();
        attachments.push_vertex([Influence {
            joint: 0,
            weight: 1.0,
        }]);
        let mesh = Mesh::new(vec![Vec3::X * 2.0], Vec::new());
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = Pose::new();
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
        // The joint has moved to (0, 1, 0), and belongs to what is seen.
        assert_eq!(geometry.bounds().min, Vec3::new(0.0, 1.0, 0.0));
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
