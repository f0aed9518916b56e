//! Values of options, as people type them.

use super::load::ids;
use crate::editor::{Edit, Session};
use crate::scene::{Camera, Skinning, ViewDirection};
use glam::Vec3;

/// Which weights of a character count.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Influences {
    /// Every one of the file.
    All,
    /// The four largest of a vertex, divided by their sum: what some programs show.
    #[value(name = "4")]
    Four,
}

impl Influences {
    /// The edits that cut the characters of `session` down.
    pub fn edits(self, session: &Session) -> Vec<Edit> {
        match self {
            Self::All => Vec::new(),
            Self::Four => ids(session)
                .map(|id| Edit::LimitInfluences(id, 4))
                .collect(),
        }
    }
}

/// What is made of curves.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct CurveOptions {
    /// Leave the step of a closed sweep whose frames do not meet
    #[arg(long)]
    no_frame_closing: bool,
}

impl CurveOptions {
    /// The edits that make every curve of `session` so.
    pub fn edits(self, session: &Session) -> Vec<Edit> {
        if !self.no_frame_closing {
            return Vec::new();
        }
        ids(session)
            .map(|id| Edit::SetFrameClosing(id, false))
            .collect()
    }
}

/// What deforms the meshes that are drawn.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum SkinningName {
    /// The processor.
    Cpu,
    /// The graphics card.
    Gpu,
}

impl From<SkinningName> for Skinning {
    fn from(name: SkinningName) -> Self {
        match name {
            SkinningName::Cpu => Self::Cpu,
            SkinningName::Gpu => Self::Gpu,
        }
    }
}

/// `800x600`.
pub(super) fn size(text: &str) -> Result<(u32, u32), String> {
    let expected = || format!("expected WIDTHxHEIGHT such as 800x600, found {text}");
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(expected)?;
    let side = |text: &str| text.parse().ok().filter(|&side: &u32| side > 0);
    side(width).zip(side(height)).ok_or_else(expected)
}

/// More samples a pixel than any driver has.
const MOST_SAMPLES: u32 = 64;

/// `4`.
pub(super) fn samples(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|n| *n <= MOST_SAMPLES);
    number.ok_or_else(|| {
        format!("expected a whole number of samples from 0 to {MOST_SAMPLES}, found {text}")
    })
}

/// `on` or `off`.
pub(super) fn switch(text: &str) -> Result<bool, String> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err(format!("expected on or off, found {text}")),
    }
}

/// `+x` and so on.
pub(super) fn view(text: &str) -> Result<ViewDirection, String> {
    ViewDirection::ALL
        .into_iter()
        .find(|direction| direction.label().eq_ignore_ascii_case(text))
        .ok_or_else(|| format!("expected +x, -x, +y, -y, +z or -z, found {text}"))
}

/// `THETA,PHI,RADIUS` with `,TX,TY,TZ` or without; angles in degrees.
pub(super) fn camera(text: &str) -> Result<Camera, String> {
    let numbers: Option<Vec<f32>> = text
        .split(',')
        .map(|number| {
            number
                .trim()
                .parse()
                .ok()
                .filter(|number: &f32| number.is_finite())
        })
        .collect();
    let (theta, phi, radius, target) = match numbers.as_deref() {
        Some(&[theta, phi, radius]) => (theta, phi, radius, Vec3::ZERO),
        Some(&[theta, phi, radius, x, y, z]) => (theta, phi, radius, Vec3::new(x, y, z)),
        _ => {
            return Err(format!(
                "expected three numbers THETA,PHI,RADIUS or six with TX,TY,TZ, found {text}"
            ));
        }
    };
    if radius <= 0.0 {
        return Err(format!("expected a distance above 0, found {radius}"));
    }
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    Ok(Camera {
        target,
        radius,
        theta,
        phi,
        ..Camera::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_cameras_are_read_and_nonsense_is_told() {
        assert_eq!(size("640x480"), Ok((640, 480)));
        assert!(size("640").is_err() && size("0x5").is_err() && size("-1x5").is_err());
        let read = camera("-30,10,5,0,1,0").expect("six numbers");
        assert_eq!((read.radius, read.target), (5.0, Vec3::Y));
        assert!((read.theta.to_degrees() + 30.0).abs() < 1e-4);
        for bad in ["", "1,2", "1,2,x", "1,2,NaN", "1,2,0", "1,2,3,4"] {
            assert!(camera(bad).is_err(), "{bad}");
        }
        assert_eq!((samples("0"), samples("4")), (Ok(0), Ok(4)));
        for bad in ["-1", "65", "1.5", "many", ""] {
            assert!(samples(bad).is_err(), "{bad}");
        }
        assert_eq!(view("-x"), Ok(ViewDirection::MinusX));
        assert!(view("x").is_err());
    }
}
