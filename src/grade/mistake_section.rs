//! The sections of the assignment in which mistakes cost points.

use crate::diagnose::Mistake;
use crate::io::{RIGHT_BUT_FOR_JOINTS, TestData};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The section in which posed meshes are made: a file that is nearly right does not show in which section the mistake
/// is.
const OF_POSED_MESHES: &str = "4.2";
/// The section in which angles come to joints.
const OF_ANGLES: &str = "3.4";

/// The section that a mistake, or a file that is nearly right, is of.
pub(super) fn own_section(id: &str) -> &'static str {
    match (Mistake::find(id), id) {
        (Some(mistake), _) => mistake.section,
        (None, RIGHT_BUT_FOR_JOINTS) => OF_ANGLES,
        (None, _) => OF_POSED_MESHES,
    }
}

/// The section of a test in which a mistake of the section `own` of the assignment costs points: that one, or else the one
/// with the nearest number, of two as near the later one, which builds upon it; where no section has a number, the one
/// with the most points. `None` in a test without sections.
pub(super) fn section_of<'a>(own: &str, test: &'a TestData) -> Option<&'a str> {
    let own = parts_of(own)?;
    let apart = |section: &&String| {
        let (chapter, part) = parts_of(section)?;
        let is_before = (chapter, part) < own;
        let part_apart = match chapter.cmp(&own.0) {
            Ordering::Equal => part.abs_diff(own.1),
            // Nearest are the last of a chapter before and the first of one after.
            Ordering::Less => u32::MAX - part,
            Ordering::Greater => part,
        };
        Some((chapter.abs_diff(own.0), part_apart, is_before))
    };
    let numbered = test
        .points
        .keys()
        .filter(|section| apart(section).is_some());
    let nearest = numbered.min_by_key(apart).map(String::as_str);
    nearest.or_else(|| largest(test))
}

/// Sections in which tests have points that no mistake costs, each once.
pub fn without_mistakes(tests: &[TestData]) -> BTreeSet<String> {
    let cost: BTreeSet<&str> = tests
        .iter()
        .flat_map(|test| {
            Mistake::all().filter_map(move |mistake| section_of(mistake.section, test))
        })
        .collect();
    let all = tests.iter().flat_map(|test| test.points.keys());
    let without = all.filter(|section| !cost.contains(section.as_str()));
    without.cloned().collect()
}

/// Whether a section has a number such as `4.2`.
pub fn is_numbered(section: &str) -> bool {
    parts_of(section).is_some()
}

/// The section of a test with the most points.
fn largest(test: &TestData) -> Option<&str> {
    let sections = test.points.iter();
    let largest = sections.reduce(|most, other| if other.1 > most.1 { other } else { most });
    largest.map(|(section, _)| section.as_str())
}

/// Chapter and part of a section such as `4.2 SSD`.
fn parts_of(section: &str) -> Option<(u32, u32)> {
    let (chapter, part) = number(section).split_once('.')?;
    Some((chapter.parse().ok()?, part.parse().ok()?))
}

/// The number of a section such as `4.2 SSD`.
pub(super) fn number(section: &str) -> &str {
    section.split(' ').next().unwrap_or(section)
}
