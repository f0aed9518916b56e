//! Arguments that commands share: files to load, options that change what is in them, and values of
//! options.

use super::CliError;
use super::output::eprint_line;
use crate::disk::files;
use crate::editor::{Edit, Session};
use crate::io::{Loaded, PoseFile};
use crate::scene::{
    BoneStyle, Camera, CharacterDisplay, CurveDisplay, CurveVisibility, JointStyle, ModelDisplay,
    ShapeId, ShapeKind, Skinning, SkinningMethod, SurfaceVisibility, ViewDirection, ViewSettings,
};
use std::path::{Path, PathBuf};

/// Loads the scenes and shapes of `paths` into one session, with the view of the last scene file,
/// and poses its characters by the file `pose` if there is one. Prints warnings on standard error.
///
/// # Errors
/// At the first file that cannot be loaded.
pub fn load(paths: &[PathBuf], pose: Option<&Path>) -> Result<Session, CliError> {
    let files = files();
    let mut loaded = Loaded::default();
    for path in paths {
        loaded.add(&files, path)?;
    }
    for warning in &loaded.warnings {
        eprint_line(format_args!("warning: {warning}"));
    }
    // The window has axes for orientation; a picture of files has nothing but what is in them.
    let view = loaded.view.unwrap_or(ViewSettings {
        axis: false,
        ..ViewSettings::default()
    });
    let mut session = Session::with_shapes(loaded.shapes, view);
    if let Some(path) = pose {
        let pose = PoseFile::open(&files, path)?;
        let poses = pose.poses_for(session.scene())?.into_iter();
        let edits = poses.map(|(id, pose)| Edit::SetPose(id, pose)).collect();
        edit(&mut session, edits)?;
    }
    Ok(session)
}

/// Carries out the edits of a command's options.
///
/// # Errors
/// If one of them is refused; then nothing has changed.
pub fn edit(session: &mut Session, edits: Vec<Edit>) -> Result<(), CliError> {
    let edited = session.edit(Edit::Together(edits));
    edited.map_err(|refused| CliError::Other(refused.to_string()))?;
    Ok(())
}

/// Identifiers of all shapes.
fn ids(session: &Session) -> impl Iterator<Item = ShapeId> {
    session.scene().shapes().iter().map(|shape| shape.id)
}

/// Display options of characters and curves; what is not given stays as in the scene.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct DisplayOptions {
    /// What is drawn of characters [default: mesh, or as the scene has it].
    #[arg(long)]
    display: Option<Display>,
    /// How joints are drawn [default: spheres, or as the scene has it].
    #[arg(long)]
    joints: Option<Joints>,
    /// How bones are drawn [default: boxes, or as the scene has it].
    #[arg(long)]
    bones: Option<Bones>,
    /// How curves are drawn [default: on, or as the scene has it].
    #[arg(long)]
    curve: Option<CurveName>,
    /// How surfaces of curves are drawn [default: shaded, or as the scene has it].
    #[arg(long)]
    surface: Option<SurfaceName>,
    /// Whether control points are drawn [default: on, or as the scene has it].
    #[arg(long, value_name = "on|off", value_parser = switch)]
    control_points: Option<bool>,
    #[command(flatten)]
    curves: CurveOptions,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Display {
    Mesh,
    Skeleton,
    Both,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Joints {
    Points,
    Spheres,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Bones {
    Lines,
    Boxes,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum CurveName {
    Off,
    On,
    /// With normals, tangents and binormals.
    Frames,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum SurfaceName {
    Off,
    /// All edges, with normals.
    Wireframe,
    Shaded,
}

impl DisplayOptions {
    /// Edits that set the display options of all shapes of `session`.
    pub fn edits(&self, session: &Session) -> Vec<Edit> {
        let shapes = session.scene().shapes().iter();
        let displays = shapes.filter_map(|shape| match &shape.kind {
            ShapeKind::Character(character) => {
                let mut display = character.display;
                set_character_display(self, &mut display);
                Some(Edit::SetDisplay(shape.id, display))
            }
            ShapeKind::Curve(curve) => {
                let mut display = curve.display;
                set_curve_display(self, &mut display);
                Some(Edit::SetCurveDisplay(shape.id, display))
            }
            _ => None,
        });
        displays.chain(self.curves.edits(session)).collect()
    }
}

fn set_character_display(options: &DisplayOptions, display: &mut CharacterDisplay) {
    if let Some(mode) = options.display {
        display.mode = match mode {
            Display::Mesh => ModelDisplay::Mesh,
            Display::Skeleton => ModelDisplay::Skeleton,
            Display::Both => ModelDisplay::Both,
        };
    }
    if let Some(joints) = options.joints {
        display.joints = match joints {
            Joints::Points => JointStyle::Points,
            Joints::Spheres => JointStyle::Spheres,
        };
    }
    if let Some(bones) = options.bones {
        display.bones = match bones {
            Bones::Lines => BoneStyle::Lines,
            Bones::Boxes => BoneStyle::Boxes,
        };
    }
}

fn set_curve_display(options: &DisplayOptions, display: &mut CurveDisplay) {
    if let Some(curve) = options.curve {
        display.curve = match curve {
            CurveName::Off => CurveVisibility::Off,
            CurveName::On => CurveVisibility::On,
            CurveName::Frames => CurveVisibility::OnWithFrames,
        };
    }
    if let Some(surface) = options.surface {
        display.surface = match surface {
            SurfaceName::Off => SurfaceVisibility::Off,
            SurfaceName::Wireframe => SurfaceVisibility::WireframeWithNormals,
            SurfaceName::Shaded => SurfaceVisibility::Shaded,
        };
    }
    if let Some(control_points) = options.control_points {
        display.control_points = control_points;
    }
}

/// Number of influences per vertex that are used.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Influences {
    /// Every one of the file.
    All,
    /// The four largest of a vertex, divided by their sum: what some programs show.
    #[value(name = "4")]
    Four,
}

impl Influences {
    /// Edits that limit the influences of the characters of `session`.
    pub fn edits(self, session: &Session) -> Vec<Edit> {
        match self {
            Self::All => Vec::new(),
            Self::Four => ids(session)
                .map(|id| Edit::LimitInfluences(id, 4))
                .collect(),
        }
    }
}

/// Way in which the meshes of characters follow their joints.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum SkinningMethodName {
    /// Linear blend skinning, the assignment's.
    Lbs,
    /// Dual quaternion skinning.
    Dqs,
}

impl SkinningMethodName {
    /// Edits that set the method of all characters of `session`.
    pub fn edits(self, session: &Session) -> Vec<Edit> {
        let method = match self {
            Self::Lbs => SkinningMethod::LinearBlend,
            Self::Dqs => SkinningMethod::DualQuaternion,
        };
        ids(session)
            .map(|id| Edit::SetSkinningMethod(id, method))
            .collect()
    }
}

/// Options of surfaces made from curves.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct CurveOptions {
    /// Leave the step of a closed sweep whose frames do not meet
    #[arg(long)]
    no_frame_closing: bool,
}

impl CurveOptions {
    /// Edits that apply them to all curves of `session`.
    pub fn edits(self, session: &Session) -> Vec<Edit> {
        if !self.no_frame_closing {
            return Vec::new();
        }
        ids(session)
            .map(|id| Edit::SetFrameClosing(id, false))
            .collect()
    }
}

/// Processor that deforms the meshes that are drawn.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum SkinningName {
    /// The processor.
    Cpu,
    /// The graphics card.
    Gpu,
}

