//! The table of commands: labels, tooltips, menus and keyboard shortcuts.

use super::{Command, Primitive};
use crate::editor::{Session, Tool, selected_roots};
use crate::scene::{Look, Shading, Skinning, ViewDirection};
use crate::ui::{MeshColors, Navigation};
use egui::{Key, KeyboardShortcut, Modifiers, ThemePreference};

/// Menu of a command, or the part of a menu between two separators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// File, the part about the document.
    Document,
    /// File, the part about other files.
    File,
    /// File ▸ Built-in Scene.
    Scenes,
    /// Edit, the part about the history.
    Edit,
    /// Edit, the part about the clipboard and the selection.
    Clipboard,
    /// Edit, last part.
    Preferences,
    /// Insert, first part.
    Insert,
    /// Insert, the part with curves.
    Curves,
    /// Insert ▸ Import.
    Import,
    /// View, first part.
    View,
    /// View ▸ View from.
    Directions,
    /// View ▸ Look.
    Look,
    /// View ▸ Shading.
    Shading,
    /// View ▸ Colors.
    Colors,
    /// View, last part.
    Ground,
    /// View, the part about comparing.
    Compare,
    /// View, the part about explaining.
    Explain,
    /// View ▸ Navigation.
    Navigation,
    /// View ▸ Theme.
    Theme,
    /// View ▸ Skinning.
    Skinning,
    /// Pose, the tools.
    Tools,
    /// Pose, what acts on the whole pose.
    Pose,
    /// Help.
    Help,
    /// Edit ▸ Reset Transform.
    Transform,
    /// Edit, the part about the selected shape; buttons of the shape panel, and icons in its list.
    Shape,
}

impl Menu {
    /// All menus, in the order of Help ▸ Keys and Mouse.
    pub const ALL: &[Self] = &[
        Self::Document,
        Self::File,
        Self::Scenes,
        Self::Edit,
        Self::Clipboard,
        Self::Insert,
        Self::Curves,
        Self::Import,
        Self::Shape,
        Self::Transform,
        Self::Preferences,
        Self::View,
        Self::Directions,
        Self::Look,
        Self::Shading,
        Self::Colors,
        Self::Ground,
        Self::Compare,
        Self::Explain,
        Self::Navigation,
        Self::Theme,
        Self::Skinning,
        Self::Tools,
        Self::Pose,
        Self::Help,
    ];
}

/// One row of the table of commands.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Command that it starts.
    pub command: Command,
    /// Menu that lists it.
    pub menu: Menu,
    /// Label in the menu.
    pub label: &'static str,
    /// Text of the tooltip.
    pub tooltip: &'static str,
    /// Keyboard shortcuts; menus show the first.
    pub shortcuts: &'static [KeyboardShortcut],
    /// The only navigation in which its shortcuts work; there they take precedence over others.
    pub only_in: Option<Navigation>,
    /// Words by which other programs know it, for Help ▸ Find Command, that its label lacks.
    pub also: &'static str,
}

impl Entry {
    const fn also(self, also: &'static str) -> Self {
        Self { also, ..self }
    }
}

const fn key(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

pub(super) const NONE: Modifiers = Modifiers::NONE;
pub(super) const SHIFT: Modifiers = Modifiers::SHIFT;
pub(super) const ALT: Modifiers = Modifiers::ALT;
pub(super) const CTRL: Modifiers = Modifiers::COMMAND;

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
        also: "",
    }
}

/// A command whose shortcuts work in one navigation only.
const fn only_in(navigation: Navigation, entry: Entry) -> Entry {
    Entry {
        only_in: Some(navigation),
        ..entry
    }
}

