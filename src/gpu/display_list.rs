//! Vertices given once and drawn often: the compatibility layer's `glNewList … glCallList`.

use std::ops::Range;

use super::immediate::{Immediate, Mode, Vertex};
use super::{
    Attribute, Buffer, Gl, GpuError, PointShape, Primitive, Usage, VertexArray, VertexArrayBuilder,
};

/// Points, lines and triangles that are in the memory of the graphics card, made by
/// [`Immediate::end_list`](super::Immediate::end_list) and drawn by
/// [`Immediate::call_list`](super::Immediate::call_list).
#[derive(Debug)]
pub struct DisplayList {
    pub(in crate::gpu) vertex_array: VertexArray,
    pub(in crate::gpu) groups: Vec<Group>,
}

/// The vertices of one or more `begin … end` that are drawn by one call.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::gpu) struct Group {
    pub(in crate::gpu) primitive: Primitive,
    pub(in crate::gpu) vertices: Range<u32>,
    pub(in crate::gpu) look: PointLook,
}

/// Size and shape of points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::gpu) struct PointLook {
    pub(in crate::gpu) size: f32,
    pub(in crate::gpu) shape: PointShape,
}

impl DisplayList {
    pub(in crate::gpu) fn new(
        gl: &Gl,
        vertices: &[Vertex],
        groups: Vec<Group>,
    ) -> Result<Self, GpuError> {
        let buffer = Buffer::vertices(gl, Usage::Static, vertices)?;
        let vertex_array = attributes(gl, &buffer).build()?;
        Ok(Self {
            vertex_array,
            groups,
        })
    }
}

impl Immediate {
    /// Keeps the groups that follow instead of drawing them, until
    /// [`end_list`](Self::end_list). Lines in it have one pixel.
    #[doc(alias = "glNewList")]
    pub fn begin_list(&mut self) {
        self.break_off();
        self.vertices.clear();
        self.list = Some(Vec::new());
    }

    /// The groups since [`begin_list`](Self::begin_list), with their colors, light and sizes of
    /// points; the matrix is the one of the time at which the list is drawn.
    ///
    /// # Errors
    /// When they do not fit into the driver's memory.
    #[doc(alias = "glEndList")]
    pub fn end_list(&mut self) -> Result<DisplayList, GpuError> {
        self.break_off();
        let groups = self.list.take().unwrap_or_default();
        let vertices = std::mem::take(&mut self.vertices);
        DisplayList::new(&self.gl, &vertices, groups)
    }

    /// Forgets a group that was not ended: its start means nothing in other vertices.
    fn break_off(&mut self) {
        if self.mode.take().is_some() {
            let fault = "immediate: a list starts and ends outside of begin and end";
            self.gl.report(fault.to_owned());
        }
    }

    /// Draws a list. Neither color nor sizes are other ones afterwards.
    #[doc(alias = "glCallList")]
    pub fn call_list(&mut self, list: &DisplayList) {
        self.program
            .set_mat4("clip_from_world", self.clip_from_world);
        for group in &list.groups {
            self.set_look(group.look);
            let vertices = group.vertices.clone();
            list.vertex_array
                .draw(&self.program, group.primitive, vertices);
        }
    }

    /// Adds the group to the list.
    pub(in crate::gpu) fn record(&mut self, mode: Mode) {
        let primitive = self.plain(mode);
        let place = |index: usize| u32::try_from(index).unwrap_or(u32::MAX);
        let group = Group {
            primitive,
            vertices: place(self.group_start)..place(self.vertices.len()),
            look: self.look(mode),
        };
        if let Some(groups) = &mut self.list {
            add(groups, group);
        }
    }
}

/// Lets `immediate_vertex.glsl` read `buffer`.
pub(in crate::gpu) fn attributes(gl: &Gl, buffer: &Buffer<Vertex>) -> VertexArrayBuilder {
    let color_offset = std::mem::offset_of!(Vertex, color);
    VertexArray::builder(gl)
        .attribute(buffer, Attribute::f32(0, 4))
        .attribute(buffer, Attribute::f32(1, 4).offset(color_offset))
}

/// Adds a group, to the one before it where the two are the same in one draw.
fn add(groups: &mut Vec<Group>, group: Group) {
    let is_list = matches!(
        group.primitive,
        Primitive::Points | Primitive::Lines | Primitive::Triangles
    );
    match groups.last_mut() {
        Some(last)
            if is_list
                && (last.primitive, last.look) == (group.primitive, group.look)
                && last.vertices.end == group.vertices.start
                && is_whole(last) =>
        {
            last.vertices.end = group.vertices.end;
        }
        _ => groups.push(group),
    }
}

/// Whether its last primitive has all its vertices: the next group would complete it.
fn is_whole(group: &Group) -> bool {
    let count = group.vertices.end - group.vertices.start;
    match group.primitive {
        Primitive::Lines => count.is_multiple_of(2),
        Primitive::Triangles => count.is_multiple_of(3),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_become_one_where_no_primitive_would_run_from_one_into_the_next() {
        let look = PointLook {
            size: 1.0,
            shape: PointShape::Square,
        };
        let group = |primitive, vertices| Group {
            primitive,
            vertices,
            look,
        };
        let after = |first: Primitive, count: u32, second: Primitive| {
            let mut groups = vec![group(first, 0..count)];
            add(&mut groups, group(second, count..count + 6));
            groups.len()
        };
        assert_eq!(after(Primitive::Lines, 4, Primitive::Lines), 1);
        assert_eq!(after(Primitive::Lines, 5, Primitive::Lines), 2);
        assert_eq!(after(Primitive::Triangles, 4, Primitive::Triangles), 2);
        assert_eq!(after(Primitive::Points, 5, Primitive::Points), 1);
        assert_eq!(after(Primitive::LineStrip, 4, Primitive::LineStrip), 2);
        assert_eq!(after(Primitive::Lines, 4, Primitive::Points), 2);
        let larger = Group {
            look: PointLook { size: 2.0, ..look },
            ..group(Primitive::Points, 5..6)
        };
        let mut groups = vec![group(Primitive::Points, 0..5)];
        add(&mut groups, larger);
        assert_eq!(groups.len(), 2);
    }
}
