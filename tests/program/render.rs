//! `editor render`: pictures without a window.

use super::{editor_in, files_in, folder};
use std::path::Path;

/// The pixels of a picture that a run wrote.
fn picture(folder: &Path, name: &str) -> image::RgbaImage {
    image::open(folder.join(name)).unwrap().to_rgba8()
}

fn drawn(picture: &image::RgbaImage) -> usize {
    picture
        .pixels()
        .filter(|pixel| pixel.0 != [26, 26, 26, 255])
        .count()
}

#[test]
fn a_character_is_drawn_posed_and_fills_the_picture() {
    let folder = folder();
    for (name, pose) in [
        ("rest.png", &[][..]),
        ("bent.png", &["--pose", "bend.json"]),
    ] {
        let arguments = [&["render", "man.obj", "--fit", "-o", name], pose].concat();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(0), "{arguments:?}: {}", ran.err);
    }
    let (rest, bent) = (
        picture(folder.path(), "rest.png"),
        picture(folder.path(), "bent.png"),
    );
    assert_eq!(rest.dimensions(), (800, 600));
    assert!(drawn(&rest) > 10_000);
    assert_ne!(rest, bent);
}

#[test]
fn a_picture_shows_the_method_of_skinning_that_is_asked_for() {
    let folder = folder();
    std::fs::write(
        folder.path().join("twist.json"),
        "{\"joints\": {\"Upper\": [0, 150, 0]}}",
    )
    .unwrap();
    let seen = |method: &[&str]| {
        let arguments = ["render", "builtin:column", "--pose", "twist.json"];
        let arguments = [&arguments[..], &["-o", "out.png"], method].concat();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(0), "{arguments:?}: {}", ran.err);
        picture(folder.path(), "out.png")
    };
    let (own, linear) = (seen(&[]), seen(&["--skinning-method", "lbs"]));
    let dual = seen(&["--skinning-method", "dqs"]);
    assert_eq!(own, linear);
    // Linear blending pinches what is twisted, so that fewer pixels are covered.
    assert!(
        drawn(&dual) > drawn(&linear) + 500,
        "{} {}",
        drawn(&dual),
        drawn(&linear)
    );
}

#[test]
fn egl_and_osmesa_draw_the_same_picture_and_so_does_every_run() {
    let folder = folder();
    let mut files = Vec::new();
    for (name, gl) in [
        ("a.png", "egl"),
        ("b.png", "osmesa"),
        ("c.png", "egl"),
        ("d.png", "auto"),
    ] {
        let ran = editor_in(
            folder.path(),
            &[
                "render",
                "builtin:showcase",
                "--ui",
                "--samples",
                "4",
                "--gl",
                gl,
                "-o",
                name,
            ],
        );
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{gl}");
        files.push(std::fs::read(folder.path().join(name)).unwrap());
    }
    assert!(files.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn options_change_the_picture_and_defaults_are_what_the_contract_says() {
    let folder = folder();
    let render = |name: &str, options: &[&str]| {
        let arguments = [
            &["render", "builtin:robot", "--size", "200x150", "-o", name],
            options,
        ];
        let ran = editor_in(folder.path(), &arguments.concat());
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options:?}");
        picture(folder.path(), name)
    };
    let plain = render("plain.png", &[]);
    let said = "--display mesh --joints spheres --bones boxes --look course --axis off --samples 0 \
                --gl auto --camera 90,0,5 --curve on --surface shaded --control-points on";
    assert_eq!(
        plain,
        render("said.png", &said.split_whitespace().collect::<Vec<_>>())
    );
    for options in [
        &["--display", "skeleton"][..],
        &["--display", "both"],
        &["--display", "skeleton", "--joints", "points"],
        &["--display", "skeleton", "--bones", "lines"],
        &["--look", "studio"],
        &["--axis", "on"],
        &["--samples", "4"],
        &["--camera=-30,10,5"],
        &["--camera", "-30,10,5,0.1,0,0"],
        &["--view", "-x"],
        &["--view", "+y"],
        &["--fit"],
    ] {
        let changed = render("changed.png", options);
        assert_ne!(plain, changed, "{options:?}");
        assert!(drawn(&changed) > 100, "{options:?}");
    }
}

#[test]
fn the_axes_are_as_the_scene_has_them_unless_they_are_asked_for() {
    let folder = folder();
    let scene = |axis: &str| {
        let text = format!(
            r#"{{ "format": "editor-scene", "version": 1, "view": {{ "axis": {axis} }},
                 "shapes": [{{ "source": "builtin:robot" }}] }}"#
        );
        std::fs::write(folder.path().join("a.scene"), text).unwrap();
    };
    let render = |options: &[&str]| {
        let arguments = [
            &["render", "a.scene", "--size", "200x150", "-o", "a.png"],
            options,
        ];
        let ran = editor_in(folder.path(), &arguments.concat());
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options:?}");
        picture(folder.path(), "a.png")
    };
    scene("true");
    let (with, without) = (render(&[]), render(&["--axis", "off"]));
    assert_ne!(with, without);
    scene("false");
    assert_eq!(render(&[]), without);
    assert_eq!(render(&["--axis", "on"]), with);
}

