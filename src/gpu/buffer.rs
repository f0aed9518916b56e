//! Buffers in the memory of the graphics card: vertices, instances and indices.

use std::cell::Cell;
use std::marker::PhantomData;
use std::mem::size_of;
use std::rc::Rc;

use bytemuck::Pod;
use glow::HasContext as _;

use super::{Gl, GpuError};

/// Frequency of changes of the content.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Usage {
    /// Written once, drawn often.
    Static,
    /// Written for each picture.
    Stream,
}

impl Usage {
    fn raw(self) -> u32 {
        match self {
            Self::Static => glow::STATIC_DRAW,
            Self::Stream => glow::STREAM_DRAW,
        }
    }
}

/// Bytes that a buffer keeps, however little is written.
const SMALL: usize = 1 << 16;

/// The driver's object, shared with the vertex arrays that read it.
pub(in crate::gpu) struct Storage {
    pub(in crate::gpu) gl: Gl,
    pub(in crate::gpu) raw: glow::Buffer,
    target: u32,
    usage: Usage,
    /// Bytes that the driver has reserved.
    capacity: Cell<usize>,
    /// Bytes that may be read: draws check their ranges against it.
    pub(in crate::gpu) used: Cell<usize>,
    /// The largest index, for index buffers.
    pub(in crate::gpu) max_index: Cell<u32>,
}

impl Drop for Storage {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; deleted once, after the last vertex array that reads it.
            unsafe { glow.delete_buffer(self.raw) }
        }
    }
}

impl Storage {
    fn new(gl: &Gl, target: u32, usage: Usage) -> Result<Self, GpuError> {
        let create = |why| GpuError::Create {
            what: "buffer",
            why,
        };
        let glow = gl.current_for("making a buffer")?;
        // SAFETY: current context.
        let raw = unsafe { glow.create_buffer() }.map_err(create)?;
        let (capacity, used, max_index) = (Cell::new(0), Cell::new(0), Cell::new(0));
        Ok(Self {
            gl: gl.clone(),
            raw,
            target,
            usage,
            capacity,
            used,
            max_index,
        })
    }

    fn write(&self, bytes: &[u8]) -> Result<(), GpuError> {
        // Memory much larger than its content would be asked for again with every write.
        let kept = bytes.len()..=bytes.len().saturating_mul(4).max(SMALL);
        let capacity = self.capacity.get();
        let capacity = if kept.contains(&capacity) {
            capacity
        } else {
            bytes.len()
        };
        let size = i32::try_from(capacity).map_err(|_| GpuError::Data {
            what: "buffer",
            problem: format!(
                "{capacity} bytes are more than the {} it can hold",
                i32::MAX
            ),
        })?;
        let glow = self.gl.current_for("writing a buffer")?;
        // Until the driver is known to have reserved the memory, nothing may be read.
        self.capacity.set(0);
        self.used.set(0);
        // SAFETY: current context; the size is at least that of the data. An index buffer would
        // otherwise become part of whatever vertex array happens to be bound.
        unsafe {
            glow.bind_vertex_array(None);
            glow.bind_buffer(self.target, Some(self.raw));
            // New storage instead of waiting until the old one is not drawn from any more.
            glow.buffer_data_size(self.target, size, self.usage.raw());
            if !bytes.is_empty() {
                glow.buffer_sub_data_u8_slice(self.target, 0, bytes);
            }
            glow.bind_buffer(self.target, None);
        }
        self.gl.check_memory("buffer")?;
        self.capacity.set(capacity);
        self.used.set(bytes.len());
        Ok(())
    }
}

/// A slice of `T` in the memory of the graphics card. Vertex arrays that read it share it.
pub struct Buffer<T: Pod> {
    pub(in crate::gpu) storage: Rc<Storage>,
    element: PhantomData<T>,
}

impl<T: Pod> std::fmt::Debug for Buffer<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Buffer").field("len", &self.len()).finish()
    }
}

impl<T: Pod> Buffer<T> {
    /// Vertices or instances. `data` may be empty.
    ///
    /// # Errors
    /// When the driver has not the memory, or the data is larger than 2 GiB.
    pub fn vertices(gl: &Gl, usage: Usage, data: &[T]) -> Result<Self, GpuError> {
        let storage = Rc::new(Storage::new(gl, glow::ARRAY_BUFFER, usage)?);
        storage.write(bytemuck::cast_slice(data))?;
        Ok(Self {
            storage,
            element: PhantomData,
        })
    }

    /// Replaces the content by vertices or instances, of any number; memory that fits is reused.
    ///
    /// # Errors
    /// When the data is larger than 2 GiB; the content is then unchanged. When the driver has not
    /// the memory; the buffer is then empty.
    pub fn update(&self, data: &[T]) -> Result<(), GpuError> {
        self.storage.write(bytemuck::cast_slice(data))
    }

    /// The number of elements written last.
    #[must_use]
    pub fn len(&self) -> usize {
        self.storage.used.get() / size_of::<T>().max(1)
    }

    /// Whether it has no elements.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Indices of vertices of a [`VertexArray`](super::VertexArray).
#[derive(Debug)]
pub struct IndexBuffer {
    buffer: Buffer<u32>,
}

impl IndexBuffer {
    /// `data` may be empty.
    ///
    /// # Errors
    /// When the driver has not the memory, or the data is larger than 2 GiB.
    pub fn new(gl: &Gl, usage: Usage, data: &[u32]) -> Result<Self, GpuError> {
        let storage = Rc::new(Storage::new(gl, glow::ELEMENT_ARRAY_BUFFER, usage)?);
        let indices = Self {
            buffer: Buffer {
                storage,
                element: PhantomData,
            },
        };
        indices.update(data)?;
        Ok(indices)
    }

    /// Replaces the content by indices, of any number; memory that fits is reused.
    ///
    /// # Errors
    /// When the data is larger than 2 GiB; the content is then unchanged. When the driver has not
    /// the memory; the buffer is then empty.
    pub fn update(&self, data: &[u32]) -> Result<(), GpuError> {
        self.buffer.update(data)?;
        self.storage()
            .max_index
            .set(data.iter().copied().max().unwrap_or(0));
        Ok(())
    }

    /// The number of indices written last.
    #[must_use]
    pub fn len(&self) -> usize {
        self.buffer.len()
    }

    /// Whether it has no indices.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.buffer.is_empty()
    }

    pub(in crate::gpu) fn storage(&self) -> &Rc<Storage> {
        &self.buffer.storage
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};

    #[test]
    fn a_buffer_keeps_memory_that_fits_and_gives_back_what_is_far_too_large() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let buffer = Buffer::vertices(context.gl(), Usage::Stream, &[0_u8; 4000]).unwrap();
        let capacity_for = |count: usize| {
            buffer.update(&vec![0_u8; count]).unwrap();
            assert_eq!(buffer.len(), count);
            buffer.storage.capacity.get()
        };
        let sizes = [1000, 5000, 10, 10_000_000, 3_000_000, 1000, 0];
        assert_eq!(
            sizes.map(capacity_for),
            [4000, 5000, 5000, 10_000_000, 10_000_000, 1000, 1000]
        );
    }
}
