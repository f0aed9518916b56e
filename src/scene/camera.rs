use super::ViewDirection;
use crate::math::Ray;
use glam::camera::rh::{proj::opengl, view};
use glam::{Mat4, Vec2, Vec3, Vec4};
use std::f32::consts::FRAC_PI_2;

/// Camera that looks at a target from a distance: `eye = target + r (cosφ cosθ, sinφ, cosφ sinθ)`,
/// +Y up. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Camera {
    /// Point that it looks at, in the world.
    pub target: Vec3,
    /// Distance of the eye from the target.
    pub radius: f32,
    /// Angle about +Y, from +X towards +Z, radians.
    pub theta: f32,
    /// Angle above the horizontal plane, radians.
    pub phi: f32,
    /// Vertical field of view, radians.
    pub fovy: f32,
    /// Distance of the near plane.
    pub near: f32,
    /// Distance of the far plane.
    pub far: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: Vec3::ZERO,
            radius: 5.0,
            theta: FRAC_PI_2,
            phi: 0.0,
            fovy: 45.0_f32.to_radians(),
            near: 0.1,
            far: 100.0,
        }
    }
}

impl Camera {
    /// The camera with which the Virtual Mannequin starts: at (0, 0, -6), looking at the origin.
    pub fn of_mannequin() -> Self {
        Self {
            radius: 6.0,
            theta: -FRAC_PI_2,
            far: 1000.0,
            ..Self::default()
        }
    }

    /// One of the six views of the View menu: target at the origin, distance 5.
    pub fn preset(direction: ViewDirection) -> Self {
        let (theta, phi) = direction.angles();
        Self {
            theta,
            phi,
            ..Self::default()
        }
    }

