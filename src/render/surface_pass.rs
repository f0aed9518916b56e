//! The surfaces of shapes, and the lights that they are drawn with.

use super::batches::{Batch, batches, parts_within};
use super::cached_mesh::CachedMesh;
use super::frame::{Frame, PassContext};
use super::mesh_cache::MeshCache;
use super::number_colors::NumberColors;
use super::shown_triangles::Purpose;
use super::surface_programs::SurfacePrograms;
use crate::geometry::Mesh;
use crate::gpu::{Blend, DepthTest, DrawState, Gl, GpuError, Program, Texture};
use crate::scene::{
    Camera, EvaluatedShape, Look, ModelDisplay, Shape, ShapeKind, SurfaceVisibility,
};
use glam::{Mat3, Mat4, Vec3};
use std::ops::Range;

/// Opacity of a mesh through which its skeleton shows.
const SEEN_THROUGH: f32 = 0.55;
/// Texture unit of a material's picture.
const PICTURE: u32 = 0;

/// Draws the surfaces of shapes.
#[derive(Debug)]
pub(super) struct SurfacePass {
    programs: SurfacePrograms,
    /// Made when first needed.
    numbers: Option<NumberColors>,
}

impl SurfacePass {
    pub fn new(gl: &Gl) -> Self {
        Self {
            programs: SurfacePrograms::new(gl),
            numbers: None,
        }
    }

    /// Compiles the programs for skinned meshes in a look.
    pub fn add_skinned(&mut self, gl: &Gl, look: Look) -> Result<(), GpuError> {
        self.programs.add_skinned(gl, look)?;
        match &mut self.numbers {
            Some(numbers) => numbers.add_skinned(gl),
            None => Ok(()),
        }
    }

    /// Compiles the programs for meshes in the colors of numbers, unless that is done.
    pub fn add_number_colors(&mut self, gl: &Gl) -> Result<(), GpuError> {
        if self.numbers.is_none() {
            self.numbers = Some(NumberColors::new(gl)?);
        }
        Ok(())
    }

    /// Draws the meshes that hide what lies behind them: of their triangles, counted mesh by mesh and as often as a
    /// mesh is drawn, those within `triangles`. Returns how many there are.
    pub fn draw_opaque(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
        triangles: Range<u64>,
    ) -> u64 {
        DrawState::opaque(context.width, context.height).apply(gl);
        self.prepare(context, frame);
        // The mannequin's bones are seen through every mesh.
        let opaque: Vec<_> = match frame.view.look {
            Look::Mannequin => surfaces(frame).collect(),
            Look::Course | Look::Studio => shapes(frame, ModelDisplay::Mesh).collect(),
        };
        let all = batches(opaque.into_iter(), meshes, Purpose::Surface);
        let (parts, count) = parts_within(all, triangles);
        for (batch, part) in parts {
            self.draw_batch(&batch, meshes, frame.view.look, (1.0, part));
        }
        count
    }

    /// Draws the meshes of characters shown together with their skeletons, which are drawn already.
    /// Depth comes first, so that only the nearest surface of each mesh is blended.
    pub fn draw_translucent(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
    ) {
        self.prepare(context, frame);
        let shapes = shapes(frame, ModelDisplay::Both);
        let single = |(shape, it)| Batch::of(shape, it, meshes, Purpose::Surface);
        for batch in shapes.filter_map(single) {
            for state in nearest_blended(context) {
                state.apply(gl);
                let opacity = (SEEN_THROUGH, batch.triangles());
                self.draw_batch(&batch, meshes, frame.view.look, opacity);
            }
        }
    }

    /// Draws a mesh that is not one of the scene's in the colors of its numbers.
    pub fn draw_numbered(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        mesh: &CachedMesh,
        world_from_model: Mat4,
    ) {
        DrawState::opaque(context.width, context.height).apply(gl);
        self.prepare(context, frame);
        if let (Some(numbers), Some(colors)) = (mesh.numbers(), &self.numbers) {
            let program = colors.program(mesh, numbers);
            program.set_mat4("world_from_model", world_from_model);
            prepare_mesh(program, mesh, world_from_model, 1.0);
            mesh.draw_whole(program, Purpose::Surface, 1);
        }
    }

