use crate::scene::{Evaluated, EvaluatedShape, Scene, Shape, ShapeKind};
use glam::{Mat4, Vec3};
use std::fmt::Write;

/// The current geometry of a scene in the world, as an `.obj` file: an `o` for each shape, its
/// vertices in the order of their file and under its pose, its triangles; of curves all surfaces,
/// displayed or not, then an `l` element for each curve in the order of the file. Shapes that
/// are hidden in the view are no less there. A stand-in for a shape whose file is missing is left
/// out, with a comment. Numbers have as many digits as it takes to read the same ones back.
///
/// `evaluated` must be the evaluation of `scene`.
///
/// # Errors
/// At the first shape with a vertex that lies too far out for its coordinates to be numbers: no
/// program could read the file.
pub fn export_obj(scene: &Scene, evaluated: &Evaluated) -> Result<String, TooFarOut> {
    let mut first_vertex = 1;
    each_shape(scene, evaluated, |out, _, shape| {
        let written = write_mesh(out, shape, first_vertex)?;
        first_vertex += written;
        Some(())
    })
}

/// The text of an `.obj` file in which `write` writes each shape of `scene` that is there; it
/// returns `None` for one with a vertex that is not finite.
///
/// # Errors
/// At the first such shape.
pub(super) fn each_shape(
    scene: &Scene,
    evaluated: &Evaluated,
    mut write: impl FnMut(&mut String, &Shape, &EvaluatedShape) -> Option<()>,
) -> Result<String, TooFarOut> {
    let mut out = String::new();
    for (shape, evaluated) in scene.shapes().iter().zip(&evaluated.shapes) {
        let name = on_one_line(&shape.name);
        if let ShapeKind::Missing(missing) = &shape.kind {
            let reason = on_one_line(&missing.reason);
            out.push_str(&format!("# {name} is left out: {reason}\n"));
            continue;
        }
        out.push_str(&format!("o {name}\n"));
        write(&mut out, shape, evaluated).ok_or(TooFarOut { shape: name })?;
    }
    Ok(out)
}

/// `text` without line breaks: a line ends where a name does, whatever is in it.
pub(super) fn on_one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}

/// Error of an export: a shape with a vertex whose coordinates are not finite.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected shapes whose coordinates are numbers, found the shape “{shape}” with a vertex too \
     far out: make it smaller or move it nearer"
)]
pub struct TooFarOut {
    /// Name of the shape.
    pub shape: String,
}

/// Writes one shape, and returns how many vertices it wrote; `None` if one is not finite.
fn write_mesh(out: &mut String, shape: &EvaluatedShape, first_vertex: usize) -> Option<usize> {
    let geometry = &shape.geometry;
    let positions = geometry.positions();
    write_vertices(out, shape, positions.iter().copied())?;
    // A mirrored shape would be inside out if its triangles kept their order.
    let mirrored = shape.world_from_model.determinant() < 0.0;
    for &[a, b, c] in &geometry.mesh.triangles {
        let [a, b, c] = if mirrored { [a, c, b] } else { [a, b, c] };
        let [a, b, c] = [a, b, c].map(|index| first_vertex + index as usize);
        let _ = writeln!(out, "f {a} {b} {c}");
    }
    let curves = write_curves(out, shape, first_vertex + positions.len())?;
    Some(positions.len() + curves)
}

/// Writes the curves of a shape as lines, and returns how many vertices it wrote; `None` if one is
/// not finite.
pub(super) fn write_curves(
    out: &mut String,
    shape: &EvaluatedShape,
    first_vertex: usize,
) -> Option<usize> {
    let mut written = 0;
    for curve in shape.geometry.curves.iter().flat_map(|all| &all.curves) {
        write_vertices(out, shape, curve.positions())?;
        out.push('l');
        for _ in curve.positions() {
            // Writing to a string cannot fail.
            let _ = write!(out, " {}", first_vertex + written);
            written += 1;
        }
        out.push('\n');
    }
    Some(written)
}

