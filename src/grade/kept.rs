//! Meshes that come of what a program keeps from one test to the next: it skins the last result in place of the mesh at
//! rest, goes on with its sums or its angles, or has B from the first pose.

use crate::character::skinning::skin_positions;
use crate::character::{Character, Pose};
use crate::diagnose::{
    ANGLES_KEPT, BIND_OF_OTHER_POSE, LAST_RESULT_SKINNED, Mistake, SUM_NOT_RESET, measure,
};
use crate::geometry::Mesh;
use crate::math::Euler;
use glam::{Mat4, Vec3};

/// Mistakes that are found in the other tests.
pub(super) static MISTAKES: [&Mistake; 4] = [
    &LAST_RESULT_SKINNED,
    &SUM_NOT_RESET,
    &BIND_OF_OTHER_POSE,
    &ANGLES_KEPT,
];

/// A test of the character, of which a program may have kept something.
pub(super) struct Posed<'a> {
    pub name: &'a str,
    pub pose: &'a Pose,
    /// Its exact vertices, in model space.
    pub exact: &'a [Vec3],
}

/// The mistake that gives a mesh, in words what it is made with, and by how much the mesh is off from that, by the size.
pub(super) type Found = (&'static Mistake, String, f64);

/// A mistake, in words what it is made with, and where it puts the vertices.
type Way = (&'static Mistake, String, Vec<Vec3>);

/// What has to be kept to give `theirs` in the pose of the test `own`: something of one that is `before` or `after` it,
/// or of all before it.
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
        kept.ways(own)
            .into_iter()
            .find_map(|(mistake, how, places)| {
                let measured = measure(character, &places, &theirs.positions)?;
                (measured.off == 0).then(|| (mistake, how, measured.worst / measured.size))
            })
    });
    found.next()
}

/// Tests of which a program has kept something.
struct Kept<'a> {
    character: &'a Character,
    tests: &'a [Posed<'a>],
}

impl Kept<'_> {
    /// What a program may make of it in the test `own`.
    fn ways(&self, own: &Posed<'_>) -> Vec<Way> {
        let result = format!("the result of {}", self.named(" together"));
        let summed = self.summed(own.exact);
        let begun = places_with(&summed, &self.character.bind_mesh().positions);
        let mut ways = vec![
            (&SUM_NOT_RESET, format!("from {result}"), summed),
            (
                &SUM_NOT_RESET,
                format!("from the mesh at rest and {result}"),
                begun,
            ),
        ];
        let skinned = self.skinned(own.pose).map(|places| {
            let how = format!("that of {}", self.named(" one upon the other"));
            (&LAST_RESULT_SKINNED, how, places)
        });
        ways.extend(skinned);
        if let [test] = self.tests {
            let how = format!("that of {}", test.name);
            ways.push((&BIND_OF_OTHER_POSE, how, self.bound(test.pose, own.pose)));
        }
        let those = format!("those of {}", self.named(" together"));
        let angles: [(String, Angles); 3] = [
            (format!("{those}, where the test has none"), left),
            (format!("{those}, to which its own are added"), added),
            (format!("{those}, from which joints turn on"), turned_on),
        ];
        ways.extend(angles.into_iter().map(|(how, angles)| {
            let pose = self.posed(own.pose, angles);
            (&ANGLES_KEPT, how, self.character.skin_pose(&pose))
        }));
        ways
    }

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

    /// What comes of `pose` where B is that of the pose `bind`.
    fn bound(&self, bind: &Pose, pose: &Pose) -> Vec<Vec3> {
        let skeleton = self.character.skeleton();
        let [bind, current] =
            [bind, pose].map(|pose| skeleton.update_current_joint_to_world_transforms(pose));
        let factors = current.iter().zip(&bind);
        let palette: Vec<Mat4> = factors.map(|(t, b)| *t * b.inverse()).collect();
        let rest = &self.character.bind_mesh().positions;
        let mut places = rest.clone();
        skin_positions(&palette, self.character.attachments(), rest, &mut places);
        places
    }

    /// The pose that comes of `pose` where each joint has what `angles` makes of those before and of its own.
    fn posed(&self, pose: &Pose, angles: Angles) -> Pose {
        let mut posed = Pose::new();
        for test in self.tests.iter().map(|test| test.pose).chain([pose]) {
            for joint in 0..self.character.skeleton().joints().len() {
                let rotation = angles(posed.rotation(joint), test.rotation(joint));
                posed.set_joint_transform(joint, rotation);
                posed.set_root_offset(joint, pose.root_offset(joint));
            }
        }
        posed
    }
}

/// Angles that a joint has if it had the first ones and is given the second.
type Angles = fn(Euler, Euler) -> Euler;

fn left(before: Euler, own: Euler) -> Euler {
    if own == Euler::ZERO { before } else { own }
}

fn added(before: Euler, own: Euler) -> Euler {
    Euler::from_radians(before.radians + own.radians)
}

fn turned_on(before: Euler, own: Euler) -> Euler {
    let rotation = before.to_dmat3() * own.to_dmat3();
    Euler::nearest(rotation.as_mat3(), own)
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
