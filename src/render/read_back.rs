//! Skinned vertices read back from the graphics card.

use super::cached_mesh::{CachedMesh, MeshKind};
use super::mesh_programs;
use super::mesh_upload::{MeshKey, MeshUpload};
use super::palettes::Palettes;
use crate::gpu::{DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive, Program};
use crate::scene::{EvaluatedShape, Shading, Skinning};
use glam::{Mat4, Vec3};
use std::collections::HashSet;
use std::rc::Rc;

const PIXELS_A_ROW: u32 = 1024;

/// Positions and normals of a character as the graphics card skins them, in model space, one pair
/// a vertex: first the vertices of its mesh in their order, then copies that facets need. A copy,
/// and with facets any vertex, has the normal of the triangle whose last corner it is
/// ([`crate::geometry::Facets`]), and zero if it is none's.
///
/// Runs the vertex shader that pictures are drawn with and reads its numbers back bit by bit, as
/// the colors of pixels, which every driver can do: tests compare skinning on the graphics card with
/// skinning on the processor by it. `None` if the graphics card does not skin the shape.
///
/// # Errors
/// As [`super::Renderer::draw`], and for more vertices than a picture has pixels.
pub fn read_back_skinning(
    gl: &Gl,
    shape: &EvaluatedShape,
    shading: Shading,
) -> Result<Option<Vec<[Vec3; 2]>>, GpuError> {
    let most_rows = gl.info().max_texture_size;
    let (geometry, skinning) = (&shape.geometry, Skinning::Gpu);
    let key = MeshKey::new(geometry, shading, skinning);
    let upload = Rc::new(MeshUpload::new(gl, &key, geometry, most_rows)?);
    let mesh = CachedMesh::new(gl, &upload, geometry, false)?;
    let vertex = match mesh.kind() {
        MeshKind::Plain => return Ok(None),
        MeshKind::Skinned => mesh_programs::SMOOTH,
        MeshKind::SkinnedFacets => mesh_programs::FACETTED,
    };
    let renamed = "#define main surface_main\n".to_owned() + vertex + "#undef main\n";
    let program = Program::new(
        gl,
        "read back",
        &(renamed + include_str!("../../shaders/read_back_vertex.glsl")),
        include_str!("../../shaders/read_back_fragment.glsl"),
    )?;
    let mut palettes = Palettes::default();
    let shape = EvaluatedShape {
        world_from_model: Mat4::IDENTITY,
        ..shape.clone()
    };
    let alone = std::iter::once((&shape, Vec3::ONE));
    palettes.update(gl, &HashSet::from([shape.id]), alone, most_rows)?;
    let instances: Vec<i32> = palettes.first_cell(shape.id).into_iter().collect();
    mesh.bind_skin(&program, &instances, &palettes);

    let count = mesh.vertex_array.vertex_count();
    let rows = count.div_ceil(PIXELS_A_ROW).max(1);
    let picture = Framebuffer::new(gl, PIXELS_A_ROW, rows, 0)?;
    program.set_mat4("clip_from_world", Mat4::IDENTITY);
    program.set_i32("pixels_a_row", PIXELS_A_ROW as i32);
    program.set_i32("rows", rows as i32);
    let mut vertices = vec![[Vec3::ZERO; 2]; count as usize];
    for component in 0..6 {
        picture.clear([0.0; 4]);
        let state = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(PIXELS_A_ROW, rows)
        };
        state.apply(gl);
        program.set_i32("component", component as i32);
        mesh.vertex_array
            .draw(&program, Primitive::Points, 0..count);
        let bytes = picture.read_rgba()?;
        // The top row is the last one.
        let pixels = bytes.chunks_exact(4 * PIXELS_A_ROW as usize).rev();
        let pixels = pixels.flat_map(|row| row.as_chunks().0);
        for (vertex, &number) in vertices.iter_mut().zip(pixels) {
            vertex[component / 3][component % 3] = f32::from_le_bytes(number);
        }
    }
    Ok(Some(vertices))
}
