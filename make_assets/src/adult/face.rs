//! The head without hair: skull, jaw, nose, eyes, mouth and ears.
use super::super::field::{Loft, blend, carve, chain, clip, ellipsoid, round_cone, sphere};
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Face from the chin to the forehead: height, center (0, z), half width, front, back.
static FACE: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [1.570, 0.0, 0.058, 0.026, 0.032, 0.050],
            [1.582, 0.0, 0.046, 0.043, 0.047, 0.062],
            [1.600, 0.0, 0.030, 0.054, 0.063, 0.066],
            [1.625, 0.0, 0.014, 0.062, 0.079, 0.062],
            [1.655, 0.0, 0.008, 0.067, 0.085, 0.066],
            [1.685, 0.0, 0.004, 0.070, 0.088, 0.080],
            [1.715, 0.0, 0.0, 0.070, 0.095, 0.090],
            [1.745, 0.0, 0.0, 0.067, 0.088, 0.090],
        ],
        2.2,
        (0.008, 0.03),
    )
});

pub const EYE: DVec3 = DVec3::new(0.0325, 1.6880, 0.0735);

/// The left half of the head.
pub fn surface(p: DVec3) -> f64 {
    let rough = sphere(p, DVec3::new(0.0, 1.685, 0.005), 0.135);
    if rough > 0.06 {
        return rough;
    }
    let mut d = features(p);
    d = mouth(p, d);
    d = lids(p, d);
    d = blend(d, eyeball(p), 0.0008);
    ear(p, d)
}

/// Skull, brow and nose.
pub fn features(p: DVec3) -> f64 {
    let mut d = ellipsoid(
        p,
        DVec3::new(0.0, 1.705, -0.008),
        DVec3::new(0.075, 0.086, 0.094),
    );
    d = blend(d, FACE.distance(p.y, DVec2::new(p.x, p.z)), 0.03);
    let cheekbone = ellipsoid(
        p,
        DVec3::new(0.043, 1.657, 0.052),
        DVec3::new(0.026, 0.022, 0.028),
    );
    d = blend(d, cheekbone, 0.03);
    d = blend(d, sphere(p, DVec3::new(0.0, 1.580, 0.082), 0.016), 0.02);
    d = sockets_and_brow(p, d);
    nose(p, d)
}

fn sockets_and_brow(p: DVec3, d: f64) -> f64 {
    let socket = ellipsoid(
        p,
        DVec3::new(0.032, 1.688, 0.098),
        DVec3::new(0.022, 0.0135, 0.017),
    );
    let d = carve(d, socket, 0.022);
    let ridge = chain(
        p,
        &[
            (DVec3::new(0.012, 1.7075, 0.0900), 0.0062),
            (DVec3::new(0.030, 1.7125, 0.0850), 0.0066),
            (DVec3::new(0.052, 1.7080, 0.0690), 0.0050),
        ],
    );
    let d = blend(d, ridge, 0.012);
    let eyebrow = chain(
        p,
        &[
            (DVec3::new(0.0150, 1.7085, 0.0945), 0.0036),
            (DVec3::new(0.0330, 1.7140, 0.0890), 0.0036),
            (DVec3::new(0.0530, 1.7085, 0.0725), 0.0022),
        ],
    );
    blend(d, eyebrow, 0.003)
}

fn nose(p: DVec3, d: f64) -> f64 {
    let tip = DVec3::new(0.0, 1.6470, 0.1105);
    let bridge = round_cone(p, (DVec3::new(0.0, 1.7020, 0.0870), 0.0090), (tip, 0.0115));
    let d = blend(d, bridge, 0.014);
    let wing = ellipsoid(
        p,
        DVec3::new(0.0115, 1.6450, 0.1000),
        DVec3::new(0.0075, 0.0070, 0.0100),
    );
    let d = blend(d, wing, 0.007);
    let nostril = ellipsoid(
        p,
        DVec3::new(0.0065, 1.6385, 0.1060),
        DVec3::new(0.0034, 0.0034, 0.0050),
    );
    carve(d, nostril, 0.003)
}

pub fn mouth(p: DVec3, d: f64) -> f64 {
    // The lips follow the curve of the teeth behind them.
    let back = 5.0 * p.x * p.x;
    let q = DVec3::new(p.x, p.y - 4.0 * p.x * p.x, p.z + back);
    let muzzle = ellipsoid(
        p,
        DVec3::new(0.0, 1.615, 0.080),
        DVec3::new(0.030, 0.024, 0.018),
    );
    let d = blend(d, muzzle, 0.02);
    let upper = ellipsoid(
        q,
        DVec3::new(0.005, 1.6195, 0.0965),
        DVec3::new(0.0200, 0.0052, 0.0072),
    );
    let lower = ellipsoid(
        q,
        DVec3::new(0.0, 1.6090, 0.0955),
        DVec3::new(0.0190, 0.0062, 0.0080),
    );
    let d = blend(blend(d, upper, 0.006), lower, 0.006);
    let line = ellipsoid(
        q,
        DVec3::new(0.0, 1.6148, 0.1040),
        DVec3::new(0.0250, 0.0018, 0.0080),
    );
    let philtrum = ellipsoid(
        q,
        DVec3::new(0.0, 1.6290, 0.1040),
        DVec3::new(0.0030, 0.0070, 0.0040),
    );
    carve(carve(d, line, 0.003), philtrum, 0.005)
}

/// The lids: a shell over the ball, open between two arcs that meet in the corners.
pub fn lids(p: DVec3, d: f64) -> f64 {
    let from = p - EYE;
    let half_width = 0.0165;
    let arc = 1.0 - (from.x / half_width).powi(2);
    let upper = from.y - (0.0014 + 0.0062 * arc);
    let lower = (0.0014 - 0.0056 * arc) - from.y;
    let open = clip(clip(upper, lower, 0.001), 0.004 - from.z, 0.001);
    let fold = sphere(p, EYE + DVec3::new(0.0, 0.0022, 0.0008), 0.0178);
    let lid = blend(sphere(p, EYE, 0.0175), fold, 0.001);
    carve(blend(d, lid, 0.005), open, 0.0014)
}

fn eyeball(p: DVec3) -> f64 {
    let ball = sphere(p, EYE, 0.0148);
    let iris = sphere(p, EYE + DVec3::new(-0.0004, 0.0012, 0.0166), 0.0056);
    carve(ball, iris, 0.001)
}

pub fn ear(p: DVec3, d: f64) -> f64 {
    let center = DVec3::new(0.0775, 1.6740, -0.0080);
    // In the ear's own frame: turned out a little at the back, leaning back at the top.
    let q = p - center;
    let (lean, out) = (0.20, 0.42);
    let q = DVec3::new(q.x, q.y - lean * q.z, q.z + lean * q.y);
    let q = DVec3::new(q.x + out * q.z, q.y, q.z - out * q.x);
    let shell = ellipsoid(q, DVec3::ZERO, DVec3::new(0.0085, 0.0300, 0.0190));
    let bowl = ellipsoid(
        q,
        DVec3::new(0.0085, 0.0040, 0.0015),
        DVec3::new(0.0060, 0.0195, 0.0110),
    );
    let lobe = ellipsoid(
        q,
        DVec3::new(0.0, -0.0240, 0.0050),
        DVec3::new(0.0055, 0.0085, 0.0085),
    );
    let tragus = sphere(q, DVec3::new(0.0030, -0.0030, 0.0150), 0.0045);
    let ear = blend(carve(blend(shell, lobe, 0.006), bowl, 0.005), tragus, 0.005);
    blend(d, clip(ear, -(p.x - 0.045), 0.002), 0.006)
}
