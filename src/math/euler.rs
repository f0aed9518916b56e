use glam::{DMat3, DVec3, EulerRot, Mat3, Mat4, Vec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Cosine of the angle about Y below which the axes of the rotations about X and Z coincide to
/// within single precision: gimbal lock.
const LOCKED: f64 = 1e-6;
/// Decimals beyond these make no other `f32`, unless the number is all but 0.
const MOST_DECIMALS: usize = 12;

/// Euler angles in radians: the rotation `Rx · Ry · Rz` of column vectors, so Z turns first and X
/// last (assignment, "Sliders").
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct Euler {
    /// Angles about X, Y and Z, radians.
    pub radians: Vec3,
}

impl Euler {
    /// No rotation.
    pub const ZERO: Self = Self {
        radians: Vec3::ZERO,
    };

    /// Angles in radians about X, Y and Z.
    pub fn from_radians(radians: Vec3) -> Self {
        Self { radians }
    }

    /// Angles in degrees about X, Y and Z, the unit of files and panels.
    pub fn from_degrees(degrees: Vec3) -> Self {
        Self {
            radians: degrees * (std::f32::consts::PI / 180.0),
        }
    }

    /// Degrees about X, Y and Z.
    pub fn degrees(self) -> Vec3 {
        self.radians * (180.0 / std::f32::consts::PI)
    }

    /// Degrees about X, Y and Z, of each angle the number with the fewest digits that is read as the same angle; the nearest
    /// one where rounding lets no number of degrees be read as it.
    pub fn shortest_degrees(self) -> Vec3 {
        Vec3::from(self.radians.to_array().map(|radians| {
            let degrees = f64::from(radians).to_degrees();
            let read = |degrees: f32| Self::from_degrees(Vec3::splat(degrees)).radians.x;
            (0..MOST_DECIMALS)
                .filter_map(|decimals| format!("{degrees:.decimals$}").parse().ok())
                .find(|&short| read(short) == radians)
                .unwrap_or(degrees as f32)
        }))
    }

    /// Degrees wrapped into 0..360, as the panel shows them.
    pub fn wrapped_degrees(self) -> Vec3 {
        self.degrees().map(wrap_degrees)
    }

    /// The rotation `Rx · Ry · Rz`.
    pub fn to_mat3(self) -> Mat3 {
        Mat3::from_euler(
            EulerRot::XYZ,
            self.radians.x,
            self.radians.y,
            self.radians.z,
        )
    }

    /// Angles of `rotation` (without scale or mirroring) that are nearest to `to`, so that the
    /// angles in a panel do not jump. Of all angles of that rotation these have the smallest sum of
    /// squared changes, in gimbal lock too. `to` itself if `rotation` is not finite.
    pub fn nearest(rotation: Mat3, to: Self) -> Self {
        if !rotation.is_finite() {
            return to;
        }
        let from = to.radians.as_dvec3();
        Self::from_radians(nearest_angles(rotation.as_dmat3(), from).as_vec3())
    }

    /// The rotation `Rx · Ry · Rz` in double precision: chains of joints add up what each is off by.
    pub fn to_dmat3(self) -> DMat3 {
        let [x, y, z] = self.radians.as_dvec3().to_array();
        DMat3::from_euler(EulerRot::XYZ, x, y, z)
    }

    /// 1 if a small turn about `axis`, in the space that these angles turn into, makes the angle
    /// larger that it changes most, or else -1.
    pub fn sign_of_turn(self, axis: Vec3) -> f32 {
        let about_x = Mat3::from_rotation_x(self.radians.x);
        let about_z = self.to_mat3() * Vec3::Z;
        let along = [Vec3::X, about_x * Vec3::Y, about_z].map(|own| own.dot(axis));
        let most = along.into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs()));
        most.map_or(1.0, f32::signum)
    }

    /// The rotation `Rx · Ry · Rz` without translation.
    pub fn to_mat4(self) -> Mat4 {
        Mat4::from_mat3(self.to_mat3())
    }
}

