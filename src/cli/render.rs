//! `editor render`: a picture without a window.

use super::CliError;
use super::arguments::{self, DisplayOptions, edit, load};
use super::output::{eprint_line, picture_format};
use super::render_ui::{self, PanelOptions};
use crate::disk;
use crate::editor::{Session, View};
use crate::gpu::Backend;
use crate::io;
use crate::render::{Frame, Marks, Offscreen};
use crate::scene::{Camera, Look, ViewDirection};
use std::path::PathBuf;

/// Draws scenes, characters and shapes into a picture, without a window or a display.
///
/// The same input gives the same picture, byte for byte, on every run.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor render builtin:showcase --samples 4 -o showcase.png\n  \
    editor render Model1.obj --pose walk.json --display skeleton --fit -o walk.png")]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), or builtin:NAME.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The picture to write; its extension is .png, .jpg or .gif.
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    /// Width and height in pixels.
    #[arg(long, default_value = "800x600", value_parser = arguments::size)]
    size: (u32, u32),
    /// Camera: angles in degrees, distance, and the point it looks at.
    #[arg(
        long,
        value_name = "THETA,PHI,RADIUS[,TX,TY,TZ]",
        allow_hyphen_values = true,
        value_parser = arguments::camera
    )]
    camera: Option<Camera>,
    /// One of the six views: +x, -x, +y, -y, +z or -z.
    #[arg(long, allow_hyphen_values = true, value_parser = arguments::view, conflicts_with = "camera")]
    view: Option<ViewDirection>,
    /// Move the camera so that everything is in the picture, keeping its direction.
    #[arg(long)]
    fit: bool,
    /// Pose every character by this POSE.json.
    #[arg(long, value_name = "POSE.json")]
    pose: Option<PathBuf>,
    #[command(flatten)]
    display: DisplayOptions,
    /// Influences per vertex: all of the file, or the four largest.
    #[arg(long, default_value = "all")]
    influences: arguments::Influences,
    /// Light and background [default: course, or as the scene has it].
    #[arg(long)]
    look: Option<LookName>,
    /// Draw the axes.
    #[arg(long, value_name = "on|off", default_value = "off", value_parser = arguments::switch, action = clap::ArgAction::Set)]
    axis: bool,
    /// Samples a pixel, for smooth edges; 0 for none. A driver takes the next number that it has:
    /// on the processor, 4 for any other.
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true, value_parser = arguments::samples)]
    samples: u32,
    /// OpenGL that draws.
    #[arg(long, default_value = "auto")]
    gl: GlName,
    /// Processor that deforms characters [default: the graphics card, or the CPU if that draws].
    #[arg(long)]
    skinning: Option<arguments::SkinningName>,
    /// Draw the window's panels too; the size is the window's.
    #[arg(long)]
    ui: bool,
    #[command(flatten)]
    panels: PanelOptions,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum LookName {
    Course,
    Studio,
    Mannequin,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum GlName {
    /// EGL, and OSMesa where there is none.
    Auto,
    Egl,
    Osmesa,
}

/// Draws the picture and writes it.
///
/// # Errors
/// When a file cannot be read or written, a joint of the pose is missing, there is no OpenGL, or
/// the picture is too large for it.
pub fn run(args: &Args) -> Result<(), CliError> {
    let format = picture_format(&args.output)?;
    if args.ui {
        render_ui::check_size(args.size)?;
    }
    let session = session(args)?;
    let backend = match args.gl {
        GlName::Auto => Backend::Auto,
        GlName::Egl => Backend::Egl,
        GlName::Osmesa => Backend::Osmesa,
    };
    let skinning = args.skinning.map(Into::into);
    let picture = if args.ui {
        render_ui::picture(
            &args.panels,
            session,
            backend,
            args.size,
            args.samples,
            skinning,
        )?
    } else {
        let mut offscreen = Offscreen::new(backend)?;
        offscreen.renderer().set_skinning(skinning);
        let frame = Frame {
            scene: session.scene(),
            evaluated: session.evaluated(),
            view: session.view(),
            marks: Marks::default(),
        };
        let picture = offscreen.picture(&frame, args.size, args.samples)?;
        for notice in offscreen.renderer().take_notices() {
            eprint_line(format_args!("warning: {notice}"));
        }
        picture
    };
    let bytes = io::image::encode(&picture, format)
        .map_err(|message| io::Diagnostic::new(&args.output, message))?;
    disk::write_whole(&args.output, &bytes)?;
    Ok(())
}

fn session(args: &Args) -> Result<Session, CliError> {
    let mut session = load(&args.files, args.pose.as_deref())?;
    let mut edits = args.influences.edits(&session);
    edits.extend(args.display.edits(&session));
    edit(&mut session, edits)?;

    session.look(View::SetAxis(args.axis));
    if let Some(look) = args.look {
        session.look(View::SetLook(match look {
            LookName::Course => Look::Course,
            LookName::Studio => Look::Studio,
            LookName::Mannequin => Look::Mannequin,
        }));
    }
    if let Some(camera) = args.camera.or(args.view.map(Camera::preset)) {
        session.look(View::SetCamera(camera));
    }
    if args.fit {
        let (width, height) = args.size;
        let mut camera = session.view().camera;
        let bounds = session.evaluated().world_bounds();
        camera.fit(&bounds, width as f32 / height as f32);
        session.look(View::SetCamera(camera));
    }
    Ok(session)
}
