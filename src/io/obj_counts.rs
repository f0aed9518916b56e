//! How much an `.obj` file has, by a quick look at its lines.

use super::scanner::QUICK_STRETCH;
use std::str::Lines;

/// How many lines of each kind there are. Those that are spelled in other ways, such as with a tab or
/// behind spaces, are not counted.
#[derive(Default)]
pub(super) struct Counts {
    pub positions: usize,
    pub texture: usize,
    pub normals: usize,
    pub faces: usize,
}

impl Counts {
    /// Counts some of `lines`; whether there may be more.
    pub fn add(&mut self, lines: &mut Lines) -> bool {
        let mut since = 0;
        for line in lines {
            match line.as_bytes() {
                [b'v', b' ', ..] => self.positions += 1,
                [b'v', b't', ..] => self.texture += 1,
                [b'v', b'n', ..] => self.normals += 1,
                [b'f', b' ', ..] => self.faces += 1,
                _ => {}
            }
            since += line.len();
            if since >= QUICK_STRETCH {
                return true;
            }
        }
        false
    }
}