/// All commands: the one table behind key handling, menus, tooltips and Help ▸ Keys and Mouse.
#[rustfmt::skip]
pub const COMMANDS: &[Entry] = &[
    entry(Command::New, Menu::Document, "New", "Begin an empty document", &[key(CTRL, Key::N)]).also("blank clear empty start"),
    entry(Command::Open, Menu::Document, "Open…", "Open a scene, or a model as a new document", &[key(CTRL, Key::O)]).also("load import file"),
    entry(Command::Save, Menu::Document, "Save", "Save the document; the version before stays beside it, as NAME~", &[key(CTRL, Key::S)]).also("store write"),
    entry(Command::SaveAs, Menu::Document, "Save As…", "Save the document to another file", &[key(CTRL.plus(SHIFT), Key::S)]).also("store write copy"),
    entry(Command::CopyLink, Menu::Document, "Copy Link to This Scene", "Put an address on the clipboard that shows this scene to everybody who opens it", &[]).also("share url"),
    entry(Command::SaveWithFiles, Menu::Document, "Save with Files…", "Write the document and all files that it needs, as a .zip archive or a scene with a folder, to be opened on another machine", &[]).also("pack bundle collect share export"),
    entry(Command::Revert, Menu::Document, "Revert", "Open the document's file again, as it is now", &[]).also("discard restore reset"),
    entry(Command::Reload, Menu::Document, "Reload Models", "Read the files that shapes came from again, where other programs have changed them; poses and places stay", &[key(CTRL, Key::R)]).also("refresh update"),
    entry(Command::Screenshot, Menu::File, "Screenshot…", "Save the view as a picture, or a turntable as an animated GIF", &[key(NONE, Key::F12)]).also("image photo render capture transparent export png jpg animation video submission submit hand in homework"),
    entry(Command::ExportCurve, Menu::File, "Export Curve…", "Write the curves of the selected shape as .swp", &[key(CTRL, Key::E)]).also("save swp"),
    entry(Command::ExportGeometry, Menu::File, "Export Geometry…", "Write the geometry of all shapes, as posed, as .obj, whatever is selected", &[key(CTRL.plus(SHIFT), Key::E)]).also("save mesh model obj"),
    entry(Command::ExportSelected, Menu::File, "Export Selected Geometry…", "Write the geometry of the selected shapes alone, as posed, as .obj", &[]).also("save mesh model obj only selection"),
    entry(Command::ExportMaterials, Menu::File, "Export with Materials…", "Write the geometry of all shapes, as posed, as .obj with its colors and pictures beside it", &[]).also("save mesh model textures mtl"),
    entry(Command::ExportCharacter, Menu::File, "Export Character…", "Write the selected character as .skel, with .attach, .obj and its pose beside it", &[]).also("save rig skeleton weights skin"),
    entry(Command::OpenScene("showcase"), Menu::Scenes, "Showcase", "A man, a robot and a dog", &[]).also("example demo sample"),
    entry(Command::OpenScene("turned"), Menu::Scenes, "Turned", "A vase, a goblet, a pawn and a knot, swept from curves", &[]).also("example demo sample"),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-1"), Menu::Scenes, "Mannequin 1: Column", "Two bones in a column of cubes", &[key(NONE, Key::Num1)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-2"), Menu::Scenes, "Mannequin 2: Chain", "Boxes in a row, joined by springs", &[key(NONE, Key::Num2)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-3"), Menu::Scenes, "Mannequin 3: Tentacle", "Bends softly: five and more joints move each point", &[key(NONE, Key::Num3)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-4"), Menu::Scenes, "Mannequin 4: Crate and Lizard", "A chest with a picture on it, and a lizard that Blender wrote", &[key(NONE, Key::Num4)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-5"), Menu::Scenes, "Mannequin 5: Humanoid", "A man with all his fingers", &[key(NONE, Key::Num5)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-6"), Menu::Scenes, "Mannequin 6: Face", "A head with jaw, eyes and brows", &[key(NONE, Key::Num6)])),
    only_in(Navigation::Mannequin, entry(Command::OpenScene("mannequin-7"), Menu::Scenes, "Mannequin 7: Creature", "A body and two hands that nothing joins", &[key(NONE, Key::Num7)])),
    entry(Command::Quit, Menu::File, "Quit", "Close an open dialog, else give up an import or other work that shows its progress, else end a comparison, else deselect the joint or the shape, else, pressed twice, end the program; Ctrl+Q ends it at once", &[key(CTRL, Key::Q), key(NONE, Key::Escape)]).also("exit close"),

    entry(Command::Undo, Menu::Edit, "Undo", "Take back the last step; in the middle of a drag, all of the drag", &[key(CTRL, Key::Z)]).also("back"),
    entry(Command::Redo, Menu::Edit, "Redo", "Do the step again that was taken back last", &[key(CTRL.plus(SHIFT), Key::Z), key(CTRL, Key::Y)]).also("again repeat forward"),
    entry(Command::History, Menu::Edit, "History", "Every step since the document was opened; a click goes back or forward to it", &[]).also("undo"),

    entry(Command::Preferences, Menu::Preferences, "Preferences…", "Theme, look of new views, navigation and whatever else is kept from one run to the next", &[key(CTRL, Key::Comma)]).also("settings options configuration"),

    entry(Command::Cut, Menu::Clipboard, "Cut", "Copy the selected shapes to the clipboard, and delete them", &[key(CTRL, Key::X)]),
    entry(Command::Copy, Menu::Clipboard, "Copy", "Copy the selected shapes to the clipboard, as text; with the Pose and IK tools, the pose", &[key(CTRL, Key::C)]),
    entry(Command::Paste, Menu::Clipboard, "Paste", "Add the shapes on the clipboard, or apply the pose on it to the selected character", &[key(CTRL, Key::V)]),
    entry(Command::Duplicate, Menu::Clipboard, "Duplicate", "Add copies of the selected shapes beside them", &[key(CTRL, Key::D)]).also("clone"),
    entry(Command::SelectAll, Menu::Clipboard, "Select All", "Select every shape that is shown, or while a figure is posed its joints; Ctrl and Shift with a click select several", &[key(CTRL, Key::A)]),
    entry(Command::SelectNone, Menu::Clipboard, "Select None", "Deselect every shape, or while a figure is posed its joints", &[key(CTRL.plus(SHIFT), Key::A)]).also("unselect deselect clear"),
    entry(Command::InvertSelection, Menu::Clipboard, "Invert Selection", "Select the shapes that are shown and not selected, instead of those that are, or while a figure is posed its joints", &[]).also("inverse others"),
    entry(Command::BoxSelect, Menu::Clipboard, "Box Select", "Draw a box with the next left drag in the view: shapes of which any part is in it are selected; Shift adds them, Ctrl takes them out", &[key(NONE, Key::Q)]).also("marquee rectangle border lasso"),

    entry(Command::Insert(Primitive::Cube), Menu::Insert, "Cube", "Add a cube at the origin, or beside the characters that are there", &[key(SHIFT, Key::C)]).also("box"),
    entry(Command::Insert(Primitive::Sphere), Menu::Insert, "Sphere", "Add a sphere at the origin, or beside the characters that are there", &[key(SHIFT, Key::S)]).also("ball"),
    entry(Command::Insert(Primitive::Pyramid), Menu::Insert, "Pyramid", "Add a pyramid at the origin, or beside the characters that are there", &[key(SHIFT, Key::P)]),
    entry(Command::Insert(Primitive::Teapot), Menu::Insert, "Teapot", "Add the Utah teapot at the origin, or beside the characters that are there", &[key(SHIFT, Key::T)]),
    entry(Command::Insert(Primitive::Icosahedron), Menu::Insert, "Icosahedron", "Add an icosahedron at the origin, or beside the characters that are there", &[key(SHIFT, Key::I)]),
    entry(Command::Insert(Primitive::Custom), Menu::Insert, "Custom Shape", "Add the shape that custom.rs makes", &[key(SHIFT, Key::U)]),
    entry(Command::InsertMenu, Menu::Insert, "Insert Menu at Pointer", "Open this menu where the pointer is", &[key(SHIFT, Key::A)]).also("add new create"),
    entry(Command::Insert(Primitive::BezierCurve), Menu::Curves, "Bézier Curve", "Add a Bézier curve of four control points to drag into shape", &[key(SHIFT, Key::B)]).also("spline path"),
    entry(Command::Insert(Primitive::BSplineCurve), Menu::Curves, "B-Spline Curve", "Add a B-spline of four control points to drag into shape", &[key(SHIFT, Key::N)]).also("path"),
    entry(Command::Insert(Primitive::Circle), Menu::Curves, "Circle", "Add a circle of radius 1, to sweep or to sweep along", &[key(SHIFT, Key::O)]).also("ring"),
    entry(Command::MakeSurfaceOfRevolution, Menu::Curves, "Surface of Revolution from Curve", "Turn the last flat curve of the selected shape about the Y axis", &[key(SHIFT, Key::V)]).also("lathe revolve spin"),
    entry(Command::MakeSweep, Menu::Curves, "Sweep from Curves", "Carry a flat curve along another: the flat one of two selected shapes, or the one that is not active if both are flat; within one shape the first flat curve; a tube along a curve that is alone", &[key(SHIFT, Key::W)]).also("extrude loft pipe bevel generalized cylinder"),
    entry(Command::ImportShape, Menu::Import, "Import Shape…", "Add a shape from an .obj or .dae file", &[key(CTRL, Key::I)]).also("open load append mesh model"),
    entry(Command::ImportCurve, Menu::Import, "Import Curve…", "Add curves and surfaces from a .swp file", &[key(CTRL.plus(Modifiers::ALT), Key::I)]).also("open load"),
    entry(Command::ImportCharacter, Menu::Import, "Import Character…", "Add a character from a .dae file, or from .obj, .skel and .attach files of one name", &[key(CTRL.plus(SHIFT), Key::I)]).also("open load rig skeleton model"),

    entry(Command::Delete, Menu::Shape, "Delete", "Delete the selected shape", &[key(NONE, Key::Delete)]).also("remove erase point"),
    entry(Command::Reset, Menu::Shape, "Reset", "Put position, scale, rotation, color and joint angles back to the start", &[key(SHIFT, Key::R)]).also("restore default zero transform"),
    only_in(Navigation::Blender, entry(Command::ResetPosition, Menu::Transform, "Reset Position", "Put the selected shapes back to where they started", &[key(ALT, Key::G)])).also("clear location zero origin"),
    only_in(Navigation::Blender, entry(Command::ResetRotation, Menu::Transform, "Reset Rotation", "Turn the selected shapes back to how they started", &[key(ALT, Key::R)])).also("clear zero angle"),
    only_in(Navigation::Blender, entry(Command::ResetScale, Menu::Transform, "Reset Scale", "Make the selected shapes as large again as they started", &[key(ALT, Key::S)])).also("clear size"),
    entry(Command::Rename, Menu::Shape, "Rename", "Type a new name for the selected shape in the list; a double click there does it, too", &[]),
    only_in(Navigation::Blender, entry(Command::Begin(Tool::Move), Menu::Shape, "Move with Pointer", "Move what is selected with the pointer until a click or Enter; X, Y, Z, with Shift the other two axes, and a number can be typed, Esc puts it back", &[key(NONE, Key::G)])).also("translate grab position"),
    only_in(Navigation::Blender, entry(Command::Begin(Tool::Rotate), Menu::Shape, "Rotate with Pointer", "Turn what is selected with the pointer until a click or Enter; X, Y, Z and degrees can be typed, Esc puts it back", &[key(NONE, Key::R)])).also("spin"),
    only_in(Navigation::Blender, entry(Command::Begin(Tool::Scale), Menu::Shape, "Scale with Pointer", "Scale what is selected with the pointer until a click or Enter; X, Y, Z, with Shift the other two axes, and a factor can be typed, Esc puts it back", &[key(NONE, Key::S)])).also("size resize"),
    entry(Command::ToggleVisible, Menu::Shape, "Hide or Show", "Hide the selected shape in the view, or show it again; exports have it all the same", &[key(NONE, Key::H)]).also("invisible visibility"),
    entry(Command::HideOthers, Menu::Shape, "Hide Others", "Hide every shape that is not selected", &[key(SHIFT, Key::H)]).also("isolate local view solo"),
    entry(Command::ShowAll, Menu::Shape, "Show All", "Show every shape that is hidden", &[key(ALT, Key::H)]).also("unhide reveal"),
    entry(Command::ToggleLocked, Menu::Shape, "Lock or Unlock", "Keep the selected shape from being clicked, posed and moved in the view, or unlock it", &[key(SHIFT, Key::L)]).also("freeze"),

    entry(Command::ViewFrom(ViewDirection::PlusX), Menu::Directions, "View from +X (Right)", "Look from +X; in the course's navigation at the origin", &[key(NONE, Key::Num3)]).also("side"),
    entry(Command::ViewFrom(ViewDirection::MinusX), Menu::Directions, "View from -X (Left)", "Look from -X; in the course's navigation at the origin", &[key(CTRL, Key::Num3)]).also("side"),
    entry(Command::ViewFrom(ViewDirection::PlusY), Menu::Directions, "View from +Y (Top)", "Look from above; in the course's navigation at the origin", &[key(NONE, Key::Num7)]),
    entry(Command::ViewFrom(ViewDirection::MinusY), Menu::Directions, "View from -Y (Bottom)", "Look from below; in the course's navigation at the origin", &[key(CTRL, Key::Num7)]),
    entry(Command::ViewFrom(ViewDirection::PlusZ), Menu::Directions, "View from +Z (Front)", "Look from +Z; in the course's navigation at the origin", &[key(NONE, Key::Num1)]),
    entry(Command::ViewFrom(ViewDirection::MinusZ), Menu::Directions, "View from -Z (Back)", "Look from -Z; in the course's navigation at the origin", &[key(CTRL, Key::Num1)]).also("rear behind"),
    entry(Command::ResetCamera, Menu::View, "Reset to Default Camera View", "Put the camera back to where it started; once more, in the Course or the Mannequin look, to where that program starts", &[key(NONE, Key::Home)]).also("home zoom"),
    only_in(Navigation::Mannequin, entry(Command::ResetViewAndPose, Menu::View, "Reset View and Pose", "Put the camera and every character back to where they started, posed as they were opened", &[key(NONE, Key::R)])),
    entry(Command::Fit, Menu::View, "Fit to View", "Fill the view with the selected shape, or with everything if none is", &[key(NONE, Key::F)]).also("frame focus zoom center"),
    entry(Command::FitAll, Menu::View, "Fit All to View", "Fill the view with everything, whatever is selected", &[key(SHIFT, Key::F)]).also("frame focus zoom center"),
    entry(Command::ToggleAxis, Menu::View, "Toggle Axis", "Show or hide the lines of X (red), Y (green) and Z (blue)", &[key(NONE, Key::T)]).also("axes origin coordinates"),
    entry(Command::Compare, Menu::Compare, "Compare with Picture…", "Show a picture, such as the sample solution's, beside the view and measure the differences; the key pressed again ends that", &[key(NONE, Key::F8)]).also("difference reference end comparison"),
    entry(Command::Explain, Menu::Explain, "Explain Skinning", "The formula at work on a vertex, mistakes made on purpose, and the matrix stack step by step", &[key(NONE, Key::K)]).also("weights learn"),
    entry(Command::CompareMesh, Menu::Compare, "Compare with Mesh…", "Lay a mesh that another program posed over the selected character, see how far off it is and which mistake gives it; the key pressed again ends that", &[key(SHIFT, Key::F8)]).also("difference reference diagnose wrong end comparison"),
    entry(Command::SetLook(Look::Course), Menu::Look, "Course", "The course's light and background, for pictures that are compared; files open in the look that was chosen last", &[key(NONE, Key::F2)]).also("lighting render"),
    entry(Command::SetLook(Look::Studio), Menu::Look, "Studio", "Key, fill and rim light, with a grid and shadows on the ground; files open in the look that was chosen last", &[key(NONE, Key::F3)]).also("lighting render floor"),
    entry(Command::SetLook(Look::Mannequin), Menu::Look, "Mannequin", "The Virtual Mannequin's: surfaces in the colors of their normals, red bones, a checkered floor; files open in the look that was chosen last", &[key(NONE, Key::F10)]).also("lighting render"),
    entry(Command::SetShading(Shading::AsAuthored), Menu::Shading, "As authored", "The normals that each mesh comes with; faceted where it has none", &[key(NONE, Key::F5)]),
    entry(Command::SetShading(Shading::Flat), Menu::Shading, "Flat", "One normal a triangle", &[key(NONE, Key::F6)]).also("facets faces edges wireframe normals"),
    entry(Command::SetShading(Shading::Smooth), Menu::Shading, "Smooth", "One normal a vertex, the mean of the triangles around it", &[key(NONE, Key::F7)]).also("gouraud phong normals"),
    entry(Command::SetColors(MeshColors::Materials), Menu::Colors, "Materials", "Characters have their own colors", &[]).also("textures"),
    entry(Command::SetColors(MeshColors::Weight), Menu::Colors, "Weight of the Selected Joint", "Color the selected character by how much the selected joint moves each vertex", &[]).also("weights heat map paint skin"),
    entry(Command::SetColors(MeshColors::Influences), Menu::Colors, "Number of Influences", "Color characters by how many joints move each vertex", &[]).also("weights heat map skin bones"),
    entry(Command::SetColors(MeshColors::LostAtFour), Menu::Colors, "Lost at Four Influences", "Color characters by the share of the weights that is left out where a vertex has at most four", &[]).also("heat map skin"),
    entry(Command::ToggleBindGhost, Menu::Ground, "Bind Pose as Ghost", "Show the selected characters, or all, in their bind pose as well, translucent", &[]).also("rest t-pose onion"),
    entry(Command::ToggleGrid, Menu::Ground, "Ground Grid", "Show or hide the grid on the ground", &[key(NONE, Key::F4)]).also("floor plane"),
    entry(Command::ToggleBones, Menu::Ground, "Bones", "Show or hide the red bones of the Mannequin look; the one under the pointer is shown either way", &[]).also("skeleton rig"),
    entry(Command::TogglePanel, Menu::Ground, "Shape Panel", "Fold the panel at the right away, or unfold it", &[key(NONE, Key::N)]).also("sidebar properties inspector sliders angles joints"),
    entry(Command::SetNavigation(Navigation::Course), Menu::Navigation, "As the course's editor", "Left drag moves the scene, right drag turns it", &[]),
    entry(Command::SetNavigation(Navigation::Orbit), Menu::Navigation, "Orbit", "As in three.js: left drag turns the scene, right or middle drag moves it", &[]),
    entry(Command::SetNavigation(Navigation::Mannequin), Menu::Navigation, "Mannequin", "As in the Virtual Mannequin: left drag turns, right drag zooms, W S A D and arrows walk, 1 to 7 open its scenes", &[]),
    entry(Command::SetNavigation(Navigation::Blender), Menu::Navigation, "Blender", "Middle drag turns the scene, with Shift it moves it, with Ctrl it zooms", &[]),
    entry(Command::SetTheme(ThemePreference::System), Menu::Theme, "System", "Dark or light, as the desktop is set", &[]),
    entry(Command::SetTheme(ThemePreference::Dark), Menu::Theme, "Dark", "Light text on dark panels", &[]).also("appearance night"),
    entry(Command::SetTheme(ThemePreference::Light), Menu::Theme, "Light", "Dark text on light panels", &[]).also("appearance day bright"),
    entry(Command::SetSkinning(None), Menu::Skinning, "Automatic", "The graphics card deforms characters where there is one", &[]),
    entry(Command::SetSkinning(Some(Skinning::Cpu)), Menu::Skinning, "Processor", "The processor deforms characters and uploads their vertices", &[]).also("cpu"),
    entry(Command::SetSkinning(Some(Skinning::Gpu)), Menu::Skinning, "Graphics Card", "The graphics card deforms characters in a vertex shader", &[]).also("gpu"),

    entry(Command::SetTool(Tool::Select), Menu::Tools, "Select Tool", "Click selects; drags move the camera, or select in a box in the Blender navigation", &[key(NONE, Key::V)]).also("pointer cursor arrow"),
    entry(Command::SetTool(Tool::Pose), Menu::Tools, "Pose Tool", "Left drag turns the bone under the pointer, Left and Right roll it", &[key(NONE, Key::B)]).also("joints sliders rotate animate"),
    entry(Command::SetTool(Tool::Move), Menu::Tools, "Move Tool", "Left drag moves the shape under the pointer, or where bones show or it is selected, the root", &[key(NONE, Key::G), key(NONE, Key::W)]).also("translate grab position"),
    entry(Command::SetTool(Tool::Rotate), Menu::Tools, "Rotate Tool", "Rings turn the selected shape about its origin, several about the middle of theirs", &[key(NONE, Key::E)]).also("gizmo spin"),
    entry(Command::SetTool(Tool::Scale), Menu::Tools, "Scale Tool", "Handles scale the selected shapes along their own axes, the ring and the square in the middle along all; figures stay on their ground", &[key(NONE, Key::R)]).also("size resize gizmo"),
    entry(Command::SetTool(Tool::Ik), Menu::Tools, "IK Tool", "Left drag moves the end of the bone under the pointer: hand, foot or root; a chain of joints follows", &[key(NONE, Key::I)]).also("inverse kinematics reach"),
    entry(Command::ToggleLocalAxes, Menu::Tools, "Local Axes", "Turn and move along the axes of the joint or shape instead of the world's", &[key(NONE, Key::L)]).also("global orientation"),
    entry(Command::PinJoint, Menu::Tools, "Pin Joint", "Hold the joint under the pointer, or all that are selected, where it is while the IK tool drags others", &[key(NONE, Key::P)]).also("fix anchor"),
    entry(Command::UnpinAll, Menu::Tools, "Unpin All Joints", "Let go of every pinned joint", &[key(ALT, Key::P)]).also("release free"),

    entry(Command::ResetJoint, Menu::Pose, "Reset Joint", "Put the selected joint back to rest", &[key(ALT, Key::R)]).also("zero clear"),
    entry(Command::ResetAngles, Menu::Pose, "Reset Angles of Joint", "Turn the selected joint back to rest; a root stays where it is", &[]).also("zero clear"),
    entry(Command::ResetOffset, Menu::Pose, "Reset Offset of Root", "Put the selected root back to where it is at rest, turned as it is", &[]).also("zero clear position"),
    entry(Command::ResetPose, Menu::Pose, "Reset Pose", "Put every joint of the selected character back to rest", &[key(ALT.plus(SHIFT), Key::R)]).also("zero clear bind t-pose"),
    entry(Command::MirrorPose, Menu::Pose, "Mirror Pose", "Exchange left and right, which are found by the joints' names or else by their places", &[key(NONE, Key::M)]).also("flip symmetry symmetric reflect swap"),
    entry(Command::MirrorJoints, Menu::Pose, "Mirror onto Other Side", "Give the joints on the other side the pose of the selected ones, which stay as they are", &[key(SHIFT, Key::M)]).also("flip symmetry symmetrize symmetric reflect opposite arm leg"),
    entry(Command::CopyPose, Menu::Pose, "Copy Pose", "Put the pose on the clipboard, as the text of a pose file", &[key(CTRL.plus(Modifiers::ALT), Key::C)]),
    entry(Command::PastePose, Menu::Pose, "Paste Pose", "Apply the pose on the clipboard", &[key(CTRL.plus(Modifiers::ALT), Key::V)]),
    entry(Command::PastePoseMirrored, Menu::Pose, "Paste Pose Mirrored", "Apply the pose on the clipboard with left and right exchanged", &[key(CTRL.plus(SHIFT), Key::V)]).also("flip flipped symmetry reflect swap"),
    entry(Command::KeepPose, Menu::Pose, "Keep Pose", "Keep the pose in the character's list of poses", &[key(CTRL, Key::K)]).also("save store remember"),
    entry(Command::SavePose, Menu::Pose, "Save Pose…", "Write the pose as a .json file", &[key(CTRL, Key::P)]).also("export store"),
    entry(Command::LoadPose, Menu::Pose, "Load Pose…", "Apply the pose of a .json file", &[key(CTRL.plus(Modifiers::ALT), Key::P)]).also("open import"),

    entry(Command::FindCommand, Menu::Help, "Find Command…", "Find any command by its name, see its key, and run it", &[key(CTRL.plus(SHIFT), Key::P)]).also("search palette"),
    entry(Command::Keys, Menu::Help, "Keys and Mouse", "Every key and every gesture", &[key(NONE, Key::Questionmark), key(NONE, Key::F1)]).also("shortcuts keyboard keymap help hotkeys"),
    entry(Command::Messages, Menu::Help, "Messages", "Every message since the program started", &[key(NONE, Key::F9)]).also("log errors warnings"),
    entry(Command::About, Menu::Help, "About", "Version, license, and what it runs on", &[]),
];

