use super::kept_pose::{self, KeptPose};
use super::{CurveShape, ShapeColor, custom};
use crate::character::{Character, Pose};
use crate::geometry::{self, Mesh, SharedMesh};
use crate::math::Transform;
use crate::revision::Revision;
use std::sync::{Arc, LazyLock};

/// Names a shape for as long as its scene is open; from 1, never reused.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
#[serde(transparent)]
pub struct ShapeId(pub u32);

impl std::fmt::Display for ShapeId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

/// One thing in the scene. Equal shapes are drawn alike and behave alike: heavy data counts as
/// equal where its revision is.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its identity.
    pub id: ShapeId,
    /// What the list calls it.
    pub name: String,
    /// What it is.
    pub kind: ShapeKind,
    /// Where it came from, so that a scene file can name it; `None` for shapes made in code.
    pub source: Option<Source>,
    /// What Reset brings back: the placement and color that it started with.
    pub start: Placement,
    /// Its placement and color now.
    pub placement: Placement,
    /// Whether it is drawn. One that is not cannot be picked either, nor does it count when the
    /// view is fitted to everything; exports have it all the same.
    pub visible: bool,
    /// Whether the pointer passes through it in the view: it is not picked, posed or moved there.
    /// Panels and keys change it all the same.
    pub locked: bool,
}

/// A shape before it is in a scene: everything but its id.
#[derive(Clone, Debug)]
pub struct NewShape {
    /// Name for the list of shapes.
    pub name: String,
    /// Geometry, and for characters and curves pose and display.
    pub kind: ShapeKind,
    /// File that it came from; `None` for shapes made in code.
    pub source: Option<Source>,
    /// Placement and color, which Reset brings back later.
    pub placement: Placement,
    /// See [`Shape::visible`].
    pub visible: bool,
    /// See [`Shape::locked`].
    pub locked: bool,
}

impl NewShape {
    /// A visible shape at the origin, in the color of its kind.
    pub fn new(name: impl Into<String>, kind: ShapeKind) -> Self {
        Self {
            name: name.into(),
            placement: Placement::at_origin(kind.start_color()),
            kind,
            source: None,
            visible: true,
            locked: false,
        }
    }

    /// The same shape, imported from `source`.
    pub fn from_source(self, source: Source) -> Self {
        Self {
            source: Some(source),
            ..self
        }
    }
}

/// What every shape has: where it stands and its color.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Placement {
    /// From model space to the world.
    pub transform: Transform,
    /// Whether the panel scales all axes together.
    pub uniform_scaling: bool,
    /// Color of its surface.
    pub color: ShapeColor,
}

impl Placement {
    /// At the origin at its own size, in preset color `preset`.
    pub fn at_origin(preset: usize) -> Self {
        Self {
            transform: Transform::IDENTITY,
            uniform_scaling: true,
            color: ShapeColor::Preset(preset),
        }
    }
}

/// Where an imported shape came from.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct Source(
    /// A path, or `builtin:NAME`.
    pub String,
);

/// The closed set of things that a scene holds.
#[derive(Clone, Debug)]
pub enum ShapeKind {
    /// ±0.5 on each axis.
    Cube,
    /// Radius 0.5.
    Sphere,
    /// Square base, apex up.
    Pyramid,
    /// Newell's, from its patches.
    Teapot,
    /// Twenty faces.
    Icosahedron,
    /// The shape that [`custom::custom_shape`] makes.
    Custom,
    /// Import Shape.
    Mesh(SharedMesh),
    /// Import Character.
    Character(CharacterShape),
    /// Import Curve.
    Curve(CurveShape),
}

impl PartialEq for ShapeKind {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Mesh(one), Self::Mesh(other)) => one.revision() == other.revision(),
            (Self::Character(one), Self::Character(other)) => one == other,
            (Self::Curve(one), Self::Curve(other)) => one == other,
            (
                Self::Cube
                | Self::Sphere
                | Self::Pyramid
                | Self::Teapot
                | Self::Icosahedron
                | Self::Custom
                | Self::Mesh(_)
                | Self::Character(_)
                | Self::Curve(_),
                _,
            ) => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

/// A character in the scene: what was imported, and how it is posed and shown.
#[derive(Clone, Debug)]
pub struct CharacterShape {
    /// Skeleton, weights and bind mesh, shared with copies and older states.
    pub character: Arc<Character>,
    /// Its joints' angles. Change it through [`CharacterShape::set_pose`].
    pose: Pose,
    pose_revision: Revision,
    poses: Vec<KeptPose>,
    /// How it is drawn.
    pub display: CharacterDisplay,
}

/// How a character is drawn.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CharacterDisplay {
    /// Skeleton, mesh or both.
    pub mode: ModelDisplay,
    /// How joints are drawn.
    pub joints: JointStyle,
    /// How bones are drawn.
    pub bones: BoneStyle,
    /// Diameter of joints drawn as points, in pixels.
    pub point_size: f32,
    /// Width of bones drawn as lines, in pixels; 1 is a plain GL line.
    pub line_width: f32,
}

