use super::blender_keys;
use super::commands::{Gesture, gesture};
use super::turning_keys::{TURN_GESTURES, turned};
use crate::editor::Together;
use crate::scene::{Camera, Look};
use crate::ui::pointing::Pointing;
use egui::{
    Context, Event, Id, InputState, Key, KeyboardShortcut, Modifiers, PointerButton, Response,
};
use glam::{Vec2, Vec3};

/// How mouse and keys move the camera, each as in a program that users may know.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Navigation {
    /// As in the course's editor: left moves the scene, right turns the camera; and the middle button, which does nothing
    /// there and turns in many programs, turns it, too.
    #[default]
    Course,
    /// As three.js's OrbitControls: left turns the scene, right or middle moves it.
    Orbit,
    /// As in the Virtual Mannequin: left turns, right zooms, keys walk, digits open its scenes.
    Mannequin,
    /// As in Blender: the middle button turns, with Shift it moves, with Ctrl it zooms.
    Blender,
}

/// Movement of the camera by a drag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Motion {
    /// [`Camera::pan`], the course's, in its look, and else as [`Motion::Follow`].
    Pan,
    /// [`Camera::turn`], the course's.
    Turn,
    /// [`Camera::pan_with_pointer`].
    Follow,
    /// [`Camera::orbit`] by a whole turn for the height of the picture.
    Orbit,
    /// [`Camera::dolly`], down = away.
    Dolly,
}

/// Button and modifiers of a drag, its movement, and its row in Help ▸ Keys and Mouse.
struct Drag {
    button: PointerButton,
    modifiers: Modifiers,
    motion: Motion,
    row: Gesture,
}

const fn drag(
    button: PointerButton,
    modifiers: Modifiers,
    motion: Motion,
    hand: &'static str,
    does: &'static str,
) -> Drag {
    Drag {
        button,
        modifiers,
        motion,
        row: gesture(hand, does),
    }
}

const NONE: Modifiers = Modifiers::NONE;
const LEFT: PointerButton = PointerButton::Primary;
const RIGHT: PointerButton = PointerButton::Secondary;
const MIDDLE: PointerButton = PointerButton::Middle;

/// The first row whose button and modifiers are held is used; rows without modifiers allow any.
#[rustfmt::skip]
const COURSE: &[Drag] = &[
    drag(LEFT, NONE, Motion::Pan, "Left drag in the view", "Move the scene; in the Course look as fast as the course does"),
    drag(RIGHT, NONE, Motion::Turn, "Right drag in the view", "Turn the camera about its target"),
    drag(MIDDLE, NONE, Motion::Turn, "Middle drag in the view", "Turn the camera about its target"),
];
#[rustfmt::skip]
const ORBIT: &[Drag] = &[
    drag(LEFT, Modifiers::SHIFT, Motion::Follow, "Shift and left drag", "Move the scene with the pointer"),
    drag(LEFT, NONE, Motion::Orbit, "Left drag in the view", "Turn the scene with the pointer"),
    drag(RIGHT, NONE, Motion::Follow, "Right drag in the view", "Move the scene with the pointer"),
    drag(MIDDLE, NONE, Motion::Follow, "Middle drag in the view", "Move the scene with the pointer"),
];
#[rustfmt::skip]
const MANNEQUIN: &[Drag] = &[
    drag(LEFT, NONE, Motion::Orbit, "Left drag in the view", "Turn the scene with the pointer"),
    drag(RIGHT, NONE, Motion::Dolly, "Right drag in the view", "Move the camera, down is away"),
    drag(MIDDLE, NONE, Motion::Follow, "Middle drag in the view", "Move the scene with the pointer"),
];
#[rustfmt::skip]
const BLENDER: &[Drag] = &[
    drag(MIDDLE, Modifiers::SHIFT, Motion::Follow, "Shift and middle drag", "Move the scene with the pointer"),
    drag(MIDDLE, Modifiers::CTRL, Motion::Dolly, "Ctrl and middle drag", "Move the camera, down is away"),
    drag(MIDDLE, NONE, Motion::Orbit, "Middle drag in the view", "Turn the scene with the pointer"),
    drag(LEFT, Modifiers::ALT, Motion::Orbit, "Alt and left drag", "Turn the scene, without a middle button"),
];
const BLENDER_GESTURES: &[Gesture] = &[
    gesture("Wheel in the view", "Zoom to what is under the pointer"),
    gesture("Left drag in the view", "Select in a box; Shift adds to it"),
];

