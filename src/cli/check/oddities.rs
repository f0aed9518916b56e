//! What is odd about a mesh that can be opened.

use crate::character::Character;
use crate::geometry::{Mesh, enclosed_volume, opposed_triangles};
use crate::math::Aabb;
use crate::scene::{Shape, ShapeKind};

/// How many times as large as its skeleton a mesh is at most, and the other way round, where both are in the same
/// units. Those of feet and meters are nearer to each other, but so may a body and few joints in it be.
const SAME_UNITS: f32 = 30.0;

/// In words what is odd about the mesh of a shape that is from a file.
pub(super) fn oddities(shape: &Shape) -> Vec<String> {
    let mesh = shape.kind.mesh();
    let size = match &shape.kind {
        ShapeKind::Character(shape) => other_size(&shape.character),
        _ => None,
    };
    let found = size.into_iter().chain(turned(&mesh));
    found
        .map(|what| format!("{}: {what}", shape.name))
        .collect()
}

/// That mesh and skeleton differ in size by so much that one of them must be in other units.
fn other_size(character: &Character) -> Option<String> {
    let size = |points: &[glam::Vec3]| Aabb::from_points(points.iter().copied()).size().length();
    let mesh = size(&character.bind_mesh().positions);
    let skeleton = size(&character.skeleton().bind_positions());
    // A single joint has no size.
    if !(mesh > 0.0 && skeleton > 0.0 && mesh.is_finite() && skeleton.is_finite()) {
        return None;
    }
    let (times, larger, smaller) = if mesh > skeleton {
        (mesh / skeleton, "mesh", "skeleton")
    } else {
        (skeleton / mesh, "skeleton", "mesh")
    };
    (times > SAME_UNITS).then(|| {
        let times = in_two_digits(times);
        format!(
            "the {larger} is some {times} times as large as the {smaller}: one of them may be in other \
             units, such as centimeters and meters"
        )
    })
}

/// That triangles are turned inside out.
fn turned(mesh: &Mesh) -> Option<String> {
    let count = mesh.triangles.len();
    match opposed_triangles(&mesh.triangles) {
        0 => {
            let volume = enclosed_volume(&mesh.positions, &mesh.triangles)?;
            (volume < 0.0).then(|| {
                "all of the closed mesh is turned inside out: the corners of its faces go clockwise, seen from outside"
                    .to_owned()
            })
        }
        1 => Some(format!(
            "1 of {count} triangles is turned inside out, against its neighbors"
        )),
        turned => Some(format!(
            "{turned} of {count} triangles are turned inside out, against their neighbors"
        )),
    }
}

/// A number above 10 in words, without digits that say nothing here.
fn in_two_digits(number: f32) -> String {
    let unit = 10_f32.powf(number.log10().floor() - 1.0);
    format!("{:.0}", (number / unit).round() * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_with_two_digits() {
        assert_eq!(
            [31.4, 99.7, 104.0, 1234.0].map(in_two_digits),
            ["31", "100", "100", "1200"]
        );
    }
}
