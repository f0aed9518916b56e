//! `editor render`: a picture without a window.

use super::CliError;
use super::arguments::{self, DisplayOptions, edit, load};
use super::colors::{self, Colors};
use super::output::{Progress, eprint_line, picture_format};
use super::pipes::{self, Ends};
use super::render_ui::{self, PanelOptions};
use super::turntable;
use crate::editor::{Session, View};
use crate::geometry::Picture;
use crate::gpu::Backend;
use crate::io::image::PictureFormat;
use crate::io::{self, Diagnostic};
use crate::render::{
    Backdrop, Background, Frame, LargePicture, Marks, Offscreen, ShapeNumbers, check_picture_size,
};
use crate::scene::{
    Camera, FitArea, Look, ViewSettings, fit_turntable, turntable_cameras, turntable_milliseconds,
};
use std::io::IsTerminal;
use std::path::PathBuf;

/// Draw scenes, characters and shapes into a picture, without a window or a display.
///
/// The same input gives the same picture, byte for byte, on every run. Pictures that are larger than
/// the driver can draw are put together of several.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor render builtin:showcase --samples 4 -o showcase.png\n  \
    editor render Model1.obj --pose walk.json --display skeleton --fit -o walk.png\n  \
    editor render builtin:adult --fit --turntable 36 --size 400x400 -o adult.gif\n  \
    editor export rig.dae -o - | editor render - --fit -o - > rig.png")]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), builtin:NAME, or - for standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The picture to write; its extension is .png, .jpg or .gif. With --turntable an animated .gif,
    /// or numbered pictures such as OUT-%03d.png, from 1. - is standard output, as PNG or animated GIF.
    /// The folder must be there.
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    /// Width and height in pixels, of at most 268435456 together; JPEG and GIF have at most 65535 a
    /// side.
    #[arg(long, default_value = "800x600", value_parser = arguments::size)]
    size: (u32, u32),
    #[command(flatten)]
    camera: arguments::CameraArgs,
    /// Move the camera so that everything is in the picture, keeping its direction: where no other is given, that from +z,
    /// which sees the back of a figure that faces -z (--view -z), as the window does not.
    #[arg(long)]
    fit: bool,
    /// Pose every character by this POSE.json, builtin:NAME, or POSES.json#NAME of a file with several.
    #[arg(long, value_name = "POSE.json")]
    pose: Option<PathBuf>,
    #[command(flatten)]
    display: DisplayOptions,
    /// Influences per vertex: all of the file, or the four largest.
    #[arg(long, default_value = "all")]
    influences: arguments::Influences,
    /// How meshes follow their joints: linear blending, or dual quaternions, which keep the volume of
    /// what is twisted [default: lbs, or as the scene has it].
    #[arg(long, value_name = "lbs|dqs")]
    skinning_method: Option<arguments::SkinningMethodName>,
    /// Light and background [default: course, or as the scene has it].
    #[arg(long)]
    look: Option<LookName>,
    /// Color characters by a number of each vertex on a scale from violet to yellow: the weight of a
    /// joint (0 to 1), the number of joints that move it (1, or 0 if none does, to the most), or the
    /// share of its weights beyond the four largest (0 to the most); gray where it is nothing.
    #[arg(long, value_name = "weight:JOINT|influences|lost-at-four", conflicts_with = "ui", value_parser = colors::colors)]
    colors: Option<Colors>,
    /// Brightness of the Studio look's background, and of the panels.
    #[arg(long, default_value = "dark")]
    theme: ThemeName,
    /// Draw the axes [default: off, or as the scene has it].
    #[arg(long, value_name = "on|off", value_parser = arguments::switch)]
    axis: Option<bool>,
    /// Samples a pixel, for smooth edges; 0 for none. A driver takes the next number that it has, software 4 for 1 to
    /// 4; more than it has is an error, and `editor doctor` says how many that is.
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true, value_parser = arguments::samples)]
    samples: u32,
    /// Leave the background out, into a .png that is transparent there. Shadows on the Studio look's
    /// ground stay; the ground's light and lines, and the Mannequin look's floor, are left out.
    #[arg(long, conflicts_with = "ui")]
    transparent: bool,
    /// Draw N pictures on the way once round the point that the camera looks at; --fit fits all.
    #[arg(long, value_name = "N", conflicts_with = "ui", allow_hyphen_values = true, value_parser = turntable::frames)]
    turntable: Option<u32>,
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
enum ThemeName {
    Dark,
    Light,
}

