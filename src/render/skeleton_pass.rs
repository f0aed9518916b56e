//! Skeletons: joints as points or spheres, bones as lines or boxes.

use super::frame::{Frame, PassContext};
use super::surface_pass::set_lights;
use super::surface_programs::{LOOKS, surface_fragment};
use crate::character::StickFigure;
use crate::geometry::{
    BONE_HALF_WIDTH, Mesh, Normals, Poles, cube, cuboid_from_unit, smooth_normals, sphere,
};
use crate::gpu::{
    Attribute, Blend, Buffer, DepthTest, DrawState, Gl, GpuError, Immediate, IndexBuffer, Mode,
    PointShape, Primitive, Program, Usage, VertexArray,
};
use crate::scene::{
    BoneStyle, CharacterDisplay, EvaluatedShape, JointStyle, Look, ModelDisplay, ShapeId,
    ShapeKind, bones_in_world,
};
use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3};

/// Radius of a joint's sphere, in the character's space.
const JOINT_RADIUS: f32 = 0.02;
const SELECTED: Vec3 = Vec3::new(1.0, 0.62, 0.11);
const HOVERED: Vec3 = Vec3::new(0.1, 0.85, 1.0);

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Instance {
    /// Column by column: a `Mat4` would be padded.
    world_from_unit: [f32; 16],
    color: Vec3,
}

impl Instance {
    fn new(world_from_unit: Mat4, color: Vec3) -> Self {
        Self {
            world_from_unit: world_from_unit.to_cols_array(),
            color,
        }
    }
}

/// A unit shape drawn once for every joint, or for every bone (assignment, "Stick figure": one
/// vertex array for the joints, one for the bones).
#[derive(Debug)]
struct Instances {
    vertex_array: VertexArray,
    buffer: Buffer<Instance>,
}

/// Draws skeletons: joints as points or spheres, bones as lines or boxes.
#[derive(Debug)]
pub(super) struct SkeletonPass {
    /// One for each of [`LOOKS`].
    programs: [Program; 3],
    mask_program: Program,
    joints: Instances,
    bones: Instances,
}

impl SkeletonPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let vertex = include_str!("../../shaders/instance_vertex.glsl");
        let unit_box = cube();
        // The cube reaches ±0.5; a bone's box ±1 across and 0 to 1 along.
        let positions = unit_box
            .positions
            .iter()
            .map(|p| Vec3::new(p.x * 2.0, p.y * 2.0, p.z + 0.5));
        let unit_box = Mesh::new(positions.collect(), unit_box.triangles.clone());
        Ok(Self {
            programs: LOOKS.map(|look| {
                Program::when_used(gl, "skeleton", vertex, &surface_fragment(look, false))
            }),
            mask_program: Program::when_used(
                gl,
                "skeleton mask",
                vertex,
                include_str!("../../shaders/mask_fragment.glsl"),
            ),
            joints: Instances::new(gl, &sphere(1.0, 16, 16, Poles::Z))?,
            bones: Instances::new(gl, &unit_box)?,
        })
    }

    /// Draws the skeletons that are shown.
    pub fn draw(
        &mut self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        immediate: &mut Immediate,
    ) -> Result<(), GpuError> {
        for (shape, evaluated) in frame.shapes() {
            let ShapeKind::Character(character) = &shape.kind else {
                continue;
            };
            let Some(figure) = &evaluated.geometry.figure else {
                continue;
            };
            if character.display.mode == ModelDisplay::Mesh {
                continue;
            }
            let colors = JointColors::new(frame, shape.id, context.colors.bone);
            let world_from_model = evaluated.world_from_model;
            let blended = DrawState {
                blend: Blend::Alpha,
                ..DrawState::opaque(context.width, context.height)
            };
            blended.apply(gl);
            immediate.load_matrix(context.clip_from_world * world_from_model);
            let program = &self.programs[frame.view.look as usize];
            prepare(program, context, frame);
            if character.display.bones == BoneStyle::Lines {
                draw_bone_lines(immediate, figure, character.display, &colors);
            } else {
                let boxes = bone_boxes(figure, world_from_model, &colors);
                self.bones.draw(program, &boxes)?;
            }
            if character.display.joints == JointStyle::Points {
                draw_joint_points(immediate, figure, character.display, &colors);
            } else {
                let spheres = joint_spheres(figure, world_from_model, &colors);
                self.joints.draw(program, &spheres)?;
            }
        }
        Ok(())
    }

    /// Draws a skeleton in one color, as boxes and spheres whatever its style; in the Mannequin look the bones that are
    /// lines there.
    pub fn draw_mask(
        &mut self,
        context: &PassContext,
        frame: &Frame,
        evaluated: &EvaluatedShape,
        color: Vec3,
    ) -> Result<(), GpuError> {
        let Some(figure) = &evaluated.geometry.figure else {
            return Ok(());
        };
        self.mask_program
            .set_mat4("clip_from_world", context.clip_from_world);
        self.mask_program.set_vec3("color", color);
        if frame.view.look == Look::Mannequin {
            let bones = bones_in_world(frame.scene, evaluated);
            let boxes = bones.filter_map(|(_, start, end)| {
                let world_from_unit = cuboid_from_unit(start, end, BONE_HALF_WIDTH)?;
                Some(Instance::new(world_from_unit, Vec3::ZERO))
            });
            return self
                .bones
                .draw(&self.mask_program, &boxes.collect::<Vec<_>>());
        }
        let plain = JointColors::default();
        let world_from_model = evaluated.world_from_model;
        self.bones.draw(
            &self.mask_program,
            &bone_boxes(figure, world_from_model, &plain),
        )?;
        self.joints.draw(
            &self.mask_program,
            &joint_spheres(figure, world_from_model, &plain),
        )
    }
}

