use editor_core::character::Attachments;
use editor_core::geometry::Mesh;
use fearless_simd::{Level, dispatch, f32x4, prelude::*};
use glam::{Mat4, Vec3};

/// The design that ozz-animation publishes: vertices sorted by their number of influences, a loop for
/// each number, and in it the columns of one vertex's matrices four numbers at a time. Its result stays in
/// that order.
pub struct Bucketed {
    level: Level,
    buckets: Vec<Bucket>,
    /// The vertex of the file of each result.
    order: Vec<u32>,
}

struct Bucket {
    influences: usize,
    joints: Vec<u16>,
    weights: Vec<f32>,
    positions: Vec<[f32; 3]>,
}

impl Bucketed {
    pub fn new(attachments: &Attachments, mesh: &Mesh, level: Level) -> Self {
        let bucket = |count: usize| {
            let mut bucket = Bucket {
                influences: count,
                joints: Vec::new(),
                weights: Vec::new(),
                positions: Vec::new(),
            };
            let all = attachments.vertices().zip(&mesh.positions);
            for (influences, position) in all.filter(|(all, _)| all.len() == count) {
                let joints = influences.iter().map(|i| i.joint as u16);
                bucket.joints.extend(joints);
                bucket.weights.extend(influences.iter().map(|i| i.weight));
                bucket.positions.push(position.to_array());
            }
            bucket
        };
        let buckets = (1..=attachments.most_influences()).map(bucket);
        let is_weighted = |vertex: &[_]| !vertex.is_empty();
        assert!(
            attachments.vertices().all(is_weighted),
            "all vertices have weights"
        );
        let mut order: Vec<u32> = (0..mesh.positions.len() as u32).collect();
        order.sort_by_key(|&vertex| attachments.of_vertex(vertex as usize).len());
        Self {
            level,
            buckets: buckets.filter(|b| !b.positions.is_empty()).collect(),
            order,
        }
    }

    /// Skins, and puts the result into the order of the file; `sorted` is for the result before.
    pub fn skin_in_order(&self, palette: &[Mat4], sorted: &mut Vec<Vec3>, out: &mut Vec<Vec3>) {
        self.skin(palette, sorted);
        out.resize(self.order.len(), Vec3::ZERO);
        for (&vertex, position) in self.order.iter().zip(&*sorted) {
            out[vertex as usize] = *position;
        }
    }

    pub fn skin(&self, palette: &[Mat4], out: &mut Vec<Vec3>) {
        out.resize(self.order.len(), Vec3::ZERO);
        let palette: Vec<[[f32; 4]; 4]> = palette.iter().map(Mat4::to_cols_array_2d).collect();
        let mut rest = &mut out[..];
        for bucket in &self.buckets {
            let (out, later) = rest.split_at_mut(bucket.positions.len());
            rest = later;
            let palette = &palette[..];
            match bucket.influences {
                1 => dispatch!(self.level, simd => skin::<_, 1>(simd, bucket, palette, out)),
                2 => dispatch!(self.level, simd => skin::<_, 2>(simd, bucket, palette, out)),
                3 => dispatch!(self.level, simd => skin::<_, 3>(simd, bucket, palette, out)),
                4 => dispatch!(self.level, simd => skin::<_, 4>(simd, bucket, palette, out)),
                _ => dispatch!(self.level, simd => skin::<_, 0>(simd, bucket, palette, out)),
            }
        }
    }
}

/// Skins a bucket whose number of influences is `COUNT`, or any if that is 0.
#[inline(always)]
fn skin<S: Simd, const COUNT: usize>(
    simd: S,
    bucket: &Bucket,
    palette: &[[[f32; 4]; 4]],
    out: &mut [Vec3],
) {
    let count = if COUNT == 0 { bucket.influences } else { COUNT };
    let influences = bucket
        .joints
        .chunks_exact(count)
        .zip(bucket.weights.chunks_exact(count));
    for (((joints, weights), position), out) in influences.zip(&bucket.positions).zip(out) {
        let mut columns = [f32x4::splat(simd, 0.0); 4];
        for (&joint, &weight) in joints.iter().zip(weights) {
            let weight = f32x4::splat(simd, weight);
            for (column, numbers) in columns.iter_mut().zip(&palette[usize::from(joint)]) {
                *column = f32x4::from_slice(simd, numbers).mul_add(weight, *column);
            }
        }
        let [x, y, z] = *position;
        let moved = columns[2].mul_add(f32x4::splat(simd, z), columns[3]);
        let moved = columns[1].mul_add(f32x4::splat(simd, y), moved);
        let moved = columns[0].mul_add(f32x4::splat(simd, x), moved);
        let moved = moved.as_slice();
        *out = Vec3::new(moved[0], moved[1], moved[2]);
    }
}
