use super::{
    Diagnostic, Files, Imported, builtin,
    dae::{DaeReport, DaeScene, read_dae_by},
    file_access,
    import_character::read_character_by,
    import_shape::read_shape_obj_by,
    is_character, read_swp,
    recorder::Recorder,
};
use crate::character::Character;
use crate::geometry::SharedMesh;
use crate::scene::{
    CharacterShape, CurveShape, Importer, NewShape, ShapeKind, Source, name_of_import,
};
use crate::steps::{Pace, at_once};
use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

/// The extensions of files that can be imported into a scene, in lower case.
pub const IMPORTABLE: [&str; 3] = ["obj", "swp", "dae"];

/// Those of them that hold meshes.
const WITH_MESHES: &[&str] = &["obj", "dae"];

/// Imports the file at `path` by its extension: an `.obj` file with a skeleton or
/// weights beside it is a character, others are shapes; a `.swp` file holds curves, and a `.dae`
/// file may hold several characters and shapes. `builtin:NAME` stands for a file too.
///
/// # Errors
/// If it cannot be read, is not well formed, or is of a kind that cannot be imported.
#[doc(alias = "FileImporter")]
pub fn import_any(files: &dyn Files, path: &Path) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    at_once(|pace| async move { import_any_by(files, path, &pace).await })
}

/// As [`import_any`], at a pace that is told of bytes.
///
/// # Errors
/// As [`import_any`].
pub(super) async fn import_any_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    let file = to_open(path)?;
    match file_access::extension(&file).as_str() {
        "obj" if is_character(files, &file) => import_character_by(files, path, pace).await,
        "obj" => import_shape_by(files, path, pace).await,
        "swp" => import_curve(files, path),
        "dae" => {
            let read = import_collada_by(files, path, pace).await?;
            Ok(read.map(|(shapes, _)| shapes))
        }
        extension => Err(cannot_open(
            files,
            path,
            extension,
            "a file that can be imported",
            &IMPORTABLE,
        )),
    }
}

/// Imports the file at `path` with `importer`: what a [`Source`] refers to, at a pace that is told of
/// bytes.
///
/// # Errors
/// If it cannot be read, is not well formed, or is of a kind that `importer` does not read.
pub(super) async fn import_with(
    files: &dyn Files,
    path: &Path,
    importer: Importer,
    pace: &Pace,
) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    match importer {
        // A scene's character may have become a shape since it was saved.
        Importer::Character if file_access::extension(path) == "dae" => {
            import_any_by(files, path, pace).await
        }
        Importer::Shape => Ok(shapes_without_bones(files, path, pace).await?.0),
        Importer::Character => import_character_by(files, path, pace).await,
        Importer::Curve => import_curve(files, path),
    }
}

/// Imports the Collada file at `path`, with a report about its other content.
///
/// # Errors
/// If it cannot be read or is not well formed.
pub fn import_collada(
    files: &dyn Files,
    path: &Path,
) -> Result<Imported<(Vec<NewShape>, DaeReport)>, Diagnostic> {
    at_once(|pace| async move { import_collada_by(files, path, &pace).await })
}

async fn import_collada_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<(Vec<NewShape>, DaeReport)>, Diagnostic> {
    let files = Recorder::new(files);
    let read = read_dae_by(&files, &to_open(path)?, pace).await?;
    Ok(read.map(|scene| {
        let report = scene.report.clone();
        // What has no skeleton is imported as shapes.
        let importer = if scene.characters.is_empty() {
            Importer::Shape
        } else {
            Importer::Character
        };
        let source = source(&files, path, importer);
        (shapes_of(source, scene), report)
    }))
}

/// Import Character: the `.obj` file at `path` with the `.skel` and `.attach` files beside it, or
/// all that a `.dae` file holds, a character among it.
///
/// # Errors
/// If one of them is missing, or cannot be read, or is not well formed, or does not fit.
pub fn import_character(
    files: &dyn Files,
    path: &Path,
) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    at_once(|pace| async move { import_character_by(files, path, &pace).await })
}

