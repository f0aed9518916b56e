use crate::compare::painter::{HEIGHT, SCENE, Scene, WIDTH, rearranged, recolored};
use crate::work::work;
use editor_core::compare::{Finding, HighlightChange, Pair, PictureOptions, Which};
use editor_core::geometry::Picture;
use glam::Vec3;

fn findings(a: &Picture, b: &Picture) -> Vec<Finding> {
    Pair::new(a, b, &[]).unwrap().findings()
}

/// What is found in the picture of another scene than [`SCENE`].
fn findings_for(b: Scene) -> Vec<Finding> {
    findings(&SCENE.paint(), &b.paint())
}

fn blank(gray: u8) -> Picture {
    recolored(&SCENE.paint(), |_| [gray, gray, gray, 255])
}

#[test]
fn nothing_is_wrong_with_equal_pictures() {
    let a = SCENE.paint();
    let comparison = Pair::new(&a, &a, &[])
        .unwrap()
        .compare(&PictureOptions::default());
    assert!(comparison.passed);
    let judgment = &comparison.judgment;
    assert_eq!((judgment.ssim, judgment.flip), (Some(1.0), 0.0));
    assert_eq!(judgment.findings, []);
    assert!(comparison.to_string().contains("infinite"));
}

#[test]
fn a_blank_picture_is_named() {
    let a = SCENE.paint();
    let found = |picture| Finding::Blank { picture };
    assert_eq!(findings(&a, &blank(26)), [found(Which::B)]);
    assert_eq!(findings(&blank(26), &a), [found(Which::A)]);
    assert_eq!(findings(&blank(26), &blank(26)), [found(Which::Both)]);
    let other = findings(&blank(26), &blank(90));
    assert_eq!(other[0], found(Which::Both));
    assert!(matches!(other[1], Finding::Background { alone: true, .. }));
}

#[test]
fn a_picture_of_opacity_0_is_called_transparent_and_not_blank() {
    let a = SCENE.paint();
    let clear = recolored(&a, |[r, g, b, _]| [r, g, b, 0]);
    let found = |picture| Finding::Transparent { picture };
    assert_eq!(findings(&a, &clear), [found(Which::B)]);
    assert_eq!(findings(&clear, &a), [found(Which::A)]);
    assert_eq!(findings(&clear, &clear), [found(Which::Both)]);
    let nothing = recolored(&a, |_| [0; 4]);
    assert_eq!(
        findings(&a, &nothing)[0],
        Finding::Blank { picture: Which::B }
    );
}

#[test]
fn a_picture_moved_by_whole_pixels_is_named_with_the_movement() {
    for (dx, dy) in [(1, 0), (0, -1), (-3, 5), (8, 8), (31, -17)] {
        let [x, y] = SCENE.center;
        let moved = Scene {
            slab: false,
            center: [x + dx as f32, y + dy as f32],
            ..SCENE
        };
        let still = Scene {
            slab: false,
            ..SCENE
        };
        assert_eq!(
            findings(&still.paint(), &moved.paint()),
            [Finding::Shifted { dx, dy }]
        );
    }
    assert_eq!(
        Finding::Shifted { dx: -3, dy: 1 }.to_string(),
        "B is A moved 3 pixels left and 1 pixel down"
    );
}

#[test]
fn a_picture_cut_off_at_the_border_is_still_found_to_be_moved() {
    let up = |y: f32| Scene {
        center: [70.0, y],
        slab: false,
        ..SCENE
    };
    assert_eq!(
        findings(&up(30.0).paint(), &up(25.0).paint()),
        [Finding::Shifted { dx: 0, dy: -5 }]
    );
}

#[test]
fn one_of_two_things_moved_is_not_a_moved_picture() {
    let moved = Scene {
        center: [75.0, 55.0],
        ..SCENE
    };
    let found = findings_for(moved);
    assert!(
        !found.iter().any(|f| matches!(f, Finding::Shifted { .. })),
        "{found:?}"
    );
    let inside_too = matches!(
        found[..],
        [
            Finding::Outline { .. },
            Finding::Shading {
                outlines_agree: false,
                outlines_cross: true,
                ..
            }
        ]
    );
    assert!(inside_too, "{found:?}");
    // What is drawn elsewhere may be seen from elsewhere, and have the right normals.
    let told = ": another camera, shape, depth or shading (normals, light, material)";
    assert!(found[1].to_string().ends_with(told), "{}", found[1]);
}

#[test]
fn a_mirrored_picture_is_named_with_the_sides() {
    let a = SCENE.paint();
    for (left_right, top_bottom) in [(true, false), (false, true), (true, true)] {
        let b = rearranged(&a, |x, y| {
            (
                if left_right { WIDTH - 1 - x } else { x },
                if top_bottom { HEIGHT - 1 - y } else { y },
            )
        });
        assert_eq!(
            findings(&a, &b),
            [Finding::Mirrored {
                left_right,
                top_bottom
            }]
        );
    }
}

#[test]
fn another_background_is_named_and_whether_it_is_all() {
    let background = [90, 120, 140];
    let named = |alone| Finding::Background {
        a: [26; 3],
        b: background,
        alone,
    };
    assert_eq!(
        findings_for(Scene {
            background,
            ..SCENE
        }),
        [named(true)]
    );
    let found = findings_for(Scene {
        background,
        slab: false,
        ..SCENE
    });
    assert_eq!(found[0], named(false));
    assert!(
        matches!(found[1], Finding::Outline { only_b: 0, .. }),
        "{found:?}"
    );
}

