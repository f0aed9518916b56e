//! Scenes with fewer triangles, for pictures that are seen for a moment.

use super::{Evaluated, EvaluatedGeometry, EvaluatedShape, ShapeId};
use crate::character::Character;
use crate::geometry::{CoarseMesh, SharedMesh};
use std::collections::HashMap;
use std::sync::Arc;

/// Triangles of a mesh up to which it stays as it is.
const FEW: usize = 4_000;

/// Makes evaluations of scenes coarse, and keeps what it has made of their meshes while these are there.
#[derive(Debug, Default)]
pub struct Coarsener {
    /// By how much all that is kept is coarser.
    fewer: u32,
    /// Models, and what they were made; `None` for one that stays as it is.
    models: Vec<(Model, Option<Model>)>,
    shapes: HashMap<ShapeId, CoarseShape>,
}

/// What an evaluated shape was made.
#[derive(Debug)]
struct CoarseShape {
    of: Arc<EvaluatedGeometry>,
    coarse: Arc<EvaluatedGeometry>,
}

/// What the vertices of a shape follow from.
#[derive(Clone, Debug)]
enum Model {
    Rigid(SharedMesh),
    Character(Arc<Character>),
}

impl Coarsener {
    /// `evaluated` with at most about `most` triangles in the meshes that have many; `None` if it has no more than
    /// that, or no such meshes. Vertices are where the scene has them, of characters as its joints take them. The
    /// surfaces of curves stay, and so does what was put elsewhere than where its joints take it.
    pub fn coarse(&mut self, evaluated: &Evaluated, most: usize) -> Option<Evaluated> {
        let visible = evaluated.shapes.iter().filter(|shape| shape.visible);
        let triangles = visible.map(|shape| shape.geometry.mesh.triangles.len());
        let share = triangles.sum::<usize>().div_ceil(most.max(1));
        if share <= 1 {
            return None;
        }
        // A power of two, so that few scenes have their meshes made anew when a shape comes or goes.
        let fewer = u32::try_from(share)
            .unwrap_or(u32::MAX / 2)
            .next_power_of_two();
        if fewer != self.fewer {
            *self = Self {
                fewer,
                ..Self::default()
            };
        }
        let mut coarse = evaluated.clone();
        let mut is_coarse = false;
        for shape in coarse.shapes.iter_mut().filter(|shape| shape.visible) {
            if let Some(made) = self.of_shape(shape) {
                shape.geometry = made;
                is_coarse = true;
            }
        }
        is_coarse.then_some(coarse)
    }

    /// Forgets what it has made of meshes that are not in a scene any more.
    pub fn forget_deleted(&mut self, evaluated: &Evaluated) {
        let is_there = |of: &Model| {
            let mut all = evaluated.shapes.iter();
            all.any(|shape| Model::of(&shape.geometry).is_some_and(|is| is.is(of)))
        };
        self.models.retain(|(of, _)| is_there(of));
        self.shapes.retain(|id, _| evaluated.shape(*id).is_some());
    }

    /// The geometry of `shape`, made coarse; that of the last call, if it is the same.
    fn of_shape(&mut self, shape: &EvaluatedShape) -> Option<Arc<EvaluatedGeometry>> {
        let geometry = &shape.geometry;
        let known = self.shapes.get(&shape.id);
        if let Some(known) = known.filter(|known| Arc::ptr_eq(&known.of, geometry)) {
            return Some(Arc::clone(&known.coarse));
        }
        let of = Model::of(geometry).filter(|_| geometry.mesh.triangles.len() > FEW)?;
        let coarse = Arc::new(self.of_model(of)?.evaluated_as(geometry));
        let made = CoarseShape {
            of: Arc::clone(geometry),
            coarse: Arc::clone(&coarse),
        };
        self.shapes.insert(shape.id, made);
        Some(coarse)
    }

    /// The same model as `of`, made coarse.
    fn of_model(&mut self, of: Model) -> Option<Model> {
        if let Some((_, known)) = self.models.iter().find(|(known, _)| known.is(&of)) {
            return known.clone();
        }
        let coarse = of.coarse(self.fewer);
        self.models.push((of, coarse.clone()));
        coarse
    }
}