    /// Draws the nearest surface of a mesh that is not one of the scene's in one color, with an
    /// opacity, in the light of the Studio look: that of the Course look leaves what is seen from behind in the dark,
    /// where nothing is seen through it.
    pub fn draw_seen_through(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        mesh: &CachedMesh,
        world_from_model: Mat4,
        (color, alpha): (Vec3, f32),
    ) {
        let program = self.programs.of(Look::Studio, false).of(mesh);
        prepare_program(program, context, frame);
        program.set_mat4("world_from_model", world_from_model);
        prepare_mesh(program, mesh, world_from_model, alpha);
        program.set_vec3("color", color);
        for state in nearest_blended(context) {
            state.apply(gl);
            mesh.draw_whole(program, Purpose::Surface, 1);
        }
    }

    fn prepare(&self, context: &PassContext, frame: &Frame) {
        let textured = has_pictures(frame).then_some(true);
        for textured in std::iter::once(false).chain(textured) {
            for program in self.programs.of(frame.view.look, textured).all() {
                prepare_program(program, context, frame);
            }
        }
        if let Some(numbers) = &self.numbers {
            numbers.prepare(context, frame);
        }
    }

    /// Draws those `triangles` of each mesh of a batch, with an opacity.
    fn draw_batch(
        &self,
        batch: &Batch,
        meshes: &MeshCache,
        look: Look,
        (alpha, triangles): (f32, Range<u32>),
    ) {
        let (mesh, copies) = (batch.mesh, batch.copies());
        let world_from_model = batch.evaluated.world_from_model;
        if let (Some(numbers), Some(colors)) = (mesh.numbers(), &self.numbers) {
            let program = colors.program(mesh, numbers);
            meshes.place(program, batch);
            prepare_mesh(program, mesh, world_from_model, alpha);
            return mesh.draw(program, Purpose::Surface, triangles, copies);
        }
        let program = |textured: bool| self.programs.of(look, textured).of(mesh);
        // The vertex shader that skins knows the color of each copy.
        let own = if mesh.is_skinned() {
            Vec3::ONE
        } else {
            batch.shape.placement.color.rgb()
        };
        let mut prepared = None;
        for part in parts(&batch.evaluated.geometry.mesh, mesh, own) {
            let first = triangles.start.max(part.triangles.start as u32);
            let own = first..triangles.end.min(part.triangles.end as u32);
            if own.is_empty() {
                continue;
            }
            let textured = part.texture.is_some();
            let program = program(textured);
            if prepared.replace(textured) != Some(textured) {
                meshes.place(program, batch);
                prepare_mesh(program, mesh, world_from_model, alpha);
            }
            program.set_vec3("color", part.color);
            if let Some(texture) = part.texture {
                texture.bind(PICTURE);
            }
            mesh.draw(program, Purpose::Surface, own, copies);
        }
    }
}

/// Sets what a program needs to know of a frame.
fn prepare_program(program: &Program, context: &PassContext, frame: &Frame) {
    program.set_mat4("clip_from_world", context.clip_from_world);
    program.set_sampler("picture", PICTURE);
    set_lights(program, &frame.view.camera);
}

/// Sets how a program draws a mesh, and how it turns the normals of one that it does not skin.
fn prepare_mesh(program: &Program, mesh: &CachedMesh, world_from_model: Mat4, alpha: f32) {
    if !mesh.is_skinned() {
        program.set_mat3("world_from_model_normal", normal_matrix(world_from_model));
    }
    program.set_i32("flat_normals", i32::from(mesh.is_flat()));
    program.set_f32("alpha", alpha);
}

/// The states in which a mesh is drawn twice, so that only its nearest surface is blended: first its
/// depth, then its color.
fn nearest_blended(context: &PassContext) -> [DrawState; 2] {
    let opaque = DrawState::opaque(context.width, context.height);
    let depth_only = DrawState {
        color_mask: [false; 4],
        ..opaque
    };
    let blended = DrawState {
        depth_test: DepthTest::LessEqual,
        depth_write: false,
        blend: Blend::Alpha,
        ..opaque
    };
    [depth_only, blended]
}

