//! What the humanoid wears: every part of the body's surface belongs to the field that is lowest
//! there.
use super::super::super::adult::{body, face, hair, hand, jacket, shoe, trousers};
use super::super::super::field::{chain, ellipsoid};
use super::super::model::{Material, plain};
use super::super::paint::Painted;
use glam::DVec3;

const TRIM: usize = 1;
const ZIP: usize = 2;
const TROUSERS: usize = 3;
const TURN_UP: usize = 4;
const SHOE: usize = 5;
const SOLE: usize = 6;
const SKIN: usize = 7;
const HAIR: usize = 8;
const LIPS: usize = 9;
const EYE_WHITE: usize = 10;
const IRIS: usize = 11;
const PUPIL: usize = 12;

/// Where nothing is painted there is the jacket, material 0.
pub fn materials() -> Vec<Material> {
    vec![
        plain("Jacket", [0.62, 0.16, 0.15]),
        plain("Trim", [0.19, 0.20, 0.24]),
        plain("Zip", [0.72, 0.73, 0.75]),
        plain("Trousers", [0.17, 0.25, 0.40]),
        plain("Turn-up", [0.36, 0.46, 0.62]),
        plain("Shoe", [0.46, 0.28, 0.15]),
        plain("Sole", [0.90, 0.87, 0.80]),
        plain("Skin", [0.86, 0.63, 0.50]),
        plain("Hair", [0.22, 0.12, 0.07]),
        plain("Lips", [0.78, 0.47, 0.42]),
        plain("Eye white", [0.95, 0.95, 0.93]),
        plain("Iris", [0.22, 0.42, 0.52]),
        plain("Pupil", [0.04, 0.04, 0.05]),
    ]
}

/// Whether nothing of a kind is at a place: a value that is surely outside.
const NOWHERE: f64 = 1.0;

fn left(p: DVec3) -> DVec3 {
    DVec3::new(p.x.abs(), p.y, p.z)
}

fn cloth(p: DVec3) -> (f64, f64) {
    let (near, far) = (left(p), DVec3::new(-p.x.abs(), p.y, p.z));
    (jacket::surface(near, far), trousers::surface(near, far))
}

pub fn paint(body: &mut Painted) {
    lower_half(body);
    jacket_trim(body);
    skin(body);
    head(body);
}

fn lower_half(body: &mut Painted) {
    body.paint(TROUSERS, &|p| {
        let (jacket, trousers) = cloth(p);
        trousers - jacket
    });
    body.paint(TURN_UP, &|p| {
        if p.y > 0.3 {
            NOWHERE
        } else {
            p.y - trousers::TURN_UP
        }
    });
    let on_shoe = |p: DVec3| {
        if p.y > 0.3 {
            NOWHERE
        } else {
            shoe::surface(left(p)) - cloth(p).1
        }
    };
    body.paint(SHOE, &on_shoe);
    body.paint(SOLE, &|p| on_shoe(p).max(p.y - 0.031));
}

fn jacket_trim(body: &mut Painted) {
    let on_jacket = |p: DVec3| {
        let (jacket, trousers) = cloth(p);
        jacket - trousers
    };
    body.paint(ZIP, &|p| {
        let strip = (p.x.abs() - 0.0045).max(-p.z);
        strip
            .max(on_jacket(p))
            .max(jacket::RIB - p.y)
            .max(p.y - 1.56)
    });
    body.paint(TRIM, &|p| {
        if p.x.abs() > 0.25 {
            NOWHERE
        } else {
            on_jacket(p).max(p.y - jacket::RIB)
        }
    });
    body.paint(TRIM, &|p| {
        let near = left(p);
        let axis = (body::WRIST - body::ELBOW).normalize_or_zero();
        if near.x < 0.3 {
            NOWHERE
        } else {
            -0.052 - (near - body::WRIST).dot(axis)
        }
    });
    body.paint(TRIM, &|p| {
        if p.y < 1.40 {
            return NOWHERE;
        }
        let collar = body::collar(left(p), body::neck(p));
        (collar - cloth(p).0).max(collar - 0.004)
    });
}

fn skin(body: &mut Painted) {
    body.paint(SKIN, &|p| {
        if p.y < 1.44 {
            return NOWHERE;
        }
        let neck = body::neck(p);
        let head = neck.min(face::surface(left(p))).min(hair::surface(left(p)));
        head - body::collar(left(p), neck).min(cloth(p).0)
    });
    body.paint(SKIN, &|p| {
        let near = left(p);
        if near.x < 0.3 {
            NOWHERE
        } else {
            hand::surface(near) - jacket::sleeve(near)
        }
    });
}

fn head(body: &mut Painted) {
    let at_face =
        |p: DVec3, radius: f64| p.distance(DVec3::new(0.0, 1.66, 0.06)) < radius && p.z > 0.0;
    body.paint(HAIR, &|p| {
        if p.y < 1.56 {
            NOWHERE
        } else {
            hair::surface(left(p)) - face::surface(left(p))
        }
    });
    body.paint(HAIR, &|p| {
        if at_face(p, 0.12) {
            eyebrow(left(p))
        } else {
            NOWHERE
        }
    });
    body.paint(LIPS, &|p| if at_face(p, 0.12) { lips(p) } else { NOWHERE });
    // Iris and pupil lie round the line of sight.
    for (material, radius) in [(EYE_WHITE, 0.02), (IRIS, 0.0062), (PUPIL, 0.0031)] {
        body.paint(material, &|p| {
            let from = left(p) - face::EYE;
            let gaze = DVec3::new(-0.024, 0.072, 1.0).normalize_or(DVec3::Z);
            let off = (from - gaze * from.dot(gaze)).length();
            (off - radius).max(from.length() - 0.0156).max(-from.z)
        });
    }
}

fn eyebrow(p: DVec3) -> f64 {
    let arc = [
        (DVec3::new(0.0150, 1.7085, 0.0945), 0.0056),
        (DVec3::new(0.0330, 1.7140, 0.0890), 0.0056),
        (DVec3::new(0.0530, 1.7085, 0.0725), 0.0036),
    ];
    chain(p, &arc)
}

fn lips(p: DVec3) -> f64 {
    let q = DVec3::new(p.x.abs(), p.y - 4.0 * p.x * p.x, p.z + 5.0 * p.x * p.x);
    let upper = DVec3::new(0.005, 1.6195, 0.0965);
    let lower = DVec3::new(0.0, 1.6090, 0.0955);
    let upper = ellipsoid(q, upper, DVec3::new(0.0205, 0.0058, 0.0120));
    let lower = ellipsoid(q, lower, DVec3::new(0.0195, 0.0068, 0.0125));
    upper.min(lower)
}
