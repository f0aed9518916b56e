//! A tiny painter: a lit ball beside a slab, so that nothing is symmetric.

use editor_core::geometry::Picture;
use glam::Vec3;

pub const WIDTH: u32 = 160;
pub const HEIGHT: u32 = 120;

/// What to paint. Lengths in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    pub background: [u8; 3],
    pub center: [f32; 2],
    pub radius: f32,
    pub color: Vec3,
    pub toward_light: Vec3,
    /// Strength of the white highlight.
    pub specular: f32,
    /// Its exponent: the smaller, the wider.
    pub shininess: i32,
    /// Facets a half turn; 0 for a smooth ball.
    pub facets: u32,
    pub slab: bool,
    /// Samples a side in each pixel.
    pub samples: u32,
}

pub const SCENE: Scene = Scene {
    background: [26, 26, 26],
    center: [70.0, 55.0],
    radius: 34.0,
    color: Vec3::new(0.65, 0.35, 0.25),
    toward_light: Vec3::new(0.48, 0.64, 0.6),
    specular: 0.6,
    shininess: 20,
    facets: 0,
    slab: true,
    samples: 1,
};

impl Scene {
    pub fn paint(&self) -> Picture {
        let mut rgba = Vec::new();
        for y in 0..HEIGHT {
            for x in 0..WIDTH {
                let samples = (0..self.samples)
                    .flat_map(|row| (0..self.samples).map(move |column| [column, row]));
                let sum: Vec3 = samples
                    .map(|at| {
                        let [dx, dy] = at.map(|at| (at as f32 + 0.5) / self.samples as f32);
                        self.color_at(x as f32 + dx, y as f32 + dy)
                    })
                    .sum();
                let color = 255.0 * sum / (self.samples * self.samples) as f32;
                rgba.extend(
                    color
                        .round()
                        .clamp(Vec3::ZERO, Vec3::splat(255.0))
                        .to_array()
                        .map(|c| c as u8),
                );
                rgba.push(255);
            }
        }
        Picture {
            width: WIDTH,
            height: HEIGHT,
            rgba,
        }
    }

    fn color_at(&self, x: f32, y: f32) -> Vec3 {
        let (dx, dy) = (
            (x - self.center[0]) / self.radius,
            (self.center[1] - y) / self.radius,
        );
        let beyond = 1.0 - dx * dx - dy * dy;
        if beyond > 0.0 {
            return self.lit(Vec3::new(dx, dy, beyond.sqrt()));
        }
        if self.slab && (20.0..50.0).contains(&x) && (92.0..104.0).contains(&y) {
            return Vec3::new(0.2, 0.3, 0.7);
        }
        Vec3::from(self.background.map(f32::from)) / 255.0
    }

    fn lit(&self, normal: Vec3) -> Vec3 {
        let normal = self.faceted(normal);
        let diffuse = 0.2 + 0.8 * normal.dot(self.toward_light).max(0.0);
        let reflected = 2.0 * normal.dot(self.toward_light) * normal - self.toward_light;
        let specular = self.specular * reflected.z.max(0.0).powi(self.shininess);
        self.color * diffuse + Vec3::splat(specular)
    }

    fn faceted(&self, normal: Vec3) -> Vec3 {
        if self.facets == 0 {
            return normal;
        }
        let step = std::f32::consts::PI / self.facets as f32;
        let snap = |angle: f32| ((angle / step).floor() + 0.5) * step;
        let (up, around) = (snap(normal.y.asin()), snap(normal.x.atan2(normal.z)));
        Vec3::new(up.cos() * around.sin(), up.sin(), up.cos() * around.cos())
    }
}

/// The picture with the color of each pixel changed.
pub fn recolored(picture: &Picture, change: impl Fn([u8; 4]) -> [u8; 4]) -> Picture {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    Picture {
        rgba: pixels.iter().flat_map(|&pixel| change(pixel)).collect(),
        ..*picture
    }
}

/// The picture with each pixel taken from another column and row.
pub fn rearranged(picture: &Picture, source: impl Fn(u32, u32) -> (u32, u32)) -> Picture {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let places = (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y)));
    Picture {
        rgba: places
            .flat_map(|(x, y)| {
                let (x, y) = source(x, y);
                pixels[(y * picture.width + x) as usize]
            })
            .collect(),
        ..*picture
    }
}
