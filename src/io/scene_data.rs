//! The schema of scene files, version 1. Angles are in degrees.

use super::{PoseData, json, scanner};
use crate::math::{Euler, Transform};
use crate::scene::{
    COLOR_PRESETS, CUSTOM_PRESET, Camera, CharacterDisplay, CurveDisplay, CurveShape,
    CurveVisibility, Look, Placement, Shading, ShapeColor, ShapeKind, SurfaceVisibility,
    ViewSettings,
};
use glam::Vec3;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_spanned::Spanned;
use std::fmt;

const FORMAT: &str = "editor-scene";
const VERSION: u32 = 1;

/// The whole file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneData {
    pub format: Format,
    pub version: Version,
    #[serde(default)]
    pub view: ViewData,
    /// Each with its bytes in the file, for faults that show only when others are read.
    #[serde(default)]
    pub shapes: Vec<Spanned<ShapeData>>,
}

/// Format and version, which are read before the rest: a file of a later version is refused for
/// its version and not for the first key that is new in it.
#[derive(Deserialize)]
pub(super) struct Head {
    #[serde(rename = "format")]
    _format: Format,
    #[serde(rename = "version")]
    _version: Version,
}

/// The one value of `format`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Format;

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

/// The one value of `version`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Version;

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u32::deserialize(deserializer)? {
            VERSION => Ok(Self),
            other => Err(D::Error::custom(format!(
                "expected version {VERSION}, found {other}: it needs a newer editor"
            ))),
        }
    }
}

/// How the scene is looked at.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct ViewData {
    pub camera: CameraData,
    pub look: Look,
    pub axis: bool,
    pub grid: bool,
    pub shading: Shading,
}

impl Default for ViewData {
    fn default() -> Self {
        let ViewSettings {
            camera: _,
            look,
            axis,
            grid,
            shading,
        } = ViewSettings::default();
        Self {
            camera: CameraData::default(),
            look,
            axis,
            grid,
            shading,
        }
    }
}

impl ViewData {
    pub fn settings(&self) -> ViewSettings {
        ViewSettings {
            camera: self.camera.0,
            look: self.look,
            axis: self.axis,
            grid: self.grid,
            shading: self.shading,
        }
    }
}

/// A camera with its angles in degrees.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(try_from = "CameraFields")]
pub(super) struct CameraData(pub Camera);

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct CameraFields {
    #[serde(deserialize_with = "vector")]
    target: Vec3,
    #[serde(deserialize_with = "json::positive")]
    radius: f32,
    theta: f32,
    phi: f32,
    #[serde(deserialize_with = "fovy")]
    fovy: f32,
    #[serde(deserialize_with = "json::positive")]
    near: f32,
    #[serde(deserialize_with = "json::positive")]
    far: f32,
}

impl Default for CameraFields {
    fn default() -> Self {
        let camera = Camera::default();
        Self {
            target: camera.target,
            radius: camera.radius,
            theta: camera.theta.to_degrees(),
            phi: camera.phi.to_degrees(),
            fovy: camera.fovy.to_degrees(),
            near: camera.near,
            far: camera.far,
        }
    }
}

impl TryFrom<CameraFields> for CameraData {
    type Error = String;

    fn try_from(fields: CameraFields) -> Result<Self, String> {
        let CameraFields { near, far, .. } = fields;
        if near >= far {
            return Err(format!("expected near < far, found {near} and {far}"));
        }
        Ok(Self(Camera {
            target: fields.target,
            radius: fields.radius,
            theta: fields.theta.to_radians(),
            phi: fields.phi.to_radians(),
            fovy: fields.fovy.to_radians(),
            near,
            far,
        }))
    }
}

/// A field of view in degrees that a perspective can have.
fn fovy<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f32, D::Error> {
    json::checked(deserializer, |degrees| match degrees {
        1.0..=170.0 => Ok(()),
        _ => Err(format!("expected a fovy from 1 to 170, found {degrees}")),
    })
}

/// One shape: of a kind, or from a file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShapeData {
    pub kind: Option<KindData>,
    pub source: Option<String>,
    pub name: Option<String>,
    #[serde(default, deserialize_with = "vector")]
    pub position: Vec3,
    #[serde(default, deserialize_with = "vector")]
    pub rotation: Vec3,
    #[serde(default = "one", deserialize_with = "scale")]
    pub scale: Vec3,
    pub uniform_scaling: Option<bool>,
    pub color: Option<ColorData>,
    pub visible: Option<bool>,
    pub locked: Option<bool>,
    pub pose: Option<PoseReference>,
    pub display: Option<CharacterDisplay>,
    pub curves: Option<CurveData>,
}

/// How curves and surfaces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct CurveData {
    control_points: bool,
    curve: CurveVisibility,
    surface: SurfaceVisibility,
    close_frames: bool,
}

impl Default for CurveData {
    fn default() -> Self {
        let display = CurveDisplay::default();
        Self {
            control_points: display.control_points,
            curve: display.curve,
            surface: display.surface,
            close_frames: true,
        }
    }
}

impl CurveData {
    pub fn apply_to(self, shape: &mut CurveShape) {
        shape.display = CurveDisplay {
            control_points: self.control_points,
            curve: self.curve,
            surface: self.surface,
        };
        shape.set_frame_closing(self.close_frames);
    }
}

fn one() -> Vec3 {
    Vec3::ONE
}

fn vector<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    json::vec3(deserializer, |_| Ok(()))
}

fn scale<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    json::vec3(deserializer, |scale| match scale {
        0.0 => Err("expected a scale other than 0, found 0".to_owned()),
        _ => Ok(()),
    })
}

impl ShapeData {
    /// Where the shape stands, in the color of `kind` if it names none.
    pub fn placement(&self, kind: &ShapeKind) -> Placement {
        let uniform = self.scale == Vec3::splat(self.scale.x);
        let color = self.color.map(|color| color.0);
        Placement {
            transform: Transform {
                position: self.position,
                rotation: Euler::from_degrees(self.rotation),
                scale: self.scale,
            },
            uniform_scaling: self.uniform_scaling.unwrap_or(uniform),
            color: color.unwrap_or(ShapeColor::Preset(kind.start_color())),
        }
    }
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
                let rgb = json::vec3(numbers, |channel| match channel {
                    0.0..=1.0 => Ok(()),
                    _ => Err(format!("expected a number from 0 to 1, found {channel}")),
                })?;
                Ok(ShapeColor::Custom(rgb))
            }
        }
        deserializer.deserialize_any(Color).map(Self)
    }
}

/// A pose written out, or the file that holds it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum PoseReference {
    File(String),
    Inline(PoseData),
}

impl<'de> Deserialize<'de> for PoseReference {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FileOrPose;
        impl<'de> Visitor<'de> for FileOrPose {
            type Value = PoseReference;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a pose or the name of its file")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<PoseReference, E> {
                Ok(PoseReference::File(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PoseReference, A::Error> {
                PoseData::deserialize(MapAccessDeserializer::new(map)).map(PoseReference::Inline)
            }
        }
        deserializer.deserialize_any(FileOrPose)
    }
}
