//! Documents at random: everything that a scene and its view can hold.

use super::support::{BOX, MAN, PAIR, Table, VASE};
use editor_core::character::{Pose, SkeletalModel};
use editor_core::geometry::{Basis, Curve};
use editor_core::io::{import_any, import_shape};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{
    BoneStyle, Camera, CharacterDisplay, CharacterShape, CurveDisplay, CurveItemKind, CurveSet,
    CurveShape, CurveVisibility, IkPole, IkSettings, JointStyle, KeptPose, Look, ModelDisplay,
    NewShape, Placement, Scene, Shading, ShapeColor, ShapeKind, SkinningMethod, SurfaceVisibility,
    ViewSettings,
};
use glam::Vec3;
use proptest::collection::{btree_set, vec};
use proptest::num::f32 as floats;
use proptest::prelude::*;
use proptest::sample::select;
use std::path::Path;

/// A finite number: any, or one of those that people type.
fn number() -> impl Strategy<Value = f32> {
    let any = floats::NORMAL | floats::SUBNORMAL | floats::ZERO;
    prop_oneof![
        any,
        -10.0_f32..10.0,
        (-100..100_i16).prop_map(|n| f32::from(n) / 10.0)
    ]
}

fn vector() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from)
}

/// Letters of all kinds, quotes, line breaks and nothing at all.
fn name() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<String>(),
        "[a-z\"\\\\\n\t\u{2028}😀é ]{0,6}",
        Just("Cube".to_owned())
    ]
}

fn color() -> impl Strategy<Value = ShapeColor> {
    let custom = [0.0_f32..=1.0, 0.0_f32..=1.0, 0.0_f32..=1.0];
    prop_oneof![
        (0..31_usize).prop_map(ShapeColor::Preset),
        custom.prop_map(|rgb| ShapeColor::Custom(Vec3::from(rgb))),
    ]
}

fn placement() -> impl Strategy<Value = Placement> {
    let parts = (vector(), vector(), vector(), any::<bool>(), color());
    parts.prop_map(
        |(position, radians, scale, uniform_scaling, color)| Placement {
            transform: Transform {
                position,
                rotation: Euler::from_radians(radians),
                scale,
            },
            uniform_scaling,
            color,
        },
    )
}

/// Joints by a number below that of the skeleton's, each with its angles and, if it is a root, its
/// offset.
type JointList = Vec<(usize, Vec3, Vec3)>;

fn joints() -> impl Strategy<Value = JointList> {
    vec((0..40_usize, vector(), vector()), 0..5)
}

fn pose_of(skeleton: &SkeletalModel, joints: &JointList) -> Pose {
    let mut pose = Pose::new();
    for &(joint, radians, offset) in joints {
        let joint = joint % skeleton.joints().len();
        pose.set_joint_transform(joint, Euler::from_radians(radians));
        let roots = skeleton.roots();
        pose.set_root_offset(roots[joint % roots.len()], offset);
    }
    pose
}

fn ik() -> impl Strategy<Value = IkSettings> {
    let pins = btree_set(0..40_usize, 0..4);
    let parts = (
        1..=999_usize,
        select(IkPole::ALL.to_vec()),
        any::<bool>(),
        pins,
    );
    parts.prop_map(|(length, pole, keep_orientation, pins)| IkSettings {
        length,
        pole,
        keep_orientation,
        pins,
    })
}

fn character_display() -> impl Strategy<Value = CharacterDisplay> {
    (
        select(vec![
            ModelDisplay::Skeleton,
            ModelDisplay::Mesh,
            ModelDisplay::Both,
        ]),
        select(vec![JointStyle::Points, JointStyle::Spheres]),
        select(vec![BoneStyle::Lines, BoneStyle::Boxes]),
        1.0_f32..=64.0,
        1.0_f32..=64.0,
    )
        .prop_map(
            |(mode, joints, bones, point_size, line_width)| CharacterDisplay {
                mode,
                joints,
                bones,
                point_size,
                line_width,
            },
        )
}

/// What the scene says of a character, whatever its skeleton is.
#[derive(Clone, Debug)]
pub struct Dress {
    pose: JointList,
    kept: Vec<(String, JointList)>,
    ik: IkSettings,
    display: CharacterDisplay,
    skinning_method: SkinningMethod,
}

fn dress() -> impl Strategy<Value = Dress> {
    let kept = vec((name(), joints()), 0..3);
    let methods = vec![SkinningMethod::LinearBlend, SkinningMethod::DualQuaternion];
    let parts = (joints(), kept, ik(), character_display(), select(methods));
    parts.prop_map(|(pose, kept, ik, display, skinning_method)| Dress {
        pose,
        kept,
        ik,
        display,
        skinning_method,
    })
}

impl Dress {
    fn put_on(&self, shape: &mut CharacterShape) {
        let character = shape.character.clone();
        let skeleton = character.skeleton();
        let count = skeleton.joints().len();
        let kept = self.kept.iter().map(|(name, joints)| KeptPose {
            name: name.clone(),
            pose: pose_of(skeleton, joints),
        });
        shape.set_poses(kept.collect());
        shape.set_pose(pose_of(skeleton, &self.pose));
        let pins = self.ik.pins.iter().map(|pin| pin % count).collect();
        shape.ik = IkSettings {
            pins,
            ..self.ik.clone()
        };
        shape.set_skinning_method(self.skinning_method);
        shape.display = self.display;
    }
}

fn coordinate() -> impl Strategy<Value = f32> {
    number().prop_map(|number| number.clamp(-1e9, 1e9))
}

fn point() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

