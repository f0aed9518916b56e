use super::{CharacterShape, CurveShape, ShapeColor, custom};
use crate::geometry::{self, Mesh, SharedMesh};
use crate::math::Transform;
use glam::Vec3;
use std::collections::HashSet;
use std::sync::{Arc, LazyLock};

/// Identifier of a shape while its scene is open; from 1, never reused.
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

/// Shape in the scene. Equal shapes are drawn alike and behave alike: heavy data is equal if its
/// revision is.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Identifier.
    pub id: ShapeId,
    /// Name in the list of shapes.
    pub name: String,
    /// Geometry, and for characters and curves pose and display.
    pub kind: ShapeKind,
    /// File that it came from, for scene files; `None` for shapes made in code.
    pub source: Option<Source>,
    /// Placement and color that Reset restores.
    pub start: Placement,
    /// Current placement and color.
    pub placement: Placement,
    /// Whether it is drawn. A hidden shape cannot be picked either and is ignored when the view is
    /// fitted to everything; it is exported all the same.
    pub visible: bool,
    /// Whether it is ignored by the pointer in the view: not picked, posed or moved there. Panels
    /// and keys change it all the same.
    pub locked: bool,
}

impl Shape {
    /// Direction in the world in which a character faces at rest, as long as it is scaled to be;
    /// `None` for all else.
    pub fn front(&self) -> Option<Vec3> {
        front(&self.kind, &self.placement)
    }

    /// Its transform, were it turned as it began.
    pub fn upright(&self) -> Transform {
        Transform {
            rotation: self.start.transform.rotation,
            ..self.placement.transform
        }
    }

    /// Path of the file that it came from, if it came from one.
    pub fn source_file(&self) -> Option<&str> {
        self.source.as_ref().map(|source| &*source.file)
    }

    /// See [`super::Scene::memory`].
    pub(super) fn memory(&self, counted: &mut HashSet<usize>) -> usize {
        let file = self.source.as_ref().map_or(0, |source| source.file.len());
        let own = size_of::<Self>() + self.name.len() + file;
        own + match &self.kind {
            ShapeKind::Mesh(mesh) => mesh.memory(counted),
            ShapeKind::Character(character) => character.memory(counted),
            ShapeKind::Curve(curve) => curve.memory(counted),
            ShapeKind::Cube
            | ShapeKind::Sphere
            | ShapeKind::Pyramid
            | ShapeKind::Teapot
            | ShapeKind::Icosahedron
            | ShapeKind::Custom
            | ShapeKind::Missing(_) => 0,
        }
    }
}

fn front(kind: &ShapeKind, placement: &Placement) -> Option<Vec3> {
    let ShapeKind::Character(character) = kind else {
        return None;
    };
    let front = character.character.skeleton().facing().front();
    let world_from_model = placement.transform.world_from_model();
    Some(world_from_model.transform_vector3(front))
}

/// Shape before it is added to a scene: everything but its identifier.
#[derive(Clone, Debug)]
pub struct NewShape {
    /// Name for the list of shapes.
    pub name: String,
    /// Geometry, and for characters and curves pose and display.
    pub kind: ShapeKind,
    /// File that it came from; `None` for shapes made in code.
    pub source: Option<Source>,
    /// Placement and color.
    pub placement: Placement,
    /// Placement and color that Reset restores.
    pub start: Placement,
    /// See [`Shape::visible`].
    pub visible: bool,
    /// See [`Shape::locked`].
    pub locked: bool,
}

impl NewShape {
    /// A visible shape at the origin, in the color of its kind.
    pub fn new(name: impl Into<String>, kind: ShapeKind) -> Self {
        let start = Placement::at_origin(kind.start_color());
        Self {
            name: name.into(),
            placement: start,
            start,
            kind,
            source: None,
            visible: true,
            locked: false,
        }
    }

    /// See [`Shape::front`].
    pub fn front(&self) -> Option<Vec3> {
        front(&self.kind, &self.placement)
    }

    /// The same shape, imported from `source`.
    pub fn from_source(self, source: Source) -> Self {
        Self {
            source: Some(source),
            ..self
        }
    }
}

/// Placement of a shape in the world, with its color.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Placement {
    /// Transform from model space to the world.
    pub transform: Transform,
    /// Whether the panel scales all axes together.
    pub uniform_scaling: bool,
    /// Color of the surface.
    pub color: ShapeColor,
}

