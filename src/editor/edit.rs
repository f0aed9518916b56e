use super::BoxMode;
use crate::character::Pose;
use crate::geometry::Curve;
use crate::math::{Euler, Transform};
use crate::scene::{
    Camera, CharacterDisplay, CurveDisplay, FitArea, IkSettings, Look, NewShape, Shading,
    ShapeColor, ShapeId, ShapeKind, SkinningMethod, Source, ViewDirection,
};
use glam::Vec3;
use std::borrow::Cow;

/// Change of the document.
#[derive(Clone, Debug)]
pub enum Edit {
    /// Several edits as one: all of them, in order, or none.
    Together(Vec<Edit>),
    /// Replaces the document by one of these shapes.
    Open(Vec<NewShape>),
    /// Appends shapes to the list.
    Insert(Vec<NewShape>),
    /// The same with shapes from the clipboard, which the step's name tells.
    Paste(Vec<NewShape>),
    /// Deletes a shape.
    Delete(ShapeId),
    /// Restores the placement and color that the shape started with, and the bind pose of a
    /// character.
    Reset(ShapeId),
    /// Sets position, rotation and scale of a shape.
    SetTransform(ShapeId, Transform),
    /// Turns uniform scaling on or off. Turning it on sets all three scales to that of x.
    SetUniformScaling(ShapeId, bool),
    /// Sets the color of a shape.
    SetColor(ShapeId, ShapeColor),
    /// Shows a shape in the view, or hides it there.
    SetVisible(ShapeId, bool),
    /// Locks a shape, so that it cannot be picked, posed and moved in the view, or unlocks it.
    SetLocked(ShapeId, bool),
    /// Sets the display options of a character.
    SetDisplay(ShapeId, CharacterDisplay),
    /// Sets the way in which the mesh of a character follows its joints.
    SetSkinningMethod(ShapeId, SkinningMethod),
    /// Limits the number of influences per vertex of a character (see
    /// [`crate::character::Character::limited`]).
    LimitInfluences(ShapeId, usize),
    /// Replaces one angle of a joint; the other two stay exactly as they are.
    SetJointAngle {
        /// The character.
        shape: ShapeId,
        /// Index of the joint.
        joint: usize,
        /// Axis of the angle: 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// The new angle, in radians.
        radians: f32,
    },
    /// Replaces the angles of one joint.
    SetJointTransform {
        /// The character.
        shape: ShapeId,
        /// Index of the joint.
        joint: usize,
        /// New rotation.
        rotation: Euler,
    },
    /// Sets the translation of a root joint from its position at rest.
    SetRootOffset {
        /// The character.
        shape: ShapeId,
        /// Index of the root joint.
        root: usize,
        /// Translation, in the character's space.
        offset: Vec3,
    },
    /// Resets the joint at this index to rest.
    ResetJoint(ShapeId, usize),
    /// Replaces the whole pose.
    SetPose(ShapeId, Pose),
    /// Resets every joint to rest, and forgets what was saved of the pose of joints that the character
    /// does not have.
    ResetPose(ShapeId),
    /// Keeps the current pose with the character, replacing the one of that name if there is one.
    KeepPose {
        /// The character.
        shape: ShapeId,
        /// Name in the list.
        name: String,
    },
    /// Removes a kept pose, by its index, from the character's list.
    ForgetPose(ShapeId, usize),
    /// Moves a control point. A closed curve stays closed, a flat one flat.
    SetControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point.
        point: usize,
        /// New position, in the shape's model space.
        position: Vec3,
    },
    /// Sets the settings of inverse kinematics of a character, with its pins.
    SetIk(ShapeId, IkSettings),
    /// Unpins all joints of a character, those that it does not have included.
    UnpinAll(ShapeId),
    /// Replaces geometry and file of a shape; its place, color and name stay.
    Replace(ShapeId, ShapeKind, Source),
    /// Renames a shape.
    Rename(ShapeId, String),
    /// Moves a shape in the list to this index.
    MoveInList(ShapeId, usize),
    /// Adds a control point, or a whole piece of a Bézier curve (see [`Curve::with_point_after`]).
    AddControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point before the new one.
        after: usize,
    },
    /// Removes a control point, of a Bézier curve with its handles (see [`Curve::without_point`]).
    RemoveControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point.
        point: usize,
    },
    /// Appends a curve to a shape made of curves.
    AddCurve(ShapeId, Curve),
    /// Removes a curve or surface from a shape made of curves, and all surfaces made from it.
    RemoveCurveItem {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve or surface in its [`crate::scene::CurveSet`].
        item: usize,
    },
    /// Sets the number of steps of a curve (per piece) or of a surface of revolution (of the turn).
    SetSteps {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve or surface in its [`crate::scene::CurveSet`].
        item: usize,
        /// Number of steps.
        steps: u32,
    },
    /// Sets the radius of a circle.
    SetRadius {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the circle in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Radius, in the shape's model space.
        radius: f32,
    },
    /// Turns frame closing on or off (see [`crate::geometry::close_frames`]).
    SetFrameClosing(ShapeId, bool),
    /// Sets the display options of curves and surfaces.
    SetCurveDisplay(ShapeId, CurveDisplay),
    /// Appends the surface of revolution of a flat curve about +Y.
    MakeSurfaceOfRevolution {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        profile: usize,
        /// Number of steps of the whole turn.
        steps: u32,
    },
    /// Appends the generalized cylinder of a flat curve that is swept along another.
    MakeSweep {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the flat curve in its [`crate::scene::CurveSet`]; a small circle, added with
        /// the surface, if `None`.
        profile: Option<usize>,
        /// Index of the curve that it is swept along.
        sweep: usize,
    },
}

