//! A character between both methods of skinning.

use super::{EvaluatedGeometry, SkinningMethod};

impl EvaluatedGeometry {
    /// The same character `share` of the way from linear blending (0) to dual quaternions (1), whatever
    /// its own method is: positions in between, and unit normals in between. `None` for a shape without
    /// joints.
    pub fn between_methods(&self, share: f32) -> Option<Self> {
        let deformation = self.deformation.as_ref()?;
        let skinned_by = |method| deformation.skinned_by(method);
        let skinned = if share <= 0.0 {
            skinned_by(SkinningMethod::LinearBlend).into_owned()
        } else if share >= 1.0 {
            skinned_by(SkinningMethod::DualQuaternion).into_owned()
        } else {
            let mut skinned = skinned_by(SkinningMethod::LinearBlend).into_owned();
            let other = skinned_by(SkinningMethod::DualQuaternion);
            for (from, to) in skinned.positions.iter_mut().zip(&other.positions) {
                *from = from.lerp(*to, share);
            }
            let normals = skinned.normals.iter_mut().flatten();
            for (from, to) in normals.zip(other.normals.iter().flatten()) {
                *from = from.lerp(*to, share).normalize_or(*from);
            }
            skinned
        };
        self.with_vertices(skinned.positions, skinned.normals)
    }
}

#[cfg(test)]
mod tests {
    use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::Mesh;
    use crate::math::Euler;
    use crate::scene::{
        CharacterShape, EvaluatedGeometry, Evaluator, NewShape, Scene, ShapeKind, SkinningMethod,
    };
    use glam::Vec3;
    use std::sync::Arc;

    /// A triangle that two joints share, of which one is twisted by 120° about y.
    fn twisted(method: SkinningMethod) -> Arc<EvaluatedGeometry> {
        let child = Joint {
            parent: Some(0),
            ..Joint::default()
        };
        let skeleton = SkeletalModel::new(vec![Joint::default(), child]).unwrap();
        let mut attachments = Attachments::new();
        for _ in 0..3 {
            attachments.push_vertex([0, 1].map(|joint| Influence { joint, weight: 0.5 }));
        }
        let mesh = Mesh::new(vec![Vec3::X, Vec3::Y, Vec3::Z], vec![[0, 1, 2]]);
        let mut shape = CharacterShape::new(Arc::new(
            Character::new(skeleton, attachments, mesh).unwrap(),
        ));
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(Vec3::Y * 120.0));
        shape.set_pose(pose);
        shape.set_skinning_method(method);
        let mut scene = Scene::new();
        scene.add(NewShape::new("Triangle", ShapeKind::Character(shape)));
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        Arc::clone(&evaluated.shapes[0].geometry)
    }

    #[test]
    fn the_ends_are_the_methods_and_between_them_vertices_are_on_the_way() {
        let [linear, dual] =
            [SkinningMethod::LinearBlend, SkinningMethod::DualQuaternion].map(twisted);
        let lengths = [&linear, &dual].map(|geometry| geometry.positions()[0].length());
        assert!((lengths[0] - 0.5).abs() < 1e-6 && (lengths[1] - 1.0).abs() < 1e-6);
        for own in [&linear, &dual] {
            let ends = [0.0, 1.0].map(|share| own.between_methods(share).unwrap());
            for (end, method) in ends.iter().zip([&linear, &dual]) {
                assert_eq!(end.positions(), method.positions());
                assert_eq!(end.normals(), method.normals());
            }
            let quarter = own.between_methods(0.25).unwrap();
            let vertices = linear.positions().iter().zip(dual.positions());
            for (found, (linear, dual)) in quarter.positions().iter().zip(vertices) {
                let expected = 0.75 * *linear + 0.25 * *dual;
                assert!(found.abs_diff_eq(expected, 1e-6), "{found} {expected}");
            }
        }
    }

    #[test]
    fn the_vertices_of_its_own_method_are_worked_out_once() {
        for method in [SkinningMethod::LinearBlend, SkinningMethod::DualQuaternion] {
            let own = twisted(method);
            let deformation = own.deformation.as_ref().unwrap();
            assert!(!deformation.is_worked_out());
            own.between_methods(0.5).unwrap();
            assert!(
                deformation.is_worked_out(),
                "{method:?} is worked out twice"
            );
        }
    }

    #[test]
    fn vertices_that_were_put_elsewhere_are_not_taken_for_those_of_a_method() {
        let own = twisted(SkinningMethod::DualQuaternion);
        let elsewhere = own.with_vertices(vec![Vec3::ONE; 3], None).unwrap();
        let dual = elsewhere.between_methods(1.0).unwrap();
        assert_eq!(dual.positions(), own.positions());
    }
}
