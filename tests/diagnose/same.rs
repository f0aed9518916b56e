//! Which causes are named beside one another, and in which order.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, with};
use editor_core::diagnose::{Diagnosis, Verdict};
use glam::Vec3;

/// What is found out about the mesh of a student with the mistakes `ids`.
fn found(figure: &Figure, ids: &[&str], digits: usize) -> Diagnosis {
    figure.diagnose(&written(&with(ids).skin(figure), digits))
}

#[test]
fn mistakes_that_a_pose_does_not_tell_apart_are_all_named_the_most_telling_first() {
    let right_elbow = 14;
    let about_z = |joint| {
        if joint == right_elbow {
            Vec3::Z * 50.0
        } else {
            Vec3::ZERO
        }
    };
    let figure = Figure::builtin("adult", about_z);
    let flipped = found(&figure, &["sign-flipped-z"], 6);
    assert_eq!(
        named(&flipped),
        [
            ["rotation-transposed"],
            ["angles-negated"],
            ["sign-flipped-z"],
            ["wrong-inverse"],
            ["current-rotation-transposed"]
        ]
    );
    let told = flipped.to_string();
    let same = "\n  indistinguishable here: angles-negated, sign-flipped-z, wrong-inverse";
    assert!(told.contains(same), "{told}");
    let ignored = found(&figure, &["one-axis-ignored-z"], 6);
    // The elbow is the last joint of its arm.
    assert_eq!(
        named(&ignored),
        [
            ["pose-not-applied"],
            ["one-axis-ignored-z"],
            ["only-root-turned"],
            ["joints-not-reached"],
            ["own-transform-missing"],
            ["rotation-of-children-only"]
        ]
    );
    let ordered = found(&figure, &["euler-zyx"], 6);
    assert_eq!(
        (ordered.verdict, named(&ordered).len()),
        (Verdict::Right, 0)
    );
}

#[test]
fn angles_that_are_all_negated_are_one_mistake_and_not_two() {
    let figure = Figure::builtin("adult", turned(35));
    let negated = found(&figure, &["angles-negated"], 6);
    assert_eq!(named(&negated), [["angles-negated"]]);
    // The other way to say it.
    let two = found(&figure, &["rotation-transposed", "euler-zyx"], 6);
    assert_eq!(named(&two), [["angles-negated"]]);
}

#[test]
fn digits_tell_apart_what_fewer_digits_do_not() {
    let figure = Figure::builtin("adult", turned(31));
    // Weights that do not sum to 1, of which all but the four largest hardly count.
    let rows = figure.rows.iter().map(|row| {
        let mut order: Vec<usize> = (0..row.len()).collect();
        order.sort_by(|&a, &b| row[b].total_cmp(&row[a]));
        let mut weak = vec![0.0; row.len()];
        order[..4]
            .iter()
            .for_each(|&column| weak[column] = row[column] * 0.99);
        weak[order[4]] = 1e-4;
        weak
    });
    let rows = rows.collect();
    let figure = figure.with_rows(rows);
    let named = |digits| named(&found(&figure, &["weights-normalized"], digits));
    let [alone, other] = ["weights-normalized", "influences-cut-4-renormalized"];
    assert_eq!(named(8), [[alone]]);
    assert_eq!(named(4), [[other], [alone]]);
}

#[test]
fn a_mistake_that_hardly_shows_is_told_where_digits_show_it() {
    let figure = Figure::builtin("adult", turned(34));
    let rows = figure
        .rows
        .iter()
        .map(|row| row.iter().map(|weight| weight * 1.0001).collect());
    let rows = rows.collect();
    let figure = figure.with_rows(rows);
    let exactly = found(&figure, &["weights-normalized"], 8);
    assert_eq!(named(&exactly), [["weights-normalized"]]);
    assert!(
        exactly.error_from_exact < 1e-4 && exactly.first.is_some(),
        "{exactly}"
    );
    let roughly = found(&figure, &["weights-normalized"], 4);
    assert_eq!(
        (roughly.verdict, named(&roughly).len()),
        (Verdict::Right, 0)
    );
}

#[test]
fn of_two_mistakes_the_one_that_accounts_for_more_is_named_first() {
    let figure = Figure::builtin("adult", turned(32)).with_weights_of(2);
    for ids in [
        ["joints-by-depth", "weights-normalized"],
        ["parent-missing", "weights-normalized"],
    ] {
        let both = found(&figure, &ids, 6);
        assert_eq!(both.together(), ids, "{both}");
        assert_eq!(both.causes[..2], ids, "{both}");
        let first_line = format!("2 mistakes: {} and {}\n", ids[0], ids[1]);
        assert!(both.to_string().starts_with(&first_line), "{both}");
    }
}

#[test]
fn a_single_vertex_that_is_off_is_not_explained_away() {
    let figure = Figure::builtin("adult", turned(33));
    let theirs = with(&["weights-shifted"]).skin(&figure);
    let exact = RIGHT.skin(&figure);
    assert_eq!(figure.diagnose(&theirs).verdict, Verdict::Explained);
    // Where the mistake makes least difference, the vertex is not among those that are tried first.
    let apart = |vertex: &usize| exact[*vertex].distance(theirs[*vertex]);
    let least = (0..theirs.len())
        .min_by(|a, b| apart(a).total_cmp(&apart(b)))
        .unwrap();
    for vertex in [least, least + 1, least + 2] {
        let mut theirs = theirs.clone();
        theirs[vertex].x += 0.002;
        let found = figure.diagnose(&theirs);
        assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
        assert_eq!(found.nearest.unwrap().mistake.id, "weights-shifted");
    }
}