#[test]
fn another_background_hides_nothing_else_that_is_wrong() {
    let alone = Scene {
        slab: false,
        ..SCENE
    };
    let [x, y] = SCENE.center;
    let wrong = [
        alone,
        Scene {
            center: [x + 3.0, y - 1.0],
            ..alone
        },
        Scene {
            center: [x + 0.5, y],
            ..alone
        },
        Scene {
            specular: 0.0,
            ..alone
        },
        Scene {
            radius: 34.0 * 1.25,
            ..alone
        },
    ];
    let mut pictures = wrong.map(|scene| {
        [SCENE.background, [51; 3], [90, 120, 140]].map(|background| {
            Scene {
                background,
                ..scene
            }
            .paint()
        })
    });
    pictures[0] = pictures[0]
        .each_ref()
        .map(|picture| rearranged(picture, |x, y| (WIDTH - 1 - x, y)));
    for [with_same, with_others @ ..] in pictures {
        let expected = findings(&alone.paint(), &with_same);
        assert_eq!(expected.len(), 1, "{expected:?}");
        for picture in with_others {
            let found = findings(&alone.paint(), &picture);
            let (background, others): (Vec<_>, Vec<_>) = found
                .into_iter()
                .partition(|finding| matches!(finding, Finding::Background { alone: false, .. }));
            assert_eq!((background.len(), others), (1, expected.clone()));
        }
    }
}

#[test]
fn a_smooth_rim_over_another_background_is_no_other_difference() {
    let smooth = Scene {
        samples: 4,
        ..SCENE
    };
    let found = findings(
        &smooth.paint(),
        &Scene {
            background: [90, 120, 140],
            ..smooth
        }
        .paint(),
    );
    assert!(
        matches!(found[..], [Finding::Background { alone: true, .. }]),
        "{found:?}"
    );
}

#[test]
fn what_has_the_color_of_the_other_background_is_no_hole() {
    let gray = Scene {
        color: Vec3::splat(0.7),
        specular: 0.0,
        slab: false,
        ..SCENE
    };
    let found = findings(
        &SCENE.paint(),
        &Scene {
            background: [51; 3],
            ..gray
        }
        .paint(),
    );
    let outlines: Vec<_> = found
        .iter()
        .filter_map(|finding| match finding {
            Finding::Outline { only_a, .. } => Some(*only_a),
            _ => None,
        })
        .collect();
    assert_eq!(outlines, [360], "{found:?}");
}

#[test]
fn rounding_and_another_background_are_told_apart() {
    let rounded = recolored(&SCENE.paint(), |[r, g, b, alpha]| match [r, g, b] {
        [26, 26, 26] => [51, 51, 51, alpha],
        _ => [r, g + g % 3, b, alpha],
    });
    let found = findings(&SCENE.paint(), &rounded);
    assert!(
        matches!(found[..], [Finding::Background { alone: true, .. }]),
        "{found:?}"
    );
    let mut spotted = rounded;
    spotted.rgba[0] ^= 128;
    let found = findings(&SCENE.paint(), &spotted);
    assert_eq!(
        found.last().map(ToString::to_string).as_deref(),
        Some(
            "apart from the background, the pictures are the same except for rounding (at most 2 of 255) and 1 pixel that differs by more than 8, within x 0, y 0"
        )
    );
}

#[test]
fn exchanged_channels_are_named() {
    let a = SCENE.paint();
    let b = recolored(&a, |[r, g, b, alpha]| [b, g, r, alpha]);
    assert_eq!(findings(&a, &b), [Finding::RedBlueExchanged]);
    let c = recolored(&a, |[r, g, b, alpha]| [g, r, b, alpha]);
    assert!(!findings(&a, &c).contains(&Finding::RedBlueExchanged));
}

#[test]
fn a_picture_without_colors_is_named_and_nothing_in_it_is_missing() {
    let green = Scene {
        color: Vec3::new(0.1, 0.4, 0.1),
        ..SCENE
    }
    .paint();
    let weights = [[0.299, 0.587, 0.114], [0.2126, 0.7152, 0.0722]];
    for [red, green_share, blue] in weights {
        let gray = recolored(&green, |[r, g, b, alpha]| {
            let [r, g, b] = [r, g, b].map(f32::from);
            let gray = (red * r + green_share * g + blue * b).round() as u8;
            [gray, gray, gray, alpha]
        });
        assert_eq!(findings(&green, &gray), [Finding::Gray]);
        assert_ne!(findings(&gray, &green), [Finding::Gray]);
        let added = with_line(None);
        assert!(!findings(&added, &gray).contains(&Finding::Gray));
    }
}

#[test]
fn other_opacity_is_named() {
    let a = SCENE.paint();
    let b = recolored(&a, |[r, g, b, _]| [r, g, b, if r == 26 { 0 } else { 255 }]);
    let found = findings(&a, &b);
    assert!(
        matches!(found[0], Finding::Opacity { pixels } if pixels > 10_000),
        "{found:?}"
    );
}

