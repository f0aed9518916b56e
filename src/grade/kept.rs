//! Meshes that come of what a program keeps from one test to the next: it skins the last result in place of the mesh at
//! rest, goes on with its sums or its angles, or has B from the first pose.

use crate::character::skinning::skin_positions;
use crate::character::{Attachments, Character, Pose};
use crate::diagnose::{
    ANGLES_KEPT, BIND_OF_OTHER_POSE, Formula, LAST_RESULT_SKINNED, MISTAKES, Mistake,
    SUM_NOT_RESET, measure, skin_after, skin_by,
};
use crate::geometry::Mesh;
use crate::math::Euler;
use glam::{Mat4, Vec3};

/// Mistakes that are found in the other tests.
pub(super) static FROM_OTHER_TESTS: [&Mistake; 4] = [
    &LAST_RESULT_SKINNED,
    &SUM_NOT_RESET,
    &BIND_OF_OTHER_POSE,
    &ANGLES_KEPT,
];

/// A test of the character, of which a program may have kept something.
#[derive(Clone, Copy)]
pub(super) struct Posed<'a> {
    pub name: &'a str,
    pub pose: &'a Pose,
    /// Its vertices, in model space, as the program has them but for what it has kept.
    pub places: &'a [Vec3],
}

/// The mistakes that together give a mesh, each with words about how it is made, and by how much the mesh is off from
/// that, by the size.
pub(super) type Found = (Vec<(&'static Mistake, String)>, f64);

/// A mistake, in words what it is made with, and where it puts the vertices.
type Way = (&'static Mistake, String, Vec<Vec3>);

/// Vertices by which it is tried whether something was kept beside another mistake.
const SAMPLE: usize = 96;

/// What has to be kept to give `theirs` in the pose of the test `own`: something of one that is `before` or `after` it,
/// or of all that came before it in the order of the tests or of their names, forwards or backwards; if need be beside one
/// of the other mistakes.
pub(super) fn find(
    character: &Character,
    own: &Posed<'_>,
    theirs: &Mesh,
    before: &[Posed<'_>],
    after: &[Posed<'_>],
) -> Option<Found> {
    let theirs = &theirs.positions;
    let exact = Skinning {
        character,
        formula: None,
    };
    if let Some((kept, error)) = kept_by(exact, own, theirs, before, after) {
        return Some((vec![kept], error));
    }
    if before.is_empty() && after.is_empty()
        || theirs.len() != character.attachments().vertex_count()
    {
        return None;
    }
    let step = theirs.len().div_ceil(SAMPLE);
    let few = sampled(character, step)?;
    let few_theirs: Vec<Vec3> = theirs.iter().copied().step_by(step).collect();
    let readings = MISTAKES.iter().flat_map(|mistake| {
        let readings = mistake.readings.iter();
        readings.map(move |reading| (mistake, reading))
    });
    let mut found = readings.filter_map(|(mistake, reading)| {
        let mut formula = Formula::default();
        (reading.make)(&mut formula);
        let with_mistake = |character, theirs: &[Vec3]| {
            let by = Skinning {
                character,
                formula: Some(&formula),
            };
            let all = [std::slice::from_ref(own), before, after].concat();
            let places: Vec<Vec<Vec3>> = all.iter().map(|test| by.skin(test.pose)).collect();
            let posed = all
                .iter()
                .zip(&places)
                .map(|(test, places)| Posed { places, ..*test });
            let posed: Vec<Posed> = posed.collect();
            let (before, after) = posed[1..].split_at(before.len());
            kept_by(by, &posed[0], theirs, before, after)
        };
        with_mistake(&few, &few_theirs)?;
        let (kept, error) = with_mistake(character, theirs)?;
        Some((vec![kept, (mistake, reading.how.to_owned())], error))
    });
    found.next()
}

/// What is kept with this skinning that gives `theirs`, and by how much they are off, by the size.
fn kept_by(
    by: Skinning<'_>,
    own: &Posed<'_>,
    theirs: &[Vec3],
    before: &[Posed<'_>],
    after: &[Posed<'_>],
) -> Option<((&'static Mistake, String), f64)> {
    let alone = before.iter().chain(after).map(|test| vec![*test]);
    let together = come_before(own, before, after);
    let mut found = alone.chain(together).filter_map(|tests| {
        let kept = Kept { by, tests: &tests };
        kept.ways(own)
            .into_iter()
            .find_map(|(mistake, how, places)| {
                let measured = measure(by.character, &places, theirs)?;
                (measured.off == 0).then(|| ((mistake, how), measured.worst / measured.size))
            })
    });
    found.next()
}

/// The orders in which a program may have made tests: that of their file or of their names, forwards or backwards.
pub(super) fn orders<'a, T: Copy>(of_file: &[T], name: impl Fn(&T) -> &'a str) -> [Vec<T>; 4] {
    let of_file = of_file.to_vec();
    let mut by_name = of_file.clone();
    by_name.sort_by(|a, b| name(a).cmp(name(b)));
    let backwards = |order: &[T]| order.iter().rev().copied().collect();
    let (file_backwards, name_backwards) = (backwards(&of_file), backwards(&by_name));
    [of_file, file_backwards, by_name, name_backwards]
}

/// The tests, where they are several, that come before `own` in the orders in which a program may have made all of them.
fn come_before<'a>(
    own: &Posed<'a>,
    before: &[Posed<'a>],
    after: &[Posed<'a>],
) -> Vec<Vec<Posed<'a>>> {
    let of_file = [before, std::slice::from_ref(own), after].concat();
    let mut found: Vec<Vec<Posed>> = Vec::new();
    for order in orders(&of_file, |test| test.name) {
        let come_before = order.iter().take_while(|test| test.name != own.name);
        let come_before: Vec<Posed> = come_before.copied().collect();
        let names = |tests: &[Posed<'a>]| tests.iter().map(|it| it.name).collect::<Vec<_>>();
        let is_known = found.iter().any(|it| names(it) == names(&come_before));
        if come_before.len() > 1 && !is_known {
            found.push(come_before);
        }
    }
    found
}

/// The character with one of `step` of its vertices, and no triangles.
fn sampled(character: &Character, step: usize) -> Option<Character> {
    let mut attachments = Attachments::new();
    for influences in character.attachments().vertices().step_by(step) {
        attachments.push_vertex(influences.iter().copied());
    }
    let places = character
        .bind_mesh()
        .positions
        .iter()
        .copied()
        .step_by(step);
    let mesh = Mesh::new(places.collect(), Vec::new());
    Character::new(character.skeleton().clone(), attachments, mesh).ok()
}

/// How a program gets from a pose to vertices.
#[derive(Clone, Copy)]
struct Skinning<'a> {
    character: &'a Character,
    /// The formula with a mistake; `None` for the exact one.
    formula: Option<&'a Formula>,
}

impl Skinning<'_> {
    fn skin(self, pose: &Pose) -> Vec<Vec3> {
        self.skin_of(self.character, pose)
    }

    /// What comes of vertices at `places` in model space instead of those at rest.
    fn skin_again(self, places: Vec<Vec3>, pose: &Pose) -> Option<Vec<Vec3>> {
        let character = self.character;
        let mesh = Mesh::new(places, character.bind_mesh().triangles.clone());
        let attachments = character.attachments().clone();
        let placed = Character::new(character.skeleton().clone(), attachments, mesh);
        Some(self.skin_of(&placed.ok()?, pose))
    }

    fn skin_of(self, character: &Character, pose: &Pose) -> Vec<Vec3> {
        match self.formula {
            Some(formula) => skin_by(character, pose, formula).positions,
            None => character.skin_pose(pose),
        }
    }
}

/// Tests of which a program has kept something.
struct Kept<'a> {
    by: Skinning<'a>,
    tests: &'a [Posed<'a>],
}

impl Kept<'_> {
    /// What a program may make of it in the test `own`.
    fn ways(&self, own: &Posed<'_>) -> Vec<Way> {
        let result = format!("the result of {}", self.named(" together"));
        let summed = self.summed(own.places);
        let rest = &self.by.character.bind_mesh().positions;
        let at_rest = self.by.skin(&Pose::new());
        let begun = places_with(&summed, rest);
        let begun_with_sum = places_with(&summed, &at_rest);
        let begun_with_both = places_with(&begun, &at_rest);
        let mut ways = vec![
            (&SUM_NOT_RESET, format!("from {result}"), summed),
            (
                &SUM_NOT_RESET,
                format!("from the mesh at rest and {result}"),
                begun,
            ),
            (
                &SUM_NOT_RESET,
                format!("from what the mesh at rest was skinned to and {result}"),
                begun_with_sum,
            ),
            (
                &SUM_NOT_RESET,
                format!("from the mesh at rest, what that was skinned to and {result}"),
                begun_with_both,
            ),
        ];
        let skinned = self.skinned(own.pose).map(|places| {
            let how = format!("that of {}", self.named(" one upon the other"));
            (&LAST_RESULT_SKINNED, how, places)
        });
        ways.extend(skinned);
        if let ([test], None) = (self.tests, self.by.formula) {
            let how = format!("that of {}", test.name);
            let bound = bound(self.by.character, test.pose, own.pose);
            ways.push((&BIND_OF_OTHER_POSE, how, bound));
        }
        let those = format!("those of {}", self.named(" together"));
        let angles: [(String, Angles); 2] = [
            (format!("{those}, where the test has none"), left),
            (format!("{those}, to which its own are added"), added),
        ];
        ways.extend(angles.into_iter().map(|(how, angles)| {
            let pose = self.posed(own.pose, angles);
            (&ANGLES_KEPT, how, self.by.skin(&pose))
        }));
        let turned_on = self.turned_on(own.pose);
        ways.push((
            &ANGLES_KEPT,
            format!("{those}, from which joints turn on"),
            turned_on,
        ));
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
        poses.try_fold(first.places.to_vec(), |places, pose| {
            self.by.skin_again(places, pose)
        })
    }

    /// What comes of adding the result `places` to the others.
    fn summed(&self, places: &[Vec3]) -> Vec<Vec3> {
        let others = self.tests.iter().map(|test| test.places);
        others.fold(places.to_vec(), |sum, other| places_with(&sum, other))
    }

    /// What comes of `pose` where its rotations are multiplied onto those before.
    fn turned_on(&self, pose: &Pose) -> Vec<Vec3> {
        let before: Vec<&Pose> = self.tests.iter().map(|test| test.pose).collect();
        let formula = self.by.formula.cloned().unwrap_or_default();
        skin_after(self.by.character, &before, pose, &formula).positions
    }

    /// The pose that comes of `pose` where each joint has what `angles` makes of those before and of its own.
    fn posed(&self, pose: &Pose, angles: Angles) -> Pose {
        let mut posed = Pose::new();
        for test in self.tests.iter().map(|test| test.pose).chain([pose]) {
            for joint in 0..self.by.character.skeleton().joints().len() {
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

/// The sums of the places of each vertex.
fn places_with(places: &[Vec3], others: &[Vec3]) -> Vec<Vec3> {
    let pairs = places.iter().zip(others);
    pairs.map(|(place, other)| *place + *other).collect()
}

/// What comes of `pose` where B is that of the pose `bind`.
fn bound(character: &Character, bind: &Pose, pose: &Pose) -> Vec<Vec3> {
    let skeleton = character.skeleton();
    let [bind, current] =
        [bind, pose].map(|pose| skeleton.update_current_joint_to_world_transforms(pose));
    let factors = current.iter().zip(&bind);
    let palette: Vec<Mat4> = factors.map(|(t, b)| *t * b.inverse()).collect();
    let rest = &character.bind_mesh().positions;
    let mut places = rest.clone();
    skin_positions(&palette, character.attachments(), rest, &mut places);
    places
}
