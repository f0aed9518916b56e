//! Poses that show the characters off, as files for the command line's `--pose`.
use std::fmt::Write;

/// A pose: joints by name with their Euler angles in degrees (Rx · Ry · Rz, about the axes of the
/// world at rest), and how far the root moves.
struct Pose {
    root: [f64; 3],
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
    let [x, y, z] = pose.root;
    let _ = writeln!(
        text,
        "  }},\n  \"roots\": {{ \"Root\": [{x}, {y}, {z}] }}\n}}"
    );
    text
}

const POSES: &[Pose] = &[
    // adult-walk
    Pose {
        root: [0.0, -0.053, 0.0],
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
        root: [0.0, 0.007, 0.0],
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
        root: [0.0, -0.402, 0.0],
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
        root: [0.0, 0.0, 0.0],
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
        root: [0.0, -0.026, 0.0],
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
        root: [0.0, -0.008, 0.0],
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
        root: [0.0, -0.129, 0.0],
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
];
