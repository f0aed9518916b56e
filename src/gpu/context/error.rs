//! Why there is no OpenGL, and what to do about it.

const EGL_PACKAGES: &str = "install the packages libegl1 and libgl1-mesa-dri \
     (sudo apt-get install libegl1 libgl1-mesa-dri)";
const OSMESA_PACKAGE: &str = "install the package libosmesa6 (sudo apt-get install libosmesa6), \
     or use --gl egl";
const WINDOW_REMEDY: &str = "Try LIBGL_ALWAYS_SOFTWARE=1 in the environment; on Wayland try it \
     without WAYLAND_DISPLAY (env -u WAYLAND_DISPLAY editor); on Debian and Ubuntu install \
     libegl1 libgl1-mesa-dri libgl1 libxcursor1 libxi6 libxrandr2 libxkbcommon-x11-0. \
     Pictures without a window: editor render FILE -o OUT.png";

/// Why no OpenGL context could be made. Each message names what to try.
#[derive(Debug, thiserror::Error)]
pub enum ContextError {
    /// A library is not installed.
    #[error("{library} cannot be loaded ({cause}): {}", library_remedy(library))]
    Library {
        /// Its file name.
        library: &'static str,
        /// The loader's words.
        cause: String,
    },
    /// EGL is there, but none of its devices gives a context.
    #[error(
        "no graphics device gives an OpenGL context through EGL ({}): {EGL_PACKAGES}, or use \
         --gl osmesa",
        tried.join("; ")
    )]
    NoDevice {
        /// One entry a device, with its failure.
        tried: Vec<String>,
    },
    /// OSMesa made no context.
    #[error("OSMesa gives no context ({cause}): use --gl egl")]
    Osmesa {
        /// What failed.
        cause: String,
    },
    /// Neither EGL nor OSMesa works.
    #[error("no OpenGL without a window. EGL: {egl}. OSMesa: {osmesa}.")]
    NoBackend {
        /// Why EGL failed.
        egl: Box<ContextError>,
        /// Why OSMesa failed.
        osmesa: Box<ContextError>,
    },
    /// The driver is older than OpenGL 3.3 and OpenGL ES 3.0.
    #[error(
        "the graphics driver has only OpenGL {found}, and 3.3 is needed: update the driver, or set \
         LIBGL_ALWAYS_SOFTWARE=1 in the environment to draw on the processor"
    )]
    TooOld {
        /// The driver's version string.
        found: String,
    },
    /// There is no display to open a window on.
    #[error(
        "there is no display to open a window on ({cause})\n\
         Start it in a graphical session, or set DISPLAY (ssh -X does).\n\
         Pictures without a window: editor render FILE -o OUT.png"
    )]
    NoDisplay {
        /// The window system's words.
        cause: String,
    },
    /// The window system gives no window with OpenGL.
    #[error("no window with OpenGL can be opened ({cause}). {WINDOW_REMEDY}")]
    Window {
        /// What failed.
        cause: String,
    },
    /// An existing context stopped working.
    #[error("the graphics context cannot be used: {0}; restart the program")]
    Native(String),
}

impl ContextError {
    /// For the failure of an event loop to start: there is no display, or it does not answer.
    #[must_use]
    pub fn no_display(cause: &impl std::fmt::Display) -> Self {
        let cause = cause.to_string();
        // `winit` tells first where in its own source the failure was noticed.
        let told = cause
            .split_once(".rs:")
            .and_then(|(_, rest)| rest.split_once(": "));
        Self::NoDisplay {
            cause: told
                .map_or(cause.as_str(), |(_, told)| told)
                .trim_end_matches('.')
                .to_owned(),
        }
    }

    pub(super) fn window(step: &str, cause: &impl std::fmt::Display) -> Self {
        Self::Window {
            cause: format!("{step}: {cause}"),
        }
    }
}

fn library_remedy(library: &str) -> &'static str {
    if library.contains("OSMesa") {
        OSMESA_PACKAGE
    } else {
        EGL_PACKAGES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_display_is_told_without_the_place_in_foreign_source() {
        let told = |cause: &str| match ContextError::no_display(&cause) {
            ContextError::NoDisplay { cause } => cause,
            other => panic!("{other:?}"),
        };
        assert_eq!(
            told("os error at /x/winit-1/linux/mod.rs:788: no X server"),
            "no X server"
        );
        assert_eq!(told("no X server"), "no X server");
        assert_eq!(told("DISPLAY is not set."), "DISPLAY is not set");
    }

    #[test]
    fn a_missing_library_names_the_package_to_install() {
        let message = |library| {
            ContextError::Library {
                library,
                cause: "not found".to_owned(),
            }
            .to_string()
        };
        assert!(message("libEGL").contains("apt-get install libegl1 libgl1-mesa-dri"));
        assert!(message("libOSMesa").contains("apt-get install libosmesa6"));
    }
}
