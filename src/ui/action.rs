use super::CompareAction;
use crate::editor::{Edit, View};
use crate::scene::ShapeId;

/// What a panel, a menu, a key or a gesture wants done.
#[derive(Clone, Debug)]
pub enum Action {
    /// Changes the scene.
    Edit(Edit),
    /// Begins or ends a gesture, whose edits come between.
    Gesture(GestureStep),
    /// Changes how the scene is looked at.
    View(View),
    /// Needs a dialog, a file or the program itself.
    Ask(Ask),
}

/// The beginning or the end of a gesture: a drag whose edits are kept or cancelled together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GestureStep {
    /// The edits that follow belong to it.
    Begin,
    /// Ends it and keeps what it changed.
    Commit,
    /// Ends it and puts everything back to how it was.
    Cancel,
}

/// Something that only the program around the editor can do.
#[derive(Clone, Debug, PartialEq)]
pub enum Ask {
    /// Import ▸ Import Shape: choose a file.
    ImportShape,
    /// Import ▸ Import Character: choose a file.
    ImportCharacter,
    /// Import ▸ Import Curve: choose a file.
    ImportCurve,
    /// A built-in character or curve by its name.
    InsertBuiltin(&'static str),
    /// A built-in scene by its name, in the place of the one that is open.
    OpenBuiltin(&'static str),
    /// Write the curves of a shape as `.swp`: choose a file.
    ExportCurve(ShapeId),
    /// Write the geometry of the scene as `.obj`: choose a file.
    ExportGeometry,
    /// Save a picture of the view: choose a file.
    Screenshot(Screenshot),
    /// Put the pose of a character on the clipboard.
    CopyPose(ShapeId),
    /// Give a character the pose on the clipboard.
    PastePose(ShapeId),
    /// Write the pose of a character, or the kept one with this index, as `POSE.json`: choose a
    /// file.
    SavePose(ShapeId, Option<usize>),
    /// Give a character the pose of a `POSE.json`: choose a file.
    LoadPose(ShapeId),
    /// Compare the view with a picture.
    Compare(CompareAction),
    /// End the program.
    Quit,
}

/// What a picture of the view should show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screenshot {
    /// Whether the panels are in it.
    pub with_panels: bool,
    /// Its size in pixels; the window's own if `None`. Pictures with panels have the window's.
    pub size: Option<(u32, u32)>,
}
