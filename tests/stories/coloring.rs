//! Characters in the colors of numbers, with a legend, and their bind pose beside them.

use super::explaining::{NO_INVERSE, make};
use super::{Story, differing};
use editor_core::scene::scale_color;
use egui::vec2;
use glam::Vec3;

impl Story {
    /// Chooses an item of a submenu of the View menu.
    fn choose_colors(&mut self, label: &str) {
        self.click("View");
        self.click("Colors");
        self.click(label);
    }

    /// Color of the view at a point of the world.
    fn color_at(&self, world: Vec3) -> Vec3 {
        let picture = self.scene_picture();
        let at = self.at(world) - self.view().min;
        let index = 4 * (at.y as usize * picture.width as usize + at.x as usize);
        Vec3::from([0, 1, 2].map(|channel| f32::from(picture.rgba[index + channel]))) / 255.0
    }
}

/// Whether `seen` is a color of the scale at `part`, however it is lit.
fn is_scale_color(seen: Vec3, part: f32) -> bool {
    let expected = scale_color(part);
    let brightness = seen.length() / expected.length();
    (0.65..1.02).contains(&brightness) && (seen - expected * brightness).length() < 0.04
}

/// Points of the strip just inside its lower edge, between the joints, and inside its upper edge,
/// where the elbow's weights are 0, 1/2 and 1.
const PARTS: [(Vec3, f32); 3] = [
    (Vec3::new(0.05, 0.02, 0.0), 0.01),
    (Vec3::new(0.05, 1.0, 0.0), 0.5),
    (Vec3::new(0.05, 1.98, 0.0), 0.99),
];

#[test]
fn the_selected_joints_weight_colors_the_mesh_and_follows_the_selection() {
    let mut story = Story::start(&["models/strip.obj"]);
    let before = story.scene_picture();
    story.choose_colors("Weight of the Selected Joint");
    assert!(story.has_text("Select a joint of a character to see what it moves"));
    story.click("Elbow");
    assert!(story.has_text("Weight of Elbow"));
    assert!(story.has("Weight of Elbow: from 0 to 1"));
    for (at, part) in PARTS {
        let seen = story.color_at(at);
        assert!(is_scale_color(seen, part), "{part}: {seen}");
    }
    story.click("Hip");
    for (at, part) in PARTS {
        let seen = story.color_at(at);
        assert!(is_scale_color(seen, 1.0 - part), "1 - {part}: {seen}");
    }
    story.choose_colors("Materials");
    assert!(!story.has_text("Weight of Hip"));
    story.key(egui::Key::Escape);
    assert_eq!(differing(&before, &story.scene_picture()), 0);
}

#[test]
fn the_legend_is_below_the_tools_where_these_have_two_rows() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.size = (700, 600);
    story.key(egui::Key::B);
    story.choose_colors("Number of Influences");
    let legend = story.text_place("Joints that move a vertex");
    assert!(
        story.place("Local Axes").y > story.place("Pose Tool").y + 12.0,
        "two rows"
    );
    assert!(
        legend.top() > story.place("Local Axes").y + 12.0,
        "{legend}"
    );
}

#[test]
fn the_legend_is_below_what_says_that_the_character_is_shown_wrong() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.choose_colors("Weight of the Selected Joint");
    story.type_into("Elbow Z", "90");
    story.click("Elbow");
    let alone = story.text_place("Weight of Elbow");
    story.key(egui::Key::K);
    make(&mut story, NO_INVERSE);
    let legend = story.text_place("Weight of Elbow");
    assert!(legend.top() > story.place("Back to Correct").y + 12.0);
    story.click("Back to Correct");
    assert!(!story.has("Back to Correct"));
    assert_eq!(story.text_place("Weight of Elbow"), alone);
}

#[test]
fn colors_stay_on_their_vertices_while_a_joint_is_dragged() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.choose_colors("Weight of the Selected Joint");
    story.click("Elbow");
    let before = story.scene_picture();
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(60.0, 0.0));
    assert_ne!(differing(&before, &story.scene_picture()), 0);
    // What is below the elbow stands still.
    let (at, part) = PARTS[0];
    assert!(is_scale_color(story.color_at(at), part));
    story.button(false);
}

#[test]
fn the_number_of_influences_is_counted_and_what_four_lose_is_told() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.choose_colors("Number of Influences");
    assert!(story.has("Joints that move a vertex: from 1 to 2"));
    assert!(is_scale_color(story.color_at(PARTS[1].0), 1.0));
    assert!(is_scale_color(story.color_at(PARTS[0].0), 0.02));
    story.choose_colors("Lost at Four Influences");
    assert!(story.has_text("Nothing: no vertex has more than four"));
}

#[test]
fn the_bind_pose_is_a_ghost_beside_the_posed_mesh() {
    let mut story = Story::start(&["models/strip.obj"]);
    let top = PARTS[2].0;
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(90.0, 0.0));
    story.button(false);
    story.settle();
    let (bent, beside) = (story.scene_picture(), story.color_at(top));
    story.click("View");
    story.click("Bind Pose as Ghost");
    let ghost = story.color_at(top);
    assert!(ghost.z > beside.z + 0.1, "{beside} {ghost}");
    story.click("View");
    story.click("Bind Pose as Ghost");
    assert_eq!(differing(&bent, &story.scene_picture()), 0);
}
