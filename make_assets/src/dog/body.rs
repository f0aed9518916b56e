//! Trunk, neck, tail and legs, and the whole animal's surface.
use super::super::field::{Loft, blend, chain, clip, ellipsoid, round_cone, sphere};
use super::head;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

pub const SHOULDER: DVec3 = DVec3::new(0.078, 0.470, 0.215);
pub const ELBOW: DVec3 = DVec3::new(0.096, 0.335, 0.135);
pub const WRIST: DVec3 = DVec3::new(0.092, 0.160, 0.158);
pub const FRONT_TOES: DVec3 = DVec3::new(0.094, 0.050, 0.172);
pub const FRONT_PAW: DVec3 = DVec3::new(0.096, 0.022, 0.205);
pub const HIP: DVec3 = DVec3::new(0.072, 0.470, -0.235);
pub const KNEE: DVec3 = DVec3::new(0.106, 0.315, -0.135);
pub const HOCK: DVec3 = DVec3::new(0.098, 0.165, -0.305);
pub const HIND_TOES: DVec3 = DVec3::new(0.100, 0.050, -0.280);
pub const HIND_PAW: DVec3 = DVec3::new(0.102, 0.022, -0.245);
pub const NECK: DVec3 = DVec3::new(0.0, 0.540, 0.235);
pub const HEAD: DVec3 = DVec3::new(0.0, 0.688, 0.393);
pub const TAIL: [DVec3; 5] = [
    DVec3::new(0.0, 0.535, -0.345),
    DVec3::new(0.0, 0.500, -0.435),
    DVec3::new(0.0, 0.430, -0.505),
    DVec3::new(0.0, 0.375, -0.575),
    DVec3::new(0.0, 0.355, -0.645),
];

/// Along the body: place, 0, height of the middle, half width, up, down.
static TRUNK: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [-0.340, 0.0, 0.500, 0.066, 0.066, 0.070],
            [-0.280, 0.0, 0.495, 0.098, 0.094, 0.095],
            [-0.180, 0.0, 0.490, 0.104, 0.104, 0.090],
            [-0.070, 0.0, 0.485, 0.104, 0.106, 0.100],
            [0.050, 0.0, 0.475, 0.116, 0.112, 0.135],
            [0.150, 0.0, 0.470, 0.120, 0.126, 0.158],
            [0.230, 0.0, 0.475, 0.102, 0.126, 0.140],
            [0.290, 0.0, 0.490, 0.074, 0.098, 0.100],
        ],
        2.15,
        (0.030, 0.035),
    )
});

/// The surface of the whole animal.
pub fn surface(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let far = DVec3::new(-near.x, p.y, p.z);
    let mut d = TRUNK.distance(p.z, DVec2::new(near.x, p.y));
    d = blend(d, neck(near), 0.06);
    d = blend(d, tail(near), 0.03);
    d = blend(d, blend(fore_leg(near), fore_leg(far), 0.015), 0.035);
    d = blend(d, blend(hind_leg(near), hind_leg(far), 0.015), 0.035);
    blend(d, head::surface(near), 0.025)
}

/// Neck with a ruff, fuller below and at the breast.
fn neck(p: DVec3) -> f64 {
    let d = chain(
        p,
        &[
            (NECK + DVec3::new(0.0, -0.035, -0.01), 0.105),
            (DVec3::new(0.0, 0.612, 0.322), 0.096),
            (HEAD + DVec3::new(0.0, 0.0, 0.005), 0.076),
        ],
    );
    let ruff = chain(
        p,
        &[
            (DVec3::new(0.0, 0.565, 0.345), 0.072),
            (DVec3::new(0.0, 0.465, 0.285), 0.080),
        ],
    );
    let cheek = ellipsoid(
        p,
        DVec3::new(0.045, 0.662, 0.408),
        DVec3::new(0.034, 0.050, 0.040),
    );
    blend(blend(d, ruff, 0.05), cheek, 0.04)
}

