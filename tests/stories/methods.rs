//! Both methods of skinning in the view: blended, and split by a line.

use super::explaining::{NO_INVERSE, make};
use super::{Story, differing};
use editor_core::geometry::Picture;
use egui::vec2;

impl Story {
    /// The texts of all labels.
    fn texts(&self) -> Vec<&str> {
        let nodes = self.widgets.iter().flat_map(|update| &update.nodes);
        nodes.filter_map(|(_, node)| node.value()).collect()
    }
}

/// The column with its upper half twisted, its panel of skinning open.
fn twisted() -> Story {
    let mut story = Story::start(&["builtin:column"]);
    story.type_into("Upper Y", "150");
    story.click("Skinning");
    story
}

/// Pixels that differ in the columns `from..to`.
fn differing_within(a: &Picture, b: &Picture, from: usize, to: usize) -> usize {
    let width = a.width as usize;
    let (a, b) = (a.rgba.as_chunks::<4>().0, b.rgba.as_chunks::<4>().0);
    let columns = (0..a.len()).filter(|at| (from..to).contains(&(at % width)));
    columns.filter(|&at| a[at] != b[at]).count()
}

/// The volume in the label that begins and ends so, in percent.
fn told_volume(story: &Story, before: &str, after: &str) -> f64 {
    let texts = story.texts();
    let number = |text: &&str| -> Option<f64> {
        let number = text.strip_prefix(before)?.strip_suffix(after)?;
        number.parse().ok()
    };
    texts.iter().find_map(number).expect("a volume")
}

/// The volume by the character's own method.
fn own_volume(story: &Story) -> f64 {
    told_volume(story, "Volume ", " % of the bind pose")
}

#[test]
fn the_volume_that_a_twist_leaves_is_told_in_percent_of_the_bind_pose() {
    let mut story = twisted();
    for (button, range) in [
        ("Dual Quaternion", 90.0..110.0),
        ("Linear Blend", 10.0..90.0),
    ] {
        story.click(button);
        let shape = story.session().evaluated().shape(story.shape().id).unwrap();
        let kept = 100.0 * shape.geometry.volume_kept().unwrap();
        let told = own_volume(&story);
        assert!((told - kept).abs() <= 0.05, "{told} {kept}");
        assert!(range.contains(&told), "{button}: {told}");
    }
}

#[test]
fn while_a_mistake_is_shown_the_volume_is_that_of_the_mesh_that_is_seen() {
    let mut story = twisted();
    let right = own_volume(&story);
    story.click("View");
    story.click("Explain Skinning");
    let of_mistake =
        |story: &Story| told_volume(story, "Volume ", " % of the bind pose, with the mistake");
    make(&mut story, NO_INVERSE);
    let wrong = of_mistake(&story);
    assert!((wrong - right).abs() > 1.0, "{wrong} {right}");
    story.click("Back to Correct");
    assert_eq!(own_volume(&story), right);
}

#[test]
fn the_view_is_split_at_a_line_that_is_dragged() {
    let mut story = twisted();
    story.click("Dual Quaternion");
    let dual = story.scene_picture();
    story.click("Linear Blend");
    let linear = story.scene_picture();
    let (document, steps) = (story.session().document(), story.session().steps().len());
    story.click("Compare Methods: Split");
    assert!(story.has_text("Linear blend") && story.has_text("Dual quaternions"));
    let width = linear.width as usize;
    let middle = width / 2;
    let split = story.scene_picture();
    assert_eq!(differing_within(&split, &linear, 0, middle), 0);
    assert_eq!(differing_within(&split, &dual, middle, width), 0);
    assert!(differing_within(&split, &linear, middle, width) > 100);
    assert!(differing_within(&split, &dual, 0, middle) > 100);

    // All the way to the left nothing but dual quaternions is left.
    let line = story.place("Line between the pictures");
    story.drag(line, line - vec2(2000.0, 0.0));
    let dragged = story.scene_picture();
    assert_eq!(differing_within(&dragged, &dual, 0, width), 0);
    assert_eq!(story.session().document(), document);
    assert_eq!(story.session().steps().len(), steps);
    story.click("Compare Methods: Off");
    assert_eq!(differing(&story.scene_picture(), &linear), 0);
}

#[test]
fn a_blend_lies_between_the_methods_and_is_in_the_view_alone() {
    let mut story = twisted();
    let document = story.session().document();
    let linear = story.scene_picture();
    story.save_view((200, 150), "before.png");
    story.click("Compare Methods: Blend");
    assert!(story.has_text("Blend: 50 % dual quaternions"));
    let half = story.scene_picture();
    assert!(differing(&half, &linear) > 100);
    let volume = |story: &Story| told_volume(story, "Blend: volume ", " %");
    let of_half = volume(&story);
    assert!(own_volume(&story) < of_half, "{of_half}");
    let slider = story.place("Share of dual quaternions");
    story.drag(slider, slider + vec2(500.0, 0.0));
    assert!(story.has_text("Blend: 100 % dual quaternions"));
    assert!(of_half < volume(&story));
    let blended = story.scene_picture();

    story.save_view((200, 150), "after.png");
    let file = |story: &Story, path: &str| story.host.files[std::path::Path::new(path)].clone();
    assert_eq!(file(&story, "before.png"), file(&story, "after.png"));
    assert_eq!(story.session().document(), document);
    story.click("Compare Methods: Off");
    story.click("Dual Quaternion");
    assert_eq!(differing(&blended, &story.scene_picture()), 0);
}
