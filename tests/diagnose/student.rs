//! Skinning as a student writes it, in single precision and straight from the assignment, with a
//! place for every mistake.

use crate::diagnose::figures::Figure;
use glam::{Mat4, Vec3};

/// Weights that count, each with the index of its joint.
pub type Weights = Vec<(usize, f32)>;

/// The parts of the program that a mistake may be in.
#[derive(Clone)]
pub struct Student {
    /// The angles of a slider as they arrive.
    pub slider: fn(Vec3) -> Vec3,
    pub to_radians: fn(f32) -> f32,
    /// The rotation from radians about x, y and z.
    pub rotation: fn(Mat4, Mat4, Mat4) -> Mat4,
    pub keep_rotation: fn(Mat4) -> Mat4,
    /// The transform of a joint from its offset and its rotation.
    pub joint: fn(Mat4, Mat4) -> Mat4,
    /// The transform in the world from the parent's and the own one.
    pub push: fn(Mat4, Mat4) -> Mat4,
    pub push_bind: fn(Mat4, Mat4) -> Mat4,
    /// What moves a vertex, from T and B.
    pub product: fn(Mat4, Mat4) -> Mat4,
    /// Where what moves a vertex takes it.
    pub moved: fn(Mat4, Vec3) -> Vec3,
    /// The rows of weights that are read, from those of the file.
    pub rows: fn(&[Vec<f32>]) -> Vec<Vec<f32>>,
    /// The weights of a row that are read, one a column.
    pub row: fn(&[f32]) -> Vec<f32>,
    pub joint_of_column: fn(usize) -> usize,
    /// Which weights count, of those that are not zero.
    pub weights: fn(Weights) -> Weights,
    /// Joints in the order in which the program has them.
    pub joints: fn(&Figure) -> Vec<usize>,
    /// For each vertex that is written: which `v` line, and which row of weights.
    pub vertices: fn(&Figure) -> Vec<(usize, usize)>,
    /// The weighted sum that is kept.
    pub sum: fn(Vec3) -> Vec3,
    /// What is written for a vertex.
    pub write: fn(Vec3) -> Vec3,
}

/// The program without a mistake.
pub const RIGHT: Student = Student {
    slider: |degrees| degrees,
    to_radians: |degrees| degrees * std::f32::consts::PI / 180.0,
    rotation: |x, y, z| x * y * z,
    keep_rotation: |rotation| rotation,
    joint: |offset, rotation| offset * rotation,
    push: |parent, own| parent * own,
    push_bind: |parent, own| parent * own,
    product: |t, b| t * b.inverse(),
    moved: |matrix, vertex| matrix.transform_point3(vertex),
    rows: |rows| rows.to_vec(),
    row: |row| row.to_vec(),
    joint_of_column: |column| column + 1,
    weights: |weights| weights,
    joints: |figure| (0..figure.parents.len()).collect(),
    vertices: |figure| (0..figure.positions.len()).map(|i| (i, i)).collect(),
    sum: |sum| sum,
    write: |vertex| vertex,
};

