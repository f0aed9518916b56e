use super::workspace::Workspace;
use crate::disk;
use crate::editor::Severity;
use crate::io::{self, Diagnostic};
use crate::scene::ShapeId;
use std::path::Path;

impl Workspace {
    /// File ▸ Export Curve.
    pub(super) fn export_curve(&mut self, shape: ShapeId, path: &Path) {
        // It may have been deleted while the dialog was open.
        let curves = self.session.scene().curve(shape);
        let Some(text) = curves.map(|shape| io::to_swp(shape.curves())) else {
            let text = format!("Not saved: there is no curve with ID {shape} any more");
            self.session.messages.tell(Severity::Error, text);
            return;
        };
        self.write(path, "swp", &text);
    }

    /// File ▸ Export Geometry.
    pub(super) fn export_geometry(&mut self, path: &Path) {
        let text = io::export_obj(self.session.scene(), self.session.evaluated());
        self.write(path, "obj", &text);
    }

    /// Writes `text` whole or not at all, and tells how that went. A name without the extension
    /// that it needs to be read again is refused rather than changed: the file dialog has asked
    /// whether to replace a file of the name that was typed.
    pub(super) fn write(&mut self, path: &Path, extension: &str, text: &str) {
        let written = io::expect_extension(path, extension)
            .and_then(|()| disk::write_whole(path, text.as_bytes()));
        self.tell_saved(path, written);
    }

    /// Tells how writing a file went.
    pub(super) fn tell_saved(&mut self, path: &Path, written: Result<(), Diagnostic>) {
        let (severity, text) = match written {
            Ok(()) => (Severity::Info, format!("Saved {}", path.display())),
            Err(error) => (Severity::Error, format!("Not saved: {error}")),
        };
        self.session.messages.tell(severity, text);
        self.request_redraw();
    }
}

/// What a dialog calls the file for a shape called `name`, without an extension.
pub(super) fn file_stem(name: &str) -> String {
    let stem: String = name
        .to_lowercase()
        .chars()
        .map(|c| if c.is_alphanumeric() { c } else { '-' })
        .collect();
    match stem.trim_matches('-') {
        "" => "shape".to_owned(),
        stem => stem.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_called_like_its_shape_without_what_file_systems_refuse() {
        assert_eq!(file_stem("Bézier Curve"), "bézier-curve");
        assert_eq!(file_stem("../A:b"), "a-b");
        assert_eq!(file_stem("///"), "shape");
    }
}