#[test]
fn a_factor_in_brightness_is_measured() {
    let a = SCENE.paint();
    let darker = recolored(&a, |[r, g, b, alpha]| {
        let [r, g, b] = [r, g, b].map(|c| {
            if (r, g, b) == (26, 26, 26) {
                c
            } else {
                (f32::from(c) * 0.7).round() as u8
            }
        });
        [r, g, b, alpha]
    });
    let found = findings(&a, &darker);
    let [Finding::Brightness { factors }] = found[..] else {
        panic!("{found:?}");
    };
    assert!(
        factors.iter().all(|factor| (factor - 0.7).abs() < 0.01),
        "{factors:?}"
    );
    assert!(found[0].to_string().contains("0.70"));
}

#[test]
fn another_color_of_light_is_measured_by_channel() {
    let a = SCENE.paint();
    let tinted = recolored(&a, |[r, g, b, alpha]| match [r, g, b] {
        [26, 26, 26] => [r, g, b, alpha],
        _ => [r, g / 2, b, alpha],
    });
    let found = findings(&a, &tinted);
    let [Finding::Brightness { factors }] = found[..] else {
        panic!("{found:?}");
    };
    assert!(
        (factors[0] - 1.0).abs() < 1e-3 && (factors[1] - 0.5).abs() < 0.02,
        "{factors:?}"
    );
    assert!(found[0].to_string().contains("a different color"));
}

#[test]
fn one_encoding_too_many_is_named() {
    let a = SCENE.paint();
    let encode = |c: u8| {
        let linear = f32::from(c) / 255.0;
        (255.0 * (1.055 * linear.powf(1.0 / 2.4) - 0.055))
            .round()
            .max(0.0) as u8
    };
    let lighter = recolored(&a, |[r, g, b, alpha]| {
        [encode(r), encode(g), encode(b), alpha]
    });
    let gamma = |lighter| Finding::Gamma { lighter };
    assert!(findings(&a, &lighter).contains(&gamma(Which::B)));
    assert!(findings(&lighter, &a).contains(&gamma(Which::A)));
}

#[test]
fn a_missing_highlight_is_named_with_its_place() {
    for facets in [0, 24] {
        let lit = Scene { facets, ..SCENE };
        let dull = Scene {
            specular: 0.0,
            ..lit
        };
        for (a, b, missing) in [(lit, dull, Which::B), (dull, lit, Which::A)] {
            let found = findings(&a.paint(), &b.paint());
            let [Finding::Highlight { missing_in, area }] = found[..] else {
                panic!("{facets} facets: {found:?}");
            };
            assert_eq!(missing_in, missing);
            let inside = |start: u32, length: u32, at: u32| (start..start + length).contains(&at);
            // Halfway between the eye and the light the ball reflects the light to the eye.
            assert!(
                inside(area.x, area.width, 79) && inside(area.y, area.height, 42),
                "{area}"
            );
        }
    }
}

#[test]
fn another_highlight_is_not_taken_for_a_missing_one() {
    use HighlightChange::{Narrower, Stronger, Weaker, Wider};
    // So weak that nothing is cut off.
    let lit = Scene {
        specular: 0.3,
        ..SCENE
    };
    let half = Scene {
        specular: 0.15,
        ..lit
    };
    let wide = Scene {
        shininess: 7,
        ..lit
    };
    let cases = [
        (lit, half, Weaker),
        (half, lit, Stronger),
        (lit, wide, Wider),
        (wide, lit, Narrower),
    ];
    for (a, b, expected) in cases {
        let found = findings(&a.paint(), &b.paint());
        let [Finding::HighlightChanged { in_b, .. }] = found[..] else {
            panic!("{expected:?}: {found:?}");
        };
        assert_eq!(in_b, expected);
    }
}

#[test]
fn where_nothing_has_a_color_a_missing_highlight_may_be_a_weaker_one() {
    let lit = Scene {
        color: Vec3::splat(0.4),
        specular: 0.5,
        ..SCENE
    };
    let dull = Scene {
        specular: 0.0,
        ..lit
    };
    let less = findings(&lit.paint(), &dull.paint());
    assert!(
        matches!(
            less[..],
            [Finding::HighlightChanged {
                in_b: HighlightChange::Less,
                ..
            }]
        ),
        "{less:?}"
    );
    let more = findings(&dull.paint(), &lit.paint());
    assert!(
        matches!(
            more[..],
            [Finding::HighlightChanged {
                in_b: HighlightChange::More,
                ..
            }]
        ),
        "{more:?}"
    );
    assert!(!more[0].to_string().contains("missing"), "{}", more[0]);
}

#[test]
fn a_missing_thing_is_not_a_missing_highlight_even_if_it_is_bright() {
    let a = Scene {
        color: Vec3::splat(0.5),
        specular: 0.0,
        ..SCENE
    }
    .paint();
    let mut b = a.clone();
    for y in 45..55 {
        for x in 70..85 {
            let start = (4 * (y * WIDTH + x)) as usize;
            b.rgba[start..start + 4].copy_from_slice(&[250, 250, 250, 255]);
        }
    }
    for found in [findings(&a, &b), findings(&b, &a)] {
        assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
    }
}

