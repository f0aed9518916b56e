//! Which look files without one of their own get when another is chosen in the view.

use super::running::Program;
use crate::revision::Revision;
use crate::scene::Look;

/// What the look was in a document before another was chosen.
#[derive(Clone, Copy, Debug)]
pub(super) struct LookTried {
    /// Which document, by [`crate::editor::Session::opened`].
    opened: Revision,
    /// Its look.
    first: Look,
    /// The look of files without one of their own.
    of_new: Option<Look>,
}

impl Program {
    /// Opens files in `look` from now on, or as before where the document goes back to the look that it had first.
    pub(super) fn choose_look_of_new(&mut self, look: Look) {
        let opened = self.session.opened();
        let known = self.look_tried.filter(|tried| tried.opened == opened);
        self.look_tried = known.or(Some(LookTried {
            opened,
            first: self.session.view().look,
            of_new: self.ui.look_of_new,
        }));
        self.ui.look_of_new = match known {
            Some(tried) if look == tried.first => tried.of_new,
            _ => Some(look),
        };
    }
}
