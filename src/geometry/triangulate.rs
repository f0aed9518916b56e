use glam::{Vec2, Vec3};

/// A polygon with more corners becomes a fan: the time of the search for ears grows with the cube
/// of their number.
const MOST_CORNERS: usize = 512;
/// The most corners that the search for ears looks at, over all polygons of a mesh: about a
/// second.
const MOST_WORK: usize = 1_000_000_000;

/// Cuts polygons into triangles in bounded time: when a mesh has spent its share of work, the rest
/// of its concave polygons become fans.
#[derive(Debug)]
pub struct Triangulator {
    /// How many corners may still be looked at.
    left: usize,
}

impl Default for Triangulator {
    fn default() -> Self {
        Self { left: MOST_WORK }
    }
}

impl Triangulator {
    /// Cuts a polygon into triangles that wind as it does, as indices into `corners`: two fewer
    /// than corners, none below three, and every corner in one of them. A convex polygon becomes a
    /// fan around its first corner. Others, concave or not quite flat, are cut ear by ear in the
    /// plane of their mean normal (Meisters 1975); where no ear is left, as in a polygon that
    /// crosses itself, the rest becomes a fan.
    pub fn cut(&mut self, corners: &[Vec3]) -> Vec<[usize; 3]> {
        let count = corners.len();
        let mut left: Vec<usize> = (0..count).collect();
        let mut triangles = Vec::with_capacity(count.saturating_sub(2));
        if (4..=MOST_CORNERS).contains(&count) && self.left > 0 {
            let flat = in_their_plane(corners);
            let is_concave = |left: &[usize]| (0..left.len()).any(|at| turn(&flat, left, at) < 0.0);
            while left.len() > 3 && self.left > 0 && is_concave(&left) {
                let ear = (0..left.len()).find(|&at| is_ear(&flat, &left, at));
                // For each candidate all others were looked at, at most.
                let asked = ear.map_or(left.len(), |ear| ear + 1);
                self.left = self.left.saturating_sub(asked * left.len());
                let Some(ear) = ear else { break };
                triangles.push(around(&left, ear));
                left.remove(ear);
            }
        }
        triangles.extend((2..left.len()).map(|at| [left[0], left[at - 1], left[at]]));
        triangles
    }
}

/// The corners in their plane, as seen from the side where they wind counter-clockwise.
fn in_their_plane(corners: &[Vec3]) -> Vec<Vec2> {
    let first = corners[0];
    let doubled_area = (2..corners.len())
        .map(|at| (corners[at - 1] - first).cross(corners[at] - first))
        .sum::<Vec3>();
    let normal = doubled_area.normalize_or(Vec3::Z);
    let (u, v) = normal.any_orthonormal_pair();
    corners
        .iter()
        .map(|&corner| Vec2::new((corner - first).dot(u), (corner - first).dot(v)))
        .collect()
}

/// The corner `at` of those `left`, between its neighbors.
fn around(left: &[usize], at: usize) -> [usize; 3] {
    let count = left.len();
    [
        left[(at + count - 1) % count],
        left[at],
        left[(at + 1) % count],
    ]
}

/// Positive where the polygon turns left at a corner.
fn turn(flat: &[Vec2], left: &[usize], at: usize) -> f32 {
    let [a, b, c] = around(left, at).map(|corner| flat[corner]);
    (b - a).perp_dot(c - b)
}

