//! Contexts without a window.

use super::{Api, egl, osmesa};
use crate::gpu::{ContextError, Gl};

/// Library for contexts without a window.
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

/// A context that draws into [`Framebuffer`](crate::gpu::Framebuffer)s only; there is no window.
///
/// Any number of them may live on one thread, see [`Gl`]. Meanwhile another thread that makes one waits.
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

    /// A context of one kind of OpenGL; [`Backend::Auto`] means EGL here, and OSMesa has no OpenGL ES.
    ///
    /// # Errors
    /// When no driver is found or none has this kind of OpenGL in a version that is new enough.
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

    /// The library that the context came from, never [`Backend::Auto`].
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.backend
    }
}
