use crate::curves::support::{evaluate, read};
use crate::work::grows_in_proportion;
use editor_core::geometry::{Basis, CurveForm};
use editor_core::io::to_swp;
use editor_core::scene::{CurveItemKind, CurveSet};
use glam::Vec3;
use proptest::prelude::*;

const GOOD: &str = "bez2 a 5 4 [0 0] [1 0] [1 1] [0 1]
bsp3 b 6 5 [0 0 0] [1 0 -1.5] [1 1 1]
  [0 1 2] [3 -1 2e-1]
circ . 8 0.25
srev vase 12 a
gcyl tube . b
";

#[test]
fn every_kind_of_curve_and_surface_is_read() {
    let set = read(GOOD).unwrap();
    let names: Vec<&str> = set.items().iter().map(|item| &*item.name).collect();
    assert_eq!(names, ["a", "b", ".", "vase", "tube"]);
    let CurveForm::Spline {
        basis,
        flat,
        control_points,
    } = set.curve(1).unwrap().form()
    else {
        panic!("a spline was expected");
    };
    assert_eq!((*basis, *flat), (Basis::BSpline, false));
    assert_eq!(control_points[4], Vec3::new(3.0, -1.0, 0.2));
    assert_eq!(set.curve(1).unwrap().steps(), 6);
    let revolution = CurveItemKind::Revolution {
        steps: 12,
        profile: 0,
    };
    assert_eq!(set.items()[3].kind, revolution);
    let sweep = CurveItemKind::Sweep {
        profile: 2,
        sweep: 1,
    };
    assert_eq!(set.items()[4].kind, sweep);
}

#[test]
fn white_space_does_not_matter_beside_brackets() {
    let spaced = "bez2 a 5 4[0 0][1 0] [ 1 1 ]\r\n\r\n[0\n1] \n srev vase 12\ta";
    let plain = "bez2 a 5 4 [0 0] [1 0] [1 1] [0 1] srev vase 12 a";
    assert_eq!(read(spaced), read(plain));
}

#[test]
fn of_several_curves_with_one_name_a_surface_takes_the_latest_before_it() {
    let set = read("circ . 4 1 circ . 8 2 srev . 5 . circ . 4 3 srev . 6 .").unwrap();
    let profile = |item: usize| match set.items()[item].kind {
        CurveItemKind::Revolution { profile, .. } => profile,
        _ => panic!("a surface was expected"),
    };
    assert_eq!((profile(2), profile(4)), (1, 3));
}

#[test]
fn each_fault_is_told_where_it_is() {
    for (text, error) in [
        ("", "a.swp:1:1: expected a curve, found none"),
        ("\n \n", "a.swp:1:1: expected a curve, found none"),
        (
            "circ a 5 1\n  disc b",
            "a.swp:2:3: expected bez2, bez3, bsp2, bsp3, circ, srev or gcyl, found “disc”",
        ),
        (
            "bez2 a 5 6 [0 0]",
            "a.swp:1:10: expected 3k + 1 control points (4, 7, 10, …) for a Bézier curve, found 6",
        ),
        (
            "bsp2 a 5 3",
            "a.swp:1:10: expected at least 4 control points for a B-spline, found 3",
        ),
        (
            "bsp2 a 5 4\n[0 0] [0 0]\n[0 0]\ncirc",
            "a.swp:4:1: expected `[` of control point 4 of 4, found “circ”",
        ),
        (
            "bsp2 a 5 4 [0 0] [0 0] [0 0] [0 0] [0 0]",
            "a.swp:1:36: expected bez2, bez3, bsp2, bsp3, circ, srev or gcyl, found “[”",
        ),
        (
            "bsp2 a 5 4 [0 0 0]",
            "a.swp:1:17: expected `]` after 2 numbers, found “0”",
        ),
        (
            "bsp3 a 5 4 [0 0]",
            "a.swp:1:16: expected z of control point 1 of 4, a number, found “]”",
        ),
        (
            "bsp2 a 5 4 [0 nan]",
            "a.swp:1:15: expected y of control point 1 of 4, a number, found “nan”",
        ),
        (
            "circ a 0 1",
            "a.swp:1:8: expected 1 to 10000 steps, found “0”",
        ),
        (
            "circ a 99999999999 1",
            "a.swp:1:8: expected 1 to 10000 steps, found “99999999999”",
        ),
        (
            "circ a 5.5 1",
            "a.swp:1:8: expected the number of steps, a whole number, found “5.5”",
        ),
        (
            "bsp2 a 5 99999999999999",
            "a.swp:1:10: expected at most 1000000 control points, found “99999999999999”",
        ),
        (
            "circ a 5",
            "a.swp:1:9: expected the radius, a number, found the end of the file",
        ),
        (
            "circ a 5 1e20",
            "a.swp:1:6: expected numbers within ±1e9, found 1e20",
        ),
        (
            "circ a 5 1\nsrev s 9 b",
            "a.swp:2:10: expected the name of the profile, found “b”: \
             no curve before has this name",
        ),
        (
            "circ a 5 1\nsrev s 9 a\ngcyl t a s",
            "a.swp:3:10: expected the name of the curve to sweep along, found “s”: \
             no curve before has this name",
        ),
        (
            "bsp3 ä 5 4 [0 0 0] [1 0 0] [1 1 0] [0 1 1]\nsrev s 9 ä",
            "a.swp:2:10: expected a profile in the plane z = 0, found “ä”, which leaves it",
        ),
        (
            "circ a 9999 1 srev s 9999 a",
            "a.swp:1:20: expected at most 2000000 points and vertices in all, found 100010000",
        ),
    ] {
        assert_eq!(read(text).unwrap_err(), error, "{text}");
    }
}

