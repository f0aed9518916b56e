//! Names of steps for the Edit menu and the history, found by what has changed: so a gesture is
//! named for its result, whatever its edits were.

use super::Change;
use crate::character::{Mirror, Pose, SkeletalModel};
use crate::scene::{
    BoneStyle, CharacterDisplay, CharacterShape, CurveDisplay, CurveShape, CurveVisibility,
    JointStyle, ModelDisplay, Scene, Shape, ShapeKind, SurfaceVisibility,
};

/// Change of a shape: a verb, and what it is done to.
type Named = (&'static str, String);

/// Name of the step from one state of a scene to another, such as "Rotate Left elbow".
pub(super) fn step_name(before: &Scene, after: &Scene) -> String {
    let change = Change::between(before, after);
    let shape = |scene: &Scene, id| scene.shape(id).cloned();
    match (&*change.added, &*change.removed, &*change.altered) {
        ([added], [], []) => {
            shape(after, *added).map_or_else(String::new, |shape| inserted(&shape, before))
        }
        (added, [], []) if !added.is_empty() => format!("Insert {} shapes", added.len()),
        ([], [removed], []) => shape(before, *removed)
            .map_or_else(String::new, |shape| format!("Delete {}", shape.name)),
        ([], removed, []) if !removed.is_empty() => format!("Delete {} shapes", removed.len()),
        ([], [], []) => "Reorder shapes".to_owned(),
        ([], [], altered) => {
            let pairs = altered
                .iter()
                .filter_map(|&id| before.shape(id).zip(after.shape(id)));
            let mut changes: Vec<Named> = pairs.map(|(was, is)| altered_shape(was, is)).collect();
            let count = changes.len();
            let alike = changes.windows(2).all(|pair| pair[0].0 == pair[1].0);
            match changes.pop() {
                Some((verb, object)) if count == 1 => format!("{verb} {object}"),
                Some((verb, _)) if alike => format!("{verb} {count} shapes"),
                _ => format!("Change {count} shapes"),
            }
        }
        _ => "Change the scene".to_owned(),
    }
}

/// Name of the step that adds shapes from the clipboard.
pub(super) fn pasting_name(after: &Scene, change: &Change) -> String {
    match &*change.added {
        &[added] => {
            let name = after.shape(added).map_or("", |shape| &shape.name);
            format!("Paste {name}")
        }
        added => format!("Paste {} shapes", added.len()),
    }
}

fn inserted(shape: &Shape, before: &Scene) -> String {
    let from_file = shape.source.as_ref().is_some_and(|s| !s.is_builtin());
    let mut others = before.shapes().iter();
    let verb = if others.any(|other| shares_character(shape, other)) {
        "Duplicate"
    } else if from_file {
        "Import"
    } else {
        "Insert"
    };
    format!("{verb} {}", shape.name)
}

/// Whether both shapes have one character in memory: a file that is read again makes another.
fn shares_character(one: &Shape, other: &Shape) -> bool {
    match (&one.kind, &other.kind) {
        (ShapeKind::Character(one), ShapeKind::Character(other)) => {
            std::sync::Arc::ptr_eq(&one.character, &other.character)
        }
        _ => false,
    }
}

fn altered_shape(was: &Shape, is: &Shape) -> Named {
    let name = &is.name;
    let mut found = Vec::new();
    if was.name != *name {
        found.push(("Rename to", name.clone()));
    }
    if was.visible != is.visible {
        found.push((if is.visible { "Show" } else { "Hide" }, name.clone()));
    }
    if was.locked != is.locked {
        found.push((if is.locked { "Lock" } else { "Unlock" }, name.clone()));
    }
    if was.placement != is.placement {
        found.push((placed(was, is), name.clone()));
    }
    match (&was.kind, &is.kind) {
        (same, kind) if same == kind => {
            if was.source != is.source {
                let file = |shape: &Shape| shape.source.as_ref().map(|source| source.file.clone());
                let is_elsewhere = file(was) != file(is);
                let verb = if is_elsewhere { "Relink" } else { "Reload" };
                found.push((verb, name.clone()));
            }
        }
        (ShapeKind::Character(was), ShapeKind::Character(is)) => {
            found.push(altered_character(was, is, name));
        }
        (ShapeKind::Curve(was), ShapeKind::Curve(is)) => {
            found.push(altered_curves(was, is, name));
        }
        _ => found.push(("Reload", name.clone())),
    }
    let is_reset = is.placement == is.start
        && !matches!(&is.kind, ShapeKind::Character(c) if !c.pose().is_bind());
    match found.len() {
        1 => found.swap_remove(0),
        2 if is_reset => ("Reset", name.clone()),
        _ => ("Change", name.clone()),
    }
}

fn placed(was: &Shape, is: &Shape) -> &'static str {
    let (from, to) = (&was.placement, &is.placement);
    let moved = from.transform.position != to.transform.position;
    let turned = from.transform.rotation != to.transform.rotation;
    let scaled = from.transform.scale != to.transform.scale;
    let colored = from.color != to.color;
    match (moved, turned, scaled, colored) {
        (true, false, false, false) => "Move",
        (false, true, false, false) => "Rotate",
        (false, false, true, false) => "Scale",
        (false, false, false, true) => "Color",
        // About a pivot that is not its origin.
        (true, true, false, false) if *to != is.start => "Rotate",
        (true, false, true, false) if *to != is.start => "Scale",
        (false, false, false, false) => "Change the scaling of",
        _ if *to == is.start => "Reset",
        _ => "Place",
    }
}