impl Default for CharacterDisplay {
    fn default() -> Self {
        Self {
            mode: ModelDisplay::Mesh,
            joints: JointStyle::Spheres,
            bones: BoneStyle::Boxes,
            point_size: 8.0,
            line_width: 1.0,
        }
    }
}

/// What the panel calls Model Display Mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModelDisplay {
    /// Joints and bones.
    Skeleton,
    /// The deformed mesh.
    Mesh,
    /// The mesh with the skeleton seen through it.
    Both,
}

/// How joints are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JointStyle {
    /// Round points of a fixed size on screen.
    Points,
    /// Spheres of radius 0.02 in the character's space.
    Spheres,
}

/// How bones are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BoneStyle {
    /// Lines of a fixed width on screen.
    Lines,
    /// Boxes of half-width 0.01 in the character's space.
    Boxes,
}

impl PartialEq for CharacterShape {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.character, &other.character)
            && self.pose == other.pose
            && self.poses == other.poses
            && self.display == other.display
    }
}

impl CharacterShape {
    /// `character` in its bind pose.
    pub fn new(character: Arc<Character>) -> Self {
        Self {
            character,
            pose: Pose::new(),
            pose_revision: Revision::new(),
            poses: Vec::new(),
            display: CharacterDisplay::default(),
        }
    }

    /// The joints' angles.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// The joints' angles at a time of playback, in seconds. A character keeps one pose for all
    /// time so far.
    pub fn pose_at(&self, _time: f64) -> &Pose {
        &self.pose
    }

    /// Changes with every change of the pose.
    pub fn pose_revision(&self) -> Revision {
        self.pose_revision
    }

    /// The poses that are kept with it, in the order in which they were.
    pub fn poses(&self) -> &[KeptPose] {
        &self.poses
    }

    /// Keeps the current pose under `name`, in place of the one of that name if there is one.
    pub fn keep_pose(&mut self, name: String) {
        kept_pose::keep(&mut self.poses, name, self.pose.clone());
    }

    /// Takes a kept pose off the list; nothing if there is none with this index.
    pub fn forget_pose(&mut self, index: usize) {
        if index < self.poses.len() {
            self.poses.remove(index);
        }
    }

    /// `Pose 1` and so on: the first name that no kept pose has.
    pub fn free_pose_name(&self) -> String {
        kept_pose::free_name(&self.poses)
    }

    /// Replaces the pose; one that is the same changes nothing.
    pub fn set_pose(&mut self, pose: Pose) {
        if pose != self.pose {
            self.pose = pose;
            self.pose_revision = Revision::new();
        }
    }
}

impl ShapeKind {
    /// The name that the Insert menu and scene files have for it.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Cube => "Cube",
            Self::Sphere => "Sphere",
            Self::Pyramid => "Pyramid",
            Self::Teapot => "Teapot",
            Self::Icosahedron => "Icosahedron",
            Self::Custom => "Custom Shape",
            Self::Mesh(_) => "Shape",
            Self::Character(_) => "Character",
            Self::Curve(_) => "Curve",
        }
    }

    /// The preset color a new one has.
    pub fn start_color(&self) -> usize {
        match self {
            Self::Cube => 2,
            Self::Sphere => 3,
            Self::Pyramid => 5,
            Self::Teapot => 4,
            Self::Icosahedron => 6,
            Self::Custom => 11,
            Self::Mesh(_) => 1,
            // Its materials have colors, which another one would tint.
            Self::Character(shape) if !shape.character.bind_mesh().groups.is_empty() => 1,
            Self::Character(_) => 12,
            Self::Curve(_) => 30,
        }
    }

    /// Its mesh, undeformed; empty for curves, whose surfaces only [`super::Evaluator`] makes.
    pub fn mesh(&self) -> SharedMesh {
        static CUBE: LazyLock<SharedMesh> = LazyLock::new(|| SharedMesh::new(geometry::cube()));
        static SPHERE: LazyLock<SharedMesh> =
            LazyLock::new(|| SharedMesh::new(geometry::sphere(0.5, 20, 20, geometry::Poles::Y)));
        static PYRAMID: LazyLock<SharedMesh> =
            LazyLock::new(|| SharedMesh::new(geometry::pyramid()));
        static TEAPOT: LazyLock<SharedMesh> = LazyLock::new(|| SharedMesh::new(geometry::teapot()));
        static ICOSAHEDRON: LazyLock<SharedMesh> =
            LazyLock::new(|| SharedMesh::new(geometry::icosahedron()));
        static CUSTOM: LazyLock<SharedMesh> =
            LazyLock::new(|| SharedMesh::new(custom::custom_shape()));
        static EMPTY: LazyLock<SharedMesh> = LazyLock::new(|| SharedMesh::new(Mesh::default()));
        match self {
            Self::Cube => CUBE.clone(),
            Self::Sphere => SPHERE.clone(),
            Self::Pyramid => PYRAMID.clone(),
            Self::Teapot => TEAPOT.clone(),
            Self::Icosahedron => ICOSAHEDRON.clone(),
            Self::Custom => CUSTOM.clone(),
            Self::Mesh(mesh) => mesh.clone(),
            Self::Character(shape) => shape.character.bind_mesh().clone(),
            Self::Curve(_) => EMPTY.clone(),
        }
    }
}
