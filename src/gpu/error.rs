//! What can go wrong once a context exists.

/// A failure of an OpenGL operation, in words that name the remedy where there is one.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GpuError {
    /// A shader did not compile. `line` counts from 1 in the shader's body, where the driver told.
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
        /// What was asked for.
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
        /// What was asked for.
        asked: u32,
        /// What the driver can do.
        max: u32,
    },
    /// Data of the wrong length, or an attribute that does not fit its buffer.
    #[error("{what}: {problem}")]
    Data {
        /// The object concerned.
        what: &'static str,
        /// What is wrong with it.
        problem: String,
    },
    /// The driver made no object, or none that is complete: usually it ran out of memory.
    #[error(
        "the graphics driver could not make a {what} ({why}); a smaller picture or fewer samples \
         need less memory"
    )]
    Create {
        /// What was asked for.
        what: &'static str,
        /// The driver's reason.
        why: String,
    },
    /// Parts of a picture that could not be drawn, where all the rest was.
    #[error("not everything is shown: {}", parts.join("; "))]
    LeftOut {
        /// One entry a part, with its reason.
        parts: Vec<String>,
    },
    /// The context and all that it held are gone.
    #[error("the graphics driver was reset while {what}: restart the program")]
    Lost {
        /// What was being done.
        what: String,
    },
    /// Errors that the driver, or this layer, noticed since the last check.
    #[error("OpenGL reports errors in {what}: {}", faults.join("; "))]
    Faults {
        /// What was being done.
        what: String,
        /// One entry a fault, each told once.
        faults: Vec<String>,
    },
}
