use super::frame::Frame;
use super::renderer::Renderer;
use crate::gpu::{Gl, GpuError, Info};
use crate::scene::Skinning;

/// Textures that a vertex shader reads to skin: palettes and influences.
const TEXTURES_NEEDED: u32 = 2;

/// Who skins: what was asked for, and what it came to.
#[derive(Debug)]
pub(super) struct SkinningChoice {
    asked: Option<Skinning>,
    in_use: Skinning,
}

impl SkinningChoice {
    pub fn automatic(info: &Info) -> Self {
        Self::new(None, info)
    }

    fn new(asked: Option<Skinning>, info: &Info) -> Self {
        // On software OpenGL both are the processor, and one vector at a time is the slower way.
        let automatic = if info.is_software {
            Skinning::Cpu
        } else {
            Skinning::Gpu
        };
        Self {
            asked,
            in_use: asked.unwrap_or(automatic),
        }
    }
}

impl Renderer {
    /// Chooses who skins characters. `None` leaves it to the driver: the graphics card where there
    /// is one, the processor where that draws as well. Whether this makes a difference.
    pub fn set_skinning(&mut self, asked: Option<Skinning>) -> bool {
        if asked == self.skinning.asked {
            return false;
        }
        let before = self.skinning();
        self.skinning = SkinningChoice::new(asked, self.gl.info());
        before != self.skinning()
    }

    /// Who skins characters. The processor, once the graphics card has refused to: see
    /// [`Renderer::take_notices`].
    pub fn skinning(&self) -> Skinning {
        self.skinning.in_use
    }

    /// What the user should know about how pictures are drawn, in plain words; each is told once.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// Uploads what changed; by the other way of skinning, if the graphics card cannot skin these
    /// characters.
    pub(super) fn update_meshes(&mut self, frame: &Frame) -> Result<(), GpuError> {
        if self.skinning() == Skinning::Gpu
            && let Err(error) = self
                .prepare_skinning()
                .and_then(|()| self.update_meshes_by(frame, Skinning::Gpu))
        {
            self.notices.push(format!(
                "The graphics card cannot skin the characters, so the processor does: {error}"
            ));
            self.skinning.in_use = Skinning::Cpu;
        }
        self.update_meshes_by(frame, self.skinning())?;
        self.notices.extend(self.meshes.take_notices());
        Ok(())
    }

    fn update_meshes_by(&mut self, frame: &Frame, skinning: Skinning) -> Result<(), GpuError> {
        let (gl, shading) = (&self.gl, frame.view.shading);
        self.meshes.update(gl, frame.evaluated, shading, skinning)
    }

