//! Programs that are one pose late, or that have one pose for all tests: no file tells that alone, but all meshes of a
//! submission together.

use super::graded::{Graded, Outcome};
use super::kept::orders;
use crate::diagnose::{Mistake, POSE_LATE, POSE_NOT_APPLIED, in_words};
use crate::io::{TestData, TestKind, TestsFile};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Fewest meshes that show that a program is late: a single one may have a wrong name.
const FEWEST_LATE: usize = 2;
/// Fewest meshes that show that a program has one pose for all tests: of two, one may have a wrong name.
const FEWEST_ALIKE: usize = 3;

/// The meshes of a submission that are of one character, in the order of their tests.
type OfCharacter<'a> = Vec<(&'a TestData, &'a mut Graded)>;

/// Has the meshes of each character count as late, where they are in one of the orders in which a program may have made
/// the tests, or says that all of them are of one pose. `graded` has the results of the tests of `file`, in their order.
/// A picture of the mesh at rest counts as late where the mesh of the same pose does.
pub(super) fn settle_late(file: &TestsFile, graded: &mut [Graded]) {
    let mut by_character: BTreeMap<PathBuf, OfCharacter> = BTreeMap::new();
    for (test, result) in file.tests.iter().zip(&mut *graded) {
        if test.kind == TestKind::Mesh {
            let of_character = by_character.entry(stem(test)).or_default();
            of_character.push((test, result));
        }
    }
    let mut begun = Vec::new();
    for mut meshes in by_character.into_values() {
        let tests: Vec<&TestData> = meshes.iter().map(|(test, _)| *test).collect();
        let mut orders = orders(&tests, |test| &test.name).into_iter();
        let late = orders.find_map(|order| Some((Late::find(&order, &meshes)?, order[0])));
        match late {
            Some((late, first)) => {
                begun.push((stem(first), first.pose.path.clone()));
                late.settle(&mut meshes);
            }
            None => settle_alike(&mut meshes),
        }
    }
    for (test, result) in file.tests.iter().zip(graded) {
        let is_of_first = || begun.contains(&(stem(test), test.pose.path.clone()));
        if test.kind != TestKind::Mesh
            && is_of_first()
            && let Some(held) = Held::at_rest(result)
        {
            *result = held.settled(result);
        }
    }
}

/// The path of a character, whichever of its files the test names.
fn stem(test: &TestData) -> PathBuf {
    let path = &test.character.path;
    let is_one_of_three = ["obj", "skel", "attach"]
        .iter()
        .any(|extension| path.extension().is_some_and(|it| it == *extension));
    match is_one_of_three {
        true => path.with_extension(""),
        false => path.clone(),
    }
}

/// Whether there is a mesh that could be late or not.
fn is_there(graded: &Graded) -> bool {
    match graded.outcome {
        Outcome::Right | Outcome::Explained | Outcome::OtherPose | Outcome::Unexplained => true,
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => false,
    }
}

/// What a test of a late program holds instead of its own result.
struct Held {
    /// In words.
    what: String,
    /// Mistakes that together give it beside that, by name; empty if there are none.
    with: Vec<Vec<String>>,
}

impl Held {
    /// The mesh at rest, which comes before the first result, if `graded` may be that.
    fn at_rest(graded: &Graded) -> Option<Self> {
        let is_rest = |id: &&String| *id == POSE_NOT_APPLIED;
        let at_rest = graded.causes.iter();
        let at_rest = at_rest.filter(|ids| ids.iter().any(|id| is_rest(&id)));
        let beside = at_rest.map(|ids| {
            let others = ids.iter().filter(|id| !is_rest(id));
            others.cloned().collect::<Vec<_>>()
        });
        let with: Vec<Vec<String>> = beside.collect();
        (!with.is_empty()).then(|| Self {
            what: "the mesh at rest, before the first one".to_owned(),
            with: if with.contains(&Vec::new()) {
                Vec::new()
            } else {
                with
            },
        })
    }

    /// The result of the test `before`, if `graded` is one.
    fn of(before: &TestData, graded: &Graded) -> Option<Self> {
        let mut of = graded.of_tests.iter();
        let of = of.find(|of| of.name == before.name)?;
        Some(Self {
            what: format!("the result of {}", of.name),
            with: of.with.clone(),
        })
    }

    /// `graded` as what a late program gives.
    fn settled(&self, graded: &Graded) -> Graded {
        let told = self.with.first().into_iter().flatten();
        let beside = told.filter_map(|id| Some((Mistake::find(id)?, String::new())));
        let late = [(&POSE_LATE, self.what.clone())];
        let causes = match &*self.with {
            [] => vec![vec![POSE_LATE.id.to_owned()]],
            with => {
                let causes = with.iter();
                let late = |ids: &Vec<String>| [&[POSE_LATE.id.to_owned()], &**ids].concat();
                causes.map(late).collect()
            }
        };
        Graded {
            outcome: Outcome::Explained,
            text: in_words(late.into_iter().chain(beside).collect()),
            hint: None,
            causes,
            nearly: Vec::new(),
            slight: Vec::new(),
            posed: 0.0,
            ..graded.clone()
        }
    }
}

/// The tests that hold what the one before should, by name.
struct Late(BTreeMap<String, Held>);

impl Late {
    /// Those of `meshes`, if every mesh that is there is late in this `order`. The first may be right, as of a program that
    /// draws twice before it writes.
    fn find(order: &[&TestData], meshes: &OfCharacter<'_>) -> Option<Self> {
        let mut late = BTreeMap::new();
        for (at, test) in order.iter().enumerate() {
            let mut all = meshes.iter();
            let (_, graded) = all.find(|(other, _)| other.name == test.name)?;
            let before = at.checked_sub(1).map(|before| order[before]);
            let has_same_pose = || before.is_none_or(|it| it.pose.path == test.pose.path);
            if !is_there(graded) || graded.outcome == Outcome::Right && has_same_pose() {
                continue;
            }
            let held = match before {
                None => Held::at_rest(graded),
                Some(before) => Held::of(before, graded),
            };
            late.insert(test.name.clone(), held?);
        }
        (late.len() >= FEWEST_LATE).then_some(Self(late))
    }

    fn settle(&self, meshes: &mut OfCharacter<'_>) {
        for (test, graded) in meshes {
            if let Some(held) = self.0.get(&test.name) {
                **graded = held.settled(graded);
            }
        }
    }
}

/// Says of meshes with the result of another test that all are of that one, if they are.
fn settle_alike(meshes: &mut OfCharacter<'_>) {
    let there: Vec<_> = meshes.iter().filter(|(_, it)| is_there(it)).collect();
    let is_of = |graded: &Graded, name: &str| graded.of_tests.iter().any(|of| of.name == name);
    let are_of = |name: &&str| {
        there
            .iter()
            .all(|(test, graded)| test.name == **name || is_of(graded, name))
    };
    let mut names = meshes.iter().map(|(test, _)| &*test.name);
    let one = names.find(are_of).filter(|_| there.len() >= FEWEST_ALIKE);
    let Some(one) = one.map(str::to_owned) else {
        return;
    };
    for (_, graded) in meshes {
        let mut of = graded.of_tests.iter();
        let of = of.find(|of| of.name == one).cloned();
        if let Some(of) = of.filter(|_| graded.outcome == Outcome::OtherPose) {
            **graded = graded.clone().of_one_test(&of);
        }
    }
}