#[test]
fn a_highlight_off_the_brightest_place_is_told_by_its_white_light_if_the_thing_has_a_color() {
    let light = |amount: f32, gray: u8| gray.saturating_add((80.0 * amount) as u8);
    let colored = Scene {
        specular: 0.0,
        ..SCENE
    };
    let found = findings(&spotted(&colored, light), &colored.paint());
    assert!(
        matches!(
            found[..],
            [Finding::Highlight {
                missing_in: Which::B,
                ..
            }]
        ),
        "{found:?}"
    );
    let gray = Scene {
        color: Vec3::splat(0.4),
        ..colored
    };
    let found = findings(&spotted(&gray, light), &gray.paint());
    assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
}

#[test]
fn light_of_a_color_is_no_highlight() {
    let scene = Scene {
        specular: 0.0,
        ..SCENE
    };
    let white = spotted(&scene, |amount, channel| {
        channel.saturating_add((80.0 * amount) as u8)
    });
    let (mut yellow, plain) = (white.clone(), scene.paint());
    for (lit, unlit) in yellow.rgba.chunks_mut(4).zip(plain.rgba.chunks(4)) {
        lit[2] = unlit[2];
    }
    let found = findings(&white, &plain);
    assert!(
        matches!(found[..], [Finding::Highlight { .. }]),
        "{found:?}"
    );
    let found = findings(&yellow, &plain);
    assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
}

#[test]
fn a_shadow_is_not_a_missing_highlight() {
    let shade = |amount: f32, channel: u8| (f32::from(channel) * (1.0 - 0.4 * amount)) as u8;
    for color in [SCENE.color, Vec3::splat(0.7)] {
        let scene = Scene {
            specular: 0.0,
            color,
            ..SCENE
        };
        let found = findings(&scene.paint(), &spotted(&scene, shade));
        assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
    }
}

/// The scene with its channels changed around a place on the ball off its highlight, the more the
/// nearer.
fn spotted(scene: &Scene, change: impl Fn(f32, u8) -> u8) -> Picture {
    let mut picture = scene.paint();
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let away = (x as f32 - 66.0).hypot(y as f32 - 58.0) / 12.0;
            let start = (4 * (y * WIDTH + x)) as usize;
            for channel in &mut picture.rgba[start..start + 3] {
                *channel = change((1.0 - away).max(0.0), *channel);
            }
        }
    }
    picture
}

#[test]
fn antialiasing_and_half_a_pixel_are_differences_along_edges() {
    let smooth = Scene {
        samples: 4,
        ..SCENE
    };
    let half = Scene {
        center: [70.5, 55.0],
        ..SCENE
    };
    let faceted = Scene {
        facets: 24,
        ..SCENE
    };
    let faceted_half = Scene { facets: 24, ..half };
    for (a, b) in [(SCENE, smooth), (SCENE, half), (faceted, faceted_half)] {
        let found = findings(&a.paint(), &b.paint());
        assert!(
            matches!(found[..], [Finding::Edges { share, .. }] if share > 0.9),
            "{found:?}"
        );
    }
}

/// The mean of the pixels at most `by` away.
fn blurred(picture: &Picture, by: i32) -> Picture {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let mean = |index: usize| {
        let (x, y) = (index as i32 % WIDTH as i32, index as i32 / WIDTH as i32);
        let near = (-by..=by).flat_map(|dy| (-by..=by).map(move |dx| (x + dx, y + dy)));
        let near: Vec<[u8; 4]> = near
            .map(|(x, y)| (x.clamp(0, WIDTH as i32 - 1), y.clamp(0, HEIGHT as i32 - 1)))
            .map(|(x, y)| pixels[(y * WIDTH as i32 + x) as usize])
            .collect();
        let sum = |channel: usize| near.iter().map(|pixel| u32::from(pixel[channel])).sum();
        [0, 1, 2, 3].map(|channel| {
            let sum: u32 = sum(channel);
            (sum / near.len() as u32) as u8
        })
    };
    Picture {
        rgba: (0..pixels.len()).flat_map(mean).collect(),
        ..*picture
    }
}

#[test]
fn a_blurred_picture_has_no_other_things_drawn() {
    let a = Scene {
        facets: 24,
        ..SCENE
    }
    .paint();
    let found = findings(&a, &blurred(&a, 2));
    assert!(matches!(found[..], [Finding::Detail { .. }]), "{found:?}");
}

#[test]
fn a_thin_line_moved_is_no_fine_detail_though_the_colors_even_out() {
    let line = |y: u32| {
        let mut picture = blank(26);
        for x in 16..112 {
            let start = (4 * (y * WIDTH + x)) as usize;
            picture.rgba[start..start + 3].copy_from_slice(&[255, 0, 0]);
        }
        for corner in [0, 70] {
            let start = (4 * (90 * WIDTH + corner)) as usize;
            picture.rgba[start..start + 160].fill(255);
        }
        picture
    };
    let found = findings(&line(20), &line(26));
    assert!(
        matches!(
            found[..],
            [Finding::Outline {
                only_a: 96,
                only_b: 96,
                ..
            }]
        ),
        "{found:?}"
    );
}