#[test]
fn both_ways_of_skinning_draw_the_same_character() {
    let folder = folder();
    let [cpu, gpu] = ["cpu", "gpu"].map(|skinning| {
        let name = format!("{skinning}.png");
        let ran = editor_in(
            folder.path(),
            &[
                "render",
                "builtin:adult",
                "--pose",
                "builtin:adult-walk",
                "--skinning",
                skinning,
                "-o",
                &name,
            ],
        );
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{skinning}");
        picture(folder.path(), &name)
    });
    let different = cpu.pixels().zip(gpu.pixels()).filter(|(a, b)| a != b);
    assert!(drawn(&cpu) > 10_000);
    assert!(different.count() < 50);
}

#[test]
fn a_bone_in_the_hand_can_be_shown_with_the_panels() {
    let folder = folder();
    let render = |name: &str, options: &str| {
        let line = format!("render builtin:mannequin-5 --ui --size 1000x700 -o {name} {options}");
        let ran = editor_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options}");
        picture(folder.path(), name)
    };
    let cyan = |picture: &image::RgbaImage| {
        let is_cyan = |p: &&image::Rgba<u8>| p[0] < 60 && p[1] > 200 && p[2] > 230;
        picture.pixels().filter(is_cyan).count()
    };
    let posing = render("a.png", "--tool pose");
    let held = render("b.png", "--tool pose --drag 240,280,150,180");
    assert_eq!(cyan(&posing), 0);
    assert!(cyan(&held) > 100, "{}", cyan(&held));
    // The forearm went up, to the left of where any of it was.
    let arm = |picture: &image::RgbaImage| {
        let red = |x, y| picture.get_pixel(x, y)[0] > 150;
        (140..230)
            .filter(|&x| (120..230).any(|y| red(x, y)))
            .count()
    };
    assert!(arm(&posing) == 0 && arm(&held) > 40, "{}", arm(&held));
    // A picture that is kept has its samples, whatever is in the hand.
    let [smooth, rough] = [4, 0].map(|samples| {
        let drag = "--tool pose --drag 240,280,150,180";
        render("c.png", &format!("{drag} --samples {samples}"))
    });
    let different = smooth.pixels().zip(rough.pixels()).filter(|(a, b)| a != b);
    assert!(different.count() > 1000);
}

#[test]
fn fit_leaves_a_margin_and_no_more_in_wide_pictures_and_in_tall_ones() {
    let folder = folder();
    for size in ["600x150", "150x600"] {
        let line = format!("render box.obj --view +z --fit --size {size} -o fit.png");
        let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let picture = picture(folder.path(), "fit.png");
        let is_drawn = |x, y| picture.get_pixel(x, y).0 != [26, 26, 26, 255];
        let (width, height) = picture.dimensions();
        let columns = (0..width).filter(|&x| (0..height).any(|y| is_drawn(x, y)));
        let rows = (0..height).filter(|&y| (0..width).any(|x| is_drawn(x, y)));
        for count in [columns.count(), rows.count()] {
            assert!((75..150).contains(&count), "{size}: {count} of 150 pixels");
        }
    }
}

