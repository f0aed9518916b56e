use super::Navigation;
use crate::character::Skinning;
use crate::editor::Tool;
use crate::geometry::Basis;
use crate::scene::{CurveSet, CurveShape, Look, Shading, ShapeKind, ViewDirection};
use egui::{Context, Event, Key, KeyboardShortcut, Modifiers, ThemePreference};

/// Everything that a menu item or a key can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Opens the dialog for a picture of the view.
    Screenshot,
    /// Writes the selected curves into a file.
    ExportCurve,
    /// Writes the geometry of the scene into a file.
    ExportGeometry,
    /// Closes what is open, else ends the program.
    Quit,
    /// Adds a shape.
    Insert(Primitive),
    /// Adds a shape from a file.
    ImportShape,
    /// Adds curves from a file.
    ImportCurve,
    /// Adds a character from its files.
    ImportCharacter,
    /// Turns a curve of the selected shape about +Y.
    MakeSurfaceOfRevolution,
    /// Carries one curve of the selected shape along another.
    MakeSweep,
    /// Takes the selected shape away.
    Delete,
    /// Puts the selected shape back to how it started.
    Reset,
    /// Hides the selected shape in the view, or shows it.
    ToggleVisible,
    /// Locks the selected shape in the view, or unlocks it.
    ToggleLocked,
    /// One of the six views.
    ViewFrom(ViewDirection),
    /// The course's first view.
    ResetCamera,
    /// Fills the view with the selected shape.
    Fit,
    /// Shows or hides the axes.
    ToggleAxis,
    /// Shows or hides the grid on the ground.
    ToggleGrid,
    /// Chooses light and background.
    SetLook(Look),
    /// Chooses the normals to light surfaces with.
    SetShading(Shading),
    /// Chooses the colors of the panels.
    SetTheme(ThemePreference),
    /// Chooses how mouse and keys move the camera.
    SetNavigation(Navigation),
    /// Puts a scene from inside the program in the place of the one that is open.
    OpenScene(&'static str),
    /// Puts the camera and all poses back to where they started.
    ResetViewAndPose,
    /// Chooses a picture to compare the view with.
    Compare,
    /// Chooses what deforms characters; whatever suits the driver if `None`.
    SetSkinning(Option<Skinning>),
    /// Chooses what a left drag in the view does.
    SetTool(Tool),
    /// Shows gizmos along the axes of the joint or shape, or of the world.
    ToggleLocalAxes,
    /// Puts the selected joint back to rest.
    ResetJoint,
    /// Puts every joint of the selected character back to rest.
    ResetPose,
    /// Exchanges left and right in the pose of the selected character.
    MirrorPose,
    /// Puts the pose of the selected character on the clipboard.
    CopyPose,
    /// Gives the selected character the pose on the clipboard.
    PastePose,
    /// Keeps the pose with the selected character.
    KeepPose,
    /// Writes the pose of the selected character to a file.
    SavePose,
    /// Gives the selected character the pose of a file.
    LoadPose,
    /// Pins a joint for the IK tool, or lets go of it.
    PinJoint,
    /// Lets go of all pinned joints.
    UnpinAll,
    /// Opens the list of keys and gestures.
    Keys,
    /// Opens the history of messages.
    Messages,
    /// Opens the window about the program.
    About,
}

/// The shapes and curves of the Insert menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primitive {
    /// See [`ShapeKind::Cube`].
    Cube,
    /// See [`ShapeKind::Sphere`].
    Sphere,
    /// See [`ShapeKind::Pyramid`].
    Pyramid,
    /// See [`ShapeKind::Teapot`].
    Teapot,
    /// See [`ShapeKind::Icosahedron`].
    Icosahedron,
    /// See [`ShapeKind::Custom`].
    Custom,
    /// See [`CurveSet::start_spline`].
    BezierCurve,
    /// See [`CurveSet::start_spline`].
    BSplineCurve,
    /// See [`CurveSet::start_circle`].
    Circle,
}

