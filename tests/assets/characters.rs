//! The characters: closed bodies, well bound.
use crate::assets::surface::{Surface, float};
use crate::assets::{asset, paths};
use glam::{DMat3, DVec3};
use std::collections::HashMap;

const NAMES: [&str; 3] = ["adult", "robot", "dog"];

struct Joint {
    name: String,
    /// In the world at rest.
    at: DVec3,
    parent: Option<usize>,
}

struct Character {
    name: &'static str,
    joints: Vec<Joint>,
    body: Surface,
    weights: Vec<Vec<f64>>,
}

fn character(name: &'static str) -> Character {
    let mut joints: Vec<Joint> = Vec::new();
    for line in asset(&format!("characters/{name}.skel")).lines() {
        let (numbers, title) = line.split_once(" # ").unwrap_or((line, ""));
        let numbers: Vec<f64> = numbers.split_whitespace().map(float).collect();
        assert_eq!(numbers.len(), 4, "{name}: {line}");
        let parent = (numbers[3] >= 0.0).then_some(numbers[3] as usize);
        let offset = DVec3::new(numbers[0], numbers[1], numbers[2]);
        // Parents stand before their children, so that no chain of them can close.
        let base = parent.map_or(DVec3::ZERO, |p| joints[p].at);
        joints.push(Joint {
            name: title.to_owned(),
            at: base + offset,
            parent,
        });
    }
    let weights = asset(&format!("characters/{name}.attach"))
        .lines()
        .map(|line| line.split_whitespace().map(float).collect())
        .collect();
    Character {
        name,
        joints,
        body: Surface::read(&asset(&format!("characters/{name}.obj"))),
        weights,
    }
}

impl Character {
    fn joint(&self, name: &str) -> usize {
        let found = self.joints.iter().position(|j| j.name == name);
        assert!(found.is_some(), "{} has a joint {name}", self.name);
        found.unwrap_or_default()
    }

    /// The vertices, skinned, after one joint turned about an axis of the world.
    fn posed(&self, joint: usize, axis: DVec3, degrees: f64) -> Vec<DVec3> {
        let turn = DMat3::from_axis_angle(axis, degrees.to_radians());
        let mut moves = vec![false; self.joints.len()];
        for (i, j) in self.joints.iter().enumerate() {
            moves[i] = i == joint || j.parent.is_some_and(|p| moves[p]);
        }
        let center = self.joints[joint].at;
        let place = |(p, row): (&DVec3, &Vec<f64>)| {
            let share: f64 = (1..moves.len())
                .filter(|&j| moves[j])
                .map(|j| row[j - 1])
                .sum();
            *p + (center + turn * (*p - center) - *p) * share
        };
        self.body
            .positions
            .iter()
            .zip(&self.weights)
            .map(place)
            .collect()
    }

    fn dominant(&self, vertex: usize) -> usize {
        let row = &self.weights[vertex];
        1 + (0..row.len())
            .max_by(|&a, &b| row[a].total_cmp(&row[b]))
            .unwrap_or_default()
    }
}

#[test]
fn every_edge_borders_two_triangles_that_face_outward() {
    for name in NAMES {
        let c = character(name);
        assert!(
            c.body.faces.iter().all(|f| f.len() == 3),
            "{name}: triangles only"
        );
        c.body.assert_closed(name);
        // Each part of the body for itself: a part inside out has a negative volume.
        let parts = c.body.parts();
        let mut volumes: HashMap<usize, f64> = HashMap::new();
        for t in c.body.triangles() {
            let [x, y, z] = t.map(|v| c.body.positions[v]);
            *volumes.entry(parts[t[0]]).or_default() += x.dot(y.cross(z)) / 6.0;
        }
        assert!(
            volumes.values().all(|&v| v > 1e-7),
            "{name}: parts inside out"
        );
        assert_eq!(
            volumes.len() == 1,
            name != "robot",
            "{name}: {} parts",
            volumes.len()
        );
    }
}

#[test]
fn the_living_have_no_holes_and_no_slivers() {
    for name in ["adult", "dog"] {
        let body = character(name).body;
        let euler =
            body.positions.len() as i64 - body.edges().len() as i64 + body.faces.len() as i64;
        assert_eq!(euler, 2, "{name}: the surface of a ball, without handles");
        for t in body.triangles() {
            let [a, b, c] = t.map(|v| body.positions[v]);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let height = body.cross(t).length() / longest;
            assert!(height > 0.1 * longest, "{name}: sliver {t:?} at {a}");
        }
    }
}

