//! Outlines of marked shapes.

use super::area::Area;
use super::batches::Batch;
use super::curve_pass::draw_curve_mask;
use super::edge_pass::{Edge, EdgePass};
use super::frame::{Frame, PassContext};
use super::mesh_cache::MeshCache;
use super::mesh_programs::MeshPrograms;
use super::shown_triangles::Purpose;
use super::skeleton_pass::SkeletonPass;
use crate::gpu::{DepthTest, DrawState, Framebuffer, Gl, GpuError, Immediate};
use crate::scene::{EvaluatedShape, ModelDisplay, Shape, ShapeId, ShapeKind, SurfaceVisibility};
use glam::Vec3;

const ACTIVE: Vec3 = Vec3::new(1.0, 0.62, 0.11);
/// Color of shapes that are selected with the active one.
const OTHERS: Vec3 = Vec3::new(0.86, 0.36, 0.05);
/// Width of the line in pixels of a picture 800 high or less.
const WIDTH: u32 = 2;

/// Draws a line round the selected shape and the one under the pointer, also where something hides
/// them: their pixels are first drawn as a mask, whose edge is then drawn over the picture.
#[derive(Debug)]
pub(super) struct OutlinePass {
    masks: MeshPrograms,
    edges: EdgePass,
    mask: Option<Framebuffer>,
}

impl OutlinePass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        Ok(Self {
            masks: MeshPrograms::new(gl, "mask", include_str!("../../shaders/mask_fragment.glsl")),
            edges: EdgePass::new(gl)?,
            mask: None,
        })
    }

    /// Compiles the programs for skinned meshes.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.masks.add_skinned(gl)
    }

    pub fn draw(
        &mut self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
        lines: (&mut SkeletonPass, &mut Immediate),
        target: &Framebuffer,
    ) -> Result<(), GpuError> {
        let marks = &frame.marks;
        if marks.selected.is_none() && marks.hovered.is_none() {
            return Ok(());
        }
        let (width, height) = (context.width, context.height);
        let mask = Framebuffer::fitting(&mut self.mask, gl, width, height)?;
        mask.clear([0.0; 4]);
        let flat = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(width, height)
        };
        flat.apply(gl);
        // Selected shapes come after the hovered one and the active one comes last, so that they keep their
        // pixels where they overlap others.
        let hovered = marks.hovered.map(|id| (id, Vec3::Y));
        let others = marks.also_selected.iter().map(|&id| (id, Vec3::Z));
        let selected = others.chain(marks.selected.map(|id| (id, Vec3::X)));
        let mut covered = Area::EMPTY;
        for (id, color) in hovered.into_iter().chain(selected) {
            let shape = frame.scene.shape(id).zip(frame.evaluated.shape(id));
            if let Some((shape, evaluated)) = shape {
                covered = covered.union(area(context, shape, evaluated));
            }
            draw_mask(
                &self.masks,
                context,
                frame,
                meshes,
                (&mut *lines.0, &mut *lines.1),
                id,
                color,
            )?;
        }
        let edge = Edge {
            selected: ACTIVE,
            hovered: context.colors.hovered,
            other: OTHERS,
            width: (WIDTH * context.tile.whole.1.div_ceil(800)).min(6),
        };
        self.edges.draw(gl, mask, covered, &edge, target)
    }
}

/// The pixels outside of which the mask of a shape is empty.
fn area(context: &PassContext, shape: &Shape, evaluated: &EvaluatedShape) -> Area {
    let size = [context.width, context.height];
    // Lines and joints are drawn beyond the mesh.
    let is_mesh = match &shape.kind {
        ShapeKind::Character(character) => character.display.mode != ModelDisplay::Skeleton,
        ShapeKind::Curve(_) => false,
        _ => true,
    };
    if !is_mesh {
        return Area::whole(size);
    }
    let corners = evaluated.world_box().corners();
    Area::around(&corners, context.clip_from_world, size)
}

fn draw_mask(
    masks: &MeshPrograms,
    context: &PassContext,
    frame: &Frame,
    meshes: &MeshCache,
    (skeletons, immediate): (&mut SkeletonPass, &mut Immediate),
    id: ShapeId,
    color: Vec3,
) -> Result<(), GpuError> {
    let (Some(shape), Some(evaluated)) = (
        frame.scene.shape(id),
        frame.evaluated.shape(id).filter(|shape| shape.visible),
    ) else {
        return Ok(());
    };
    if let ShapeKind::Character(character) = &shape.kind
        && character.display.mode == ModelDisplay::Skeleton
    {
        return skeletons.draw_mask(context, evaluated, color);
    }
    if let ShapeKind::Curve(curve) = &shape.kind {
        draw_curve_mask(immediate, context, evaluated, color);
        if curve.display.surface != SurfaceVisibility::Shaded {
            return Ok(());
        }
    }
    if let Some(batch) = Batch::of(shape, evaluated, meshes, Purpose::Mask) {
        let program = masks.of(batch.mesh);
        meshes.place(program, &batch);
        program.set_mat4("clip_from_world", context.clip_from_world);
        program.set_vec3("color", color);
        batch.mesh.draw_whole(program, Purpose::Mask, 1);
    }
    Ok(())
}