impl Student {
    /// The vertices that the program writes.
    pub fn skin(&self, figure: &Figure) -> Vec<Vec3> {
        let joints = (self.joints)(figure);
        let mut own = vec![Mat4::IDENTITY; joints.len()];
        let mut own_at_rest = own.clone();
        for (index, &joint) in joints.iter().enumerate() {
            let offset = Mat4::from_translation(figure.offsets[joint]);
            // The slider of this index belongs to this joint of the program's list.
            let angles = (self.slider)(figure.degrees[index]).map(self.to_radians);
            let rotation = (self.rotation)(
                Mat4::from_rotation_x(angles.x),
                Mat4::from_rotation_y(angles.y),
                Mat4::from_rotation_z(angles.z),
            );
            own[joint] = (self.joint)(offset, (self.keep_rotation)(rotation));
            own_at_rest[joint] = (self.joint)(offset, Mat4::IDENTITY);
        }
        let world = |own: &[Mat4], push: fn(Mat4, Mat4) -> Mat4, joint: usize| {
            let mut line = vec![joint];
            while let Some(parent) = figure.parents[*line.last().unwrap()] {
                line.push(parent);
            }
            let mut top = Mat4::IDENTITY;
            for &joint in line.iter().rev() {
                top = push(top, own[joint]);
            }
            top
        };
        let palette: Vec<Mat4> = joints
            .iter()
            .map(|&joint| {
                let t = world(&own, self.push, joint);
                let b = world(&own_at_rest, self.push_bind, joint);
                (self.product)(t, b)
            })
            .collect();
        let rows = (self.rows)(&figure.rows);
        let skinned = (self.vertices)(figure).into_iter().map(|(position, row)| {
            let row = (self.row)(&rows[row]);
            let columns = row.iter().enumerate();
            let weights = columns
                .filter(|(_, weight)| **weight != 0.0)
                .map(|(column, weight)| ((self.joint_of_column)(column), *weight));
            let mut moved = Vec3::ZERO;
            for (joint, weight) in (self.weights)(weights.collect()) {
                // Beyond the last joint a program may read whatever it finds, or have put nothing.
                let joint = palette.get(joint).copied().unwrap_or(Mat4::ZERO);
                moved += weight * (self.moved)(joint, figure.positions[position]);
            }
            (self.write)((self.sum)(moved))
        });
        skinned.collect()
    }
}

/// A mistake of a student: its name, what part of the program it is in, and how it is made.
pub struct Wrong {
    pub id: &'static str,
    pub part: &'static str,
    pub make: fn(&mut Student),
}

/// The program with mistakes, each made in its first way.
pub fn with(ids: &[&str]) -> Student {
    let mut student = RIGHT;
    for id in ids {
        let wrong = WRONG.iter().find(|wrong| wrong.id == *id).unwrap();
        (wrong.make)(&mut student);
    }
    student
}

const fn wrong(id: &'static str, part: &'static str, make: fn(&mut Student)) -> Wrong {
    Wrong { id, part, make }
}

fn sum(weights: &[(usize, f32)]) -> f32 {
    weights.iter().map(|(_, weight)| weight).sum()
}

/// Weights without those of the adult's last joint, the left elbow.
pub fn without_last_joint(mut weights: Weights) -> Weights {
    weights.retain(|(joint, _)| *joint != 17);
    weights
}

fn normalized(weights: Weights) -> Weights {
    let sum = sum(&weights);
    weights
        .into_iter()
        .map(|(joint, weight)| (joint, weight / sum))
        .collect()
}

fn largest(mut weights: Weights, most: usize) -> Weights {
    weights.sort_by(|a, b| b.1.partial_cmp(&a.1).unwrap());
    weights.truncate(most);
    weights
}

/// Joints as a recursion from the root meets them.
fn in_tree_order(figure: &Figure) -> Vec<usize> {
    fn visit(figure: &Figure, joint: usize, order: &mut Vec<usize>) {
        order.push(joint);
        for child in 0..figure.parents.len() {
            if figure.parents[child] == Some(joint) {
                visit(figure, child, order);
            }
        }
    }
    let mut order = Vec::new();
    for root in 0..figure.parents.len() {
        if figure.parents[root].is_none() {
            visit(figure, root, &mut order);
        }
    }
    order
}

fn by_distance_from_the_root(figure: &Figure) -> Vec<usize> {
    let depth = |mut joint: usize| {
        let mut depth = 0;
        while let Some(parent) = figure.parents[joint] {
            (joint, depth) = (parent, depth + 1);
        }
        depth
    };
    let mut order: Vec<usize> = (0..figure.parents.len()).collect();
    order.sort_by_key(|&joint| depth(joint));
    order
}

fn as_a_queue_has_them(figure: &Figure) -> Vec<usize> {
    let joints = 0..figure.parents.len();
    let mut order: Vec<usize> = joints
        .clone()
        .filter(|&joint| figure.parents[joint].is_none())
        .collect();
    let mut next = 0;
    while next < order.len() {
        let parent = Some(order[next]);
        order.extend(
            joints
                .clone()
                .filter(|&joint| figure.parents[joint] == parent),
        );
        next += 1;
    }
    order
}