/// Whether the triangle at a corner can be cut off: it turns left and no other corner is in it.
fn is_ear(flat: &[Vec2], left: &[usize], at: usize) -> bool {
    let indices = around(left, at);
    let [a, b, c] = indices.map(|corner| flat[corner]);
    let inside = |p: Vec2| {
        // A corner that lies where one of the triangle's does is no obstacle.
        p != a
            && p != b
            && p != c
            && (b - a).perp_dot(p - a) >= 0.0
            && (c - b).perp_dot(p - b) >= 0.0
            && (a - c).perp_dot(p - c) >= 0.0
    };
    turn(flat, left, at) > 0.0
        && !left
            .iter()
            .any(|corner| !indices.contains(corner) && inside(flat[*corner]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangulate(corners: &[Vec3]) -> Vec<[usize; 3]> {
        Triangulator::default().cut(corners)
    }

    fn area(corners: &[Vec3], triangles: &[[usize; 3]]) -> f32 {
        let doubled = |[a, b, c]: [Vec3; 3]| (b - a).cross(c - a).length();
        let triangles = triangles.iter().map(|t| doubled(t.map(|i| corners[i])));
        triangles.sum::<f32>() * 0.5
    }

    #[test]
    fn a_convex_polygon_becomes_a_fan() {
        let square = [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Y, Vec3::Y];
        assert_eq!(triangulate(&square), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(triangulate(&square[..3]), [[0, 1, 2]]);
        assert!(triangulate(&square[..2]).is_empty());
    }

    #[test]
    fn a_dented_quad_is_cut_through_its_dent_whichever_corner_comes_first() {
        let quad = [
            Vec3::new(0.0, 2.0, 1.0),
            Vec3::new(-1.0, -1.0, 1.0),
            Vec3::new(0.0, 0.0, 1.0),
            Vec3::new(1.0, -1.0, 1.0),
        ];
        for first in 0..4 {
            let corners: Vec<Vec3> = (0..4).map(|i| quad[(first + i) % 4]).collect();
            let triangles = triangulate(&corners);
            assert_eq!(triangles.len(), 2);
            let area = area(&corners, &triangles);
            assert!((area - 2.0).abs() < 1e-6, "{first} {area}");
        }
    }

    #[test]
    fn a_letter_u_keeps_its_area_and_its_side() {
        let u = [
            (0, 0),
            (3, 0),
            (3, 3),
            (2, 3),
            (2, 1),
            (1, 1),
            (1, 3),
            (0, 3),
        ];
        let corners = u.map(|(x, z)| Vec3::new(x as f32, 5.0, -z as f32));
        let triangles = triangulate(&corners);
        assert_eq!(triangles.len(), 6);
        assert!((area(&corners, &triangles) - 7.0).abs() < 1e-5);
        for triangle in triangles {
            let [a, b, c] = triangle.map(|i| corners[i]);
            assert!((b - a).cross(c - a).y > 0.0);
        }
    }

    #[test]
    fn no_polygon_loses_a_triangle_however_bad() {
        let crossed = [Vec3::ZERO, Vec3::ONE, Vec3::X, Vec3::Y];
        for bad in [&crossed[..], &[Vec3::ZERO; 6][..], &[Vec3::NAN; 5][..]] {
            assert_eq!(triangulate(bad).len(), bad.len() - 2);
        }
        let circle = |i: usize| Vec3::new((i as f32).cos(), (i as f32).sin(), 0.0);
        let star: Vec<Vec3> = (0..2000).map(circle).collect();
        assert_eq!(triangulate(&star).len(), 1998);
    }

    #[test]
    fn polygons_become_fans_once_the_work_is_spent() {
        let dented = [(0.0, 2.0), (-1.0, -1.0), (0.0, 0.0), (1.0, -1.0)];
        let dented = dented.map(|(x, y)| Vec3::new(x, y, 0.0));
        let turned: Vec<Vec3> = (1..5).map(|at| dented[at % 4]).collect();
        let mut triangulator = Triangulator { left: 3 };
        assert_eq!(triangulator.cut(&turned), triangulate(&turned));
        assert_ne!(triangulate(&turned), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(triangulator.cut(&turned), [[0, 1, 2], [0, 2, 3]]);
    }

    /// Twice the area of a triangle seen from +Z, negative if it is seen from behind.
    fn doubled_area([a, b, c]: [Vec3; 3]) -> f32 {
        (b - a).cross(c - a).z
    }

    #[test]
    fn a_concave_polygon_that_is_not_flat_keeps_its_outline_and_its_side() {
        // The letter L, corners up to 0.2 off its plane, in every order of its corners.
        let outline = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)];
        let heights = [0.0, 0.2, -0.1, 0.1, 0.0, -0.2];
        for first in 0..6 {
            let corners: Vec<Vec3> = (0..6)
                .map(|i| (first + i) % 6)
                .map(|i| Vec3::new(outline[i].0 as f32, outline[i].1 as f32, heights[i]))
                .collect();
            let triangles = triangulate(&corners);
            let areas = triangles
                .iter()
                .map(|t| doubled_area(t.map(|i| corners[i])));
            let areas: Vec<f32> = areas.collect();
            assert_eq!(areas.len(), 4);
            assert!(areas.iter().all(|&area| area > 0.1), "{first} {areas:?}");
            let area = areas.iter().sum::<f32>() / 2.0;
            assert!((area - 3.0).abs() < 1e-5, "{first} {area}");
        }
    }

    #[test]
    fn a_bent_quad_is_cut_between_its_first_and_third_corner() {
        let quad = [
            Vec3::ZERO,
            Vec3::new(1.0, 0.0, 0.4),
            Vec3::new(1.0, 1.0, 0.0),
            Vec3::Y,
        ];
        for first in 0..4 {
            let corners: Vec<Vec3> = (0..4).map(|i| quad[(first + i) % 4]).collect();
            assert_eq!(triangulate(&corners), [[0, 1, 2], [0, 2, 3]], "{first}");
        }
    }

    #[test]
    fn corners_on_a_straight_edge_stay_corners_of_triangles() {
        // An L whose long edges have corners in their middles, where neighbors may join them.
        let outline = [
            (0, 0),
            (1, 0),
            (2, 0),
            (2, 1),
            (1, 1),
            (1, 2),
            (0, 2),
            (0, 1),
        ];
        let corners = outline.map(|(x, y)| Vec3::new(x as f32, y as f32, 0.0));
        let triangles = triangulate(&corners);
        assert_eq!(triangles.len(), 6);
        for corner in 0..8 {
            assert!(triangles.iter().any(|t| t.contains(&corner)), "{corner}");
        }
        assert!((area(&corners, &triangles) - 3.0).abs() < 1e-5);
    }

    #[test]
    fn the_search_for_ears_has_a_bound_for_each_polygon_and_for_all() {
        let comb = |count: usize| -> Vec<Vec3> {
            let tooth = |i: usize| {
                Vec3::new(
                    i as f32,
                    if i.is_multiple_of(2) { 1000.0 } else { 1.0 },
                    0.0,
                )
            };
            (0..count).rev().map(tooth).chain([Vec3::ZERO]).collect()
        };
        let mut triangulator = Triangulator::default();
        assert_eq!(triangulator.cut(&comb(100_000)).len(), 99_999);
        assert_eq!(triangulator.left, MOST_WORK, "too large to search");
        triangulator.left = 1_000_000;
        for _ in 0..20 {
            assert_eq!(triangulator.cut(&comb(511)).len(), 510);
        }
        assert_eq!(triangulator.left, 0);
    }
}
