//! What both versions of scene files share: the file as a whole, the view, kinds, colors and display
//! options. Angles are in degrees.

use super::super::angle::Angle;
use super::super::{json_values, scanner};
use crate::scene::{
    COLOR_PRESETS, CUSTOM_PRESET, Camera, CharacterDisplay, CharacterShape, CurveDisplay, CurveSet,
    CurveShape, CurveVisibility, Look, Shading, ShapeColor, ShapeKind, SurfaceVisibility,
    ViewSettings,
};
use glam::Vec3;
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde_spanned::Spanned;
use std::fmt;
use std::marker::PhantomData;

pub(super) const FORMAT: &str = "editor-scene";

/// The whole file, with shapes of the form `S` and angles of the form `A`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, bound = "S: Deserialize<'de>, A: Angle")]
pub(super) struct SceneData<S, A> {
    #[serde(rename = "format")]
    _format: Format,
    #[serde(rename = "version")]
    _version: Version,
    #[serde(default)]
    pub view: ViewData<A>,
    /// Each with its bytes in the file, for faults that show only when others are read.
    #[serde(default = "Vec::new")]
    pub shapes: Vec<Spanned<S>>,
}

/// Format and version, which are read before the rest: a file of a later version is refused for
/// its version and not for the first key that is new in it.
#[derive(Deserialize)]
pub(super) struct Head {
    #[serde(rename = "format")]
    _format: Format,
    pub version: Version,
}

/// The one value of `format`.
#[derive(Clone, Copy, Debug)]
struct Format;

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match String::deserialize(deserializer)? {
            format if format == FORMAT => Ok(Self),
            other => Err(D::Error::custom(format!(
                "expected the format “{FORMAT}”, found {}",
                scanner::quoted(&other)
            ))),
        }
    }
}

/// The value of `version`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Version {
    One,
    Two,
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u32::deserialize(deserializer)? {
            1 => Ok(Self::One),
            2 => Ok(Self::Two),
            other => Err(D::Error::custom(format!(
                "expected version 1 or 2, found {other}: it needs a newer editor"
            ))),
        }
    }
}

/// How the scene is looked at.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields, bound = "A: Angle")]
pub(super) struct ViewData<A> {
    camera: CameraData<A>,
    look: Look,
    axis: bool,
    grid: bool,
    bones: bool,
    shading: Shading,
}

impl<A> Default for ViewData<A> {
    fn default() -> Self {
        let ViewSettings {
            camera,
            look,
            axis,
            grid,
            bones,
            shading,
        } = ViewSettings::default();
        Self {
            camera: CameraData(camera, PhantomData),
            look,
            axis,
            grid,
            bones,
            shading,
        }
    }
}

impl<A> ViewData<A> {
    pub fn settings(&self) -> ViewSettings {
        ViewSettings {
            camera: self.camera.0,
            look: self.look,
            axis: self.axis,
            grid: self.grid,
            bones: self.bones,
            shading: self.shading,
        }
    }
}

/// A camera, with angles of the form `A`.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "CameraFields<A>", bound = "A: Angle")]
struct CameraData<A>(Camera, PhantomData<A>);

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields, bound = "A: Angle")]
struct CameraFields<A: Angle> {
    #[serde(deserialize_with = "vector")]
    target: Vec3,
    #[serde(deserialize_with = "json_values::positive")]
    radius: f32,
    theta: A,
    phi: A,
    #[serde(deserialize_with = "fovy")]
    fovy: A,
    #[serde(deserialize_with = "json_values::positive")]
    near: f32,
    #[serde(deserialize_with = "json_values::positive")]
    far: f32,
}

impl<A: Angle> Default for CameraFields<A> {
    fn default() -> Self {
        let camera = Camera::default();
        Self {
            target: camera.target,
            radius: camera.radius,
            theta: A::from_radians(camera.theta),
            phi: A::from_radians(camera.phi),
            fovy: A::from_radians(camera.fovy),
            near: camera.near,
            far: camera.far,
        }
    }
}

impl<A: Angle> TryFrom<CameraFields<A>> for CameraData<A> {
    type Error = String;

    fn try_from(fields: CameraFields<A>) -> Result<Self, String> {
        let CameraFields { near, far, .. } = fields;
        if near >= far {
            return Err(format!("expected near < far, found {near} and {far}"));
        }
        let camera = Camera {
            target: fields.target,
            radius: fields.radius,
            theta: fields.theta.radians(),
            phi: fields.phi.radians(),
            fovy: fields.fovy.radians(),
            near,
            far,
        };
        Ok(Self(camera, PhantomData))
    }
}

