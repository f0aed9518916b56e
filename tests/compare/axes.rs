//! Axes that one of two pictures shows.

use crate::compare::painter::{SCENE, Scene, WIDTH};
use editor_core::compare::{Finding, Pair, Which};
use editor_core::geometry::Picture;

fn findings(a: &Picture, b: &Picture) -> Vec<Finding> {
    Pair::new(a, b, &[]).unwrap().findings()
}

/// A line two pixels wide with smooth edges, from one place to another.
type Line = ([f32; 2], [f32; 2], [u8; 3]);

const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];

/// The axes from a little beside Z, which is nearly along X in the picture. Each leaves it.
const AXES: [Line; 3] = [
    ([-1.0, 95.3], [161.0, 95.3], RED),
    ([120.4, -1.0], [120.4, 121.0], GREEN),
    ([-1.0, 91.0], [120.4, 95.3], BLUE),
];

/// `picture` with `lines` behind what is drawn in it.
fn with_lines(picture: &Picture, lines: &[Line], half_width: f32) -> Picture {
    let mut picture = picture.clone();
    let (pixels, _) = picture.rgba.as_chunks_mut::<4>();
    for &(from, to, color) in lines {
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        for (index, pixel) in pixels.iter_mut().enumerate() {
            let (x, y) = (index as u32 % WIDTH, index as u32 / WIDTH);
            let off = [x as f32 + 0.5 - from[0], y as f32 + 0.5 - from[1]];
            let across = (off[0] * along[1] - off[1] * along[0]).abs() / length;
            let part = (off[0] * along[0] + off[1] * along[1]) / (length * length);
            let cover = (half_width + 0.5 - across).clamp(0.0, 1.0);
            let is_behind = pixel[..3] != SCENE.background && !is_of_line(*pixel);
            if (0.0..=1.0).contains(&part) && !is_behind {
                for (channel, own) in pixel.iter_mut().zip(color) {
                    let mixed = f32::from(*channel) * (1.0 - cover) + f32::from(own) * cover;
                    *channel = mixed.round() as u8;
                }
            }
        }
    }
    picture
}

/// Whether a pixel is of a line that was drawn before: no color of the scene is so pure.
fn is_of_line([r, g, b, _]: [u8; 4]) -> bool {
    let dark = [r, g, b].into_iter().filter(|&channel| channel <= 26);
    dark.count() >= 2
}

#[test]
fn axes_with_smooth_edges_are_told_where_nothing_else_differs() {
    let without = SCENE.paint();
    let with = with_lines(&without, &AXES, 0.8);
    let told = |a, b| {
        findings(a, b)
            .iter()
            .map(Finding::sentence)
            .collect::<Vec<_>>()
    };
    let where_from = "apart from them nothing differs (View ⏵ Toggle Axis, T, or --axis).";
    let only_b = format!("B shows the axes, A does not: {where_from}");
    let only_a = format!("A shows the axes, B does not: {where_from}");
    assert_eq!(told(&without, &with), [only_b]);
    assert_eq!(told(&with, &without), [only_a]);
}

/// A picture of something gray of which the part is seen through that `is_hole`.
fn gray_but(is_hole: impl Fn(u32, u32) -> bool) -> Picture {
    let mut picture = SCENE.paint();
    let (pixels, _) = picture.rgba.as_chunks_mut::<4>();
    for (index, pixel) in pixels.iter_mut().enumerate() {
        let [r, g, b] = match is_hole(index as u32 % WIDTH, index as u32 / WIDTH) {
            true => SCENE.background,
            false => [140, 140, 140],
        };
        *pixel = [r, g, b, 255];
    }
    picture
}

#[test]
fn axes_that_a_figure_around_them_hides_are_told_where_nothing_else_differs() {
    let told = |without: &Picture, lines: &[Line]| {
        let with = with_lines(without, lines, 0.5);
        let found = findings(without, &with);
        let alone = Finding::Axes {
            only_in: Which::B,
            alone: true,
        };
        found == [alone]
    };
    let [x, y, _] = AXES;
    // Through the hole of a ring, and a line of which most is hidden.
    let ring = gray_but(|x, y| x.abs_diff(120) < 30 && y.abs_diff(90) < 25);
    assert!(told(&ring, &[x, y]));
    let vase = gray_but(|x, _| !(18..140).contains(&x));
    assert!(told(&vase, &[x]));
    // A single line that ends in the picture may be anything.
    assert!(!told(&ring, &[x]));
    // Over a line of another color that both have.
    let yellow = ([-1.0, 95.3], [60.0, 95.3], [255, 255, 0]);
    let both = with_lines(&SCENE.paint(), &[yellow], 0.5);
    assert!(told(&both, &AXES));
}