#[test]
fn a_missing_thin_line_is_not_a_difference_along_edges() {
    let a = SCENE.paint();
    let mut b = a.clone();
    for x in 20..140 {
        let start = (4 * (110 * WIDTH + x)) as usize;
        b.rgba[start..start + 4].copy_from_slice(&[255, 0, 0, 255]);
    }
    let found = findings(&a, &b);
    let [
        Finding::Outline {
            only_a: 0,
            only_b: 120,
            area_b,
            ..
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert_eq!(area_b, "20,110,120,1".parse().ok());
}

#[test]
fn an_outline_of_another_size_is_measured() {
    let alone = Scene {
        slab: false,
        ..SCENE
    };
    let larger = Scene {
        radius: 34.0 * 1.25,
        ..alone
    };
    let found = findings(&alone.paint(), &larger.paint());
    let [
        Finding::Placed {
            dx: 0,
            dy: 0,
            factor,
            degrees: 0.0,
            unexplained: 0.0,
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert!((factor - 1.25).abs() < 0.01, "{factor}");
    let only_the_ball = findings_for(Scene {
        radius: 34.0 * 1.1,
        ..SCENE
    });
    assert!(
        matches!(only_the_ball[..], [Finding::Outline { .. }]),
        "{only_the_ball:?}"
    );
}

/// A picture of a figure of head, body and one arm, moved, in another size and turned clockwise by
/// degrees about its middle.
fn figure(by: [f32; 2], factor: f32, degrees: f32) -> Picture {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x as f32, y as f32)));
    let drawn = |(x, y): (f32, f32)| {
        let (x, y) = (x - 70.0 - by[0], y - 60.0 - by[1]);
        let (x, y) = ((x * cos + y * sin) / factor, (y * cos - x * sin) / factor);
        let head = x.hypot(y + 22.0) < 8.0;
        let body = x.abs() < 10.0 && y.abs() < 18.0;
        head || body || (0.0..26.0).contains(&x) && (-14.0..-8.0).contains(&y)
    };
    Picture {
        width: WIDTH,
        height: HEIGHT,
        rgba: places
            .flat_map(|place| {
                if drawn(place) {
                    [90, 200, 90, 255]
                } else {
                    [26, 26, 26, 255]
                }
            })
            .collect(),
    }
}

#[test]
fn a_picture_by_another_camera_is_told_as_the_whole_figure_moved_scaled_and_turned() {
    let still = figure([0.0; 2], 1.0, 0.0);
    for (by, larger, turned) in [
        ([24.0, -9.0], 1.3, 0.0),
        ([-14.0, 6.0], 0.8, 12.0),
        ([3.0, 2.0], 1.1, -35.0),
    ] {
        let found = findings(&still, &figure(by, larger, turned));
        let [
            Finding::Placed {
                dx,
                dy,
                factor,
                degrees,
                unexplained: 0.0,
            },
        ] = found[..]
        else {
            panic!("{found:?}");
        };
        // The middle of what is drawn is a little off the point about which it turns.
        assert!(
            (dx as f32 - by[0]).abs() < 4.0 && (dy as f32 - by[1]).abs() < 4.0,
            "{found:?}"
        );
        assert!((factor - f64::from(larger)).abs() < 0.03, "{found:?}");
        assert!((degrees - f64::from(turned)).abs() < 1.0, "{found:?}");
        assert!(
            found[0].to_string().contains("another camera"),
            "{}",
            found[0]
        );
    }
    // Axes that only one of them has are no part of the figure.
    let (mut with_axis, row) = (figure([24.0, -9.0], 1.3, 0.0), 80 * WIDTH as usize);
    with_axis.rgba[4 * row..4 * (row + WIDTH as usize)]
        .as_chunks_mut::<4>()
        .0
        .fill([200, 0, 0, 255]);
    let found = findings(&still, &with_axis);
    assert!(
        matches!(
            found[..],
            [Finding::Placed {
                unexplained: 0.0,
                ..
            }]
        ),
        "{found:?}"
    );
    let placed = Finding::Placed {
        dx: 24,
        dy: -9,
        factor: 1.3,
        degrees: -12.0,
        unexplained: 0.25,
    };
    assert_eq!(
        placed.to_string(),
        "the whole figure is moved 24 pixels right and 9 pixels up, 1.300 times as large, turned 12.0 degrees counterclockwise in B, and 25 % of it differs even so: a camera in another direction, or another pose"
    );
}

#[test]
fn an_arm_in_another_place_is_no_other_camera() {
    let still = figure([0.0; 2], 1.0, 0.0);
    // The arm ten pixels lower.
    let lowered = rearranged(&still, |x, y| match (x, y) {
        (81.., 10..) => (x, y - 10),
        _ => (x, y),
    });
    assert!(lowered != still);
    let found = findings(&still, &lowered);
    assert!(
        matches!(
            found[..],
            [Finding::Outline {
                everywhere: false,
                ..
            }]
        ),
        "{found:?}"
    );
}

#[test]
fn an_outline_that_differs_in_every_part_of_the_figure_is_told_so() {
    let still = figure([0.0; 2], 1.0, 0.0);
    // Narrower and shorter, as seen from another side.
    let center =
        |at: u32, middle: i32, by: f32| (middle as f32 + (at as i32 - middle) as f32 * by) as u32;
    let narrow = rearranged(&still, |x, y| {
        (
            center(x, 76, 1.35).min(WIDTH - 1),
            center(y, 54, 1.12).min(HEIGHT - 1),
        )
    });
    let found = findings(&still, &narrow);
    let [
        Finding::Outline {
            everywhere: true, ..
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert!(
        found[0].to_string().contains("another camera"),
        "{}",
        found[0]
    );
}

#[test]
fn other_normals_and_another_light_are_differences_in_shading() {
    let flat = Scene { facets: 9, ..SCENE };
    let other_light = Scene {
        toward_light: Vec3::new(-0.48, 0.64, 0.6),
        ..SCENE
    };
    for scene in [flat, other_light] {
        let found = findings_for(scene);
        let [Finding::Shading { share, .. }] = found[..] else {
            panic!("{found:?}");
        };
        assert!(share > 0.05, "{share}");
    }
}

#[test]
fn differences_in_color_are_told_with_their_place_and_no_cause_that_is_not_known() {
    let a = SCENE.paint();
    let mut b = a.clone();
    for y in 50..60 {
        for x in 60..80 {
            let start = (4 * (y * WIDTH + x)) as usize;
            b.rgba[start..start + 4].copy_from_slice(&[30, 40, 200, 255]);
        }
    }
    let found = findings(&a, &b);
    let [Finding::Shading { area, .. }] = found[..] else {
        panic!("{found:?}");
    };
    assert_eq!(Some(area), "60,50,20,10".parse().ok());
    let text = found[0].to_string();
    assert!(
        text.starts_with("the outlines agree, but 5.")
            && text.ends_with(
                "within x 60 to 79, y 50 to 59: shape, depth or shading (normals, light, material)"
            ),
        "{text}"
    );
}

#[test]
fn differences_along_edges_are_told_with_their_place() {
    let mut half = SCENE.paint();
    let moved = Scene {
        center: [70.5, 55.0],
        ..SCENE
    };
    // Only the upper half is moved.
    let bytes = (4 * WIDTH * 55) as usize;
    half.rgba[..bytes].copy_from_slice(&moved.paint().rgba[..bytes]);
    let found = findings(&SCENE.paint(), &half);
    let [Finding::Edges { area, .. }] = found[..] else {
        panic!("{found:?}");
    };
    assert!(area.y >= 20 && area.y + area.height <= 55, "{area}");
    assert!(found[0].to_string().contains(&area.in_words()));
}

#[test]
fn a_thing_missing_does_not_hide_that_the_rest_is_shaded_otherwise() {
    let other = Scene {
        slab: false,
        toward_light: Vec3::new(-0.48, 0.64, 0.6),
        ..SCENE
    };
    let found = findings_for(other);
    let [
        Finding::Outline {
            only_a: 360,
            only_b: 0,
            ..
        },
        Finding::Shading {
            share,
            area,
            outlines_agree: false,
            outlines_cross: false,
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert!(share > 0.5 && area.y + area.height <= 90, "{share} {area}");
    let text = found[1].to_string();
    assert!(
        !text.contains("agree") && !text.contains("camera"),
        "{text}"
    );
}

#[test]
fn what_is_ignored_is_not_found_to_be_wrong() {
    let a = SCENE.paint();
    let b = Scene {
        slab: false,
        ..SCENE
    }
    .paint();
    let slab = "20,92,30,12".parse().unwrap();
    let compare = |ignore: &[_]| {
        let pair = Pair::new(&a, &b, ignore).unwrap();
        pair.compare(&PictureOptions::default())
    };
    let comparison = compare(&[slab]);
    assert!(comparison.passed);
    assert_eq!(comparison.ignored_pixels, 360);
    assert_eq!(comparison.judgment.findings, []);
    assert!(!compare(&[]).passed);
}

/// A line on a dark background, and a cube of one color that hides a part of it.
fn with_line(cube: Option<[u8; 3]>) -> Picture {
    let place = |index: usize| (index as u32 % WIDTH, index as u32 / WIDTH);
    let blank = blank(26);
    let (pixels, _) = blank.rgba.as_chunks::<4>();
    let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    let color = |index: usize| match place(index) {
        (40..=79, 40..=79) if cube.is_some() => opaque(cube.unwrap_or_default()),
        (30..=99, 60) => [255, 0, 0, 255],
        _ => pixels[index],
    };
    Picture {
        rgba: (0..pixels.len()).flat_map(color).collect(),
        ..blank
    }
}

#[test]
fn an_added_thing_is_no_other_color() {
    // The second is the background's color times 5, 3 and 2.
    for cube in [[235, 0, 0], [130, 78, 52]] {
        let (without, with) = (with_line(None), with_line(Some(cube)));
        let added = 40 * 40 - 40;
        for (a, b, expected) in [(&without, &with, (0, added)), (&with, &without, (added, 0))] {
            let found = findings(a, b);
            let [Finding::Outline { only_a, only_b, .. }] = found[..] else {
                panic!("{cube:?}: {found:?}");
            };
            assert_eq!((only_a, only_b), expected);
        }
    }
}

#[test]
fn a_few_times_darker_is_a_factor_but_many_times_is_not() {
    let gray = |gray: u8| {
        recolored(&with_line(Some([235, 0, 0])), |pixel| match pixel {
            [26, 26, 26, _] => [0, 0, 0, 255],
            _ => [gray, gray, gray, 255],
        })
    };
    let found = findings(&gray(240), &gray(60));
    assert!(
        matches!(found[..], [Finding::Brightness { .. }]),
        "{found:?}"
    );
    let found = findings(&gray(20), &gray(240));
    assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
}

#[test]
fn rounding_reads_as_such_and_names_the_few_pixels_that_are_more() {
    let a = SCENE.paint();
    let rounded = recolored(&a, |[r, g, b, alpha]| match [r, g, b] {
        [26, 26, 26] => [r, g, b, alpha],
        _ => [r, g + g % 3, b, alpha],
    });
    let text = |b: &Picture| {
        let found = findings(&a, b);
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].to_string()
    };
    assert_eq!(
        text(&rounded),
        "the pictures are the same except for rounding (at most 2 of 255)"
    );
    let with_spots = |picture: &Picture, spots: &[([u32; 2], u8)]| {
        let mut picture = picture.clone();
        for &([x, y], by) in spots {
            let at = (4 * (y * WIDTH + x)) as usize;
            picture.rgba[at] = a.rgba[at] ^ by;
        }
        picture
    };
    let far = [([5, 5], 128), ([6, 7], 128), ([7, 5], 128)];
    assert_eq!(
        text(&with_spots(&rounded, &far)),
        "the pictures are the same except for rounding (at most 2 of 255) and 3 pixels that differ by more than 8, within x 5 to 7, y 5 to 7"
    );
    assert_eq!(
        text(&with_spots(&rounded, &[([5, 5], 128), ([6, 5], 4)])),
        "the pictures are the same except for rounding (at most 2 of 255) and 2 pixels that differ by more, 1 of them by more than 8, within x 5 to 6, y 5"
    );
    assert_eq!(
        text(&with_spots(&a, &far[..1])),
        "the pictures are the same except for 1 pixel, within x 5, y 5"
    );
    let near = text(&with_spots(&rounded, &[([6, 5], 4)]));
    assert!(
        near.ends_with("and 1 pixel that differs by more, up to 8, within x 6, y 5"),
        "{near}"
    );
    // As many as a small thing has.
    let many: Vec<_> = (0..16).map(|x| ([x, 3], 128)).collect();
    assert!(!text(&with_spots(&a, &many)).contains("same"));
}

#[test]
fn noise_is_given_no_cause() {
    let noise = |seed: u32| {
        let mut state = seed;
        recolored(&SCENE.paint(), |_| [0, 0, 0, 255])
            .rgba
            .chunks(4)
            .flat_map(|_| {
                let mut next = || {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    (state >> 24) as u8
                };
                [next(), next(), next(), 255]
            })
            .collect::<Vec<u8>>()
    };
    let picture = |seed| Picture {
        width: WIDTH,
        height: HEIGHT,
        rgba: noise(seed),
    };
    assert_eq!(findings(&picture(1), &picture(2)), []);
}

#[test]
fn as_many_pixels_may_differ_as_are_allowed() {
    let a = SCENE.paint();
    let b = Scene {
        slab: false,
        ..SCENE
    }
    .paint();
    let passes = |allowed: &str, threshold| {
        let options = PictureOptions {
            allowed: allowed.parse().unwrap(),
            threshold,
        };
        Pair::new(&a, &b, &[]).unwrap().compare(&options).passed
    };
    assert!(passes("360", 0) && !passes("359", 0));
    assert!(passes("0", 153) && !passes("0", 152));
    let drawn = Pair::new(&a, &b, &[]).unwrap().differences(0).drawn_pixels as f64;
    let percent = 100.0 * 360.0 / drawn;
    assert!(passes(&format!("{}%", percent + 0.01), 0));
    assert!(!passes(&format!("{}%", percent - 0.01), 0));
}

/// Noise that goes on in all directions, seen from another place.
fn noise_from(dx: i32, dy: i32) -> Picture {
    let gray = |x: i32, y: i32| {
        let mixed = (x.wrapping_mul(7_919) ^ y.wrapping_mul(104_729)).wrapping_mul(1_103_515_245);
        (mixed >> 16) as u8
    };
    let places = (0..HEIGHT as i32).flat_map(|y| (0..WIDTH as i32).map(move |x| (x, y)));
    Picture {
        width: WIDTH,
        height: HEIGHT,
        rgba: places
            .flat_map(|(x, y)| [gray(x - dx, y - dy); 3].into_iter().chain([255]))
            .collect(),
    }
}

#[test]
fn without_a_background_movements_of_up_to_8_pixels_are_found() {
    for (dx, dy) in [(8, 0), (-8, 8), (0, -8), (3, -8)] {
        let found = findings(&noise_from(0, 0), &noise_from(dx, dy));
        assert_eq!(found, [Finding::Shifted { dx, dy }]);
    }
    assert_eq!(findings(&noise_from(0, 0), &noise_from(9, 0)), []);
}

#[test]
fn of_movements_that_explain_as_much_the_nearest_is_named() {
    // Every sixth column is the same.
    let repeated = |dx: u32| rearranged(&noise_from(0, 0), |x, y| ((x + 600 - dx) % 6, y));
    let found = |dx| findings(&repeated(0), &repeated(dx));
    assert_eq!(found(2), [Finding::Shifted { dx: 2, dy: 0 }]);
    assert_eq!(found(5), [Finding::Shifted { dx: -1, dy: 0 }]);
}

/// A gray square of 64×64 pixels in a dark picture, from which pixels differ.
fn square(change: impl Fn(u32, u32) -> i32) -> Picture {
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    Picture {
        width: WIDTH,
        height: HEIGHT,
        rgba: places
            .flat_map(|(x, y)| match (x, y) {
                (32..96, 32..96) => [(120 + change(x, y)) as u8; 3].into_iter().chain([255]),
                _ => [26; 3].into_iter().chain([255]),
            })
            .collect(),
    }
}

#[test]
fn a_dark_line_on_a_light_thing_is_no_difference_along_edges() {
    let line = square(|x, _| if x == 50 { -80 } else { 0 });
    let found = findings(&square(|_, _| 0), &line);
    assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
    let found = findings(&line, &square(|_, _| 0));
    assert!(matches!(found[..], [Finding::Shading { .. }]), "{found:?}");
}

#[test]
fn fine_detail_evens_out_within_blocks_of_16_pixels_and_not_of_more() {
    let stripes = |height: u32| {
        move |_, y: u32| {
            if (y / height).is_multiple_of(2) {
                12
            } else {
                -12
            }
        }
    };
    let found = |change: &dyn Fn(u32, u32) -> i32| findings(&square(|_, _| 0), &square(change));
    assert!(matches!(
        found(&stripes(1))[..],
        [Finding::Detail { max: 12, .. }]
    ));
    let coarse = found(&stripes(16));
    assert!(
        matches!(coarse[..], [Finding::Shading { .. }]),
        "{coarse:?}"
    );
}

#[test]
fn one_pixel_in_200_of_the_drawn_may_differ_by_more_than_rounding() {
    // 4096 pixels are drawn: 20 are no more than one in 200.
    let spots = |most: u32| move |x: u32, y: u32| if y == 40 && x < 32 + most { 5 } else { 0 };
    let found = |most| findings(&square(|_, _| 0), &square(spots(most)));
    assert!(matches!(
        found(20)[..],
        [Finding::NearlySame {
            others: 20,
            other_color: 0,
            rounding: 0,
            ..
        }]
    ));
    assert_eq!(found(21), []);
}

#[test]
fn shares_of_what_is_drawn_leave_out_the_masks() {
    let (a, b) = (square(|_, _| 0), {
        let block = |x: u32, y: u32| (64..96).contains(&x) && (32..64).contains(&y);
        square(move |x, y| match block(x, y) {
            true if (x + y) % 2 == 0 => 40,
            true => -60,
            false => 0,
        })
    });
    let share = |masks: &[&str]| {
        let masks: Vec<_> = masks.iter().map(|mask| mask.parse().unwrap()).collect();
        match Pair::new(&a, &b, &masks).unwrap().findings()[..] {
            [Finding::Shading { share, .. }] => share,
            ref other => panic!("{other:?}"),
        }
    };
    assert_eq!(share(&[]), 0.25);
    assert_eq!(share(&["32,32,32,64"]), 0.5);
    assert_eq!(share(&["64,32,32,16"]), 512.0 / 3584.0);
}

/// A picture of noise, another for each `seed`.
fn noise(side: u32, seed: u64) -> Picture {
    let mut state = seed;
    let mut channel = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 56) as u8
    };
    let pixels = (0..side * side).flat_map(|_| [channel(), channel(), channel(), 255]);
    Picture {
        width: side,
        height: side,
        rgba: pixels.collect(),
    }
}

#[test]
fn the_causes_of_noise_are_sought_in_few_times_the_work_of_counting_pixels() {
    let [a, b] = [1, 2].map(|seed| noise(800, seed));
    let pair = Pair::new(&a, &b, &[]).unwrap();
    let least = |run: &dyn Fn()| (0..3).map(|_| work(run).1).min().unwrap();
    let counting = least(&|| assert!(pair.differences(0).differing_pixels > 600_000));
    let seeking = least(&|| assert_eq!(pair.findings(), []));
    let times = seeking.as_secs_f64() / counting.as_secs_f64();
    assert!(times < 40.0, "{times} times: {counting:?} and {seeking:?}");
}

#[test]
fn the_camera_is_right_where_a_part_of_what_is_shaded_is_exactly_the_same() {
    // A shaded disk of which the right side has another color, and the left side such a gray, brighter by `more`.
    let disk = |right: [u8; 3], more: u8| {
        let pixels = (0..200 * 200).flat_map(|at| {
            let (x, y) = (at % 200, at / 200);
            let is_inside = (x - 100_i32).pow(2) + (y - 100_i32).pow(2) < 80 * 80;
            let gray = 80 + ((x + y) / 4) as u8 + more;
            let [r, g, b] = match (is_inside, x < 100) {
                (false, _) => [26; 3],
                (true, true) => [gray; 3],
                (true, false) => right,
            };
            [r, g, b, 255]
        });
        Picture {
            width: 200,
            height: 200,
            rgba: pixels.collect(),
        }
    };
    let a = disk([200, 40, 40], 0);
    let is_camera_right = |b: &Picture| {
        let judgment = Pair::new(&a, b, &[]).unwrap().judge();
        judgment.off.expect("something is off").is_camera_right
    };
    assert!(is_camera_right(&disk([40, 200, 40], 0)));
    // As alike as what is turned by a little.
    assert!(!is_camera_right(&disk([40, 200, 40], 1)));
}
