//! Shapes to import: a gear of polygons, a cut gem, and a potted plant with materials and normals.
mod gear;
mod gem;
mod plant;

pub use gear::gear;
pub use gem::gem;
pub use plant::{plant, plant_materials};

use super::text::number;
use glam::DVec3;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Faces with any number of corners, grouped by material.
#[derive(Default)]
struct Shape {
    positions: Vec<DVec3>,
    /// Material and corners; empty names mean none.
    faces: Vec<(&'static str, Vec<usize>)>,
    smooth: bool,
}

impl Shape {
    fn vertex(&mut self, p: DVec3) -> usize {
        self.positions.push(p);
        self.positions.len() - 1
    }

    fn face(&mut self, material: &'static str, corners: &[usize]) {
        self.faces.push((material, corners.to_vec()));
    }

    /// Quads between two closed rings of equal length; the first runs counter-clockwise seen from
    /// the side that the second lies on.
    fn band(&mut self, material: &'static str, below: &[usize], above: &[usize]) {
        let n = below.len();
        for i in 0..n {
            let j = (i + 1) % n;
            self.face(material, &[below[i], below[j], above[j], above[i]]);
        }
    }

    fn ring(&mut self, n: usize, at: impl Fn(f64) -> DVec3) -> Vec<usize> {
        (0..n)
            .map(|i| self.vertex(at(TAU * i as f64 / n as f64)))
            .collect()
    }

    /// The file's text; `library` names a material file.
    fn text(&self, title: &str, library: Option<&str>) -> String {
        let mut text = format!("# {title}\n");
        if let Some(library) = library {
            let _ = writeln!(text, "mtllib {library}");
        }
        let triple = |p: DVec3, n: usize| p.to_array().map(|c| number(c, n)).join(" ");
        for &p in &self.positions {
            let _ = writeln!(text, "v {}", triple(p, 5));
        }
        if self.smooth {
            for n in self.normals() {
                let _ = writeln!(text, "vn {}", triple(n, 4));
            }
        }
        let mut current = "";
        for (material, corners) in &self.faces {
            if *material != current {
                current = material;
                let _ = writeln!(text, "usemtl {material}");
            }
            text.push('f');
            for corner in corners {
                let i = corner + 1;
                let _ = if self.smooth {
                    write!(text, " {i}//{i}")
                } else {
                    write!(text, " {i}")
                };
            }
            text.push('\n');
        }
        text
    }

    /// Normals of the vertices: the mean of the faces around, by area.
    fn normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (_, corners) in &self.faces {
            let p = |i: usize| self.positions[corners[i]];
            let area: DVec3 = (1..corners.len() - 1)
                .map(|i| (p(i) - p(0)).cross(p(i + 1) - p(0)))
                .sum();
            corners.iter().for_each(|&c| sums[c] += area);
        }
        sums.into_iter().map(|n| n.normalize_or(DVec3::Y)).collect()
    }
}
