//! Torso, arms and legs with their clothes, and the whole body's surface.
use super::super::field::{
    Loft, blend, carve, chain, clip, ellipsoid, round_cone, smooth_step, sphere,
};
use super::{face, hair, hand, shoe};
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Landmarks of the left side.
pub const SHOULDER: DVec3 = DVec3::new(0.178, 1.425, -0.012);
pub const ELBOW: DVec3 = DVec3::new(0.376, 1.213, -0.022);
pub const WRIST: DVec3 = DVec3::new(0.548, 1.030, 0.030);
pub const HIP: DVec3 = DVec3::new(0.094, 0.925, 0.0);
pub const KNEE: DVec3 = DVec3::new(0.114, 0.500, 0.012);
pub const ANKLE: DVec3 = DVec3::new(0.128, 0.085, -0.022);

static TORSO: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.965, 0.0, 0.0, 0.163, 0.108, 0.112],
            [1.005, 0.0, 0.0, 0.160, 0.110, 0.106],
            [1.050, 0.0, 0.0, 0.163, 0.118, 0.106],
            [1.120, 0.0, 0.0, 0.158, 0.116, 0.100],
            [1.200, 0.0, 0.0, 0.162, 0.120, 0.110],
            [1.300, 0.0, 0.0, 0.178, 0.128, 0.128],
            [1.370, 0.0, 0.0, 0.180, 0.120, 0.132],
            [1.430, 0.0, 0.0, 0.160, 0.094, 0.120],
            [1.475, 0.0, -0.01, 0.118, 0.068, 0.092],
            [1.515, 0.0, -0.01, 0.072, 0.056, 0.064],
        ],
        2.3,
        (0.012, 0.02),
    )
});

static PELVIS: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.850, 0.0, 0.0, 0.120, 0.070, 0.085],
            [0.900, 0.0, 0.0, 0.168, 0.096, 0.122],
            [0.950, 0.0, 0.0, 0.166, 0.100, 0.118],
            [1.000, 0.0, 0.0, 0.152, 0.100, 0.100],
        ],
        2.2,
        (0.03, 0.02),
    )
});

static LEG: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.075, 0.128, -0.014, 0.056, 0.060, 0.058],
            [0.130, 0.127, -0.016, 0.056, 0.056, 0.058],
            [0.220, 0.124, -0.014, 0.057, 0.054, 0.061],
            [0.330, 0.120, -0.010, 0.061, 0.056, 0.069],
            [0.420, 0.117, -0.004, 0.062, 0.059, 0.066],
            [0.500, 0.114, 0.004, 0.063, 0.065, 0.060],
            [0.600, 0.110, 0.006, 0.070, 0.073, 0.070],
            [0.710, 0.105, 0.004, 0.079, 0.083, 0.082],
            [0.820, 0.099, 0.0, 0.087, 0.093, 0.098],
            [0.900, 0.092, 0.0, 0.084, 0.092, 0.112],
            [0.960, 0.086, 0.0, 0.074, 0.090, 0.100],
        ],
        2.0,
        (0.008, 0.03),
    )
});

/// The surface of the whole body.
pub fn surface(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let far = DVec3::new(-near.x, p.y, p.z);
    let trunk = jacket(near, far);
    let lower = trousers(near, far);
    let mut d = blend(trunk, lower, 0.006);
    d = blend(d, neck_and_head(near), 0.006);
    d.min(shoe::surface(near))
}

/// Jacket with sleeves and the hands that come out of them.
fn jacket(p: DVec3, mirrored: DVec3) -> f64 {
    let mut d = TORSO.distance(p.y, DVec2::new(p.x, p.z));
    // Chest and shoulder blades give the loft its planes; the zip runs down in a shallow groove.
    d = blend(
        d,
        ellipsoid(
            p,
            DVec3::new(0.082, 1.325, 0.060),
            DVec3::new(0.078, 0.070, 0.062),
        ),
        0.05,
    );
    d = blend(
        d,
        ellipsoid(
            p,
            DVec3::new(0.085, 1.345, -0.078),
            DVec3::new(0.066, 0.090, 0.050),
        ),
        0.05,
    );
    d = blend(
        d,
        chain(
            p,
            &[
                (DVec3::new(0.02, 1.485, -0.03), 0.050),
                (SHOULDER + DVec3::new(-0.012, 0.008, 0.0), 0.050),
            ],
        ),
        0.05,
    );
    let arm = sleeve(p);
    d = blend(d, blend(arm, sleeve(mirrored), 0.02), 0.055);
    d = rib(p, d);
    let groove = (p.x - 0.003).max(p.y - 1.50).max(-p.z);
    d += 0.003 * (1.0 - smooth_step(0.0, 0.006, groove));
    blend(d, hand::surface(p), 0.004)
}