/// The `v` line of each vertex that `tobj` gives.
fn as_tobj_has_them(figure: &Figure) -> Vec<usize> {
    let mut text = String::new();
    // The number of the line tells vertices apart that lie in one place.
    for line in 0..figure.positions.len() {
        text += &format!("v {line} 0 0\n");
    }
    for [a, b, c] in &figure.triangles {
        text += &format!("f {} {} {}\n", a + 1, b + 1, c + 1);
    }
    let options = tobj::LoadOptions {
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials).unwrap();
    let lines = models[0]
        .mesh
        .positions
        .chunks(3)
        .map(|vertex| vertex[0] as usize);
    lines.collect()
}

/// Every mistake as a student makes it, some in several ways.
pub const WRONG: &[Wrong] = &[
    wrong("weights-shifted", "columns", |s| {
        s.joint_of_column = |column| column
    }),
    wrong("weights-shifted", "columns", |s| {
        s.row = |row| row.iter().skip(1).copied().chain([0.0]).collect();
    }),
    wrong("weights-shifted-on", "columns", |s| {
        s.joint_of_column = |column| column + 2
    }),
    wrong("weight-rows-shifted", "rows", |s| {
        s.rows = |rows| {
            let none = vec![0.0; rows[0].len()];
            rows.iter().skip(1).cloned().chain([none]).collect()
        };
    }),
    wrong("weight-rows-shifted", "rows", |s| {
        s.rows = |rows| {
            let none = vec![0.0; rows[0].len()];
            [none].into_iter().chain(rows.iter().cloned()).collect()
        };
    }),
    wrong("no-inverse-bind", "product", |s| s.product = |t, _| t),
    wrong("inverse-bind-only", "product", |s| {
        s.product = |_, b| b.inverse()
    }),
    wrong("bind-not-inverted", "product", |s| s.product = |t, b| t * b),
    wrong("factors-swapped", "product", |s| {
        s.product = |t, b| b.inverse() * t
    }),
    wrong("matrix-transposed", "product", |s| {
        s.product = |t, b| (t * b.inverse()).transpose()
    }),
    wrong("matrix-transposed", "product", |s| {
        s.product = |t, b| (t * b.inverse()).transpose();
        s.moved = |matrix, vertex| matrix.project_point3(vertex);
    }),
    wrong("matrix-transposed", "product", |s| {
        s.product = |t, b| t.transpose() * b.inverse()
    }),
    wrong("matrix-transposed", "product", |s| {
        s.product = |t, b| t * b.inverse().transpose()
    }),
    wrong("parent-missing", "stack", |s| {
        s.push = |_, own| own;
        s.push_bind = |_, own| own;
    }),
    wrong("parent-missing", "stack", |s| s.push = |_, own| own),
    wrong("bind-parent-missing", "stack", |s| {
        s.push_bind = |_, own| own
    }),
    wrong("parent-order", "stack", |s| {
        s.push = |parent, own| own * parent;
        s.push_bind = |parent, own| own * parent;
    }),
    wrong("euler-xzy", "order", |s| s.rotation = |x, y, z| x * z * y),
    wrong("euler-yxz", "order", |s| s.rotation = |x, y, z| y * x * z),
    wrong("euler-yzx", "order", |s| s.rotation = |x, y, z| y * z * x),
    wrong("euler-zxy", "order", |s| s.rotation = |x, y, z| z * x * y),
    wrong("euler-zyx", "order", |s| s.rotation = |x, y, z| z * y * x),
    wrong("degrees-as-radians", "radians", |s| {
        s.to_radians = |degrees| degrees
    }),
    wrong("radians-as-degrees", "radians", |s| {
        s.to_radians = |degrees| degrees.to_radians().to_radians()
    }),
    wrong("rotation-transposed", "rotation", |s| {
        s.keep_rotation = |r| r.transpose()
    }),
    wrong("angles-negated", "slider", |s| s.slider = |angles| -angles),
    wrong("rotation-before-translation", "joint", |s| {
        s.joint = |t, r| r * t
    }),
    wrong("translation-missing", "joint", |s| s.joint = |_, r| r),
    wrong("pose-not-applied", "slider", |s| s.slider = |_| Vec3::ZERO),
    wrong("influences-cut-4", "weights", |s| {
        s.weights = |w| largest(w, 4)
    }),
    wrong("influences-cut-4", "weights", |s| {
        s.weights = |w| w.into_iter().take(4).collect()
    }),
    wrong("influences-cut-4-renormalized", "weights", |s| {
        s.weights = |w| normalized(largest(w, 4));
    }),
    wrong("influences-cut-4-renormalized", "weights", |s| {
        s.weights = |w| {
            if w.len() > 4 {
                normalized(largest(w, 4))
            } else {
                w
            }
        };
    }),
    wrong("influences-cut-4-renormalized", "weights", |s| {
        s.weights = |w| {
            let all = sum(&w);
            let kept = normalized(largest(w, 4));
            kept.into_iter()
                .map(|(joint, weight)| (joint, weight * all))
                .collect()
        };
    }),
    wrong("weights-normalized", "weights", |s| s.weights = normalized),
    wrong("weights-normalized", "weights", |s| {
        s.weights = |mut w| {
            w.push((0, 1.0 - sum(&w)));
            w
        };
    }),
    wrong("weights-doubled", "sum", |s| s.sum = |sum| sum + sum),
    wrong("strongest-joint-only", "weights", |s| {
        s.weights = |w| {
            largest(w, 1)
                .into_iter()
                .map(|(joint, _)| (joint, 1.0))
                .collect()
        };
    }),
    wrong("vertices-renumbered", "vertices", |s| {
        s.vertices = |figure| {
            let lines = as_tobj_has_them(figure);
            lines
                .into_iter()
                .enumerate()
                .map(|(row, line)| (line, row))
                .collect()
        };
    }),
    wrong("vertices-renumbered", "vertices", |s| {
        s.vertices = |figure| {
            let lines = as_tobj_has_them(figure);
            lines.into_iter().map(|line| (line, line)).collect()
        };
    }),
    wrong("vertices-renumbered", "vertices", |s| {
        s.vertices = |figure| {
            let corners = figure.triangles.iter().flatten();
            corners
                .map(|&corner| (corner as usize, corner as usize))
                .collect()
        };
    }),
    wrong("joints-by-depth", "list", |s| s.joints = in_tree_order),
    wrong("joints-by-depth", "list", |s| {
        s.joints = by_distance_from_the_root
    }),
    wrong("joints-by-depth", "list", |s| {
        s.joints = as_a_queue_has_them
    }),
    wrong("one-axis-ignored-x", "slider", |s| {
        s.slider = |a| Vec3::new(0.0, a.y, a.z)
    }),
    wrong("one-axis-ignored-y", "slider", |s| {
        s.slider = |a| Vec3::new(a.x, 0.0, a.z)
    }),
    wrong("one-axis-ignored-z", "slider", |s| {
        s.slider = |a| Vec3::new(a.x, a.y, 0.0)
    }),
    wrong("sign-flipped-x", "slider", |s| {
        s.slider = |a| Vec3::new(-a.x, a.y, a.z)
    }),
    wrong("sign-flipped-y", "slider", |s| {
        s.slider = |a| Vec3::new(a.x, -a.y, a.z)
    }),
    wrong("sign-flipped-z", "slider", |s| {
        s.slider = |a| Vec3::new(a.x, a.y, -a.z)
    }),
    wrong("mesh-mirrored", "write", |s| {
        s.write = |v| Vec3::new(-v.x, v.y, v.z)
    }),
    wrong("mesh-mirrored", "write", |s| {
        s.write = |v| Vec3::new(v.x, -v.y, v.z)
    }),
    wrong("mesh-mirrored", "write", |s| {
        s.write = |v| Vec3::new(v.x, v.y, -v.z)
    }),
];