fn curve() -> impl Strategy<Value = Curve> {
    let spline = |(is_bezier, flat, steps, points): (bool, bool, u32, Vec<Vec3>)| {
        let basis = if is_bezier {
            Basis::Bezier
        } else {
            Basis::BSpline
        };
        let whole = points.len() - (points.len() - 1) % 3;
        let points = if is_bezier {
            points[..whole].to_vec()
        } else {
            points
        };
        Curve::spline(basis, flat, steps, points).unwrap()
    };
    let splines = (any::<bool>(), any::<bool>(), 1..9_u32, vec(point(), 4..12));
    let circles = (1..40_u32, coordinate());
    prop_oneof![
        splines.prop_map(spline),
        circles.prop_map(|(steps, radius)| Curve::circle(steps, radius).unwrap()),
    ]
}

/// Curves, and surfaces of those that can be their profiles.
fn curve_set() -> impl Strategy<Value = CurveSet> {
    let surface = (any::<bool>(), 0..9_usize, 0..9_usize, 1..20_u32);
    let name = "[a-z.é\"]{1,4}";
    let parts = (vec((name, curve()), 0..5), vec((name, surface), 0..4));
    parts.prop_map(|(curves, surfaces)| {
        let mut set = CurveSet::new();
        let count = curves.len().max(1);
        for (name, curve) in curves {
            set.push(&name, CurveItemKind::Curve(curve)).unwrap();
        }
        for (name, (is_sweep, profile, sweep, steps)) in surfaces {
            let (profile, sweep) = (profile % count, sweep % count);
            let kind = if is_sweep {
                CurveItemKind::Sweep { profile, sweep }
            } else {
                CurveItemKind::Revolution { steps, profile }
            };
            // Refused where the profile leaves its plane.
            let _ = set.push(&name, kind);
        }
        set
    })
}

fn curves() -> impl Strategy<Value = ShapeKind> {
    let curve = select(vec![
        CurveVisibility::Off,
        CurveVisibility::On,
        CurveVisibility::OnWithFrames,
    ]);
    let surface = select(vec![
        SurfaceVisibility::Off,
        SurfaceVisibility::WireframeWithNormals,
        SurfaceVisibility::Shaded,
    ]);
    let parts = (curve_set(), any::<bool>(), curve, surface, any::<bool>());
    parts.prop_map(|(set, control_points, curve, surface, closing)| {
        let mut shape = CurveShape::new(set);
        shape.set_frame_closing(closing);
        shape.display = CurveDisplay {
            control_points,
            curve,
            surface,
        };
        ShapeKind::Curve(shape)
    })
}

/// Every kind of shape that is imported: each `import` gives one or several.
pub fn imported(files: &Table) -> Vec<NewShape> {
    let any = [
        MAN,
        BOX,
        VASE,
        PAIR,
        "builtin:adult",
        "builtin:gear",
        "builtin:vase",
    ];
    let mut shapes: Vec<NewShape> = any
        .iter()
        .flat_map(|path| import_any(files, Path::new(path)).unwrap().value)
        .collect();
    for path in [MAN, PAIR] {
        shapes.extend(import_shape(files, Path::new(path)).unwrap().value);
    }
    shapes
}

const SIMPLE: [ShapeKind; 6] = [
    ShapeKind::Cube,
    ShapeKind::Sphere,
    ShapeKind::Pyramid,
    ShapeKind::Teapot,
    ShapeKind::Icosahedron,
    ShapeKind::Custom,
];

fn kind(imported: Vec<NewShape>) -> impl Strategy<Value = NewShape> {
    let new = |kind: ShapeKind| NewShape::new("", kind);
    let imported = select(imported);
    let drawn_over = (imported.clone(), curves()).prop_map(|(mut shape, curves)| {
        if let ShapeKind::Curve(_) = shape.kind {
            shape.kind = curves;
        }
        shape
    });
    prop_oneof![
        1 => select(SIMPLE.to_vec()).prop_map(new),
        3 => imported,
        1 => curves().prop_map(new),
        1 => drawn_over,
    ]
}

fn shape(imported: Vec<NewShape>) -> impl Strategy<Value = NewShape> {
    let start = prop::option::of(placement());
    let flags = (any::<bool>(), any::<bool>());
    let parts = (kind(imported), name(), placement(), start, flags, dress());
    parts.prop_map(|(mut shape, name, placement, start, flags, dress)| {
        if let ShapeKind::Character(character) = &mut shape.kind {
            dress.put_on(character);
        }
        (shape.visible, shape.locked) = flags;
        NewShape {
            name,
            placement,
            start: start.unwrap_or(placement),
            ..shape
        }
    })
}

/// A scene of up to six shapes, made of what is `imported` and all else that there is.
pub fn scene(imported: Vec<NewShape>) -> impl Strategy<Value = Scene> {
    vec(shape(imported), 0..6).prop_map(|shapes| shapes.into_iter().collect())
}

pub fn view() -> impl Strategy<Value = ViewSettings> {
    let lens = (1.1_f32..169.0, 1e-3_f32..1e3, 1e-4_f32..1.0, 1.1_f32..1e5);
    let camera = (vector(), number(), number(), lens).prop_map(
        |(target, theta, phi, (fovy, radius, near, far))| Camera {
            target,
            radius,
            theta,
            phi,
            fovy: fovy.to_radians(),
            near,
            far,
        },
    );
    let look = select(vec![Look::Course, Look::Studio, Look::Mannequin]);
    let shading = select(vec![Shading::AsAuthored, Shading::Flat, Shading::Smooth]);
    (camera, look, shading, any::<[bool; 3]>()).prop_map(
        |(camera, look, shading, [axis, grid, bones])| ViewSettings {
            camera,
            look,
            axis,
            grid,
            bones,
            shading,
        },
    )
}
