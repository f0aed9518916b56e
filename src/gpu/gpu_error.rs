//! Errors of the `gpu` layer: [`ContextError`] for getting a context, [`GpuError`] for using it.

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
        /// The loader's message.
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
        /// The step that failed, and why.
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
        /// The window system's message.
        cause: String,
    },
    /// The window system gives no window with OpenGL.
    #[error("no window with OpenGL can be opened ({cause}). {WINDOW_REMEDY}")]
    Window {
        /// The step that failed, and why.
        cause: String,
    },
    /// An existing context stopped working.
    #[error("the graphics context cannot be used: {0}; restart the program")]
    Native(String),
}

impl ContextError {
    /// The error for an event loop that does not start: there is no display, or it does not answer.
    #[must_use]
    pub fn no_display(cause: &impl std::fmt::Display) -> Self {
        let cause = cause.to_string();
        // `winit` starts with the place in its own source at which the failure was noticed.
        let message = cause
            .split_once(".rs:")
            .and_then(|(_, rest)| rest.split_once(": "));
        Self::NoDisplay {
            cause: message
                .map_or(cause.as_str(), |(_, message)| message)
                .trim_end_matches('.')
                .to_owned(),
        }
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub(in crate::gpu) fn window(step: &str, cause: &impl std::fmt::Display) -> Self {
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

/// A failure of an OpenGL operation, in words that name the remedy where there is one.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GpuError {
    /// A shader did not compile. `line` counts from 1 in the shader's body, where the driver names one.
    #[error("shader {label} ({stage}){}: {log}", line.map(|l| format!(", line {l}")).unwrap_or_default())]
    Compile {
        /// The program's label.
        label: String,
        /// `vertex` or `fragment`.
        stage: &'static str,
        /// The first line the driver complains about.
        line: Option<u32>,
        /// The driver's text.
        log: String,
    },
    /// The stages of a program do not fit together.
    #[error("shader {label} does not link: {log}")]
    Link {
        /// The program's label.
        label: String,
        /// The driver's text.
        log: String,
    },
    /// A picture or texture that has no pixels, or more than the driver can hold.
    #[error(
        "a {what} of {width}x{height} pixels cannot be made: each side must be from 1 to {max} \
         with this graphics driver"
    )]
    Size {
        /// The kind of object.
        what: &'static str,
        /// In pixels.
        width: u32,
        /// In pixels.
        height: u32,
        /// The largest side the driver allows, in pixels.
        max: u32,
    },
    /// More samples a pixel than the driver can do.
    #[error(
        "{asked} samples a pixel are more than this graphics driver can do: at most {max} (0 for none)"
    )]
    Samples {
        /// The number asked for.
        asked: u32,
        /// The most that the driver can do.
        max: u32,
    },
    /// Data of the wrong length, or an attribute that does not fit its buffer.
    #[error("{what}: {problem}")]
    Data {
        /// The object concerned.
        what: &'static str,
        /// The problem with it.
        problem: String,
    },
    /// The driver made no object, or none that is complete: usually it ran out of memory.
    #[error(
        "the graphics driver could not make a {what} ({why}); a smaller picture or fewer samples \
         need less memory"
    )]
    Create {
        /// The kind of object.
        what: &'static str,
        /// The driver's reason.
        why: String,
    },
    /// The context and all its objects are gone.
    #[error("the graphics context was lost in {what} ({why}): restart the program")]
    Lost {
        /// The operation.
        what: String,
        /// The platform's reason.
        why: String,
    },
    /// Errors that the driver, or this layer, noticed since the last check.
    #[error("OpenGL reports errors in {what}: {}", faults.join("; "))]
    Faults {
        /// The operation.
        what: String,
        /// One entry a fault, each reported once.
        faults: Vec<String>,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_display_is_reported_without_the_place_in_foreign_source() {
        let cause_of = |cause: &str| match ContextError::no_display(&cause) {
            ContextError::NoDisplay { cause } => cause,
            other => panic!("{other:?}"),
        };
        assert_eq!(
            cause_of("os error at /x/winit-1/linux/mod.rs:788: no X server"),
            "no X server"
        );
        assert_eq!(cause_of("no X server"), "no X server");
        assert_eq!(cause_of("DISPLAY is not set."), "DISPLAY is not set");
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
