//! Everything that lies in `assets/`, as texts by path.
mod adult;
mod dog;
mod field;
mod mesh;
mod polygonize;
mod poses;
mod remesh;
mod rig;
mod robot;
mod shapes;
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
    let mut shape = |name: &str, text: String| {
        files.push(File {
            path: format!("shapes/{name}"),
            text,
        });
    };
    shape("gear.obj", shapes::gear());
    shape("gem.obj", shapes::gem());
    shape("plant.obj", shapes::plant());
    shape("plant.mtl", shapes::plant_materials());
    files.extend(poses::texts().map(|(name, text)| File {
        path: format!("poses/{name}.json"),
        text,
    }));
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
