use super::{CompareAction, CompareMeshAction};
use crate::editor::{Edit, View};
use crate::scene::ShapeId;
use std::path::PathBuf;

/// A request of a panel, a menu, a key or a gesture.
#[derive(Clone, Debug)]
pub enum Action {
    /// Changes the scene.
    Edit(Edit),
    /// Begins or ends a gesture; its edits come in between.
    Gesture(GestureStep),
    /// Goes back or forward in the history of the document.
    History(HistoryMove),
    /// Changes the camera, the look or the selection.
    View(View),
    /// Needs a dialog, a file or the program.
    Ask(Ask),
}

/// The beginning or the end of a gesture: a drag whose edits are kept or cancelled together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GestureStep {
    /// The edits that follow belong to it.
    Begin,
    /// The edits that follow belong to it, and it to the last step.
    BeginOnLastStep,
    /// Ends it and keeps its changes.
    Commit,
    /// Ends it and undoes its changes.
    Cancel,
}

/// A move in the history of the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HistoryMove {
    /// Undoes the last step, or cancels the gesture under way.
    Undo,
    /// Does the step again that was undone last.
    Redo,
    /// Goes to the document after this number of steps since it was opened.
    GoTo(usize),
}

/// A request that only the program around the panels can carry out.
#[derive(Clone, Debug, PartialEq)]
pub enum Ask {
    /// Begin an empty document.
    New,
    /// Choose a document, and open it.
    Open,
    /// Open a document of the list of recent ones.
    OpenRecent(PathBuf),
    /// Save the document.
    Save,
    /// Choose a file, and save the document to it.
    SaveAs,
    /// Choose a file, and write the document with all files that it needs.
    SaveWithFiles,
    /// Put a link to the document on the clipboard.
    CopyLink,
    /// Open the document's file as it is now.
    Revert,
    /// Read the files of all shapes again.
    Reload,
    /// Choose the file that a shape came from, where it is now.
    FindSource(ShapeId),
    /// Answer the question that is shown.
    Answer(Answer),
    /// Choose a shape to import.
    ImportShape,
    /// Choose a character to import.
    ImportCharacter,
    /// Choose a curve to import.
    ImportCurve,
    /// Insert a built-in character or curve by its name.
    InsertBuiltin(&'static str),
    /// Replace the scene by a built-in one, by its name.
    OpenBuiltin(&'static str),
    /// Choose a file, and write the curves of a shape to it as `.swp`.
    ExportCurve(ShapeId),
    /// Choose a file, and write the geometry of the scene to it as `.obj`.
    ExportGeometry,
    /// Choose a file, and write the geometry of the selected shapes to it as `.obj`.
    ExportSelected,
    /// Choose a file, and write the geometry of the scene to it with its materials beside it.
    ExportMaterials,
    /// Choose a file, and write a character to it as `.skel`, with the others beside it.
    ExportCharacter(ShapeId),
    /// Choose a file, and save a picture of the view to it.
    Screenshot(Screenshot),
    /// Give up the work whose progress is shown: pictures, files that are fetched or read.
    CancelWork,
    /// Copy the selected shapes to the clipboard, and delete them.
    CutShapes,
    /// Copy the selected shapes to the clipboard.
    CopyShapes,
    /// Add the shapes on the clipboard, or apply the pose on it to the selected character.
    Paste,
    /// Copy the pose of a character to the clipboard.
    CopyPose {
        /// Identifier of the character.
        shape: ShapeId,
        /// Indices of the joints that alone are meant; all are if there are none.
        joints: Vec<usize>,
    },
    /// Apply the pose on the clipboard to a character.
    PastePose(ShapeId),
    /// Apply the pose on the clipboard to a character, with left and right exchanged.
    PastePoseMirrored(ShapeId),
    /// Apply what the pose on the clipboard has for these joints of a character, or for those that alone were meant when it
    /// was copied. All others stay.
    PastePoseOnto {
        /// Identifier of the character.
        shape: ShapeId,
        /// Indices of the joints.
        joints: Vec<usize>,
        /// Whether left and right are exchanged.
        mirrored: bool,
    },
    /// Choose a file, and write the pose of a character to it as `POSE.json`; with an index, that
    /// pose of its list.
    SavePose(ShapeId, Option<usize>),
    /// Choose a `POSE.json`, and apply its pose to a character.
    LoadPose(ShapeId),
    /// Apply one of the program's own poses to a character.
    UseBuiltinPose(ShapeId, &'static str),
    /// Begin, change or end a comparison with a picture.
    Compare(CompareAction),
    /// Begin, change or end a comparison of a character with a mesh.
    CompareMesh(CompareMeshAction),
    /// End the program.
    Quit,
}

/// Question that is answered before anything else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// Title of the dialog.
    pub title: String,
    /// Text of the question, in plain words.
    pub text: String,
    /// Answers to choose from; Enter gives the first, and Esc cancels if that is an answer.
    pub answers: Vec<Answer>,
}

/// Answer to a [`Question`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Save the document first.
    Save,
    /// Save the document to another file.
    SaveAs,
    /// Go on without saving.
    Discard,
    /// Go back to what is in the file.
    Revert,
    /// Replace the file.
    Overwrite,
    /// Restore what was not saved.
    Restore,
    /// Let go of what was not saved.
    Forget,
    /// Ask again at the next start.
    Later,
    /// Do nothing.
    Cancel,
}

impl Answer {
    /// Label of the button.
    pub fn label(self) -> &'static str {
        match self {
            Self::Save => "Save",
            Self::SaveAs => "Save As…",
            Self::Discard => "Don't Save",
            Self::Revert => "Go Back",
            Self::Overwrite => "Overwrite",
            Self::Restore => "Restore",
            Self::Forget => "Discard",
            Self::Later => "Later",
            Self::Cancel => "Cancel",
        }
    }
}

/// Contents and size of a picture of the view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Screenshot {
    /// Whether it shows the panels, too.
    pub with_panels: bool,
    /// Width and height in pixels; those of the window if `None`, as for every picture with panels.
    pub size: Option<(u32, u32)>,
    /// Whether the background is left out.
    pub transparent: bool,
    /// Pictures from all around in place of a single one.
    pub turntable: Option<Turntable>,
}

/// Pictures on the way once round the point that the camera looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turntable {
    /// Number of pictures, one of [`crate::scene::TURNTABLE_FRAMES`].
    pub frames: u32,
    /// Whether the camera is moved so that everything is in all of them.
    pub fit: bool,
}
