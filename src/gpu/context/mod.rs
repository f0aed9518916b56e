//! Where OpenGL comes from: a window, EGL without one, or OSMesa on the processor.

mod egl;
mod error;
mod osmesa;
mod window;

pub use error::ContextError;
pub use window::WindowContext;

use super::Gl;

/// Which library gives a context without a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Backend {
    /// EGL, and OSMesa where that fails.
    #[default]
    Auto,
    /// EGL: the graphics card, or Mesa on the processor. Needs no display.
    Egl,
    /// Mesa on the processor, through `libOSMesa`.
    Osmesa,
}

/// Which dialect of OpenGL is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Api {
    /// OpenGL 3.3 core.
    Gl,
    /// OpenGL ES 3.0, which old and mobile drivers, and browsers, have instead.
    Gles,
}

/// A context that draws into [`Framebuffer`](super::Framebuffer)s only; there is no window.
///
/// Any number of them may live on one thread, see [`Gl`].
#[derive(Debug)]
pub struct HeadlessContext {
    gl: Gl,
    backend: Backend,
}

impl HeadlessContext {
    /// A context of OpenGL 3.3 core, or of OpenGL ES 3.0 where only that exists.
    ///
    /// # Errors
    /// When no driver is found or none is new enough; the message names the package to install.
    pub fn new(backend: Backend) -> Result<Self, ContextError> {
        match backend {
            Backend::Egl | Backend::Osmesa => Self::with_api(backend, Api::Gl)
                .or_else(|error| Self::with_api(backend, Api::Gles).map_err(|_| error)),
            Backend::Auto => Self::new(Backend::Egl).or_else(|egl| {
                Self::new(Backend::Osmesa).map_err(|osmesa| ContextError::NoBackend {
                    egl: Box::new(egl),
                    osmesa: Box::new(osmesa),
                })
            }),
        }
    }

    /// A context of one dialect; [`Backend::Auto`] means EGL here, and OSMesa has no OpenGL ES.
    ///
    /// # Errors
    /// When no driver is found or none speaks this dialect in a version that is new enough.
    pub fn with_api(backend: Backend, api: Api) -> Result<Self, ContextError> {
        let (gl, backend) = match backend {
            Backend::Auto | Backend::Egl => (egl::create(api)?, Backend::Egl),
            Backend::Osmesa => (osmesa::create(api)?, Backend::Osmesa),
        };
        Ok(Self { gl, backend })
    }

    /// The handle to make objects from.
    #[must_use]
    pub fn gl(&self) -> &Gl {
        &self.gl
    }

    /// Which library the context came from, never [`Backend::Auto`].
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.backend
    }
}
