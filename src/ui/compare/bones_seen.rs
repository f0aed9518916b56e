//! Bones of the characters in view, as they lie in its picture.

use super::names::all_of;
use crate::character::Joint;
use crate::editor::Session;
use crate::scene::{ShapeId, bones_in_world};
use glam::Vec2;

/// Points along a bone that are looked at.
const SAMPLES: u8 = 16;

/// A character in view.
pub(super) struct CharacterSeen<'a> {
    pub shape: ShapeId,
    pub joints: &'a [Joint],
    pub bones: Vec<BoneSeen>,
    /// Name of the character, if there are several.
    name: Option<&'a str>,
}

/// A bone of it.
pub(super) struct BoneSeen {
    /// Joint that turns it.
    pub joint: usize,
    /// Where points along it are, in pixels, from the joint on. Those behind the camera are left out.
    pub pixels: Vec<Vec2>,
    /// How long it is, in the world.
    pub length: f32,
}

impl BoneSeen {
    /// Its ends in the picture; `None` if it is behind the camera.
    pub fn line(&self) -> Option<[Vec2; 2]> {
        Some([*self.pixels.first()?, *self.pixels.last()?])
    }
}

impl CharacterSeen<'_> {
    /// Name of a joint, with the character's if there are several.
    pub fn name_of(&self, joint: usize) -> String {
        self.of_character(&self.joints[joint].name)
    }

    /// Names of joints, with the character's if there are several.
    pub fn names_of(&self, joints: &[usize]) -> String {
        let names: Vec<&str> = joints.iter().map(|&it| &*self.joints[it].name).collect();
        self.of_character(&all_of(&names))
    }

    fn of_character(&self, joints: &str) -> String {
        match self.name {
            Some(name) => format!("{joints} of {name}"),
            None => joints.to_owned(),
        }
    }
}

/// How large the box round pixels is, along its longer side; `None` of none.
pub(super) fn extent(pixels: impl Iterator<Item = Vec2> + Clone) -> Option<f32> {
    let most = pixels.clone().reduce(Vec2::max)?;
    Some((most - pixels.reduce(Vec2::min)?).max_element())
}

/// The characters that are visible in a live view of `size` pixels.
pub(super) fn characters_seen(session: &Session, size: Vec2) -> Vec<CharacterSeen<'_>> {
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let camera = &session.view().camera;
    let shapes = scene.shapes().iter().filter(|shape| shape.visible);
    let characters = shapes.filter_map(|shape| Some((shape, scene.character(shape.id)?)));
    let are_several = characters.clone().count() > 1;
    let seen = characters.filter_map(|(shape, character)| {
        let bones = bones_in_world(scene, evaluated.shape(shape.id)?);
        let bones = bones.map(|(joint, start, end)| {
            let along = (0..=SAMPLES).map(|i| f32::from(i) / f32::from(SAMPLES));
            let pixels = along.filter_map(|t| camera.pixel(start.lerp(end, t), size));
            BoneSeen {
                joint,
                pixels: pixels.collect(),
                length: start.distance(end),
            }
        });
        Some(CharacterSeen {
            shape: shape.id,
            joints: character.character.skeleton().joints(),
            bones: bones.collect(),
            name: are_several.then_some(&*shape.name),
        })
    });
    seen.collect()
}
