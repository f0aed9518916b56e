//! A line round what a mask covers.

use super::area::Area;
use super::backdrop_pass::whole_picture;
use crate::gpu::{
    Attribute, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive, Program, Usage,
    VertexArray,
};
use glam::{Vec3, Vec4};

/// Side of a block in pixels. Larger blocks take fewer looks at the mask to find out whether the line
/// passes through them, and fourteen looks at each of more pixels where it does.
const BLOCK: u32 = 8;

/// Texture unit of what a shader reads.
const UNIT: u32 = 0;

/// How the line looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// Color round what is red in the mask.
    pub selected: Vec3,
    /// Color round what is green in the mask.
    pub hovered: Vec3,
    /// Color round what is blue in the mask.
    pub other: Vec3,
    /// Width in pixels.
    pub width: u32,
}

/// Draws lines round what masks cover. Only the blocks of the picture through which one passes are
/// drawn: looking around at every pixel was half of a frame on software OpenGL.
#[derive(Debug)]
pub(super) struct EdgePass {
    blocks_program: Program,
    edge_program: Program,
    whole_picture: VertexArray,
    blocks: Option<Framebuffer>,
    /// Squares over the blocks, for a picture of so many blocks.
    squares: Option<([u32; 2], VertexArray)>,
}

impl EdgePass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        Ok(Self {
            blocks_program: Program::when_used(
                gl,
                "blocks of edges",
                include_str!("../../shaders/whole_picture_vertex.glsl"),
                include_str!("../../shaders/edge_blocks_fragment.glsl"),
            ),
            edge_program: Program::when_used(
                gl,
                "edge",
                include_str!("../../shaders/edge_vertex.glsl"),
                include_str!("../../shaders/edge_fragment.glsl"),
            ),
            whole_picture: whole_picture(gl)?,
            blocks: None,
            squares: None,
        })
    }

    /// Draws a line into `target` round what `mask` covers, which is nothing outside of `area`.
    pub fn draw(
        &mut self,
        gl: &Gl,
        mask: &Framebuffer,
        area: Area,
        edge: &Edge,
        target: &Framebuffer,
    ) -> Result<(), GpuError> {
        let size = [mask.width(), mask.height()];
        let reach = edge.width;
        // Blocks in which there may be a line.
        let lined = Area {
            first: area.first.map(|at| at.saturating_sub(reach) / BLOCK),
            end: [0, 1].map(|axis| (area.end[axis] + reach).min(size[axis]).div_ceil(BLOCK)),
        };
        if lined.is_empty() {
            return Ok(());
        }
        let count = size.map(|pixels| pixels.div_ceil(BLOCK));
        let blocks = Framebuffer::fitting(&mut self.blocks, gl, count[0], count[1])?;
        blocks.clear([0.0; 4]);
        mask.bind_texture(UNIT);
        blocks.bind();
        let flat = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(size[0], size[1])
        };
        let within = DrawState {
            viewport: lined.rectangle(),
            ..flat
        };
        within.apply(gl);
        let program = &self.blocks_program;
        program.set_sampler("mask", UNIT);
        program.set_i32("reach", reach.cast_signed());
        program.set_i32("block", BLOCK.cast_signed());
        self.whole_picture.draw(program, Primitive::Triangles, 0..3);

        blocks.bind_texture(UNIT + 1);
        mask.bind_texture(UNIT);
        target.bind();
        flat.apply(gl);
        let program = &self.edge_program;
        program.set_sampler("mask", UNIT);
        program.set_sampler("blocks", UNIT + 1);
        program.set_f32("block", BLOCK as f32);
        program.set_vec2("picture", glam::vec2(size[0] as f32, size[1] as f32));
        program.set_vec3("selected_color", edge.selected);
        program.set_vec3("hovered_color", edge.hovered);
        program.set_vec3("other_color", edge.other);
        program.set_i32("reach", reach.cast_signed());
        let squares = match self.squares.take().filter(|(of, _)| *of == count) {
            Some(kept) => kept,
            None => (count, squares(gl, count)?),
        };
        // They go by rows.
        let rows = lined.first[1] * count[0] * CORNERS..lined.end[1] * count[0] * CORNERS;
        squares.1.draw(program, Primitive::Triangles, rows);
        self.squares = Some(squares);
        Ok(())
    }
}

/// Corners of the two triangles of a square.
const CORNERS: u32 = 6;

