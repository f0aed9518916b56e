//! Poses that show the characters off, as files for the command line's `--pose`.
use std::fmt::Write;

/// A pose: joints by name with their Euler angles in degrees (Rx · Ry · Rz, about the axes of the
/// world at rest), and how far roots move.
struct Pose {
    roots: &'static [(&'static str, [f64; 3])],
    joints: &'static [(&'static str, [f64; 3])],
}

/// The text of every pose, in the order in which the catalog lists them.
pub fn texts() -> impl Iterator<Item = String> {
    POSES.iter().map(text)
}

fn text(pose: &Pose) -> String {
    let mut text = String::from("{\n  \"joints\": {\n");
    for (i, (name, [x, y, z])) in pose.joints.iter().enumerate() {
        let comma = if i + 1 < pose.joints.len() { "," } else { "" };
        let _ = writeln!(text, "    \"{name}\": [{x}, {y}, {z}]{comma}");
    }
    let roots = pose.roots.iter();
    let roots = roots.map(|(name, [x, y, z])| format!("\"{name}\": [{x}, {y}, {z}]"));
    let roots: Vec<String> = roots.collect();
    let _ = writeln!(text, "  }},\n  \"roots\": {{ {} }}\n}}", roots.join(", "));
    text
}

const POSES: &[Pose] = &[
    // adult-walk
    Pose {
        roots: &[("Root", [0.0, -0.053, 0.0])],
        joints: &[
            ("Root", [3.0, 4.0, 0.0]),
            ("Waist", [-2.0, -9.0, 0.0]),
            ("Neck", [-2.0, -3.0, 0.0]),
            ("Left leg", [-30.0, 0.0, -1.0]),
            ("Left knee", [9.0, 0.0, 0.0]),
            ("Left foot", [4.0, 0.0, 0.0]),
            ("Right leg", [17.0, 0.0, 1.0]),
            ("Right knee", [34.0, 0.0, 0.0]),
            ("Right foot", [14.0, 0.0, 0.0]),
            ("Left shoulder", [24.0, 0.0, -33.0]),
            ("Left elbow", [-14.9, -13.5, -1.8]),
            ("Right shoulder", [-22.0, 0.0, 33.0]),
            ("Right elbow", [-27.1, 23.0, 5.6]),
        ],
    },
    // adult-wave
    Pose {
        roots: &[("Root", [0.0, 0.007, 0.0])],
        joints: &[
            ("Waist", [0.0, -6.0, -2.0]),
            ("Neck", [-4.0, -10.0, 6.0]),
            ("Right collarbone", [0.0, 0.0, -10.0]),
            ("Right shoulder", [-12.0, 0.0, -52.0]),
            ("Right elbow", [-6.0, 10.0, -78.0]),
            ("Left collarbone", [0.0, 0.0, -2.0]),
            ("Left shoulder", [4.0, 0.0, -33.0]),
            ("Left elbow", [-18.8, -16.7, -2.8]),
            ("Left leg", [-3.0, 12.0, 2.0]),
            ("Right leg", [2.0, -4.0, -2.0]),
        ],
    },
    // adult-sit
    Pose {
        roots: &[("Root", [0.0, -0.402, 0.0])],
        joints: &[
            ("Root", [6.0, 0.0, 0.0]),
            ("Waist", [-8.0, 0.0, 0.0]),
            ("Neck", [-2.0, 14.0, 0.0]),
            ("Left leg", [-84.0, 8.0, 0.0]),
            ("Left knee", [84.0, 0.0, 0.0]),
            ("Left foot", [0.0, 0.0, 0.0]),
            ("Right leg", [-84.0, -8.0, 0.0]),
            ("Right knee", [84.0, 0.0, 0.0]),
            ("Right foot", [0.0, 0.0, 0.0]),
            ("Left shoulder", [-18.0, 0.0, -35.0]),
            ("Left elbow", [-41.1, -31.5, -12.1]),
            ("Right shoulder", [-18.0, 0.0, 35.0]),
            ("Right elbow", [-41.1, 31.5, 12.1]),
        ],
    },
    // robot-greet
    Pose {
        roots: &[("Root", [0.0, 0.0, 0.0])],
        joints: &[
            ("Torso", [0.0, -8.0, 0.0]),
            ("Neck", [0.0, -8.0, 0.0]),
            ("Head", [-4.0, -6.0, 10.0]),
            ("Antenna", [0.0, 0.0, -14.0]),
            ("Right shoulder", [0.0, 0.0, -108.0]),
            ("Right elbow", [0.0, 0.0, -42.0]),
            ("Right upper jaw", [-16.0, 0.0, 0.0]),
            ("Right lower jaw", [16.0, 0.0, 0.0]),
            ("Left shoulder", [10.0, 0.0, -6.0]),
            ("Left elbow", [-28.0, 0.0, 0.0]),
        ],
    },
    // robot-march
    Pose {
        roots: &[("Root", [0.0, -0.026, 0.0])],
        joints: &[
            ("Torso", [4.0, 6.0, 0.0]),
            ("Head", [0.0, -6.0, 0.0]),
            ("Left leg", [-46.0, 0.0, 0.0]),
            ("Left knee", [52.0, 0.0, 0.0]),
            ("Left foot", [-4.0, 0.0, 0.0]),
            ("Right leg", [14.0, 0.0, 0.0]),
            ("Right knee", [8.0, 0.0, 0.0]),
            ("Right foot", [-18.0, 0.0, 0.0]),
            ("Left shoulder", [34.0, 0.0, -8.0]),
            ("Left elbow", [-40.0, 0.0, 0.0]),
            ("Right shoulder", [-40.0, 0.0, 8.0]),
            ("Right elbow", [-55.0, 0.0, 0.0]),
        ],
    },
    // dog-trot
    Pose {
        roots: &[("Root", [0.0, -0.008, 0.0])],
        joints: &[
            ("Neck", [6.0, 0.0, 0.0]),
            ("Head", [-4.0, 0.0, 0.0]),
            ("Jaw", [9.0, 0.0, 0.0]),
            ("Tail", [34.0, 6.0, 0.0]),
            ("Tail middle", [12.0, 6.0, 0.0]),
            ("Tail end", [10.0, 6.0, 0.0]),
            ("Left shoulder", [-20.0, 0.0, 0.0]),
            ("Left elbow", [-26.0, 0.0, 0.0]),
            ("Left wrist", [52.0, 0.0, 0.0]),
            ("Left front paw", [24.0, 0.0, 0.0]),
            ("Right shoulder", [16.0, 0.0, 0.0]),
            ("Right elbow", [4.0, 0.0, 0.0]),
            ("Right front paw", [-18.0, 0.0, 0.0]),
            ("Right thigh", [-22.0, 0.0, 0.0]),
            ("Right knee", [30.0, 0.0, 0.0]),
            ("Right hock", [-22.0, 0.0, 0.0]),
            ("Right hind paw", [26.0, 0.0, 0.0]),
            ("Left thigh", [16.0, 0.0, 0.0]),
            ("Left knee", [-6.0, 0.0, 0.0]),
            ("Left hock", [6.0, 0.0, 0.0]),
            ("Left hind paw", [-14.0, 0.0, 0.0]),
        ],
    },
    // dog-sit
    Pose {
        roots: &[("Root", [0.0, -0.129, 0.0])],
        joints: &[
            ("Root", [-30.0, 0.0, 0.0]),
            ("Hips", [-14.0, 0.0, 0.0]),
            ("Neck", [14.0, 0.0, 0.0]),
            ("Head", [20.0, 12.0, 8.0]),
            ("Tail", [52.0, 0.0, 0.0]),
            ("Tail middle", [22.0, 10.0, 0.0]),
            ("Left shoulder", [26.0, 0.0, 0.0]),
            ("Left elbow", [4.0, 0.0, 0.0]),
            ("Left front paw", [2.0, 0.0, 0.0]),
            ("Right shoulder", [26.0, 0.0, 0.0]),
            ("Right elbow", [4.0, 0.0, 0.0]),
            ("Right front paw", [2.0, 0.0, 0.0]),
            ("Left thigh", [-12.0, 0.0, 4.0]),
            ("Left knee", [48.0, 0.0, 0.0]),
            ("Left hock", [-58.0, 0.0, 0.0]),
            ("Left hind paw", [66.0, 0.0, 0.0]),
            ("Right thigh", [-12.0, 0.0, -4.0]),
            ("Right knee", [48.0, 0.0, 0.0]),
            ("Right hock", [-58.0, 0.0, 0.0]),
            ("Right hind paw", [66.0, 0.0, 0.0]),
        ],
    },
    // humanoid-point
    Pose {
        roots: &[("Hips", [0.0, 0.0, 0.0])],
        joints: &[
            ("Spine", [0.0, 6.0, -2.0]),
            ("Chest", [0.0, 6.0, 0.0]),
            ("Neck", [0.0, 10.0, 0.0]),
            ("Head", [-4.0, 14.0, -3.0]),
            ("Left arm", [0.0, -46.0, 50.0]),
            ("Left forearm", [0.0, 8.0, 2.0]),
            ("Left hand", [0.0, 0.0, 8.0]),
            ("Left thumb 1", [0.0, 20.0, -20.0]),
            ("Left thumb 2", [0.0, 30.0, -20.0]),
            ("Left index 1", [0.0, 0.0, 6.0]),
            ("Left index 2", [0.0, 0.0, 16.0]),
            ("Left middle 1", [0.0, 0.0, -72.0]),
            ("Left middle 2", [0.0, 0.0, -84.0]),
            ("Left ring 1", [0.0, 0.0, -76.0]),
            ("Left ring 2", [0.0, 0.0, -84.0]),
            ("Left little 1", [0.0, 0.0, -78.0]),
            ("Left little 2", [0.0, 0.0, -84.0]),
            ("Right arm", [6.0, 0.0, 32.0]),
            ("Right forearm", [-24.0, 0.0, 6.0]),
        ],
    },
    // face-wink
    Pose {
        roots: &[("Shoulders", [0.0, 0.0, 0.0])],
        joints: &[
            ("Neck", [0.0, 8.0, -4.0]),
            ("Head", [4.0, 10.0, -6.0]),
            ("Jaw", [7.0, 0.0, 0.0]),
            ("Left mouth corner", [0.0, 0.0, 20.0]),
            ("Right mouth corner", [0.0, 0.0, -20.0]),
            ("Left eye", [0.0, -14.0, 0.0]),
            ("Right eye", [0.0, -14.0, 0.0]),
            ("Right upper lid", [38.0, 0.0, 0.0]),
            ("Right lower lid", [-10.0, 0.0, 0.0]),
            ("Left brow", [0.0, 0.0, 12.0]),
        ],
    },
    // creature-wave
    Pose {
        roots: &[
            ("Left hand", [0.02, 0.42, 0.1]),
            ("Right hand", [0.1, -0.06, 0.06]),
        ],
        joints: &[
            ("Head", [0.0, 14.0, -9.0]),
            ("Left ear", [0.0, 0.0, -16.0]),
            ("Right ear", [0.0, 0.0, -10.0]),
            ("Left eye", [-6.0, 12.0, 0.0]),
            ("Right eye", [-6.0, 12.0, 0.0]),
            ("Tail 1", [10.0, 0.0, 10.0]),
            ("Tail 2", [6.0, 0.0, 16.0]),
            ("Tail 3", [10.0, 0.0, 22.0]),
            ("Tail 4", [10.0, 0.0, 30.0]),
            ("Left hand", [-96.0, 20.0, 10.0]),
            ("Right hand", [24.0, 10.0, 0.0]),
        ],
    },
    // tentacle-curl
    Pose {
        roots: &[("Segment 1", [0.0, 0.0, 0.0])],
        joints: &[
            ("Segment 2", [0.0, 0.0, 12.0]),
            ("Segment 3", [0.0, 20.0, 14.0]),
            ("Segment 4", [8.0, 0.0, 6.0]),
            ("Segment 5", [10.0, 0.0, -20.0]),
            ("Segment 6", [0.0, -20.0, -34.0]),
            ("Segment 7", [0.0, 0.0, -30.0]),
            ("Segment 8", [0.0, 0.0, -26.0]),
            ("Segment 9", [0.0, 0.0, -40.0]),
            ("Segment 10", [0.0, 0.0, -40.0]),
        ],
    },
    // lizard-turn
    Pose {
        roots: &[("Hips", [0.0, 0.0, 0.0])],
        joints: &[
            ("Back 1", [0.0, -12.0, 0.0]),
            ("Back 2", [0.0, 16.0, 0.0]),
            ("Back 3", [0.0, 14.0, 0.0]),
            ("Neck", [-20.0, 20.0, 0.0]),
            ("Head", [-8.0, 14.0, 8.0]),
            ("Tail 1", [0.0, 14.0, 0.0]),
            ("Tail 2", [0.0, 24.0, 0.0]),
            ("Tail 3", [-6.0, 32.0, 0.0]),
            ("Tail 4", [-10.0, 34.0, 0.0]),
            ("Tail 5", [-6.0, 36.0, 0.0]),
            ("Tail 6", [0.0, 30.0, 0.0]),
        ],
    },
    // chain-snake
    Pose {
        roots: &[("Link 1", [0.0, 0.0, 0.0])],
        joints: &[
            ("Link 2", [10.0, 0.0, 34.0]),
            ("Link 3", [0.0, 0.0, -40.0]),
            ("Link 4", [20.0, 0.0, -40.0]),
            ("Link 5", [0.0, 0.0, 42.0]),
            ("Link 6", [34.0, 0.0, 30.0]),
        ],
    },
];
