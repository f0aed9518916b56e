//! Vertex arrays: attributes of vertices from buffers, and draws from them.

use std::mem::size_of;
use std::ops::Range;
use std::rc::Rc;

use bytemuck::Pod;
use glow::HasContext as _;

use super::attribute::{Attribute, Source, attach};
use super::buffer::Storage;
use super::{Buffer, Gl, GpuError, IndexBuffer, Program};

/// Shape that consecutive vertices form. [`Immediate`](super::Immediate) adds quads.
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
    /// When an attribute reaches beyond its element or has not 1 to 4 components, a buffer is of
    /// another context, or the driver makes no vertex array.
    pub fn build(self) -> Result<VertexArray, GpuError> {
        let Self {
            gl,
            sources,
            indices,
        } = self;
        let invalid = |problem| GpuError::Data {
            what: "vertex attribute",
            problem,
        };
        for Source {
            attribute, stride, ..
        } in &sources
        {
            if !attribute.fits(*stride, gl.info().max_vertex_attributes) {
                let problem =
                    format!("{attribute:?} does not fit into an element of {stride} bytes");
                return Err(invalid(problem));
            }
        }
        let mut storages = sources.iter().map(|source| &source.storage).chain(&indices);
        if !storages.all(|storage| storage.gl.is_same(&gl)) {
            return Err(invalid("its buffer is of another context".to_owned()));
        }
        let glow = gl.current_for("making a vertex array")?;
        let create = |why| GpuError::Create {
            what: "vertex array",
            why,
        };
        // SAFETY: current context.
        let raw = unsafe { glow.create_vertex_array() }.map_err(create)?;
        // SAFETY: current context, which all buffers are of; the layout was checked, and draws check
        // their ranges.
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
/// A draw beyond the end of a buffer, or with a program of another context, draws nothing and is a
/// fault that [`Gl::check`] returns.
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

    /// Starts a vertex array with the same attributes and indices, from the same buffers; others can
    /// be added, and other indices take the place of these.
    pub fn extended(&self) -> VertexArrayBuilder {
        let sources = self.sources.iter().map(|source| Source {
            storage: Rc::clone(&source.storage),
            ..*source
        });
        VertexArrayBuilder {
            gl: self.gl.clone(),
            sources: sources.collect(),
            indices: self.indices.clone(),
        }
    }

    /// Number of vertices in the buffers; `u32::MAX` if no attribute advances by vertex.
    #[must_use]
    pub fn vertex_count(&self) -> u32 {
        self.count(|divisor| (divisor == 0).then_some(1))
            .unwrap_or(u32::MAX)
    }

    /// Number of indices in the index buffer (0 without one).
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
        let Some(glow) = self.bind_program(program) else {
            return;
        };
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
        let Some(glow) = self.bind_program(program) else {
            return;
        };
        let offset = first * size_of::<u32>() as i32;
        // SAFETY: current context; the range was checked against the indices, and the largest index
        // against every buffer.
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

    /// The entry points, with `program` bound in them.
    fn bind_program<'a>(&self, program: &'a Program) -> Option<&'a glow::Context> {
        if !program.is_of(&self.gl) {
            self.report("a draw with a program of another context".to_owned());
            return None;
        }
        program.bind()
    }

    /// First, count and instances as OpenGL takes them; `None` if there is nothing to draw, or not
    /// all of it is in the buffers, which is reported.
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

    /// The smallest number of elements, times what `repeat` returns for the divisor, among the
    /// attributes for which it returns something.
    fn count(&self, repeat: impl Fn(u32) -> Option<u32>) -> Option<u32> {
        let counts = self.sources.iter().filter_map(|source| {
            let repeat = repeat(source.attribute.divisor)?;
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
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; deleted once.
            unsafe { glow.delete_vertex_array(self.raw) }
        }
    }
}
