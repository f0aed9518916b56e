//! Reading files, beside `tobj`, which only reads numbers and indices of `.obj` files.

use crate::report::Report;
use cpu_time::ProcessTime;
use editor_core::disk::Disk;
use editor_core::geometry::Mesh;
use editor_core::io::{import_character, import_shape};
use editor_core::scene::{NewShape, ShapeKind};
use glam::Vec3;
use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;

/// assimp's time for a `.dae` of 1.8 MB as a part of `tobj`'s for an `.obj` of 0.8 MB, at best, where they were
/// measured beside each other.
const ASSIMP: f64 = 1.05;

/// Size of the large files, in bytes.
const LARGE: usize = 100_000_000;

pub fn run(report: &mut Report) {
    let folder = tempfile::tempdir().expect("a folder for files to read");
    let adult = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/characters/adult.obj");
    report.ratio(
        "Importing a character of three files against tobj reading its .obj alone",
        0.6,
        || least(40, || drop(ours_character(&adult)), || tobj(&adult)),
    );
    report.ratio(
        "Importing a character of three files against 3 ms",
        1.0,
        || (least(40, || drop(ours_character(&adult)), || ()).0, 3.0),
    );
    let humanoid = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/rigs/humanoid.dae");
    report.ratio(
        "Importing a .dae of 1.8 MB against tobj reading an .obj of 0.8 MB",
        ASSIMP,
        || least(20, || drop(ours_character(&humanoid)), || tobj(&adult)),
    );
    for (corners, name) in [
        (Corners::Positions, "positions alone"),
        (Corners::All, "normals and texture coordinates"),
    ] {
        let file = folder.path().join(format!("{name}.obj"));
        report.ratio(
            &format!("Importing an .obj of 100 MB with {name} against tobj"),
            0.5,
            || {
                write_grid(&file, LARGE, corners);
                least(3, || drop(ours(&file)), || tobj(&file))
            },
        );
        let what = format!(
            "Peak memory of importing an .obj of 100 MB with {name} against the file and twice the mesh"
        );
        report.ratio_in("MB", &what, 1.0, || {
            write_grid(&file, LARGE, corners);
            let Alone { peak, mesh, .. } = Alone::import(&file);
            (peak, file_size(&file) as f64 / 1e6 + 2.0 * mesh)
        });
        let what = format!("Importing an .obj of 100 MB with {name} against two of 50 MB");
        report.ratio(&what, 1.05, || {
            write_grid(&file, LARGE, corners);
            let small = folder.path().join(format!("{name}, half.obj"));
            write_grid(&small, LARGE / 2, corners);
            let rounds = (0..5).map(|_| [&file, &small].map(|file| Alone::import(file).cost));
            let least = rounds.reduce(|least, round| [0, 1].map(|at| least[at].min(round[at])));
            let [one, half] = least.expect("rounds");
            (one, 2.0 * half)
        });
        // The next one needs the space.
        let _ = std::fs::remove_file(&file);
    }
}

fn ours(file: &Path) -> Vec<NewShape> {
    black_box(import_shape(&Disk, file).expect("a shape").value)
}

fn ours_character(file: &Path) -> Vec<NewShape> {
    black_box(import_character(&Disk, file).expect("a character").value)
}

/// As it reads with the least work: neither triangulated nor indexed anew.
fn tobj(file: &Path) {
    let options = tobj::LoadOptions::default();
    let _ = black_box(tobj::load_obj(file, &options).expect("a mesh"));
}

/// What corners of faces have.
#[derive(Clone, Copy)]
pub enum Corners {
    Positions,
    All,
}

