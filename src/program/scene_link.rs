//! The document as a link.

use super::Host;
use super::running::Program;
use crate::editor::Severity;
use crate::io::{self, scene_link};

impl Program {
    /// Puts a link to a page that shows the document on the clipboard.
    pub(super) fn copy_link(&mut self, host: &mut dyn Host) {
        let text = io::scene_text(self.session.scene(), &self.document_view(), None);
        let text = match text {
            Ok(text) => text,
            Err(error) => return self.tell(Severity::Error, format!("Not copied: {error}")),
        };
        let letters = scene_link::to_link(&text);
        match letters.and_then(|letters| host.link(&format!("scene={letters}"))) {
            Some(link) => {
                host.copy_text(link);
                self.tell(Severity::Info, "Copied a link to this scene");
            }
            None => {
                let text = "Not copied: this scene is too large for a link. File ⏵ Save with Files \
                            makes a file of it";
                self.tell(Severity::Error, text);
            }
        }
    }
}
