use super::arguments;
use crate::editor::{Edit, Session};
use crate::scene::{
    BoneStyle, CharacterDisplay, CurveDisplay, CurveVisibility, JointStyle, ModelDisplay,
    ShapeKind, SurfaceVisibility,
};

/// How characters and curves are drawn; what is not given stays as the scene has it.
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
    #[arg(long, value_name = "on|off", value_parser = arguments::switch)]
    control_points: Option<bool>,
    #[command(flatten)]
    curves: arguments::CurveOptions,
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
    /// The edits by which every shape of `session` is drawn in this way.
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
