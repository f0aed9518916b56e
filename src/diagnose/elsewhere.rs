//! Pictures that show the right silhouette, but elsewhere, in another size or turned, as through another camera.

use super::formula::Formula;
use super::model::Model;
use super::picture_search::points;
use super::silhouette::{DRAWN, Samples, Silhouette};
use super::skin::Skinner;
use crate::character::Pose;
use crate::geometry::Picture;
use glam::DMat4;

/// How the exact silhouette, which is seen with `clip_from_model`, is placed in `picture`, in words; `None` if it is not there.
pub(super) fn find(
    model: &Model<'_>,
    pose: &Pose,
    picture: &Picture,
    clip_from_model: DMat4,
) -> Option<String> {
    let points = points(&mut Skinner::new(model, pose, &Formula::default()));
    // Each pixel is a sample, so that movements are told in pixels.
    let (width, height) = (picture.width, picture.height);
    let samples = Samples::new(width, height, width.max(height));
    let exact = Silhouette::of_mesh(&points, model.triangles(), clip_from_model, samples);
    Silhouette::of_picture(picture, samples, DRAWN).placement_of(&exact)
}
