use super::{json, scanner};
use crate::character::{Pose, SkeletalModel};
use glam::Vec3;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::collections::{HashMap, HashSet};

/// Joints with three numbers each, in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entries(pub Vec<(String, Vec3)>);

impl Entries {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn keys(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(key, _)| key.as_str())
    }

    /// The first two keys that mean one joint of `skeleton`, by its name, sid or index.
    pub(super) fn same_joint(&self, skeleton: &SkeletalModel) -> Option<(&str, &str)> {
        let mut seen: HashMap<usize, &str> = HashMap::new();
        self.0.iter().find_map(|(key, _)| {
            let joint = Pose::find_joint(skeleton, key).ok()?;
            Some((seen.insert(joint, key)?, key.as_str()))
        })
    }
}

impl Serialize for Entries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl<'de> Deserialize<'de> for Entries {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entry(Vec3);
        impl<'de> Deserialize<'de> for Entry {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                json::finite3(deserializer).map(Self)
            }
        }
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Entries;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("joints with three numbers each")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries, A::Error> {
                let mut entries = Vec::new();
                let mut seen = HashSet::new();
                while let Some(key) = map.next_key::<String>()? {
                    if !seen.insert(key.clone()) {
                        return Err(A::Error::custom(format!(
                            "expected each joint once, found {} again",
                            scanner::quoted(&key)
                        )));
                    }
                    let Entry(value) = map.next_value()?;
                    entries.push((key, value));
                }
                Ok(Entries(entries))
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}