/// A key that moves the eye while it is held, along the picture's right, the world's up and the
/// direction of view (x, y and z of `along`); or that turns it about the target.
struct Step {
    key: Key,
    along: Vec3,
    turn: f32,
}

const fn step(key: Key, along: Vec3) -> Step {
    Step {
        key,
        along,
        turn: 0.0,
    }
}

const fn turn(key: Key, turn: f32) -> Step {
    Step {
        key,
        along: Vec3::ZERO,
        turn,
    }
}

const STEPS: &[Step] = &[
    step(Key::D, Vec3::X),
    step(Key::A, Vec3::NEG_X),
    step(Key::ArrowUp, Vec3::Y),
    step(Key::ArrowDown, Vec3::NEG_Y),
    step(Key::W, Vec3::Z),
    step(Key::S, Vec3::NEG_Z),
    turn(Key::ArrowRight, 1.0),
    turn(Key::ArrowLeft, -1.0),
];
const STEP_GESTURES: &[Gesture] = &[
    gesture("W, S", "Move the camera forwards, backwards"),
    gesture("A, D", "Move the camera to the left, to the right"),
    gesture("Up, Down over the view", "Move the camera up, down"),
    gesture(
        "Left, Right over the view",
        "Turn the camera, where no bone is to be rolled",
    ),
];

/// What the pointer did over the view in a frame. Lengths are in pixels of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointerMove {
    /// Movement, y down.
    pub delta: Vec2,
    /// The same, in the first frame of a drag with all of the way since the button was pressed.
    pub all: Vec2,
    /// Point in the world that is dragged.
    pub held: Vec3,
    /// Height of the picture.
    pub height: f32,
    /// Notches of the wheel.
    pub notches: f32,
    /// Point in the world that the wheel was turned over, if it was.
    pub turned_over: Option<Vec3>,
    /// Whether the view is to move as fast as in the course's editor: in its look.
    pub as_course: bool,
}

/// Step of one press of a key, in units of the world or in radians.
const STEP: f32 = 0.1;
/// Steps per second while a key is held, as keys usually repeat.
const STEPS_PER_SECOND: f32 = 30.0;
/// Longest frame that counts while a key is held, in seconds, so that a stall is no leap.
const LONGEST_FRAME: f32 = 0.1;
/// [`Camera::dolly`] per notch of the wheel, and per pixel of a drag.
pub(super) const DOLLY_PER_NOTCH: f32 = 0.1;
const DOLLY_PER_PIXEL: f32 = 0.005;

/// Keys that only the Virtual Mannequin's navigation has a use for.
const OF_THE_MANNEQUIN: &[Key] = &[
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::ArrowUp,
    Key::ArrowDown,
];
const WHY_NOTHING: &str = "This key does nothing in this navigation: the Virtual Mannequin's keys work in \
                           View ⏵ Navigation ⏵ Mannequin";

impl Navigation {
    /// All, in the order of the menu.
    pub const ALL: [Self; 4] = [Self::Course, Self::Orbit, Self::Mannequin, Self::Blender];

