//! The Studio look's ground and the shadows on it.

use super::area::Area;
use super::backdrop_pass::set_gradient;
use super::batches::{batches, parts_within};
use super::frame::{Background, Frame, PassContext};
use super::mesh_cache::MeshCache;
use super::mesh_programs::MeshPrograms;
use super::rows::Rows;
use super::shown_triangles::Purpose;
use super::surface_pass::surfaces;
use crate::gpu::{
    Attribute, Blend, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive, Program,
    Usage, VertexArray,
};
use crate::scene::Camera;
use glam::{Mat4, Vec2, Vec3, Vec4};
use std::ops::Range;

/// From the ground to the light that throws shadows: the key light as it stands for the first
/// view. It stays there when the camera turns, for shadows that wander over the ground would look
/// as if the shapes did.
const LIGHT: Vec3 = Vec3::new(-0.45, 1.0, 0.55);

/// Draws the shadows on the Studio look's ground: every surface, flattened onto the plane of the
/// ground along the light, as the camera sees it there. A shadow map would have to be fitted to the
/// size of the scene, which need not be known here, and edges are as fine as pixels.
#[derive(Debug)]
pub(super) struct ShadowPass {
    programs: MeshPrograms,
    picture: Option<Framebuffer>,
}

impl ShadowPass {
    pub fn new(gl: &Gl) -> Self {
        let fragment = include_str!("../../shaders/shadow_fragment.glsl");
        Self {
            programs: MeshPrograms::new(gl, "shadow", fragment),
            picture: None,
        }
    }

    /// Compiles the programs for skinned meshes.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.programs.add_skinned(gl)
    }

    /// A picture as large as the one that is drawn, white where the ground is in shadow: in those of
    /// `others`, if there are any, and those of the shapes. Afterwards it is bound.
    pub fn draw(
        &mut self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
        others: Option<&Framebuffer>,
    ) -> Result<&Framebuffer, GpuError> {
        let (width, height) = (context.width, context.height);
        let picture = Framebuffer::fitting(&mut self.picture, gl, width, height)?;
        match others {
            Some(others) => others.copy_into(picture)?,
            None => picture.clear([0.0; 4]),
        }
        let scene = (context, frame, meshes);
        draw_shadows(gl, scene, &self.programs, picture, 0..u64::MAX);
        Ok(picture)
    }

    /// Adds the shadows of some of the triangles of `frame` to `picture`, which is as large as what is drawn: of
    /// those that [`parts_within`] counts. Returns their number.
    pub fn draw_part(
        &self,
        gl: &Gl,
        scene: (&PassContext, &Frame, &MeshCache),
        picture: &Framebuffer,
        triangles: Range<u64>,
    ) -> u64 {
        draw_shadows(gl, scene, &self.programs, picture, triangles)
    }
}

fn draw_shadows(
    gl: &Gl,
    (context, frame, meshes): (&PassContext, &Frame, &MeshCache),
    programs: &MeshPrograms,
    picture: &Framebuffer,
    triangles: Range<u64>,
) -> u64 {
    picture.bind();
    let state = DrawState {
        depth_test: DepthTest::Off,
        depth_write: false,
        ..DrawState::opaque(context.width, context.height)
    };
    state.apply(gl);
    let clip_from_world = context.clip_from_world * ground_from_world(context.ground);
    let all = batches(surfaces(frame), meshes, Purpose::Shadow);
    let (parts, count) = parts_within(all, triangles);
    for (batch, part) in parts {
        let program = programs.of(batch.mesh);
        meshes.place(program, &batch);
        program.set_mat4("clip_from_world", clip_from_world);
        program.set_f32("ground", context.ground);
        (batch.mesh).draw(program, Purpose::Shadow, part, batch.copies());
    }
    count
}

/// Moves every point along the light onto the plane y = `ground`.
pub(super) fn ground_from_world(ground: f32) -> Mat4 {
    let along = LIGHT / LIGHT.y;
    let mut flattened = Mat4::IDENTITY;
    flattened.y_axis = Vec4::new(-along.x, 0.0, -along.z, 0.0);
    flattened.w_axis = (along * ground).extend(1.0);
    flattened
}

/// Texture unit of the shadows.
const SHADOWS: u32 = 0;
/// Share of what is behind the ground that its light covers, in the middle.
pub(super) const LIT: f32 = 0.6;
/// Width of a shadow's fading edge in the world.
const SOFTNESS: f32 = 0.07;

/// Height of the eye above the ground, by the distance of the near plane, up to which the ground may be seen before that.
const SEEN_NEAR: f32 = 4.0;

/// The Studio look's ground: a grid, one unit wide, every tenth line stronger,
/// and shadows with soft edges. Before a transparent background only the shadows.
#[derive(Debug)]
pub(super) struct GroundPass {
    plain: Program,
    shadowed: Program,
    square: VertexArray,
}

/// The picture of shadows, and the pixels of the ground outside of which none is seen.
pub(super) struct Shadows<'a> {
    pub picture: &'a Framebuffer,
    pub area: Area,
}