#[test]
fn every_tool_shows_itself_and_a_drag_to_where_it_began_is_a_click() {
    let folder = folder();
    let render = |options: &str| {
        let line = format!("render box.obj --ui --size 1000x640 -o a.png {options}");
        let ran = editor_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options}");
        picture(folder.path(), "a.png")
    };
    let tools = ["select", "pose", "move", "ik"].map(|tool| render(&format!("--tool {tool}")));
    for (index, tool) in tools.iter().enumerate() {
        assert!(!tools[..index].contains(tool), "tool {index}");
    }
    // Nothing is there, so a click selects nothing, and the panel of the shape goes away.
    let clicked = render("--drag 330,120,330,120");
    let pairs = clicked.pixels().zip(tools[0].pixels());
    let differing = pairs.filter(|(a, b)| a != b).count();
    assert!(differing > 5_000, "{differing} pixels");
}

#[test]
fn keys_are_pressed_before_the_mouse_and_clicks_come_one_after_the_other() {
    let folder = folder();
    let render = |options: &str| {
        let line = format!("render builtin:adult --ui --size 1000x700 -o a.png {options}");
        let ran = editor_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options}");
        picture(folder.path(), "a.png")
    };
    let differing = |a: &image::RgbaImage, b: &image::RgbaImage| {
        let pairs = a.pixels().zip(b.pixels());
        pairs.filter(|(a, b)| a != b).count()
    };
    let plain = render("");
    assert_eq!(
        differing(&plain, &render("--press K --press K")),
        0,
        "opened and closed"
    );
    let opened = render("--press K");
    assert!(differing(&plain, &opened) > 50_000);
    // Its other topic, and back.
    let (stack, formula) = ("--drag 120,420,120,420", "--drag 40,420,40,420");
    let other = render(&format!("--press K {stack}"));
    assert!(differing(&opened, &other) > 5_000);
    let back = render(&format!("--press K {stack} {formula} --drag 1,690,1,690"));
    let again = render(&format!("--press K {formula} --drag 1,690,1,690"));
    assert_eq!(differing(&back, &again), 0);
}

#[test]
fn pictures_are_written_as_png_jpeg_and_gif() {
    let folder = folder();
    for name in ["a.png", "a.jpg", "a.gif"] {
        let ran = editor_in(
            folder.path(),
            &["render", "box.obj", "--size", "64x48", "-o", name],
        );
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{name}");
        assert_eq!(picture(folder.path(), name).dimensions(), (64, 48));
    }
}

#[test]
fn curves_are_drawn_with_frames_and_wireframes() {
    let folder = folder();
    let swp = "circ profile 12 0.5\ncirc sweep 24 1.5\ngcyl ring profile sweep\n";
    std::fs::write(folder.path().join("ring.swp"), swp).unwrap();
    let mut pictures = Vec::new();
    for options in [
        &["--curve", "off", "--control-points", "off"][..],
        &["--surface", "wireframe"],
        &["--surface", "off", "--curve", "frames"],
        &[
            "--no-frame-closing",
            "--surface",
            "off",
            "--curve",
            "off",
            "--control-points",
            "off",
        ],
    ] {
        let arguments = [&["render", "ring.swp", "-o", "a.png"], options].concat();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options:?}");
        pictures.push(picture(folder.path(), "a.png"));
    }
    assert!(pictures.windows(2).all(|pair| pair[0] != pair[1]));
    assert_eq!(drawn(&pictures[3]), 0);
}

