use crate::character::Pose;
use crate::geometry::Curve;
use crate::math::{Euler, Transform};
use crate::scene::{
    Camera, CharacterDisplay, CurveDisplay, Look, NewShape, Shading, ShapeColor, ShapeId,
    ViewDirection,
};
use glam::Vec3;

/// A change of the scene.
#[derive(Clone, Debug)]
pub enum Edit {
    /// Several edits as one: all of them, in order, or none.
    Together(Vec<Edit>),
    /// Replaces the scene by one of these shapes.
    Open(Vec<NewShape>),
    /// Adds shapes at the end of the list.
    Insert(Vec<NewShape>),
    /// Deletes a shape.
    Delete(ShapeId),
    /// Puts placement, color and joint angles back to how the shape started.
    Reset(ShapeId),
    /// Moves, turns or scales a shape.
    SetTransform(ShapeId, Transform),
    /// Scales all axes together, or each by its own. Turning it on makes all scales the x one.
    SetUniformScaling(ShapeId, bool),
    /// Colors a shape.
    SetColor(ShapeId, ShapeColor),
    /// Shows a shape in the view, or hides it there.
    SetVisible(ShapeId, bool),
    /// Keeps a shape from being picked, posed and moved in the view, or lets it be.
    SetLocked(ShapeId, bool),
    /// Changes how a character is drawn.
    SetDisplay(ShapeId, CharacterDisplay),
    /// Leaves every vertex of a character at most so many influences (see
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
        /// Its new angles.
        rotation: Euler,
    },
    /// Moves a root joint from its place at rest, in the character's space.
    SetRootOffset {
        /// The character.
        shape: ShapeId,
        /// Index of the root joint.
        root: usize,
        /// How far.
        offset: Vec3,
    },
    /// Puts one joint back to rest.
    ResetJoint(ShapeId, usize),
    /// Replaces all angles.
    SetPose(ShapeId, Pose),
    /// Keeps the current pose with the character, in place of the one of that name if there is
    /// one.
    KeepPose {
        /// The character.
        shape: ShapeId,
        /// What the list will call it.
        name: String,
    },
    /// Takes a kept pose, by its index, off the character's list.
    ForgetPose(ShapeId, usize),
    /// Moves a control point. A curve that closes stays closed, a flat one flat.
    SetControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point.
        point: usize,
        /// Its new place, in the shape's model space.
        position: Vec3,
    },
    /// Adds a control point, or a whole piece of a Bézier curve (see
    /// [`Curve::with_point_after`]).
    AddControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point that the new one comes behind.
        after: usize,
    },
    /// Takes a control point away, of a Bézier curve with its handles (see
    /// [`Curve::without_point`]).
    RemoveControlPoint {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        curve: usize,
        /// Index of the control point.
        point: usize,
    },
    /// Adds a curve at the end of a shape made of curves.
    AddCurve(ShapeId, Curve),
    /// Takes a curve or surface out of a shape made of curves, and all surfaces made from it.
    RemoveCurveItem {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve or surface in its [`crate::scene::CurveSet`].
        item: usize,
    },
    /// Sets the steps of a curve (per piece) or of a surface of revolution (of the turn).
    SetSteps {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve or surface in its [`crate::scene::CurveSet`].
        item: usize,
        /// How many.
        steps: u32,
    },
    /// Sets the radius of a circle.
    SetRadius {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the circle in its [`crate::scene::CurveSet`].
        curve: usize,
        /// In the shape's model space.
        radius: f32,
    },
    /// Spreads the angle by which frames miss their start along closed sweeps, or leaves it.
    SetFrameClosing(ShapeId, bool),
    /// Changes how curves and surfaces are drawn.
    SetCurveDisplay(ShapeId, CurveDisplay),
    /// Adds the surface that a flat curve sweeps when it turns about +Y.
    MakeSurfaceOfRevolution {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the curve in its [`crate::scene::CurveSet`].
        profile: usize,
        /// Steps of the whole turn.
        steps: u32,
    },
    /// Adds the surface that a flat curve makes when it is carried along another.
    MakeSweep {
        /// The shape made of curves.
        shape: ShapeId,
        /// Index of the flat curve in its [`crate::scene::CurveSet`]; a small circle, added with
        /// the surface, if `None`.
        profile: Option<usize>,
        /// Index of the curve that it is carried along.
        sweep: usize,
    },
}

/// A change of how the scene is looked at.
#[derive(Clone, Debug)]
pub enum View {
    /// Puts the camera elsewhere.
    SetCamera(Camera),
    /// One of the six views of the View menu.
    From(ViewDirection),
    /// The course's first view.
    ResetCamera,
    /// Moves the camera so that the selected shape, or everything visible if none that is visible
    /// is selected, fills a picture of this aspect (width over height).
    Fit {
        /// Width over height.
        aspect: f32,
    },
    /// Shows or hides the axes.
    SetAxis(bool),
    /// Shows or hides the Studio look's grid.
    SetGrid(bool),
    /// Changes light and background.
    SetLook(Look),
    /// Changes the normals that surfaces are lit with.
    SetShading(Shading),
    /// Selects a shape, or none.
    Select(Option<ShapeId>),
    /// Selects a joint of the selected shape, or none.
    SelectJoint(Option<usize>),
    /// Marks the joint of the selected shape that the pointer is over, or none.
    HoverJoint(Option<usize>),
    /// Marks the joint of any character that the pointer is over in the view, or none.
    HoverBone(Option<(ShapeId, usize)>),
    /// Marks the control point of the selected shape that the pointer is over, by the indices of
    /// its curve and of the point in it; or none.
    HoverControlPoint(Option<(usize, usize)>),
    /// Takes the fresh messages away; the history keeps them.
    DismissMessages,
    /// Takes the fresh message at an index from the view.
    DismissMessage(usize),
}