    fn drags(self) -> &'static [Drag] {
        match self {
            Self::Course => COURSE,
            Self::Orbit => ORBIT,
            Self::Mannequin => MANNEQUIN,
            Self::Blender => BLENDER,
        }
    }

    /// Whether a key moves the camera while it is held.
    pub(super) fn walks_by(self, key: Key) -> bool {
        self == Self::Mannequin && STEPS.iter().any(|step| step.key == key)
    }

    /// Why a key that was pressed in this frame, and that nothing has used, does nothing, though it does in the
    /// Virtual Mannequin, if the view has its look, or in Blender; `None` if there is none.
    pub(super) fn why_nothing(self, ctx: &Context, look: Look) -> Option<&'static str> {
        let is_one = |event: &Event, shortcut: &KeyboardShortcut| match event {
            Event::Key {
                key,
                pressed: true,
                repeat: false,
                modifiers,
                ..
            } => modifiers.matches_exact(shortcut.modifiers) && *key == shortcut.logical_key,
            _ => false,
        };
        let is_pressed = |shortcut: &KeyboardShortcut| {
            ctx.input(|input| input.events.iter().any(|event| is_one(event, shortcut)))
        };
        let is_plain = |&key: &Key| is_pressed(&KeyboardShortcut::new(Modifiers::NONE, key));
        if self == Self::Mannequin {
            return None;
        }
        let mut not_here = blender_keys::NOT_HERE.iter();
        // Space is meant for a button that has the keyboard.
        let has_keyboard = ctx.memory(|memory| memory.focused().is_some());
        let is_meant = |key: &KeyboardShortcut| key.logical_key != Key::Space || !has_keyboard;
        let not_here =
            not_here.find(|(key, _)| self == Self::Blender && is_pressed(key) && is_meant(key));
        let is_mannequins = look == Look::Mannequin && OF_THE_MANNEQUIN.iter().any(is_plain);
        let is_mannequins = is_mannequins.then_some(WHY_NOTHING);
        not_here.map(|(_, why)| *why).or(is_mannequins)
    }

    /// Which of the selected joints turn together.
    pub(super) fn together(self) -> Together {
        match self {
            Self::Blender => Together::Topmost,
            Self::Course | Self::Orbit | Self::Mannequin => Together::Every,
        }
    }

    /// Whether Esc ends the program where there is nothing else to end. In Blender it never does.
    pub(super) fn quits_by_esc(self) -> bool {
        self != Self::Blender
    }

    /// Gestures that move the camera, for Help ▸ Keys and Mouse.
    pub(super) fn gestures(self) -> impl Iterator<Item = &'static Gesture> {
        let (steps, turns): (&[Gesture], &[Gesture]) = match self {
            Self::Mannequin => (STEP_GESTURES, &[]),
            Self::Blender => (BLENDER_GESTURES, TURN_GESTURES),
            Self::Course | Self::Orbit => (&[], &[]),
        };
        let drags = self.drags().iter().map(|drag| &drag.row);
        drags.chain(steps).chain(turns)
    }

    /// What one finger that is drawn over the view does, for Help ▸ Keys and Mouse.
    pub(super) fn drag_of_a_finger(self) -> Gesture {
        match self {
            Self::Blender => gesture("One finger", "Select the shapes in a box"),
            Self::Course | Self::Orbit | Self::Mannequin => gesture("One finger", "Turn the scene"),
        }
    }

    /// The gestures of a mouse as one line, or those of fingers, for the status line.
    pub(super) fn summary(self, pointing: Pointing) -> &'static str {
        match (self, pointing) {
            (Self::Blender, Pointing::Fingers) => {
                "One finger selects in a box · two move the scene and zoom"
            }
            (_, Pointing::Fingers) => "One finger turns the scene · two move it and zoom",
            (_, Pointing::Mouse) => self.summary_of_mouse(),
        }
    }

    /// What a mouse, and keys, do in the view.
    pub(super) fn summary_of_mouse(self) -> &'static str {
        match self {
            Self::Course => "Left drag moves the scene · right drag turns it · wheel zooms",
            Self::Orbit => "Left drag turns the scene · right drag moves it · wheel zooms",
            Self::Mannequin => "Left drag turns the scene · right drag zooms · W, S, A, D walk",
            Self::Blender => "Middle drag turns, with Shift moves · left drag selects",
        }
    }

    /// Text of the status line over a shape that is not selected: a click selects it, and a drag
    /// still turns the camera.
    pub(super) fn over_a_shape(self, pointing: Pointing) -> &'static str {
        match self {
            _ if pointing == Pointing::Fingers => "Tap to select it",
            Self::Course => "Click to select it · right drag turns the camera",
            Self::Orbit | Self::Mannequin => "Click to select it · left drag turns the scene",
            Self::Blender => "Click to select it · middle drag turns the scene",
        }
    }

    /// `camera` after what the pointer did over `view` in this frame.
    pub(super) fn moved(self, mut camera: Camera, view: &Response, by: &PointerMove) -> Camera {
        let PointerMove {
            delta,
            height,
            notches,
            ..
        } = *by;
        let held = view.ctx.input(|input| input.modifiers);
        let row = self.drags().iter().find(|row| {
            view.dragged_by(row.button) && (row.modifiers.is_none() || held.contains(row.modifiers))
        });
        let motion = row.map(|row| row.motion);
        // One finger has no other button to turn with.
        let by_finger = view.ctx.input(InputState::any_touches) && view.dragged();
        match if by_finger {
            Some(Motion::Orbit)
        } else {
            motion
        } {
            Some(Motion::Pan) if by.as_course => camera.pan(delta),
            Some(Motion::Turn) => camera.turn(delta),
            Some(Motion::Pan | Motion::Follow) => {
                camera.pan_with_pointer(by.all, height, by.held);
            }
            Some(Motion::Orbit) => camera.orbit(delta * (std::f32::consts::TAU / height)),
            Some(Motion::Dolly) => camera.dolly(delta.y * DOLLY_PER_PIXEL),
            None => {}
        }
        if notches != 0.0 {
            match self {
                Self::Course => camera.zoom(notches),
                Self::Orbit | Self::Mannequin => camera.dolly(-notches * DOLLY_PER_NOTCH),
                Self::Blender => {
                    let over = by.turned_over.unwrap_or(camera.target);
                    camera.dolly_about(-notches * DOLLY_PER_NOTCH, over);
                }
            }
        }
        camera
    }

    /// `camera` after the keys that are held in this frame, or were pressed.
    pub(super) fn walked(self, mut camera: Camera, ctx: &Context) -> Camera {
        match self {
            Self::Mannequin => {}
            Self::Blender => return turned(camera, ctx),
            Self::Course | Self::Orbit => return camera,
        }
        let mut walks = false;
        let (pressed, held) = walking_keys(ctx);
        for step in STEPS {
            let amount = ctx.input(|input| {
                if pressed.contains(&step.key) {
                    STEP
                } else if held.contains(&step.key) && !input.modifiers.any() {
                    STEP * STEPS_PER_SECOND * input.stable_dt.min(LONGEST_FRAME)
                } else {
                    0.0
                }
            });
            if amount != 0.0 {
                walks = true;
                camera.walk(step.along * amount);
                camera.orbit(Vec2::new(-step.turn * amount, 0.0));
            }
        }
        if walks {
            ctx.request_repaint();
        }
        camera
    }
}

/// Keys that were pressed in this frame, and those held, each pressed without modifiers: Ctrl+S must
/// not walk, whichever of the two keys is released first.
fn walking_keys(ctx: &Context) -> (Vec<Key>, Vec<Key>) {
    let id = Id::new("keys that walk");
    let mut held: Vec<Key> = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    let pressed = ctx.input(|input| {
        let presses = input.events.iter().filter_map(|event| match event {
            Event::Key {
                key,
                pressed: true,
                repeat: false,
                modifiers,
                ..
            } if modifiers.is_none() => Some(*key),
            _ => None,
        });
        let pressed: Vec<Key> = presses.collect();
        held.extend(&pressed);
        held.retain(|&key| input.key_down(key));
        pressed
    });
    ctx.data_mut(|data| data.insert_temp(id, held.clone()));
    (pressed, held)
}
