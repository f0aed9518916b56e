//! The program as eframe runs it: panels, and the scene below them.

use super::address::leave_link;
use super::error_watch::ErrorWatch;
use super::page::Page;
use super::{browser, fonts, rescue, resolution};
use crate::gpu::{CanvasContext, Rect};
use crate::program::{FingerPresses, Graphics, Pass, allow_for_slow_frames, input_parts};
use crate::render::view_place;
use crate::revision::Revision;
use eframe::{CreationContext, Frame};
use egui::{Event, RawInput, Shape, Ui};
use std::cell::RefCell;
use std::error::Error;
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;
use web_sys::WebGl2RenderingContext;

/// What eframe runs as long as one context of WebGL lives.
pub(super) struct Application {
    page: Rc<RefCell<Page>>,
    context: CanvasContext,
    errors: ErrorWatch,
    presses: FingerPresses,
    /// Events of the next frames: each has one of the parts that egui is given.
    later: Vec<Event>,
    /// Whether there has been a picture.
    is_shown: bool,
    /// The document that is open, once the program has started.
    opened: Option<Revision>,
    /// The document whose unsaved work is at hand for a panic.
    remembered: Option<Revision>,
}

thread_local! {
    /// Everything made with WebGL. egui's painter calls back for the scene with functions that must be
    /// free to move between threads, which graphics are not.
    static GRAPHICS: RefCell<Option<Graphics>> = const { RefCell::new(None) };
}

impl Application {
    /// Shows `page` in the canvas whose context is `context`.
    ///
    /// # Errors
    /// If WebGL refuses something that every picture needs.
    pub fn new(
        creation: &CreationContext,
        context: WebGl2RenderingContext,
        page: Rc<RefCell<Page>>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let gl = creation.gl.clone().ok_or("There is no WebGL.")?;
        fonts::set(&creation.egui_ctx);
        resolution::draw_on_change(&creation.egui_ctx);
        let context = CanvasContext::new(context, gl)?;
        let graphics = Graphics::new(context.gl())?;
        let info = graphics.info();
        GRAPHICS.with(|kept| *kept.borrow_mut() = Some(graphics));
        page.borrow_mut().use_graphics(info, &creation.egui_ctx);
        Ok(Self {
            page,
            errors: ErrorWatch::new(context.gl()),
            context,
            presses: FingerPresses::default(),
            later: Vec::new(),
            is_shown: false,
            opened: None,
            remembered: None,
        })
    }
}

impl Drop for Application {
    fn drop(&mut self) {
        GRAPHICS.with(|kept| kept.borrow_mut().take());
    }
}

impl eframe::App for Application {
    fn ui(&mut self, root: &mut Ui, _: &mut Frame) {
        let context = root.ctx().clone();
        let mut page = self.page.borrow_mut();
        let Some((program, host)) = page.running() else {
            return;
        };
        host.begin_frame();
        host.take_dropped(&context);
        host.set_pasted(context.input(|input| pasted(&input.events)));
        let came_in = program.begin_frame(host);
        // The scene lies below everything that the panels paint.
        let below = root.painter().add(Shape::Noop);
        let shown = program.show(root, Pass::Input, host);
        let rect = shown.panels.view_rect;
        let view = size_in_pixels(rect, &context);
        let messages = program.session().messages.count();
        let wait = GRAPHICS.with(|graphics| {
            let mut graphics = graphics.borrow_mut();
            let graphics = graphics.as_mut()?;
            // It fails where the context is lost, of which the page is told as well.
            let wait = program.draw(graphics, view, None, host).ok()?;
            Some(wait.min(program.finish_frame(graphics, host)))
        });
        // egui's painter draws into whatever is bound.
        self.context.gl().bind_window();
        self.errors.end_frame();
        root.painter().set(below, scene(rect));
        let document = program.session().document();
        let modified = program.is_modified().then_some(document);
        if self.remembered != modified {
            self.remembered = modified;
            rescue::remember(program.unsaved().zip(host.autosave_entry()));
        }
        let told = program.session().messages.count() != messages;
        let opened = program.session().opened();
        if !program.is_starting()
            && self
                .opened
                .replace(opened)
                .is_some_and(|before| before != opened)
        {
            leave_link();
        }
        let is_first = !program.is_starting() && !self.is_shown;
        self.is_shown |= is_first;
        if is_first {
            let context = context.clone();
            browser::after(Duration::ZERO, move || {
                browser::tell_shown();
                fonts::fetch_signs(&context);
            });
        }
        match wait {
            _ if came_in || shown.changed || told => context.request_repaint(),
            Some(wait) => context.request_repaint_after(wait),
            None => {}
        }
    }

    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut RawInput) {
        allow_for_slow_frames(context, input.time);
        self.presses.count_once(&mut input.events);
        let mut events = std::mem::take(&mut self.later);
        events.append(&mut input.events);
        input.events = events;
        let is_typing = context.text_edit_focused();
        let mut parts = input_parts(std::mem::take(input), is_typing).into_iter();
        *input = parts.next().unwrap_or_default();
        self.later = parts.flat_map(|part| part.events).collect();
        if !self.later.is_empty() {
            context.request_repaint();
        }
    }

    // What egui remembers of its windows is not worth more than a visit.
    fn persist_egui_memory(&self) -> bool {
        false
    }
}

/// The text that the user has the browser paste in this frame, if any.
fn pasted(events: &[Event]) -> Option<String> {
    events.iter().find_map(|event| match event {
        Event::Paste(text) => Some(text.clone()),
        _ => None,
    })
}

/// Width and height of `rect` in pixels of the screen.
fn size_in_pixels(rect: egui::Rect, context: &egui::Context) -> (u32, u32) {
    let scale = context.pixels_per_point();
    let screen = context.content_rect();
    let size = [screen.width(), screen.height()].map(|side| (side * scale).round() as u32);
    let place = view_place(
        (rect.min.x, rect.min.y),
        (rect.max.x, rect.max.y),
        scale,
        (size[0], size[1]),
    );
    (place.width.unsigned_abs(), place.height.unsigned_abs())
}

/// The scene's picture as a shape that fills `rect`.
fn scene(rect: egui::Rect) -> Shape {
    let callback = eframe::egui_glow::CallbackFn::new(|info, _| {
        let place = info.viewport_in_pixels();
        GRAPHICS.with(|graphics| {
            let graphics = graphics.borrow();
            if let Some(scene) = graphics.as_ref().and_then(Graphics::scene_picture) {
                scene.blit_to_window(Rect {
                    x: place.left_px,
                    y: place.from_bottom_px,
                    width: place.width_px,
                    height: place.height_px,
                });
            }
        });
    });
    Shape::Callback(egui::PaintCallback {
        rect,
        callback: Arc::new(callback),
    })
}