#[test]
fn axes_are_told_beside_what_else_differs_and_do_not_hide_it() {
    let without = SCENE.paint();
    let moved = Scene {
        center: [78.0, 51.0],
        ..SCENE
    };
    let alone = findings(&without, &moved.paint());
    assert!(!alone.is_empty());
    let found = findings(&without, &with_lines(&moved.paint(), &AXES, 0.8));
    let only_in = Which::B;
    assert_eq!(
        found[0],
        Finding::Axes {
            only_in,
            alone: false
        }
    );
    assert_eq!(found[1..], alone);
    assert_eq!(
        found[0].to_string(),
        "B shows the axes, A does not (View ⏵ Toggle Axis, T, or --axis)"
    );
    // As smooth edges differ: those of the picture and the axes.
    let smooth = Scene {
        samples: 4,
        ..SCENE
    };
    let found = findings(&smooth.paint(), &with_lines(&without, &AXES, 0.8));
    assert!(
        matches!(
            found[..],
            [
                Finding::Axes {
                    only_in: Which::B,
                    ..
                },
                Finding::Edges { .. }
            ]
        ),
        "{found:?}"
    );
}

#[test]
fn lines_that_are_no_axes_are_not_called_so() {
    let without = SCENE.paint();
    let is_axes = |finding: &Finding| matches!(finding, Finding::Axes { .. });
    let is_found = |a: &Picture, b: &Picture| findings(a, b).iter().any(is_axes);
    assert!(is_found(&without, &with_lines(&without, &AXES, 0.8)));
    // They end in the picture, as the axes of a joint do.
    let short = AXES.map(|(_, _, color)| ([122.0, 90.0], [150.0, 90.0], color));
    assert!(!is_found(&without, &with_lines(&without, &short, 0.8)));
    assert!(
        !is_found(&without, &with_lines(&without, &AXES, 5.0)),
        "bars"
    );
    let gray = AXES.map(|(from, to, _)| (from, to, [140; 3]));
    assert!(!is_found(&without, &with_lines(&without, &gray, 0.8)));
    // Beside what else differs, the bone and the edge of one limb that leaves the picture.
    let beside: [Line; 2] = [
        ([120.4, -1.0], [112.0, 121.0], RED),
        ([128.4, -1.0], [124.0, 121.0], GREEN),
    ];
    let moved = Scene {
        center: [78.0, 51.0],
        ..SCENE
    };
    let found = |lines: &[Line]| is_found(&without, &with_lines(&moved.paint(), lines, 0.8));
    assert!(!found(&beside));
    assert!(found(&AXES[..2]), "two that cross");
    // Bones and edges that lie in two such lines by chance have gaps.
    let dashes = AXES[..2].iter().flat_map(|&([x, y], [u, v], color)| {
        let [along_x, along_y] = [u - x, v - y];
        let at = move |part: f32| [x + part * along_x, y + part * along_y];
        [0.0, 0.3, 0.6, 0.9].map(|part| (at(part), at(part + 0.08), color))
    });
    let dashes: Vec<Line> = dashes.collect();
    assert!(!found(&dashes));
    let along_a_side = ([70.0, 0.5], [150.0, 0.5], RED);
    let that_ends_inside = ([70.0, 95.0], [150.0, 90.0], BLUE);
    for line in [along_a_side, that_ends_inside] {
        assert!(!found(&[line, AXES[1]]), "{line:?}");
    }
    // Both show them, from another side.
    let elsewhere = AXES.map(|([x, y], to, color)| ([x + 9.0, y - 9.0], to, color));
    let with = with_lines(&without, &AXES, 0.8);
    assert!(!is_found(&with, &with_lines(&without, &elsewhere, 0.8)));
}
