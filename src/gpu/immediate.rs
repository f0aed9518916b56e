//! The compatibility layer: `glBegin … glEnd` on top of core OpenGL.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

use super::display_list::{self, Group, PointLook};
use super::{Buffer, Gl, GpuError, Primitive, Program, Usage, VertexArray};

/// Shape that the vertices between [`begin`](Immediate::begin) and [`end`](Immediate::end) form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// `GL_POINTS`.
    Points,
    /// `GL_LINES`: one segment two vertices.
    Lines,
    /// `GL_LINE_STRIP`.
    LineStrip,
    /// `GL_LINE_LOOP`: a strip that returns to its first vertex.
    LineLoop,
    /// `GL_TRIANGLES`.
    Triangles,
    /// `GL_TRIANGLE_STRIP`.
    TriangleStrip,
    /// `GL_TRIANGLE_FAN`.
    TriangleFan,
    /// `GL_QUADS`: one quad four vertices, around it.
    Quads,
}

/// Shape of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[doc(alias = "GL_POINT_SMOOTH")]
pub enum PointShape {
    /// OpenGL's own.
    #[default]
    Square,
    /// A disc with a hard edge, for draws without blending.
    Disc,
    /// A disc whose edge fades out through alpha: needs [`Blend::Alpha`](super::Blend::Alpha).
    SmoothDisc,
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(in crate::gpu) struct Vertex {
    pub(in crate::gpu) position: Vec4,
    pub(in crate::gpu) color: Vec4,
}

/// Room for so many vertices is kept from one group to the next.
const KEPT_VERTICES: usize = 1 << 16;

/// Draws points, lines and triangles given vertex by vertex, one draw call for each
/// `begin … end`, into what is bound and with the [`DrawState`](super::DrawState) applied last.
///
/// As in OpenGL, the matrix, color, sizes and shape stay until changed. A vertex outside of
/// `begin … end`, or those two in a wrong order, are faults that [`Gl::check`] returns.
pub struct Immediate {
    pub(in crate::gpu) gl: Gl,
    pub(in crate::gpu) program: Program,
    buffer: Buffer<Vertex>,
    vertex_array: VertexArray,
    /// Vertices of the current group, after those of earlier groups in a list.
    pub(in crate::gpu) vertices: Vec<Vertex>,
    pub(in crate::gpu) group_start: usize,
    /// The groups of the list that is recorded, if one is.
    pub(in crate::gpu) list: Option<Vec<Group>>,
    pub(in crate::gpu) mode: Option<Mode>,
    color: Vec4,
    normal: Vec3,
    towards_light: Option<Vec3>,
    pub(in crate::gpu) clip_from_world: Mat4,
    point_size: f32,
    point_shape: PointShape,
    line_width: f32,
}

impl std::fmt::Debug for Immediate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Immediate")
            .field("mode", &self.mode)
            .finish_non_exhaustive()
    }
}