fn nearest_angles(m: DMat3, to: DVec3) -> DVec3 {
    let at = |row: usize, column: usize| m.col(column)[row];
    let cos_y = at(0, 0).hypot(at(0, 1));
    if cos_y < LOCKED {
        return nearest_when_locked(at(0, 2) > 0.0, at(1, 0).atan2(at(1, 1)), to);
    }
    let x = (-at(1, 2)).atan2(at(2, 2));
    let y = at(0, 2).atan2(cos_y);
    // Close to gimbal lock x is not well known; z makes up for what it is off by.
    let (sin, cos) = x.sin_cos();
    let z = (cos * at(1, 0) + sin * at(2, 0)).atan2(cos * at(1, 1) + sin * at(2, 1));
    let one = near(DVec3::new(x, y, z), to);
    let other = near(DVec3::new(x + PI, PI - y, z + PI), to);
    if one.distance_squared(to) <= other.distance_squared(to) {
        one
    } else {
        other
    }
}

/// Nearest angles at y = ±90°, where only the sum of the other two (at −90° z less x) matters:
/// `together`.
fn nearest_when_locked(upper: bool, together: f64, to: DVec3) -> DVec3 {
    let sign = if upper { 1.0 } else { -1.0 };
    let half = wrap_half(together - (to.z + sign * to.x)) * 0.5;
    let y = to.y + wrap_half(sign * FRAC_PI_2 - to.y);
    DVec3::new(to.x + sign * half, y, to.z + half)
}

/// `angles`, each moved by whole turns as near to `to` as possible.
fn near(angles: DVec3, to: DVec3) -> DVec3 {
    to + (angles - to).map(wrap_half)
}

