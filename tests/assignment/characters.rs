//! Small characters, written as their files.

use editor_core::character::{Character, SkeletalModel};
use editor_core::io::{read_attach, read_character_obj, read_skel};
use std::path::Path;

/// A body of five joints: two arms on a chest, one hand.
pub const BODY: &str = "0.5 1 0 -1 # Root\n0 1 0 0 # Chest\n1 0 0 1 # Left arm\n-1 0 0 1 # Right arm\n0.5 0 0 2 # Left hand\n";

pub fn skeleton(skel: &str) -> SkeletalModel {
    read_skel(Path::new("a.skel"), skel.as_bytes())
        .unwrap()
        .value
}

/// A character of three files.
pub fn character(skel: &str, attach: &str, obj: &str) -> Character {
    let skeleton = skeleton(skel);
    let mesh = read_character_obj(Path::new("a.obj"), obj.as_bytes())
        .unwrap()
        .value;
    let (joints, vertices) = (skeleton.joints().len(), mesh.positions.len());
    let attachments = read_attach(Path::new("a.attach"), attach.as_bytes(), joints, vertices);
    Character::new(skeleton, attachments.unwrap().value, mesh).unwrap()
}
