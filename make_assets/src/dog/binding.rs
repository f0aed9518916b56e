//! The dog's joints, and which of them each place follows.
use super::super::rig::{self, Joint};
use super::body::{
    ELBOW, FRONT_PAW, FRONT_TOES, HEAD, HIND_TOES, HIP, HOCK, KNEE, NECK, SHOULDER, TAIL, WRIST,
};
use super::{GROUND, head};
use glam::DVec3;

/// The joints; the trunk's root lies in the middle of the back.
pub fn joints() -> Vec<Joint> {
    let left = |p: DVec3| DVec3::new(p.x, p.y - GROUND, p.z);
    let right = |p: DVec3| DVec3::new(-p.x, p.y - GROUND, p.z);
    rig::joints(&[
        ("Root", -1, left(DVec3::new(0.0, 0.510, -0.060))),
        ("Hips", 0, left(DVec3::new(0.0, 0.515, -0.150))),
        ("Chest", 0, left(DVec3::new(0.0, 0.515, 0.030))),
        ("Neck", 2, left(NECK)),
        ("Head", 3, left(HEAD)),
        ("Jaw", 4, left(head::JAW)),
        ("Right ear", 4, right(head::EAR)),
        ("Left ear", 4, left(head::EAR)),
        ("Tail", 1, left(TAIL[0])),
        ("Tail middle", 8, left(TAIL[1])),
        ("Tail end", 9, left(TAIL[3].lerp(TAIL[2], 0.5))),
        ("Right shoulder", 2, right(SHOULDER)),
        ("Right elbow", 11, right(ELBOW)),
        ("Right wrist", 12, right(WRIST)),
        ("Right front paw", 13, right(FRONT_TOES)),
        ("Left shoulder", 2, left(SHOULDER)),
        ("Left elbow", 15, left(ELBOW)),
        ("Left wrist", 16, left(WRIST)),
        ("Left front paw", 17, left(FRONT_TOES)),
        ("Right thigh", 1, right(HIP)),
        ("Right knee", 19, right(KNEE)),
        ("Right hock", 20, right(HOCK)),
        ("Right hind paw", 21, right(HIND_TOES)),
        ("Left thigh", 1, left(HIP)),
        ("Left knee", 23, left(KNEE)),
        ("Left hock", 24, left(HOCK)),
        ("Left hind paw", 25, left(HIND_TOES)),
    ])
}

/// Which joint a place on the surface belongs to before the borders are softened.
pub fn owner(p: DVec3) -> usize {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let right = p.x < 0.0;
    let side = |left: usize, right_one: usize| if right { right_one } else { left };
    if let Some(part) = on_head(near) {
        return if part == 7 { side(7, 6) } else { part };
    }
    if near.z < -0.335 && near.y < 0.60 && near.x < 0.06 && near.y > 0.30 {
        let past = |a: DVec3, b: DVec3| (near - a).dot(b - a) > 0.0;
        if past(TAIL[3].lerp(TAIL[2], 0.5), TAIL[4]) {
            return 10;
        }
        if past(TAIL[1], TAIL[2]) {
            return 9;
        }
        if past(TAIL[0] + DVec3::new(0.0, 0.0, -0.012), TAIL[1]) {
            return 8;
        }
    }
    if near.z > 0.0 && near.y < 0.47 && near.x > 0.02 {
        let bend = |joint: DVec3, up: DVec3, down: DVec3| {
            (near - joint)
                .dot((down - joint).normalize_or_zero() - (up - joint).normalize_or_zero())
                > 0.0
        };
        let leg = SHOULDER + DVec3::new(0.0, -0.035, 0.0);
        if near.y < 0.42 && (near.x > 0.055 || near.y < 0.325) && bend(leg, leg + DVec3::Y, ELBOW) {
            if bend(FRONT_TOES, WRIST, FRONT_PAW) {
                return side(18, 14);
            }
            if bend(WRIST, ELBOW, FRONT_TOES) {
                return side(17, 13);
            }
            if bend(ELBOW, SHOULDER, WRIST) {
                return side(16, 12);
            }
            return side(15, 11);
        }
    }
    if near.z < -0.06 {
        if near.y < HIND_TOES.y {
            return side(26, 22);
        }
        if near.y < HOCK.y {
            return side(25, 21);
        }
        if near.y < KNEE.y + 0.3 * (near.z - KNEE.z) {
            return side(24, 20);
        }
        if near.y < 0.43 + 0.2 * (near.x - 0.08) && near.z < -0.075 {
            return side(23, 19);
        }
    }
    if (near - NECK).dot(DVec3::new(0.0, 0.55, 0.83)) > 0.02 && near.y > 0.46 {
        return 3;
    }
    if near.z > -0.06 { 2 } else { 1 }
}

fn on_head(p: DVec3) -> Option<usize> {
    let ear = (p - head::EAR).dot(DVec3::new(0.25, 0.96, 0.0)) > 0.012 && p.z < 0.488;
    if ear && p.y > 0.78 {
        return Some(7);
    }
    if p.z > 0.478 && p.y < 0.6745 - 0.02 * (p.z - 0.478) {
        return Some(5);
    }
    let head = (p - HEAD).dot(DVec3::new(0.0, 0.5, 0.87)) > 0.0 && p.y > 0.59;
    head.then_some(4)
}

/// How far the border between joints is softened.
pub fn reach(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    if near.y < 0.24 {
        return 0.012;
    }
    if near.y > 0.63 && near.z > 0.43 {
        return if near.y > 0.77 { 0.014 } else { 0.010 };
    }
    if near.z < -0.36 {
        return 0.024;
    }
    if near.y < 0.36 { 0.022 } else { 0.042 }
}