#[test]
fn no_triangle_has_zero_area() {
    for name in NAMES {
        let body = character(name).body;
        let flat = body
            .triangles()
            .filter(|&t| body.cross(t).length() < 1e-9)
            .count();
        assert_eq!(flat, 0, "{name}");
    }
}

#[test]
fn there_are_as_many_vertices_as_the_models_ask_for() {
    let count = |name| character(name).body.positions.len();
    assert!((8_000..=14_000).contains(&count("adult")));
    assert!((1_500..=5_000).contains(&count("robot")));
    assert!((5_000..=14_000).contains(&count("dog")));
}

#[test]
fn the_adult_fits_the_first_view() {
    let body = character("adult").body;
    let low = body.positions.iter().fold(DVec3::MAX, |m, &p| m.min(p));
    let high = body.positions.iter().fold(DVec3::MIN, |m, &p| m.max(p));
    assert!((low.y + 0.9).abs() < 0.02, "feet at {}", low.y);
    assert!((high.y - 0.9).abs() < 0.05, "head at {}", high.y);
    assert!(low.x > -1.0 && high.x < 1.0);
}

#[test]
fn weights_fit_the_mesh_and_sum_to_one() {
    for name in NAMES {
        let c = character(name);
        assert_eq!(
            c.weights.len(),
            c.body.positions.len(),
            "{name}: a row for each vertex"
        );
        for (v, row) in c.weights.iter().enumerate() {
            assert_eq!(row.len(), c.joints.len() - 1, "{name}: columns of row {v}");
            assert!(
                row.iter().all(|&w| (0.0..=1.0).contains(&w)),
                "{name}: row {v}"
            );
            assert!(
                (row.iter().sum::<f64>() - 1.0).abs() < 1e-9,
                "{name}: row {v}"
            );
            let influences = row.iter().filter(|&&w| w > 0.0).count();
            assert!(
                influences <= if name == "robot" { 1 } else { 6 },
                "{name}: row {v}"
            );
        }
    }
}

#[test]
fn every_joint_but_the_root_dominates_some_vertices() {
    for name in NAMES {
        let c = character(name);
        let mut counts = vec![0; c.joints.len()];
        (0..c.weights.len()).for_each(|v| counts[c.dominant(v)] += 1);
        for (j, joint) in c.joints.iter().enumerate().skip(1) {
            assert!(counts[j] >= 20, "{name}: {} has {}", joint.name, counts[j]);
        }
    }
}

#[test]
fn every_joint_has_a_name_of_its_own_and_a_parent_before_it() {
    for name in NAMES {
        let c = character(name);
        for (i, joint) in c.joints.iter().enumerate() {
            assert_eq!(joint.parent.is_none(), i == 0, "{name}: {}", joint.name);
            assert!(joint.parent.is_none_or(|p| p < i), "{name}: {}", joint.name);
            assert!(!joint.name.is_empty());
            assert_eq!(
                c.joint(&joint.name),
                i,
                "{name}: {} occurs twice",
                joint.name
            );
        }
    }
}

#[test]
fn the_adult_has_the_joints_of_the_course() {
    let c = character("adult");
    let names = [
        "Root",
        "Chest",
        "Waist",
        "Neck",
        "Right hip",
        "Right leg",
        "Right knee",
        "Right foot",
        "Left hip",
        "Left leg",
        "Left knee",
        "Left foot",
        "Right collarbone",
        "Right shoulder",
        "Right elbow",
        "Left collarbone",
        "Left shoulder",
        "Left elbow",
    ];
    let parents = [-1, 0, 1, 0, 2, 4, 5, 6, 2, 8, 9, 10, 0, 12, 13, 0, 15, 16];
    assert_eq!(
        c.joints.iter().map(|j| j.name.as_str()).collect::<Vec<_>>(),
        names
    );
    let of = |j: &Joint| j.parent.map_or(-1, |p| p as i32);
    assert_eq!(c.joints.iter().map(of).collect::<Vec<_>>(), parents);
    assert!(
        c.joints[c.joint("Left elbow")].at.x > 0.0,
        "left is +X for one who faces +Z"
    );
}

