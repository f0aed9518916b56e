//! `--colors`: characters in the colors of numbers.

use super::CliError;
use crate::character::{Character, Pose};
use crate::editor::Session;
use crate::io::no_such_joint;
use crate::render::ShapeNumbers;
use crate::scene::CharacterNumber;

/// What characters are colored by.
#[derive(Clone, Debug)]
pub(super) enum Colors {
    /// The weight of the joint of this name or index.
    Weight(String),
    Influences,
    LostAtFour,
}

/// What `--colors` names.
///
/// # Errors
/// If it names nothing, in words.
pub(super) fn colors(text: &str) -> Result<Colors, String> {
    match text {
        "influences" => Ok(Colors::Influences),
        "lost-at-four" => Ok(Colors::LostAtFour),
        _ => match text.strip_prefix("weight:") {
            Some(joint) if !joint.is_empty() => Ok(Colors::Weight(joint.to_owned())),
            _ => Err("expected weight:JOINT, influences or lost-at-four".to_owned()),
        },
    }
}

impl Colors {
    /// The numbers of the characters of `session`, all on one scale; of a joint's weight those of the
    /// characters that have it.
    ///
    /// # Errors
    /// If there is no character, or none has the joint.
    pub fn numbers(&self, session: &Session) -> Result<Vec<ShapeNumbers>, CliError> {
        let scene = session.scene();
        let shapes = scene.shapes().iter();
        let characters: Vec<_> = shapes
            .filter_map(|shape| Some((shape.id, &*scene.character(shape.id)?.character)))
            .collect();
        if characters.is_empty() {
            let text = "--colors is about characters, found none";
            return Err(CliError::Usage(text.to_owned()));
        }
        let number = |character: &Character| match self {
            Self::Weight(name) => {
                let joint = Pose::find_joint(character.skeleton(), name).ok();
                joint.map(CharacterNumber::Weight)
            }
            Self::Influences => Some(CharacterNumber::Influences),
            Self::LostAtFour => Some(CharacterNumber::LostAtFour),
        };
        if let Self::Weight(name) = self
            && !characters.iter().any(|(_, c)| number(c).is_some())
        {
            let skeletons: Vec<_> = characters.iter().map(|(_, c)| c.skeleton()).collect();
            let error = no_such_joint(name, &skeletons);
            return Err(CliError::Usage(format!("--colors: {error}")));
        }
        let numbered = characters.iter();
        let numbered = numbered.filter_map(|&(id, c)| Some((id, number(c)?, c)));
        Ok(ShapeNumbers::on_one_scale(numbered))
    }
}
