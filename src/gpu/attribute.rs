//! How the inputs of a vertex shader are read from buffers.

use std::rc::Rc;

use glow::HasContext as _;

use super::buffer::Storage;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    F32,
    U32,
}

/// How one `in` variable of a vertex shader is read from the elements of a buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Attribute {
    location: u32,
    components: u32,
    kind: Kind,
    offset: usize,
    divisor: u32,
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

    /// Where it starts in each element, in bytes (0 unless told).
    #[must_use]
    pub const fn offset(self, bytes: usize) -> Self {
        Self {
            offset: bytes,
            ..self
        }
    }

    /// Moves on once for `instances` instances instead of once a vertex (0: once a vertex).
    #[must_use]
    pub const fn divisor(self, instances: u32) -> Self {
        Self {
            divisor: instances,
            ..self
        }
    }

    pub(in crate::gpu) fn instance_divisor(&self) -> u32 {
        self.divisor
    }

    /// Whether it lies within elements of `stride` bytes, at a location below `max_location`.
    pub(in crate::gpu) fn fits(&self, stride: usize, max_location: u32) -> bool {
        (1..=4).contains(&self.components)
            && self.offset.saturating_add(self.byte_len()) <= stride
            && self.location < max_location
    }

    fn byte_len(&self) -> usize {
        (self.components as usize).saturating_mul(size_of::<f32>())
    }
}

/// An attribute attached to a buffer.
pub(in crate::gpu) struct Source {
    pub(in crate::gpu) attribute: Attribute,
    pub(in crate::gpu) stride: usize,
    pub(in crate::gpu) storage: Rc<Storage>,
}

impl Source {
    /// How many elements can be read.
    pub(in crate::gpu) fn elements(&self) -> usize {
        let needed = self.attribute.offset + self.attribute.byte_len();
        match self.storage.used.get().checked_sub(needed) {
            Some(rest) => rest / self.stride + 1,
            None => 0,
        }
    }
}

/// # Safety
/// The context is current, a vertex array is bound, and the layout fits the elements.
pub(in crate::gpu) unsafe fn attach(glow: &glow::Context, source: &Source) {
    let Attribute {
        location,
        kind,
        divisor,
        ..
    } = source.attribute;
    // These were checked to be small.
    let components = source.attribute.components as i32;
    let (stride, offset) = (source.stride as i32, source.attribute.offset as i32);
    // SAFETY: by contract.
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