impl Primitive {
    /// The shape itself.
    pub fn kind(self) -> ShapeKind {
        match self {
            Self::Cube => ShapeKind::Cube,
            Self::Sphere => ShapeKind::Sphere,
            Self::Pyramid => ShapeKind::Pyramid,
            Self::Teapot => ShapeKind::Teapot,
            Self::Icosahedron => ShapeKind::Icosahedron,
            Self::Custom => ShapeKind::Custom,
            Self::BezierCurve => curve(CurveSet::start_spline(Basis::Bezier)),
            Self::BSplineCurve => curve(CurveSet::start_spline(Basis::BSpline)),
            Self::Circle => curve(CurveSet::start_circle()),
        }
    }
}

fn curve(set: CurveSet) -> ShapeKind {
    ShapeKind::Curve(CurveShape::new(set))
}

/// The menu, or the part of one between two lines, that a command is listed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// File.
    File,
    /// File ▸ Built-in Scene.
    Scenes,
    /// Insert, first part.
    Insert,
    /// Insert, the part with curves.
    Curves,
    /// Insert ▸ Import.
    Import,
    /// View, first part.
    View,
    /// View ▸ Look.
    Look,
    /// View ▸ Shading.
    Shading,
    /// View, last part.
    Ground,
    /// View, the line about comparing.
    Compare,
    /// View ▸ Navigation.
    Navigation,
    /// View ▸ Theme.
    Theme,
    /// View ▸ Skinning.
    Skinning,
    /// Pose, the tools.
    Tools,
    /// Pose, the part about the whole pose.
    Pose,
    /// Help.
    Help,
    /// The shape panel's buttons, and the signs in its list.
    Shape,
}

impl Menu {
    /// All, in the order of the window about the keys.
    pub const ALL: &[Self] = &[
        Self::File,
        Self::Scenes,
        Self::Insert,
        Self::Curves,
        Self::Import,
        Self::Shape,
        Self::View,
        Self::Look,
        Self::Shading,
        Self::Ground,
        Self::Compare,
        Self::Navigation,
        Self::Theme,
        Self::Skinning,
        Self::Tools,
        Self::Pose,
        Self::Help,
    ];
}

/// One line of the table of commands.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What it starts.
    pub command: Command,
    /// Where it is listed.
    pub menu: Menu,
    /// What menus call it.
    pub label: &'static str,
    /// What the tooltip says.
    pub tooltip: &'static str,
    /// Keys that start it; menus show the first.
    pub shortcuts: &'static [KeyboardShortcut],
    /// The one way of navigation in which its keys are those; they come before the others' then.
    pub only_in: Option<Navigation>,
}

