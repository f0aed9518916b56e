//! Known troubles, and what helps against each.

use super::Report;
use super::machine::Server;
use super::probe::{FailureKind, OpenGl, Outcome};
use crate::program::globals;

/// One sentence or two for everything in `report` that is not as it should be, the most important
/// first. A way to draw pictures that is missing counts only where the other is missing, too.
pub(super) fn advice(report: &Report) -> Vec<&'static str> {
    let mut advice = Vec::new();
    let works = |outcome: &Outcome| outcome.works().is_some();
    if !works(&report.egl) && !works(&report.osmesa) {
        advice.push(
            "Pictures cannot be drawn: neither EGL nor OSMesa works. One of them is enough, and \
             EGL is the faster.",
        );
    }
    advice.extend(report.egl.fails().and_then(|failure| egl(failure.kind)));
    if !works(&report.egl) {
        advice.extend(report.osmesa.fails().map(|failure| match failure.kind {
            FailureKind::NoLibrary => {
                "OSMesa is not installed: sudo apt-get install libosmesa6. Newer versions of Mesa \
                 no longer have it, and EGL does the same."
            }
            _ => {
                "OSMesa has no OpenGL 3.3: update Mesa, and unset MESA_GL_VERSION_OVERRIDE if it \
                 is set."
            }
        }));
    }
    advice.extend(window(report));
    if let Some(driver) = report.best() {
        advice.extend(limits(driver));
    }
    if !report.settings.writable {
        advice.push(
            "Preferences and unsaved work cannot be kept: make the folder of the settings \
             writable, or set XDG_CONFIG_HOME to one that is.",
        );
    }
    advice
}

fn egl(kind: FailureKind) -> Option<&'static str> {
    Some(match kind {
        FailureKind::NoLibrary => {
            "EGL is not installed: sudo apt-get install libegl1 libgl1-mesa-dri."
        }
        FailureKind::NoDevice | FailureKind::TooOld => {
            "EGL finds no driver with OpenGL 3.3: update the graphics driver, or install the one \
             that draws on the processor (sudo apt-get install libgl1-mesa-dri) and set \
             LIBGL_ALWAYS_SOFTWARE=1 in the environment. Unset MESA_GL_VERSION_OVERRIDE and \
             GALLIUM_DRIVER if they are set."
        }
        FailureKind::Crashed | FailureKind::NoAnswer => {
            "The EGL driver crashes or does not answer: set LIBGL_ALWAYS_SOFTWARE=1 in the \
             environment to draw on the processor, and update the graphics driver."
        }
        FailureKind::NoDisplay | FailureKind::Refused => {
            "EGL does not work: set LIBGL_ALWAYS_SOFTWARE=1 in the environment, or use --gl osmesa."
        }
    })
}

fn window(report: &Report) -> Option<&'static str> {
    if report.display.server == Server::None {
        return Some(
            "There is no display, so that no window can be opened: start the program in a \
             graphical session, or log in with ssh -X. render, export, check, compare, diagnose \
             and grade need none.",
        );
    }
    Some(match report.window.as_ref()?.fails()?.kind {
        FailureKind::NoDisplay => {
            "The display does not answer: check that DISPLAY or WAYLAND_DISPLAY name the session \
             that you are in. render, export, check, compare, diagnose and grade need none."
        }
        FailureKind::TooOld => {
            "The window has no OpenGL 3.3: update the graphics driver, or set \
             LIBGL_ALWAYS_SOFTWARE=1 in the environment to draw on the processor."
        }
        _ => {
            "No window with OpenGL can be opened: set LIBGL_ALWAYS_SOFTWARE=1 in the environment; \
             on Wayland try env -u WAYLAND_DISPLAY editor; on Debian and Ubuntu install libegl1 \
             libgl1-mesa-dri libgl1 libxcursor1 libxi6 libxrandr2 libxkbcommon-x11-0."
        }
    })
}

fn limits(driver: &OpenGl) -> Vec<&'static str> {
    let mut advice = Vec::new();
    if driver.software {
        advice.push(
            "Everything is drawn on the processor, which works but is slower. In containers, \
             virtual machines and over ssh -X that is usual; elsewhere install the driver of the \
             graphics card, and unset LIBGL_ALWAYS_SOFTWARE if it is set.",
        );
    }
    if driver.max_samples < globals::SAMPLES {
        advice.push(
            "The driver has fewer samples a pixel than the window asks for: edges look jagged.",
        );
    }
    advice
}