    /// The camera that options and files describe by three numbers, THETA, PHI and RADIUS, or by six
    /// with the target TX, TY, TZ; angles in degrees.
    ///
    /// # Errors
    /// If there are more or fewer numbers, one is not finite, or the radius is not above 0.
    pub fn from_numbers(numbers: &[f32]) -> Result<Self, String> {
        let (theta, phi, radius, target) = match *numbers {
            [theta, phi, radius] => (theta, phi, radius, Vec3::ZERO),
            [theta, phi, radius, x, y, z] => (theta, phi, radius, Vec3::new(x, y, z)),
            _ => {
                let found = numbers.len();
                return Err(format!(
                    "expected three numbers THETA, PHI, RADIUS or six with TX, TY, TZ, found {found}"
                ));
            }
        };
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(format!("expected finite numbers, found {number}"));
        }
        if radius <= 0.0 {
            return Err(format!("expected a distance above 0, found {radius}"));
        }
        Ok(Self {
            target,
            radius,
            theta: theta.to_radians(),
            phi: phi.to_radians(),
            ..Self::default()
        })
    }

    /// The same camera turned to look from `direction`, with target and distance kept.
    pub fn looking_from(self, direction: ViewDirection) -> Self {
        let (theta, phi) = direction.angles();
        Self { theta, phi, ..self }
    }

    /// Unit vector from the target to the eye.
    pub(super) fn outward(&self) -> Vec3 {
        let (sin_theta, cos_theta) = self.theta.sin_cos();
        let (sin_phi, cos_phi) = self.phi.sin_cos();
        Vec3::new(cos_phi * cos_theta, sin_phi, cos_phi * sin_theta)
    }

    /// Unit vector to the right of the picture. It follows from θ alone and so is defined at the
    /// poles too.
    pub fn right(&self) -> Vec3 {
        Vec3::new(self.theta.sin(), 0.0, -self.theta.cos())
    }

    /// Unit vector to the top of the picture, in the world.
    pub fn up(&self) -> Vec3 {
        self.outward().cross(self.right())
    }

    /// Position of the eye, in the world.
    pub fn eye(&self) -> Vec3 {
        self.target + self.outward() * self.radius
    }

    /// Matrix from the world to the eye's space (x right, y up, looking along −z).
    pub fn view_from_world(&self) -> Mat4 {
        view::look_at_mat4(self.eye(), self.target, self.up())
    }

    /// Matrix from the eye's space to clip space; `aspect` is width over height of the picture.
    pub fn clip_from_view(&self, aspect: f32) -> Mat4 {
        opengl::perspective(self.fovy, aspect, self.near, self.far)
    }

    /// Matrix from the world to clip space; `aspect` is width over height of the picture.
    pub fn clip_from_world(&self, aspect: f32) -> Mat4 {
        self.clip_from_view(aspect) * self.view_from_world()
    }

    /// Ray, in the world, through a point of the picture: `pixel` from the top left, in a picture
    /// of `size` pixels. Starts at the eye; its direction has unit length.
    pub fn ray(&self, pixel: Vec2, size: Vec2) -> Ray {
        let half_height = (self.fovy * 0.5).tan();
        let x = (2.0 * pixel.x / size.x - 1.0) * half_height * size.x / size.y;
        let y = (1.0 - 2.0 * pixel.y / size.y) * half_height;
        let direction = self.right() * x + self.up() * y - self.outward();
        Ray {
            origin: self.eye(),
            direction: direction.normalize_or(-self.outward()),
        }
    }

    /// Position of a point of the world in a picture of `size` pixels, from the top left; `None`
    /// behind the eye.
    pub fn pixel(&self, world: Vec3, size: Vec2) -> Option<Vec2> {
        let clip: Vec4 = self.clip_from_world(size.x / size.y) * world.extend(1.0);
        (clip.w > 0.0).then(|| {
            let ndc = clip.truncate() / clip.w;
            Vec2::new((ndc.x + 1.0) * 0.5 * size.x, (1.0 - ndc.y) * 0.5 * size.y)
        })
    }

    /// Distance of a point of the world from the eye along the direction of view; negative behind
    /// the eye.
    pub fn depth(&self, world: Vec3) -> f32 {
        (self.eye() - world).dot(self.outward())
    }

    /// Whether a point of the world lies between the near and the far plane.
    pub fn is_in_depth(&self, world: Vec3) -> bool {
        (self.near..=self.far).contains(&self.depth(world))
    }

    /// Unit vector from the eye into the picture.
    pub fn forward(&self) -> Vec3 {
        -self.outward()
    }

    /// Length of a pixel, in the world, at the depth of `world`, in a picture `height` pixels high;
    /// `None` for a point nearer than the near plane.
    pub fn world_per_pixel(&self, world: Vec3, height: f32) -> Option<f32> {
        let depth = self.depth(world);
        (depth > self.near).then(|| self.pixel_at_depth(depth, height))
    }

    /// Length of a pixel, in the world, at a distance from the eye along the direction of view, in
    /// a picture `height` pixels high.
    pub(super) fn pixel_at_depth(&self, depth: f32, height: f32) -> f32 {
        2.0 * (self.fovy * 0.5).tan() * depth / height
    }

    /// The point of the world under a pixel that is as far away as the target, along the direction of view.
    pub fn point_at_target(&self, pixel: Vec2, size: Vec2) -> Vec3 {
        let ray = self.ray(pixel, size);
        ray.at(self.radius / self.depth(ray.at(1.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_through_a_pixel_comes_back_to_that_pixel() {
        let size = Vec2::new(800.0, 600.0);
        for direction in ViewDirection::ALL {
            let camera = Camera {
                target: Vec3::new(0.3, -0.2, 0.7),
                ..Camera::preset(direction)
            };
            for pixel in [Vec2::ZERO, Vec2::new(13.0, 577.0), size * 0.5] {
                let ray = camera.ray(pixel, size);
                let back = camera.pixel(ray.at(3.7), size).unwrap();
                assert!(
                    back.abs_diff_eq(pixel, 1e-2),
                    "{direction:?} {pixel} {back}"
                );
            }
        }
    }

    #[test]
    fn seen_from_above_and_below_plus_x_is_to_the_right() {
        for direction in [
            ViewDirection::PlusY,
            ViewDirection::MinusY,
            ViewDirection::PlusZ,
        ] {
            let camera = Camera::preset(direction);
            let pixel = camera.pixel(Vec3::X, Vec2::new(800.0, 600.0)).unwrap();
            assert!(pixel.x > 450.0, "{direction:?} {pixel}");
        }
    }
}
