//! What the vertex shader makes of each vertex.

use super::characters;
use crate::offscreen::support::on_each_backend;
use editor_core::character::Character;
use editor_core::geometry::{Facets, Normals, face_normals};
use editor_core::gpu::Gl;
use editor_core::render::read_back_skinning;
use editor_core::scene::NewShape;
use editor_core::scene::{EvaluatedShape, Evaluator, Scene, Shading};
use glam::Vec3;

/// How far a position may be off, of the size of the character.
const POSITIONS: f32 = 1e-5;
/// How far a unit normal may be off.
const NORMALS: f32 = 1e-4;

fn each_character(scene: &Scene, check: impl Fn(&EvaluatedShape, &Character)) {
    let evaluated = Evaluator::new().evaluate(scene, 0.0);
    for shape in &evaluated.shapes {
        if let Some(deformation) = &shape.geometry.deformation {
            check(shape, deformation.character());
        }
    }
}

fn read_back(gl: &Gl, shape: &EvaluatedShape, shading: Shading) -> Vec<[Vec3; 2]> {
    read_back_skinning(gl, shape, shading)
        .expect("numbers read back")
        .expect("a character that the graphics card skins")
}

fn furthest(found: impl Iterator<Item = Vec3>, expected: &[Vec3]) -> f32 {
    let pairs = found.zip(expected);
    pairs
        .map(|(found, &expected)| found.distance(expected))
        .fold(0.0, f32::max)
}

#[test]
fn positions_agree_with_the_exact_path_whatever_the_number_of_influences() {
    let scenes = characters::all();
    on_each_backend(|gl| {
        for (name, scene) in &scenes {
            each_character(scene, |shape, character| {
                let expected = shape.geometry.positions();
                let size = character.bind_mesh().bounds().size().max_element();
                for shading in [Shading::AsAuthored, Shading::Flat] {
                    let found = read_back(gl, shape, shading);
                    assert!(found.len() >= expected.len());
                    let off = furthest(found.iter().map(|v| v[0]), expected) / size;
                    let most = character.attachments().most_influences();
                    eprintln!(
                        "{name}: {} vertices, {most} influences, {off:e}",
                        found.len()
                    );
                    assert!(off < POSITIONS, "{name}, {shading:?}: {off:e} of its size");
                    let moved =
                        furthest(found.iter().map(|v| v[0]), &character.bind_mesh().positions);
                    assert!(moved > 0.01 * size, "{name} did not move");
                }
            });
        }
    });
}

#[test]
fn normals_agree_with_the_exact_path() {
    let scenes = characters::all();
    on_each_backend(|gl| {
        for (name, scene) in &scenes {
            each_character(scene, |shape, character| {
                if matches!(character.bind_mesh().normals, Normals::PerVertex(_)) {
                    let found = read_back(gl, shape, Shading::AsAuthored);
                    let expected = shape.geometry.normals().expect("normals");
                    assert_eq!(found.len(), expected.len());
                    let off = furthest(found.iter().map(|v| v[1]), expected);
                    eprintln!("{name}: {} normals, {off:e}", found.len());
                    assert!(off < NORMALS, "{name}: {off:e}");
                }
            });
        }
    });
}

#[test]
fn facets_have_the_normals_of_their_moved_corners() {
    let scenes = characters::all();
    on_each_backend(|gl| {
        for (name, scene) in &scenes {
            each_character(scene, |shape, character| {
                let mesh = character.bind_mesh();
                let size = mesh.bounds().size().max_element();
                let positions = shape.geometry.positions();
                let found = read_back(gl, shape, Shading::Flat);
                let facets = Facets::new(mesh.vertex_count(), mesh.vertex_triangles());
                let expected = face_normals(positions, &mesh.triangles);
                let mut compared = 0;
                for (triangle, (drawn, expected)) in
                    facets.triangles.iter().zip(&expected).enumerate()
                {
                    let corners = mesh.triangles[triangle].map(|i| positions[i as usize]);
                    // What rounding may do to a thin triangle is no fault of either.
                    if is_thin(corners, size) {
                        continue;
                    }
                    compared += 1;
                    let off = found[drawn[2] as usize][1].distance(*expected);
                    assert!(off < 1e-2, "{name}, triangle {triangle}: {off:e}");
                }
                assert!(
                    compared > mesh.triangles.len() / 2,
                    "{name}: {compared} compared"
                );
            });
        }
    });
}

/// Whether rounding of a character of this size moves its corners by a thousandth of its height.
fn is_thin([a, b, c]: [Vec3; 3], size: f32) -> bool {
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    let height = (b - a).cross(c - a).length() / longest;
    height.is_nan() || height < 1e-3 * size
}

#[test]
fn shapes_that_nothing_deforms_are_not_skinned() {
    let mut scene = Scene::new();
    scene.add(NewShape::new("Cube", editor_core::scene::ShapeKind::Cube));
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    on_each_backend(|gl| {
        let read = read_back_skinning(gl, &evaluated.shapes[0], Shading::AsAuthored);
        assert_eq!(read.expect("an answer"), None);
    });
}