const fn key(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL: Modifiers = Modifiers::COMMAND;

const fn entry(
    command: Command,
    menu: Menu,
    label: &'static str,
    tooltip: &'static str,
    shortcuts: &'static [KeyboardShortcut],
) -> Entry {
    Entry {
        command,
        menu,
        label,
        tooltip,
        shortcuts,
        only_in: None,
    }
}

/// A command with keys that it has in one way of navigation alone.
const fn only_in(navigation: Navigation, entry: Entry) -> Entry {
    Entry {
        only_in: Some(navigation),
        ..entry
    }
}

/// All commands: the one table behind key handling, menus, tooltips and Help ▸ Keys and Mouse.
#[rustfmt::skip]
pub const COMMANDS: &[Entry] = &[
    entry(Command::Screenshot, Menu::File, "Screenshot…", "Save the view as PNG, JPEG or GIF", &[key(NONE, Key::F12)]),
    entry(Command::ExportCurve, Menu::File, "Export Curve…", "Write the curves of the selected shape as .swp", &[key(CTRL, Key::E)]),
    entry(Command::ExportGeometry, Menu::File, "Export Geometry…", "Write the geometry of the whole scene, as posed, as .obj", &[key(CTRL.plus(SHIFT), Key::E)]),
    entry(Command::OpenScene("showcase"), Menu::Scenes, "Showcase", "A man, a robot and a dog", &[]),
    entry(Command::OpenScene("turned"), Menu::Scenes, "Turned", "A vase, a goblet, a pawn and a knot, swept from curves", &[]),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-1"), Menu::Scenes, "Column", "Two bones in a column of cubes", &[key(NONE, Key::Num1)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-2"), Menu::Scenes, "Chain", "Boxes in a row, joined by springs", &[key(NONE, Key::Num2)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-3"), Menu::Scenes, "Tentacle", "Bends softly: five and more joints move each point", &[key(NONE, Key::Num3)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-4"), Menu::Scenes, "Crate and Lizard", "A chest with a picture on it, and a lizard that Blender wrote", &[key(NONE, Key::Num4)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-5"), Menu::Scenes, "Humanoid", "A man with all his fingers", &[key(NONE, Key::Num5)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-6"), Menu::Scenes, "Face", "A head with jaw, eyes and brows", &[key(NONE, Key::Num6)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-7"), Menu::Scenes, "Creature", "A body and two hands that nothing joins", &[key(NONE, Key::Num7)])),
    entry(Command::Quit, Menu::File, "Quit", "Close an open dialog, else end a comparison, else end the program", &[key(NONE, Key::Escape)]),

    entry(Command::Insert(Primitive::Cube), Menu::Insert, "Cube", "Add a cube at the origin", &[key(SHIFT, Key::C)]),
    entry(Command::Insert(Primitive::Sphere), Menu::Insert, "Sphere", "Add a sphere at the origin", &[key(SHIFT, Key::S)]),
    entry(Command::Insert(Primitive::Pyramid), Menu::Insert, "Pyramid", "Add a pyramid at the origin", &[key(SHIFT, Key::P)]),
    entry(Command::Insert(Primitive::Teapot), Menu::Insert, "Teapot", "Add the Utah teapot at the origin", &[key(SHIFT, Key::T)]),
    entry(Command::Insert(Primitive::Icosahedron), Menu::Insert, "Icosahedron", "Add an icosahedron at the origin", &[key(SHIFT, Key::I)]),
    entry(Command::Insert(Primitive::Custom), Menu::Insert, "Custom Shape", "Add the shape that custom.rs makes", &[key(SHIFT, Key::U)]),
    entry(Command::Insert(Primitive::BezierCurve), Menu::Curves, "Bézier Curve", "Add a Bézier curve of four control points to drag into shape", &[key(SHIFT, Key::B)]),
    entry(Command::Insert(Primitive::BSplineCurve), Menu::Curves, "B-Spline Curve", "Add a B-spline of four control points to drag into shape", &[key(SHIFT, Key::N)]),
    entry(Command::Insert(Primitive::Circle), Menu::Curves, "Circle", "Add a circle of radius 1, to sweep or to sweep along", &[key(SHIFT, Key::O)]),
    entry(Command::MakeSurfaceOfRevolution, Menu::Curves, "Surface of Revolution from Curve", "Turn the last flat curve of the selected shape about the Y axis", &[key(SHIFT, Key::V)]),
    entry(Command::MakeSweep, Menu::Curves, "Sweep from Curves", "Carry the first flat curve of the selected shape along another; a tube where there is only one", &[key(SHIFT, Key::W)]),
    entry(Command::ImportShape, Menu::Import, "Import Shape", "Add a shape from an .obj or .dae file", &[key(CTRL, Key::I)]),
    entry(Command::ImportCurve, Menu::Import, "Import Curve", "Add curves and surfaces from a .swp file", &[key(CTRL.plus(Modifiers::ALT), Key::I)]),
    entry(Command::ImportCharacter, Menu::Import, "Import Character", "Add a character from a .dae file, or from .obj, .skel and .attach files of one name", &[key(CTRL.plus(SHIFT), Key::I)]),

    entry(Command::Delete, Menu::Shape, "Delete", "Take the selected shape away", &[key(NONE, Key::Delete)]),
    entry(Command::Reset, Menu::Shape, "Reset", "Put position, scale, rotation, color and joint angles back to the start", &[key(SHIFT, Key::R)]),
    entry(Command::ToggleVisible, Menu::Shape, "Hide or Show", "Hide the selected shape in the view, or show it again; exports have it all the same", &[key(NONE, Key::H)]),
    entry(Command::ToggleLocked, Menu::Shape, "Lock or Unlock", "Keep the selected shape from being clicked, posed and moved in the view, or let it be", &[key(SHIFT, Key::L)]),

    entry(Command::ViewFrom(ViewDirection::PlusX), Menu::View, "View from +X", "Look at the origin from +X", &[key(NONE, Key::Num3)]),
    entry(Command::ViewFrom(ViewDirection::MinusX), Menu::View, "View from -X", "Look at the origin from -X", &[key(CTRL, Key::Num3)]),
    entry(Command::ViewFrom(ViewDirection::PlusY), Menu::View, "View from +Y", "Look at the origin from above", &[key(NONE, Key::Num7)]),
    entry(Command::ViewFrom(ViewDirection::MinusY), Menu::View, "View from -Y", "Look at the origin from below", &[key(CTRL, Key::Num7)]),
    entry(Command::ViewFrom(ViewDirection::PlusZ), Menu::View, "View from +Z", "Look at the origin from +Z", &[key(NONE, Key::Num1)]),
    entry(Command::ViewFrom(ViewDirection::MinusZ), Menu::View, "View from -Z", "Look at the origin from -Z", &[key(CTRL, Key::Num1)]),
    entry(Command::ResetCamera, Menu::View, "Reset to Default Camera View", "Put the camera back to where it started", &[key(NONE, Key::Home)]),
    only_in(Navigation::Mannequin, entry(Command::ResetViewAndPose, Menu::View, "Reset View and Pose", "Put the camera back to where it started, and every character to rest", &[key(NONE, Key::R)])),
    entry(Command::Fit, Menu::View, "Fit to View", "Fill the view with the selected shape, or with everything if none is", &[key(NONE, Key::F)]),
    entry(Command::ToggleAxis, Menu::View, "Toggle Axis", "Show or hide the lines of X (red), Y (green) and Z (blue)", &[key(NONE, Key::T)]),
    entry(Command::Compare, Menu::Compare, "Compare with Picture…", "Show a picture, such as the sample solution's, beside the view and measure the differences", &[key(NONE, Key::F8)]),
    entry(Command::SetLook(Look::Course), Menu::Look, "Course", "The course's light and background, for pictures that are compared", &[key(NONE, Key::F2)]),
    entry(Command::SetLook(Look::Studio), Menu::Look, "Studio", "Key, fill and rim light, with a grid and shadows on the ground", &[key(NONE, Key::F3)]),
    entry(Command::SetLook(Look::Mannequin), Menu::Look, "Mannequin Look", "The Virtual Mannequin's: surfaces in the colors of their normals, red bones, a checkered floor", &[key(NONE, Key::F10)]),
    entry(Command::SetShading(Shading::AsAuthored), Menu::Shading, "As authored", "The normals that each mesh brings; facetted where it has none", &[key(NONE, Key::F5)]),
    entry(Command::SetShading(Shading::Flat), Menu::Shading, "Flat", "One normal a triangle", &[key(NONE, Key::F6)]),
    entry(Command::SetShading(Shading::Smooth), Menu::Shading, "Smooth", "One normal a vertex, the mean of the triangles around it", &[key(NONE, Key::F7)]),
    entry(Command::ToggleGrid, Menu::Ground, "Ground Grid", "Show or hide the grid on the ground", &[key(NONE, Key::F4)]),
    entry(Command::SetNavigation(Navigation::Course), Menu::Navigation, "As the course's editor", "Left drag moves the scene, right drag turns it", &[]),
    entry(Command::SetNavigation(Navigation::Orbit), Menu::Navigation, "Orbit", "As three.js has it: left drag turns the scene, right or middle drag moves it", &[]),
    entry(Command::SetNavigation(Navigation::Mannequin), Menu::Navigation, "Mannequin", "As in the Virtual Mannequin: left drag turns, right drag zooms, W S A D and arrows walk, 1 to 7 open its scenes", &[]),
    entry(Command::SetNavigation(Navigation::Blender), Menu::Navigation, "Blender", "Middle drag turns the scene, with Shift it moves it, with Ctrl it zooms", &[]),
    entry(Command::SetTheme(ThemePreference::System), Menu::Theme, "System", "Dark or light, as the desktop has it", &[]),
    entry(Command::SetTheme(ThemePreference::Dark), Menu::Theme, "Dark", "Light text on dark panels", &[]),
    entry(Command::SetTheme(ThemePreference::Light), Menu::Theme, "Light", "Dark text on light panels", &[]),
    entry(Command::SetSkinning(None), Menu::Skinning, "Automatic", "The graphics card deforms characters where there is one", &[]),
    entry(Command::SetSkinning(Some(Skinning::Cpu)), Menu::Skinning, "Processor", "The processor deforms characters and hands their vertices over", &[]),
    entry(Command::SetSkinning(Some(Skinning::Gpu)), Menu::Skinning, "Graphics Card", "The graphics card deforms characters in a vertex shader", &[]),

    entry(Command::SetTool(Tool::Select), Menu::Tools, "Select tool", "Click selects, left drag moves the scene", &[key(NONE, Key::V)]),
    entry(Command::SetTool(Tool::Pose), Menu::Tools, "Pose tool", "Left drag turns the bone under the pointer, Left and Right roll it", &[key(NONE, Key::B)]),
    entry(Command::SetTool(Tool::Move), Menu::Tools, "Move tool", "Left drag moves the root of the bone under the pointer, else the shape", &[key(NONE, Key::G)]),
    entry(Command::SetTool(Tool::Ik), Menu::Tools, "IK tool", "Left drag brings the end of the bone under the pointer somewhere: hand, foot or root; a chain of joints follows", &[key(NONE, Key::I)]),
    entry(Command::ToggleLocalAxes, Menu::Tools, "Local axes", "Turn and move along the axes of the joint or shape instead of the world's", &[key(NONE, Key::L)]),
    entry(Command::PinJoint, Menu::Tools, "Pin joint", "Hold the joint under the pointer, or the selected one, where it is while the IK tool drags others", &[key(NONE, Key::P)]),
    entry(Command::UnpinAll, Menu::Tools, "Unpin all joints", "Let go of every pinned joint", &[key(ALT, Key::P)]),

    entry(Command::ResetJoint, Menu::Pose, "Reset Joint", "Put the selected joint back to rest", &[key(ALT, Key::R)]),
    entry(Command::ResetPose, Menu::Pose, "Reset Pose", "Put every joint of the selected character back to rest", &[key(ALT.plus(SHIFT), Key::R)]),
    entry(Command::MirrorPose, Menu::Pose, "Mirror Pose", "Exchange left and right, which are found by the joints' names or else by their places", &[key(NONE, Key::M)]),
    entry(Command::CopyPose, Menu::Pose, "Copy Pose", "Put the pose on the clipboard, as the text of a pose file", &[key(CTRL, Key::C)]),
    entry(Command::PastePose, Menu::Pose, "Paste Pose", "Take on the pose on the clipboard", &[key(CTRL, Key::V)]),
    entry(Command::KeepPose, Menu::Pose, "Keep Pose", "Keep the pose in the character's list of poses", &[key(CTRL, Key::K)]),
    entry(Command::SavePose, Menu::Pose, "Save Pose…", "Write the pose as a .json file", &[key(CTRL, Key::P)]),
    entry(Command::LoadPose, Menu::Pose, "Load Pose…", "Take on the pose of a .json file", &[key(CTRL.plus(SHIFT), Key::P)]),

    entry(Command::Keys, Menu::Help, "Keys and Mouse", "Every key and every gesture", &[key(NONE, Key::Questionmark), key(NONE, Key::F1)]),
    entry(Command::Messages, Menu::Help, "Messages", "Everything the program has told since it started", &[key(NONE, Key::F9)]),
    entry(Command::About, Menu::Help, "About", "Version, license, and what it runs on", &[]),
];

/// A gesture of the mouse, for the window about the keys.
#[derive(Clone, Copy, Debug)]
pub struct Gesture {
    /// What the hand does.
    pub gesture: &'static str,
    /// What happens.
    pub does: &'static str,
}

pub(super) const fn gesture(gesture: &'static str, does: &'static str) -> Gesture {
    Gesture { gesture, does }
}

/// Gestures in the view other than those that move the camera ([`Navigation`]'s), then in the
/// panels.
pub const GESTURES: &[Gesture] = &[
    gesture("Click in the view", "Select the shape under the pointer"),
    gesture(
        "Drag a control point",
        "Move it; Esc or right click cancels",
    ),
    gesture("Wheel in the view", "Move the camera closer or away"),
    gesture("Pose: drag a bone", "Turn it, with Ctrl by 15°"),
    gesture("Pose: Left, Right", "Roll the bone under the pointer"),
    gesture("Pose: click a bone", "Show rings that turn it"),
    gesture("Move: drag a bone", "Move its root, with Shift every root"),
    gesture("Move: drag a shape", "Move it, with Ctrl by 0.1"),
    gesture("Esc, right click in a drag", "Put everything back"),
    gesture("Click the axis ball", "Look from the side that was clicked"),
    gesture(
        "Drag a number",
        "Change it; Shift is finer, Ctrl is coarser",
    ),
    gesture("Click a number", "Type a value or a sum such as 45/2"),
    gesture("Right click a number", "Put it back to where it started"),
    gesture("Up, Down in a list", "Choose the row above or below"),
    gesture("Left, Right in the joint list", "Fold or unfold a joint"),
    gesture("Ctrl and +, −, 0", "Larger, smaller, normal text"),
];

/// The table's entries for one menu, in order.
pub(super) fn entries(menu: Menu) -> impl Iterator<Item = &'static Entry> {
    COMMANDS.iter().filter(move |entry| entry.menu == menu)
}

