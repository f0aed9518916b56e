//! Vertex arrays: which attribute reads which buffer how, and drawing from them.

use std::mem::size_of;
use std::ops::Range;
use std::rc::Rc;

use bytemuck::Pod;
use glow::HasContext as _;

use super::attribute::{Source, attach};
use super::buffer::Storage;
use super::{Attribute, Buffer, Gl, GpuError, IndexBuffer, Program};

/// What consecutive vertices make. [`Immediate`](super::Immediate) adds quads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Primitive {
    /// One point a vertex.
    Points,
    /// One segment two vertices.
    Lines,
    /// A segment from each vertex to the next.
    LineStrip,
    /// A strip that returns to its first vertex.
    LineLoop,
    /// One triangle three vertices.
    Triangles,
    /// A triangle with each vertex and the two before it.
    TriangleStrip,
    /// A triangle with each vertex, the one before it, and the first.
    TriangleFan,
}

impl Primitive {
    fn raw(self) -> u32 {
        match self {
            Self::Points => glow::POINTS,
            Self::Lines => glow::LINES,
            Self::LineStrip => glow::LINE_STRIP,
            Self::LineLoop => glow::LINE_LOOP,
            Self::Triangles => glow::TRIANGLES,
            Self::TriangleStrip => glow::TRIANGLE_STRIP,
            Self::TriangleFan => glow::TRIANGLE_FAN,
        }
    }
}

/// Collects the attributes of a [`VertexArray`].
#[must_use]
pub struct VertexArrayBuilder {
    gl: Gl,
    sources: Vec<Source>,
    indices: Option<Rc<Storage>>,
}

impl std::fmt::Debug for VertexArrayBuilder {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VertexArrayBuilder")
            .field("attributes", &self.sources.len())
            .finish()
    }
}

impl VertexArrayBuilder {
    /// Reads `attribute` from `buffer`, one element of `T` a vertex (or instance).
    pub fn attribute<T: Pod>(mut self, buffer: &Buffer<T>, attribute: Attribute) -> Self {
        let storage = Rc::clone(&buffer.storage);
        self.sources.push(Source {
            attribute,
            stride: size_of::<T>(),
            storage,
        });
        self
    }

    /// Takes indices from `buffer` in [`VertexArray::draw_indexed`].
    pub fn indices(mut self, buffer: &IndexBuffer) -> Self {
        self.indices = Some(Rc::clone(buffer.storage()));
        self
    }

    /// The finished vertex array.
    ///
    /// # Errors
    /// When an attribute reaches beyond its element or has not 1 to 4 components, or the driver
    /// makes no vertex array.
    pub fn build(self) -> Result<VertexArray, GpuError> {
        let Self {
            gl,
            sources,
            indices,
        } = self;
        let glow = gl.raw();
        // SAFETY: current context.
        let max = unsafe { glow.get_parameter_i32(glow::MAX_VERTEX_ATTRIBS) }
            .max(0)
            .unsigned_abs();
        for Source {
            attribute, stride, ..
        } in &sources
        {
            if !attribute.fits(*stride, max) {
                let problem =
                    format!("{attribute:?} does not fit into an element of {stride} bytes");
                return Err(GpuError::Data {
                    what: "vertex attribute",
                    problem,
                });
            }
        }
        let create = |why| GpuError::Create {
            what: "vertex array",
            why,
        };
        // SAFETY: current context.
        let raw = unsafe { glow.create_vertex_array() }.map_err(create)?;
        // SAFETY: current context; the layout was checked, and draws check their ranges.
        unsafe {
            glow.bind_vertex_array(Some(raw));
            sources.iter().for_each(|source| attach(glow, source));
            glow.bind_buffer(glow::ARRAY_BUFFER, None);
            glow.bind_buffer(
                glow::ELEMENT_ARRAY_BUFFER,
                indices.as_ref().map(|storage| storage.raw),
            );
            glow.bind_vertex_array(None);
            glow.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, None);
        }
        Ok(VertexArray {
            gl: gl.clone(),
            raw,
            sources,
            indices,
        })
    }
}

/// A set of attributes to draw from. It shares the buffers, so they may be updated, and dropped.
///
/// A draw beyond the end of a buffer draws nothing and is a fault told by [`Gl::check`].
pub struct VertexArray {
    gl: Gl,
    raw: glow::VertexArray,
    sources: Vec<Source>,
    indices: Option<Rc<Storage>>,
}

impl std::fmt::Debug for VertexArray {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VertexArray")
            .field("vertices", &self.vertex_count())
            .finish()
    }
}

