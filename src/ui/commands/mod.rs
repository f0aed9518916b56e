//! Commands: everything that a menu item or a key can start.

mod enabled;
mod gestures;
mod hiding;
mod keys;
mod pose_commands;
mod pressed;
mod put_back;
mod run;
mod sweep;
mod table;

pub use gestures::{GESTURES, Gesture};
pub use keys::is_kept_by_browsers;
pub use table::{COMMANDS, Entry, Menu, scene_label};

pub(super) use enabled::why_disabled;
pub(super) use gestures::gesture;
pub(super) use keys::{is_page, key_now, remember_for_keys, tooltip, tooltip_now, with_key};
pub(super) use pressed::{pressed, pressed_with_ctrl};
pub(super) use run::{
    curves, full_label, full_tooltip, homes, is_on, run, second_home, selected_character,
};
pub(super) use sweep::REVOLUTION_STEPS;
pub(super) use table::{entries, entry_of, in_words, label, meant};

use crate::editor::Tool;
use crate::geometry::Basis;
use crate::scene::{CurveSet, CurveShape, Look, Shading, ShapeKind, Skinning, ViewDirection};
use crate::ui::{MeshColors, Navigation};
use egui::ThemePreference;

/// Everything that a menu item or a key can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Begins an empty document.
    New,
    /// Opens a document.
    Open,
    /// Saves the document.
    Save,
    /// Saves the document to another file.
    SaveAs,
    /// Saves the document with all files that it needs.
    SaveWithFiles,
    /// Puts a link to the document on the clipboard.
    CopyLink,
    /// Opens the document's file as it is now.
    Revert,
    /// Reads the files of all shapes again.
    Reload,
    /// Opens the screenshot dialog.
    Screenshot,
    /// Exports the curves of the selected shape.
    ExportCurve,
    /// Exports the geometry of the scene.
    ExportGeometry,
    /// Exports the geometry of the selected shapes.
    ExportSelected,
    /// Exports the geometry of the scene with its materials.
    ExportMaterials,
    /// Exports the selected character.
    ExportCharacter,
    /// Closes the last dialog that was opened, else ends the program.
    Quit,
    /// Undoes the last step.
    Undo,
    /// Does the step again that was undone last.
    Redo,
    /// Opens Edit ▸ History.
    History,
    /// Opens Edit ▸ Preferences.
    Preferences,
    /// Copies the selected shapes to the clipboard, and deletes them.
    Cut,
    /// Copies the selected shapes to the clipboard, or the pose of the selected character with a tool
    /// that poses.
    Copy,
    /// Adds the shapes on the clipboard, or applies the pose on it.
    Paste,
    /// Adds copies of the selected shapes beside them.
    Duplicate,
    /// Selects all shapes.
    SelectAll,
    /// Selects nothing.
    SelectNone,
    /// Selects the shapes that are shown and not selected, instead of those that are.
    InvertSelection,
    /// Lets the next drag in the view draw a box, which selects the shapes in it.
    BoxSelect,
    /// Inserts a shape.
    Insert(Primitive),
    /// Opens the menu Insert at the pointer.
    InsertMenu,
    /// Imports a shape.
    ImportShape,
    /// Imports curves.
    ImportCurve,
    /// Imports a character.
    ImportCharacter,
    /// Makes a surface of revolution from a curve of the selected shape, about +Y.
    MakeSurfaceOfRevolution,
    /// Makes a surface by sweeping one curve of the selected shape along another.
    MakeSweep,
    /// Deletes the selected shape.
    Delete,
    /// Resets the selected shape to how it was inserted.
    Reset,
    /// Puts the selected shapes back to where they were inserted.
    ResetPosition,
    /// Turns the selected shapes back to how they were inserted.
    ResetRotation,
    /// Makes the selected shapes as large again as they were inserted.
    ResetScale,
    /// Begins to rename the selected shape.
    Rename,
    /// Hides the selected shape in the view, or shows it.
    ToggleVisible,
    /// Shows every shape that is hidden.
    ShowAll,
    /// Hides the shapes that are not selected.
    HideOthers,
    /// Locks the selected shape in the view, or unlocks it.
    ToggleLocked,
    /// One of the six views.
    ViewFrom(ViewDirection),
    /// Resets the camera to where it started.
    ResetCamera,
    /// Fits the selected shape, or everything, to the view.
    Fit,
    /// Fits everything to the view, whatever is selected.
    FitAll,
    /// Shows or hides the axes.
    ToggleAxis,
    /// Shows or hides the grid on the ground.
    ToggleGrid,
    /// Shows or hides the bones of the Mannequin look.
    ToggleBones,
    /// Folds the shape panel away, or unfolds it.
    TogglePanel,
    /// Chooses the look: light and background.
    SetLook(Look),
    /// Chooses the normals that surfaces are lit with.
    SetShading(Shading),
    /// Chooses what characters are colored by.
    SetColors(MeshColors),
    /// Shows characters in their bind pose, too, or no more.
    ToggleBindGhost,
    /// Chooses the colors of the panels.
    SetTheme(ThemePreference),
    /// Chooses how mouse and keys move the camera.
    SetNavigation(Navigation),
    /// Opens a built-in scene by its name.
    OpenScene(&'static str),
    /// Resets the camera and all poses.
    ResetViewAndPose,
    /// Chooses a picture to compare the view with.
    Compare,
    /// Opens the panel that explains skinning, or closes it.
    Explain,
    /// Chooses a mesh to compare the selected character with, or the only one.
    CompareMesh,
    /// Chooses what deforms characters; automatic if `None`.
    SetSkinning(Option<Skinning>),
    /// Chooses a tool.
    SetTool(Tool),
    /// Does what a tool does to the selection, with the pointer from now on until a click.
    Begin(Tool),
    /// Switches gizmos between local and world axes.
    ToggleLocalAxes,
    /// Resets the selected joint.
    ResetJoint,
    /// Turns the selected joints back to rest.
    ResetAngles,
    /// Puts the selected roots back to where they are at rest.
    ResetOffset,
    /// Resets every joint of the selected character.
    ResetPose,
    /// Exchanges left and right in the pose of the selected character.
    MirrorPose,
    /// Gives the joints on the other side the pose of those that are selected, mirrored.
    MirrorJoints,
    /// Copies the pose of the selected character to the clipboard.
    CopyPose,
    /// Applies the pose on the clipboard to the selected character.
    PastePose,
    /// Applies the pose on the clipboard to the selected character, with left and right exchanged.
    PastePoseMirrored,
    /// Adds the pose to the list of the selected character.
    KeepPose,
    /// Saves the pose of the selected character.
    SavePose,
    /// Loads a pose for the selected character.
    LoadPose,
    /// Pins a joint for the IK tool, or unpins it.
    PinJoint,
    /// Unpins all joints.
    UnpinAll,
    /// Opens the search for a command.
    FindCommand,
    /// Opens Help ▸ Keys and Mouse.
    Keys,
    /// Opens Help ▸ Messages.
    Messages,
    /// Opens Help ▸ About.
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
    /// A new shape of this kind.
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