/// A bushy tail that hangs and lifts at its end.
fn tail(p: DVec3) -> f64 {
    let radii = [0.034, 0.040, 0.050, 0.044, 0.012];
    let spheres: Vec<(DVec3, f64)> = TAIL.into_iter().zip(radii).collect();
    spheres
        .windows(2)
        .map(|s| round_cone(p, s[0], s[1]))
        .fold(f64::INFINITY, |all, one| blend(all.min(1e3), one, 0.03))
}

fn fore_leg(p: DVec3) -> f64 {
    if p.z < -0.06 {
        return 0.04 - p.z;
    }
    let blade = round_cone(
        p,
        (SHOULDER + DVec3::new(-0.012, 0.050, -0.045), 0.060),
        (SHOULDER, 0.062),
    );
    let upper = round_cone(p, (SHOULDER, 0.066), (ELBOW, 0.047));
    let elbow = sphere(p, ELBOW + DVec3::new(0.0, 0.008, -0.022), 0.030);
    let lower = round_cone(p, (ELBOW, 0.043), (WRIST, 0.0285));
    let cannon = round_cone(p, (WRIST, 0.0285), (FRONT_TOES, 0.0265));
    let mut d = blend(blend(blade, upper, 0.04), lower, 0.035);
    d = blend(d, elbow, 0.03);
    d = blend(d, cannon, 0.012);
    blend(d, paw(p, FRONT_PAW), 0.014)
}

fn hind_leg(p: DVec3) -> f64 {
    if p.z > 0.08 {
        return p.z + 0.03;
    }
    // A broad, flat thigh from the croup to the knee.
    let flat = |v: DVec3| DVec3::new(v.x / 0.66, v.y, v.z);
    let thigh = [
        (flat(HIP + DVec3::new(-0.004, 0.0, 0.0)), 0.100),
        (
            flat(HIP.lerp(KNEE, 0.5) + DVec3::new(0.004, -0.012, -0.026)),
            0.088,
        ),
        (flat(KNEE + DVec3::new(-0.016, 0.010, -0.014)), 0.050),
    ];
    let thigh = 0.8 * chain(flat(p), &thigh);
    let stifle = sphere(p, KNEE + DVec3::new(-0.012, 0.006, -0.006), 0.037);
    let middle = KNEE.lerp(HOCK, 0.45) + DVec3::new(0.0, 0.006, 0.0);
    let gaskin = chain(
        p,
        &[
            (KNEE + DVec3::new(-0.008, 0.0, -0.006), 0.040),
            (middle, 0.036),
            (HOCK, 0.0255),
        ],
    );
    let heel = sphere(p, HOCK + DVec3::new(0.0, 0.010, -0.014), 0.020);
    let cannon = round_cone(p, (HOCK, 0.0270), (HIND_TOES, 0.0250));
    let flank = round_cone(
        p,
        (DVec3::new(0.070, 0.440, -0.135), 0.052),
        (KNEE + DVec3::new(-0.010, 0.012, -0.006), 0.034),
    );
    let thigh = blend(thigh, flank, 0.05);
    let mut d = blend(blend(thigh, stifle, 0.04), gaskin, 0.05);
    d = blend(blend(d, heel, 0.014), cannon, 0.012);
    blend(d, paw(p, HIND_PAW), 0.014)
}

/// A paw: pad with four toes, flat on the ground.
fn paw(p: DVec3, at: DVec3) -> f64 {
    let q = p - at;
    let rough = q.length() - 0.07;
    if rough > 0.05 {
        return rough;
    }
    let mut d = ellipsoid(
        q,
        DVec3::new(0.0, 0.010, -0.020),
        DVec3::new(0.034, 0.034, 0.036),
    );
    for (x, z, lift) in [
        (-0.0265, 0.006, 0.0),
        (-0.0092, 0.019, 0.002),
        (0.0092, 0.019, 0.002),
        (0.0265, 0.006, 0.0),
    ] {
        let toe = ellipsoid(
            q,
            DVec3::new(x, 0.006 + lift, z),
            DVec3::new(0.0118, 0.0200, 0.0240),
        );
        d = blend(d, toe, 0.005);
    }
    clip(d, -(q.y + 0.020), 0.006)
}
