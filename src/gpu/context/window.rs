//! A window to draw in, through `glutin`: GLX or EGL on X11, EGL on Wayland, WGL, or CGL.

use std::ffi::CStr;
use std::num::NonZeroU32;
use std::rc::Rc;

use glutin::config::{Config, ConfigTemplateBuilder};
use glutin::context::{
    ContextApi, ContextAttributesBuilder, GlProfile, NotCurrentContext, PossiblyCurrentContext,
    Version,
};
use glutin::display::{Display, DisplayApiPreference, GetGlDisplay as _};
use glutin::prelude::*;
use glutin::surface::{Surface, SurfaceAttributesBuilder, SwapInterval, WindowSurface};
use raw_window_handle::{HasDisplayHandle as _, HasWindowHandle as _, RawWindowHandle};
use winit::event_loop::{ActiveEventLoop, OwnedDisplayHandle};
use winit::window::{Window, WindowAttributes};

use super::NativeContext;
use crate::gpu::{ContextError, Gl};

/// Fields are dropped from top to bottom, each before what it was made from.
struct WindowNative {
    surface: Surface<WindowSurface>,
    context: PossiblyCurrentContext,
    window: Window,
    /// Keeps the connection to the display open, even beyond the event loop.
    _display: OwnedDisplayHandle,
}

/// A window and its OpenGL context.
///
/// It has neither depth nor samples: draw into a [`Framebuffer`](crate::gpu::Framebuffer) and copy
/// that. Drop it, and every object made from its [`Gl`], before the event loop returns.
pub struct WindowContext {
    gl: Gl,
    native: Rc<WindowNative>,
}

impl std::fmt::Debug for WindowContext {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("WindowContext")
            .field("gl", &self.gl)
            .finish_non_exhaustive()
    }
}

impl WindowContext {
    /// Opens a window with OpenGL 3.3 core, or OpenGL ES 3.0 where the driver has only that.
    ///
    /// # Errors
    /// When the window system or the driver refuses; the message names what to try.
    pub fn new(
        event_loop: &ActiveEventLoop,
        attributes: WindowAttributes,
    ) -> Result<Self, ContextError> {
        let (window, config) = open_window(event_loop, attributes)?;
        let handle = window
            .window_handle()
            .map_err(|e| ContextError::window("window handle", &e))?;
        let context = create_context(&config, handle.as_raw())?;
        let size = window.inner_size();
        let surface = SurfaceAttributesBuilder::<WindowSurface>::new().build(
            handle.as_raw(),
            at_least_one(size.width),
            at_least_one(size.height),
        );
        let display = config.display();
        // SAFETY: the handle is that of `window`, which is dropped after the surface: it is declared
        // before it here, and after it in `WindowNative`.
        let surface = unsafe { display.create_window_surface(&config, &surface) }
            .map_err(|error| ContextError::window("surface", &error))?;
        let context = context.treat_as_possibly_current();
        let native = Rc::new(WindowNative {
            surface,
            context,
            window,
            _display: event_loop.owned_display_handle(),
        });
        let shared = Rc::clone(&native) as Rc<dyn NativeContext>;
        // SAFETY: the entry points are those of the display that the context was made on, whose
        // library `glutin` never unloads.
        let gl = unsafe { Gl::new(shared, |name: &CStr| display.get_proc_address(name)) }?;
        // A wish: without it pictures may tear, which is no reason not to start.
        let every_frame = SwapInterval::Wait(NonZeroU32::MIN);
        let _ = native
            .surface
            .set_swap_interval(&native.context, every_frame);
        Ok(Self { gl, native })
    }

    /// The handle to make objects from.
    #[must_use]
    pub fn gl(&self) -> &Gl {
        &self.gl
    }

    /// The window.
    #[must_use]
    pub fn window(&self) -> &Window {
        &self.native.window
    }

    /// Fits the surface to a new size of the window in physical pixels.
    pub fn resize(&self, width: u32, height: u32) {
        // Where this fails, so will the next `swap_buffers`, which reports it.
        if self.gl.make_current().is_ok() {
            let size = (at_least_one(width), at_least_one(height));
            self.native
                .surface
                .resize(&self.native.context, size.0, size.1);
        }
    }

