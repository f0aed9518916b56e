//! The scenes of the original's pictures, built from what their list says.

use std::path::Path;
use std::sync::Arc;

use editor_core::character::Pose;
use editor_core::geometry::{Mesh, SharedMesh, face_normals};
use editor_core::io::{self, Diagnostic, Files};
use editor_core::math::{Euler, Transform};
use editor_core::scene::NewShape;
use editor_core::scene::{
    Camera, CharacterShape, CurveDisplay, CurveShape, CurveVisibility, ModelDisplay, Scene,
    ShapeColor, ShapeKind, SurfaceVisibility, ViewSettings,
};
use glam::Vec3;

use crate::pictures::reference::{Render, Renders};

struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        std::fs::read(path).map_err(|error| Diagnostic::new(path, error.to_string()))
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }
}

/// The scene of one picture and how it is looked at.
pub fn build(renders: &Renders, render: &Render) -> (Scene, ViewSettings) {
    // From above and from below the original sees the scene turned by half a circle, through a
    // rounding accident; ours has +X to the right there, and sees theirs from the other side.
    let turn = if render.is_from_above_or_below() {
        std::f32::consts::PI
    } else {
        0.0
    };
    let camera = Camera {
        target: Vec3::from_array(render.camera.target),
        radius: render.camera.radius,
        theta: render.camera.theta_rad as f32 + turn,
        phi: render.camera.phi_rad as f32,
        ..Camera::default()
    };
    let view = ViewSettings {
        camera,
        axis: render.axis,
        ..ViewSettings::default()
    };
    let mut scene = Scene::new();
    let file = render.file.as_str();
    if let Some(model) = &render.model {
        let mode = match render.mode.as_deref() {
            Some("skel") => ModelDisplay::Skeleton,
            _ => ModelDisplay::Mesh,
        };
        add_character(renders, &mut scene, model, mode, render);
    } else if file.starts_with("view_") {
        scene.add(NewShape::new("Model1", just_imported(renders, "Model1")));
        let green = ShapeColor::Preset(12);
        let id = scene.shapes()[0].id;
        scene.shape_mut(id).expect("the character").placement.color = green;
        place(
            &mut scene,
            Transform {
                position: Vec3::splat(-0.5),
                scale: Vec3::splat(2.0),
                ..Transform::IDENTITY
            },
        );
        scene.add(NewShape::new("Cube", ShapeKind::Cube));
        place(
            &mut scene,
            Transform {
                position: Vec3::new(1.2, 0.4, 0.0),
                scale: Vec3::splat(0.5),
                ..Transform::IDENTITY
            },
        );
    } else if file.starts_with("cube_transformed") {
        scene.add(NewShape::new("Cube", ShapeKind::Cube));
        place(
            &mut scene,
            Transform {
                position: Vec3::new(0.5, -0.25, 0.3),
                rotation: Euler::from_degrees(Vec3::new(30.0, 45.0, 60.0)),
                scale: Vec3::new(1.0, 2.0, 0.5),
            },
        );
    } else if let Some(path) = content_path(renders, render) {
        let bytes = Disk.read(&path).expect("the shape's file");
        if path.extension().is_some_and(|extension| extension == "swp") {
            add_curves(&mut scene, &path, &bytes, file);
            return (scene, view);
        }
        let mesh = io::read_shape_obj(&Disk, &path, &bytes)
            .expect("a shape")
            .value;
        scene.add(NewShape::new(
            "Shape",
            ShapeKind::Mesh(SharedMesh::new(mesh)),
        ));
    } else if let Some(shape) = file.strip_prefix("shape_") {
        let kind = match shape.split('_').next() {
            Some("cube") => ShapeKind::Cube,
            Some("sphere") => ShapeKind::Sphere,
            Some("pyramid") => ShapeKind::Pyramid,
            Some("icosahedron") => ShapeKind::Icosahedron,
            other => panic!("unknown shape {other:?}"),
        };
        scene.add(NewShape::new("Shape", kind));
    } else {
        assert!(file.starts_with("empty"), "{file}: what is in it?");
    }
    (scene, view)
}

fn add_curves(scene: &mut Scene, path: &Path, bytes: &[u8], file: &str) {
    let curves = io::read_swp(path, bytes).expect("curves").value;
    let mut shape = CurveShape::new(curves);
    // The original leaves the step of a closed sweep where its frames do not meet.
    shape.set_frame_closing(false);
    shape.display = if file.contains("_shaded_") {
        CurveDisplay {
            control_points: false,
            curve: CurveVisibility::Off,
            surface: SurfaceVisibility::Shaded,
        }
    } else if file.contains("_wire_") {
        CurveDisplay {
            control_points: false,
            curve: CurveVisibility::Off,
            surface: SurfaceVisibility::WireframeWithNormals,
        }
    } else if file.contains("_tnb_") {
        CurveDisplay {
            control_points: true,
            curve: CurveVisibility::OnWithFrames,
            surface: SurfaceVisibility::Off,
        }
    } else {
        CurveDisplay::default()
    };
    scene.add(NewShape::new("Curve", ShapeKind::Curve(shape)));
}

/// `data/obj/torus.obj` of the original lies in `obj/` of the reference.
fn content_path(renders: &Renders, render: &Render) -> Option<std::path::PathBuf> {
    let inside = render.content.as_deref()?.strip_prefix("data/")?;
    Some(renders.course.join(inside.split(',').next()?))
}

/// A character as the original shows it between its import and the first move of a slider: the
/// vertices have been through the weights, whose sums are not quite one, while the normals are
/// still those of the vertices in the file. Ours are always of the current vertices.
fn just_imported(renders: &Renders, model: &str) -> ShapeKind {
    let path = character_path(renders, model);
    let character = io::read_character(&Disk, &path).expect("a character").value;
    let skinned = character.skin_pose(&Pose::new());
    let mesh = character.bind_mesh();
    let normals = face_normals(&mesh.positions, &mesh.triangles);
    let corners = mesh.triangles.iter().flatten();
    let positions = corners
        .map(|&corner| skinned[corner as usize])
        .collect::<Vec<_>>();
    let triangles = (0..mesh.triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let apart = Mesh::new(positions, triangles.collect())
        .with_normals(normals.into_iter().flat_map(|normal| [normal; 3]).collect());
    ShapeKind::Mesh(SharedMesh::new(apart))
}

fn character_path(renders: &Renders, model: &str) -> std::path::PathBuf {
    renders
        .course
        .join("characters")
        .join(format!("{model}.obj"))
}

fn add_character(
    renders: &Renders,
    scene: &mut Scene,
    model: &str,
    mode: ModelDisplay,
    render: &Render,
) {
    let path = character_path(renders, model);
    let character = io::read_character(&Disk, &path).expect("a character").value;
    let mut shape = CharacterShape::new(Arc::new(character));
    shape.display.mode = mode;
    let mut pose = Pose::new();
    for (&joint, angles) in &render.joints {
        pose.set_joint_transform(joint, Euler::from_degrees(Vec3::from_array(angles.xyz_deg)));
    }
    shape.set_pose(pose);
    scene.add(NewShape::new(model, ShapeKind::Character(shape)));
}

fn place(scene: &mut Scene, transform: Transform) {
    let id = scene.shapes().last().expect("a shape to place").id;
    scene.shape_mut(id).expect("the shape").placement.transform = transform;
}