#[test]
fn left_mirrors_right() {
    for name in NAMES {
        let c = character(name);
        let key = |p: DVec3| [p.x, p.y, p.z].map(|x| (x * 1e5).round() as i64);
        let other_side = |name: &str| match name.split_once(' ') {
            Some(("Left", rest)) => format!("Right {rest}"),
            Some(("Right", rest)) => format!("Left {rest}"),
            _ => name.to_owned(),
        };
        let twins: Vec<usize> = c
            .joints
            .iter()
            .map(|j| c.joint(&other_side(&j.name)))
            .collect();
        let rows: HashMap<[i64; 3], &Vec<f64>> = c
            .body
            .positions
            .iter()
            .map(|&p| key(p))
            .zip(&c.weights)
            .collect();
        for (p, row) in c.body.positions.iter().zip(&c.weights) {
            let [x, y, z] = key(*p);
            let Some(twin) = rows.get(&[-x, y, z]) else {
                panic!("{name}: nothing mirrors {p}");
            };
            for j in 1..c.joints.len() {
                let (here, there) = (row[j - 1], twin[twins[j] - 1]);
                assert!(
                    (here - there).abs() < 4e-4,
                    "{name}: {} at {p}",
                    c.joints[j].name
                );
            }
        }
        for (joint, &twin) in c.joints.iter().zip(&twins) {
            let mirrored = c.joints[twin].at * DVec3::new(-1.0, 1.0, 1.0);
            assert!(joint.at.distance(mirrored) < 3e-5, "{name}: {}", joint.name);
        }
    }
}

#[test]
fn bending_an_elbow_moves_nothing_of_the_trunk_or_the_legs() {
    let c = character("adult");
    for (name, axis) in [("Left elbow", DVec3::NEG_Y), ("Right elbow", DVec3::Y)] {
        let elbow = c.joint(name);
        let posed = c.posed(elbow, axis, 90.0);
        let arm = [elbow, elbow - 1];
        for (v, (before, after)) in c.body.positions.iter().zip(&posed).enumerate() {
            let moved = before.distance(*after);
            assert!(
                arm.contains(&c.dominant(v)) || moved < 1e-9,
                "{name} moves {before} by {moved}"
            );
        }
    }
}

#[test]
fn lifting_a_leg_leaves_the_other_alone() {
    let c = character("adult");
    let posed = c.posed(c.joint("Left leg"), DVec3::X, -60.0);
    for (before, after) in c.body.positions.iter().zip(&posed) {
        let other = before.x < -0.02 && before.y < -0.25;
        assert!(!other || before.distance(*after) < 1e-9, "{before}");
    }
}

#[test]
fn bent_joints_keep_the_triangles_whole() {
    let c = character("adult");
    for (name, axis, degrees) in [
        (
            "Left elbow",
            DVec3::new(-0.73, -0.68, 0.0).normalize_or_zero(),
            90.0,
        ),
        ("Left knee", DVec3::X, 90.0),
        ("Left shoulder", DVec3::Z, 60.0),
        ("Left shoulder", DVec3::Z, -35.0),
        ("Left leg", DVec3::X, -60.0),
    ] {
        let posed = c.posed(c.joint(name), axis, degrees);
        let edges = c.body.edges();
        let torn = edges.keys().filter(|&&(a, b)| {
            posed[a].distance(posed[b]) > 2.6 * c.body.positions[a].distance(c.body.positions[b])
        });
        assert_eq!(torn.count(), 0, "{name} by {degrees}");
    }
}

#[test]
fn poses_name_joints_that_their_characters_have() {
    for path in &Vec::from_iter(paths("poses")) {
        let pose: serde_json::Value = serde_json::from_str(&asset(path)).unwrap_or_default();
        // The others are those of the rigs.
        let Some(&name) = NAMES.iter().find(|n| path.contains(&format!("/{n}-"))) else {
            continue;
        };
        let c = character(name);
        let joints = pose["joints"].as_object().cloned().unwrap_or_default();
        assert!(joints.len() >= 5, "{path}");
        for (joint, angles) in &joints {
            c.joint(joint);
            let angles: Vec<f64> = angles
                .as_array()
                .into_iter()
                .flatten()
                .filter_map(|x| x.as_f64())
                .collect();
            assert!(
                angles.len() == 3 && angles.iter().all(|a| a.abs() <= 180.0),
                "{path}: {joint}"
            );
        }
        assert!(pose["roots"]["Root"].is_array(), "{path}");
    }
}
