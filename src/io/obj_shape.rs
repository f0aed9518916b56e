//! What an `.obj` file says of a shape, and the mesh that follows.

use super::diagnostic::Warnings;
use super::mtl::{self, Libraries};
use super::obj::FACES;
use super::obj_faces::{Corner, Faces};
use super::scanner::STRETCH;
use super::{Diagnostic, Files, Imported, Position};
use crate::geometry::{self, Material, MaterialGroup, Mesh, MeshBuilder, Triangulator};
use crate::steps::Pace;
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;
use std::path::Path;

/// All that a file says.
pub(super) struct Shape {
    pub data: Data,
    pub faces: Faces,
    pub libraries: Libraries,
    pub materials_missing: bool,
    pub uses: Vec<Use>,
    pub names: Vec<Name>,
    pub warnings: Warnings,
    pub face_warnings: Warnings,
}

impl Shape {
    /// The mesh, with the materials of the libraries.
    pub async fn mesh(self, files: &dyn Files, path: &Path, pace: &Pace) -> Imported<Mesh> {
        let mut warnings = self.warnings;
        let (materials, material_warnings) =
            mtl::with_pictures(files, path, self.libraries.into_materials());
        let of_names = self.names.iter().map(|name| materials.get(&name.text));
        let of_names: Vec<Option<&Material>> = of_names.collect();
        let mesh = self
            .data
            .mesh(self.faces, &self.uses, &of_names, pace)
            .await;
        // If a library is missing, which has a warning of its own, so may the material be.
        if !self.materials_missing {
            let unknown = self.names.iter().zip(&of_names);
            let unknown = unknown.filter(|(_, material)| material.is_none());
            let unknown: BTreeMap<_, _> = unknown.map(|(name, _)| (&name.text, name.at)).collect();
            for (name, Position { line, column }) in unknown {
                warnings.push_with(|| Diagnostic::at(path, line, column, mtl::unknown(name)));
            }
        }
        warnings.append(self.face_warnings);
        warnings.append(material_warnings);
        Imported {
            value: mesh,
            warnings: warnings.into_vec(path),
        }
    }
}

/// A `usemtl` line.
pub(super) struct Use {
    /// Index of the material's name.
    pub name: usize,
    /// How many faces come before it.
    pub faces_before: usize,
}

/// Name of a material.
pub(super) struct Name {
    pub text: String,
    /// Where it stands first.
    pub at: Position,
}

/// The numbers that corners of faces index.
#[derive(Default)]
pub(super) struct Data {
    pub positions: Vec<Vec3>,
    pub texture: Vec<Vec2>,
    /// Of unit length; zero for one without a direction.
    pub normals: Vec<Vec3>,
}

impl Data {
    /// The mesh of `faces`; `materials` are those that `uses` name.
    async fn mesh(
        mut self,
        mut faces: Faces,
        uses: &[Use],
        materials: &[Option<&Material>],
        pace: &Pace,
    ) -> Mesh {
        faces.keep_used(&mut self.positions);
        pace.after(STRETCH).await;
        let mut builder = MeshBuilder::over(std::mem::take(&mut self.positions));
        let mut cutter = Triangulator::default();
        let mut uses = uses.iter().peekable();
        let mut group: Option<MaterialGroup> = None;
        let mut triangles = Vec::new();
        for (index, face) in faces.iter().enumerate() {
            if index > 0 && index.is_multiple_of(FACES) {
                pace.tell(index as f32 / faces.count() as f32);
                pace.after(STRETCH).await;
            }
            let mut latest = None;
            while let Some(next) = uses.next_if(|next| next.faces_before <= index) {
                latest = Some(materials[next.name]);
            }
            if let Some(material) = latest {
                let known = group.as_ref().map(|group| &group.material.name);
                if known != material.map(|material| &material.name) {
                    close(&mut builder, group.take());
                    let start = builder.triangle_count();
                    group = material.map(|material| MaterialGroup {
                        triangles: start..start,
                        material: material.clone(),
                    });
                }
            }
            faces.cut(face, builder.positions(), &mut cutter, |corners| {
                triangles.push(corners);
            });
            for corners in triangles.drain(..) {
                let corners = corners.map(|corner| self.corner(corner));
                let has_normals = corners.iter().all(|corner| corner.normal.is_some());
                builder.push_triangle(corners.map(|corner| geometry::Corner {
                    normal: corner.normal.filter(|_| has_normals),
                    ..corner
                }));
            }
        }
        close(&mut builder, group);
        builder.build()
    }

    fn corner(&self, corner: Corner) -> geometry::Corner {
        let normal = corner.normal.map(|at| self.normals[at as usize]);
        geometry::Corner {
            position: corner.position,
            normal: normal.filter(|&normal| normal != Vec3::ZERO),
            texture: corner.texture.map(|at| self.texture[at as usize]),
        }
    }
}

/// Ends `group` at the triangles so far.
fn close(builder: &mut MeshBuilder, group: Option<MaterialGroup>) {
    if let Some(group) = group {
        let triangles = group.triangles.start..builder.triangle_count();
        builder.push_group(MaterialGroup { triangles, ..group });
    }
}
