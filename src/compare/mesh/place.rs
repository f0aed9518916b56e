//! Where in a mesh vertices differ: by the parts it is made of, or else by the sides they are on.

use super::is_apart;
use super::numbers::length;
use crate::math::Aabb;
use glam::{DVec3, Vec3};
use serde::Serialize;
use std::fmt;

/// Parts that are told; the others are counted.
const TOLD: usize = 5;
/// Part of the mesh's width, height and depth from which on vertices are all over it.
const ALL_OVER: f64 = 0.7;
/// Sides shorter than this share of the longest one have no ends worth telling.
const FLAT: f64 = 0.05;

/// Parts of a mesh that have names, such as what each joint of a character moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshParts {
    /// Their names.
    pub names: Vec<String>,
    /// For each vertex the index of its part; `None` if it belongs to none.
    pub of_vertex: Vec<Option<u32>>,
}

/// Vertices that differ in one place of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshPlace {
    /// The place in words: `near Left elbow`.
    pub place: String,
    /// How many differ there.
    pub vertices: u64,
    /// The same by all vertices of the mesh, 0 to 1.
    pub share: f64,
    /// Largest distance of two of them; not finite is JSON null.
    pub max: f64,
}

/// Where vertices of `a` differ, the place with the farthest first: by part if there are `parts`, which
/// have an entry for each vertex.
pub(super) fn places(
    a: &[DVec3],
    distances: &[f64],
    tolerance: f64,
    parts: Option<&MeshParts>,
) -> Vec<MeshPlace> {
    let differing = || (0..a.len()).filter(|&index| is_apart(distances[index], tolerance));
    let Some(parts) = parts else {
        let finite = |index: &usize| a[*index].is_finite();
        let points = differing().filter(finite).map(|index| a[index].as_vec3());
        let whole = a.iter().filter(|point| point.is_finite());
        let whole = Aabb::from_points(whole.map(|point| point.as_vec3()));
        let side = side_of(&Aabb::from_points(points), &whole);
        let names = side.into_iter().collect();
        return counted(a.len(), differing(), distances, names, |_| 0);
    };
    // What belongs to no part comes after all parts.
    let named = parts.names.iter().map(|name| format!("near {name}"));
    let names: Vec<String> = named
        .chain(["where no joint moves them".to_owned()])
        .collect();
    let none = parts.names.len();
    let part_of = |index: usize| {
        let part = parts.of_vertex.get(index).copied().flatten();
        part.map_or(none, |part| part as usize)
    };
    let mut places = counted(a.len(), differing(), distances, names, part_of);
    places.sort_by(|a, b| b.max.total_cmp(&a.max));
    places
}

/// The places called `names` in which there are vertices of `differing`, each in one of them by
/// `place_of`, of a mesh of `all` vertices.
fn counted(
    all: usize,
    differing: impl Iterator<Item = usize>,
    distances: &[f64],
    names: Vec<String>,
    place_of: impl Fn(usize) -> usize,
) -> Vec<MeshPlace> {
    let mut found = vec![(0_u64, 0.0_f64); names.len()];
    for index in differing {
        if let Some((count, max)) = found.get_mut(place_of(index)) {
            *count += 1;
            *max = max.max(distances[index]);
        }
    }
    let named = names.into_iter().zip(found);
    let named = named.filter(|(_, (count, _))| *count > 0);
    named
        .map(|(place, (vertices, max))| MeshPlace {
            place,
            vertices,
            share: vertices as f64 / all as f64,
            max,
        })
        .collect()
}

/// Where `part` lies in `whole`, in words; `None` if either is empty.
fn side_of(part: &Aabb, whole: &Aabb) -> Option<String> {
    if part.is_empty() || whole.is_empty() {
        return None;
    }
    let (size, full) = (part.size(), whole.size());
    let is_flat = |axis: usize| f64::from(full[axis]) <= FLAT * f64::from(full.max_element());
    let covers = |axis: usize| f64::from(size[axis]) >= ALL_OVER * f64::from(full[axis]);
    if (0..3).all(|axis| is_flat(axis) || covers(axis)) {
        return Some("all over the mesh".to_owned());
    }
    let off = (part.center() - whole.center()) / full.max(Vec3::splat(f32::MIN_POSITIVE));
    let third = |axis: usize, words: [&'static str; 2]| {
        let is_at_end = !is_flat(axis) && off[axis].abs() > 1.0 / 6.0;
        is_at_end.then(|| words[usize::from(off[axis] > 0.0)])
    };
    let sides = [
        third(1, ["at the bottom", "at the top"]),
        third(0, ["toward -X", "toward +X"]),
        third(2, ["toward -Z", "toward +Z"]),
    ];
    let sides: Vec<&str> = sides.into_iter().flatten().collect();
    let is_wide = (0..3).any(|axis| !is_flat(axis) && size[axis] > 0.5 * full[axis]);
    Some(match (sides.is_empty(), is_wide) {
        (false, _) => format!("{} of the mesh", sides.join(", ")),
        (true, true) => "spread across the middle of the mesh".to_owned(),
        (true, false) => "in the middle of the mesh".to_owned(),
    })
}

impl fmt::Display for MeshPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.share;
        let share = match percent {
            percent if percent < 1.0 => "less than 1 %".to_owned(),
            percent => format!("{percent:.0} %"),
        };
        let Self { place, max, .. } = self;
        write!(
            f,
            "{place}: {share} of the vertices ({}), at most {} apart",
            self.vertices,
            length(*max)
        )
    }
}

/// Lines that tell the first of `places`.
pub(super) fn fmt_places(f: &mut fmt::Formatter<'_>, places: &[MeshPlace]) -> fmt::Result {
    for place in places.iter().take(TOLD) {
        writeln!(f, "  {place}")?;
    }
    if let Some(more) = places.len().checked_sub(TOLD).filter(|more| *more > 0) {
        writeln!(f, "  and near {more} more")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn aabb(low: [f32; 3], high: [f32; 3]) -> Aabb {
        Aabb::from_points([low, high].map(Vec3::from))
    }

    #[test]
    fn a_side_is_told_by_the_axes_along_which_it_is_an_end() {
        let whole = aabb([-1.0, 0.0, 0.0], [1.0, 4.0, 0.0]);
        let at = |low, high| side_of(&aabb(low, high), &whole).unwrap();
        assert_eq!(
            at([0.6, 3.0, 0.0], [0.9, 3.5, 0.0]),
            "at the top, toward +X of the mesh"
        );
        assert_eq!(
            at([-0.1, 1.9, 0.0], [0.1, 2.1, 0.0]),
            "in the middle of the mesh"
        );
        assert_eq!(
            at([-0.1, 0.5, 0.0], [0.1, 3.5, 0.0]),
            "spread across the middle of the mesh"
        );
        assert_eq!(at([-0.9, 0.1, 0.0], [0.9, 3.9, 0.0]), "all over the mesh");
        assert_eq!(side_of(&Aabb::EMPTY, &whole), None);
    }
}
