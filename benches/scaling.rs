//! How costs grow with what there is more of. Nothing should grow faster than the work does.

use crate::import::{Alone, Corners, write_grid};
use crate::picking;
use crate::report::Report;
use crate::skinning::Posed;
use cpu_time::ProcessTime;
use editor_core::character::{Joint, Pose, SkeletalModel};
use editor_core::gpu::{Backend, Framebuffer, HeadlessContext};
use editor_core::math::Euler;
use editor_core::render::{Frame, Renderer};
use editor_core::scene::{Evaluator, FitArea, NewShape, Scene, ShapeKind, ViewSettings};
use glam::Vec3;
use std::hint::black_box;
use std::time::Instant;

/// The most that an exponent may be without a reason.
const LINEAR: f64 = 1.05;
const ROUNDS: usize = 7;
/// Milliseconds that one measurement should take at least.
const LONG_ENOUGH: f64 = 2.0;

pub fn run(report: &mut Report) {
    report.growth("Skinning a character", "vertices", LINEAR, || {
        let counts = [1, 4, 16, 64].map(|times| times * 10_000);
        by_size(&counts, |vertices| {
            Posed::regular(vertices, 18, 4).skinning(1)
        })
    });
    report.growth("Posing a skeleton", "joints", LINEAR, || {
        by_size(&[16, 64, 256, 1024, 4096], |joints| {
            let skeleton = limbs(joints);
            let mut pose = Pose::new();
            for joint in 0..joints {
                let angle = (joint as f32).sin() * 20.0;
                pose.set_joint_transform(joint, Euler::from_degrees(Vec3::splat(angle)));
            }
            move || {
                let current = skeleton.update_current_joint_to_world_transforms(&pose);
                drop(black_box(skeleton.palette(&current)));
            }
        })
    });
    report.growth("Skinning by more joints", "joints", LINEAR, || {
        by_size(&[16, 64, 256, 1024], |joints| {
            Posed::regular(40_000, joints, 4).skinning(1)
        })
    });
    report.growth("Skinning by more influences", "influences", LINEAR, || {
        by_size(&[1, 2, 4, 8, 16], |influences| {
            Posed::regular(40_000, 18, influences).skinning(1)
        })
    });
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    if all > 1 {
        let what = "Skinning a crowd, by the clock";
        report.growth(what, "threads", -0.85, || {
            let crowd = Posed::regular(1_000_000, 18, 4);
            let counts = (0..).map(|power| 1 << power).take_while(|&it| it <= all);
            let counts: Vec<usize> = counts.collect();
            let mut ways: Vec<_> = counts.iter().map(|&it| crowd.skinning(it)).collect();
            let rounds = (0..ROUNDS).map(|_| ways.iter_mut().map(by_the_clock).collect());
            counts
                .iter()
                .map(|&it| it as f64)
                .zip(least(rounds))
                .collect()
        });
    }
    report.growth("A ray of the pointer", "triangles", LINEAR, || {
        by_size(&[20_000, 200_000, 2_000_000], |triangles| {
            let pick = picking::Pick::new(triangles as u32);
            move || {
                black_box(pick.by_boxes());
            }
        })
    });
    report.growth("The first picture of a mesh", "triangles", LINEAR, || {
        let sizes = [125_000, 500_000, 2_000_000];
        let rounds = (0..3).map(|_| sizes.iter().map(|&it| first_picture(it)).collect());
        sizes
            .iter()
            .map(|&it| f64::from(it))
            .zip(least(rounds))
            .collect()
    });
    report.growth("Importing an .obj", "bytes", LINEAR, || {
        let folder = tempfile::tempdir().expect("a folder for files to read");
        let sizes = [6_250_000, 25_000_000, 100_000_000];
        let files = sizes.map(|size| {
            let file = folder.path().join(format!("{size}.obj"));
            write_grid(&file, size, Corners::All);
            file
        });
        let rounds = (0..3).map(|_| files.iter().map(|it| Alone::import(it).cost).collect());
        sizes
            .iter()
            .map(|&it| it as f64)
            .zip(least(rounds))
            .collect()
    });
}

/// Milliseconds of the processor for each size, done by what `prepare` makes for it: the least of
/// interleaved rounds.
fn by_size<W: FnMut()>(sizes: &[usize], prepare: impl Fn(usize) -> W) -> Vec<(f64, f64)> {
    let mut ways: Vec<W> = sizes.iter().map(|&size| prepare(size)).collect();
    let rounds = (0..ROUNDS).map(|_| ways.iter_mut().map(|way| cost(way)).collect());
    let costs = least(rounds);
    sizes.iter().map(|&size| size as f64).zip(costs).collect()
}

/// Milliseconds of the processor, as often as it takes to measure them.
fn cost(work: &mut impl FnMut()) -> f64 {
    let start = ProcessTime::now();
    let mut times = 0.0;
    loop {
        work();
        times += 1.0;
        let spent = start.elapsed().as_secs_f64() * 1e3;
        if spent >= LONG_ENOUGH {
            return spent / times;
        }
    }
}

fn by_the_clock(work: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e3
}

/// The least of each column.
fn least(rounds: impl Iterator<Item = Vec<f64>>) -> Vec<f64> {
    let both = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(b).map(|(a, b)| a.min(b)).collect();
    rounds.reduce(both).expect("rounds")
}

/// A skeleton of limbs, eight joints each, that hang on those of the limb before.
fn limbs(joints: usize) -> SkeletalModel {
    let joint = |index: usize| Joint {
        name: format!("Joint {index}"),
        parent: index
            .checked_sub(if index % 8 == 1 { 8 } else { 1 })
            .or((index > 0).then_some(0)),
        offset: Vec3::new(0.1, 0.2, 0.3),
        ..Joint::default()
    };
    SkeletalModel::new((0..joints).map(joint).collect()).expect("a skeleton")
}

/// Milliseconds of the processor from a mesh in memory to its picture.
fn first_picture(triangles: u32) -> f64 {
    let mut scene = Scene::new();
    scene.add(NewShape::new(
        "Sphere",
        ShapeKind::Mesh(picking::mesh(triangles)),
    ));
    let mut view = ViewSettings::default();
    let bounds = Evaluator::new().evaluate(&scene, 0.0).world_bounds();
    view.camera.fit(&bounds, FitArea::whole(4.0 / 3.0));
    let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
    let mut renderer = Renderer::new(headless.gl()).expect("a renderer");
    let target = Framebuffer::new(headless.gl(), 800, 600, 0).expect("a picture");
    let start = ProcessTime::now();
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let frame = Frame::plain(&scene, &evaluated, &view);
    renderer.draw(&frame, &target).expect("a drawn frame");
    headless.gl().finish();
    start.elapsed().as_secs_f64() * 1e3
}