#[test]
fn what_cannot_be_drawn_is_told_once_and_leaves_no_file() {
    let folder = folder();
    let before = files_in(folder.path());
    for (arguments, code, told) in [
        (&["render", "bad.obj", "-o", "a.png"][..], 1, "bad.obj:2:"),
        (
            &["render", "none.obj", "-o", "a.png"],
            1,
            "none.obj: there is no such file",
        ),
        (&["render", "man.obj", "-o", "a.bmp"], 2, "a.bmp: expected"),
        (
            &["render", "man.obj", "-o", "no/a.png"],
            1,
            "there is no folder",
        ),
        (
            &["render", "man.obj", "--size", "99999x99999", "-o", "a.png"],
            1,
            "99999",
        ),
        (
            &["render", "man.obj", "--samples", "7000", "-o", "a.png"],
            2,
            "from 0 to 64",
        ),
        (
            &["render", "man.obj", "--pose", "a.scene", "-o", "a.png"],
            1,
            "a.scene: expected a pose, found a scene",
        ),
        (
            &["render", "box.obj", "--pose", "bend.json", "-o", "a.png"],
            1,
            "bend.json",
        ),
        (
            &["render", "man.obj", "--size", "800", "-o", "a.png"],
            2,
            "WIDTHxHEIGHT",
        ),
        (
            &["render", "man.obj", "--camera", "1,2", "-o", "a.png"],
            2,
            "THETA,PHI,RADIUS",
        ),
        (
            &["render", "man.obj", "--camera", "1,2,NaN", "-o", "a.png"],
            2,
            "THETA,PHI,RADIUS",
        ),
        (
            &["render", "man.obj", "--view", "up", "-o", "a.png"],
            2,
            "+x, -x",
        ),
        (
            &["render", "man.obj", "--axis", "maybe", "-o", "a.png"],
            2,
            "on or off",
        ),
        (&["render", "man.obj"], 2, "--output"),
        (
            &["render", "man.obj", "--samples", "-1", "-o", "a.png"],
            2,
            "a whole number of samples from 0 to 64",
        ),
        (
            &[
                "render", "man.obj", "--ui", "--size", "419x400", "-o", "a.png",
            ],
            2,
            "at least 420x400",
        ),
        (
            &["render", "man.obj", "--drag", "1,2,3,4", "-o", "a.png"],
            2,
            "--ui",
        ),
        (
            &[
                "render", "man.obj", "--ui", "--drag", "1,2,3", "-o", "a.png",
            ],
            2,
            "X,Y,Z,W",
        ),
        (
            &["render", "man.obj", "--ui", "--press", "Any", "-o", "a.png"],
            2,
            "the name of a key",
        ),
    ] {
        let ran = editor_in(folder.path(), arguments);
        assert_eq!(
            (ran.code, &*ran.out),
            (Some(code), ""),
            "{arguments:?}: {}",
            ran.err
        );
        let errors: Vec<_> = ran
            .err
            .lines()
            .filter(|l| l.starts_with("error: "))
            .collect();
        assert_eq!(errors.len(), 1, "{arguments:?}: {}", ran.err);
        assert!(ran.err.contains(told), "{arguments:?}: {}", ran.err);
        assert_eq!(files_in(folder.path()), before, "{arguments:?}");
    }
}

/// What a run that must succeed without a word wrote.
fn drawn_as(folder: &Path, line: &str, name: &str) -> image::RgbaImage {
    let ran = editor_in(folder, &line.split(' ').collect::<Vec<_>>());
    assert_eq!(
        (ran.code, &*ran.out, &*ran.err),
        (Some(0), "", ""),
        "{line}"
    );
    picture(folder, name)
}

#[test]
fn a_picture_wider_than_any_driver_draws_is_put_together_the_same_every_time() {
    let folder = folder();
    let size = "render builtin:robot --size 40000x30";
    let wide = drawn_as(folder.path(), &format!("{size} -o a.png"), "a.png");
    assert_eq!(wide.dimensions(), (40_000, 30));
    let columns = wide
        .enumerate_pixels()
        .filter(|(_, _, pixel)| pixel.0 != [26, 26, 26, 255]);
    let columns: Vec<u32> = columns.map(|(x, _, _)| x).collect();
    let (first, last) = (columns.iter().min().unwrap(), columns.iter().max().unwrap());
    assert!((19_950..20_050).contains(first) && (19_950..20_050).contains(last));
    drawn_as(folder.path(), &format!("{size} -o b.png"), "b.png");
    let bytes = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(bytes("a.png") == bytes("b.png"));
}

