//! The part of a mesh between the near and the far plane, which is what is drawn of it.

use glam::DVec4;

/// Least w of a point before the eye.
pub(super) const NEAREST: f64 = 1e-6;

/// Whether a point lies between the near and the far plane.
pub(super) fn is_in_depth(clip: DVec4) -> bool {
    clip.w > NEAREST && clip.is_finite() && clip.z.abs() <= clip.w
}

/// The part of a triangle between the near and the far plane, which is what is drawn of it: the corners of a convex polygon in
/// order, or none. After Sutherland and Hodgman, *Reentrant Polygon Clipping* (1974).
pub(super) fn in_depth(triangle: [DVec4; 3]) -> Vec<DVec4> {
    if !triangle.iter().all(|clip| clip.is_finite()) {
        return Vec::new();
    }
    let planes: [fn(DVec4) -> f64; 2] = [|clip| clip.w + clip.z, |clip| clip.w - clip.z];
    planes.iter().fold(triangle.to_vec(), |corners, inward| {
        let ends = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(ends);
        let kept = edges.flat_map(|(&from, &to)| {
            let (start, end) = (inward(from), inward(to));
            let crosses = (start < 0.0) != (end < 0.0);
            let cut = crosses.then(|| from.lerp(to, start / (start - end)));
            (start >= 0.0).then_some(from).into_iter().chain(cut)
        });
        kept.collect()
    })
}
