//! Keys that mean something in Blender which is not here, or goes another way: in its navigation they say so, and start
//! no command.

use egui::{Key, KeyboardShortcut, Modifiers};

const fn key(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Each key with why it does nothing. Those that add a shape in other navigations say how that is done in this one.
#[rustfmt::skip]
pub(super) const NOT_HERE: &[(KeyboardShortcut, &str)] = &[
    (key(NONE, Key::Space), "There is no animation to play: files of poses are opened one pose at a time"),
    (key(NONE, Key::Num0), "No camera stands in the scene: a picture shows what the view shows"),
    (key(NONE, Key::Num5), "The camera is always in perspective: there is no orthographic view"),
    (key(NONE, Key::Slash), "There is no local view: Edit ⏵ Hide Others leaves what is selected, Show All brings the rest back"),
    (key(NONE, Key::Z), "Shading, colors and looks are chosen in View, looks also beside the axes"),
    (key(SHIFT, Key::Z), "There is no wireframe: View ⏵ Shading ⏵ Flat shows the triangles"),
    (key(ALT, Key::Z), "There is no X-ray: Model Display Mode in the panel shows the skeleton in the mesh"),
    (key(NONE, Key::C), "There is no circle to select with: a drag beside all shapes selects with a box"),
    (key(NONE, Key::Backtick), "There is no menu of views: 1, 3 and 7 look from the front, the right and above, with Ctrl from the other side"),
    (key(NONE, Key::OpenBracket), OTHER_JOINTS),
    (key(NONE, Key::CloseBracket), OTHER_JOINTS),
    (key(CTRL, Key::M), "Shapes are not mirrored. M mirrors the pose, Shift+M that of the selected joints onto the other side"),
    (key(SHIFT, Key::R), "Nothing repeats what was done last. Edit ⏵ Reset puts a shape back to the start"),
    (key(SHIFT, Key::S), "There is no Snap menu: Ctrl snaps in a drag. Shift+A adds shapes"),
    (key(SHIFT, Key::B), "There is no zoom into a box: the period key fits what is selected. Shift+A adds curves"),
    (key(SHIFT, Key::N), "Normals are not recalculated. Shift+A adds curves"),
    (key(SHIFT, Key::O), "There is no proportional editing. Shift+A adds curves"),
    (key(SHIFT, Key::I), "Bones take no constraints: the IK tool in Pose bends chains. Shift+A adds shapes"),
    (key(SHIFT, Key::P), ADDS_ELSEWHERE),
    (key(SHIFT, Key::T), ADDS_ELSEWHERE),
    (key(SHIFT, Key::U), ADDS_ELSEWHERE),
];

const OTHER_JOINTS: &str =
    "No key goes to a joint's parent or children: a click selects them, in the view or in the list";
const ADDS_ELSEWHERE: &str = "This key adds no shape in Blender's navigation: Shift+A does";
