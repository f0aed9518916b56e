//! A scene as its file has it: the schema, version 1. Angles are in degrees.

use super::{PoseData, json, scanner};
use crate::math::{Euler, Transform};
use crate::scene::{
    COLOR_PRESETS, CUSTOM_PRESET, Camera, CharacterDisplay, CurveDisplay, CurveShape,
    CurveVisibility, Look, Placement, Shading, ShapeColor, ShapeKind, SurfaceVisibility,
    ViewSettings,
};
use glam::Vec3;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

const FORMAT: &str = "editor-scene";
const VERSION: u32 = 1;

/// The whole file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneData {
    pub format: Format,
    pub version: Version,
    #[serde(default, deserialize_with = "json::object")]
    pub view: ViewData,
    #[serde(default, deserialize_with = "json::objects")]
    pub shapes: Vec<ShapeData>,
}

/// What says that a file is a scene, and of which version: read first, and alone, so that a file
/// of a later version is told as such and not by its first unknown word.
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

impl Serialize for Format {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        FORMAT.serialize(serializer)
    }
}

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

impl Serialize for Version {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        VERSION.serialize(serializer)
    }
}

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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct ViewData {
    #[serde(deserialize_with = "json::object")]
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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "CameraFields", into = "CameraFields")]
pub(super) struct CameraData(pub Camera);

#[derive(Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct CameraFields {
    #[serde(deserialize_with = "json::finite3")]
    target: Vec3,
    #[serde(deserialize_with = "json::finite")]
    radius: f32,
    #[serde(deserialize_with = "json::finite")]
    theta: f32,
    #[serde(deserialize_with = "json::finite")]
    phi: f32,
    #[serde(deserialize_with = "json::finite")]
    fovy: f32,
    #[serde(deserialize_with = "json::finite")]
    near: f32,
    #[serde(deserialize_with = "json::finite")]
    far: f32,
}

impl Default for CameraFields {
    fn default() -> Self {
        CameraData::default().into()
    }
}

impl From<CameraData> for CameraFields {
    fn from(CameraData(camera): CameraData) -> Self {
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
        let wrong = if fields.radius <= 0.0 {
            format!("a radius above 0, found {}", fields.radius)
        } else if !(1.0..=170.0).contains(&fields.fovy) {
            format!("a fovy from 1 to 170, found {}", fields.fovy)
        } else if fields.near <= 0.0 || fields.near >= fields.far {
            let (near, far) = (fields.near, fields.far);
            format!("0 < near < far, found {near} and {far}")
        } else {
            return Ok(Self(Camera {
                target: fields.target,
                radius: fields.radius,
                theta: fields.theta.to_radians(),
                phi: fields.phi.to_radians(),
                fovy: fields.fovy.to_radians(),
                near: fields.near,
                far: fields.far,
            }));
        };
        Err(format!("expected {wrong}"))
    }
}

/// One shape: of a kind, or from a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShapeData {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<KindData>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    #[serde(default, deserialize_with = "json::finite3")]
    pub position: Vec3,
    #[serde(default, deserialize_with = "json::finite3")]
    pub rotation: Vec3,
    #[serde(default = "one", deserialize_with = "scale")]
    pub scale: Vec3,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uniform_scaling: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<ColorData>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub visible: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub locked: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pose: Option<PoseReference>,
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "json::optional_object"
    )]
    pub display: Option<CharacterDisplay>,
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "json::optional_object"
    )]
    pub curves: Option<CurveData>,
}

/// How curves and surfaces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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

fn scale<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    let scale = json::finite3(deserializer)?;
    if scale.cmpeq(Vec3::ZERO).any() {
        return Err(D::Error::custom("expected scales other than 0, found 0"));
    }
    Ok(scale)
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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

impl Serialize for ColorData {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.preset_index() {
            CUSTOM_PRESET => self.0.rgb().serialize(serializer),
            preset => COLOR_PRESETS[preset].name.serialize(serializer),
        }
    }
}

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
                let rgb = json::finite3(SeqAccessDeserializer::new(numbers))?;
                if rgb.clamp(Vec3::ZERO, Vec3::ONE) != rgb {
                    let message = "expected red, green and blue from 0 to 1";
                    return Err(A::Error::custom(format!("{message}, found {rgb}")));
                }
                Ok(ShapeColor::Custom(rgb))
            }
        }
        deserializer.deserialize_any(Color).map(Self)
    }
}

/// A pose written out, or the file that holds it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
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
