//! What is the same everywhere in the program. A student puts their name here.

/// The program's name.
pub const PROGRAM: &str = "Editor";

/// Your name: it stands in the title of the window, unless `--title` names another.
pub const STUDENT_NAME: &str = "Your Name";

/// Folder of the user's preferences and unsaved work, below the system's folder for such.
pub const SETTINGS_FOLDER: &str = "skeleton-editor";

/// Size of the window at first start, in logical pixels; the course's is 800×600.
pub const WINDOW_SIZE: (f64, f64) = (1280.0, 800.0);

/// Samples a pixel in the window, where the driver has as many.
pub const SAMPLES: u32 = 4;

/// What stands in place of a name until there is one.
const NO_NAME: &str = "Your Name";

/// Your name, once it is given.
pub fn student_name() -> Option<&'static str> {
    Some(STUDENT_NAME).filter(|name| *name != NO_NAME)
}

/// The title of the window: the program's name, and yours once it is given.
pub fn title() -> String {
    student_name().map_or(PROGRAM.to_owned(), title_for)
}

/// The title of the window of somebody called `name`.
pub fn title_for(name: &str) -> String {
    format!("{PROGRAM} — {name}")
}