impl Immediate {
    /// Starts with the identity matrix, white, points and lines of one pixel, square points.
    ///
    /// # Errors
    /// When the driver refuses a buffer.
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let vertex_body = include_str!("../../shaders/immediate_vertex.glsl");
        let fragment_body = include_str!("../../shaders/immediate_fragment.glsl");
        let program = Program::when_used(gl, "immediate", vertex_body, fragment_body);
        let buffer = Buffer::vertices(gl, Usage::Stream, &[])?;
        let vertex_array = display_list::attributes(gl, &buffer).build()?;
        Ok(Self {
            gl: gl.clone(),
            program,
            buffer,
            vertex_array,
            vertices: Vec::new(),
            group_start: 0,
            list: None,
            mode: None,
            color: Vec4::ONE,
            normal: Vec3::Z,
            towards_light: None,
            clip_from_world: Mat4::IDENTITY,
            point_size: 1.0,
            point_shape: PointShape::Square,
            line_width: 1.0,
        })
    }

    /// Sets the matrix that takes vertices to clip space.
    #[doc(alias = "glLoadMatrixf")]
    pub fn load_matrix(&mut self, clip_from_world: Mat4) {
        self.clip_from_world = clip_from_world;
    }

    /// Sets the diameter of points in pixels, at most the driver's limit.
    #[doc(alias = "glPointSize")]
    pub fn point_size(&mut self, pixels: f32) {
        self.point_size = pixels.clamp(1.0, self.gl.info().max_point_size);
    }

    /// Sets the shape of points.
    #[doc(alias = "GL_POINT_SMOOTH")]
    pub fn point_shape(&mut self, shape: PointShape) {
        self.point_shape = shape;
    }

    /// Sets the width of lines in pixels. At 1 they are OpenGL's own; wider ones have this width
    /// across at every distance, and end square at their ends.
    #[doc(alias = "glLineWidth")]
    pub fn line_width(&mut self, pixels: f32) {
        self.line_width = pixels.max(1.0);
    }

    /// Starts a group of vertices.
    #[doc(alias = "glBegin")]
    pub fn begin(&mut self, mode: Mode) {
        if self.mode.is_some() {
            self.gl
                .report("immediate: begin without end before it".to_owned());
        }
        if self.list.is_none() {
            self.vertices.clear();
            self.vertices.shrink_to(KEPT_VERTICES);
        }
        self.group_start = self.vertices.len();
        self.mode = Some(mode);
    }

    /// Sets the color (red, green, blue in 0..1) of the vertices that follow.
    #[doc(alias = "glColor3f")]
    pub fn color(&mut self, rgb: Vec3) {
        self.color = rgb.extend(1.0);
    }

    /// Sets the color of the vertices that follow, with alpha.
    #[doc(alias = "glColor4f")]
    pub fn color_alpha(&mut self, rgba: Vec4) {
        self.color = rgba;
    }

    /// Sets the normal of the vertices that follow, of unit length, in their space. It matters
    /// where there is a light.
    #[doc(alias = "glNormal3f")]
    pub fn normal(&mut self, normal: Vec3) {
        self.normal = normal;
    }

    /// Lights the vertices that follow from a direction, given in their space, or leaves their
    /// colors as they are. As in OpenGL's own lighting each vertex is lit by itself: a fifth of
    /// its color everywhere, the rest by the angle between normal and light.
    #[doc(alias = "GL_LIGHTING")]
    pub fn light(&mut self, towards_light: Option<Vec3>) {
        self.towards_light = towards_light.map(Vec3::normalize_or_zero);
    }

    /// Adds a vertex, in the space that the matrix starts from.
    #[doc(alias = "glVertex3f")]
    pub fn vertex(&mut self, position: Vec3) {
        if self.mode.is_none() {
            self.gl
                .report("immediate: vertex outside of begin and end".to_owned());
            return;
        }
        self.vertices.push(Vertex {
            position: position.extend(1.0),
            color: self.lit_color(),
        });
    }

    fn lit_color(&self) -> Vec4 {
        let Some(towards_light) = self.towards_light else {
            return self.color;
        };
        let light = 0.2 + 0.8 * self.normal.dot(towards_light).max(0.0);
        (self.color.truncate() * light).extend(self.color.w)
    }

    /// Draws the group.
    #[doc(alias = "glEnd")]
    pub fn end(&mut self) {
        let Some(mode) = self.mode.take() else {
            self.gl.report("immediate: end without begin".to_owned());
            return;
        };
        let is_line = matches!(mode, Mode::Lines | Mode::LineStrip | Mode::LineLoop);
        if self.list.is_some() {
            if is_line && self.line_width > 1.0 {
                let fault = "immediate: a list holds lines of one pixel alone";
                self.gl.report(fault.to_owned());
            }
            self.record(mode);
            return;
        }
        let (primitive, clip_from_vertex) = if is_line && self.line_width > 1.0 {
            self.widen_lines(mode);
            (Primitive::Triangles, Mat4::IDENTITY)
        } else {
            (self.plain(mode), self.clip_from_world)
        };
        if let Err(error) = self.buffer.update(&self.vertices) {
            self.gl.report(error.to_string());
            return;
        }
        self.program.set_mat4("clip_from_world", clip_from_vertex);
        self.set_look(self.look(mode));
        let count = self.vertex_array.vertex_count();
        self.vertex_array.draw(&self.program, primitive, 0..count);
    }

    /// Size and shape of the points of a group; defaults for groups of lines and triangles.
    pub(in crate::gpu) fn look(&self, mode: Mode) -> PointLook {
        if mode == Mode::Points {
            PointLook {
                size: self.point_size,
                shape: self.point_shape,
            }
        } else {
            PointLook {
                size: 1.0,
                shape: PointShape::Square,
            }
        }
    }

    pub(in crate::gpu) fn set_look(&self, PointLook { size, shape }: PointLook) {
        // A smooth edge reaches half a pixel beyond the disc.
        let margin = if shape == PointShape::SmoothDisc {
            1.0
        } else {
            0.0
        };
        self.program.set_f32("point_size", size);
        self.program.set_f32("sprite_size", size + margin);
        self.program.set_i32("point_shape", shape as i32);
    }

    /// The primitive for a mode that OpenGL draws; quads become triangles first.
    pub(in crate::gpu) fn plain(&mut self, mode: Mode) -> Primitive {
        match mode {
            Mode::Points => Primitive::Points,
            Mode::Lines => Primitive::Lines,
            Mode::LineStrip => Primitive::LineStrip,
            Mode::LineLoop => Primitive::LineLoop,
            Mode::Triangles => Primitive::Triangles,
            Mode::TriangleStrip => Primitive::TriangleStrip,
            Mode::TriangleFan => Primitive::TriangleFan,
            Mode::Quads => {
                let quads = self.vertices.split_off(self.group_start);
                let corners = quads.chunks_exact(4);
                let corners = corners.flat_map(|q| [q[0], q[1], q[2], q[0], q[2], q[3]]);
                self.vertices.extend(corners);
                Primitive::Triangles
            }
        }
    }

    /// Replaces the vertices of lines by triangles in clip space.
    fn widen_lines(&mut self, mode: Mode) {
        let [_, _, width, height] = self.gl.viewport();
        let viewport = Vec2::new(width.max(1) as f32, height.max(1) as f32);
        let points: Vec<Point> = self
            .vertices
            .drain(..)
            .map(|vertex| Point {
                clip: self.clip_from_world * vertex.position,
                color: vertex.color,
            })
            .collect();
        let mut segments: Vec<(Point, Point)> = match mode {
            Mode::Lines => points
                .chunks_exact(2)
                .map(|pair| (pair[0], pair[1]))
                .collect(),
            _ => points.windows(2).map(|pair| (pair[0], pair[1])).collect(),
        };
        if let (Mode::LineLoop, [first, .., last]) = (mode, points.as_slice()) {
            segments.push((*last, *first));
        }
        let quads = segments
            .into_iter()
            .filter_map(|(from, to)| thick_line(from, to, self.line_width, viewport));
        self.vertices.extend(quads.flatten().map(|point| Vertex {
            position: point.clip,
            color: point.color,
        }));
    }
}