    /// Shows what was drawn into the window. May wait for the screen, and on Wayland for ever
    /// while the window is hidden: draw only when asked to.
    ///
    /// # Errors
    /// When the context or the window was lost.
    pub fn swap_buffers(&self) -> Result<(), ContextError> {
        self.gl.make_current()?;
        let swapped = self.native.surface.swap_buffers(&self.native.context);
        swapped.map_err(|error| ContextError::Native(error.to_string()))
    }
}

impl NativeContext for WindowNative {
    fn make_current(&self) -> Result<(), String> {
        let made = self.context.make_current(&self.surface);
        made.map_err(|error| error.to_string())
    }

    fn release(&self) {
        // There is nothing to be done where this fails; the next context reports.
        let _ = self.context.make_not_current_in_place();
    }
}

/// Zero is what a minimized window has, and what surfaces refuse.
fn at_least_one(pixels: u32) -> NonZeroU32 {
    NonZeroU32::new(pixels).unwrap_or(NonZeroU32::MIN)
}

/// The window and its configuration. X11 needs the configuration before the window, for its
/// visual; Windows needs the window before the display, for its driver.
fn open_window(
    event_loop: &ActiveEventLoop,
    attributes: WindowAttributes,
) -> Result<(Window, Config), ContextError> {
    let refused = |error: winit::error::OsError| ContextError::window("window", &error);
    if cfg!(windows) {
        let window = event_loop.create_window(attributes).map_err(refused)?;
        let handle = window
            .window_handle()
            .map_err(|e| ContextError::window("window handle", &e))?;
        let config = choose_config(event_loop, Some(handle.as_raw()))?;
        return Ok((window, config));
    }
    let config = choose_config(event_loop, None)?;
    let window = glutin_winit::finalize_window(event_loop, attributes, &config).map_err(refused)?;
    Ok((window, config))
}

/// `glutin_winit::DisplayBuilder` would have to panic where there is no configuration.
fn choose_config(
    event_loop: &ActiveEventLoop,
    window: Option<RawWindowHandle>,
) -> Result<Config, ContextError> {
    let handle = event_loop
        .display_handle()
        .map_err(|cause| ContextError::no_display(&cause))?;
    // SAFETY: the handle is the event loop's, which is borrowed here; afterwards `WindowNative`
    // keeps the connection behind it open for as long as anything is left of the display.
    let display = unsafe { Display::new(handle.as_raw(), preference(window)) }
        .map_err(|error| ContextError::window("display", &error))?;
    let mut template = ConfigTemplateBuilder::new()
        .with_depth_size(0)
        .with_stencil_size(0);
    if let Some(window) = window {
        template = template.compatible_with_native_window(window);
    }
    // SAFETY: the template's window, if any, is alive.
    let mut configs = unsafe { display.find_configs(template.build()) }
        .map_err(|error| ContextError::window("configurations", &error))?;
    // Samples would be wasted: pictures are copied into the window.
    configs
        .by_ref()
        .min_by_key(Config::num_samples)
        .ok_or_else(|| ContextError::window("configurations", &"the display has none"))
}

#[cfg(all(unix, not(target_vendor = "apple")))]
fn preference(_window: Option<RawWindowHandle>) -> DisplayApiPreference {
    DisplayApiPreference::GlxThenEgl(Box::new(winit::platform::x11::register_xlib_error_hook))
}

#[cfg(windows)]
fn preference(window: Option<RawWindowHandle>) -> DisplayApiPreference {
    DisplayApiPreference::WglThenEgl(window)
}

#[cfg(target_vendor = "apple")]
fn preference(_window: Option<RawWindowHandle>) -> DisplayApiPreference {
    DisplayApiPreference::Cgl
}

/// OpenGL 3.3 core, else OpenGL ES 3.0. The first failure is the one returned.
fn create_context(
    config: &Config,
    window: RawWindowHandle,
) -> Result<NotCurrentContext, ContextError> {
    let core = ContextAttributesBuilder::new()
        .with_context_api(ContextApi::OpenGl(Some(Version::new(3, 3))))
        .with_profile(GlProfile::Core)
        .build(Some(window));
    let es = ContextAttributesBuilder::new()
        .with_context_api(ContextApi::Gles(Some(Version::new(3, 0))))
        .build(Some(window));
    let display = config.display();
    // SAFETY: the window is alive, as the caller holds it.
    unsafe {
        display
            .create_context(config, &core)
            .or_else(|error| display.create_context(config, &es).map_err(|_| error))
            .map_err(|error| ContextError::TooOld {
                found: format!("below 3.3 ({error})"),
            })
    }
}