    fn prepare_skinning(&mut self) -> Result<(), GpuError> {
        let gl: &Gl = &self.gl;
        let available = gl.info().max_vertex_textures;
        if available < TEXTURES_NEEDED {
            return Err(GpuError::Create {
                what: "vertex shader that skins",
                why: format!("{TEXTURES_NEEDED} textures are needed in it, {available} possible"),
            });
        }
        self.surfaces.add_skinned(gl)?;
        self.shadows.add_skinned(gl)?;
        self.outline.add_skinned(gl)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::{Basis, Mesh, Picture};
    use crate::gpu::{Backend, Framebuffer, HeadlessContext};
    use crate::render::mesh_cache::MeshCache;
    use crate::render::{Marks, read_picture};
    use crate::scene::NewShape;
    use crate::scene::{
        CharacterShape, CurveSet, CurveShape, Evaluator, Scene, ShapeKind, ViewSettings,
    };
    use glam::Vec3;
    use std::sync::Arc;

    fn moved_triangle() -> Scene {
        let skeleton = SkeletalModel::new(vec![Joint::default()]).unwrap();
        let mut attachments = Attachments::new();
        for _ in 0..3 {
            attachments.push_vertex([Influence {
                joint: 0,
                weight: 1.0,
            }]);
        }
        let mesh = Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]);
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = Pose::new();
        pose.set_root_offset(0, -Vec3::X);
        shape.set_pose(pose);
        let mut scene = Scene::new();
        scene.add(NewShape::new("Triangle", ShapeKind::Character(shape)));
        scene
    }

    fn picture(renderer: &mut Renderer, gl: &Gl, scene: &Scene) -> Picture {
        let (told, picture) = drawn(renderer, gl, scene);
        told.unwrap();
        picture
    }

    fn drawn(renderer: &mut Renderer, gl: &Gl, scene: &Scene) -> (Result<(), GpuError>, Picture) {
        let evaluated = Evaluator::new().evaluate(scene, 0.0);
        let frame = Frame {
            scene,
            evaluated: &evaluated,
            view: &ViewSettings::default(),
            marks: Marks::default(),
        };
        let target = Framebuffer::new(gl, 64, 48, 0).unwrap();
        let told = renderer.draw(&frame, &target);
        (told, read_picture(&target).unwrap())
    }

    #[test]
    fn what_the_driver_cannot_hold_is_skinned_by_the_processor_and_told_once() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let scene = moved_triangle();
        let mut limited = Renderer::new(gl).unwrap();
        limited.meshes = MeshCache::new(0);
        assert!(limited.set_skinning(Some(Skinning::Gpu)) || !gl.info().is_software);
        let fallen_back = picture(&mut limited, gl, &scene);
        let notices = limited.take_notices();
        assert_eq!(notices.len(), 1, "{notices:?}");
        assert!(notices[0].contains("the processor does"), "{notices:?}");
        assert_eq!(limited.skinning(), Skinning::Cpu);
        assert_eq!(picture(&mut limited, gl, &scene), fallen_back);
        assert!(limited.take_notices().is_empty());

        let mut plain = Renderer::new(gl).unwrap();
        plain.set_skinning(Some(Skinning::Cpu));
        assert_eq!(picture(&mut plain, gl, &scene), fallen_back);
    }

    #[test]
    fn a_mesh_that_the_driver_cannot_take_is_left_out_and_told_and_all_else_is_drawn() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let mut scene = Scene::new();
        let cube = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        scene.shape_mut(cube).unwrap().placement.transform.position = Vec3::X;
        let alone = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);
        scene.add(NewShape::new("Ball", ShapeKind::Sphere));
        let both = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);

        let mut renderer = Renderer::new(gl).unwrap();
        gl.limit_buffers(2000);
        for _ in 0..2 {
            let (told, found) = drawn(&mut renderer, gl, &scene);
            let told = told.unwrap_err().to_string();
            assert!(told.contains("“Ball”") && !told.contains("Cube"), "{told}");
            assert_eq!(found, alone);
        }
        // Once there is memory, another way of drawing it is tried, and not before.
        gl.limit_buffers(i32::MAX);
        assert!(drawn(&mut renderer, gl, &scene).0.is_err());
        let ball = scene.shapes()[1].id;
        scene.delete(ball);
        assert!(drawn(&mut renderer, gl, &scene).0.is_ok());
        scene.add(NewShape::new("Ball", ShapeKind::Sphere));
        assert_eq!(picture(&mut renderer, gl, &scene), both);
    }

    #[test]
    fn lines_that_the_driver_cannot_take_are_left_out_and_told_until_they_are_others() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let mut scene = Scene::new();
        let empty = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);
        let curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
        let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(curve)));
        let mut renderer = Renderer::new(gl).unwrap();
        gl.limit_buffers(250);
        for _ in 0..2 {
            let (told, found) = drawn(&mut renderer, gl, &scene);
            let told = told.unwrap_err().to_string();
            assert!(told.contains("the lines of “Wire”"), "{told}");
            assert_eq!(found, empty);
        }
        gl.limit_buffers(i32::MAX);
        assert!(drawn(&mut renderer, gl, &scene).0.is_err());
        scene.curve_mut(id).unwrap().display.control_points = false;
        assert_ne!(picture(&mut renderer, gl, &scene), empty);
    }

    #[test]
    fn software_leaves_skinning_to_the_processor_and_hardware_takes_it() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let mut info = context.gl().info().clone();
        info.is_software = true;
        assert_eq!(SkinningChoice::automatic(&info).in_use, Skinning::Cpu);
        info.is_software = false;
        assert_eq!(SkinningChoice::automatic(&info).in_use, Skinning::Gpu);
        assert_eq!(
            SkinningChoice::new(Some(Skinning::Cpu), &info).in_use,
            Skinning::Cpu
        );
    }
}
