//! The robot's hips, torso, neck and head.
use super::super::solids::{aimed, ball, moved, rounded_box, shaped, turned};
use super::{Assembly, NECK};
use glam::DVec3;

pub fn trunk(robot: &mut Assembly) {
    let hips = shaped(rounded_box(DVec3::new(0.150, 0.062, 0.098), 0.03, 1), |p| {
        let narrow = 1.0 + 2.4 * p.y;
        DVec3::new(p.x * narrow, p.y, p.z * narrow)
    });
    robot.add("Hips", moved(hips, DVec3::new(0.0, -0.060, 0.0)));
    robot.add(
        "Hips",
        moved(
            rounded_box(DVec3::new(0.034, 0.026, 0.012), 0.008, 1),
            DVec3::new(0.0, -0.045, 0.098),
        ),
    );
    let ribs = [
        (0.0, -0.06),
        (0.088, -0.06),
        (0.096, -0.045),
        (0.082, -0.030),
        (0.096, -0.015),
        (0.082, 0.0),
        (0.096, 0.015),
        (0.082, 0.030),
        (0.090, 0.045),
        (0.0, 0.06),
    ];
    robot.add("Torso", moved(turned(&ribs, 16), DVec3::Y * 0.045));
    let chest = shaped(
        rounded_box(DVec3::new(0.195, 0.165, 0.125), 0.055, 2),
        |p| {
            // Broad shoulders, a narrower waist, and a breast that bows forward.
            let wide = 1.0 + 1.05 * p.y;
            DVec3::new(p.x * wide, p.y, p.z * (1.0 + 0.45 * p.y) + 0.10 * p.y)
        },
    );
    robot.add("Torso", moved(chest, DVec3::new(0.0, 0.245, 0.0)));
    let plate = shaped(
        rounded_box(DVec3::new(0.128, 0.085, 0.018), 0.012, 1),
        |p| {
            DVec3::new(
                p.x * (1.0 + 1.2 * p.y),
                p.y,
                p.z + 0.22 * p.y - 0.55 * p.x * p.x,
            )
        },
    );
    robot.add("Torso", moved(plate, DVec3::new(0.0, 0.285, 0.142)));
    let lamp = [
        (0.0, -0.02),
        (0.046, -0.02),
        (0.046, 0.006),
        (0.040, 0.013),
        (0.034, 0.013),
        (0.031, 0.006),
        (0.024, 0.013),
        (0.012, 0.018),
        (0.0, 0.019),
    ];
    robot.add(
        "Torso",
        aimed(
            turned(&lamp, 16),
            DVec3::new(0.0, -0.1, 1.0),
            DVec3::new(0.0, 0.285, 0.160),
        ),
    );
    for x in [-1.0, 0.0, 1.0] {
        let vent = rounded_box(DVec3::new(0.024, 0.007, 0.010), 0.005, 1);
        robot.add("Torso", moved(vent, DVec3::new(0.062 * x, 0.165, 0.110)));
    }
    let pack = shaped(
        rounded_box(DVec3::new(0.125, 0.120, 0.050), 0.025, 1),
        |p| DVec3::new(p.x * (1.0 + 0.8 * p.y), p.y, p.z),
    );
    robot.add("Torso", moved(pack, DVec3::new(0.0, 0.255, -0.140)));
    for side in [-1.0, 1.0] {
        let tank = turned(
            &[
                (0.0, -0.125),
                (0.022, -0.118),
                (0.036, -0.095),
                (0.036, 0.095),
                (0.022, 0.118),
                (0.0, 0.125),
            ],
            12,
        );
        robot.add(
            "Torso",
            moved(tank, DVec3::new(0.058 * side, 0.255, -0.195)),
        );
    }
}

pub fn head(robot: &mut Assembly) {
    let bellows = [
        (0.0, -0.04),
        (0.058, -0.04),
        (0.058, -0.025),
        (0.046, -0.012),
        (0.058, 0.0),
        (0.046, 0.012),
        (0.058, 0.025),
        (0.046, 0.04),
        (0.046, 0.06),
        (0.0, 0.06),
    ];
    robot.add("Neck", moved(turned(&bellows, 14), NECK + DVec3::Y * 0.01));
    let center = DVec3::new(0.0, 0.605, 0.010);
    let skull = shaped(
        rounded_box(DVec3::new(0.142, 0.122, 0.125), 0.065, 2),
        |p| DVec3::new(p.x * (1.0 + 0.35 * p.y), p.y, p.z * (1.0 + 0.25 * p.y)),
    );
    robot.add("Head", moved(skull, center));
    // The visor bends round the face; two lenses look out of it.
    let visor = shaped(
        rounded_box(DVec3::new(0.130, 0.047, 0.026), 0.020, 3),
        |p| DVec3::new(p.x, p.y, p.z - 1.2 * p.x * p.x),
    );
    robot.add("Head", moved(visor, center + DVec3::new(0.0, 0.022, 0.122)));
    let lens = [
        (0.0, -0.02),
        (0.033, -0.02),
        (0.033, 0.004),
        (0.029, 0.009),
        (0.025, 0.009),
        (0.023, 0.003),
        (0.014, 0.011),
        (0.0, 0.014),
    ];
    for side in [-1.0, 1.0] {
        robot.add(
            "Head",
            aimed(
                turned(&lens, 14),
                DVec3::new(0.14 * side, 0.0, 1.0),
                center + DVec3::new(0.054 * side, 0.024, 0.147),
            ),
        );
        let ear = [
            (0.0, -0.03),
            (0.050, -0.03),
            (0.050, 0.004),
            (0.042, 0.014),
            (0.026, 0.014),
            (0.022, 0.026),
            (0.0, 0.026),
        ];
        robot.add(
            "Head",
            aimed(
                turned(&ear, 14),
                DVec3::X * side,
                center + DVec3::new(0.142 * side, 0.010, 0.0),
            ),
        );
    }
    for i in -1..=1 {
        let slot = rounded_box(DVec3::new(0.008, 0.016, 0.010), 0.004, 1);
        robot.add(
            "Head",
            moved(
                slot,
                center + DVec3::new(0.026 * f64::from(i), -0.062, 0.112),
            ),
        );
    }
    let crest = rounded_box(DVec3::new(0.022, 0.016, 0.085), 0.012, 1);
    robot.add(
        "Head",
        moved(crest, center + DVec3::new(0.0, 0.120, -0.005)),
    );
    let foot = DVec3::new(0.0, 0.735, -0.02);
    let rod = [
        (0.0, -0.015),
        (0.022, -0.015),
        (0.022, 0.0),
        (0.012, 0.012),
        (0.006, 0.016),
        (0.005, 0.105),
        (0.0, 0.11),
    ];
    robot.add("Antenna", moved(turned(&rod, 10), foot));
    robot.add("Antenna", moved(ball(0.023, 12), foot + DVec3::Y * 0.122));
}