impl Placement {
    /// Placement at the origin, not rotated or scaled, with the color preset of index `preset`.
    pub fn at_origin(preset: usize) -> Self {
        Self {
            transform: Transform::IDENTITY,
            uniform_scaling: true,
            color: ShapeColor::Preset(preset),
        }
    }
}

/// Origin of an imported shape: enough to import the same shape again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Path of the file, or `builtin:NAME`.
    pub file: String,
    /// Way in which the file was read.
    pub importer: Importer,
    /// Index among the shapes that the importer made of the file.
    pub part: usize,
    /// CRC-32 of the file and of those that were read with it, as they were when the shape was
    /// imported; `None` for built-in files.
    pub fingerprint: Option<u32>,
}

impl Source {
    /// Whether the file is one of the program's own.
    pub fn is_builtin(&self) -> bool {
        self.file.starts_with("builtin:")
    }

    /// Name of the file without folders and extension.
    pub fn stem(&self) -> &str {
        let name = self.file.rsplit(['/', ':']).next().unwrap_or_default();
        name.rsplit_once('.').map_or(name, |(stem, _)| stem)
    }
}

/// Way in which a file is read. One file may be read in several: an `.obj` beside a `.skel` as a
/// character or as a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Importer {
    /// Import Shape: meshes alone.
    Shape,
    /// Import Character: meshes with their skeletons, and the static meshes beside them.
    Character,
    /// Import Curve.
    Curve,
}

impl Importer {
    /// Index of the color preset of a new shape without materials.
    pub fn start_color(self) -> usize {
        match self {
            Self::Shape => 1,
            Self::Character => 12,
            Self::Curve => 30,
        }
    }
}

/// Kind of a shape, with its data.
#[derive(Clone, Debug)]
pub enum ShapeKind {
    /// Cube of ±0.5 on each axis.
    Cube,
    /// Sphere of radius 0.5.
    Sphere,
    /// Pyramid with a square base, apex up.
    Pyramid,
    /// Newell's teapot.
    Teapot,
    /// Regular icosahedron.
    Icosahedron,
    /// The shape that [`custom::custom_shape`] makes.
    Custom,
    /// Imported mesh.
    Mesh(SharedMesh),
    /// Imported character.
    Character(CharacterShape),
    /// Curves and surfaces, imported or drawn.
    Curve(CurveShape),
    /// Stand-in for a shape whose file could not be read.
    Missing(Arc<MissingShape>),
}

/// What is known of a shape whose file could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MissingShape {
    /// Reason, in plain words.
    pub reason: String,
    /// Member of the scene file that only means something with the shape's file, such as its pose:
    /// name, and value as JSON.
    pub kept: Option<(String, String)>,
}

impl PartialEq for ShapeKind {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Mesh(one), Self::Mesh(other)) => one.revision() == other.revision(),
            (Self::Character(one), Self::Character(other)) => one == other,
            (Self::Curve(one), Self::Curve(other)) => one == other,
            (Self::Missing(one), Self::Missing(other)) => one == other,
            (
                Self::Cube
                | Self::Sphere
                | Self::Pyramid
                | Self::Teapot
                | Self::Icosahedron
                | Self::Custom
                | Self::Mesh(_)
                | Self::Character(_)
                | Self::Curve(_)
                | Self::Missing(_),
                _,
            ) => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

impl ShapeKind {
    /// Name of the kind, as in the Insert menu.
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
            Self::Missing(_) => "Missing",
        }
    }

    /// Index of the color preset of a new shape.
    pub fn start_color(&self) -> usize {
        match self {
            Self::Cube => 2,
            Self::Sphere => 3,
            Self::Pyramid => 5,
            Self::Teapot => 4,
            Self::Icosahedron => 6,
            Self::Custom => 11,
            Self::Mesh(_) => Importer::Shape.start_color(),
            // Its materials have colors, which another one would tint.
            Self::Character(shape) if !shape.character.bind_mesh().groups.is_empty() => 1,
            Self::Character(_) => Importer::Character.start_color(),
            Self::Curve(_) => Importer::Curve.start_color(),
            // Its material has a color.
            Self::Missing(_) => 1,
        }
    }

    /// Mesh of the shape, undeformed; empty for curves, whose surfaces only [`super::Evaluator`]
    /// makes.
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
            // A box stands in for a shape whose file is missing, in the color that it has.
            Self::Cube | Self::Missing(_) => CUBE.clone(),
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