/// Writes a bent grid with two triangles a square as an `.obj` of about so many bytes.
pub fn write_grid(file: &PathBuf, bytes: usize, corners: Corners) {
    if file.exists() {
        return;
    }
    let of_square = match corners {
        Corners::Positions => 77,
        Corners::All => 187,
    };
    let side = (bytes / of_square).isqrt();
    let mut text = String::with_capacity(bytes * 5 / 4);
    // Writing to a string cannot fail.
    for at in 0..side * side {
        let [u, v] = [at % side, at / side].map(|i| i as f32 / side as f32);
        let place = Vec3::new(u - 0.5, (9.0 * u).sin() * (7.0 * v).cos() / 3.0, 1.5 - v);
        let _ = writeln!(text, "v {:.6} {:.6} {:.6}", place.x, place.y, place.z);
        if let Corners::All = corners {
            let normal = (place + Vec3::Y).normalize_or_zero();
            let _ = writeln!(text, "vt {u:.6} {v:.6}");
            let _ = writeln!(text, "vn {:.4} {:.4} {:.4}", normal.x, normal.y, normal.z);
        }
    }
    let corner = |at: usize| match corners {
        Corners::Positions => format!("{}", at + 1),
        Corners::All => format!("{0}/{0}/{0}", at + 1),
    };
    for row in 0..side - 1 {
        for at in row * side..row * side + side - 1 {
            let [a, b, c, d] = [at, at + 1, at + side + 1, at + side].map(corner);
            let _ = writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}");
        }
    }
    std::fs::write(file, text).expect("a file is written");
}

fn file_size(file: &Path) -> usize {
    let size = std::fs::metadata(file).expect("a file").len();
    size.try_into().expect("a size in memory")
}

/// Name of the environment variable with the file that a process of its own imports.
const IMPORTED_ALONE: &str = "EDITOR_BENCH_IMPORTED";

/// The import of a file in a process of its own: in this one there would be room left that was freed
/// before.
pub struct Alone {
    /// Peak of the memory that it takes, in megabytes.
    peak: f64,
    /// Memory of its mesh, in megabytes.
    mesh: f64,
    /// Milliseconds of the processor.
    pub cost: f64,
}

impl Alone {
    /// Starts this program once more to import `file`.
    pub fn import(file: &Path) -> Self {
        let bench = std::env::current_exe().expect("this program");
        let output = Command::new(bench)
            .env(IMPORTED_ALONE, file)
            .output()
            .expect("it starts again");
        let printed = String::from_utf8_lossy(&output.stdout);
        let numbers = printed.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().expect("numbers");
        let [peak, mesh, cost] = numbers[..] else {
            panic!("three numbers are printed: {printed}");
        };
        Self { peak, mesh, cost }
    }
}

/// In a process that [`Alone::import`] has started: imports its file, and prints what there is to know.
/// Whether it is such a process.
pub fn is_import_alone() -> bool {
    let Some(file) = std::env::var_os(IMPORTED_ALONE) else {
        return false;
    };
    let start = ProcessTime::now();
    let (peak, shapes) = peak_of(|| ours(Path::new(&file)));
    let cost = start.elapsed().as_secs_f64() * 1e3;
    let ShapeKind::Mesh(mesh) = &shapes[0].kind else {
        panic!("{} is a mesh", file.display());
    };
    println!("{peak} {} {cost}", Mesh::memory(mesh) as f64 / 1e6);
    true
}

/// By how many megabytes the memory of this process grows at most while `work` is done, and what
/// that returns; not a number where the system does not say.
fn peak_of<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let megabytes = |name: &str| {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix(name));
        let kib = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<f64>().ok());
        kib.map_or(f64::NAN, |kib| kib * 1024.0 / 1e6)
    };
    // The greatest so far counts from here (proc(5)).
    let reset = std::fs::write("/proc/self/clear_refs", "5");
    let before = megabytes("VmRSS:");
    let done = work();
    let peak = if reset.is_ok() {
        megabytes("VmHWM:")
    } else {
        f64::NAN
    };
    (peak - before, done)
}

/// Milliseconds of the processor of both: the least of interleaved rounds.
fn least(rounds: usize, mut one: impl FnMut(), mut other: impl FnMut()) -> (f64, f64) {
    let timed = |work: &mut dyn FnMut()| {
        let start = ProcessTime::now();
        work();
        start.elapsed().as_secs_f64() * 1e3
    };
    let rounds = (0..rounds).map(|_| (timed(&mut one), timed(&mut other)));
    rounds.fold((f64::INFINITY, f64::INFINITY), |least, round| {
        (least.0.min(round.0), least.1.min(round.1))
    })
}