/// The elastic band round the hem: tighter than the cloth that falls over it.
fn rib(p: DVec3, d: f64) -> f64 {
    let blouse = 0.010 * smooth_step(1.004, 1.016, p.y) * (1.0 - smooth_step(1.03, 1.12, p.y));
    if p.x > 0.26 { d } else { d - blouse }
}

/// The sleeve with its cuff.
fn sleeve(p: DVec3) -> f64 {
    let upper = round_cone(p, (SHOULDER, 0.064), (ELBOW, 0.050));
    let lower = round_cone(p, (ELBOW, 0.050), (WRIST.lerp(ELBOW, 0.12), 0.0385));
    let mut d = blend(upper, lower, 0.03);
    d = blend(
        d,
        ellipsoid(
            p,
            SHOULDER + DVec3::new(0.022, -0.012, 0.0),
            DVec3::new(0.062, 0.070, 0.066),
        ),
        0.04,
    );
    let axis = (WRIST - ELBOW).normalize_or_zero();
    let along = (p - WRIST).dot(axis);
    // The cloth gathers before the cuff and ends just short of the wrist.
    let bulge =
        0.007 * smooth_step(-0.13, -0.075, along) * (1.0 - smooth_step(-0.062, -0.052, along));
    clip(d - bulge, along + 0.008, 0.006)
}

/// Trousers: hips, legs and turned-up hems.
fn trousers(p: DVec3, mirrored: DVec3) -> f64 {
    let leg = leg(p);
    let legs = blend(leg, self::leg(mirrored), 0.03);
    let mut pelvis = PELVIS.distance(p.y, DVec2::new(p.x, p.z));
    pelvis = blend(
        pelvis,
        ellipsoid(
            p,
            DVec3::new(0.078, 0.905, -0.062),
            DVec3::new(0.082, 0.085, 0.068),
        ),
        0.03,
    );
    blend(legs, pelvis, 0.045)
}

fn leg(p: DVec3) -> f64 {
    let d = LEG.distance(p.y, DVec2::new(p.x, p.z));
    let knee = sphere(p, KNEE + DVec3::new(0.0, 0.0, 0.018), 0.050);
    let d = blend(d, knee, 0.03);
    let cuff = 0.006 * (1.0 - smooth_step(0.112, 0.120, p.y));
    let break_fold =
        0.006 * smooth_step(0.118, 0.140, p.y) * (1.0 - smooth_step(0.150, 0.230, p.y));
    d - cuff - break_fold
}

/// Neck, collar, head and hair.
fn neck_and_head(p: DVec3) -> f64 {
    if p.y < 1.36 {
        return sphere(p, DVec3::new(0.0, 1.64, 0.0), 0.20);
    }
    let neck = round_cone(
        p,
        (DVec3::new(0.0, 1.46, -0.030), 0.060),
        (DVec3::new(0.0, 1.63, 0.0), 0.054),
    );
    let head = face::surface(p);
    let mut d = blend(neck, head, 0.022);
    d = blend(d, hair::surface(p), 0.004);
    // A stand-up collar: a shell round the neck, higher at the nape, open in a V at the throat.
    let rim = p.y - 1.533 + 0.35 * p.z;
    let opening = (p.x - 0.012 - 0.35 * (p.y - 1.48)).max(0.01 - p.z);
    let shell = clip((neck - 0.018).abs() - 0.006, rim, 0.006);
    let collar = carve(shell, opening, 0.006);
    blend(d, collar, 0.003)
}
