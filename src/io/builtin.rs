//! Files inside the program, addressed as `builtin:NAME`.

use super::archive::main_files;
use super::file_access::is_scene;
use super::{Diagnostic, Files, file_access};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Prefix of the paths of built-in files.
pub const PREFIX: &str = "builtin:";

/// Content of a built-in file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuiltinKind {
    /// A mesh with skeleton and weights.
    Character,
    /// A mesh.
    Shape,
    /// Curves, and surfaces swept from them.
    Curve,
    /// Shapes with a view.
    Scene,
    /// Angles for joints.
    Pose,
}

/// A built-in file that has a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Builtin {
    /// Its name after `builtin:`.
    pub name: &'static str,
    /// Its content.
    pub kind: BuiltinKind,
}

/// A file of `assets/`.
struct Asset {
    /// Path below `assets/`.
    path: &'static str,
    content: Content,
    /// Number of its bytes.
    size: usize,
}

/// Bytes of a file of `assets/`.
enum Content {
    Plain(&'static [u8]),
    /// Deflated by `build.rs`, to a quarter on average.
    #[cfg(not(target_arch = "wasm32"))]
    Deflated(&'static [u8]),
    /// They are not inside the program.
    #[cfg(target_arch = "wasm32")]
    Absent,
}

macro_rules! plain {
    ($path:literal) => {
        Content::Plain(include_bytes!(concat!("../../assets/", $path)))
    };
}

#[cfg(not(target_arch = "wasm32"))]
macro_rules! deflated {
    ($path:literal) => {
        Content::Deflated(include_bytes!(concat!(env!("OUT_DIR"), "/", $path)))
    };
}

#[cfg(target_arch = "wasm32")]
macro_rules! deflated {
    ($path:literal) => {
        Content::Absent
    };
}

macro_rules! assets {
    ($content:ident; $($path:literal),* $(,)?) => {
        [$(Asset {
            path: $path,
            content: $content!($path),
            size: include_bytes!(concat!("../../assets/", $path)).len(),
        }),*]
    };
}

/// Files that are inside the program everywhere.
static SMALL: &[Asset] = &assets![plain;
    "characters/adult.skel",
    "characters/dog.skel",
    "characters/robot.skel",
    "curves/goblet.swp",
    "curves/knot.swp",
    "curves/pawn.swp",
    "curves/seam.swp",
    "curves/spring.swp",
    "curves/vase.swp",
    "shapes/gear.obj",
    "shapes/gem.obj",
    "shapes/plant.mtl",
    "scenes/mannequin-1.scene",
    "scenes/mannequin-2.scene",
    "scenes/mannequin-3.scene",
    "scenes/mannequin-4.scene",
    "scenes/mannequin-5.scene",
    "scenes/mannequin-6.scene",
    "scenes/mannequin-7.scene",
    "scenes/showcase.scene",
    "scenes/turned.scene",
    "poses/adult-sit.json",
    "poses/adult-walk.json",
    "poses/adult-wave.json",
    "poses/chain-snake.json",
    "poses/creature-wave.json",
    "poses/dog-sit.json",
    "poses/dog-trot.json",
    "poses/face-wink.json",
    "poses/humanoid-point.json",
    "poses/lizard-turn.json",
    "poses/robot-greet.json",
    "poses/robot-march.json",
    "poses/tentacle-curl.json",
];

/// Files that a page fetches when they are used: with them, it would be twice as long to load.
static LARGE: &[Asset] = &assets![deflated;
    "characters/adult.attach",
    "characters/adult.obj",
    "characters/dog.attach",
    "characters/dog.obj",
    "characters/robot.attach",
    "characters/robot.obj",
    "shapes/plant.obj",
    "rigs/chain.dae",
    "rigs/column.dae",
    "rigs/crate.dae",
    "rigs/crate.png",
    "rigs/creature.dae",
    "rigs/face.dae",
    "rigs/humanoid.dae",
    "rigs/lizard.dae",
    "rigs/tentacle.dae",
];

fn assets() -> impl Iterator<Item = &'static Asset> {
    SMALL.iter().chain(LARGE)
}

/// Everything that has a name of its own, in the order of the kinds and then of the names.
pub fn catalogue() -> Vec<Builtin> {
    [
        ("characters/", ".obj", BuiltinKind::Character),
        ("rigs/", ".dae", BuiltinKind::Character),
        ("shapes/", ".obj", BuiltinKind::Shape),
        ("curves/", ".swp", BuiltinKind::Curve),
        ("scenes/", ".scene", BuiltinKind::Scene),
        ("poses/", ".json", BuiltinKind::Pose),
    ]
    .into_iter()
    .flat_map(|(folder, extension, kind)| {
        let name = |asset: &Asset| asset.path.strip_prefix(folder)?.strip_suffix(extension);
        let names: BTreeSet<&str> = assets().filter_map(name).collect();
        names.into_iter().map(move |name| Builtin { name, kind })
    })
    .collect()
}

/// The file that `path` stands for. `builtin:adult` is `builtin:characters/adult.obj`, and
/// `builtin:poses/adult-walk` gets its extension; complete names, and paths on disk, stay.
///
/// # Errors
/// If `path` starts with `builtin:` and there is no such thing; the message lists all.
pub fn resolve(path: &Path) -> Result<PathBuf, Diagnostic> {
    let Some(name) = builtin_name(path) else {
        return Ok(path.to_owned());
    };
    let primary = |asset: &Path| {
        ["obj", "dae", "swp", "scene", "json"].contains(&&*file_access::extension(asset))
    };
    let paths = || assets().map(|asset| Path::new(asset.path));
    paths()
        .find(|asset| *asset == Path::new(name))
        .or_else(|| paths().find(|a| primary(a) && a.with_extension("") == Path::new(name)))
        .or_else(|| paths().find(|a| primary(a) && a.file_stem() == Some(name.as_ref())))
        .map(|asset| PathBuf::from(format!("{PREFIX}{}", asset.display())))
        .ok_or_else(|| {
            let known = catalogue();
            let known: Vec<&str> = known.iter().map(|builtin| builtin.name).collect();
            let known = known.join(", ");
            Diagnostic::new(path, format!("expected one of {known} after {PREFIX}"))
        })
}

/// Whether `path` is that of a built-in file.
pub fn is_builtin(path: &Path) -> bool {
    builtin_name(path).is_some()
}

/// Name of a built-in file, without what says that it is one.
pub fn builtin_name(path: &Path) -> Option<&str> {
    path.to_str()?.strip_prefix(PREFIX)
}

/// Names below `assets/` of the built-in files that are read with `path` and that `files` does not
/// have, so that they must be brought before.
pub fn absent(files: &dyn Files, path: &Path) -> Vec<PathBuf> {
    let Ok(path) = resolve(path) else {
        return Vec::new();
    };
    let own = companions(&path).filter(|path| !files.exists(path));
    let mut absent: Vec<PathBuf> = own.collect();
    let main = match &*file_access::extension(&path) {
        "zip" => main_files(files, &path).unwrap_or_default(),
        _ => vec![path],
    };
    for scene in main.into_iter().filter(|path| is_scene(path)) {
        if let Ok(bytes) = files.read(&scene) {
            absent.extend(absent_in(files, &String::from_utf8_lossy(&bytes)));
        }
    }
    absent
}

/// The same for a scene with this text.
pub fn absent_in(files: &dyn Files, text: &str) -> Vec<PathBuf> {
    let named = text.match_indices(PREFIX).filter_map(|(start, _)| {
        let name = text[start..].split('"').next()?;
        resolve(Path::new(name)).ok()
    });
    let named: BTreeSet<PathBuf> = named.collect();
    let all = named.iter().flat_map(|path| companions(path));
    all.filter(|path| !files.exists(path)).collect()
}

/// A built-in file and those that belong to it by their names; nothing for other files.
fn companions(path: &Path) -> impl Iterator<Item = PathBuf> {
    let stem = builtin_name(path).map(|name| Path::new(name).with_extension(""));
    let belongs = move |asset: &&Asset| Some(Path::new(asset.path).with_extension("")) == stem;
    assets()
        .filter(belongs)
        .map(|asset| PathBuf::from(format!("{PREFIX}{}", asset.path)))
}

/// Number of bytes of the built-in file at `path`, wherever it is; 0 if there is none.
pub fn size(path: &Path) -> usize {
    asset(path).map_or(0, |asset| asset.size)
}

/// Answers for paths that start with `builtin:` from inside the program, and hands all others on;
/// and those of built-in files that are not inside it.
#[derive(Clone, Copy, Debug)]
pub struct WithBuiltin<F>(
    /// Where the others go.
    pub F,
);

impl<F: Files> Files for WithBuiltin<F> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let resolved = resolve(path)?;
        match asset(&resolved).map(|asset| (&asset.content, asset.size)) {
            Some((Content::Plain(content), _)) => Ok(content.to_vec()),
            #[cfg(not(target_arch = "wasm32"))]
            Some((Content::Deflated(content), size)) => inflated(content, size, path),
            _ => self.0.read(&resolved),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        resolve(path).is_ok_and(|path| asset(&path).is_some_and(is_inside) || self.0.exists(&path))
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        match builtin_name(path) {
            None => self.0.absolute(path),
            Some(_) => path.to_owned(),
        }
    }

    fn real(&self, path: &Path) -> PathBuf {
        match builtin_name(path) {
            None => self.0.real(path),
            Some(_) => path.to_owned(),
        }
    }
}

/// The built-in file at `path`, complete with folder and extension.
fn asset(path: &Path) -> Option<&'static Asset> {
    let name = builtin_name(path)?;
    assets().find(|asset| asset.path == name)
}

fn is_inside(asset: &Asset) -> bool {
    match asset.content {
        Content::Plain(_) => true,
        #[cfg(not(target_arch = "wasm32"))]
        Content::Deflated(_) => true,
        #[cfg(target_arch = "wasm32")]
        Content::Absent => false,
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn inflated(content: &[u8], size: usize, path: &Path) -> Result<Vec<u8>, Diagnostic> {
    use std::io::Read;
    let mut bytes = Vec::with_capacity(size);
    let read = flate2::read::DeflateDecoder::new(content).read_to_end(&mut bytes);
    read.map_err(|error| Diagnostic::new(path, error.to_string()))?;
    Ok(bytes)
}
