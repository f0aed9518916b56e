//! The same crowds where a graphics card draws them, which is not the processor's time but the clock's.

use crate::crowds::Crowd;
use crate::report::Report;
use editor_core::gpu::{Backend, Framebuffer, HeadlessContext, Rect};
use std::time::Instant;

const HEADING: &str = "On a graphics card";
const COUNTS: [usize; 3] = [1, 100, 1000];
/// Seconds for which pictures are counted.
const SECONDS: f64 = 2.0;
/// Bytes that the vertex shader reads and the next step writes for a vertex, at least: position, normal
/// and where its influences are; four influences; what it passes on.
const BYTES_OF_VERTEX: f64 = (12 + 12 + 8 + 4 * 8 + 48) as f64;

pub fn run(report: &mut Report) {
    if !report.is_wanted(HEADING) {
        return;
    }
    let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
    let info = headless.gl().info();
    if info.is_software {
        let renderer = &info.renderer;
        report.tell(
            HEADING,
            format!("Nothing was measured: OpenGL is drawn by the processor here ({renderer})."),
        );
        return;
    }
    report.tell(HEADING, format!("Drawn by {}.", info.renderer));
    let copied = copied_bytes(&headless);
    report.tell(
        HEADING,
        format!(
            "Pictures are copied at {:.0} GB/s, read and written.",
            copied / 1e9
        ),
    );
    drop(headless);
    for count in COUNTS {
        let mut crowd = Crowd::new(count);
        let vertices = crowd.vertices() as f64;
        let pictures = pictures(&mut crowd);
        let share = pictures * vertices * BYTES_OF_VERTEX / copied * 100.0;
        report.tell(HEADING, format!(
            "Characters that all move: {count}. {pictures:.0} pictures a second at 800×600, {:.0} million \
             vertices a second, at least {share:.1} % of what copying reaches.",
            pictures * vertices / 1e6
        ));
    }
}

/// Pictures a second, by the clock.
fn pictures(crowd: &mut Crowd) -> f64 {
    crowd.move_all();
    crowd.headless.gl().finish();
    let start = Instant::now();
    let mut drawn = 0.0;
    while start.elapsed().as_secs_f64() < SECONDS {
        crowd.move_all();
        crowd.headless.gl().finish();
        drawn += 1.0;
    }
    drawn / start.elapsed().as_secs_f64()
}

/// Bytes a second that are read and written while a large picture is copied.
fn copied_bytes(headless: &HeadlessContext) -> f64 {
    const SIDE: u32 = 4096;
    const COPIES: u32 = 50;
    let gl = headless.gl();
    let [from, to] = [0, 1].map(|_| Framebuffer::new(gl, SIDE, SIDE, 0).expect("a picture"));
    from.clear([0.5; 4]);
    let side = SIDE.cast_signed();
    let whole = Rect {
        x: 0,
        y: 0,
        width: side,
        height: side,
    };
    let copy = || {
        for _ in 0..COPIES {
            from.blit_into(&to, whole, whole).expect("a copy");
        }
        gl.finish();
    };
    copy();
    let start = Instant::now();
    copy();
    f64::from(COPIES) * f64::from(SIDE * SIDE) * 8.0 / start.elapsed().as_secs_f64()
}
