//! The skin of the bust: the adult's head with a mouth that opens into a hollow, and lids with
//! nothing between them, for eyeballs of their own.
use super::super::super::adult::{body, face, hair};
use super::super::super::field::{blend, carve, chain, clip, ellipsoid, sphere};
use super::super::paint::Painted;
use super::{HAIR, LIPS, PALATE, SHIRT};
use glam::DVec3;

/// Where the lips meet, in the middle; to the sides they rise and go back.
pub const LIPS_MEET: DVec3 = DVec3::new(0.0, 1.6146, 0.1000);

/// The height at which the lips meet.
pub fn lip_line(x: f64) -> f64 {
    LIPS_MEET.y + 4.0 * x * x
}

/// The left half of the surface.
pub fn surface(p: DVec3) -> f64 {
    let head = sphere(p, DVec3::new(0.0, 1.685, 0.0), 0.145);
    let mut d = if head > 0.06 { head } else { head_surface(p) };
    d = blend(body::neck(p), d, 0.022);
    d = blend(d, shirt(p), 0.004);
    // The bust ends in a rounded edge.
    clip(d, 1.452 - p.y, 0.018)
}

fn head_surface(p: DVec3) -> f64 {
    let mut d = face::mouth(p, face::features(p));
    d = face::lids(p, d);
    d = face::ear(p, d);
    d = blend(d, hair::surface(p), 0.003);
    carve(d, opening(p), 0.0012)
}

/// The hollow of the mouth with the slit between the lips.
fn opening(p: DVec3) -> f64 {
    let back = DVec3::new(p.x, p.y - 4.0 * p.x * p.x, p.z + 5.0 * p.x * p.x);
    let slit = ellipsoid(
        back,
        DVec3::new(0.0, LIPS_MEET.y, 0.0950),
        DVec3::new(0.0215, 0.0018, 0.0200),
    );
    let hollow = ellipsoid(
        p,
        DVec3::new(0.0, LIPS_MEET.y + 0.0005, 0.0600),
        DVec3::new(0.0290, 0.0175, 0.0320),
    );
    blend(slit, hollow, 0.003)
}

/// Shoulders in a shirt with a round neck.
fn shirt(p: DVec3) -> f64 {
    let shoulders = [
        (DVec3::new(0.0, 1.462, -0.022), 0.062),
        (DVec3::new(0.110, 1.446, -0.024), 0.050),
    ];
    let collar = clip(body::neck(p) - 0.008, neckline(p), 0.006);
    blend(chain(p, &shoulders), collar, 0.02)
}

/// How far a place lies above the plane in which the shirt ends.
fn neckline(p: DVec3) -> f64 {
    p.y - 1.520 + 0.42 * p.z
}

/// The wanted length of edges.
pub fn size(p: DVec3) -> f64 {
    let near = |center: DVec3, radius: f64, fine: f64| {
        fine + 0.17 * (p.distance(center) - radius).max(0.0)
    };
    let mut size: f64 = 0.0138;
    size = size.min(near(DVec3::new(0.0, 1.775, 0.02), 0.07, 0.0074));
    size = size.min(near(DVec3::new(0.012, 1.615, 0.098), 0.016, 0.0023));
    size = size.min(near(DVec3::new(0.0, 1.645, 0.105), 0.016, 0.0034));
    size = size.min(near(face::EYE, 0.018, 0.0023));
    size = size.min(near(DVec3::new(0.036, 1.712, 0.086), 0.022, 0.0036));
    size = size.min(near(DVec3::new(0.08, 1.675, -0.005), 0.025, 0.0042));
    size = size.min(near(DVec3::new(0.025, 1.578, 0.050), 0.035, 0.0078));
    // The neckline, the bust's edge, and the hairline of the forehead.
    let band = |off: f64, fine: f64| fine + 0.25 * (off.abs() - 0.006).max(0.0);
    if body::neck(p) < 0.03 {
        size = size.min(band(neckline(p), 0.0042));
    }
    if p.z > 0.03 {
        size = size.min(band(p.y - 1.748 + 2.2 * p.x * p.x, 0.0045));
    }
    size.min(band(p.y - 1.456, 0.0065))
}

pub fn paint(bust: &mut Painted) {
    let left = |p: DVec3| DVec3::new(p.x.abs(), p.y, p.z);
    bust.paint(SHIRT, &|p| shirt(left(p)) - body::neck(p).min(0.003));
    bust.paint(HAIR, &|p| {
        let skin = face::ear(left(p), face::features(left(p)));
        if p.y < 1.56 {
            1.0
        } else {
            hair::surface(left(p)) - skin
        }
    });
    bust.paint(HAIR, &|p| eyebrow(left(p)).max(0.03 - p.z));
    bust.paint(LIPS, &|p| lips(left(p)));
    bust.paint(PALATE, &|p| {
        // Behind the lips, which the teeth follow.
        let front = 0.0920 - 5.0 * p.x * p.x;
        opening(left(p)).max(p.z - front) - 0.0012
    });
}

/// Negative on the eyebrow.
pub fn eyebrow(p: DVec3) -> f64 {
    let arc = [
        (DVec3::new(0.0150, 1.7085, 0.0945), 0.0050),
        (DVec3::new(0.0330, 1.7140, 0.0890), 0.0054),
        (DVec3::new(0.0530, 1.7085, 0.0725), 0.0034),
    ];
    chain(p, &arc)
}

fn lips(p: DVec3) -> f64 {
    let q = DVec3::new(p.x, p.y - 4.0 * p.x * p.x, p.z + 5.0 * p.x * p.x);
    let upper = DVec3::new(0.004, 1.6190, 0.0965);
    let lower = DVec3::new(0.0, 1.6095, 0.0955);
    let upper = ellipsoid(q, upper, DVec3::new(0.0228, 0.0052, 0.0140));
    let lower = ellipsoid(q, lower, DVec3::new(0.0218, 0.0060, 0.0140));
    upper.min(lower)
}