/// Rows of the table for one menu, in order.
pub(in crate::ui) fn entries(menu: Menu) -> impl Iterator<Item = &'static Entry> {
    COMMANDS.iter().filter(move |entry| entry.menu == menu)
}

/// Row of `command` in the table.
pub(in crate::ui) fn entry_of(command: Command) -> Option<&'static Entry> {
    COMMANDS.iter().find(|entry| entry.command == command)
}

/// What the key of `command` does at the moment: with the Pose and IK tools, Delete puts the selected joint back to
/// rest, rather than deleting all that hangs together with it, and with any tool that takes bones, Alt+R and Alt+G in
/// Blender's navigation are about its angles and its offset. There, with the Pose tool G turns a bone that hangs on another one, as it does in Blender.
pub(in crate::ui) fn meant(command: Command, session: &Session, tool: Tool) -> Command {
    let has_joint = session.selected_joint().is_some();
    let only_turn = |shape| selected_roots(session, shape).is_none();
    match command {
        Command::Delete if has_joint && matches!(tool, Tool::Pose | Tool::Ik) => {
            Command::ResetJoint
        }
        Command::ResetRotation if has_joint && tool.takes_bones() => Command::ResetAngles,
        Command::ResetPosition if has_joint && tool.takes_bones() => Command::ResetOffset,
        Command::Begin(Tool::Move)
            if tool == Tool::Pose && has_joint && session.selected().is_some_and(only_turn) =>
        {
            Command::Begin(Tool::Rotate)
        }
        command => command,
    }
}

/// Whether `command` is listed in `menu`.
pub(in crate::ui) fn is_in(menu: Menu, command: Command) -> bool {
    entry_of(command).is_some_and(|entry| entry.menu == menu)
}

/// Label of a command where its menu is not seen, such as `Theme: Light`.
pub(in crate::ui) fn in_words(entry: &Entry) -> String {
    let menu = match entry.menu {
        Menu::Scenes => "Built-in Scene",
        Menu::Look => "Look",
        Menu::Shading => "Shading",
        Menu::Colors => "Colors",
        Menu::Navigation => "Navigation",
        Menu::Theme => "Theme",
        Menu::Skinning => "Skinning",
        _ => return entry.label.to_owned(),
    };
    format!("{menu}: {}", entry.label)
}

/// Label of `command` in menus.
pub(in crate::ui) fn label(command: Command) -> &'static str {
    entry_of(command).map_or("", |entry| entry.label)
}

/// Label in menus of the built-in scene `name`; `None` if it is in none.
pub fn scene_label(name: &str) -> Option<&'static str> {
    let opens =
        |entry: &&Entry| matches!(entry.command, Command::OpenScene(scene) if scene == name);
    COMMANDS.iter().find(opens).map(|entry| entry.label)
}
