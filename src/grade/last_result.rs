//! Meshes that come of results of other tests, which a program keeps from one to the next: it skins them in place of
//! the mesh at rest, or goes on with their sums.

use crate::character::{Character, Pose};
use crate::diagnose::{LAST_RESULT_SKINNED, Mistake, SUM_NOT_RESET, measure};
use crate::geometry::Mesh;
use glam::Vec3;

/// A test of the character, the result of which a program may have kept.
pub(super) struct Posed<'a> {
    pub name: &'a str,
    pub pose: &'a Pose,
    /// Its exact vertices, in model space.
    pub exact: &'a [Vec3],
}

/// The mistake that gives a mesh, in words the results that it is made with, and by how much the mesh is off from that, by
/// the size.
pub(super) type Found = (&'static Mistake, String, f64);

/// Which results give `theirs` in the pose of the test `own`: those of one that is `before` or `after` it, or of all
/// before it.
pub(super) fn find(
    character: &Character,
    own: &Posed<'_>,
    theirs: &Mesh,
    before: &[Posed<'_>],
    after: &[Posed<'_>],
) -> Option<Found> {
    let alone = before.iter().chain(after).map(std::slice::from_ref);
    let all_before = Some(before).filter(|before| before.len() > 1);
    let mut found = alone.chain(all_before).filter_map(|tests| {
        let kept = Kept { character, tests };
        let skinned = kept.skinned(own.pose).map(|places| {
            let how = format!("that of {}", kept.named(" one upon the other"));
            (&LAST_RESULT_SKINNED, how, places)
        });
        let summed = kept.summed(own.exact);
        let begun = places_with(&summed, &character.bind_mesh().positions);
        let result = format!("the result of {}", kept.named(" together"));
        let with_rest = format!("from the mesh at rest and {result}");
        let summed = (&SUM_NOT_RESET, format!("from {result}"), summed);
        let begun = (&SUM_NOT_RESET, with_rest, begun);
        let mut ways = skinned.into_iter().chain([summed, begun]);
        ways.find_map(|(mistake, how, places)| {
            let measured = measure(character, &places, &theirs.positions)?;
            (measured.off == 0).then(|| (mistake, how, measured.worst / measured.size))
        })
    });
    found.next()
}

/// Results of tests that a program has kept.
struct Kept<'a> {
    character: &'a Character,
    tests: &'a [Posed<'a>],
}

impl Kept<'_> {
    /// The names of the tests, followed by `together` if they are several.
    fn named(&self, together: &str) -> String {
        let names: Vec<&str> = self.tests.iter().map(|test| test.name).collect();
        match &names[..] {
            [name] => (*name).to_owned(),
            names => names.join(", ") + together,
        }
    }

    /// What comes of skinning one result after the other, and the last in `pose`.
    fn skinned(&self, pose: &Pose) -> Option<Vec<Vec3>> {
        let (first, others) = self.tests.split_first()?;
        let mut poses = others.iter().map(|test| test.pose).chain([pose]);
        poses.try_fold(first.exact.to_vec(), |places, pose| {
            skinned(self.character, places, pose)
        })
    }

    /// What comes of adding the result `exact` to the others.
    fn summed(&self, exact: &[Vec3]) -> Vec<Vec3> {
        let others = self.tests.iter().map(|test| test.exact);
        others.fold(exact.to_vec(), |sum, other| places_with(&sum, other))
    }
}

/// The sums of the places of each vertex.
fn places_with(places: &[Vec3], others: &[Vec3]) -> Vec<Vec3> {
    let pairs = places.iter().zip(others);
    pairs.map(|(place, other)| *place + *other).collect()
}

/// What the formula makes of vertices at `places` in model space instead of those at rest.
fn skinned(character: &Character, places: Vec<Vec3>, pose: &Pose) -> Option<Vec<Vec3>> {
    let mesh = Mesh::new(places, character.bind_mesh().triangles.clone());
    let attachments = character.attachments().clone();
    let placed = Character::new(character.skeleton().clone(), attachments, mesh);
    Some(placed.ok()?.skin_pose(pose))
}