fn altered_character(was: &CharacterShape, is: &CharacterShape, name: &str) -> Named {
    let skeleton = is.character.skeleton();
    let joint = |index: usize| {
        let joint = skeleton.joints().get(index);
        joint.map_or_else(|| name.to_owned(), |joint| joint.name.clone())
    };
    if !std::sync::Arc::ptr_eq(&was.character, &is.character) {
        return ("Reload", name.to_owned());
    }
    if was.pose() != is.pose() {
        return posed(skeleton, was.pose(), is.pose(), name);
    }
    if was.missing_joints.pose != is.missing_joints.pose {
        return ("Reset the pose of", name.to_owned());
    }
    if was.poses() != is.poses() {
        let (long, short, verb) = if is.poses().len() < was.poses().len() {
            (was, is, "Remove")
        } else {
            (is, was, "Keep")
        };
        let only = long
            .poses()
            .iter()
            .find(|pose| !short.poses().contains(pose));
        return (
            verb,
            only.map_or_else(|| name.to_owned(), |pose| pose.name.clone()),
        );
    }
    if was.skinning_method() != is.skinning_method() {
        return ("Change the skinning of", name.to_owned());
    }
    if was.ik.pins != is.ik.pins {
        let mut differ = was.ik.pins.symmetric_difference(&is.ik.pins);
        let verb = if is.ik.pins.len() > was.ik.pins.len() {
            "Pin"
        } else {
            "Unpin"
        };
        let one = differ.next().filter(|_| differ.next().is_none());
        return (
            verb,
            one.map_or_else(|| name.to_owned(), |&index| joint(index)),
        );
    }
    if was.missing_joints.pins != is.missing_joints.pins {
        return ("Unpin", name.to_owned());
    }
    if was.ik != is.ik {
        return ("Change the IK of", name.to_owned());
    }
    displayed(was.display, is.display, name)
}

fn displayed(was: CharacterDisplay, is: CharacterDisplay, name: &str) -> Named {
    let verb = if was.mode != is.mode {
        match is.mode {
            ModelDisplay::Skeleton => "Show the skeleton of",
            ModelDisplay::Mesh => "Show the mesh of",
            ModelDisplay::Both => "Show mesh and skeleton of",
        }
    } else if was.joints != is.joints {
        match is.joints {
            JointStyle::Points => "Show points as joints of",
            JointStyle::Spheres => "Show spheres as joints of",
        }
    } else if was.bones != is.bones {
        match is.bones {
            BoneStyle::Lines => "Show lines as bones of",
            BoneStyle::Boxes => "Show boxes as bones of",
        }
    } else if was.point_size != is.point_size {
        "Change the point size of"
    } else {
        "Change the line width of"
    };
    (verb, name.to_owned())
}

fn posed(skeleton: &SkeletalModel, was: &Pose, is: &Pose, name: &str) -> Named {
    let joints = skeleton.joints();
    let all = 0..joints.len();
    let turned: Vec<usize> = all
        .clone()
        .filter(|&j| was.rotation(j) != is.rotation(j))
        .collect();
    let moved: Vec<usize> = all
        .filter(|&j| was.root_offset(j) != is.root_offset(j))
        .collect();
    match (&*turned, &*moved) {
        (&[joint], []) | ([], &[joint]) if !is.is_changed(joint) => {
            ("Reset", joints[joint].name.clone())
        }
        (&[joint], []) => ("Rotate", joints[joint].name.clone()),
        ([], &[joint]) => ("Move", joints[joint].name.clone()),
        ([], _) => ("Move", name.to_owned()),
        _ if is.is_bind() => ("Reset the pose of", name.to_owned()),
        _ if *is == Mirror::new(skeleton).pose(was) => ("Mirror the pose of", name.to_owned()),
        _ => ("Pose", name.to_owned()),
    }
}

fn altered_curves(was: &CurveShape, is: &CurveShape, name: &str) -> Named {
    let (before, after) = (was.curves().items(), is.curves().items());
    if before.len() < after.len() {
        let added = after.last().map_or(name, |item| &item.name);
        return ("Add", added.to_owned());
    }
    if before.len() > after.len() {
        let kept = |name: &str| after.iter().any(|item| item.name == name);
        let gone = before.iter().find(|item| !kept(&item.name));
        return ("Remove", gone.map_or(name, |item| &item.name).to_owned());
    }
    let changed = before.iter().zip(after).find(|(was, is)| was != is);
    match changed {
        Some((_, item)) => ("Edit", item.name.clone()),
        None => displayed_curves(was.display, is.display, name),
    }
}

fn displayed_curves(was: CurveDisplay, is: CurveDisplay, name: &str) -> Named {
    let verb = if was.control_points != is.control_points {
        match is.control_points {
            true => "Show the control points of",
            false => "Hide the control points of",
        }
    } else if was.curve != is.curve {
        match is.curve {
            CurveVisibility::Off => "Hide the curves of",
            CurveVisibility::On => "Show the curves of",
            CurveVisibility::OnWithFrames => "Show curves with frames of",
        }
    } else if was.surface != is.surface {
        match is.surface {
            SurfaceVisibility::Off => "Hide the surfaces of",
            SurfaceVisibility::WireframeWithNormals => "Show the wireframe of",
            SurfaceVisibility::Shaded => "Shade the surfaces of",
        }
    } else {
        // Frames of a closed curve meet, or do not any more.
        "Change the frames of"
    };
    (verb, name.to_owned())
}
