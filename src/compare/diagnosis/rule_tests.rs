//! Tests of the order of rules, and of what each finds.

use super::*;
use crate::compare::test_pictures::{filled, painted};
use crate::geometry::Picture;

const SIZE: (u32, u32) = (64, 48);
const DARK: [u8; 4] = [26, 26, 26, 255];

/// Names of the rules that find something in B, compared with A.
fn names(a: &Picture, b: &Picture) -> Vec<&'static str> {
    let pair = Pair::new(a, b, &[]).unwrap();
    let pair = &pair;
    let found = at_once(|pace| async move { named_findings(pair, &pace).await });
    found.into_iter().map(|(name, _)| name).collect()
}

fn paint(color: impl Fn(u32, u32) -> [u8; 4]) -> Picture {
    painted(SIZE.0, SIZE.1, color)
}

fn changed(picture: &Picture, change: impl Fn(u32, u32, [u8; 4]) -> [u8; 4]) -> Picture {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    paint(|x, y| change(x, y, pixels[(y * SIZE.0 + x) as usize]))
}

/// Whether a pixel is that far or nearer to the middle of the ball.
fn near_ball(x: u32, y: u32, radius: f32) -> bool {
    (x as f32 - 26.0).hypot(y as f32 - 22.0) < radius
}

/// A brown ball of radius 14, lighter to the right, and a blue slab below it.
fn scene() -> Picture {
    paint(|x, y| match (x, y) {
        _ if near_ball(x, y, 14.0) => [80 + 2 * x as u8, 50 + x as u8, 40 + x as u8, 255],
        (30..=45, 40..=43) => [51, 77, 179, 255],
        _ => DARK,
    })
}

/// A white square whose sides are as long as given, in the middle of a picture.
fn square(side: u32) -> Picture {
    let inside = |at: u32, middle: u32| (middle - side / 2..middle + side / 2).contains(&at);
    paint(|x, y| {
        if inside(x, 32) && inside(y, 24) {
            [200, 200, 200, 255]
        } else {
            DARK
        }
    })
}

fn is_dark([r, g, b, _]: [u8; 4]) -> bool {
    [r, g, b] == DARK[..3]
}

fn with_channels(picture: &Picture, change: impl Fn([f32; 3]) -> [f32; 3]) -> Picture {
    changed(picture, |_, _, pixel| {
        if is_dark(pixel) {
            return pixel;
        }
        let [r, g, b, alpha] = pixel;
        let [r, g, b] = change([r, g, b].map(f32::from)).map(|c| c.round() as u8);
        [r, g, b, alpha]
    })
}

#[test]
fn the_rules_stand_from_the_most_telling_to_the_least() {
    let order = Evidence::RULES.map(|rule| rule.name);
    let documented = [
        "transparent",
        "blank",
        "mirrored",
        "shifted",
        "opacity",
        "red_blue_exchanged",
        "gray",
        "only_background",
        "background",
        "axes",
        "axes_too",
        "nearly_same",
        "gamma",
        "brightness",
        "highlight",
        "edges",
        "detail",
        "placed",
        "outline",
        "shading",
    ];
    assert_eq!(order, documented);
}

#[test]
fn each_rule_beside_which_another_is_asked_is_one_of_those_before_it() {
    let rules = Evidence::RULES;
    for (index, rule) in rules.iter().enumerate() {
        if let Only(names) = rule.beside {
            let before: Vec<_> = rules[..index].iter().map(|rule| rule.name).collect();
            assert!(
                names.iter().all(|name| before.contains(name)),
                "{}",
                rule.name
            );
        }
    }
}

/// B for which each rule is the one that finds the cause in [`scene`].
fn provoking() -> Vec<(&'static str, Picture)> {
    let a = scene();
    let encode = |c: f32| 255.0 * (1.055 * (c / 255.0).powf(1.0 / 2.4) - 0.055);
    vec![
        (
            "transparent",
            changed(&a, |_, _, [r, g, b, _]| [r, g, b, 0]),
        ),
        ("blank", filled(SIZE.0, SIZE.1, DARK)),
        ("mirrored", {
            let (pixels, _) = a.rgba.as_chunks::<4>();
            paint(|x, y| pixels[(y * SIZE.0 + SIZE.0 - 1 - x) as usize])
        }),
        ("shifted", {
            let (pixels, _) = a.rgba.as_chunks::<4>();
            paint(|x, y| pixels[(y * SIZE.0 + (x + 3).min(SIZE.0 - 1)) as usize])
        }),
        (
            "opacity",
            changed(&a, |x, _, [r, g, b, _]| {
                [r, g, b, if x == 9 { 250 } else { 255 }]
            }),
        ),
        (
            "red_blue_exchanged",
            changed(&a, |_, _, [r, g, b, alpha]| [b, g, r, alpha]),
        ),
        (
            "gray",
            with_channels(&a, |[r, g, b]| [0.299 * r + 0.587 * g + 0.114 * b; 3]),
        ),
        (
            "only_background",
            changed(&a, |_, _, pixel| {
                if is_dark(pixel) {
                    [90, 120, 140, 255]
                } else {
                    pixel
                }
            }),
        ),
        (
            "axes",
            changed(&a, |x, y, pixel| match (x, y) {
                (28, _) if is_dark(pixel) => [77, 204, 77, 255],
                (_, 30) if is_dark(pixel) => [128, 26, 26, 255],
                _ => pixel,
            }),
        ),
        (
            "nearly_same",
            changed(&a, |x, y, [r, g, b, alpha]| {
                [r, g, b + u8::from((x, y) == (20, 20)), alpha]
            }),
        ),
        ("gamma", with_channels(&a, |color| color.map(encode))),
        (
            "brightness",
            with_channels(&a, |color| color.map(|c| 0.7 * c)),
        ),
        (
            "highlight",
            changed(&a, |x, y, [r, g, b, alpha]| {
                let away = (x as f32 - 30.0).hypot(y as f32 - 18.0) / 8.0;
                let light = (80.0 * (1.0 - away).max(0.0)) as u8;
                [r + light, g + light, b + light, alpha]
            }),
        ),
        (
            "edges",
            changed(&a, |x, y, pixel| {
                let rim = near_ball(x, y, 14.0) && !near_ball(x, y, 13.0);
                if rim {
                    pixel.map(|c| if c == 255 { c } else { c / 2 + 13 })
                } else {
                    pixel
                }
            }),
        ),
        (
            "detail",
            changed(&a, |x, y, [r, g, b, alpha]| match near_ball(x, y, 10.0) {
                true if (x + y) % 2 == 0 => [r + 13, g + 13, b + 13, alpha],
                true => [r - 13, g - 13, b - 13, alpha],
                false => [r, g, b, alpha],
            }),
        ),
        (
            "outline",
            changed(&a, |_, y, pixel| if y > 38 { DARK } else { pixel }),
        ),
        (
            "shading",
            changed(&a, |x, y, pixel| {
                if (20..26).contains(&x) && (18..24).contains(&y) {
                    [30, 40, 200, 255]
                } else {
                    pixel
                }
            }),
        ),
    ]
}