/// Two triangles over each of `count` blocks, row by row: the block, and the corner in it.
fn squares(gl: &Gl, [across, up]: [u32; 2]) -> Result<VertexArray, GpuError> {
    let corners = [(0, 0), (1, 0), (0, 1), (0, 1), (1, 0), (1, 1)];
    let blocks = (0..up).flat_map(|y| (0..across).map(move |x| (x, y)));
    let vertices: Vec<Vec4> = blocks
        .flat_map(|(x, y)| {
            corners.map(|(right, top)| Vec4::new(x as f32, y as f32, right as f32, top as f32))
        })
        .collect();
    let buffer = Buffer::vertices(gl, Usage::Static, &vertices)?;
    VertexArray::builder(gl)
        .attribute(&buffer, Attribute::f32(0, 4))
        .build()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};
    use proptest::prelude::*;

    const SIZE: [u32; 2] = [83, 61];

    /// Rectangles of the mask with their channel, the later over the earlier.
    fn masks() -> impl Strategy<Value = Vec<(usize, [u32; 4])>> {
        let side = (0..83u32, 0..61u32, 1..50u32, 1..50u32);
        let rectangle = (0..3_usize, side.prop_map(|(x, y, w, h)| [x, y, w, h]));
        proptest::collection::vec(rectangle, 0..4)
    }

    /// The line by the words of its shader, pixel by pixel; rows count from the top.
    fn expected(mask: &[u8], reach: i32) -> Vec<[u8; 4]> {
        let [width, height] = SIZE.map(u32::cast_signed);
        let at = |x: i32, y: i32, channel: usize| {
            let (x, y) = (x.clamp(0, width - 1), y.clamp(0, height - 1));
            mask[(y * width + x) as usize * 4 + channel] > 127
        };
        let near = |x: i32, y: i32, channel: usize| {
            let aside = -reach..=reach;
            let disc = aside
                .clone()
                .flat_map(|dy| aside.clone().map(move |dx| (dx, dy)));
            let mut disc = disc.filter(|(dx, dy)| dx * dx + dy * dy <= reach * reach);
            !at(x, y, channel) && disc.any(|(dx, dy)| at(x + dx, y + dy, channel))
        };
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        // The active shape first, then those selected with it, then the one under the pointer.
        let color = |(x, y)| match [0, 2, 1].into_iter().find(|&channel| near(x, y, channel)) {
            Some(0) => [255, 0, 0, 255],
            Some(1) => [0, 255, 0, 255],
            Some(_) => [255, 255, 0, 255],
            None => [0, 0, 255, 255],
        };
        pixels.map(color).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        #[test]
        fn the_line_lies_round_the_mask_and_no_block_of_it_is_left_out(
            rectangles in masks(),
            width in 1..7u32,
            samples in prop::sample::select(vec![0, 4]),
        ) {
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let gl = headless.gl();
            let [mask, plain] = [(); 2].map(|()| Framebuffer::new(gl, SIZE[0], SIZE[1], 0).unwrap());
            let target = Framebuffer::new(gl, SIZE[0], SIZE[1], samples).unwrap();
            mask.clear([0.0; 4]);
            let mut area = Area::EMPTY;
            for (channel, [x, y, w, h]) in rectangles {
                let end = [(x + w).min(SIZE[0]), (y + h).min(SIZE[1])];
                let here = Area { first: [x, y], end };
                area = area.union(here);
                let mut color = [0.0, 0.0, 0.0, 1.0];
                color[channel] = 1.0;
                plain.clear(color);
                let [x, y, width, height] = here.rectangle();
                let place = crate::gpu::Rect { x, y, width, height };
                plain.blit_into(&mask, place, place).unwrap();
            }
            target.clear([0.0, 0.0, 1.0, 1.0]);
            let other = Vec3::new(1.0, 1.0, 0.0);
            let edge = Edge { selected: Vec3::X, hovered: Vec3::Y, other, width };
            EdgePass::new(gl).unwrap().draw(gl, &mask, area, &edge, &target).unwrap();
            let expected = expected(&mask.read_rgba().unwrap(), width.cast_signed());
            let found = target.read_rgba().unwrap();
            for (index, (found, expected)) in found.chunks_exact(4).zip(&expected).enumerate() {
                let at = (index as u32 % SIZE[0], index as u32 / SIZE[0]);
                prop_assert_eq!(found, expected, "at {:?}", at);
            }
        }
    }
}