/// Wraps an angle into −π..π.
fn wrap_half(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Wraps an angle in degrees into 0..360; an angle that rounding would show as 360 becomes 0.
fn wrap_degrees(degrees: f32) -> f32 {
    let wrapped = degrees.rem_euclid(360.0);
    if wrapped > 359.999_95 { 0.0 } else { wrapped }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_is_rx_times_ry_times_rz() {
        let euler = Euler::from_degrees(Vec3::new(30.0, -70.0, 145.0));
        let [x, y, z] = euler.radians.to_array();
        let expected =
            Mat3::from_rotation_x(x) * Mat3::from_rotation_y(y) * Mat3::from_rotation_z(z);
        assert!(euler.to_mat3().abs_diff_eq(expected, 1e-6));
    }

    /// The smallest sum of squared changes that any of the equivalent angles on a fine grid of
    /// lock-free candidates needs.
    fn least_change(m: Mat3, to: Vec3) -> f32 {
        let (x, y, z) = m.to_euler(EulerRot::XYZ);
        let turns = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|turn: f32| turn * std::f32::consts::TAU);
        let pi = std::f32::consts::PI;
        let mut least = f32::INFINITY;
        for base in [Vec3::new(x, y, z), Vec3::new(x + pi, pi - y, z + pi)] {
            let change = base - to;
            let best = |d: f32| {
                turns
                    .map(|turn| (d + turn).abs())
                    .into_iter()
                    .fold(9.0, f32::min)
            };
            least = least.min(change.map(best).length_squared());
        }
        least
    }

    #[test]
    fn the_nearest_angles_mean_the_same_rotation_and_none_are_nearer() {
        let mut state = 7_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32 * 12.0 - 6.0
        };
        for _ in 0..2000 {
            let angles = Vec3::new(random(), random(), random());
            let shown = Euler::from_radians(Vec3::new(random(), random(), random()));
            let rotation = Euler::from_radians(angles).to_mat3();
            let found = Euler::nearest(rotation, shown);
            assert!(
                found.to_mat3().abs_diff_eq(rotation, 2e-6),
                "{angles} {shown:?}"
            );
            let change = (found.radians - shown.radians).length_squared();
            let least = least_change(rotation, shown.radians);
            assert!(
                change <= least + 1e-3,
                "{angles} {shown:?}: {change} and not {least}"
            );
        }
    }

    #[test]
    fn angles_that_already_mean_the_rotation_stay_as_they_are() {
        for degrees in [
            [350.0, 100.0, -200.0],
            [12.0, 90.0, 40.0],
            [12.0, -90.0, 40.0],
        ] {
            let shown = Euler::from_degrees(Vec3::from(degrees));
            let found = Euler::nearest(shown.to_mat3(), shown);
            assert!(
                found.degrees().abs_diff_eq(shown.degrees(), 0.05),
                "{degrees:?} {found:?}"
            );
        }
    }

    #[test]
    fn in_gimbal_lock_the_change_is_shared_by_x_and_z() {
        for y in [90.0, -90.0, 270.0] {
            let rotation = Euler::from_degrees(Vec3::new(10.0, y, 70.0)).to_mat3();
            let shown = Euler::from_degrees(Vec3::new(20.0, y, 70.0));
            let found = Euler::nearest(rotation, shown);
            assert!(
                found.to_mat3().abs_diff_eq(rotation, 2e-6),
                "{y}: {found:?}"
            );
            let change = found.degrees() - shown.degrees();
            assert!((change.x + 5.0).abs() < 0.01, "{y}: {change}");
            assert!((change.z.abs() - 5.0).abs() < 0.01, "{y}: {change}");
        }
    }

    #[test]
    fn a_turn_has_the_sign_of_the_angle_that_it_changes_most() {
        let half_turn = Euler::from_degrees(Vec3::new(180.0, 0.0, 0.0));
        for (angles, axis, expected) in [
            (Euler::ZERO, Vec3::Z, 1.0),
            (Euler::ZERO, Vec3::NEG_Z, -1.0),
            (Euler::ZERO, Vec3::new(0.5, -0.8, 0.1), -1.0),
            (half_turn, Vec3::Z, -1.0),
            (half_turn, Vec3::X, 1.0),
        ] {
            assert_eq!(angles.sign_of_turn(axis), expected, "{angles:?} {axis}");
            let turned = Mat3::from_axis_angle(axis.normalize_or(Vec3::X), 0.01) * angles.to_mat3();
            let change = Euler::nearest(turned, angles).radians - angles.radians;
            let most = change.abs().max_position();
            assert_eq!(
                change[most].signum(),
                expected,
                "{angles:?} {axis}: {change}"
            );
        }
    }

    #[test]
    fn a_rotation_that_is_not_finite_changes_no_angle() {
        let shown = Euler::from_degrees(Vec3::ONE);
        assert_eq!(Euler::nearest(Mat3::NAN, shown), shown);
    }

    #[test]
    fn degrees_that_were_typed_are_told_as_they_were() {
        let typed = Vec3::new(-50.0, 22.5, 143.91);
        let angles = Euler::from_degrees(typed);
        assert_ne!(angles.degrees(), typed);
        assert_eq!(angles.shortest_degrees(), typed);
    }

    #[test]
    fn angles_are_shown_between_0_and_360() {
        let shown = Euler::from_degrees(Vec3::new(-30.0, 725.0, 360.0)).wrapped_degrees();
        assert!(
            shown.abs_diff_eq(Vec3::new(330.0, 5.0, 0.0), 1e-3),
            "{shown}"
        );
    }

    #[test]
    fn an_angle_just_below_a_whole_turn_is_shown_as_0_and_not_as_360() {
        let shown = Euler::from_degrees(Vec3::new(-1e-5, -1e-6, -0.01)).wrapped_degrees();
        let expected = Vec3::new(0.0, 0.0, 359.99);
        assert!(shown.abs_diff_eq(expected, 1e-3), "{shown}");
    }
}