impl From<SkinningName> for Skinning {
    fn from(name: SkinningName) -> Self {
        match name {
            SkinningName::Cpu => Self::Cpu,
            SkinningName::Gpu => Self::Gpu,
        }
    }
}

/// Size of a picture in pixels, such as `800x600`.
pub(super) fn size(text: &str) -> Result<(u32, u32), String> {
    let expected = || format!("expected WIDTHxHEIGHT such as 800x600, found {text}");
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(expected)?;
    let side = |text: &str| text.parse().ok().filter(|&side: &u32| side > 0);
    side(width).zip(side(height)).ok_or_else(expected)
}

/// A number such as `0.001`.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let number = text.parse();
    number.map_err(|_| format!("expected a number, found {text}"))
}

/// Upper bound of the samples per pixel: more than any driver has.
const MOST_SAMPLES: u32 = 64;

/// Number of samples per pixel, such as `4`.
pub(super) fn samples(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|n| *n <= MOST_SAMPLES);
    number.ok_or_else(|| {
        format!("expected a whole number of samples from 0 to {MOST_SAMPLES}, found {text}")
    })
}

/// Switch: `on` or `off`.
pub(super) fn switch(text: &str) -> Result<bool, String> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err(format!("expected on or off, found {text}")),
    }
}

/// View direction, such as `+x`.
fn view(text: &str) -> Result<ViewDirection, String> {
    ViewDirection::ALL
        .into_iter()
        .find(|direction| direction.label().eq_ignore_ascii_case(text))
        .ok_or_else(|| format!("expected +x, -x, +y, -y, +z or -z, found {text}"))
}

/// Camera: `THETA,PHI,RADIUS`, optionally with `,TX,TY,TZ`; angles in degrees.
fn camera(text: &str) -> Result<Camera, String> {
    let numbers = text.split(',').map(|number| {
        let read = number.trim().parse();
        read.map_err(|_| format!("expected numbers between commas, found {text}"))
    });
    let numbers: Vec<f32> = numbers.collect::<Result<_, _>>()?;
    Camera::from_numbers(&numbers)
}

/// Options of the camera that a picture is seen with.
#[derive(Debug, clap::Args)]
pub struct CameraArgs {
    /// Camera: angles in degrees, distance, and the point it looks at.
    #[arg(
        long,
        value_name = "THETA,PHI,RADIUS[,TX,TY,TZ]",
        allow_hyphen_values = true,
        value_parser = camera
    )]
    camera: Option<Camera>,
    /// One of the six views: +x, -x, +y, -y, +z or -z.
    #[arg(long, allow_hyphen_values = true, value_parser = view, conflicts_with = "camera")]
    view: Option<ViewDirection>,
}

impl CameraArgs {
    /// The camera that is asked for, if one is.
    pub fn chosen(&self) -> Option<Camera> {
        self.camera.or(self.view.map(Camera::preset))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_cameras_are_read_and_nonsense_is_refused() {
        assert_eq!(size("640x480"), Ok((640, 480)));
        assert!(size("640").is_err() && size("0x5").is_err() && size("-1x5").is_err());
        let read = camera("-30,10,5,0,1,0").expect("six numbers");
        assert_eq!((read.radius, read.target), (5.0, glam::Vec3::Y));
        assert!((read.theta.to_degrees() + 30.0).abs() < 1e-4);
        for bad in ["", "1,2", "1,2,x", "1,2,NaN", "1,2,0", "1,2,3,4"] {
            assert!(camera(bad).is_err(), "{bad}");
        }
        assert_eq!((samples("0"), samples("64")), (Ok(0), Ok(64)));
        for bad in ["-1", "65", "1.5", "many", ""] {
            assert!(samples(bad).is_err(), "{bad}");
        }
        assert_eq!(view("-x"), Ok(ViewDirection::MinusX));
        assert!(view("x").is_err());
    }
}
