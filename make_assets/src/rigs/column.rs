//! A column of six welded cubes that two bones bend.
use super::super::mesh::Mesh;
use super::model::{Rig, Skin, along_chain, plain};
use glam::DVec3;

/// The edge of a cube, and how many there are.
const EDGE: f64 = 0.3;
const CUBES: usize = 6;
/// How far edges are beveled.
const BEVEL: f64 = 0.022;

pub fn rig() -> Rig {
    let mut rig = Rig::new(
        "Column",
        vec![
            plain("Teal", [0.05, 0.42, 0.46]),
            plain("Pale teal", [0.24, 0.66, 0.66]),
            plain("Orange", [0.93, 0.47, 0.12]),
            plain("Pale orange", [0.98, 0.70, 0.36]),
        ],
    );
    let at = |cube: usize| DVec3::Y * EDGE * (cube as f64 - CUBES as f64 / 2.0);
    let lower = rig.bone("Lower", None, at(0), at(CUBES / 2));
    let upper = rig.bone("Upper", Some(lower), at(CUBES / 2), at(CUBES));
    let mut skin = Skin::new("Cubes");
    for cube in 0..CUBES {
        let (bottom, top) = (at(cube).y, at(cube + 1).y);
        let material = cube % 2 + if cube < CUBES / 2 { 0 } else { 2 };
        let mesh = cube_of_rings(bottom, top, cube == 0, cube == CUBES - 1);
        skin.add(&mesh, material, |p| {
            along_chain(p.y, &[lower, upper], &[at(0).y, at(CUBES / 2).y], 0.34)
        });
    }
    rig.skins.push(skin);
    rig
}

/// A cube between two heights, cut into rings so that it can bend. Its beveled rims meet those of
/// its neighbors in a groove; only the first and the last cube have a lid.
fn cube_of_rings(bottom: f64, top: f64, floor: bool, lid: bool) -> Mesh {
    const RINGS: usize = 5;
    let half = EDGE / 2.0;
    let mut rings = vec![(bottom, half - BEVEL)];
    for i in 0..=RINGS {
        let t = i as f64 / RINGS as f64;
        rings.push((bottom + BEVEL + (top - bottom - 2.0 * BEVEL) * t, half));
    }
    rings.push((top, half - BEVEL));
    let mut mesh = Mesh::default();
    let outline = outline();
    let sides = outline.len() as u32;
    for &(y, half) in &rings {
        let inner = half - BEVEL;
        let place = |&(corner, out): &(DVec3, DVec3)| corner * inner + out * BEVEL + DVec3::Y * y;
        mesh.positions.extend(outline.iter().map(place));
    }
    for ring in 0..rings.len() as u32 - 1 {
        for side in 0..sides {
            let (a, b) = (ring * sides + side, ring * sides + (side + 1) % sides);
            mesh.triangles
                .extend([[a, b, b + sides], [a, b + sides, a + sides]]);
        }
    }
    let last = (rings.len() as u32 - 1) * sides;
    for side in 1..sides - 1 {
        if floor {
            mesh.triangles.push([0, side + 1, side]);
        }
        if lid {
            mesh.triangles.push([last, last + side, last + side + 1]);
        }
    }
    mesh
}

/// A square with rounded corners, counter-clockwise seen from above: for each point its corner's
/// signs, and the direction from the corner's center.
fn outline() -> Vec<(DVec3, DVec3)> {
    const STEPS: usize = 3;
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)];
    let mut points = Vec::new();
    for (quarter, (x, z)) in signs.into_iter().enumerate() {
        for step in 0..=STEPS {
            let turn = quarter as f64 + step as f64 / STEPS as f64;
            let (sin, cos) = (turn * std::f64::consts::FRAC_PI_2).sin_cos();
            points.push((DVec3::new(x, 0.0, z), DVec3::new(sin, 0.0, cos)));
        }
    }
    points
}
