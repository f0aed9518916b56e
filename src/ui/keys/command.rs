use crate::editor::Tool;
use crate::geometry::Basis;
use crate::scene::{CurveSet, CurveShape, Look, Shading, ShapeKind, Skinning, ViewDirection};
use crate::ui::Navigation;
use egui::ThemePreference;

/// Everything that a menu item or a key can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Opens the dialog for a picture of the view.
    Screenshot,
    /// Writes the selected curves into a file.
    ExportCurve,
    /// Writes the geometry of the scene into a file.
    ExportGeometry,
    /// Closes what is open, else ends the program.
    Quit,
    /// Adds a shape.
    Insert(Primitive),
    /// Adds a shape from a file.
    ImportShape,
    /// Adds curves from a file.
    ImportCurve,
    /// Adds a character from its files.
    ImportCharacter,
    /// Turns a curve of the selected shape about +Y.
    MakeSurfaceOfRevolution,
    /// Carries one curve of the selected shape along another.
    MakeSweep,
    /// Takes the selected shape away.
    Delete,
    /// Puts the selected shape back to how it started.
    Reset,
    /// Hides the selected shape in the view, or shows it.
    ToggleVisible,
    /// Locks the selected shape in the view, or unlocks it.
    ToggleLocked,
    /// One of the six views.
    ViewFrom(ViewDirection),
    /// The course's first view.
    ResetCamera,
    /// Fills the view with the selected shape.
    Fit,
    /// Shows or hides the axes.
    ToggleAxis,
    /// Shows or hides the grid on the ground.
    ToggleGrid,
    /// Chooses light and background.
    SetLook(Look),
    /// Chooses the normals to light surfaces with.
    SetShading(Shading),
    /// Chooses the colors of the panels.
    SetTheme(ThemePreference),
    /// Chooses how mouse and keys move the camera.
    SetNavigation(Navigation),
    /// Puts a scene from inside the program in the place of the one that is open.
    OpenScene(&'static str),
    /// Puts the camera and all poses back to where they started.
    ResetViewAndPose,
    /// Chooses a picture to compare the view with.
    Compare,
    /// Chooses what deforms characters; whatever suits the driver if `None`.
    SetSkinning(Option<Skinning>),
    /// Chooses what a left drag in the view does.
    SetTool(Tool),
    /// Shows gizmos along the axes of the joint or shape, or of the world.
    ToggleLocalAxes,
    /// Puts the selected joint back to rest.
    ResetJoint,
    /// Puts every joint of the selected character back to rest.
    ResetPose,
    /// Exchanges left and right in the pose of the selected character.
    MirrorPose,
    /// Puts the pose of the selected character on the clipboard.
    CopyPose,
    /// Gives the selected character the pose on the clipboard.
    PastePose,
    /// Keeps the pose with the selected character.
    KeepPose,
    /// Writes the pose of the selected character to a file.
    SavePose,
    /// Gives the selected character the pose of a file.
    LoadPose,
    /// Pins a joint for the IK tool, or lets go of it.
    PinJoint,
    /// Lets go of all pinned joints.
    UnpinAll,
    /// Opens the list of keys and gestures.
    Keys,
    /// Opens the history of messages.
    Messages,
    /// Opens the window about the program.
    About,
}

/// The shapes and curves of the Insert menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primitive {
    /// See [`ShapeKind::Cube`].
    Cube,
    /// See [`ShapeKind::Sphere`].
    Sphere,
    /// See [`ShapeKind::Pyramid`].
    Pyramid,
    /// See [`ShapeKind::Teapot`].
    Teapot,
    /// See [`ShapeKind::Icosahedron`].
    Icosahedron,
    /// See [`ShapeKind::Custom`].
    Custom,
    /// See [`CurveSet::start_spline`].
    BezierCurve,
    /// See [`CurveSet::start_spline`].
    BSplineCurve,
    /// See [`CurveSet::start_circle`].
    Circle,
}

impl Primitive {
    /// The shape itself.
    pub fn kind(self) -> ShapeKind {
        match self {
            Self::Cube => ShapeKind::Cube,
            Self::Sphere => ShapeKind::Sphere,
            Self::Pyramid => ShapeKind::Pyramid,
            Self::Teapot => ShapeKind::Teapot,
            Self::Icosahedron => ShapeKind::Icosahedron,
            Self::Custom => ShapeKind::Custom,
            Self::BezierCurve => curve(CurveSet::start_spline(Basis::Bezier)),
            Self::BSplineCurve => curve(CurveSet::start_spline(Basis::BSpline)),
            Self::Circle => curve(CurveSet::start_circle()),
        }
    }
}

fn curve(set: CurveSet) -> ShapeKind {
    ShapeKind::Curve(CurveShape::new(set))
}