impl Entry {
    /// The keys that start it in a way of navigation, whose own come before the others'.
    fn shortcuts_in(
        &self,
        navigation: Navigation,
    ) -> impl Iterator<Item = &'static KeyboardShortcut> {
        let means_another = move |shortcut: &&KeyboardShortcut| match self.only_in {
            Some(only) => only != navigation,
            None => COMMANDS.iter().any(|other| {
                other.only_in == Some(navigation) && other.shortcuts.contains(shortcut)
            }),
        };
        self.shortcuts
            .iter()
            .filter(move |shortcut| !means_another(shortcut))
    }

    /// All those keys, as the window about the keys shows them; empty where there are none.
    pub(super) fn keys(&self, ctx: &Context, navigation: Navigation) -> String {
        let keys: Vec<String> = self
            .shortcuts_in(navigation)
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .collect();
        keys.join(", ")
    }

    /// The first of them, for a menu.
    pub(super) fn first_key(&self, ctx: &Context, navigation: Navigation) -> String {
        self.shortcuts_in(navigation)
            .next()
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .unwrap_or_default()
    }

    fn with_key(&self, ctx: &Context, words: &str) -> String {
        match self.first_key(ctx, Navigation::default()) {
            key if key.is_empty() => words.to_owned(),
            key => format!("{words} ({key})"),
        }
    }
}