impl From<ThemeName> for Backdrop {
    fn from(theme: ThemeName) -> Self {
        match theme {
            ThemeName::Dark => Self::Dark,
            ThemeName::Light => Self::Light,
        }
    }
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum GlName {
    /// EGL, and OSMesa where there is none.
    Auto,
    Egl,
    Osmesa,
}

impl Args {
    /// What may be standard input or output.
    pub(super) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: self.files.iter_mut().chain(&mut self.pose).collect(),
            output: Some((
                &mut self.output,
                Some(if self.turntable.is_some() {
                    "gif"
                } else {
                    "png"
                }),
            )),
        }
    }
}

/// Draws the picture and writes it.
///
/// # Errors
/// When a file cannot be read or written, a joint of the pose is missing, there is no OpenGL, or
/// the picture is too large for it.
pub fn run(args: &Args) -> Result<(), CliError> {
    let format = check_output(args)?;
    let turntable = args.turntable.map(|frames| {
        let output = turntable::Output::of(&args.output)?;
        Ok::<_, CliError>((frames, output))
    });
    let turntable = turntable.transpose()?;
    let session = session(args)?;
    let backend = match args.gl {
        GlName::Auto => Backend::Auto,
        GlName::Egl => Backend::Egl,
        GlName::Osmesa => Backend::Osmesa,
    };
    let skinning = args.skinning.map(Into::into);
    let encode = |picture: &Picture| {
        let encoded = io::image::encode(picture, format);
        encoded.map_err(|message| Diagnostic::new(&args.output, message).into())
    };
    let files = if args.ui {
        let asked = render_ui::Window {
            size: args.size,
            samples: args.samples,
            theme: match args.theme {
                ThemeName::Dark => egui::ThemePreference::Dark,
                ThemeName::Light => egui::ThemePreference::Light,
            },
        };
        let picture = render_ui::picture(&args.panels, session, backend, &asked, skinning)?;
        vec![(args.output.clone(), encode(&picture)?)]
    } else {
        let mut offscreen = Offscreen::new(backend)?;
        offscreen.renderer().set_skinning(skinning);
        let colors = args.colors.as_ref();
        let numbers = colors.map(|colors| colors.numbers(&session)).transpose()?;
        let mut painter = Painter {
            args,
            numbers: numbers.unwrap_or_default(),
            session: &session,
            offscreen,
            progress: Progress::new(),
        };
        match turntable {
            None => {
                let picture = painter.picture(session.view(), "")?;
                vec![(args.output.clone(), encode(&picture)?)]
            }
            Some((frames, output)) => painter.turn(frames, &output, encode)?,
        }
    };
    pipes::write(&files)
}

/// Most pixels a side of a JPEG or GIF.
const MOST_A_SIDE: u32 = 65_535;

/// The format of the picture, once it is clear that it can hold what is asked for.
///
/// # Errors
/// If it cannot, before any work is done.
fn check_output(args: &Args) -> Result<PictureFormat, CliError> {
    let format = picture_format(&args.output)?;
    let (width, height) = args.size;
    if args.ui {
        render_ui::check_size(args.size)?;
    }
    let wrong = |message: String| Diagnostic::new(&args.output, message);
    if args.transparent && format != PictureFormat::Png {
        let message = "expected a name that ends in .png with --transparent".to_owned();
        return Err(CliError::Usage(wrong(message).to_string()));
    }
    check_picture_size(args.size).map_err(wrong)?;
    if format != PictureFormat::Png && width.max(height) > MOST_A_SIDE {
        let message = format!(
            "expected at most {MOST_A_SIDE} pixels a side of a JPEG or GIF, found {width}x{height}: \
             a PNG may have more"
        );
        return Err(wrong(message).into());
    }
    Ok(format)
}

/// Draws the pictures of a command.
struct Painter<'a> {
    args: &'a Args,
    /// What characters are colored by, if not by their materials.
    numbers: Vec<ShapeNumbers>,
    session: &'a Session,
    offscreen: Offscreen,
    progress: Progress,
}

