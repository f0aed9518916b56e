//! Everything that the generator puts into `assets/`, by path.

mod adult;
mod curves;
mod dog;
mod field;
mod mesh;
mod polygonize;
mod poses;
mod remesh;
mod rig;
mod rigs;
mod robot;
mod shapes;
mod skin;
mod solids;
mod text;

use rig::Character;

/// The folder `assets/` of this checkout.
pub const ASSETS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets");

/// A file: its path below `assets/` and its content.
pub struct File {
    pub path: &'static str,
    pub content: Vec<u8>,
}

/// The paths of all files, in the order in which they are made.
pub const PATHS: [&str; 40] = [
    "characters/adult.skel",
    "characters/adult.attach",
    "characters/adult.obj",
    "characters/robot.skel",
    "characters/robot.attach",
    "characters/robot.obj",
    "characters/dog.skel",
    "characters/dog.attach",
    "characters/dog.obj",
    "shapes/gear.obj",
    "shapes/gem.obj",
    "shapes/plant.obj",
    "shapes/plant.mtl",
    "poses/adult-walk.json",
    "poses/adult-wave.json",
    "poses/adult-sit.json",
    "poses/robot-greet.json",
    "poses/robot-march.json",
    "poses/dog-trot.json",
    "poses/dog-sit.json",
    "poses/humanoid-point.json",
    "poses/face-wink.json",
    "poses/creature-wave.json",
    "poses/tentacle-curl.json",
    "poses/lizard-turn.json",
    "poses/chain-snake.json",
    "curves/vase.swp",
    "curves/goblet.swp",
    "curves/pawn.swp",
    "curves/knot.swp",
    "curves/seam.swp",
    "curves/spring.swp",
    "rigs/column.dae",
    "rigs/chain.dae",
    "rigs/crate.dae",
    "rigs/tentacle.dae",
    "rigs/creature.dae",
    "rigs/humanoid.dae",
    "rigs/face.dae",
    "rigs/crate.png",
];

/// All files, made anew.
pub fn files() -> Vec<File> {
    // The two grown bodies take nearly all the time: side by side, where there are two cores.
    let (body, dog) = std::thread::scope(|scope| {
        let dog = scope.spawn(dog::character);
        (adult::body(), dog.join())
    });
    let mut texts = character(&adult::character(&body)).to_vec();
    texts.extend(character(&robot::character()));
    texts.extend(dog.iter().flat_map(character));
    texts.extend([
        shapes::gear(),
        shapes::gem(),
        shapes::plant(),
        shapes::plant_materials(),
    ]);
    texts.extend(poses::texts());
    texts.extend([curves::vase(), curves::goblet(), curves::pawn()]);
    texts.extend([curves::knot(), curves::seam(), curves::spring()]);
    let contents = texts.into_iter().map(String::into_bytes);
    PATHS
        .into_iter()
        .zip(contents.chain(rigs::contents(&body)))
        .map(|(path, content)| File { path, content })
        .collect()
}

/// Skeleton, attachments and mesh.
fn character(character: &Character) -> [String; 3] {
    [
        text::skeleton(&character.joints),
        text::attachments(character),
        text::mesh(&character.mesh),
    ]
}
