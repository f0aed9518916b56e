//! The original's pictures and the parameters they were drawn with.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::reference_data::reference;
use editor_core::geometry::Picture;
use serde::Deserialize;

/// One picture of the original.
#[derive(Debug, Deserialize)]
pub struct Render {
    pub file: String,
    pub size: [u32; 2],
    pub ui: bool,
    #[serde(default)]
    pub axis: bool,
    pub camera: Camera,
    pub content: Option<String>,
    pub model: Option<String>,
    pub mode: Option<String>,
    #[serde(default)]
    pub joints: BTreeMap<usize, JointAngles>,
}

impl Render {
    pub fn is_from_above_or_below(&self) -> bool {
        self.file.contains("_py_") || self.file.contains("_my_")
    }
}

#[derive(Debug, Deserialize)]
pub struct Camera {
    pub target: [f32; 3],
    pub radius: f32,
    pub theta_rad: f64,
    pub phi_rad: f64,
}

#[derive(Debug, Deserialize)]
pub struct JointAngles {
    pub xyz_deg: [f32; 3],
}

/// All of them.
pub struct Renders {
    pub course: PathBuf,
    pub all: Vec<Render>,
}

impl Renders {
    /// `None` where there is no reference data.
    pub fn read() -> Option<Self> {
        let course = reference("course")?;
        let list = std::fs::read(course.join("reference/renders.json")).expect("renders.json");
        Some(Self {
            all: serde_json::from_slice(&list).expect("a list of renders"),
            course,
        })
    }

    pub fn picture(&self, render: &Render) -> Picture {
        let path = self.course.join("reference").join(&render.file);
        let picture = image::open(&path)
            .expect("a picture of the original")
            .to_rgba8();
        Picture {
            width: picture.width(),
            height: picture.height(),
            rgba: picture.into_raw(),
        }
    }
}

/// Writes what we drew, to be looked at.
pub fn keep(folder: &str, file: &str, picture: &Picture) {
    let path = Path::new(folder).join(file);
    let (width, height) = (picture.width, picture.height);
    image::save_buffer(path, &picture.rgba, width, height, image::ColorType::Rgba8)
        .expect("a kept picture");
}
