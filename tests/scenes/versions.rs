//! A file of each version, as it was when the version was new.

use super::support::{FOLDER, OLD_SCENE, SCENE, Table, assert_same, files, read, saved_and_read};
use editor_core::geometry::Basis;
use editor_core::io::{Missing, scene_text};
use editor_core::math::Euler;
use editor_core::scene::{
    CurveItemKind, CurveVisibility, IkPole, Look, ModelDisplay, Scene, Shading, ShapeColor,
    SurfaceVisibility, ViewSettings,
};
use glam::Vec3;
use std::path::{Path, PathBuf};

const VERSION_1: &str = include_str!("version_1.scene");
const VERSION_2: &str = include_str!("version_2.scene");

fn opened(path: &str, text: &str) -> (Table, Scene, ViewSettings) {
    let mut files = files();
    files.0.insert(PathBuf::from(path), text.into());
    let (scene, view, _) = read(&files, path, Missing::Refuse).unwrap();
    (files, scene, view)
}

#[test]
fn a_scene_of_version_1_means_what_it_always_meant() {
    let (mut files, scene, view) = opened(OLD_SCENE, VERSION_1);
    assert_eq!(view.look, Look::Studio);
    assert_eq!(view.camera.theta, 45.0_f32.to_radians());
    let names: Vec<&str> = scene.shapes().iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["Cube", "Man", "Both", "Both", "Vase"]);
    let [cube, man, character, sword, vase] = scene.shapes() else {
        panic!("{names:?}");
    };
    assert_eq!(cube.placement.color, ShapeColor::Preset(9));
    assert!(!cube.placement.uniform_scaling);
    assert_eq!(cube.start, cube.placement);
    let turned = Euler::from_degrees(Vec3::new(0.0, 30.0, 0.0));
    assert_eq!(man.placement.transform.rotation, turned);
    let shape = scene.character(man.id).unwrap();
    let bent = Euler::from_degrees(Vec3::new(0.0, 12.34, -400.0));
    assert_eq!(shape.pose().rotation(1), bent);
    assert_eq!(shape.display.mode, ModelDisplay::Both);
    assert_eq!(character.kind.label(), "Character");
    assert_eq!(sword.kind.label(), "Shape");
    let curves = scene.curve(vase.id).unwrap();
    assert!(!vase.visible && !curves.display.control_points);
    assert_eq!(curves.display.surface, SurfaceVisibility::Off);

    let (read, read_view, text) = saved_and_read(&mut files, &scene, &view);
    assert_same(&read, &scene, &text);
    assert_eq!(read_view, view);
}

#[test]
fn every_line_of_a_scene_of_version_2_is_read_and_written_again() {
    let (_, scene, view) = opened(SCENE, VERSION_2);
    assert_eq!((view.look, view.shading), (Look::Studio, Shading::Smooth));
    assert_eq!((view.axis, view.grid), (false, true));
    assert_eq!(view.camera.phi, (-8.25_f32).to_radians());
    let [floor, man, sword, bowl] = scene.shapes() else {
        panic!("{:?}", scene.shapes());
    };
    assert!(floor.locked && floor.visible && !sword.visible && !sword.locked);
    assert_eq!(man.start.color, ShapeColor::Preset(12));
    assert_eq!(man.start.transform.position, Vec3::ZERO);
    assert_eq!(man.placement.transform.position, Vec3::X);

    let shape = scene.character(man.id).unwrap();
    let turned = |joint, degrees: [f32; 3]| {
        let expected = Euler::from_degrees(Vec3::from(degrees));
        assert_eq!(shape.pose().rotation(joint), expected);
    };
    turned(1, [0.0, 12.34, -400.0]);
    turned(2, [90.0, 0.0, 0.0]);
    assert_eq!(shape.pose().root_offset(0), Vec3::new(0.0, 0.2, 0.0));
    let kept: Vec<&str> = shape
        .poses()
        .iter()
        .map(|kept| kept.name.as_str())
        .collect();
    assert_eq!(kept, ["At rest", "Wave"]);
    let wave = &shape.poses()[1].pose;
    assert_eq!(wave.rotation(4).radians.z, 50.0_f32.to_radians());
    assert_eq!((shape.ik.length, shape.ik.pole), (3, IkPole::Front));
    assert!(!shape.ik.keep_orientation && shape.ik.pins.iter().eq([0, 3].iter()));
    assert_eq!(shape.display.line_width, 2.5);

    let curves = scene.curve(bowl.id).unwrap();
    assert!(!curves.frame_closing());
    assert_eq!(curves.display.curve, CurveVisibility::OnWithFrames);
    let items = curves.curves().items();
    let sweep = CurveItemKind::Sweep {
        profile: 2,
        sweep: 1,
    };
    assert_eq!(items[4].kind, sweep);
    let way = items[1].curve().unwrap();
    assert_eq!((way.steps(), way.stays_flat()), (8, false));
    assert_eq!(Basis::BSpline.pieces(way.control_points().len()), 1);
    assert_eq!(way.control_points()[2], Vec3::new(1.0, 1.0, 0.5));

    let again = scene_text(&scene, &view, Some(Path::new(FOLDER))).unwrap();
    assert_eq!(again, VERSION_2);
}

#[test]
fn a_file_is_read_once_however_many_shapes_name_it() {
    use editor_core::io::{Diagnostic, Files};
    use std::sync::Mutex;
    struct Counted(Table, Mutex<Vec<PathBuf>>);
    impl Files for Counted {
        fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
            self.1.lock().unwrap().push(path.to_owned());
            self.0.read(path)
        }

        fn exists(&self, path: &Path) -> bool {
            self.0.exists(path)
        }
    }
    let mut files = files();
    let shape = r#"{"name": "a", "source": {"file": "../rigs/pair.dae", "importer": "character", "part": 1}}"#;
    let text = format!(
        r#"{{"format": "editor-scene", "version": 2, "shapes": [{shape}, {shape}, {shape}]}}"#
    );
    files.0.insert(PathBuf::from(SCENE), text.into_bytes());
    let files = Counted(files, Mutex::default());
    let (scene, ..) = read(&files, SCENE, Missing::Refuse).unwrap();
    assert_eq!(scene.shapes().len(), 3);
    assert!(
        scene
            .shapes()
            .iter()
            .all(|shape| shape.kind.label() == "Shape")
    );
    let read = files.1.into_inner().unwrap();
    assert_eq!(read, [SCENE, "/home/ada/rigs/pair.dae"].map(PathBuf::from));
}
