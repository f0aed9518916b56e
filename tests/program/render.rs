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
            "a.scene:1:",
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
                "render", "man.obj", "--ui", "--size", "639x400", "-o", "a.png",
            ],
            2,
            "at least 640x400",
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