/// Change of the view, the selection or the messages; the document stays as it is.
#[derive(Clone, Debug)]
pub enum View {
    /// Sets the camera.
    SetCamera(Camera),
    /// Sets the camera to one of the six views of the View menu.
    From(ViewDirection),
    /// Sets the camera to the one with which the document was opened.
    ResetCamera,
    /// Fits the selected shapes, or everything visible if no visible shape is selected, into the
    /// picture.
    Fit(FitArea),
    /// Fits everything visible into the picture.
    FitAll(FitArea),
    /// Sets the camera, and makes it the one with which the document was opened.
    BeginAt(Camera),
    /// Shows or hides the axes.
    SetAxis(bool),
    /// Shows or hides the Studio look's grid.
    SetGrid(bool),
    /// Shows or hides the bones of the Mannequin look.
    SetBones(bool),
    /// Sets lights and background.
    SetLook(Look),
    /// The same, with the axes as the look has them in a new view, unless they were shown or hidden.
    ChooseLook(Look),
    /// Sets the normals that surfaces are shaded with.
    SetShading(Shading),
    /// Selects a shape alone, or none.
    Select(Option<ShapeId>),
    /// Adds a shape to those that are selected, as the active one, or takes it out.
    ToggleSelected(ShapeId),
    /// Selects all shapes of the list from the active one to this.
    SelectTo(ShapeId),
    /// Selects all shapes.
    SelectAll,
    /// Selects the shapes in a box, or adds them to those that are selected, or takes them out.
    SelectInBox(Vec<ShapeId>, BoxMode),
    /// Selects a joint of the selected shape alone, or none.
    SelectJoint(Option<usize>),
    /// Selects these joints of the selected shape, of which the last one is the active one.
    SelectJoints(Vec<usize>),
    /// Adds a joint of the selected shape to those that are selected, as the active one, or takes it out.
    ToggleJoint(usize),
    /// Highlights the joint of the selected shape that the pointer is over, or none.
    HoverJoint(Option<usize>),
    /// Highlights the joint of any character that the pointer is over in the view, or none.
    HoverBone(Option<(ShapeId, usize)>),
    /// Highlights the control point of the selected shape that the pointer is over, by the indices
    /// of its curve and of the point in it; or none.
    HoverControlPoint(Option<(usize, usize)>),
    /// Tells the user why something was not done.
    Tell(Cow<'static, str>),
    /// Dismisses the fresh message at an index; the history keeps it.
    DismissMessage(usize),
}
