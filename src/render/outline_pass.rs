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
use crate::scene::{
    CurveVisibility, EvaluatedShape, ModelDisplay, Shape, ShapeKind, SurfaceVisibility,
};
use glam::Vec3;
use std::ops::Range;

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

    /// Draws the lines round the marked shapes of `frame` into `target`.
    pub fn draw(
        &mut self,
        gl: &Gl,
        (context, frame, meshes): (&PassContext, &Frame, &MeshCache),
        lines: (&mut SkeletonPass, &mut Immediate),
        target: &Framebuffer,
    ) -> Result<(), GpuError> {
        if !has_outlines(frame) {
            return Ok(());
        }
        let mut kept = self.mask.take();
        let mask = Framebuffer::fitting(&mut kept, gl, context.width, context.height)?;
        mask.clear([0.0; 4]);
        let scene = (context, frame, meshes);
        self.draw_mask(gl, scene, lines, mask, 0..u64::MAX)?;
        self.draw_lines_round(gl, (context, frame), mask, target)?;
        self.mask = kept;
        Ok(())
    }

    /// Adds some of the triangles of the marked shapes to `mask`, which is as large as what is drawn: those within
    /// `triangles`, counted shape by shape, with one for the lines of each. Returns their number.
    pub fn draw_mask(
        &self,
        gl: &Gl,
        (context, frame, meshes): (&PassContext, &Frame, &MeshCache),
        (skeletons, immediate): (&mut SkeletonPass, &mut Immediate),
        mask: &Framebuffer,
        triangles: Range<u64>,
    ) -> Result<u64, GpuError> {
        mask.bind();
        let flat = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(context.width, context.height)
        };
        flat.apply(gl);
        let mut first = 0;
        for (shape, evaluated, color) in marked(frame) {
            if triangles.contains(&first) {
                match &shape.kind {
                    ShapeKind::Character(character)
                        if character.display.mode == ModelDisplay::Skeleton =>
                    {
                        skeletons.draw_mask(context, frame, evaluated, color)?;
                    }
                    // A line round curves would cover their frames; their control points show which ones are selected.
                    ShapeKind::Curve(curve)
                        if curve.display.curve != CurveVisibility::OnWithFrames =>
                    {
                        draw_curve_mask(immediate, context, evaluated, color);
                    }
                    _ => {}
                }
            }
            first += 1;
            let batch =
                has_surface(shape).then(|| Batch::of(shape, evaluated, meshes, Purpose::Mask));
            if let Some(batch) = batch.flatten() {
                let all = batch.triangles().end;
                let before = |end: u64| end.saturating_sub(first).min(all.into()) as u32;
                let part = before(triangles.start)..before(triangles.end);
                first += u64::from(all);
                if part.is_empty() {
                    continue;
                }
                let program = self.masks.of(batch.mesh);
                meshes.place(program, &batch);
                program.set_mat4("clip_from_world", context.clip_from_world);
                program.set_vec3("color", color);
                batch.mesh.draw(program, Purpose::Mask, part, 1);
            }
        }
        Ok(first)
    }

    /// Draws the lines round what `mask` covers into `target`.
    pub fn draw_lines_round(
        &mut self,
        gl: &Gl,
        (context, frame): (&PassContext, &Frame),
        mask: &Framebuffer,
        target: &Framebuffer,
    ) -> Result<(), GpuError> {
        let areas = marked(frame).map(|(shape, evaluated, _)| area(context, shape, evaluated));
        let covered = areas.fold(Area::EMPTY, Area::union);
        let edge = Edge {
            selected: ACTIVE,
            hovered: context.colors.hovered,
            other: OTHERS,
            width: (WIDTH * context.tile.whole.1.div_ceil(800)).min(6),
        };
        self.edges.draw(gl, mask, covered, &edge, target)
    }
}

/// Whether there are lines round shapes.
pub(super) fn has_outlines(frame: &Frame) -> bool {
    let marks = &frame.marks;
    marks.selected.is_some() || marks.hovered.is_some()
}

/// The shapes that lines are drawn round, in the order of their masks, with the color in these.
fn marked<'a>(frame: &'a Frame) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape, Vec3)> {
    let marks = &frame.marks;
    // Selected shapes come after the hovered one and the active one comes last, so that they keep their
    // pixels where they overlap others.
    let hovered = marks.hovered.map(|id| (id, Vec3::Y));
    let others = marks.also_selected.iter().map(|&id| (id, Vec3::Z));
    let selected = others.chain(marks.selected.map(|id| (id, Vec3::X)));
    let all = hovered.into_iter().chain(selected);
    all.filter_map(|(id, color)| {
        let evaluated = frame.evaluated.shape(id).filter(|shape| shape.visible)?;
        Some((frame.scene.shape(id)?, evaluated, color))
    })
}

fn has_surface(shape: &Shape) -> bool {
    match &shape.kind {
        ShapeKind::Character(character) => character.display.mode != ModelDisplay::Skeleton,
        ShapeKind::Curve(curve) => curve.display.surface == SurfaceVisibility::Shaded,
        _ => true,
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
