//! Several contexts on one thread, and the end of each.

use std::any::Any;

use editor_core::gpu::{
    Attribute, Backend, Buffer, Gl, HeadlessContext, IndexBuffer, Primitive, Rect, Usage,
    VertexArray,
};
use editor_core::render::{InterfacePainter, Marks, Offscreen, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{Scene, ShapeKind, ViewSettings};
use glam::Vec3;

use crate::offscreen::gpu::{OPAQUE_RED, fill, lower_left_half};
use crate::offscreen::support::{BLACK, Picture, RED, black, draw_scene, flat_program};

#[test]
fn contexts_live_side_by_side_and_objects_find_their_own() {
    let contexts = [Backend::Egl, Backend::Osmesa, Backend::Egl, Backend::Osmesa]
        .map(|backend| HeadlessContext::new(backend).expect("a context"));
    let mut shapes: Vec<_> = contexts
        .iter()
        .map(|context| {
            let gl = context.gl();
            (
                black(gl, 8, 8, 0),
                flat_program(gl),
                lower_left_half(gl, 0.0),
            )
        })
        .collect();
    // Objects keep their contexts alive.
    drop(contexts);
    // EGL must not believe that its only context is still current after OSMesa's.
    shapes.remove(2);
    for (framebuffer, program, shape) in shapes.iter().chain(&shapes) {
        framebuffer.bind();
        fill(program, shape, OPAQUE_RED);
        assert_eq!(Picture::of(framebuffer).at(1, 6), RED);
    }
}

#[test]
fn a_hundred_contexts_one_after_the_other_are_no_problem() {
    for index in 0..100 {
        let backend = if index % 2 == 0 {
            Backend::Egl
        } else {
            Backend::Osmesa
        };
        let context = HeadlessContext::new(backend).expect("a context");
        assert_eq!(context.backend(), backend);
        black(context.gl(), 8, 8, 0);
        context.gl().check("a small picture").expect("no fault");
    }
}

fn two_contexts() -> [HeadlessContext; 2] {
    [Backend::Egl, Backend::Osmesa].map(|b| HeadlessContext::new(b).expect("a context"))
}

/// egui's output for a white picture, ten points on each side.
fn white_panel(context: &egui::Context) -> egui::FullOutput {
    let size = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::Vec2::splat(10.0));
    let input = egui::RawInput {
        screen_rect: Some(size),
        ..Default::default()
    };
    context.run_ui(input, |ui| {
        ui.painter().rect_filled(size, 0.0, egui::Color32::WHITE);
    })
}

#[test]
fn renderers_of_two_contexts_take_turns_and_each_draws_its_own_pictures() {
    let contexts = two_contexts();
    let mut renderers = contexts
        .each_ref()
        .map(|context| Renderer::new(context.gl()).expect("a renderer"));
    let mut cube = Scene::new();
    cube.add(NewShape::new("Cube", ShapeKind::Cube));
    let mut ball = Scene::new();
    ball.add(NewShape::new("Ball", ShapeKind::Sphere));
    let mut draw = |which: usize, scene: &Scene| {
        let (gl, view) = (contexts[which].gl(), ViewSettings::default());
        let renderer = &mut renderers[which];
        draw_scene(renderer, gl, (32, 24), scene, &view, Marks::default())
    };
    let [cube_here, ball_there] = [draw(0, &cube), draw(1, &ball)];
    let [ball_here, cube_there] = [draw(0, &ball), draw(1, &cube)];
    assert!(cube_here == cube_there && ball_here == ball_there);
    assert!(cube_here != ball_here);
    contexts
        .iter()
        .for_each(|context| context.gl().check("both").expect("no fault"));
}