/// As [`import_character`], at a pace that is told of bytes.
///
/// # Errors
/// As [`import_character`].
pub(super) async fn import_character_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    let path = &*character_file(files, path);
    let file = to_open(path)?;
    let recorder = Recorder::new(files);
    match file_access::extension(&file).as_str() {
        "obj" => {
            exists(files, &file)?;
            let character = read_character_by(&recorder, &file, pace).await?;
            let source = source(&recorder, path, Importer::Character);
            Ok(character.map(|character| vec![new_shape(source, posable(character))]))
        }
        "dae" => {
            let read = read_dae_by(&recorder, &file, pace).await?;
            if read.value.characters.is_empty() {
                let message = "expected a character, found only shapes, which Import Shape reads";
                return Err(Diagnostic::new(path, message));
            }
            let source = source(&recorder, path, Importer::Character);
            Ok(read.map(|scene| shapes_of(source, scene)))
        }
        extension => Err(cannot_open(
            files,
            path,
            extension,
            "a character",
            WITH_MESHES,
        )),
    }
}

/// Import Shape: the mesh of the `.obj` file at `path`, even beside a skeleton, or those of a
/// `.dae` file without their skeletons.
///
/// # Errors
/// If it cannot be read or is not well formed.
pub fn import_shape(files: &dyn Files, path: &Path) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    at_once(|pace| async move { import_shape_by(files, path, &pace).await })
}

/// As [`import_shape`], at a pace that is told of bytes. That bones are left out is a warning, since who chose this may
/// have meant the character.
///
/// # Errors
/// As [`import_shape`].
pub(super) async fn import_shape_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    let (mut shapes, leaves_bones) = shapes_without_bones(files, path, pace).await?;
    if leaves_bones {
        let message = "expected a shape, found a character: its bones are left out. Insert ⏵ Import ⏵ Import \
                       Character… brings them along";
        shapes.warnings.push(Diagnostic::new(path, message));
    }
    Ok(shapes)
}

