use editor_core::character::Attachments;
use editor_core::geometry::Mesh;
use glam::{Mat4, Vec3};

/// The loop that the assignment leads to: for each vertex and each joint, a weight that is mostly 0, and
/// the product of two matrices.
pub struct Course {
    /// Weights of all joints, vertex by vertex.
    weights: Vec<f32>,
    joints: usize,
}

impl Course {
    pub fn new(attachments: &Attachments, joints: usize) -> Self {
        let mut weights = vec![0.0; attachments.vertex_count() * joints];
        for (row, vertex) in weights.chunks_exact_mut(joints).zip(attachments.vertices()) {
            for influence in vertex {
                row[influence.joint as usize] += influence.weight;
            }
        }
        Self { weights, joints }
    }

    /// `model_from_joint` now and in the `bind` pose.
    pub fn skin(&self, model_from_joint: &[Mat4], bind: &[Mat4], mesh: &Mesh, out: &mut Vec<Vec3>) {
        let joint_from_bind: Vec<Mat4> = bind.iter().map(Mat4::inverse).collect();
        out.resize(mesh.positions.len(), Vec3::ZERO);
        let vertices = self.weights.chunks_exact(self.joints).zip(&mesh.positions);
        for ((weights, position), out) in vertices.zip(out) {
            let mut sum = Vec3::ZERO;
            for (joint, &weight) in weights.iter().enumerate() {
                let model_from_bind = model_from_joint[joint] * joint_from_bind[joint];
                sum += weight * model_from_bind.transform_point3(*position);
            }
            *out = sum;
        }
    }
}