#[test]
fn objects_of_two_contexts_are_not_used_together() {
    let contexts = two_contexts();
    let [here, there] = contexts.each_ref().map(HeadlessContext::gl);
    let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let buffer = |gl: &Gl| Buffer::vertices(gl, Usage::Static, &corners).expect("a buffer");
    let indices = |gl: &Gl| IndexBuffer::new(gl, Usage::Static, &[0, 1, 2]).expect("indices");
    let array = |vertices: &Gl, order: &Gl| {
        VertexArray::builder(here)
            .attribute(&buffer(vertices), Attribute::f32(0, 3))
            .indices(&indices(order))
            .build()
    };
    assert!(array(here, here).is_ok());
    assert!(array(there, here).is_err());
    assert!(array(here, there).is_err());

    let pictures = [here, there].map(|gl| black(gl, 10, 10, 0));
    let whole = Rect {
        x: 0,
        y: 0,
        width: 10,
        height: 10,
    };
    assert!(pictures[0].blit_into(&pictures[1], whole, whole).is_err());

    pictures[0].bind();
    lower_left_half(here, 0.0).draw(&flat_program(there), Primitive::Triangles, 0..3);
    let message = here
        .check("a foreign program")
        .expect_err("a fault")
        .to_string();
    assert!(message.contains("program of another context"), "{message}");

    let context = egui::Context::default();
    let mut painter = InterfacePainter::new(here).expect("a painter");
    painter.paint(&context, white_panel(&context), &pictures[1]);
    let message = here
        .check("a foreign picture")
        .expect_err("a fault")
        .to_string();
    assert!(message.contains("picture of another context"), "{message}");
    for picture in &pictures {
        assert_eq!(Picture::of(picture).count(|pixel| pixel != BLACK), 0);
    }
    // The textures of what was not painted are there all the same.
    painter.paint(&context, white_panel(&context), &pictures[0]);
    assert_eq!(Picture::of(&pictures[0]).at(5, 5), [255; 4]);
}

#[test]
fn a_painter_paints_after_everything_else_of_its_context_is_dropped() {
    for backend in [Backend::Egl, Backend::Osmesa] {
        let offscreen = Offscreen::new(backend).expect("a context");
        let context = egui::Context::default();
        let mut painter = InterfacePainter::new(offscreen.gl()).expect("a painter");
        let target = black(offscreen.gl(), 10, 10, 0);
        drop(offscreen);
        painter.paint(&context, white_panel(&context), &target);
        assert_eq!(Picture::of(&target).at(5, 5), [255; 4], "{backend:?}");
        drop(target);
        drop(painter);
    }
}

#[test]
fn owners_are_dropped_in_any_order_with_another_context_in_between() {
    for first in 0..4 {
        let other = HeadlessContext::new(Backend::Osmesa).expect("a context");
        let offscreen = Offscreen::new(Backend::Egl).expect("a context");
        let gl = offscreen.gl().clone();
        let mut owners: Vec<Box<dyn Any>> = vec![
            Box::new(InterfacePainter::new(&gl).expect("a painter")),
            Box::new(black(&gl, 4, 4, 4)),
            Box::new((lower_left_half(&gl, 0.0), flat_program(&gl))),
            Box::new(offscreen),
        ];
        drop(gl);
        owners.rotate_left(first);
        for owner in owners {
            let picture = black(other.gl(), 4, 4, 0);
            drop(owner);
            fill(
                &flat_program(other.gl()),
                &lower_left_half(other.gl(), 0.0),
                OPAQUE_RED,
            );
            assert_eq!(Picture::of(&picture).at(0, 3), RED);
        }
    }
}

#[test]
fn another_thread_waits_until_the_contexts_of_this_one_are_gone() {
    let own = HeadlessContext::new(Backend::Auto).expect("a context");
    let picture = black(own.gl(), 8, 8, 0);
    let (sender, made) = std::sync::mpsc::channel();
    let other = std::thread::spawn(move || {
        let context = HeadlessContext::new(Backend::Auto).expect("a context");
        sender.send(()).expect("somebody listens");
        drop(context);
    });
    drop(own);
    // Objects keep their contexts alive.
    let early = made.recv_timeout(std::time::Duration::from_millis(300));
    assert!(early.is_err(), "both threads have a context");
    drop(picture);
    made.recv().expect("now it is made");
    other.join().expect("no panic");
}
