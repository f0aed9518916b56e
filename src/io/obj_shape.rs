//! What an `.obj` file says of a shape, and the mesh that follows.

use super::diagnostic::Warnings;
use super::mtl::{self, Libraries};
use super::obj_faces::{Corner, Faces};
use super::scanner::STRETCH;
use super::{Diagnostic, Files, Imported, Position};
use crate::geometry::{self, Material, MaterialGroup, Mesh, MeshBuilder, Triangulator};
use crate::steps::Pace;
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;
use std::iter::Peekable;
use std::ops::Range;
use std::path::Path;
use std::slice;

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
        let (mut data, mut faces) = (self.data, self.faces);
        let all = data.positions.len();
        faces.keep_used(&mut data.positions);
        let unused = all - data.positions.len();
        if unused > 0 {
            let are = if unused == 1 { "is" } else { "are" };
            let text = format!("{unused} of its {all} vertices {are} in no face, and left out");
            warnings.push_with(|| Diagnostic::new(path, text));
        }
        let mesh = data.mesh(faces, &self.uses, &of_names, pace).await;
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
    /// The mesh of `faces`, which use all positions; `materials` are those that `uses` name.
    async fn mesh(
        self,
        faces: Faces,
        uses: &[Use],
        materials: &[Option<&Material>],
        pace: &Pace,
    ) -> Mesh {
        pace.after(STRETCH).await;
        let mut assembly = Assembly {
            builder: MeshBuilder::over(self.positions),
            texture: &self.texture,
            normals: &self.normals,
            faces: &faces,
            uses: uses.iter().peekable(),
            materials,
            group: None,
            cutter: Triangulator::default(),
            triangles: Vec::new(),
        };
        for stretch in faces.stretches() {
            pace.tell(stretch.start as f32 / faces.count() as f32);
            assembly.take(stretch);
            pace.after(STRETCH).await;
        }
        assembly.finish()
    }
}

/// A mesh that is put together from faces.
struct Assembly<'a> {
    builder: MeshBuilder,
    texture: &'a [Vec2],
    normals: &'a [Vec3],
    faces: &'a Faces,
    /// Those that come after the faces so far.
    uses: Peekable<slice::Iter<'a, Use>>,
    materials: &'a [Option<&'a Material>],
    /// The group of the faces that come next, with its end still open.
    group: Option<MaterialGroup>,
    cutter: Triangulator,
    /// Room for the triangles of one face.
    triangles: Vec<[Corner; 3]>,
}

impl Assembly<'_> {
    /// Adds some faces, those that come next. This is no asynchronous function because what lives across
    /// an `await` is kept in memory, with which a large file takes a sixth longer.
    fn take(&mut self, faces: Range<usize>) {
        for index in faces {
            let mut latest = None;
            while let Some(next) = self.uses.next_if(|next| next.faces_before <= index) {
                latest = Some(self.materials[next.name]);
            }
            if let Some(material) = latest {
                self.switch_to(material);
            }
            let positions = self.builder.positions();
            self.faces
                .cut(index, positions, &mut self.cutter, |corners| {
                    self.triangles.push(corners);
                });
            for corners in self.triangles.drain(..) {
                let corners = corners.map(|corner| resolved(corner, self.texture, self.normals));
                let has_normals = corners.iter().all(|corner| corner.normal.is_some());
                self.builder
                    .push_triangle(corners.map(|corner| geometry::Corner {
                        normal: corner.normal.filter(|_| has_normals),
                        ..corner
                    }));
            }
        }
    }

    fn switch_to(&mut self, material: Option<&Material>) {
        let known = self.group.as_ref().map(|group| &group.material.name);
        if known != material.map(|material| &material.name) {
            self.close();
            let start = self.builder.triangle_count();
            self.group = material.map(|material| MaterialGroup {
                triangles: start..start,
                material: material.clone(),
            });
        }
    }

    /// Ends the group at the triangles so far.
    fn close(&mut self) {
        if let Some(group) = self.group.take() {
            let triangles = group.triangles.start..self.builder.triangle_count();
            self.builder
                .push_group(MaterialGroup { triangles, ..group });
        }
    }

    fn finish(mut self) -> Mesh {
        self.close();
        self.builder.build()
    }
}

/// What `corner` names.
fn resolved(corner: Corner, texture: &[Vec2], normals: &[Vec3]) -> geometry::Corner {
    let normal = corner.normal.map(|at| normals[at as usize]);
    geometry::Corner {
        position: corner.position,
        normal: normal.filter(|&normal| normal != Vec3::ZERO),
        texture: corner.texture.map(|at| texture[at as usize]),
    }
}