#[test]
fn many_warnings_are_counted_and_not_kept() {
    let text = "circ a 1 1\n".repeat(20_000);
    let imported = editor_core::io::read_swp(std::path::Path::new("a.swp"), text.as_bytes());
    let told: Vec<String> = imported
        .unwrap()
        .warnings
        .iter()
        .map(|w| w.to_string())
        .collect();
    assert_eq!(told.len(), 101);
    assert!(
        told[99].starts_with("a.swp:101:6: expected another name"),
        "{}",
        told[99]
    );
    assert_eq!(told[100], "a.swp: 19899 more warnings are not shown");
}

#[test]
fn warnings_that_are_not_kept_cost_little() {
    let same_names = |count: usize| "circ a 1 1\n".repeat(count);
    grows_in_proportion(5_000, same_names, |text: String| {
        editor_core::io::read_swp(std::path::Path::new("a.swp"), text.as_bytes()).unwrap();
    });
}

#[test]
fn every_beginning_of_a_file_is_an_error_or_a_smaller_file() {
    let whole = read(GOOD).unwrap();
    for end in 0..GOOD.len() {
        match read(&GOOD[..end]) {
            // A name or number that is cut short may still be one: then only the last differs.
            Ok(part) => {
                let complete = part.items().len() - 1;
                assert!(complete < whole.items().len());
                assert_eq!(part.items()[..complete], whole.items()[..complete]);
                evaluate(part, true);
            }
            Err(error) => assert!(error.starts_with("a.swp"), "{error}"),
        }
    }
}

#[test]
fn what_was_written_is_read_back_the_same() {
    let set = read(GOOD).unwrap();
    assert_eq!(read(&to_swp(&set)).unwrap(), set);
}

#[test]
fn a_curve_that_a_later_one_of_its_name_hides_is_written_under_another_name() {
    let mut set = read("circ . 4 1 circ . 8 2").unwrap();
    let surface = CurveItemKind::Revolution {
        steps: 5,
        profile: 0,
    };
    set.push("s", surface.clone()).unwrap();
    let text = to_swp(&set);
    assert_eq!(text, "circ curve1 4 1\n\ncirc . 8 2\n\nsrev s 5 curve1\n");
    assert_eq!(read(&text).unwrap().items()[2].kind, surface);
}

#[test]
fn names_that_a_file_cannot_hold_are_refused() {
    let mut set = CurveSet::start_circle();
    let circle = set.items()[0].kind.clone();
    for name in ["", "a b", "a[", "]"] {
        assert!(set.push(name, circle.clone()).is_err(), "{name}");
    }
}

proptest! {
    #[test]
    fn no_bytes_end_the_program(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = editor_core::io::read_swp(std::path::Path::new("a.swp"), &bytes);
    }

    #[test]
    fn no_order_of_words_ends_the_program(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "bez2", "bez3", "bsp2", "bsp3", "circ", "srev", "gcyl", ".", "a", "4", "5", "1",
                "-1", "[", "]", "[0 1]", "[0 0 0]", "[1 2 3]", "1e9", "10000",
            ]),
            0..60,
        )
    ) {
        if let Ok(set) = read(&words.join(" ")) {
            prop_assert_eq!(&read(&to_swp(&set)).unwrap(), &set);
        }
    }

    #[test]
    fn numbers_are_written_with_all_their_digits(
        points in prop::collection::vec((-1e9_f32..1e9, -1.0_f32..1.0, -1e-9_f32..1e-9), 4..9)
    ) {
        let list: String = points.iter().map(|(x, y, z)| format!("[{x} {y} {z}]")).collect();
        let set = read(&format!("bsp3 . 5 {} {list}", points.len())).unwrap();
        prop_assert_eq!(&read(&to_swp(&set)).unwrap(), &set);
    }
}
