//! Files inside the program, addressed as `builtin:NAME`.

use super::{Diagnostic, Files, file_access};
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

macro_rules! assets {
    ($($path:literal),* $(,)?) => {
        &[$(($path, include_bytes!(concat!("../../assets/", $path)))),*]
    };
}

/// Path below `assets/`, and content.
static ASSETS: &[(&str, &[u8])] = assets![
    "characters/adult.attach",
    "characters/adult.obj",
    "characters/adult.skel",
    "characters/dog.attach",
    "characters/dog.obj",
    "characters/dog.skel",
    "characters/robot.attach",
    "characters/robot.obj",
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
        ASSETS.iter().filter_map(move |(path, _)| {
            let name = path.strip_prefix(folder)?.strip_suffix(extension)?;
            Some(Builtin { name, kind })
        })
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
    let paths = || ASSETS.iter().map(|(asset, _)| Path::new(asset));
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

fn builtin_name(path: &Path) -> Option<&str> {
    path.to_str()?.strip_prefix(PREFIX)
}

/// Answers for paths that start with `builtin:` from inside the program, and hands all others on.
#[derive(Clone, Copy, Debug)]
pub struct WithBuiltin<F>(
    /// Where the others go.
    pub F,
);

impl<F: Files> Files for WithBuiltin<F> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let resolved = resolve(path)?;
        match builtin_name(&resolved) {
            None => self.0.read(path),
            Some(name) => ASSETS
                .iter()
                .find(|(asset, _)| *asset == name)
                .map(|(_, bytes)| bytes.to_vec())
                .ok_or_else(|| Diagnostic::new(path, "there is no such built-in file")),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        match builtin_name(path) {
            None => self.0.exists(path),
            Some(_) => resolve(path).is_ok(),
        }
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
