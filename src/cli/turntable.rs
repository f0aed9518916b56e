//! Turntables: pictures from all around, as an animated GIF or as numbered files.

use super::CliError;
use crate::math::Aabb;
use crate::scene::{Camera, FitArea};
use std::f32::consts::TAU;
use std::path::{Path, PathBuf};

/// Most frames of a turntable.
const MOST_FRAMES: u32 = 720;

/// Number of frames, such as `36`.
pub(super) fn frames(text: &str) -> Result<u32, String> {
    let number = text.parse().ok();
    let number = number.filter(|number| (2..=MOST_FRAMES).contains(number));
    number.ok_or_else(|| {
        format!("expected a whole number of frames from 2 to {MOST_FRAMES}, found {text}")
    })
}

/// Time that a frame is shown, in milliseconds: a turn takes four seconds if it has enough frames,
/// and not too many for programs, which show none for less than 20 ms.
pub(super) fn milliseconds(frames: u32) -> u32 {
    (400 + frames / 2).div_euclid(frames).clamp(2, 50) * 10
}

/// Cameras of a turn about the target, in even steps, the first being `camera`. The scene turns to
/// the right.
pub(super) fn cameras(camera: Camera, frames: u32) -> impl Iterator<Item = Camera> {
    (0..frames).map(move |frame| Camera {
        theta: camera.theta + TAU * (frame as f32 / frames as f32),
        ..camera
    })
}

/// Fits `bounds` into all pictures of a turn: as [`Camera::fit`], with the greatest distance of all.
pub(super) fn fit(camera: &mut Camera, frames: u32, bounds: &Aabb, aspect: f32) {
    let fitted: Vec<Camera> = cameras(*camera, frames)
        .map(|mut camera| {
            camera.fit(bounds, FitArea::whole(aspect));
            camera
        })
        .collect();
    let farthest = fitted.iter().max_by(|a, b| a.radius.total_cmp(&b.radius));
    let Some(farthest) = farthest else { return };
    let near = fitted.iter().map(|camera| camera.near);
    let far = fitted.iter().map(|camera| camera.far);
    *camera = Camera {
        theta: camera.theta,
        near: near.fold(farthest.near, f32::min),
        far: far.fold(farthest.far, f32::max),
        ..*farthest
    };
}

/// Names of numbered pictures, such as `OUT-%03d.png`: number 7 is `OUT-007.png`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Numbered {
    folder: PathBuf,
    before: String,
    digits: usize,
    after: String,
}

impl Numbered {
    /// The names that `path` stands for; `None` without `%d`, or `%03d` and the like, in its name.
    pub fn new(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let (before, rest) = name.split_once('%')?;
        let (digits, after) = rest.split_once('d')?;
        let digits = match digits.strip_prefix('0') {
            None if digits.is_empty() => 1,
            Some(digits) => digits
                .parse()
                .ok()
                .filter(|digits| (1..=9).contains(digits))?,
            None => return None,
        };
        Some(Self {
            folder: path.parent().unwrap_or(Path::new("")).to_owned(),
            before: before.to_owned(),
            digits,
            after: after.to_owned(),
        })
    }

    /// Path of picture `number`.
    pub fn path(&self, number: usize) -> PathBuf {
        let (before, after, digits) = (&self.before, &self.after, self.digits);
        self.folder
            .join(format!("{before}{number:0digits$}{after}"))
    }
}

/// What a turntable is written as.
pub(super) enum Output {
    /// One file.
    Gif,
    /// One file a frame.
    Frames(Numbered),
}

impl Output {
    /// What `path` asks for; its extension is one of a picture.
    ///
    /// # Errors
    /// If it is neither: wrong usage.
    pub fn of(path: &Path) -> Result<Self, CliError> {
        if let Some(numbered) = Numbered::new(path) {
            return Ok(Self::Frames(numbered));
        }
        if crate::io::expect_extension(path, "gif").is_ok() {
            return Ok(Self::Gif);
        }
        Err(CliError::Usage(format!(
            "{}: expected a name that ends in .gif with --turntable, or has a place for numbers, \
             such as OUT-%03d.png",
            path.display()
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, Vec3};

    #[test]
    fn numbers_take_the_place_that_the_name_has_for_them() {
        let path = |name: &str, number| Some(Numbered::new(Path::new(name))?.path(number));
        assert_eq!(path("a/b-%03d.png", 7), Some("a/b-007.png".into()));
        assert_eq!(path("%d.png", 12), Some("12.png".into()));
        assert_eq!(path("%02d.png", 123), Some("123.png".into()));
        for none in [
            "a.png", "%x.png", "%3d.png", "%00d.png", "%0d.png", "100%.png",
        ] {
            assert_eq!(Numbered::new(Path::new(none)), None, "{none}");
        }
    }

    #[test]
    fn a_turn_takes_about_four_seconds() {
        let times = [2, 8, 36, 100, 720].map(milliseconds);
        assert_eq!(times, [500, 500, 110, 40, 20]);
    }

    #[test]
    fn a_fitted_turn_shows_every_corner_from_every_side() {
        let bounds = Aabb {
            min: Vec3::new(-4.0, 0.0, -0.1),
            max: Vec3::new(1.0, 1.0, 0.2),
        };
        let mut camera = Camera::default();
        fit(&mut camera, 12, &bounds, 1.0);
        let mut most = 0.0_f32;
        for turned in cameras(camera, 12) {
            for corner in bounds.corners() {
                let at = turned.pixel(corner, Vec2::splat(100.0)).unwrap();
                most = most.max((at - Vec2::splat(50.0)).abs().max_element());
            }
        }
        // Of 50 pixels from the middle to the edge.
        assert!((40.0..=50.0).contains(&most), "{most}");
    }
}