impl Model {
    /// That of a geometry; `None` if its vertices follow from something else.
    fn of(geometry: &EvaluatedGeometry) -> Option<Self> {
        match (&geometry.deformation, &geometry.curves) {
            (None, None) => Some(Self::Rigid(geometry.mesh.clone())),
            (Some(deformation), _) if deformation.is_by_joints() => {
                Some(Self::Character(deformation.character().clone()))
            }
            _ => None,
        }
    }

    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Rigid(a), Self::Rigid(b)) => a.revision() == b.revision(),
            (Self::Character(a), Self::Character(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    fn coarse(&self, fewer: u32) -> Option<Self> {
        match self {
            Self::Rigid(mesh) => {
                let coarse = CoarseMesh::new(mesh, fewer, |_| 0)?;
                Some(Self::Rigid(SharedMesh::with_bounds(
                    coarse.mesh,
                    mesh.bounds(),
                )))
            }
            Self::Character(character) => Some(Self::Character(Arc::new(character.coarse(fewer)?))),
        }
    }

    /// The shape of `geometry` as this model has it.
    fn evaluated_as(&self, geometry: &EvaluatedGeometry) -> EvaluatedGeometry {
        let (mesh, deformation) = match self {
            Self::Rigid(mesh) => (mesh, None),
            Self::Character(character) => {
                let deformation = geometry.deformation.as_ref();
                let its = deformation.map(|deformation| deformation.of_character(character));
                (character.bind_mesh(), its)
            }
        };
        geometry.with_mesh(mesh.clone(), deformation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::{Poles, sphere};
    use crate::math::Euler;
    use crate::scene::{CharacterShape, Evaluator, NewShape, Scene, ShapeKind};
    use glam::Vec3;
    use std::collections::HashSet;

    /// A ball, its upper half moved by one joint and its lower one by another.
    fn character() -> Character {
        let child = Joint {
            parent: Some(0),
            ..Joint::default()
        };
        let ball = sphere(1.0, 150, 100, Poles::Y);
        let mut attachments = Attachments::new();
        for at in &ball.positions {
            let upper = at.y.clamp(0.0, 1.0);
            let influences = [(0, 1.0 - upper), (1, upper)];
            attachments.push_vertex(influences.map(|(joint, weight)| Influence { joint, weight }));
        }
        let skeleton = SkeletalModel::new(vec![Joint::default(), child]).unwrap();
        Character::new(skeleton, attachments, ball).unwrap()
    }

    fn turned(shape: &mut CharacterShape, degrees: f32) {
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(Vec3::Z * degrees));
        shape.set_pose(pose);
    }

    fn scene() -> Scene {
        let mut shape = CharacterShape::new(Arc::new(character()));
        turned(&mut shape, 40.0);
        let mut scene = Scene::new();
        scene.add(NewShape::new("A", ShapeKind::Character(shape.clone())));
        scene.add(NewShape::new("B", ShapeKind::Character(shape)));
        scene.add(NewShape::new("C", ShapeKind::Cube));
        let ball = SharedMesh::new(sphere(1.0, 200, 100, Poles::Y));
        scene.add(NewShape::new("D", ShapeKind::Mesh(ball)));
        scene
    }

    fn meshes(evaluated: &Evaluated) -> Vec<&EvaluatedGeometry> {
        evaluated
            .shapes
            .iter()
            .map(|shape| &*shape.geometry)
            .collect()
    }

    #[test]
    fn vertices_of_a_coarse_scene_are_where_the_scene_has_them() {
        let evaluated = Evaluator::new().evaluate(&scene(), 0.0);
        let coarse = Coarsener::default().coarse(&evaluated, 20_000).unwrap();
        let total = |evaluated: &Evaluated| -> usize {
            meshes(evaluated)
                .iter()
                .map(|it| it.mesh.triangles.len())
                .sum()
        };
        assert!(
            (10_000..40_000).contains(&total(&coarse)),
            "{}",
            total(&coarse)
        );
        assert!(total(&evaluated) > 90_000);
        for (is, was) in meshes(&coarse).into_iter().zip(meshes(&evaluated)) {
            let all: HashSet<_> = was
                .positions()
                .iter()
                .map(|at| at.to_array().map(f32::to_bits))
                .collect();
            for at in is.positions() {
                assert!(all.contains(&at.to_array().map(f32::to_bits)), "{at}");
            }
            assert_eq!(is.mesh.bounds(), was.mesh.bounds(), "the ground stays");
        }
        let [_, _, cube, _] = meshes(&coarse)[..] else {
            panic!()
        };
        assert_eq!(cube.mesh.triangles.len(), 12, "small meshes stay");
    }

    #[test]
    fn copies_share_a_coarse_mesh_which_is_made_once() {
        let mut scene = scene();
        let mut evaluator = Evaluator::new();
        let mut coarsener = Coarsener::default();
        let first = coarsener
            .coarse(&evaluator.evaluate(&scene, 0.0), 20_000)
            .unwrap();
        let again = coarsener
            .coarse(&evaluator.evaluate(&scene, 0.0), 20_000)
            .unwrap();
        for (a, b) in first.shapes.iter().zip(&again.shapes) {
            assert!(Arc::ptr_eq(&a.geometry, &b.geometry));
        }
        let id = scene.shapes()[0].id;
        turned(scene.character_mut(id).unwrap(), 50.0);
        let posed = coarsener
            .coarse(&evaluator.evaluate(&scene, 0.0), 20_000)
            .unwrap();
        let revisions = |evaluated: &Evaluated| -> Vec<_> {
            meshes(evaluated)
                .iter()
                .map(|it| it.mesh.revision())
                .collect()
        };
        assert_eq!(revisions(&posed), revisions(&first));
        assert_eq!(revisions(&first)[0], revisions(&first)[1]);
        assert!(!Arc::ptr_eq(
            &posed.shapes[0].geometry,
            &first.shapes[0].geometry
        ));
        assert!(Arc::ptr_eq(
            &posed.shapes[1].geometry,
            &first.shapes[1].geometry
        ));
    }

    #[test]
    fn what_is_deleted_is_kept_no_longer() {
        let mut scene = scene();
        let mut coarsener = Coarsener::default();
        let mut evaluator = Evaluator::new();
        let evaluated = evaluator.evaluate(&scene, 0.0);
        coarsener.coarse(&evaluated, 20_000).unwrap();
        coarsener.forget_deleted(&evaluated);
        assert_eq!((coarsener.models.len(), coarsener.shapes.len()), (2, 3));
        for index in [3, 1] {
            scene.delete(scene.shapes()[index].id);
        }
        coarsener.forget_deleted(&evaluator.evaluate(&scene, 0.0));
        assert_eq!((coarsener.models.len(), coarsener.shapes.len()), (1, 1));
    }

    #[test]
    fn a_scene_without_too_many_triangles_and_one_of_small_meshes_stay_as_they_are() {
        let evaluated = Evaluator::new().evaluate(&scene(), 0.0);
        let mut coarsener = Coarsener::default();
        assert!(coarsener.coarse(&evaluated, 1_000_000).is_none());
        let mut cubes = Scene::new();
        for _ in 0..20 {
            cubes.add(NewShape::new("A", ShapeKind::Cube));
        }
        let evaluated = Evaluator::new().evaluate(&cubes, 0.0);
        assert!(coarsener.coarse(&evaluated, 100).is_none());
    }

    #[test]
    fn vertices_that_were_put_elsewhere_stay_there() {
        let mut scene = scene();
        scene.delete(scene.shapes()[3].id);
        let mut evaluated = Evaluator::new().evaluate(&scene, 0.0);
        for shape in &mut evaluated.shapes[..2] {
            let moved = vec![Vec3::ONE; shape.geometry.mesh.positions.len()];
            shape.geometry = Arc::new(shape.geometry.with_vertices(moved, None).unwrap());
        }
        assert!(Coarsener::default().coarse(&evaluated, 100).is_none());
    }
}