#[test]
fn a_transparent_picture_has_no_background() {
    let folder = folder();
    let line = "render box.obj --view +z --size 64x64 --transparent";
    for look in ["course", "studio", "mannequin"] {
        let line = format!("{line} --look {look} --camera=90,0,3,0.5,0.5,0 -o {look}.png");
        let line = line.replace(" --view +z", "");
        let drawn = drawn_as(folder.path(), &line, &format!("{look}.png"));
        assert_eq!(drawn.get_pixel(0, 0).0, [0, 0, 0, 0], "{look}");
        assert_eq!(drawn.get_pixel(32, 32).0[3], 255, "{look}");
    }
}

/// Frames of a GIF, each with its time in milliseconds.
fn frames(path: &Path) -> Vec<(image::RgbaImage, u32)> {
    use image::AnimationDecoder;
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let decoder = image::codecs::gif::GifDecoder::new(file).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    let frame = |frame: image::Frame| {
        let (time, unit) = frame.delay().numer_denom_ms();
        (frame.into_buffer(), time / unit)
    };
    frames.into_iter().map(frame).collect()
}

#[test]
fn a_turntable_is_a_gif_without_end_of_the_views_all_around() {
    let folder = folder();
    let line = "render builtin:robot --size 80x60 --camera=90,0,5 --turntable 4 -o";
    for name in ["a.gif", "b.gif"] {
        let ran = editor_in(
            folder.path(),
            &format!("{line} {name}").split(' ').collect::<Vec<_>>(),
        );
        assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(0), "", ""));
    }
    let bytes = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(bytes("a.gif") == bytes("b.gif"));
    // The extension of Netscape with a count of 0, for ever.
    let forever = b"NETSCAPE2.0\x03\x01\x00\x00\x00";
    assert!(
        bytes("a.gif")
            .windows(forever.len())
            .any(|found| found == forever)
    );
    let frames = frames(&folder.path().join("a.gif"));
    assert_eq!(frames.len(), 4);
    assert!(frames.iter().all(|(_, time)| *time == 500));
    for ((frame, _), theta) in frames.iter().zip([90, 180, 270, 360]) {
        let seen = format!("--size 80x60 --look course --camera={theta},0,5");
        let line = format!("render builtin:robot {seen} -o one.gif");
        let one = drawn_as(folder.path(), &line, "one.gif");
        assert!(*frame == one, "{theta}");
    }
    assert!(frames[0].0 != frames[1].0);
}

#[test]
fn a_turntable_is_numbered_pictures_where_the_name_has_a_place_for_numbers() {
    let folder = folder();
    let before = files_in(folder.path()).len();
    let line = "render builtin:dog --view +z --size 40x64 --fit --transparent --turntable 3 -o turn-%02d.png";
    let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let names = ["turn-01.png", "turn-02.png", "turn-03.png"];
    assert_eq!(files_in(folder.path()).len(), before + names.len());
    for name in names {
        let drawn = picture(folder.path(), name);
        let solid = drawn.enumerate_pixels().filter(|(_, _, p)| p.0[3] > 0);
        let solid: Vec<(u32, u32)> = solid.map(|(x, y, _)| (x, y)).collect();
        assert!(solid.len() > 50, "{name}");
        let on_edge = |&(x, y): &(u32, u32)| x == 0 || x == 39 || y == 0 || y == 63;
        assert!(!solid.iter().any(on_edge), "{name} is cut off");
    }
}

#[test]
fn what_a_large_or_turning_or_transparent_picture_cannot_be_is_said_before_it_is_drawn() {
    let folder = folder();
    let before = files_in(folder.path());
    for (options, code, error) in [
        (
            "--size 30000x10000 -o a.png",
            1,
            "a.png: expected a picture of at most 268435456 pixels, as of 16384x16384, found 30000x10000",
        ),
        (
            "--size 70000x10 -o a.jpg",
            1,
            "a.jpg: expected at most 65535 pixels a side of a JPEG or GIF, found 70000x10: a PNG may have more",
        ),
        (
            "--transparent -o a.jpg",
            2,
            "a.jpg: expected a name that ends in .png with --transparent",
        ),
        (
            "--turntable 8 -o a.png",
            2,
            "a.png: expected a name that ends in .gif with --turntable, or has a place for numbers, such as OUT-%03d.png",
        ),
        ("--turntable 8 --ui -o a.gif", 2, "--ui"),
        ("--transparent --ui -o a.png", 2, "--ui"),
        (
            "--turntable 1 -o a.gif",
            2,
            "expected a whole number of frames from 2 to 720, found 1",
        ),
        (
            "--turntable -3 -o a.gif",
            2,
            "expected a whole number of frames from 2 to 720, found -3",
        ),
        (
            "--turntable 4 -o none/a.gif",
            1,
            "none/a.gif: there is no folder none",
        ),
    ] {
        let line = format!("render man.obj {options}");
        let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        assert_eq!(
            (ran.code, &*ran.out),
            (Some(code), ""),
            "{options}: {}",
            ran.err
        );
        assert!(ran.err.contains(error), "{options}: {}", ran.err);
    }
    assert_eq!(files_in(folder.path()), before);
}

