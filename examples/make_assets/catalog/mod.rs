//! Everything that lies in `assets/`, as texts by path.
mod adult;
mod dog;
mod field;
mod mesh;
mod polygonize;
mod remesh;
mod rig;
mod robot;
mod skin;
mod solids;
mod text;

use rig::Character;

/// A file: its path below `assets/` and its text.
pub struct File {
    pub path: String,
    pub text: String,
}

/// All files, made anew.
pub fn files() -> Vec<File> {
    let mut files = Vec::new();
    files.extend(character("adult", &adult::character()));
    files.extend(character("robot", &robot::character()));
    files.extend(character("dog", &dog::character()));
    files
}

fn character(name: &str, character: &Character) -> [File; 3] {
    let file = |ending: &str, text: String| File {
        path: format!("characters/{name}.{ending}"),
        text,
    };
    [
        file("skel", text::skeleton(&character.joints)),
        file("attach", text::attachments(character)),
        file("obj", text::mesh(&character.mesh)),
    ]
}