/// Writes `positions`, in the shape's model space, as they stand in the world; `None` if one is
/// not finite there.
pub(super) fn write_vertices(
    out: &mut String,
    shape: &EvaluatedShape,
    positions: impl Iterator<Item = Vec3>,
) -> Option<()> {
    for position in positions {
        let world = if shape.world_from_model == Mat4::IDENTITY {
            position
        } else {
            shape.world_from_model.transform_point3(position)
        };
        if !world.is_finite() {
            return None;
        }
        // Writing to a string cannot fail.
        let _ = writeln!(out, "v {} {} {}", world.x, world.y, world.z);
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::read_character_obj;
    use crate::scene::NewShape;
    use crate::scene::{Evaluator, MissingShape};
    use std::path::Path;
    use std::sync::Arc;

    #[test]
    fn what_is_written_is_read_back_in_the_world_and_the_right_side_out() {
        let mut scene = Scene::new();
        scene.add(NewShape::new("A\ncube", ShapeKind::Cube));
        let moved = scene.add(NewShape::new("Sphere", ShapeKind::Sphere));
        let transform = &mut scene.shape_mut(moved).unwrap().placement.transform;
        transform.position = Vec3::new(0.1, 1.0 / 3.0, 1e-7);
        transform.scale = Vec3::new(-1.0, 2.0, 1.0);
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);

        let text = export_obj(&scene, &evaluated).unwrap();
        assert!(text.starts_with("o A cube\nv "));
        let mesh = read_character_obj(Path::new("a"), text.as_bytes())
            .unwrap()
            .value;

        let [cube, sphere] = [&evaluated.shapes[0], &evaluated.shapes[1]];
        let (cube_positions, sphere_positions) =
            mesh.positions.split_at(cube.geometry.positions().len());
        assert_eq!(cube_positions, cube.geometry.positions());
        for (&read, &model) in sphere_positions.iter().zip(sphere.geometry.positions()) {
            assert_eq!(read, sphere.world_from_model.transform_point3(model));
        }
        let center = transform_center(&evaluated);
        for triangle in &mesh.triangles[cube.geometry.mesh.triangles.len()..] {
            let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
            assert!((b - a).cross(c - a).dot(a - center) >= -1e-6);
        }
    }

    #[test]
    fn what_is_hidden_is_written_all_the_same() {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let shown = export_obj(&scene, &Evaluator::new().evaluate(&scene, 0.0));
        scene.shape_mut(id).unwrap().visible = false;
        let hidden = export_obj(&scene, &Evaluator::new().evaluate(&scene, 0.0));
        assert_eq!(shown, hidden);
    }

    #[test]
    fn a_stand_in_is_left_out_with_a_comment() {
        let missing = MissingShape {
            reason: "man.obj: there is no\nsuch file".to_owned(),
            kept: None,
        };
        let missing = ShapeKind::Missing(Arc::new(missing));
        let mut scene = Scene::from_iter([
            NewShape::new("Man", missing),
            NewShape::new("Cube", ShapeKind::Cube),
        ]);
        let text = export_obj(&scene, &Evaluator::new().evaluate(&scene, 0.0)).unwrap();
        scene.delete(scene.shapes()[0].id);
        let cube = export_obj(&scene, &Evaluator::new().evaluate(&scene, 0.0)).unwrap();
        let comment = "# Man is left out: man.obj: there is no such file\n";
        assert_eq!(text, format!("{comment}{cube}"));
    }

    #[test]
    fn a_shape_that_is_too_far_out_to_be_read_back_is_refused_by_name() {
        let mut scene = Scene::new();
        scene.add(NewShape::new("Near", ShapeKind::Cube));
        let far = scene.add(NewShape::new("Far", ShapeKind::Cube));
        let exported = |scene: &Scene| export_obj(scene, &Evaluator::new().evaluate(scene, 0.0));
        let place = |scene: &mut Scene, x: f32, scale: f32| {
            let transform = &mut scene.shape_mut(far).unwrap().placement.transform;
            transform.position = Vec3::X * x;
            transform.scale = Vec3::splat(scale);
        };
        place(&mut scene, 3e38, 1.0);
        let written = exported(&scene).unwrap();
        read_character_obj(Path::new("a"), written.as_bytes()).unwrap();
        place(&mut scene, 3e38, 3e38);
        let message = "expected shapes whose coordinates are numbers, found the shape “Far” with a \
                       vertex too far out: make it smaller or move it nearer";
        assert_eq!(exported(&scene).unwrap_err().to_string(), message);
    }

    fn transform_center(evaluated: &Evaluated) -> Vec3 {
        evaluated.shapes[1]
            .world_from_model
            .transform_point3(Vec3::ZERO)
    }
}
