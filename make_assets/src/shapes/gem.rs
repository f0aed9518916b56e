//! A gem with the facets of the brilliant cut.
use super::Shape;
use glam::DVec3;
use std::f64::consts::TAU;

/// A gem in the round brilliant cut: table, star, bezel and girdle facets above, pavilion below.
pub fn gem() -> String {
    let mut shape = Shape::default();
    let ring = |shape: &mut Shape, radius: f64, y: f64, turn: f64| {
        shape.ring(8, |a| {
            let a = -a + turn * TAU / 8.0;
            DVec3::new(radius * a.cos(), y, radius * a.sin())
        })
    };
    let table = ring(&mut shape, 0.28, 0.20, 0.0);
    let middle = ring(&mut shape, 0.406, 0.133, 0.5);
    let upper: Vec<usize> = shape.ring(16, |a| DVec3::new(0.5 * a.cos(), 0.035, -0.5 * a.sin()));
    let lower: Vec<usize> = shape.ring(16, |a| DVec3::new(0.5 * a.cos(), 0.0, -0.5 * a.sin()));
    let culet = shape.vertex(DVec3::new(0.0, -0.43, 0.0));
    let (cos, fall) = ((TAU / 16.0).cos(), 0.43);
    // The pavilion's lower girdle facets end on the ridges between the mains.
    let ridge = ring(&mut shape, 0.5 * 0.28 / cos, -fall * 0.72, 0.5);
    shape.face("", &table);
    shape.band("", &lower, &upper);
    for i in 0..8 {
        // `middle` runs with a turn of half a step the other way: its i-th lies before table i.
        let (here, next) = (middle[i], middle[(i + 1) % 8]);
        let girdle = |k: usize| upper[k % 16];
        let g = 2 * i;
        shape.face("", &[table[(i + 7) % 8], here, table[i]]);
        shape.face("", &[table[i], here, girdle(g), next]);
        shape.face("", &[here, girdle(g + 15), girdle(g)]);
        shape.face("", &[next, girdle(g), girdle(g + 1)]);
        let low = |k: usize| lower[k % 16];
        shape.face("", &[culet, ridge[(i + 1) % 8], low(g), ridge[i]]);
        shape.face("", &[ridge[i], low(g), low(g + 15)]);
        shape.face("", &[ridge[(i + 1) % 8], low(g + 1), low(g)]);
    }
    shape.text("Gem: round brilliant cut", None)
}
