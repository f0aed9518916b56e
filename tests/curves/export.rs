use crate::curves::support::read;
use editor_core::io::{Diagnostic, Files, Loaded, export_obj};
use editor_core::scene::NewShape;
use editor_core::scene::{CurveShape, Evaluator, Scene, ShapeKind, SurfaceVisibility};
use glam::Vec3;
use std::path::Path;

const TEXT: &str = "circ a 4 0.5 circ b 8 2 gcyl tube a b";

struct OneFile;

impl Files for OneFile {
    fn read(&self, _: &Path) -> Result<Vec<u8>, Diagnostic> {
        Ok(TEXT.into())
    }

    fn exists(&self, _: &Path) -> bool {
        true
    }
}

#[test]
fn a_file_of_curves_is_imported_under_its_name_as_one_shape() {
    let mut loaded = Loaded::default();
    loaded
        .add(&OneFile, Path::new("folder/myTORUS.swp"))
        .unwrap();
    let shape = &loaded.shapes[0];
    assert_eq!(shape.name, "Mytorus");
    assert!(matches!(&shape.kind, ShapeKind::Curve(curve)
        if *curve.curves() == read(TEXT).unwrap()));
}

#[test]
fn an_obj_file_has_the_triangles_then_a_line_for_each_curve_whatever_is_displayed() {
    let mut shape = CurveShape::new(read(TEXT).unwrap());
    shape.display.surface = SurfaceVisibility::Off;
    let mut scene = Scene::new();
    scene.add(NewShape::new("Cube", ShapeKind::Cube));
    let id = scene.add(NewShape::new("Torus", ShapeKind::Curve(shape)));
    if let Some(shape) = scene.shape_mut(id) {
        shape.placement.transform.position = Vec3::X;
    }
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let text = export_obj(&scene, &evaluated).unwrap();

    let lines = |key: &str| {
        text.lines()
            .filter(|l| l.starts_with(key))
            .collect::<Vec<_>>()
    };
    let vertices = lines("v ");
    let cube = evaluated.shapes[0].geometry.positions().len();
    let torus = 5 * 9;
    assert_eq!(vertices.len(), cube + torus + 5 + 9);
    assert_eq!(lines("f ").len(), 12 + 2 * 4 * 8);

    let curves = lines("l ");
    let first = cube + torus + 1;
    assert_eq!(
        curves[0],
        format!(
            "l {} {} {} {} {}",
            first,
            first + 1,
            first + 2,
            first + 3,
            first + 4
        )
    );
    assert_eq!(curves[1].split_whitespace().count(), 1 + 9);
    // Start of the profile, moved with the shape.
    assert_eq!(vertices[first - 1], "v 1.5 0 0");
}
