//! The program's own characters: every joint and the end of every bone can be led about.

use editor_core::character::Character;
use editor_core::character::ik::{IkChain, IkGoal};
use editor_core::io::Loaded;
use editor_core::io::builtin::{BuiltinKind, WithBuiltin, catalogue};
use editor_core::scene::ShapeKind;
use glam::Vec3;
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

/// Leads the end of a chain once round where it is, `radius` away.
fn lead_round(name: &str, character: &Character, chain: &IkChain, radius: f32) {
    let skeleton = character.skeleton();
    let mut pose = Default::default();
    let middle = chain.end_position(skeleton, &pose);
    for step in 0..12_u8 {
        let angle = f32::from(step) * std::f32::consts::TAU / 12.0;
        let around = Vec3::new(angle.cos(), angle.sin(), (2.0 * angle).sin());
        let goal = IkGoal::to(middle + radius * around);
        let solution = chain.solve(skeleton, &pose, &goal);
        let solution = solution.expect("a finite goal has an answer");
        let end = chain.end_position(skeleton, &solution.pose);
        assert!(end.is_finite(), "{name}");
        let off = end.distance(goal.target);
        assert!((off - solution.off).abs() < 1e-5, "{name}: {off}");
        // What is out of reach is so because the chain is straight, or folded up.
        let off = chain
            .solve(skeleton, &solution.pose, &IkGoal::to(end))
            .map_or(1.0, |again| again.off);
        assert!(off < 1e-4, "{name}: where it is, is {off} off");
        pose = solution.pose;
    }
}

#[test]
fn every_joint_and_every_bone_can_be_led_about() {
    let names: Vec<_> = catalogue()
        .into_iter()
        .filter(|builtin| builtin.kind == BuiltinKind::Character)
        .map(|builtin| builtin.name)
        .collect();
    assert!(names.len() >= 3, "{names:?}");
    for name in names {
        let mut loaded = Loaded::default();
        let path = format!("builtin:{name}");
        loaded
            .add(&WithBuiltin(HashMap::new()), Path::new(&path))
            .expect("a built-in character");
        let none = BTreeSet::new();
        let mut led = 0;
        for shape in &loaded.shapes {
            let ShapeKind::Character(shape) = &shape.kind else {
                continue;
            };
            let character = &*shape.character;
            let (skeleton, pose) = (character.skeleton(), Default::default());
            let to_joint = |joint, length| IkChain::to_joint(skeleton, &pose, joint, length, &none);
            let joints = 0..skeleton.joints().len();
            let joints = joints.flat_map(|joint| [to_joint(joint, 2), to_joint(joint, 99)]);
            let bones = character
                .bones()
                .iter()
                .map(|bone| IkChain::to_point(skeleton, &pose, bone.joint, bone.tip, 2, &none));
            for chain in joints.chain(bones).flatten() {
                lead_round(name, character, &chain, 0.1);
                led += 1;
            }
        }
        assert!(led > 3, "{name}: {led} chains");
    }
}