/// Sets what all skeletons of a picture share.
fn prepare(program: &Program, context: &PassContext, frame: &Frame) {
    program.set_mat4("clip_from_world", context.clip_from_world);
    program.set_vec3("color", Vec3::ONE);
    program.set_f32("alpha", 1.0);
    program.set_i32("flat_normals", 0);
    set_lights(program, &frame.view.camera);
}

impl Instances {
    fn new(gl: &Gl, mesh: &Mesh) -> Result<Self, GpuError> {
        let positions = Buffer::vertices(gl, Usage::Static, &mesh.positions)?;
        let indices = IndexBuffer::new(gl, Usage::Static, mesh.triangles.as_flattened())?;
        let buffer: Buffer<Instance> = Buffer::vertices(gl, Usage::Stream, &[])?;
        let mut builder = VertexArray::builder(gl)
            .attribute(&positions, Attribute::f32(0, 3))
            .indices(&indices)
            .attribute(
                &buffer,
                Attribute::f32(6, 3)
                    .offset(std::mem::offset_of!(Instance, color))
                    .divisor(1),
            );
        for column in 0..4 {
            let offset = column as usize * size_of::<[f32; 4]>();
            let attribute = Attribute::f32(2 + column, 4).offset(offset).divisor(1);
            builder = builder.attribute(&buffer, attribute);
        }
        // The box has its own corners on every side, so that smooth normals are flat there.
        let normals = match &mesh.normals {
            Normals::PerVertex(normals) => normals.clone(),
            Normals::Flat => smooth_normals(&mesh.positions, &mesh.triangles),
        };
        let normals = Buffer::vertices(gl, Usage::Static, &normals)?;
        builder = builder.attribute(&normals, Attribute::f32(1, 3));
        Ok(Self {
            vertex_array: builder.build()?,
            buffer,
        })
    }

    fn draw(&self, program: &Program, instances: &[Instance]) -> Result<(), GpuError> {
        if instances.is_empty() {
            return Ok(());
        }
        self.buffer.update(instances)?;
        let indices = 0..self.vertex_array.index_count();
        self.vertex_array.draw_indexed_instanced(
            program,
            Primitive::Triangles,
            indices,
            instances.len() as u32,
        );
        Ok(())
    }
}

/// Marked joints; a bone has the color of the joint that turns it.
#[derive(Clone, Copy, Debug, Default)]
struct JointColors {
    plain: Vec3,
    selected: Option<usize>,
    hovered: Option<usize>,
}

impl JointColors {
    fn new(frame: &Frame, shape: ShapeId, plain: Vec3) -> Self {
        if frame.marks.selected != Some(shape) {
            return Self {
                plain,
                ..Self::default()
            };
        }
        Self {
            plain,
            selected: frame.marks.selected_joint,
            hovered: frame.marks.hovered_joint,
        }
    }