/// Transforms normals: the inverse transpose, so that they stay perpendicular to a surface that is
/// scaled unevenly.
pub(super) fn normal_matrix(world_from_model: Mat4) -> Mat3 {
    Mat3::from_mat4(world_from_model).inverse().transpose()
}

/// The shapes whose mesh is drawn, alone or together with a skeleton.
pub(super) fn surfaces<'a>(
    frame: &'a Frame,
) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)> {
    shapes(frame, ModelDisplay::Mesh).chain(shapes(frame, ModelDisplay::Both))
}

/// The shapes whose mesh is drawn in this way; all but characters count as [`ModelDisplay::Mesh`].
fn shapes<'a>(
    frame: &'a Frame,
    mode: ModelDisplay,
) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)> {
    frame.shapes().filter(move |(shape, _)| match &shape.kind {
        ShapeKind::Character(character) => character.display.mode == mode,
        ShapeKind::Curve(curve) => {
            mode == ModelDisplay::Mesh && curve.display.surface == SurfaceVisibility::Shaded
        }
        _ => mode == ModelDisplay::Mesh,
    })
}

/// Whether all that is drawn of a shape is its surface.
pub(super) fn is_surface_alone(shape: &Shape) -> bool {
    match &shape.kind {
        ShapeKind::Character(character) => character.display.mode == ModelDisplay::Mesh,
        ShapeKind::Curve(_) => false,
        _ => true,
    }
}

/// Whether a shape of `frame` may be drawn with a picture.
fn has_pictures(frame: &Frame) -> bool {
    frame.shapes().any(|(_, evaluated)| {
        let mut groups = evaluated.geometry.mesh.groups.iter();
        groups.any(|group| group.material.texture.is_some())
    })
}

/// Consecutive triangles of one color and texture.
struct Part<'a> {
    triangles: Range<usize>,
    color: Vec3,
    texture: Option<&'a Texture>,
}

/// The mesh in parts of one material each. Its color, or in place of it its picture, is tinted by the
/// shape's own color, which starts white, so that the panel's color works on every shape.
fn parts<'a>(mesh: &Mesh, cached: &'a CachedMesh, own: Vec3) -> Vec<Part<'a>> {
    let plain = |triangles| Part {
        triangles,
        color: own,
        texture: None,
    };
    let mut parts = Vec::with_capacity(mesh.groups.len() + 1);
    let mut done = 0;
    for (index, group) in mesh.groups.iter().enumerate() {
        if done < group.triangles.start {
            parts.push(plain(done..group.triangles.start));
        }
        let texture = cached.upload.textures.get(index).and_then(|t| t.as_deref());
        let material = texture.map_or(group.material.color, |_| Vec3::ONE);
        parts.push(Part {
            triangles: group.triangles.clone(),
            color: material * own,
            texture,
        });
        done = group.triangles.end;
    }
    if done < mesh.triangles.len() {
        parts.push(plain(done..mesh.triangles.len()));
    }
    parts
}

/// Position of the Course look's light in the world.
const COURSE_LIGHT: Vec3 = Vec3::new(10.0, 10.0, 30.0);
/// Position of the Mannequin look's light in the world.
pub const MANNEQUIN_LIGHT: Vec3 = Vec3::new(-10.0, 10.0, -10.0);

/// Sets the lights of a program with `surface_fragment.glsl`. The Studio look's lights turn with the
/// camera's heading, so that a character is lit well from every side.
pub(super) fn set_lights(program: &Program, camera: &Camera) {
    program.set_vec3("course_light", COURSE_LIGHT);
    program.set_vec3("mannequin_light", MANNEQUIN_LIGHT);
    program.set_vec3("eye", camera.eye());
    let right = camera.right();
    let back = right.cross(Vec3::Y);
    let direction =
        |x: f32, y: f32, z: f32| (right * x + Vec3::Y * y + back * z).normalize_or(Vec3::Y);
    program.set_vec3("key_direction", direction(-0.55, 0.8, 0.75));
    program.set_vec3("fill_direction", direction(0.9, 0.25, 0.6));
    program.set_vec3("rim_direction", direction(0.35, 0.7, -0.9));
}
