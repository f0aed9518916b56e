//! Meshes with fewer triangles, for pictures that are seen for a moment.

use super::{MaterialGroup, Mesh, Normals};
use glam::{IVec2, IVec3, Vec3};
use std::collections::HashMap;

/// Cells into which texture coordinates are divided in either direction: vertices that lie in different places of a
/// picture are not merged.
const PICTURE_CELLS: f32 = 8.0;

/// A mesh with fewer triangles, whose vertices are some of those of another one.
#[derive(Clone, Debug, PartialEq)]
pub struct CoarseMesh {
    /// The mesh, which has no seams: each of its vertices has a position of its own.
    pub mesh: Mesh,
    /// For each of its positions, the index of the same one in the other mesh.
    pub positions: Vec<u32>,
}

impl CoarseMesh {
    /// About one of `fewer` triangles of `mesh`: all vertices within a cell of a grid become the one that is nearest to
    /// their mean, and the triangles that have more than one corner left in a cell go. Vertices stay apart if their
    /// positions have different labels, `label_of` by the index of the position, if they face different ways, or if
    /// they lie in different places of a picture. `None` for a mesh without an area.
    ///
    /// Source: J. Rossignac and P. Borrel, "Multi-resolution 3D Approximations for Rendering Complex Scenes", 1993,
    /// with a vertex of the mesh in place of the mean, so that joints move it as they do there.
    pub fn new(mesh: &Mesh, fewer: u32, label_of: impl Fn(u32) -> u32) -> Option<Self> {
        let triangle_area = area(mesh) / mesh.triangles.len() as f32;
        // Two triangles for each cell that the surface passes through.
        let side = (2.0 * triangle_area * fewer as f32).sqrt();
        if !side.is_normal() {
            return None;
        }
        let origin = mesh.bounds().min;
        let place = |position: u32| mesh.positions[position as usize];
        let mut cells = HashMap::new();
        let mut sums: Vec<(Vec3, f32)> = Vec::new();
        let merged: Vec<u32> = (mesh.position_of_vertices().enumerate())
            .map(|(vertex, position)| {
                let cell = Cell {
                    at: ((place(position) - origin) / side).as_ivec3(),
                    label: label_of(position),
                    facing: facing(mesh, vertex),
                    in_picture: in_picture(mesh, vertex),
                };
                let cell = *cells.entry(cell).or_insert(sums.len());
                match sums.get_mut(cell) {
                    Some((sum, count)) => (*sum, *count) = (*sum + place(position), *count + 1.0),
                    None => sums.push((place(position), 1.0)),
                }
                cell as u32
            })
            .collect();
        // For each cell the vertex that is nearest to the mean so far, its position, and how far it is from there.
        let mut kept = vec![(0, 0, f32::INFINITY); sums.len()];
        for ((vertex, position), &cell) in mesh.position_of_vertices().enumerate().zip(&merged) {
            let (sum, count) = sums[cell as usize];
            let off = place(position).distance_squared(sum / count);
            let nearest = &mut kept[cell as usize];
            if off < nearest.2 {
                *nearest = (vertex, position, off);
            }
        }
        let corners = mesh.vertex_triangles().iter().zip(0_u32..);
        let (triangles, numbers): (Vec<[u32; 3]>, Vec<u32>) = corners
            .map(|(triangle, number)| (triangle.map(|vertex| merged[vertex as usize]), number))
            .filter(|([a, b, c], _)| a != b && b != c && c != a)
            .unzip();
        let before = |end: usize| numbers.partition_point(|&number| (number as usize) < end);
        let groups = mesh.groups.iter().map(|group| MaterialGroup {
            triangles: before(group.triangles.start)..before(group.triangles.end),
            material: group.material.clone(),
        });
        let of_vertices = kept.iter().map(|&(vertex, ..)| vertex);
        let positions: Vec<u32> = kept.iter().map(|&(_, position, _)| position).collect();
        let coarse = Mesh {
            positions: positions.iter().map(|&at| place(at)).collect(),
            triangles,
            normals: match &mesh.normals {
                Normals::Flat => Normals::Flat,
                Normals::PerVertex(normals) => {
                    Normals::PerVertex(of_vertices.clone().map(|vertex| normals[vertex]).collect())
                }
            },
            seams: None,
            texture_coordinates: match &*mesh.texture_coordinates {
                [] => Vec::new(),
                coordinates => of_vertices.map(|vertex| coordinates[vertex]).collect(),
            },
            groups: groups.collect(),
        };
        Some(Self {
            mesh: coarse,
            positions,
        })
    }
}

/// What vertices that become one have in common.
#[derive(PartialEq, Eq, Hash)]
struct Cell {
    at: IVec3,
    label: u32,
    facing: usize,
    in_picture: IVec2,
}