/// `Esc` and `?` are what keyboards have on them.
fn short(shortcut: &str) -> String {
    shortcut
        .replace("Escape", "Esc")
        .replace("Questionmark", "?")
}

/// What menus call `command`.
pub(super) fn label(command: Command) -> &'static str {
    COMMANDS
        .iter()
        .find(|entry| entry.command == command)
        .map_or("", |entry| entry.label)
}

/// The tooltip of `command`, with its key, one that no way of navigation uses otherwise.
pub(super) fn tooltip(ctx: &Context, command: Command) -> String {
    COMMANDS
        .iter()
        .find(|entry| entry.command == command)
        .map(|entry| entry.with_key(ctx, entry.tooltip))
        .unwrap_or_default()
}

/// Other words for what `command` does, with its key as in [`tooltip`].
pub(super) fn with_key(ctx: &Context, command: Command, words: &str) -> String {
    COMMANDS
        .iter()
        .find(|entry| entry.command == command)
        .map(|entry| entry.with_key(ctx, words))
        .unwrap_or_default()
}

/// Takes the pressed keys of the table out of this frame's input and returns what they start.
pub(super) fn pressed(ctx: &Context, navigation: Navigation) -> Vec<Command> {
    ctx.input_mut(|input| {
        let mut commands = Vec::new();
        let held = input.pointer.any_down();
        input.events.retain(|event| {
            let (modifiers, key) = match event {
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } => (*modifiers, *key),
                // These two keys arrive as what they mean.
                Event::Copy => (CTRL, Key::C),
                Event::Paste(_) => (CTRL, Key::V),
                _ => return true,
            };
            let hit = command_of(modifiers, key, navigation)
                // Esc with something in the hand is meant for that, and ends nothing else.
                .filter(|&command| !(held && command == Command::Quit));
            commands.extend(hit);
            hit.is_none()
        });
        commands
    })
}

