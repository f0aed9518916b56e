//! Values of JSON that are checked as they are read, so that an error points at the number itself.

use glam::Vec3;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// Three numbers `[x, y, z]`, each of which `check` accepts.
///
/// # Errors
/// If there are more or fewer; at the first that is no finite number, or for which `check` says
/// what is wrong.
pub(super) fn vec3<'de, D: Deserializer<'de>>(
    deserializer: D,
    check: fn(f32) -> Result<(), String>,
) -> Result<Vec3, D::Error> {
    three(deserializer, Checked(check)).map(Vec3::from)
}

/// Three values `[x, y, z]`, each read by `seed`.
///
/// # Errors
/// If there are more or fewer; at the first that `seed` does not accept.
pub(super) fn three<'de, D: Deserializer<'de>, S: DeserializeSeed<'de> + Copy>(
    deserializer: D,
    seed: S,
) -> Result<[S::Value; 3], D::Error> {
    deserializer.deserialize_tuple(3, Three { seed })
}

struct Three<S> {
    seed: S,
}

impl<'de, S: DeserializeSeed<'de> + Copy> Visitor<'de> for Three<S> {
    type Value = [S::Value; 3];

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("three numbers [x, y, z]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Self::Value, A::Error> {
        let mut values = Vec::with_capacity(3);
        let mut count = 0;
        while let Some(value) = numbers.next_element_seed(self.seed)? {
            if count < 3 {
                values.push(value);
            }
            count += 1;
        }
        match values.try_into() {
            Ok(three) if count == 3 => Ok(three),
            _ => Err(A::Error::invalid_length(count, &self)),
        }
    }
}

/// Reads a finite number that the check accepts; the check returns the message for others.
#[derive(Clone, Copy)]
struct Checked(fn(f32) -> Result<(), String>);

impl<'de> DeserializeSeed<'de> for Checked {
    type Value = f32;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f32, D::Error> {
        let number = f32::deserialize(deserializer)?;
        (self.0)(number).map_err(D::Error::custom)?;
        Ok(number)
    }
}

/// A number that `check` accepts.
///
/// # Errors
/// If it is no finite number; what `check` says is wrong with it.
pub(super) fn checked<'de, D: Deserializer<'de>>(
    deserializer: D,
    check: fn(f32) -> Result<(), String>,
) -> Result<f32, D::Error> {
    Checked(check).deserialize(deserializer)
}

/// A number above 0.
///
/// # Errors
/// If it is not.
pub(super) fn positive<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f32, D::Error> {
    checked(deserializer, |number| match number {
        _ if number > 0.0 => Ok(()),
        _ => Err(format!("expected a number above 0, found {number}")),
    })
}