fn area(mesh: &Mesh) -> f32 {
    let double = mesh.triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|corner| mesh.positions[corner as usize]);
        (b - a).cross(c - a).length()
    });
    double.sum::<f32>() / 2.0
}

/// The side of a cube that a vertex faces; 0 for all where triangles are flat. The two sides of a thin sheet stay
/// apart so.
fn facing(mesh: &Mesh, vertex: usize) -> usize {
    let Normals::PerVertex(normals) = &mesh.normals else {
        return 0;
    };
    let normal: Vec3 = normals[vertex];
    let axis = normal.abs().max_position();
    axis * 2 + usize::from(normal[axis] < 0.0)
}

fn in_picture(mesh: &Mesh, vertex: usize) -> IVec2 {
    let coordinates = mesh.texture_coordinates.get(vertex);
    coordinates.map_or(IVec2::ZERO, |at| (*at * PICTURE_CELLS).floor().as_ivec2())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Material, Poles, sphere};

    fn ball() -> Mesh {
        sphere(1.0, 200, 100, Poles::Y)
    }

    #[test]
    fn a_coarse_mesh_has_fewer_triangles_and_the_shape_of_the_other() {
        for fewer in [2, 8, 32] {
            let ball = ball();
            let coarse = CoarseMesh::new(&ball, fewer, |_| 0).unwrap();
            let share = ball.triangles.len() as f64 / coarse.mesh.triangles.len() as f64;
            let wanted = f64::from(fewer);
            assert!(
                (wanted / 2.0..wanted * 2.0).contains(&share),
                "{share} of {fewer}"
            );
            for (at, &of) in coarse.mesh.positions.iter().zip(&coarse.positions) {
                assert_eq!(*at, ball.positions[of as usize]);
            }
            // Chords of the cells, which are up to a fifth of the radius wide, are shorter than arcs by 2 %; folds add.
            let kept = area(&coarse.mesh) / area(&ball);
            assert!((0.9..1.1).contains(&kept), "{kept} of {fewer}");
        }
    }

    #[test]
    fn vertices_of_different_labels_or_places_of_a_picture_are_not_merged() {
        let mut ball = ball();
        let is_left =
            |mesh: &Mesh, position: u32| u32::from(mesh.positions[position as usize].x < 0.0);
        let coarse = CoarseMesh::new(&ball, 1000, |position| is_left(&ball, position)).unwrap();
        let plain = CoarseMesh::new(&ball, 1000, |_| 0).unwrap();
        assert!(coarse.positions.len() > plain.positions.len());
        ball.texture_coordinates = ball
            .positions
            .iter()
            .map(|at| at.truncate() * 20.0)
            .collect();
        let with_picture = CoarseMesh::new(&ball, 1000, |_| 0).unwrap();
        assert!(with_picture.positions.len() > 10 * plain.positions.len());
        let coordinates = &with_picture.mesh.texture_coordinates;
        for (at, coordinates) in with_picture.mesh.positions.iter().zip(coordinates) {
            assert_eq!(at.truncate() * 20.0, *coordinates);
        }
    }

    #[test]
    fn materials_keep_their_triangles() {
        let mut ball = ball();
        let count = ball.triangles.len();
        let lower = |mesh: &Mesh, triangle: &[u32; 3]| {
            triangle
                .iter()
                .all(|&corner| mesh.positions[corner as usize].y < 0.2)
        };
        let halves = ball.clone();
        ball.triangles
            .sort_by_key(|triangle| lower(&halves, triangle));
        let first = ball
            .triangles
            .partition_point(|triangle| !lower(&halves, triangle));
        let group = |triangles| MaterialGroup {
            triangles,
            material: Material {
                name: "a".to_owned(),
                color: Vec3::X,
                texture: None,
            },
        };
        ball.groups = vec![group(0..first), group(first..count)];
        let coarse = CoarseMesh::new(&ball, 8, |_| 0).unwrap().mesh;
        let [upper, below] = [0, 1].map(|at: usize| coarse.groups[at].triangles.clone());
        assert_eq!(
            (upper.start, upper.end, below.end),
            (0, below.start, coarse.triangles.len())
        );
        // As far as a vertex can go, the width of a cell.
        for triangle in &coarse.triangles[below] {
            for &corner in triangle {
                assert!(coarse.positions[corner as usize].y < 0.35);
            }
        }
        assert!(!upper.is_empty());
    }

    #[test]
    fn what_has_no_area_stays_as_it_is() {
        let flat = Mesh::new(vec![Vec3::ZERO; 3], vec![[0, 1, 2]]);
        assert_eq!(CoarseMesh::new(&flat, 8, |_| 0), None);
        assert_eq!(CoarseMesh::new(&Mesh::default(), 8, |_| 0), None);
    }
}
