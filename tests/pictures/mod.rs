//! The same picture as the course's editor: its own pictures, drawn again in the Course look and
//! compared pixel by pixel. Needs the reference data, see CONTRIBUTING.md.

mod reference;
mod scenes;

use editor_core::geometry::Picture;
use editor_core::gpu::{Backend, Framebuffer, HeadlessContext};
use editor_core::render::{Frame, Renderer, read_picture};
use editor_core::scene::Evaluator;
use reference::{Render, Renders};

/// How far two channels may be apart before a pixel counts, of 255.
const CLEARLY: u8 = 8;
const SLIGHTLY: u8 = 2;
const BACKGROUND: u8 = 26;

/// Of the pixels drawn in either picture, how many may differ clearly and how many slightly.
struct Limits {
    clearly: f64,
    slightly: f64,
}

const SURFACES: Limits = Limits {
    clearly: 0.001,
    slightly: 0.002,
};
const LINES: Limits = Limits {
    clearly: 0.005,
    slightly: 1.0,
};

#[derive(Debug, Default)]
struct Difference {
    drawn: usize,
    clearly: usize,
    slightly: usize,
}

impl Difference {
    fn between(ours: &Picture, theirs: &Picture) -> Self {
        assert_eq!((ours.width, ours.height), (theirs.width, theirs.height));
        let mut difference = Self::default();
        for (a, b) in ours.rgba.chunks_exact(4).zip(theirs.rgba.chunks_exact(4)) {
            let apart = (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
            let is_drawn =
                |pixel: &[u8]| pixel[..3].iter().any(|c| c.abs_diff(BACKGROUND) > CLEARLY);
            difference.drawn += usize::from(is_drawn(a) || is_drawn(b));
            difference.clearly += usize::from(apart > CLEARLY);
            difference.slightly += usize::from(apart > SLIGHTLY);
        }
        difference
    }

    fn is_within(&self, limits: &Limits) -> bool {
        let drawn = self.drawn as f64;
        self.clearly as f64 <= limits.clearly * drawn
            && self.slightly as f64 <= limits.slightly * drawn
    }
}

/// Draws every render that `wanted` picks and collects those beyond `limits`.
fn compare(what: &str, limits: &Limits, wanted: impl Fn(&Render) -> bool) {
    each(what, wanted, |render, ours, theirs| {
        let difference = Difference::between(ours, theirs);
        (!difference.is_within(limits)).then(|| format!("{}: {difference:?}", render.file))
    });
}

/// Draws every render that `wanted` picks and hands it to `fault` with the original's picture.
fn each(
    what: &str,
    wanted: impl Fn(&Render) -> bool,
    fault: impl Fn(&Render, &Picture, &Picture) -> Option<String>,
) {
    let Some(renders) = Renders::read() else {
        return;
    };
    let context = HeadlessContext::new(Backend::Auto).expect("a context");
    let mut renderer = Renderer::new(context.gl()).expect("a renderer");
    let mut compared = 0;
    let mut faults = Vec::new();
    for render in renders.all.iter().filter(|r| wanted(r) && !r.ui) {
        let (scene, view) = scenes::build(&renders, render);
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let frame = Frame::plain(&scene, &evaluated, &view);
        let [width, height] = render.size;
        let target = Framebuffer::new(context.gl(), width, height, 0).expect("a picture");
        renderer.draw(&frame, &target).expect("a drawn frame");
        let ours = read_picture(&target).expect("our picture");
        if let Ok(folder) = std::env::var("EDITOR_KEEP_PICTURES") {
            reference::keep(&folder, &render.file, &ours);
        }
        compared += 1;
        faults.extend(fault(render, &ours, &renders.picture(render)));
    }
    assert!(compared > 0, "no picture of {what} was found");
    assert!(
        faults.is_empty(),
        "{what}, {compared} compared:\n{}",
        faults.join("\n")
    );
}

#[test]
fn the_built_in_shapes_look_as_they_do_there() {
    compare("built-in shapes", &SURFACES, |render| {
        let file = &render.file;
        let is_shape = file.starts_with("shape_") || file.starts_with("cube_");
        // Our teapot is smooth where theirs has facets.
        is_shape && !file.starts_with("shape_teapot")
    });
}

#[test]
fn the_axes_look_as_they_do_there() {
    compare("axes", &LINES, |render| render.file.starts_with("empty_"));
}

#[test]
fn imported_shapes_look_as_they_do_there() {
    compare("imported shapes", &SURFACES, |render| {
        render.file.starts_with("obj_")
    });
}

#[test]
fn posed_characters_look_as_they_do_there() {
    compare("characters as meshes", &SURFACES, |render| {
        render.mode.as_deref() == Some("mesh")
    });
}

#[test]
fn skeletons_look_as_they_do_there() {
    compare("characters as skeletons", &LINES, |render| {
        render.mode.as_deref() == Some("skel")
    });
}

#[test]
fn the_views_of_the_menu_look_as_they_do_there() {
    compare("view presets", &SURFACES, |render| {
        render.file.starts_with("view_") && !render.is_from_above_or_below()
    });
    compare("views from above and below", &SURFACES, |render| {
        render.file.starts_with("view_") && render.is_from_above_or_below()
    });
}

#[test]
fn shaded_surfaces_look_as_they_do_there() {
    compare("shaded surfaces", &SURFACES, |render| {
        render.file.starts_with("swp_") && render.file.contains("_shaded_")
    });
}

#[test]
fn curves_with_frames_look_as_they_do_there() {
    compare("curves with frames", &LINES, |render| {
        render.file.starts_with("swp_") && render.file.contains("_tnb_")
    });
}

#[test]
fn curves_and_surfaces_as_first_shown_look_as_they_do_there() {
    compare("curves and surfaces", &LINES, |render| {
        render.file.starts_with("swp_") && render.file.contains("_default_")
    });
}

/// Theirs leaves out some edges, ours draws all of them: whatever they lit must be lit here.
#[test]
fn wireframes_have_every_edge_that_theirs_have() {
    each(
        "wireframes",
        |render| render.file.contains("_wire_"),
        |render, ours, theirs| {
            let lit = |pixel: &[u8]| pixel[..3].iter().any(|c| c.abs_diff(BACKGROUND) > CLEARLY);
            let pixels = ours.rgba.chunks_exact(4).zip(theirs.rgba.chunks_exact(4));
            let (mut drawn, mut missing) = (0_usize, 0_usize);
            for (a, b) in pixels {
                drawn += usize::from(lit(b));
                missing += usize::from(lit(b) && !lit(a));
            }
            let limit = LINES.clearly * drawn as f64;
            (missing as f64 > limit)
                .then(|| format!("{}: {missing} of {drawn} missing", render.file))
        },
    );
}