    fn of(&self, joint: usize) -> Vec3 {
        match Some(joint) {
            joint if joint == self.hovered => HOVERED,
            joint if joint == self.selected => SELECTED,
            _ => self.plain,
        }
    }
}

fn joint_spheres(figure: &StickFigure, world: Mat4, colors: &JointColors) -> Vec<Instance> {
    figure
        .joints
        .iter()
        .enumerate()
        .map(|(joint, &at)| {
            let model_from_unit =
                Mat4::from_translation(at) * Mat4::from_scale(Vec3::splat(JOINT_RADIUS));
            Instance::new(world * model_from_unit, colors.of(joint))
        })
        .collect()
}

fn bone_boxes(figure: &StickFigure, world: Mat4, colors: &JointColors) -> Vec<Instance> {
    figure
        .bones
        .iter()
        .filter_map(|bone| {
            let model_from_unit = bone.model_from_unit(BONE_HALF_WIDTH)?;
            Some(Instance::new(
                world * model_from_unit,
                colors.of(bone.joint),
            ))
        })
        .collect()
}

fn draw_bone_lines(
    immediate: &mut Immediate,
    figure: &StickFigure,
    display: CharacterDisplay,
    colors: &JointColors,
) {
    immediate.line_width(display.line_width);
    immediate.begin(Mode::Lines);
    for bone in &figure.bones {
        immediate.color(colors.of(bone.joint));
        immediate.vertex(bone.start);
        immediate.vertex(bone.end);
    }
    immediate.end();
}

fn draw_joint_points(
    immediate: &mut Immediate,
    figure: &StickFigure,
    display: CharacterDisplay,
    colors: &JointColors,
) {
    immediate.point_size(display.point_size);
    immediate.point_shape(PointShape::SmoothDisc);
    immediate.begin(Mode::Points);
    for (joint, &at) in figure.joints.iter().enumerate() {
        immediate.color(colors.of(joint));
        immediate.vertex(at);
    }
    immediate.end();
}

const RED_BONE: Vec3 = Vec3::X;
/// Dark edge of a bone, since colors of normals may be as red, or as bright, as bones are.
const BONE_EDGE: Vec3 = Vec3::new(0.05, 0.05, 0.08);
const BONE_EDGE_WIDTH: f32 = 4.0;
const BONE_WIDTH: f32 = 2.0;
const CYAN_BONE: Vec3 = Vec3::new(0.0, 1.0, 1.0);

/// Draws the bones of characters in the Mannequin look: red lines with dark edges over everything, cyan under
/// the pointer. Where bones are hidden, only those of shown skeletons and that under the pointer are drawn.
pub(super) fn draw_mannequin_bones(
    gl: &Gl,
    context: &PassContext,
    frame: &Frame,
    immediate: &mut Immediate,
) {
    let state = DrawState {
        depth_test: DepthTest::Off,
        depth_write: false,
        ..DrawState::opaque(context.width, context.height)
    };
    state.apply(gl);
    immediate.load_matrix(context.clip_from_world);
    // The edge first, of all bones, so that none covers another.
    for (width, edge) in [(BONE_EDGE_WIDTH, Some(BONE_EDGE)), (BONE_WIDTH, None)] {
        immediate.line_width(width);
        immediate.begin(Mode::Lines);
        for (_, shape) in frame.shapes() {
            let is_selected = frame.marks.selected == Some(shape.id);
            let hovered = frame.marks.hovered_joint.filter(|_| is_selected);
            let shows_skeleton = (frame.scene.character(shape.id))
                .is_some_and(|character| character.display.mode != ModelDisplay::Mesh);
            let are_shown = frame.view.bones || shows_skeleton;
            for (joint, start, end) in bones_in_world(frame.scene, shape) {
                let own = if hovered == Some(joint) {
                    CYAN_BONE
                } else if are_shown {
                    RED_BONE
                } else {
                    continue;
                };
                immediate.color(edge.unwrap_or(own));
                immediate.vertex(start);
                immediate.vertex(end);
            }
        }
        immediate.end();
    }
    immediate.line_width(1.0);
}