/// A field of view in degrees that a perspective can have.
fn fovy<'de, D: Deserializer<'de>, A: Angle>(deserializer: D) -> Result<A, D::Error> {
    let angle = A::deserialize(deserializer)?;
    if is_fovy(angle.radians()) {
        Ok(angle)
    } else {
        let degrees = angle.radians().to_degrees();
        let message = format!("expected a fovy from 1 to 170, found {degrees}");
        Err(D::Error::custom(message))
    }
}

/// Whether a perspective can have this field of view, radians.
pub(super) fn is_fovy(radians: f32) -> bool {
    (1.0_f32.to_radians()..=170.0_f32.to_radians()).contains(&radians)
}

/// Three finite numbers.
pub(super) fn vector<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    json_values::vec3(deserializer, |_| Ok(()))
}

/// How curves and surfaces are drawn.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct CurveDisplayData {
    pub control_points: bool,
    pub curve: CurveVisibility,
    pub surface: SurfaceVisibility,
    pub close_frames: bool,
}

impl Default for CurveDisplayData {
    fn default() -> Self {
        Self::of(&CurveShape::new(CurveSet::new()))
    }
}

impl CurveDisplayData {
    /// How `shape` is drawn.
    pub fn of(shape: &CurveShape) -> Self {
        Self {
            control_points: shape.display.control_points,
            curve: shape.display.curve,
            surface: shape.display.surface,
            close_frames: shape.frame_closing(),
        }
    }

    pub fn apply_to(self, shape: &mut CurveShape) {
        shape.display = CurveDisplay {
            control_points: self.control_points,
            curve: self.curve,
            surface: self.surface,
        };
        shape.set_frame_closing(self.close_frames);
    }
}

/// Sets display options of a character within the limits of drivers.
pub(super) fn set_display(character: &mut CharacterShape, display: CharacterDisplay) {
    // Beyond this no driver draws, and no one wants it.
    character.display = CharacterDisplay {
        point_size: display.point_size.clamp(1.0, 64.0),
        line_width: display.line_width.clamp(1.0, 64.0),
        ..display
    };
}

/// The shapes that need no file.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum KindData {
    Cube,
    Sphere,
    Pyramid,
    Teapot,
    Icosahedron,
    Custom,
}

impl KindData {
    /// Name in files of a shape that needs no file; `None` for others.
    pub fn name(kind: &ShapeKind) -> Option<&'static str> {
        match kind {
            ShapeKind::Cube => Some("cube"),
            ShapeKind::Sphere => Some("sphere"),
            ShapeKind::Pyramid => Some("pyramid"),
            ShapeKind::Teapot => Some("teapot"),
            ShapeKind::Icosahedron => Some("icosahedron"),
            ShapeKind::Custom => Some("custom"),
            ShapeKind::Curve(_)
            | ShapeKind::Mesh(_)
            | ShapeKind::Character(_)
            | ShapeKind::Missing(_) => None,
        }
    }

    pub fn kind(self) -> ShapeKind {
        match self {
            Self::Cube => ShapeKind::Cube,
            Self::Sphere => ShapeKind::Sphere,
            Self::Pyramid => ShapeKind::Pyramid,
            Self::Teapot => ShapeKind::Teapot,
            Self::Icosahedron => ShapeKind::Icosahedron,
            Self::Custom => ShapeKind::Custom,
        }
    }
}

/// The name of a preset, or red, green and blue in 0..1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ColorData(pub ShapeColor);

impl<'de> Deserialize<'de> for ColorData {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Color;
        impl<'de> Visitor<'de> for Color {
            type Value = ShapeColor;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a color, or red, green and blue in 0..1")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<ShapeColor, E> {
                let named = |preset: &usize| COLOR_PRESETS[*preset].name.eq_ignore_ascii_case(name);
                let preset = (0..CUSTOM_PRESET).find(named).ok_or_else(|| {
                    let found = scanner::quoted(name);
                    E::custom(format!(
                        "expected a color of the panel's list, found {found}"
                    ))
                })?;
                Ok(ShapeColor::Preset(preset))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<ShapeColor, A::Error> {
                let numbers = SeqAccessDeserializer::new(numbers);
                let rgb = json_values::vec3(numbers, |channel| match channel {
                    0.0..=1.0 => Ok(()),
                    _ => Err(format!("expected a number from 0 to 1, found {channel}")),
                })?;
                Ok(ShapeColor::Custom(rgb))
            }
        }
        deserializer.deserialize_any(Color).map(Self)
    }
}
