//! What mistakes leave of the points of their sections.

use super::by_vertices::by_nearly_all;
use super::graded::{Graded, Outcome};
use crate::diagnose::{
    MESH_MIRRORED, MOVED_AS_A_WHOLE, PICTURE_TURNED, POSE_NOT_APPLIED, TRIANGLES_DIFFER,
    TRIANGLES_TURNED, UNSEEN, VERTEX_MISSING, VERTEX_TOO_MANY, VERTICES_NOT_REACHED,
    VERTICES_WITHOUT_WEIGHTS,
};
use crate::io::{
    OTHER_POSE, RIGHT_BUT_FOR_DIGITS, RIGHT_BUT_FOR_FEW, RIGHT_BUT_FOR_LITTLE, RubricData,
};

/// What a pose that was not applied leaves unless the rubric says otherwise. All of a result rests on it: a mesh that is
/// not in the pose of its test shows nothing of what the test asks for, whatever the section. Another pose counts as it
/// does.
const LEFT_WITHOUT_POSE: f64 = 0.0;
/// What a mesh that is right but for little leaves, unless the rubric says otherwise: less is wrong than with any
/// mistake in skinning.
const LEFT_BY_LITTLE: &[(&str, f64)] = &[
    (RIGHT_BUT_FOR_FEW, 0.9),
    (VERTEX_MISSING, 0.9),
    (VERTEX_TOO_MANY, 0.9),
    // Posing does nothing to faces, which a file may even leave out.
    (TRIANGLES_DIFFER, 0.9),
    (TRIANGLES_TURNED, 0.9),
    (RIGHT_BUT_FOR_DIGITS, 0.9),
    (RIGHT_BUT_FOR_LITTLE, 0.9),
    (MOVED_AS_A_WHOLE, 0.75),
    (MESH_MIRRORED, 0.75),
    (PICTURE_TURNED, 0.75),
];

/// Why a mistake costs as little as what is right but for little.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unseen {
    /// The whole mesh is hardly off.
    Mesh,
    /// It would move hardly anything by itself.
    Alone,
}

impl Unseen {
    /// Whether and why nobody sees the mistake `id` in a file.
    fn of(id: &str, graded: &Graded) -> Option<Self> {
        if graded.outcome != Outcome::Explained {
            return None;
        }
        if graded.error.is_some_and(|error| error <= UNSEEN) {
            return Some(Self::Mesh);
        }
        let mut slight = graded.slight.iter();
        slight.any(|known| known == id).then_some(Self::Alone)
    }
}

/// The share that one mistake leaves of its section in a file. Unless the rubric has one for it, that is no less than what
/// is right but for little has, where the mistake makes no more of a difference.
pub(super) fn share_left(id: &str, graded: &Graded, rubric: &RubricData) -> f64 {
    share_and_reason(id, graded, rubric).0
}

/// The same, and why that is more than the mistake leaves otherwise, if it is.
pub(super) fn share_and_reason(
    id: &str,
    graded: &Graded,
    rubric: &RubricData,
) -> (f64, Option<Unseen>) {
    if let Some(share) = rubric.mistakes.get(id) {
        return (share.0, None);
    }
    match id {
        POSE_NOT_APPLIED => return (LEFT_WITHOUT_POSE, None),
        // The pose that was asked for is as little in it as in one that is not posed at all.
        OTHER_POSE => return share_and_reason(POSE_NOT_APPLIED, graded, rubric),
        _ => {}
    }
    let mut by_little = LEFT_BY_LITTLE.iter();
    let known = by_little.find(|(known, _)| *known == id);
    let usual = match known {
        Some((_, share)) => *share,
        // Those that a loop does not come to, or that have no weights, may be few.
        None if [VERTICES_NOT_REACHED.id, VERTICES_WITHOUT_WEIGHTS.id].contains(&id) => {
            let few = share_left(RIGHT_BUT_FOR_FEW, graded, rubric);
            by_nearly_all(rubric.mistake.0, few, graded.near).max(rubric.mistake.0)
        }
        None => rubric.mistake.0,
    };
    let unseen = Unseen::of(id, graded).filter(|_| id != RIGHT_BUT_FOR_LITTLE);
    let more = unseen.map(|unseen| {
        let share = share_left(RIGHT_BUT_FOR_LITTLE, graded, rubric);
        (share, Some(unseen))
    });
    more.filter(|(share, _)| *share > usual)
        .unwrap_or((usual, None))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::rubric::tests::{TWO, explained, given, test};
    use crate::grade::why::why;
    use crate::io::Share;

    #[test]
    fn a_mistake_that_nobody_sees_costs_as_little_as_what_is_right_but_for_little() {
        let mut rubric = RubricData::default();
        let normalized = |error: f64| Graded {
            error: Some(error),
            ..explained(&[&["weights-normalized"]])
        };
        assert_eq!(given(TWO, &normalized(0.0004), &rubric), [6.0, 9.0]);
        assert_eq!(given(TWO, &normalized(0.0011), &rubric), [6.0, 5.0]);
        // So is what shows, but is where it should be as far as skinning goes.
        assert_eq!(
            given(TWO, &explained(&[&["mesh-mirrored"]]), &rubric),
            [6.0, 7.5]
        );
        let told = why(&test(TWO), &normalized(0.0004), &rubric);
        let text = "weights-normalized leaves 90 % of 4.2, so little is the mesh off";
        assert_eq!(told, [text]);
        let unposed = Graded {
            error: Some(0.0004),
            ..explained(&[&["pose-not-applied"]])
        };
        assert_eq!(given(TWO, &unposed, &rubric), [0.0, 0.0]);
        // The rubric's own share counts.
        let name = "weights-normalized".to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.7));
        assert_eq!(given(TWO, &normalized(0.0004), &rubric), [6.0, 7.0]);
    }

    #[test]
    fn a_loop_that_leaves_few_vertices_costs_the_less_the_fewer_they_are() {
        let rubric = RubricData::default();
        let not_reached = |near: f64| Graded {
            near,
            ..explained(&[&["vertices-not-reached"]])
        };
        for (near, left) in [(0.99, 9.0), (0.945, 7.0), (0.9, 5.0), (0.3, 5.0)] {
            let given = given(TWO, &not_reached(near), &rubric);
            let (others, ssd) = (given[0], given[1]);
            assert!(others == 6.0 && (ssd - left).abs() < 1e-9, "{near}: {ssd}");
        }
    }

    #[test]
    fn a_mistake_that_nobody_would_see_alone_costs_as_little_beside_another() {
        let mut rubric = RubricData::default();
        let both = Graded {
            error: Some(0.2),
            slight: vec!["weights-normalized".to_owned()],
            ..explained(&[&["euler-zyx", "weights-normalized"]])
        };
        assert_eq!(given(TWO, &both, &rubric), [3.0, 9.0]);
        assert_eq!(
            why(&test(TWO), &both, &rubric),
            [
                "euler-zyx leaves 50 % of 3.4",
                "weights-normalized leaves 90 % of 4.2, so little would it move by itself"
            ]
        );
        let name = "weights-normalized".to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.5));
        assert_eq!(given(TWO, &both, &rubric), [3.0, 5.0]);
    }
}
