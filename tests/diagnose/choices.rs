//! Mistakes that programs make in slightly different ways for single vertices.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, Student, with};
use editor_core::diagnose::Verdict;

/// Which rows of weights a program reads, one a vertex, of those in the file.
type Rows = fn(&[Vec<f32>]) -> Vec<Vec<f32>>;
/// Weights of a vertex, each with the index of its joint.
type Weights = Vec<(usize, f32)>;
/// Which of them count.
type Cut = fn(Weights) -> Weights;

/// The largest weights; of equals in no order that the file has, nor its reverse.
fn largest(mut weights: Weights, most: usize) -> Weights {
    weights.sort_by_key(|&(joint, weight)| (-(weight * 100.0) as i32, joint * 7 % 5));
    weights.truncate(most);
    weights
}

#[test]
fn rows_that_are_shifted_are_told_whatever_the_vertex_at_the_end_has() {
    let figure = Figure::builtin("adult", turned(41));
    let shifted: [Rows; 4] = [
        |rows| [&rows[..1], &rows[..rows.len() - 1]].concat(),
        |rows| [&rows[rows.len() - 1..], &rows[..rows.len() - 1]].concat(),
        |rows| [&rows[1..], &rows[rows.len() - 1..]].concat(),
        |rows| [&rows[1..], &rows[..1]].concat(),
    ];
    for rows in shifted {
        let student = Student { rows, ..RIGHT };
        let found = figure.diagnose(&written(&student.skin(&figure), 6));
        assert_eq!(named(&found), [["weight-rows-shifted"]], "{found}");
    }
}

#[test]
fn of_equal_weights_a_program_may_leave_out_any() {
    let figure = Figure::builtin("adult", turned(42));
    // Six weights each, the last four of which are alike.
    let rows = figure.rows.iter().enumerate().map(|(vertex, row)| {
        let mut alike = vec![0.0; row.len()];
        for (at, weight) in [0.3, 0.3, 0.1, 0.1, 0.1, 0.1].into_iter().enumerate() {
            alike[(vertex + at * 2) % row.len()] = weight;
        }
        alike
    });
    let rows = rows.collect();
    let figure = figure.with_rows(rows);
    let cut: [(&str, Cut); 2] = [
        ("influences-cut-4", |weights| largest(weights, 4)),
        ("strongest-joint-only", |weights| largest(weights, 1)),
    ];
    for (id, weights) in cut {
        let student = Student { weights, ..RIGHT };
        let found = figure.diagnose(&written(&student.skin(&figure), 6));
        assert_eq!(found.together(), [id], "{found}");
    }
}

#[test]
fn a_mistake_that_gives_all_vertices_but_a_few_is_the_nearest_one() {
    let figure = Figure::builtin("adult", turned(43));
    let mut theirs = with(&["weights-shifted"]).skin(&figure);
    let all = theirs.len();
    for vertex in [0, all / 2, all - 1] {
        theirs[vertex].y += 1000.0;
    }
    let found = figure.diagnose(&theirs);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    let nearest = found.nearest.as_ref().unwrap();
    assert_eq!((nearest.mistake.id, nearest.off), ("weights-shifted", 3));
    assert!(nearest.is_nearly_all(), "{found}");
    assert!(
        found
            .to_string()
            .contains(", and gives all but 3 vertices\n"),
        "{found}"
    );
}

#[test]
fn joints_that_are_one_too_high_are_named_whatever_becomes_of_the_last_one() {
    let clamped = Student {
        row: |row| {
            let (last, others) = row.split_last().unwrap();
            let (before, first) = others.split_last().unwrap();
            [&[0.0], first, &[before + last]].concat()
        },
        ..RIGHT
    };
    let wrapped = Student {
        joint_of_column: |column| column,
        row: |row| {
            let (last, others) = row.split_last().unwrap();
            [&[*last, 0.0], others].concat()
        },
        ..RIGHT
    };
    let rolled = Student {
        row: |row| {
            let (last, others) = row.split_last().unwrap();
            [&[*last], others].concat()
        },
        ..RIGHT
    };
    let lost = with(&["weights-shifted-on"]);
    for (name, seed) in [("adult", 44), ("robot", 45)] {
        let figure = Figure::builtin(name, turned(seed));
        for (student, how) in [
            (&lost, "the last one for none"),
            (&clamped, "the last one for itself"),
            (&wrapped, "the last one for the root"),
            (&rolled, "the last one for the joint that has the first"),
        ] {
            let found = figure.diagnose(&written(&student.skin(&figure), 6));
            assert_eq!(found.together(), ["weights-shifted-on"], "{found}");
            assert_eq!(found.mistakes[0].how, how, "{found}");
        }
    }
}

#[test]
fn a_first_column_that_goes_around_to_the_last_joint_is_named() {
    let rolled = Student {
        row: |row| {
            let (first, others) = row.split_first().unwrap();
            [others, &[*first]].concat()
        },
        ..RIGHT
    };
    let figure = Figure::builtin("adult", turned(44));
    let found = figure.diagnose(&written(&rolled.skin(&figure), 6));
    assert_eq!(found.together(), ["weights-shifted"], "{found}");
    assert_eq!(
        found.mistakes[0].how, "the first one for the last joint",
        "{found}"
    );
}
