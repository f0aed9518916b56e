//! The picture of a submission, which the assignment wants to show two posed characters: one that
//! was drawn before, or one of a scene.

use super::archive::Entry;
use crate::cli::CliError;
use crate::cli::arguments::load;
use crate::cli::output::{eprint_line, picture_format};
use crate::disk::files;
use crate::editor::{Session, View};
use crate::geometry::Picture;
use crate::gpu::Backend;
use crate::io::image::{self, PictureFormat};
use crate::io::{Diagnostic, Files, package, to_zip};
use crate::math::{Aabb, Euler};
use crate::render::{Frame, Offscreen};
use crate::scene::{Camera, EvaluatedShape, ShapeKind};
use glam::Vec3;
use std::path::Path;

/// Number of posed characters that the assignment asks for.
const WANTED: usize = 2;
/// Height of a picture that is drawn, in pixels.
const HEIGHT: u32 = 960;
/// Its width by its height, and the most where that is not enough for those who are posed: the window that the camera was
/// set in may have been as wide.
const ASPECT: f32 = 4.0 / 3.0;
const WIDEST: f32 = 2.4;
/// Room that is left at the sides of a wider picture, by half of its width.
const MARGIN: f32 = 0.03;
/// Samples a pixel that are asked for; a driver that has fewer draws with what it has.
const SAMPLES: u32 = 4;

/// The picture `path`, as it is. Whom it shows cannot be seen from its pixels, so that the student
/// is reminded of it; a picture of nothing is refused.
///
/// # Errors
/// If it is not a PNG, JPEG or GIF by name and content, or has one color.
pub(super) fn of_file(path: &Path) -> Result<Vec<Entry>, CliError> {
    picture_format(path)?;
    let bytes = files().read(path)?;
    let picture = image::decode(path, &bytes)?;
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    if pixels.iter().all(|pixel| Some(pixel) == pixels.first()) {
        let message = "expected a picture of two posed characters, found a single color";
        return Err(Diagnostic::new(path, message).into());
    }
    let shown = path.display();
    eprint_line(format_args!(
        "note: {shown} is handed in as it is. Check that it shows two posed characters; with --scene \
         instead of --picture, that is checked for you."
    ));
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let name = format!("picture.{}", extension.to_lowercase());
    Ok(vec![Entry::new(name, bytes)])
}

/// The scene `path` as a picture, as `editor render --axis off` draws it, and as an archive together with the
/// models that it names.
///
/// # Errors
/// If it cannot be read or drawn, or shows fewer than two posed characters.
pub(super) fn of_scene(path: &Path) -> Result<Vec<Entry>, CliError> {
    let mut session = load(&[path.to_owned()], None)?;
    session.look(View::SetAxis(false));
    let aspect = check(path, &session)?;
    let size = ((HEIGHT as f32 * aspect).round() as u32, HEIGHT);
    if aspect > ASPECT && aspect < WIDEST {
        let (width, height) = size;
        eprint_line(format_args!(
            "note: the picture is {width}x{height}, so that nobody is cut off at its sides"
        ));
    }
    let png = image::encode(&draw(&session, size)?, PictureFormat::Png)
        .map_err(|message| Diagnostic::new(path, message))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    // Built-in scenes have no file, and a name with a colon is none on every system.
    let name = name.rsplit(':').next().unwrap_or_default().to_owned();
    let (scene, view) = (session.scene(), session.view());
    let models = to_zip(&package(&files(), scene, view, &name)?.files)?;
    Ok(vec![
        Entry::new("picture.png", png),
        Entry::new(Path::new("data").join(name + ".zip"), models),
    ])
}

fn draw(session: &Session, size: (u32, u32)) -> Result<Picture, CliError> {
    let mut offscreen = Offscreen::new(Backend::Auto)?;
    let frame = Frame::plain(session.scene(), session.evaluated(), session.view());
    let samples = SAMPLES.min(offscreen.gl().info().max_samples);
    let picture = offscreen.picture(&frame, size, samples)?;
    for notice in offscreen.renderer().take_notices() {
        eprint_line(format_args!("warning: {notice}"));
    }
    Ok(picture)
}

/// Refuses a scene that shows too few posed characters, and says of each why it does not count. Returns the width of the
/// picture by its height.
fn check(path: &Path, session: &Session) -> Result<f32, CliError> {
    let camera = &session.view().camera;
    let mut counted = 0;
    let mut aspect = ASPECT;
    let mut others = Vec::new();
    let shapes = session.scene().shapes().iter();
    for (shape, evaluated) in shapes.zip(&session.evaluated().shapes) {
        let ShapeKind::Character(character) = &shape.kind else {
            continue;
        };
        let joints = 0..character.character.skeleton().joints().len();
        let is_posed = joints
            .into_iter()
            .any(|joint| character.pose().rotation(joint) != Euler::ZERO);
        let why = if !shape.visible {
            "is hidden"
        } else if !is_posed {
            "is not posed"
        } else if !is_in_picture(camera, &evaluated.world_bounds()) {
            "is outside the picture"
        } else {
            counted += 1;
            let needed = aspect_for(camera, evaluated);
            if needed > WIDEST {
                eprint_line(format_args!(
                    "warning: “{}” is cut off at a side of the picture",
                    shape.name
                ));
            }
            aspect = aspect.max(needed.min(WIDEST));
            continue;
        };
        others.push(format!("“{}” {why}", shape.name));
    }
    if counted >= WANTED {
        return Ok(aspect);
    }
    let found = match counted {
        0 => "none".to_owned(),
        _ => counted.to_string(),
    };
    let others = match others.join(", ") {
        none if none.is_empty() => ", and no other character".to_owned(),
        others => format!(": {others}"),
    };
    let message = format!("expected two posed characters in the picture, found {found}{others}");
    Err(Diagnostic::new(path, message).into())
}

/// Width by height of a picture in which no vertex is beside its sides, with a margin unless the usual one is enough.
fn aspect_for(camera: &Camera, shape: &EvaluatedShape) -> f32 {
    let clip_from_model = camera.clip_from_world(1.0) * shape.world_from_model;
    let positions = shape.geometry.positions().iter();
    let clips = positions.map(|position| clip_from_model * position.extend(1.0));
    let ahead = clips.filter(|clip| clip.w > 0.0);
    let widest = ahead
        .map(|clip| (clip.x / clip.w).abs())
        .fold(0.0, f32::max);
    match widest {
        enough if enough <= ASPECT => ASPECT,
        wide => wide / (1.0 - MARGIN),
    }
}

/// Whether the middle or a corner of `bounds`, in the world, is in the widest picture.
fn is_in_picture(camera: &Camera, bounds: &Aabb) -> bool {
    let clip_from_world = camera.clip_from_world(WIDEST);
    let corner = |index: usize| {
        let side = |axis: usize| [bounds.min, bounds.max][index >> axis & 1][axis];
        Vec3::new(side(0), side(1), side(2))
    };
    let middle = (bounds.min + bounds.max) / 2.0;
    (0..8).map(corner).chain([middle]).any(|point| {
        let clip = clip_from_world * point.extend(1.0);
        clip.w > 0.0 && clip.truncate().abs().max_element() <= clip.w
    })
}