#[test]
fn characters_are_colored_by_numbers_and_only_where_that_is_asked_for() {
    let folder = folder();
    let render = |name: &str, options: &[&str]| {
        let arguments = [&["render", "man.obj", "--fit", "-o", name], options].concat();
        editor_in(folder.path(), &arguments)
    };
    let mut pictures = Vec::new();
    for (name, options) in [
        ("plain.png", &[][..]),
        ("weight.png", &["--colors", "weight:Tip"]),
        ("influences.png", &["--colors", "influences"]),
        ("lost.png", &["--colors", "lost-at-four"]),
    ] {
        let ran = render(name, options);
        assert_eq!(ran.code, Some(0), "{options:?}: {}", ran.err);
        pictures.push(picture(folder.path(), name));
    }
    let outlines = pictures.iter().map(drawn).collect::<Vec<_>>();
    assert!(
        outlines
            .iter()
            .all(|count| count.abs_diff(outlines[0]) * 100 < outlines[0])
    );
    for (index, one) in pictures.iter().enumerate() {
        assert!(
            pictures[..index].iter().all(|other| other != one),
            "{index}"
        );
    }
    for (colors, told) in [
        (
            "weight:Tap",
            "expected the name or index of a joint, such as “Tip”",
        ),
        (
            "weight:",
            "expected weight:JOINT, influences or lost-at-four",
        ),
        (
            "rainbow",
            "expected weight:JOINT, influences or lost-at-four",
        ),
    ] {
        let ran = render("none.png", &["--colors", colors]);
        assert_ne!(ran.code, Some(0), "{colors}");
        assert!(ran.err.contains(told), "{}", ran.err);
        assert!(!folder.path().join("none.png").exists());
    }
}

#[test]
fn a_character_in_an_archive_without_a_scene_is_drawn_as_the_character_itself() {
    let folder = folder();
    let entry = |name: &str| {
        (
            name.into(),
            std::fs::read(folder.path().join(name)).unwrap(),
        )
    };
    let entries = ["man.obj", "man.skel", "man.attach"].map(entry);
    let zip = editor_core::io::to_zip(&entries).unwrap();
    std::fs::create_dir(folder.path().join("mail")).unwrap();
    std::fs::write(folder.path().join("mail/man.zip"), zip).unwrap();
    for (file, name) in [("man.obj", "own.png"), ("mail/man.zip", "packed.png")] {
        let arguments = ["render", file, "--fit", "--pose", "bend.json", "-o", name];
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
    }
    let [own, packed] = ["own.png", "packed.png"].map(|name| picture(folder.path(), name));
    assert!(drawn(&own) > 1000 && own == packed);
}

#[test]
fn a_picture_that_is_dark_since_the_course_s_light_is_behind_says_so_unless_that_look_is_asked_for()
{
    let folder = folder();
    for (options, is_told) in [
        (&["--view", "-z"][..], true),
        (&["--view", "+x"], false),
        (&["--view", "-z", "--look", "course"], false),
        (&["--view", "-z", "--look", "studio"], false),
    ] {
        let arguments = [&["render", "builtin:robot", "-o", "a.png"], options].concat();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(0), "{options:?}: {}", ran.err);
        let told = "note: the Course look, which is the default, has one light, from +z";
        assert_eq!(
            ran.err.starts_with(told),
            is_told,
            "{options:?}: {}",
            ran.err
        );
        assert_eq!(ran.err.is_empty(), !is_told, "{options:?}");
    }
}
