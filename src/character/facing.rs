use super::mirror::{Side, sided};
use super::{Mirror, SkeletalModel};
use glam::Vec3;

/// Number of joints above which only names are used: comparing all positions would take too long.
const MANY: usize = 256;

/// Direction in which a character faces at rest: one of the axes of its model space. It stands
/// along +Y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    front: Vec3,
}

impl Default for Facing {
    /// +Z, as the course's characters face.
    fn default() -> Self {
        Self { front: Vec3::Z }
    }
}

impl Facing {
    /// Finds it by the joints whose names say left or right, or else by the axis across which most
    /// joints have a partner; then it is +Z or +X, for nothing tells front from back.
    pub fn of(skeleton: &SkeletalModel) -> Self {
        let Some(left) = called_left(skeleton) else {
            return Self::by_place(skeleton);
        };
        let left = if left.x.abs() >= left.z.abs() {
            Vec3::X * left.x.signum()
        } else {
            Vec3::Z * left.z.signum()
        };
        Self {
            front: left.cross(Vec3::Y) + Vec3::ZERO,
        }
    }

    fn by_place(skeleton: &SkeletalModel) -> Self {
        let few = skeleton.joints().len() <= MANY;
        match few.then(|| Mirror::new(skeleton).axis()) {
            Some(2) => Self { front: Vec3::X },
            _ => Self::default(),
        }
    }

    /// Unit vector to the front.
    pub fn front(self) -> Vec3 {
        self.front
    }

    /// Unit vector to the character's left.
    pub fn left(self) -> Vec3 {
        Vec3::Y.cross(self.front) + Vec3::ZERO
    }
}

/// Horizontal vector from the mean position of the joints whose names say right to that of those
/// whose names say left; `None` if there are none, or they coincide.
fn called_left(skeleton: &SkeletalModel) -> Option<Vec3> {
    let places = skeleton.bind_positions();
    let (mut sums, mut counts) = ([Vec3::ZERO; 2], [0.0_f32; 2]);
    for (joint, &place) in skeleton.joints().iter().zip(&places) {
        if let Some((side, _)) = sided(&joint.name) {
            let side = usize::from(side == Side::Right);
            sums[side] += place;
            counts[side] += 1.0;
        }
    }
    let means = [sums[0] / counts[0], sums[1] / counts[1]];
    let left = (means[0] - means[1]).with_y(0.0);
    let size = places.iter().map(|place| place.distance(places[0]));
    let clear = 1e-3 * size.fold(0.0, f32::max);
    (left.is_finite() && left.length() > clear).then_some(left)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;

    fn facing(joints: &[(&str, [f32; 3])]) -> Facing {
        let joints = joints.iter().enumerate().map(|(index, &(name, at))| Joint {
            name: name.to_owned(),
            parent: (index > 0).then_some(0),
            offset: at.into(),
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).unwrap().facing()
    }

    #[test]
    fn left_and_right_say_where_the_front_is() {
        for (left, front) in [
            (Vec3::X, Vec3::Z),
            (Vec3::NEG_X, Vec3::NEG_Z),
            (Vec3::Z, Vec3::NEG_X),
            (Vec3::NEG_Z, Vec3::X),
        ] {
            let body = [
                ("Body", [0.0; 3]),
                ("Hand.L", (left + Vec3::Y * 0.3).into()),
                ("Hand.R", (-left).into()),
            ];
            let facing = facing(&body);
            assert_eq!((facing.front(), facing.left()), (front, left));
        }
    }

    #[test]
    fn without_names_it_is_the_axis_across_the_pairs_or_else_z() {
        let pair =
            |at: [f32; 3]| facing(&[("a", [0.0; 3]), ("b", at), ("c", [-at[0], at[1], -at[2]])]);
        assert_eq!(pair([0.5, 0.1, 0.0]).front(), Vec3::Z);
        assert_eq!(pair([0.0, 0.1, 0.5]).front(), Vec3::X);
        assert_eq!(facing(&[("a", [0.0; 3])]).front(), Vec3::Z);
        let one_side = facing(&[("a", [0.0; 3]), ("Left arm", [-0.5, 0.0, 0.0])]);
        assert_eq!(one_side.front(), Vec3::Z);
    }
}
