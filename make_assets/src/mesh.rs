//! Triangle meshes on the way from a field to a file.
use glam::DVec3;

/// A triangle mesh; corners counter-clockwise seen from outside.
#[derive(Clone, Default)]
pub struct Mesh {
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The three corners of a triangle.
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.positions[v as usize])
    }

    /// Adds all of another mesh.
    pub fn append(&mut self, other: &Mesh) {
        let base = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        let moved = other.triangles.iter().map(|t| t.map(|v| v + base));
        self.triangles.extend(moved);
    }
}

/// A mesh made of a half and its reflection in the plane x = 0.
pub struct Mirrored {
    pub mesh: Mesh,
    /// For each vertex the index of its reflection; its own where it lies in the plane.
    pub twin: Vec<u32>,
}

/// Completes a half that is open along x = 0 by its reflection, sharing the vertices there.
pub fn mirror(half: &Mesh) -> Mirrored {
    let mut mesh = half.clone();
    let mut twin: Vec<u32> = (0..half.positions.len() as u32).collect();
    for (v, p) in half.positions.iter().enumerate() {
        if p.x != 0.0 {
            let new = mesh.positions.len() as u32;
            mesh.positions.push(DVec3::new(-p.x, p.y, p.z));
            twin[v] = new;
            twin.push(v as u32);
        }
    }
    for t in &half.triangles {
        let [a, b, c] = t.map(|v| twin[v as usize]);
        mesh.triangles.push([a, c, b]);
    }
    Mirrored { mesh, twin }
}
