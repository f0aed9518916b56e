//! Cameras beside the one that a picture is looked at with, which show the exact figure as slight mistakes do.

use glam::{DMat4, DVec3};

/// How far such cameras are turned about the figure to either side and up and down, in degrees: of a
/// figure of the course more differed at 3 degrees than any slight mistake gives.
const TURNS: [f64; 5] = [-3.0, -1.5, 0.0, 1.5, 3.0];

/// `clip_from_model` of cameras that are turned a little about the middle of these points, in model space.
pub(super) fn turned(clip_from_model: DMat4, points: &[DVec3]) -> impl Iterator<Item = DMat4> {
    let middle = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    let right = clip_from_model.row(0).truncate().normalize_or(DVec3::X);
    let up = clip_from_model.row(1).truncate().normalize_or(DVec3::Y);
    let turns = TURNS
        .into_iter()
        .flat_map(|around| TURNS.map(|above| [around, above]));
    turns
        .filter(|turn| *turn != [0.0; 2])
        .map(move |[around, above]| {
            let around = DMat4::from_axis_angle(up, around.to_radians());
            let above = DMat4::from_axis_angle(right, above.to_radians());
            let about = DMat4::from_translation(middle);
            clip_from_model * about * above * around * DMat4::from_translation(-middle)
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec4;

    #[test]
    fn turned_cameras_have_the_middle_where_it_was() {
        // An eye at (0, 0, 5), which looks along -z, with a field of 90 degrees.
        let view = DMat4::from_translation(DVec3::NEG_Z * 5.0);
        let clip =
            DMat4::from_cols(DVec4::X, DVec4::Y, DVec4::NEG_Z - DVec4::W, DVec4::NEG_Z) * view;
        let middle = DVec3::new(0.3, -0.2, 0.4);
        let seen = |clip: DMat4, at| clip.project_point3(at).truncate();
        let cameras: Vec<DMat4> = turned(clip, &[middle - DVec3::Y, middle + DVec3::Y]).collect();
        assert_eq!(cameras.len(), 24);
        for camera in cameras {
            assert!((seen(camera, middle) - seen(clip, middle)).length() < 1e-9);
            let beside = middle + DVec3::ONE;
            assert!((seen(camera, beside) - seen(clip, beside)).length() > 1e-3);
        }
    }
}