impl Painter<'_> {
    /// A picture seen as `view`; the progress begins with `which`.
    fn picture(&mut self, view: &ViewSettings, which: &str) -> Result<Picture, CliError> {
        let frame = Frame {
            scene: self.session.scene(),
            evaluated: self.session.evaluated(),
            view,
            backdrop: self.args.theme.into(),
            marks: Marks {
                numbers: self.numbers.clone(),
                ..Marks::default()
            },
        };
        let asked = LargePicture {
            size: self.args.size,
            samples: self.args.samples,
            background: if self.args.transparent {
                Background::Transparent
            } else {
                Background::Look
            },
            tile: None,
        };
        let progress = &self.progress;
        progress.show(which);
        let comma = if which.is_empty() { "" } else { ", " };
        let picture = self.offscreen.large_picture(&frame, &asked, |done, all| {
            let part = (done + 1).min(all);
            progress.show(format_args!("{which}{comma}part {part} of {all}"));
        })?;
        progress.show("");
        for notice in self.offscreen.renderer().take_notices() {
            eprint_line(format_args!("warning: {notice}"));
        }
        Ok(picture)
    }

    /// The files of a turntable.
    fn turn(
        &mut self,
        frames: u32,
        output: &turntable::Output,
        encode: impl Fn(&Picture) -> Result<Vec<u8>, CliError>,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, CliError> {
        let args = self.args;
        let cameras = turntable_cameras(self.session.view().camera, frames);
        let mut pictures = cameras.enumerate().map(|(index, camera)| {
            let view = ViewSettings {
                camera,
                ..*self.session.view()
            };
            self.picture(&view, &format!("picture {} of {frames}", index + 1))
        });
        match output {
            turntable::Output::Gif => {
                let failed = |message| Diagnostic::new(&args.output, message);
                let time = turntable_milliseconds(frames);
                let mut animation = io::Animation::new(time).map_err(failed)?;
                for picture in pictures {
                    animation.add(picture?).map_err(failed)?;
                }
                Ok(vec![(args.output.clone(), animation.finish())])
            }
            turntable::Output::Frames(names) => {
                let numbered = (1..).zip(&mut pictures);
                let files = numbered.map(|(n, picture)| Ok((names.path(n), encode(&picture?)?)));
                files.collect()
            }
        }
    }
}

fn session(args: &Args) -> Result<Session, CliError> {
    let mut session = load(&args.files, args.pose.as_deref())?;
    let mut edits = args.influences.edits(&session);
    if let Some(method) = args.skinning_method {
        edits.extend(method.edits(&session));
    }
    edits.extend(args.display.edits(&session));
    edit(&mut session, edits)?;

    if let Some(axis) = args.axis {
        session.look(View::SetAxis(axis));
    }
    if let Some(look) = args.look {
        session.look(View::SetLook(match look {
            LookName::Course => Look::Course,
            LookName::Studio => Look::Studio,
            LookName::Mannequin => Look::Mannequin,
        }));
    }
    if let Some(camera) = args.camera.chosen() {
        session.look(View::SetCamera(camera));
    }
    if args.fit {
        let (width, height) = args.size;
        let mut camera = session.view().camera;
        let bounds = session.evaluated().world_bounds();
        let aspect = width as f32 / height as f32;
        match args.turntable {
            Some(frames) => fit_turntable(&mut camera, frames, &bounds, aspect),
            None => camera.fit(&bounds, FitArea::whole(aspect)),
        }
        // A test of a picture, or another program, may have to look in the same way.
        if std::io::stderr().is_terminal() {
            eprint_line(format_args!(
                "note: --fit looks with --camera {}",
                in_words(&camera)
            ));
        }
        session.look(View::SetCamera(camera));
    }
    let view = session.view();
    if args.look.is_none() && view.looks_against_the_light() {
        eprint_line(
            "note: the Course look, which is the default, has one light, from +z, so that shapes are dark from this side: \
             --look studio lights all, and --look course says that this is meant",
        );
    }
    Ok(session)
}

/// A camera as `--camera` reads it.
fn in_words(camera: &Camera) -> String {
    let [x, y, z] = camera.target.to_array();
    let angles = [camera.theta, camera.phi].map(f32::to_degrees);
    let numbers = [angles[0], angles[1], camera.radius, x, y, z];
    let numbers = numbers.map(|number| ((number * 1e4).round() / 1e4).to_string());
    numbers.join(",")
}