fn command_of(modifiers: Modifiers, key: Key, navigation: Navigation) -> Option<Command> {
    // Where the question mark lies, and with which modifiers, differs between keyboards.
    let modifiers = if key == Key::Questionmark {
        Modifiers::NONE
    } else {
        modifiers
    };
    let has_key = |entry: &&Entry| {
        entry.shortcuts_in(navigation).any(|shortcut| {
            shortcut.logical_key == key && modifiers.matches_exact(shortcut.modifiers)
        })
    };
    let entry = COMMANDS.iter().find(has_key);
    entry.map(|entry| entry.command)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_share_a_key_or_a_label() {
        for (i, one) in COMMANDS.iter().enumerate() {
            for other in &COMMANDS[i + 1..] {
                assert_ne!(one.label, other.label);
                if one.only_in != other.only_in {
                    continue;
                }
                for shortcut in one.shortcuts {
                    assert!(
                        !other.shortcuts.contains(shortcut),
                        "{} and {}",
                        one.label,
                        other.label
                    );
                }
            }
        }
    }

    #[test]
    fn a_key_means_another_command_with_shift() {
        assert_eq!(
            command_of(NONE, Key::T, Navigation::Course),
            Some(Command::ToggleAxis)
        );
        assert_eq!(
            command_of(SHIFT, Key::T, Navigation::Blender),
            Some(Command::Insert(Primitive::Teapot))
        );
        assert_eq!(
            command_of(Modifiers::CTRL, Key::T, Navigation::Course),
            None
        );
    }

    #[test]
    fn the_question_mark_counts_wherever_a_keyboard_has_it() {
        assert_eq!(
            command_of(SHIFT, Key::Questionmark, Navigation::Orbit),
            Some(Command::Keys)
        );
        assert_eq!(
            command_of(NONE, Key::Questionmark, Navigation::Orbit),
            Some(Command::Keys)
        );
    }

    #[test]
    fn every_command_is_in_a_menu_and_explained() {
        for entry in COMMANDS {
            assert!(Menu::ALL.contains(&entry.menu), "{}", entry.label);
            assert!(!entry.tooltip.is_empty(), "{}", entry.label);
        }
    }

    #[test]
    fn the_fonts_have_every_sign_that_the_panels_show() {
        let ctx = Context::default();
        let output = ctx.run_ui(egui::RawInput::default(), |ui| {
            let mut shown = "⊗⚠ℹ×🔍↺⏵⏷✔·°…⏵".to_owned();
            for gesture in GESTURES {
                shown += gesture.gesture;
                shown += gesture.does;
            }
            for entry in COMMANDS {
                shown += entry.label;
                shown += entry.tooltip;
                shown += &entry.keys(ui.ctx(), Navigation::Course);
            }
            let drawn = |sign: char| {
                let font = egui::FontId::proportional(14.0);
                let painter = ui.painter();
                let galley = painter.layout_no_wrap(sign.into(), font, egui::Color32::WHITE);
                galley.rows[0].glyphs[0].uv_rect
            };
            let unknown = drawn('\u{10fffe}');
            for sign in shown.chars().filter(|sign| !sign.is_whitespace()) {
                assert_ne!(drawn(sign), unknown, "no glyph for {sign}");
            }
        });
        output.drop_without_applying_deltas();
    }
}