impl GroundPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let fragment = include_str!("../../shaders/ground_fragment.glsl");
        let program = |label, fragment: &str| {
            let vertex = include_str!("../../shaders/ground_vertex.glsl");
            Program::when_used(gl, label, vertex, fragment)
        };
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
        let buffer = Buffer::vertices(gl, Usage::Static, &corners.map(|(x, z)| Vec2::new(x, z)))?;
        let square = VertexArray::builder(gl)
            .attribute(&buffer, Attribute::f32(0, 2))
            .build()?;
        Ok(Self {
            plain: program("ground", fragment),
            shadowed: program(
                "ground with shadows",
                &format!("#define SHADOWS\n{fragment}"),
            ),
            square,
        })
    }

    /// Draws it as [`GroundPass::draw`] does, with the shadows of all shapes of `frame`, if there is a picture of
    /// them.
    pub fn draw_all(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        shadows: Option<&Framebuffer>,
        within: Area,
        target: &Framebuffer,
    ) {
        let shadows = shadows.map(|picture| Shadows {
            picture,
            area: shadow_area(context, frame),
        });
        let camera = &frame.view.camera;
        self.draw(gl, context, camera, shadows, within, target);
    }

    /// Draws it, after everything opaque: seen from above it hides what is below, but from below
    /// everything is seen through it. The picture of `shadows` is as large as `target`, white where the
    /// ground is in shadow: looking at it is most of the work, so that is done in their area alone.
    /// Nothing is drawn outside of `within`.
    pub fn draw(
        &self,
        gl: &Gl,
        context: &PassContext,
        camera: &Camera,
        shadows: Option<Shadows>,
        within: Area,
        target: &Framebuffer,
    ) {
        let shadowed = shadows.map_or(Area::EMPTY, |shadows| {
            shadows.picture.bind_texture_with_mipmaps(SHADOWS);
            shadows.area.within(within)
        });
        target.bind();
        let state = DrawState {
            depth_write: false,
            blend: Blend::Premultiplied,
            ..DrawState::opaque(context.width, context.height)
        };
        let shadowed = [shadowed].into_iter().filter(|area| !area.is_empty());
        let parts = shadowed.clone().map(|area| (&self.shadowed, area));
        let area = shadowed.clone().next().unwrap_or(Area::EMPTY);
        for (program, area) in parts.chain(area.outside(within).map(|area| (&self.plain, area))) {
            let part = DrawState {
                scissor: Some(area.rectangle()),
                ..state
            };
            part.apply(gl);
            prepare(program, context, camera);
            self.square.draw(program, Primitive::TriangleStrip, 0..4);
        }
        if hides_below(context, camera) && camera.eye().y - context.ground < SEEN_NEAR * camera.near
        {
            self.draw_near(
                gl,
                context,
                camera,
                DrawState {
                    depth_test: DepthTest::Off,
                    scissor: Some(within.rectangle()),
                    ..state
                },
            );
        }
    }

    /// Draws the part before the near plane, where a camera just above the ground would look through it: nothing else can
    /// be before that.
    fn draw_near(&self, gl: &Gl, context: &PassContext, camera: &Camera, state: DrawState) {
        state.apply(gl);
        prepare(&self.plain, context, camera);
        self.plain.set_f32("near", camera.near);
        self.square
            .draw(&self.plain, Primitive::TriangleStrip, 0..4);
    }
}

/// Sets the uniforms of a program of the ground.
fn prepare(program: &Program, context: &PassContext, camera: &Camera) {
    // As far as it can be distinguished from the horizon, around the camera's target; not beyond the
    // far plane.
    let reach = (camera.radius * 12.0).max(20.0).min(camera.far);
    program.set_mat4("clip_from_world", context.clip_from_world);
    program.set_vec2("center", Vec2::new(camera.target.x, camera.target.z));
    program.set_f32("reach", reach);
    program.set_f32("height", context.ground);
    program.set_f32("near", 0.0);
    program.set_sampler("shadows", SHADOWS);
    program.set_f32("softness", SOFTNESS);
    let is_shown = context.background == Background::Look;
    let is_opaque = hides_below(context, camera);
    program.set_f32("opaque", f32::from(is_opaque));
    program.set_f32("lit", if is_opaque { LIT } else { 0.0 });
    program.set_f32("grid", f32::from(is_shown));
    set_gradient(program, context);
    program.set_f32("picture_height", context.height as f32);
    program.set_vec3("ground", context.colors.ground);
    program.set_vec3("line_color", context.colors.grid);
    program.set_f32("darkness", context.colors.darkness);
}

