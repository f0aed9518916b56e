//! Attributes of vertices: where the `in` variables of a vertex shader are in the elements of buffers.

use std::mem::size_of;
use std::rc::Rc;

use glow::HasContext as _;

use super::buffer::Storage;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    F32,
    U32,
}

/// Source of one `in` variable of a vertex shader: its place and type in the elements of a buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Attribute {
    location: u32,
    components: u32,
    kind: Kind,
    offset: usize,
    pub(super) divisor: u32,
}

impl Attribute {
    /// A `float` or `vec2` to `vec4` at `layout(location = …)`, from `components` (1 to 4) `f32`.
    #[must_use]
    pub const fn f32(location: u32, components: u32) -> Self {
        Self {
            location,
            components,
            kind: Kind::F32,
            offset: 0,
            divisor: 0,
        }
    }

    /// A `uint` or `uvec2` to `uvec4`, from `components` (1 to 4) `u32`.
    #[must_use]
    pub const fn u32(location: u32, components: u32) -> Self {
        Self {
            location,
            components,
            kind: Kind::U32,
            offset: 0,
            divisor: 0,
        }
    }

    /// Sets its offset in each element, in bytes (0 by default).
    #[must_use]
    pub const fn offset(self, bytes: usize) -> Self {
        Self {
            offset: bytes,
            ..self
        }
    }

    /// Advances once every `instances` instances instead of once a vertex (0: once a vertex).
    #[must_use]
    pub const fn divisor(self, instances: u32) -> Self {
        Self {
            divisor: instances,
            ..self
        }
    }

    /// Whether it lies within elements of `stride` bytes, at a location below `max_location`.
    pub(super) fn fits(&self, stride: usize, max_location: u32) -> bool {
        (1..=4).contains(&self.components)
            && self.offset.saturating_add(self.byte_len()) <= stride
            && self.location < max_location
    }

    fn byte_len(&self) -> usize {
        (self.components as usize).saturating_mul(size_of::<f32>())
    }
}

/// An attribute with the buffer that it reads.
pub(super) struct Source {
    pub attribute: Attribute,
    pub stride: usize,
    pub storage: Rc<Storage>,
}

impl Source {
    /// Number of elements that can be read.
    pub fn elements(&self) -> usize {
        let needed = self.attribute.offset + self.attribute.byte_len();
        match self.storage.used.get().checked_sub(needed) {
            Some(rest) => rest / self.stride + 1,
            None => 0,
        }
    }
}

/// # Safety
/// The context is current and that of the buffer, a vertex array is bound, and the layout fits the
/// elements.
pub(super) unsafe fn attach(glow: &glow::Context, source: &Source) {
    let Attribute {
        location,
        kind,
        divisor,
        ..
    } = source.attribute;
    // `fits` has checked that these are small.
    let components = source.attribute.components as i32;
    let (stride, offset) = (source.stride as i32, source.attribute.offset as i32);
    // SAFETY: by this function's contract; the buffer is of the same context.
    unsafe {
        glow.bind_buffer(glow::ARRAY_BUFFER, Some(source.storage.raw));
        glow.enable_vertex_attrib_array(location);
        match kind {
            Kind::F32 => glow.vertex_attrib_pointer_f32(
                location,
                components,
                glow::FLOAT,
                false,
                stride,
                offset,
            ),
            Kind::U32 => glow.vertex_attrib_pointer_i32(
                location,
                components,
                glow::UNSIGNED_INT,
                stride,
                offset,
            ),
        }
        glow.vertex_attrib_divisor(location, divisor);
    }
}
