use fearless_simd::{Level, dispatch, prelude::*};
use glam::{Mat4, Vec3};

/// The three rows of a transform that move something, column by column.
pub(super) type Rows = [f32; 12];

/// `palette` as it is read here.
pub(super) fn rows(palette: &[Mat4]) -> Vec<Rows> {
    let columns = palette.iter().map(Mat4::to_cols_array_2d);
    columns
        .map(|columns| std::array::from_fn(|at| columns[at / 3][at % 3]))
        .collect()
}

/// Numbers that processors of `level` work on at once.
pub(super) fn lanes(level: Level) -> usize {
    dispatch!(level, simd => lanes_of(simd))
}

fn lanes_of<S: Simd>(_: S) -> usize {
    S::f32s::LEN
}

/// Most lanes of any processor.
const MOST_LANES: usize = 16;

/// Blocks that follow one another, see [`super::SkinningBlocks`].
pub(super) struct Span<'a> {
    pub starts: &'a [u32],
    pub joints: &'a [u32],
    pub weights: &'a [f32],
    pub bind: &'a [f32],
    pub places: &'a [u16],
}

/// Skins the blocks of `span`. Everything here is inlined, and no closure is used, so that all of it is
/// compiled for the processors of `simd`.
#[inline(always)]
pub(super) fn skin_span<S: Simd, const NORMALS: bool>(
    simd: S,
    span: &Span<'_>,
    palette: &[Rows],
    positions: &mut [Vec3],
    normals: &mut [Vec3],
) {
    let lanes = S::f32s::LEN;
    let numbers = if NORMALS { 6 } else { 3 };
    let (mut joints, mut weights) = (span.joints, span.weights);
    let blocks = span.starts.windows(2);
    let of_lanes = span.bind.chunks_exact(numbers * lanes);
    let of_lanes = of_lanes.zip(span.places.chunks_exact(lanes));
    for (ends, (bind, places)) in blocks.zip(of_lanes) {
        let count = (ends[1] - ends[0]) as usize;
        let (of_block, later) = joints.split_at(count);
        joints = later;
        let (weights_of_block, later) = weights.split_at(count * lanes);
        weights = later;
        let (position, normal) = bind.split_at(3 * lanes);
        if count == 0 {
            put::<S>(position, places, positions);
            if NORMALS {
                put::<S>(normal, places, normals);
            }
            continue;
        }
        let mut sum = [S::f32s::splat(simd, 0.0); 12];
        for (&joint, weights) in of_block.iter().zip(weights_of_block.chunks_exact(lanes)) {
            let model_from_bind = &palette[joint as usize];
            let weight = S::f32s::from_slice(simd, weights);
            for (sum, &number) in sum.iter_mut().zip(model_from_bind) {
                *sum += S::f32s::splat(simd, number) * weight;
            }
        }
        let [x, y, z] = load(simd, position);
        let mut moved = [0.0; 3 * MOST_LANES];
        for row in 0..3 {
            let number = sum[row] * x + sum[3 + row] * y + sum[6 + row] * z + sum[9 + row];
            number.store_slice(&mut moved[row * lanes..(row + 1) * lanes]);
        }
        put::<S>(&moved, places, positions);
        if NORMALS {
            turn(simd, &sum, normal, &mut moved);
            put::<S>(&moved, places, normals);
        }
    }
}

/// Normals of a block, turned by the cofactors of the blended transforms and made of unit length.
#[inline(always)]
fn turn<S: Simd>(simd: S, blended: &[S::f32s; 12], bind: &[f32], turned: &mut [f32]) {
    let lanes = S::f32s::LEN;
    let [x, y, z] = load(simd, bind);
    let columns = [
        cross::<S>(&blended[3..6], &blended[6..9]),
        cross::<S>(&blended[6..9], &blended[0..3]),
        cross::<S>(&blended[0..3], &blended[3..6]),
    ];
    let mut normal = [x, y, z];
    for (row, number) in normal.iter_mut().enumerate() {
        *number = columns[0][row] * x + columns[1][row] * y + columns[2][row] * z;
    }
    let squares = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    let factor = S::f32s::splat(simd, 1.0) / squares.sqrt();
    let has_length = factor.simd_gt(0.0) & factor.simd_lt(f32::INFINITY);
    let bind = [x, y, z];
    for row in 0..3 {
        let number = has_length.select(normal[row] * factor, bind[row]);
        number.store_slice(&mut turned[row * lanes..(row + 1) * lanes]);
    }
}

#[inline(always)]
fn cross<S: Simd>(a: &[S::f32s], b: &[S::f32s]) -> [S::f32s; 3] {
    [
        a[1] * b[2] - b[1] * a[2],
        a[2] * b[0] - b[2] * a[0],
        a[0] * b[1] - b[0] * a[1],
    ]
}

#[inline(always)]
fn load<S: Simd>(simd: S, numbers: &[f32]) -> [S::f32s; 3] {
    let lanes = S::f32s::LEN;
    [
        S::f32s::from_slice(simd, &numbers[..lanes]),
        S::f32s::from_slice(simd, &numbers[lanes..2 * lanes]),
        S::f32s::from_slice(simd, &numbers[2 * lanes..3 * lanes]),
    ]
}

/// Puts what the lanes have, all x, all y and all z, into the places of their vertices.
#[inline(always)]
fn put<S: Simd>(numbers: &[f32], places: &[u16], out: &mut [Vec3]) {
    let lanes = S::f32s::LEN;
    let (x, rest) = numbers.split_at(lanes);
    let (y, z) = rest.split_at(lanes);
    for lane in 0..lanes {
        out[usize::from(places[lane])] = Vec3::new(x[lane], y[lane], z[lane]);
    }
}
