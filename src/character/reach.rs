use super::Attachments;
use crate::math::Aabb;
use glam::{Mat4, Vec3};

/// Share of the numbers at hand by which sums of many of them may be off in `f32`.
const ROUNDING: f32 = 1e-5;

/// What is known of a character's mesh without moving a single vertex: where the vertices of each
/// joint are in the bind pose, and what their weights sum to.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    /// Around what each joint moves, in the bind pose.
    by_joint: Vec<(usize, Aabb)>,
    /// Around the vertices without any weight, which stay.
    at_rest: Aabb,
    /// The least and the largest sum of a vertex' weights.
    sums: (f32, f32),
    /// The largest sum of a vertex' weights without their signs.
    most: f32,
}

impl Reach {
    /// Of vertices at `bind`, one for each of `attachments`, whose joints are below `joints`.
    pub fn new(attachments: &Attachments, bind: &[Vec3], joints: usize) -> Self {
        let mut boxes = vec![Aabb::EMPTY; joints];
        let mut reach = Self {
            by_joint: Vec::new(),
            at_rest: Aabb::EMPTY,
            sums: (f32::INFINITY, f32::NEG_INFINITY),
            most: 0.0,
        };
        for (influences, &position) in attachments.vertices().zip(bind) {
            let point = Aabb::from_points([position]);
            if influences.is_empty() {
                reach.at_rest = reach.at_rest.union(point);
                continue;
            }
            let (mut sum, mut most) = (0.0, 0.0);
            for influence in influences {
                let joint = &mut boxes[influence.joint as usize];
                *joint = joint.union(point);
                sum += influence.weight;
                most += influence.weight.abs();
            }
            reach.sums = (reach.sums.0.min(sum), reach.sums.1.max(sum));
            reach.most = reach.most.max(most);
        }
        let used = boxes.into_iter().enumerate();
        reach.by_joint = used.filter(|(_, aabb)| !aabb.is_empty()).collect();
        reach
    }

    /// A box that no vertex leaves under `palette` (`T · B⁻¹` by joint), in model space.
    ///
    /// A vertex is the sum of wᵢ pᵢ, where pᵢ lies in the box of joint i after its transform. With
    /// c the center and h half the size of a box around all of those, that is Σwᵢ c + Σwᵢ (pᵢ - c),
    /// of which the second part is at most Σ|wᵢ| h. For weights that sum to one it is that box.
    pub fn around(&self, palette: &[Mat4]) -> Aabb {
        let mut moved = Aabb::EMPTY;
        let mut largest = Vec3::ZERO;
        for &(joint, bind) in &self.by_joint {
            let model_from_bind = palette[joint];
            moved = moved.union(bind.transformed(model_from_bind));
            let far = bind.min.abs().max(bind.max.abs());
            let [x, y, z, w] = [
                model_from_bind.x_axis,
                model_from_bind.y_axis,
                model_from_bind.z_axis,
                model_from_bind.w_axis,
            ]
            .map(|axis| axis.truncate().abs());
            largest = largest.max(x * far.x + y * far.y + z * far.z + w);
        }
        if moved.is_empty() {
            return self.at_rest;
        }
        let (center, half) = (moved.center(), moved.size() * 0.5);
        let ends = [center * self.sums.0, center * self.sums.1];
        let spread = half * self.most + largest * (self.most.max(1.0) * ROUNDING);
        let blended = Aabb {
            min: ends[0].min(ends[1]) - spread,
            max: ends[0].max(ends[1]) + spread,
        };
        blended.union(self.at_rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Influence, skinning};
    use glam::Quat;
    use proptest::prelude::*;

    fn vectors(size: f32) -> impl Strategy<Value = Vec3> {
        let side = -size..size;
        (side.clone(), side.clone(), side).prop_map(Vec3::from)
    }

    fn transforms() -> impl Strategy<Value = Mat4> {
        (vectors(5.0), vectors(3.0)).prop_map(|(angles, offset)| {
            let turn = Quat::from_euler(glam::EulerRot::XYZ, angles.x, angles.y, angles.z);
            Mat4::from_rotation_translation(turn, offset)
        })
    }

    fn weighted(pairs: &[Vec<(u32, f32)>]) -> Attachments {
        let mut attachments = Attachments::new();
        for vertex in pairs {
            let influence = |&(joint, weight)| Influence { joint, weight };
            attachments.push_vertex(vertex.iter().map(influence));
        }
        attachments
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_vertex_leaves_the_box_whatever_its_weights(
            bind in prop::collection::vec(vectors(100.0), 12),
            weights in prop::collection::vec(prop::collection::vec((0..4_u32, -0.5..1.5_f32), 0..5), 12),
            palette in prop::collection::vec(transforms(), 4),
        ) {
            let attachments = weighted(&weights);
            let around = Reach::new(&attachments, &bind, 4).around(&palette);
            let mut skinned = vec![Vec3::ZERO; bind.len()];
            skinning::skin_positions(&palette, &attachments, &bind, &mut skinned);
            for vertex in skinned {
                prop_assert!(vertex.cmpge(around.min).all() && vertex.cmple(around.max).all());
            }
        }
    }

    #[test]
    fn where_weights_sum_to_one_it_is_the_box_around_what_the_joints_move() {
        let bind = [Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0), Vec3::splat(9.0)];
        let attachments = weighted(&[vec![(0, 1.0)], vec![(0, 0.25), (1, 0.75)], vec![]]);
        let up = Mat4::from_translation(Vec3::Y * 4.0);
        let around = Reach::new(&attachments, &bind, 2).around(&[Mat4::IDENTITY, up]);
        assert!(around.min.abs_diff_eq(Vec3::ZERO, 1e-3), "{around:?}");
        assert_eq!(around.max, Vec3::splat(9.0));
    }

    #[test]
    fn without_vertices_it_is_empty() {
        let reach = Reach::new(&Attachments::new(), &[], 1);
        assert!(reach.around(&[Mat4::IDENTITY]).is_empty());
    }
}