#[test]
fn each_rule_can_be_the_one_that_finds_the_cause() {
    for (name, b) in provoking() {
        assert_eq!(names(&scene(), &b), [name]);
    }
    assert_eq!(names(&square(20), &square(24)), ["placed"]);
    let elsewhere = changed(&scene(), |_, y, pixel| match is_dark(pixel) || y > 38 {
        true => [90, 120, 140, 255],
        false => pixel,
    });
    assert_eq!(names(&scene(), &elsewhere), ["background", "outline"]);
    let with_axes = changed(&scene(), |x, y, pixel| match (x, y) {
        (4, _) => [77, 204, 77, 255],
        (_, 4) => [128, 26, 26, 255],
        _ if y > 38 => DARK,
        _ => pixel,
    });
    assert_eq!(names(&scene(), &with_axes), ["axes_too", "outline"]);
    // Both show them, and a panel in one of them hides some of them.
    let with_panel = changed(&with_axes, |x, y, pixel| match x > 44 || y > 30 {
        true => [60, 60, 64, 255],
        false => pixel,
    });
    for (a, b) in [(&with_axes, &with_panel), (&with_panel, &with_axes)] {
        assert!(!names(a, b).contains(&"axes_too"), "{:?}", names(a, b));
    }
    let mut tried: Vec<_> = provoking().into_iter().map(|(name, _)| name).collect();
    tried.extend(["placed", "background", "axes_too"]);
    for rule in Evidence::RULES {
        assert!(
            tried.contains(&rule.name),
            "no picture provokes {}",
            rule.name
        );
    }
}

#[test]
fn equal_pictures_give_no_rule_anything_to_find() {
    assert_eq!(names(&scene(), &scene()), [""; 0]);
}

#[test]
fn where_several_causes_fit_the_most_telling_is_reported() {
    let at = |left: u32| {
        paint(|x, y| {
            if (left..left + 20).contains(&x) && (10..30).contains(&y) {
                [200, 100, 50, 255]
            } else {
                DARK
            }
        })
    };
    assert_eq!(names(&at(20), &at(24)), ["mirrored"], "moved as well");
    assert_eq!(names(&at(20), &at(25)), ["shifted"]);
    let blank = filled(SIZE.0, SIZE.1, [200, 100, 50, 255]);
    let exchanged = filled(SIZE.0, SIZE.1, [50, 100, 200, 255]);
    assert_eq!(names(&blank, &exchanged), ["blank", "only_background"]);
    // White light and a factor of brightness are as good as each other on one color.
    let lighter = with_channels(&at(20), |color| color.map(|c| c * 1.1));
    assert_eq!(names(&at(20), &lighter), ["brightness"]);
}

#[test]
fn opacity_and_another_background_are_reported_beside_a_movement() {
    let a = scene();
    let (pixels, _) = a.rgba.as_chunks::<4>();
    let moved = paint(|x, y| pixels[(y * SIZE.0 + (x + 3).min(SIZE.0 - 1)) as usize]);
    let faint = changed(&moved, |x, _, [r, g, b, _]| {
        [r, g, b, if x == 9 { 250 } else { 255 }]
    });
    assert_eq!(names(&a, &faint), ["shifted", "opacity"]);
    let elsewhere = changed(&moved, |_, _, pixel| match is_dark(pixel) {
        true => [90, 120, 140, 255],
        false => pixel,
    });
    assert_eq!(names(&a, &elsewhere), ["shifted", "background"]);
}

#[test]
fn masked_panels_do_not_hide_exchanged_channels() {
    let panels = |x: u32, y: u32, pixel| {
        if x < 12 || y < 6 {
            [40, 90, 160, 255]
        } else {
            pixel
        }
    };
    let a = changed(&scene(), panels);
    let b = changed(&scene(), |_, _, [r, g, b, alpha]| [b, g, r, alpha]);
    let masks = ["0,0,12,48", "0,0,64,6"].map(|area| area.parse().unwrap());
    let pair = Pair::new(&a, &b, &masks).unwrap();
    assert_eq!(pair.findings(), [Finding::RedBlueExchanged]);
}