/// The pixels of the ground outside of which no shadow is seen: round the boxes of the shapes as they
/// are flattened onto it, as far as a soft edge reaches.
pub(super) fn shadow_area(context: &PassContext, frame: &Frame) -> Area {
    let size = [context.width, context.height];
    let clip_from_world = context.clip_from_world * ground_from_world(context.ground);
    let hard = surfaces(frame).fold(Area::EMPTY, |all, (_, evaluated)| {
        let corners = evaluated.world_box().corners();
        all.union(Area::around(&corners, clip_from_world, size))
    });
    if hard.is_empty() {
        return hard;
    }
    let rows = Rows::new(context.clip_from_world, context.ground, size);
    let mut soft = hard;
    let mut aside = 0;
    for row in 0..size[1] {
        let Some(world_per_pixel) = rows.world_per_pixel(row) else {
            continue;
        };
        let reach = reach(f64::from(SOFTNESS) / world_per_pixel);
        if row + reach >= hard.first[1] && row < hard.end[1] + reach {
            soft.first[1] = soft.first[1].min(row);
            soft.end[1] = soft.end[1].max(row + 1);
            aside = aside.max(reach);
        }
    }
    soft.first[0] = soft.first[0].saturating_sub(aside);
    soft.end[0] = (soft.end[0] + aside).min(size[0]);
    soft
}

/// How far aside the shader looks for shadows, in pixels, whose edges are `radius` pixels soft: its
/// outermost look, and twice a pixel of the version of the picture that it looks at there, which may be
/// a little larger than a power of two of the picture's own.
fn reach(radius: f64) -> u32 {
    let radius = radius.clamp(1.0, 64.0) * 1.01;
    (0.75 * radius + 2.5 * radius.log2().ceil().exp2() + 2.0).ceil() as u32
}

/// Whether the ground hides what is below it: seen from below, or without a background, it does not.
pub(super) fn hides_below(context: &PassContext, camera: &Camera) -> bool {
    camera.eye().y > context.ground && context.background == Background::Look
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};
    use crate::render::Backdrop;
    use crate::render::sight::Sight;
    use crate::render::tile::Tile;
    use crate::scene::{Evaluator, Look, NewShape, Scene, ShapeKind, Skinning, ViewSettings};
    use proptest::prelude::*;

    /// Figures of pillars and balls, and cameras from everywhere above and below the ground.
    fn scenes() -> impl Strategy<Value = (Scene, Camera)> {
        let shape = (
            any::<bool>(),
            -4.0..4.0f32,
            0.0..2.0f32,
            -4.0..4.0f32,
            0.1..1.5f32,
        );
        let shapes = proptest::collection::vec(shape, 1..4);
        let camera = (0.5..40.0f32, -180.0..180.0f32, -20.0..89.0f32);
        (shapes, camera).prop_map(|(shapes, (radius, theta, phi))| {
            let mut scene = Scene::new();
            for (is_ball, x, y, z, size) in shapes {
                let kind = if is_ball {
                    ShapeKind::Sphere
                } else {
                    ShapeKind::Cube
                };
                let id = scene.add(NewShape::new("A", kind));
                let transform = &mut scene.shape_mut(id).unwrap().placement.transform;
                transform.position = Vec3::new(x, y, z);
                transform.scale = Vec3::new(size, 2.0 * size, size);
            }
            let camera = Camera {
                radius,
                theta: theta.to_radians(),
                phi: phi.to_radians(),
                ..Camera::default()
            };
            (scene, camera)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn no_shadow_is_seen_outside_of_the_area_of_shadows((scene, camera) in scenes()) {
            const SIZE: (u32, u32) = (173, 131);
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let gl = headless.gl();
            let evaluated = Evaluator::new().evaluate(&scene, 0.0);
            let view = ViewSettings { camera, look: Look::Studio, grid: true, ..ViewSettings::default() };
            let frame = Frame::plain(&scene, &evaluated, &view);
            let tile = Tile::whole(SIZE);
            let context = PassContext {
                width: SIZE.0,
                height: SIZE.1,
                tile,
                background: Background::Look,
                clip_from_world: camera.clip_from_world(tile.aspect()),
                ground: -0.3,
                colors: Backdrop::default().colors(Look::Studio),
            };
            let mut meshes = MeshCache::new(gl.info().max_texture_size);
            let sight = Sight::new(&context, &frame);
            meshes.update(gl, &frame, &sight, Skinning::Cpu).unwrap();
            let mut pass = ShadowPass::new(gl);
            let ground = GroundPass::new(gl).unwrap();
            let picture = pass.draw(gl, &context, &frame, &meshes, None).unwrap();
            let whole = Area::whole([SIZE.0, SIZE.1]);
            let drawn = |area: Area| {
                let target = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).unwrap();
                target.clear([0.3, 0.4, 0.5, 1.0]);
                let shadows = Some(Shadows { picture, area });
                ground.draw(gl, &context, &camera, shadows, whole, &target);
                target.read_rgba().unwrap()
            };
            let everywhere = drawn(whole);
            let area = shadow_area(&context, &frame);
            prop_assert!(drawn(area) == everywhere, "{area:?}");
        }
    }

    #[test]
    fn points_go_along_the_light_to_the_ground_and_those_on_it_stay() {
        let flattened = ground_from_world(-0.5);
        let on_ground = Vec3::new(1.0, -0.5, -2.0);
        let stays = flattened.transform_point3(on_ground);
        assert!(stays.abs_diff_eq(on_ground, 1e-6), "{stays}");
        let above = on_ground + LIGHT * 3.0;
        let found = flattened.transform_point3(above);
        assert!(found.abs_diff_eq(on_ground, 1e-6), "{found}");
    }
}
