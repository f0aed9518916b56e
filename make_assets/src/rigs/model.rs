//! What a Collada file is written from: bones, and skins made of colored faces.
use super::super::mesh::Mesh;
use super::paint::Painted;
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// A bone from its joint to its tip, at rest, in our space.
pub struct Bone {
    pub name: String,
    pub parent: Option<usize>,
    pub head: DVec3,
    pub tail: DVec3,
}

/// What a face is made of.
pub struct Material {
    pub name: &'static str,
    pub color: [f64; 3],
    /// The picture beside the file that replaces the color.
    pub texture: Option<&'static str>,
}

/// A material of one color.
pub const fn plain(name: &'static str, color: [f64; 3]) -> Material {
    Material {
        name,
        color,
        texture: None,
    }
}

/// A triangle with its material, and where its corners lie in the picture.
pub struct Face {
    pub corners: [u32; 3],
    pub material: usize,
    pub picture: Option<[DVec2; 3]>,
}

/// The joints that move a vertex, and how much; they sum to 1.
pub type Weights = Vec<(usize, f64)>;

/// A mesh bound to the bones.
pub struct Skin {
    pub name: &'static str,
    /// Faces that meet at less than this angle, in radians, are one smooth surface.
    pub crease: f64,
    pub positions: Vec<DVec3>,
    pub faces: Vec<Face>,
    pub weights: Vec<Weights>,
}

/// Which way is up in the file.
#[derive(Clone, Copy, PartialEq)]
pub enum Up {
    Y,
    Z,
}

/// A rigged character.
pub struct Rig {
    pub name: &'static str,
    pub up: Up,
    /// Meters in one unit of the file.
    pub unit: f64,
    pub bones: Vec<Bone>,
    pub materials: Vec<Material>,
    pub skins: Vec<Skin>,
}

impl Rig {
    /// A rig without bones and skins in a file with +Y up and in meters.
    pub fn new(name: &'static str, materials: Vec<Material>) -> Self {
        Self {
            name,
            up: Up::Y,
            unit: 1.0,
            bones: Vec::new(),
            materials,
            skins: Vec::new(),
        }
    }

    /// Adds a bone and tells its index.
    pub fn bone(
        &mut self,
        name: impl Into<String>,
        parent: Option<usize>,
        head: DVec3,
        tail: DVec3,
    ) -> usize {
        self.bones.push(Bone {
            name: name.into(),
            parent,
            head,
            tail,
        });
        self.bones.len() - 1
    }
}

impl Skin {
    /// Nothing yet; beveled edges will look sharp, and what is grown from a field smooth.
    pub fn new(name: &'static str) -> Self {
        Self {
            name,
            crease: 0.62,
            positions: Vec::new(),
            faces: Vec::new(),
            weights: Vec::new(),
        }
    }

    /// Adds a mesh of one material; `weights` are those of a place.
    pub fn add(&mut self, mesh: &Mesh, material: usize, weights: impl Fn(DVec3) -> Weights) {
        let base = self.positions.len() as u32;
        self.positions.extend_from_slice(&mesh.positions);
        self.weights
            .extend(mesh.positions.iter().map(|&p| weights(p)));
        self.faces.extend(mesh.triangles.iter().map(|t| Face {
            corners: t.map(|v| v + base),
            material,
            picture: None,
        }));
    }

    /// Adds a mesh whose materials and weights are given.
    pub fn add_painted(&mut self, painted: Painted) {
        self.crease = 1.2;
        let base = self.positions.len() as u32;
        self.positions.extend(painted.mesh.positions);
        self.weights.extend(painted.weights);
        let triangles = painted.mesh.triangles.into_iter().zip(painted.materials);
        self.faces.extend(triangles.map(|(t, material)| Face {
            corners: t.map(|v| v + base),
            material,
            picture: None,
        }));
    }

    /// Adds a mesh that follows one bone alone.
    pub fn add_rigid(&mut self, mesh: &Mesh, material: usize, bone: usize) {
        self.add(mesh, material, |_| vec![(bone, 1.0)]);
    }

    /// A normal for each corner of each face: the mean over the faces round the corner's place
    /// that meet this one at less than the crease's angle, by their angles there.
    pub fn normals(&self) -> Vec<[DVec3; 3]> {
        let mut around: HashMap<u32, Vec<(DVec3, f64)>> = HashMap::new();
        let own: Vec<DVec3> = self.faces.iter().map(|f| self.face_normal(f)).collect();
        for (face, &normal) in self.faces.iter().zip(&own) {
            let p = face.corners.map(|v| self.positions[v as usize]);
            for i in 0..3 {
                let (a, b) = (p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
                let angle = a.angle_between(b);
                around
                    .entry(face.corners[i])
                    .or_default()
                    .push((normal, angle));
            }
        }
        let least = self.crease.cos();
        self.faces
            .iter()
            .zip(&own)
            .map(|(face, &normal)| {
                face.corners.map(|v| {
                    let near = around[&v].iter().filter(|(n, _)| n.dot(normal) > least);
                    let sum: DVec3 = near.map(|&(n, angle)| n * angle).sum();
                    sum.normalize_or(normal)
                })
            })
            .collect()
    }

    fn face_normal(&self, face: &Face) -> DVec3 {
        let [a, b, c] = face.corners.map(|v| self.positions[v as usize]);
        (b - a).cross(c - a).normalize_or(DVec3::Y)
    }
}

/// Weights along a chain of bones: each bone owns what lies between its ends, and the border
/// between neighbors is softened over `reach` to either side. `at` runs along the chain, and bone
/// `i` of `bones` begins at `starts[i]`.
pub fn along_chain(at: f64, bones: &[usize], starts: &[f64], reach: f64) -> Weights {
    let share = |start: f64| {
        let t = ((at - start) / reach * 0.5 + 0.5).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    let mut weights: Weights = Vec::new();
    let mut above = 1.0;
    for (i, &bone) in bones.iter().enumerate() {
        let next = starts.get(i + 1).map_or(0.0, |&start| share(start));
        let mine = above - next.min(above);
        if mine > 1e-4 {
            weights.push((bone, mine));
        }
        above = next.min(above);
    }
    normalized(weights)
}

/// The same weights with a sum of 1.
pub fn normalized(mut weights: Weights) -> Weights {
    let sum: f64 = weights.iter().map(|w| w.1).sum();
    weights.iter_mut().for_each(|w| w.1 /= sum);
    weights
}
