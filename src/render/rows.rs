use glam::{DMat4, DVec3, DVec4, Mat4};

/// A horizontal plane as rows of a picture show it, by a camera that does not roll.
pub(super) struct Rows {
    world_from_clip: DMat4,
    height: f64,
    size: [u32; 2],
}

impl Rows {
    /// The plane at `height` in the world.
    pub fn new(clip_from_world: Mat4, height: f32, size: [u32; 2]) -> Self {
        Self {
            world_from_clip: clip_from_world.as_dmat4().inverse(),
            height: f64::from(height),
            size,
        }
    }

    /// Length in the world that is a pixel wide in `row`; `None` where the plane is not seen.
    pub fn world_per_pixel(&self, row: u32) -> Option<f64> {
        let middle = f64::from(self.size[0] / 2);
        let length = (self.point(middle, row)? - self.point(middle + 1.0, row)?).length();
        (length.is_finite() && length > 0.0).then_some(length)
    }

    fn point(&self, column: f64, row: u32) -> Option<DVec3> {
        let [width, height] = self.size.map(f64::from);
        let x = 2.0 * (column + 0.5) / width - 1.0;
        let y = 2.0 * (f64::from(row) + 0.5) / height - 1.0;
        let unproject = |depth: f64| {
            let world = self.world_from_clip * DVec4::new(x, y, depth, 1.0);
            world.truncate() / world.w
        };
        let (near, far) = (unproject(-1.0), unproject(1.0));
        let along = (self.height - near.y) / (far.y - near.y);
        (along >= 0.0).then(|| near + (far - near) * along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use glam::camera::rh::{proj::opengl, view};

    #[test]
    fn a_row_shows_a_plane_the_larger_the_nearer_it_is() {
        let eye = Vec3::new(0.0, 2.0, 5.0);
        let view = view::look_at_mat4(eye, Vec3::ZERO, Vec3::Y);
        let clip_from_world = opengl::perspective(1.0, 2.0, 0.1, 100.0) * view;
        let rows = Rows::new(clip_from_world, 0.0, [200, 100]);
        // The middle row shows the target: 2 · distance · tan(0.5) over 100 rows.
        let expected = 2.0 * f64::from(eye.length()) * 0.5f64.tan() / 100.0;
        let found = rows.world_per_pixel(50).unwrap();
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
        assert!(rows.world_per_pixel(0).unwrap() < found);
        assert_eq!(rows.world_per_pixel(99), None, "above the horizon");
    }
}