impl VertexArray {
    /// Starts a vertex array without attributes.
    pub fn builder(gl: &Gl) -> VertexArrayBuilder {
        VertexArrayBuilder {
            gl: gl.clone(),
            sources: Vec::new(),
            indices: None,
        }
    }

    /// How many vertices the buffers hold now; any number if no attribute moves by vertex.
    #[must_use]
    pub fn vertex_count(&self) -> u32 {
        self.count(|divisor| (divisor == 0).then_some(1))
            .unwrap_or(u32::MAX)
    }

    /// How many indices the index buffer holds now (0 without one).
    #[must_use]
    pub fn index_count(&self) -> u32 {
        let used = self
            .indices
            .as_ref()
            .map_or(0, |storage| storage.used.get());
        u32::try_from(used / size_of::<u32>()).unwrap_or(u32::MAX)
    }

    /// Draws the vertices of `range`.
    pub fn draw(&self, program: &Program, primitive: Primitive, range: Range<u32>) {
        self.draw_instanced(program, primitive, range, 1);
    }

    /// Draws the vertices of `range`, `instances` times.
    pub fn draw_instanced(
        &self,
        program: &Program,
        primitive: Primitive,
        range: Range<u32>,
        instances: u32,
    ) {
        let Some((first, count, instances)) = self.checked(&range, self.vertex_count(), instances)
        else {
            return;
        };
        program.bind();
        let glow = self.gl.raw();
        // SAFETY: current context; the range was checked against every buffer.
        unsafe {
            glow.bind_vertex_array(Some(self.raw));
            glow.draw_arrays_instanced(primitive.raw(), first, count, instances);
            glow.bind_vertex_array(None);
        }
    }

    /// Draws the vertices that the indices of `range` name.
    pub fn draw_indexed(&self, program: &Program, primitive: Primitive, range: Range<u32>) {
        self.draw_indexed_instanced(program, primitive, range, 1);
    }

    /// Draws the vertices that the indices of `range` name, `instances` times.
    pub fn draw_indexed_instanced(
        &self,
        program: &Program,
        primitive: Primitive,
        range: Range<u32>,
        instances: u32,
    ) {
        let Some((first, count, instances)) = self.checked(&range, self.index_count(), instances)
        else {
            return;
        };
        let largest = self
            .indices
            .as_ref()
            .map_or(0, |storage| storage.max_index.get());
        if largest >= self.vertex_count() {
            self.report(format!(
                "index {largest} of {} vertices",
                self.vertex_count()
            ));
            return;
        }
        program.bind();
        let glow = self.gl.raw();
        let offset = first * size_of::<u32>() as i32;
        // SAFETY: current context; the range and the largest index were checked.
        unsafe {
            glow.bind_vertex_array(Some(self.raw));
            glow.draw_elements_instanced(
                primitive.raw(),
                count,
                glow::UNSIGNED_INT,
                offset,
                instances,
            );
            glow.bind_vertex_array(None);
        }
    }

    /// First, count and instances if there is something to draw that lies in the buffers.
    fn checked(
        &self,
        range: &Range<u32>,
        available: u32,
        instances: u32,
    ) -> Option<(i32, i32, i32)> {
        if range.is_empty() || instances == 0 {
            return None;
        }
        let enough = self
            .count(|divisor| (divisor > 0).then_some(divisor))
            .unwrap_or(u32::MAX);
        // Bytes and counts are i32 in OpenGL; a buffer is at most 2 GiB, so indices fit.
        if range.end > available || instances > enough || i32::try_from(range.end).is_err() {
            self.report(format!(
                "draw of {range:?} of {available}, {instances} instances of at most {enough}"
            ));
            return None;
        }
        let count = range.end - range.start;
        Some((
            range.start as i32,
            count as i32,
            i32::try_from(instances).ok()?,
        ))
    }

    /// The fewest elements, times the number that `repeat` gives, among attributes that have one.
    fn count(&self, repeat: impl Fn(u32) -> Option<u32>) -> Option<u32> {
        let counts = self.sources.iter().filter_map(|source| {
            let repeat = repeat(source.attribute.instance_divisor())?;
            let elements = u32::try_from(source.elements()).unwrap_or(u32::MAX);
            Some(elements.saturating_mul(repeat))
        });
        counts.min()
    }

    fn report(&self, problem: String) {
        self.gl.report(format!("vertex array: {problem}"));
    }
}

impl Drop for VertexArray {
    fn drop(&mut self) {
        // SAFETY: current context; deleted once.
        unsafe { self.gl.raw().delete_vertex_array(self.raw) }
    }
}