/// The shapes that [`import_shape`] finds, and whether there are bones that they leave out.
async fn shapes_without_bones(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<(Imported<Vec<NewShape>>, bool), Diagnostic> {
    let file = to_open(path)?;
    let recorder = Recorder::new(files);
    match file_access::extension(&file).as_str() {
        "obj" => {
            let bytes = recorder.read_by(&file, pace).await?;
            let mesh = read_shape_obj_by(&recorder, &file, bytes, pace).await?;
            let source = source(&recorder, path, Importer::Shape);
            let kind = |mesh| ShapeKind::Mesh(SharedMesh::new(mesh));
            let shape = mesh.map(|mesh| vec![new_shape(source, kind(mesh))]);
            Ok((shape, is_character(files, &file)))
        }
        "dae" => {
            let read = read_dae_by(&recorder, &file, pace).await?;
            let mut characters = read.value.characters.iter();
            let leaves_bones =
                characters.any(|found| !found.character.bind_mesh().positions.is_empty());
            let shapes = read.map(|scene| {
                let shapes = shapes_of(source(&recorder, path, Importer::Shape), scene);
                let rigid = shapes.into_iter().map(|shape| {
                    let rigid = NewShape::new(shape.name, ShapeKind::Mesh(shape.kind.mesh()));
                    NewShape {
                        source: shape.source,
                        ..rigid
                    }
                });
                let with_mesh = rigid.filter(|shape| !shape.kind.mesh().positions.is_empty());
                with_mesh.collect()
            });
            Ok((shapes, leaves_bones))
        }
        extension => Err(cannot_open(files, path, extension, "a shape", WITH_MESHES)),
    }
}

/// Import Curve: the curves and surfaces of the `.swp` file at `path`, as one shape.
///
/// # Errors
/// If it cannot be read or is not well formed.
pub fn import_curve(files: &dyn Files, path: &Path) -> Result<Imported<Vec<NewShape>>, Diagnostic> {
    let file = to_open(path)?;
    match file_access::extension(&file).as_str() {
        "swp" => {
            let recorder = Recorder::new(files);
            let curves = read_swp(&file, &recorder.read(&file)?)?;
            let source = source(&recorder, path, Importer::Curve);
            let kind = |curves| ShapeKind::Curve(CurveShape::new(curves));
            Ok(curves.map(|curves| vec![new_shape(source, kind(curves))]))
        }
        extension => Err(cannot_open(files, path, extension, "curves", &["swp"])),
    }
}

/// The file that `path` stands for: the one in the program for `builtin:NAME`.
///
/// # Errors
/// For a built-in name that does not exist, and for the companions that macOS writes.
pub(super) fn to_open(path: &Path) -> Result<std::path::PathBuf, Diagnostic> {
    if path.file_name().is_some_and(file_access::is_note_of_macos) {
        let message = "expected a file with content, found notes of macOS about the file of \
                       the same name without “._”";
        return Err(Diagnostic::new(path, message));
    }
    builtin::resolve(path)
}

fn exists(files: &dyn Files, path: &Path) -> Result<(), Diagnostic> {
    if files.exists(path) {
        Ok(())
    } else {
        // Reading knows best what is wrong.
        files.read(path).map(|_| ())
    }
}

/// Source of the first shape of the file at `path`, after all of it was read through `recorder`.
fn source(recorder: &Recorder, path: &Path, importer: Importer) -> Source {
    let is_builtin = path.to_string_lossy().starts_with(builtin::PREFIX);
    Source {
        file: recorder.absolute(path).to_string_lossy().into_owned(),
        importer,
        part: 0,
        fingerprint: (!is_builtin).then(|| recorder.fingerprint()),
    }
}

/// A shape that is named after its file.
fn new_shape(source: Source, kind: ShapeKind) -> NewShape {
    let file = &source.file;
    let path = Path::new(file.strip_prefix(builtin::PREFIX).unwrap_or(file));
    let name = name_of_import(&path.file_stem().unwrap_or_default().to_string_lossy());
    NewShape::new(name, kind).from_source(source)
}

fn posable(character: Character) -> ShapeKind {
    ShapeKind::Character(CharacterShape::new(Arc::new(character)))
}

/// The characters of a Collada file, then its static meshes. The only one of a file has the
/// file's name, others that of the file and their own.
fn shapes_of(source: Source, scene: DaeScene) -> Vec<NewShape> {
    let characters = scene.characters.into_iter();
    let characters = characters.map(|found| (found.name, posable(found.character)));
    let meshes = scene.meshes.into_iter();
    let meshes = meshes.map(|found| (found.name, ShapeKind::Mesh(SharedMesh::new(found.mesh))));
    let found: Vec<(String, ShapeKind)> = characters.chain(meshes).collect();
    let is_alone = found.len() == 1;
    found
        .into_iter()
        .enumerate()
        .map(|(part, (name, kind))| {
            let source = source.clone();
            let shape = new_shape(Source { part, ..source }, kind);
            NewShape {
                name: if is_alone {
                    shape.name
                } else {
                    format!("{} {name}", shape.name)
                },
                ..shape
            }
        })
        .collect()
}

/// The `.obj` file of the character whose skeleton or weights are at `path`, if it is there; all else as it is.
pub fn character_file<'a>(files: &dyn Files, path: &'a Path) -> Cow<'a, Path> {
    let extension = file_access::extension(path);
    let obj = path.with_extension("obj");
    if ["skel", "attach"].contains(&extension.as_str()) && files.exists(&obj) {
        Cow::Owned(obj)
    } else {
        Cow::Borrowed(path)
    }
}

/// The error for a file of the wrong kind, or that there is no such file.
pub(super) fn cannot_open(
    files: &dyn Files,
    path: &Path,
    extension: &str,
    what: &str,
    openable: &[&str],
) -> Diagnostic {
    if let Err(error) = exists(files, path) {
        return error;
    }
    let openable: Vec<String> = openable.iter().map(|e| format!(".{e}")).collect();
    let message = format!(
        "expected {what} ({}), found {}",
        openable.join(", "),
        match extension {
            "" => "no extension".to_owned(),
            "skel" | "attach" => format!(".{extension}: open the character's .obj file instead"),
            "json" => ".json: a pose is given to a character, by Load Pose or --pose".to_owned(),
            "swp" => ".swp, which Import Curve reads".to_owned(),
            "obj" | "dae" => format!(".{extension}, which Import Shape and Import Character read"),
            "scene" => ".scene, which Open reads".to_owned(),
            other => format!(".{other}"),
        }
    );
    Diagnostic::new(path, message)
}