/// Below this clip-space w a point is at the eye, or behind it.
const MIN_W: f32 = 1e-6;

/// A point in clip space with its color.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    clip: Vec4,
    color: Vec4,
}

impl Point {
    fn lerp(self, other: Self, t: f32) -> Self {
        Self {
            clip: self.clip.lerp(other.clip, t),
            color: self.color.lerp(other.color, t),
        }
    }
}

/// Two triangles that cover the segment `width` pixels wide, or `None` where it is behind the eye or
/// seen end-on: core OpenGL does not promise wide lines. `viewport` is the size of the picture in
/// pixels.
///
/// The part before the near plane is cut off first: projecting it would turn the line around.
fn thick_line(from: Point, to: Point, width: f32, viewport: Vec2) -> Option<[Point; 6]> {
    let (from, to) = cut(from, to, |clip| clip.z + clip.w)?;
    let (from, to) = cut(from, to, |clip| clip.w - MIN_W)?;
    let on_screen = |point: Point| point.clip.truncate().truncate() / point.clip.w * viewport * 0.5;
    let along = (on_screen(to) - on_screen(from)).try_normalize()?;
    let aside = along.perp() * width / viewport;
    let moved = |point: Point, by: Vec2| Point {
        clip: point.clip + (by * point.clip.w).extend(0.0).extend(0.0),
        ..point
    };
    let (a, b) = (moved(from, -aside), moved(to, -aside));
    let (c, d) = (moved(to, aside), moved(from, aside));
    Some([a, b, c, a, c, d])
}

/// The part of a segment where `inside` is not negative.
fn cut(from: Point, to: Point, inside: impl Fn(Vec4) -> f32) -> Option<(Point, Point)> {
    let (start, end) = (inside(from.clip), inside(to.clip));
    match (start >= 0.0, end >= 0.0) {
        (true, true) => Some((from, to)),
        (true, false) => Some((from, from.lerp(to, start / (start - end)))),
        (false, true) => Some((from.lerp(to, start / (start - end)), to)),
        (false, false) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEWPORT: Vec2 = Vec2::new(200.0, 100.0);

    fn point(x: f32, y: f32, z: f32, w: f32) -> Point {
        Point {
            clip: Vec4::new(x, y, z, w),
            color: Vec4::ONE,
        }
    }

    #[test]
    fn a_line_is_as_wide_as_asked_at_both_ends_whatever_their_distance() {
        let quad = thick_line(
            point(0.0, 0.0, 0.0, 1.0),
            point(2.0, 0.0, 3.0, 4.0),
            5.0,
            VIEWPORT,
        )
        .unwrap();
        let height = |p: Point| p.clip.y / p.clip.w * VIEWPORT.y * 0.5;
        let [a, b, c, _, _, d] = quad;
        assert!((height(d) - height(a) - 5.0).abs() < 1e-5);
        assert!((height(c) - height(b) - 5.0).abs() < 1e-5);
    }

    #[test]
    fn a_line_that_passes_the_eye_ends_at_the_near_plane() {
        let behind = Point {
            color: Vec4::ZERO,
            ..point(0.0, 0.0, -3.0, -1.0)
        };
        let quad = thick_line(point(1.0, 0.0, 0.0, 2.0), behind, 2.0, VIEWPORT).unwrap();
        // z + w goes from 2 to -4: a third of the way.
        let end = quad[1];
        assert!((end.clip.z + end.clip.w).abs() < 1e-6);
        assert!((end.clip.w - 1.0).abs() < 1e-6);
        assert!((end.color.x - 2.0 / 3.0).abs() < 1e-6);
    }

    #[test]
    fn nothing_is_left_of_a_line_behind_the_eye_or_without_a_direction() {
        let behind = point(0.0, 0.0, -3.0, -1.0);
        assert_eq!(
            thick_line(behind, point(1.0, 0.0, -3.0, 1.0), 2.0, VIEWPORT),
            None
        );
        let there = point(0.5, 0.5, 0.0, 1.0);
        assert_eq!(thick_line(there, there, 2.0, VIEWPORT), None);
    }
}
