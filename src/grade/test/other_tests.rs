//! What a file has to do with the other tests: it may be a result of one of them, or keep something of it.

use super::super::found::{explanations, mostly_posed};
use super::super::graded::OfTest;
use super::super::kept::{self, Posed};
use super::Test;
use crate::character::Pose;
use crate::diagnose::{Diagnosis, Verdict, diagnose, measure};
use crate::geometry::Mesh;

impl Test {
    /// Whether a mesh has the vertices of the exact result of this test, of which the files may be pictures.
    pub(super) fn is_right(&self, theirs: &Mesh) -> bool {
        measure(&self.character, &self.exact, &theirs.positions)
            .is_some_and(|measure| measure.off == 0)
    }

    /// Whether the character is that of `other`, whichever of its files each of the tests names.
    pub(super) fn has_character_of(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|test| &*test.character);
        own.skeleton().joints() == others.skeleton().joints()
            && own.bind_mesh().positions == others.bind_mesh().positions
            && own.attachments() == others.attachments()
    }

    /// Whether a mesh is this character in the pose of `other`, which has another character with joints of the same names:
    /// a program may always pose by the same file.
    pub(super) fn is_in_pose_of(&self, other: &Self, theirs: &Mesh) -> bool {
        if other.has_character_of(self) {
            return false;
        }
        let [own, others] = [self, other].map(|test| test.character.skeleton().joints());
        let mut pose = Pose::new();
        for (joint, described) in others.iter().enumerate() {
            if !other.pose.is_changed(joint) {
                continue;
            }
            let mut names = own.iter().map(|joint| &joint.name);
            let Some(named) = names.position(|name| *name == described.name) else {
                return false;
            };
            pose.set_joint_transform(named, other.pose.rotation(joint));
            pose.set_root_offset(named, other.pose.root_offset(joint));
        }
        measure(
            &self.character,
            &self.character.skin_pose(&pose),
            &theirs.positions,
        )
        .is_some_and(|measure| measure.off == 0)
    }

    /// Another one of `tests` that the file `is_of`, if there is one.
    pub(super) fn other_of<'a>(
        &self,
        tests: &'a [Self],
        is_of: impl Fn(&Self) -> bool,
    ) -> Option<&'a Self> {
        let mut others = tests.iter().filter(|test| test.data.name != self.data.name);
        others.find(|test| is_of(test))
    }

    /// The others of `tests` that are of this character and of which a mesh is the exact result.
    pub(super) fn others_of_mesh(&self, tests: &[Self], theirs: &Mesh) -> Vec<OfTest> {
        let others = tests.iter().filter(|test| test.data.name != self.data.name);
        let of = others.filter(|test| test.has_character_of(self) && test.is_right(theirs));
        let exact = of.map(|test| OfTest {
            name: test.data.name.clone(),
            with: Vec::new(),
        });
        exact.collect()
    }

    /// Another one of `tests` that a mesh is what mistakes give in; where it is mostly right in its own test it is not.
    pub(super) fn other_with_mistakes(
        &self,
        tests: &[Self],
        found: &Diagnosis,
        theirs: &Mesh,
    ) -> Option<OfTest> {
        if mostly_posed(found).is_some() || found.nearly_right().is_some() {
            return None;
        }
        let mut others = tests.iter().filter(|test| test.data.name != self.data.name);
        others.find_map(|test| {
            let found = diagnose(&test.character, &test.pose, theirs).ok()?;
            (found.verdict == Verdict::Explained).then(|| OfTest {
                name: test.data.name.clone(),
                with: explanations(found.together(), &found.same_as),
            })
        })
    }

    fn posed(&self) -> Posed<'_> {
        Posed {
            name: &self.data.name,
            pose: &self.pose,
            places: &self.exact,
        }
    }

    /// `found`, or that something of others of `tests` was kept, if that gives `theirs`.
    pub(super) fn or_of_kept(&self, found: Diagnosis, theirs: &Mesh, tests: &[Self]) -> Diagnosis {
        let of_character = |test: &&Self| test.has_character_of(self);
        let (before, after) = match tests
            .iter()
            .position(|test| test.data.name == self.data.name)
        {
            Some(own) => (&tests[..own], &tests[own + 1..]),
            None => (tests, &[][..]),
        };
        let [before, after] = [before, after].map(|tests| {
            let tests = tests.iter().filter(of_character);
            tests.map(Self::posed).collect::<Vec<_>>()
        });
        let own = self.posed();
        match kept::find(&self.character, &own, theirs, &before, &after) {
            Some((mistakes, error)) => found.explained_by(mistakes, error),
            None => found,
        }
    }
}
