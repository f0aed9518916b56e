//! Keys that turn the camera by steps and zoom, where Blender's number pad has them.

use super::commands::{Gesture, gesture};
use super::navigation::DOLLY_PER_NOTCH;
use crate::scene::Camera;
use egui::{Context, Key, Modifiers};
use glam::{Vec2, vec2};

/// Angle of a step, in radians: Blender's.
const STEP: f32 = std::f32::consts::PI / 12.0;

/// Keys, with how far the scene turns to the right and down, in steps: the eye goes the other way, as the
/// arrows on these keys say.
const TURNS: &[(Key, Vec2)] = &[
    (Key::Num4, vec2(1.0, 0.0)),
    (Key::Num6, vec2(-1.0, 0.0)),
    (Key::Num8, vec2(0.0, 1.0)),
    (Key::Num2, vec2(0.0, -1.0)),
    (Key::Num9, vec2(12.0, 0.0)),
];

/// Keys that zoom, with the notches of a wheel that they stand for.
const ZOOMS: &[(Key, f32)] = &[(Key::Plus, 1.0), (Key::Minus, -1.0)];

/// What they do, for Help ▸ Keys and Mouse.
pub(super) const TURN_GESTURES: &[Gesture] = &[
    gesture(
        "4, 6, 8, 2",
        "Turn the camera by 15° to the left, right, up, down",
    ),
    gesture("9", "Look from the opposite side"),
    gesture("+, -", "Zoom in and out"),
];

/// `camera` after the keys that were pressed in this frame, which do nothing else.
pub(super) fn turned(mut camera: Camera, ctx: &Context) -> Camera {
    for &(key, by) in TURNS {
        let times = ctx.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key));
        camera.orbit(by * STEP * times as f32);
    }
    for &(key, notches) in ZOOMS {
        let times = ctx.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key));
        camera.dolly(-notches * DOLLY_PER_NOTCH * times as f32);
    }
    camera
}
