//! By how much something that is held has turned or moved, in words.

use super::held::{Drag, Held};
use crate::editor::{Constraint, GizmoAxes, IkDrag, MoveAlong, MoveDrag};

impl Held {
    /// What becomes of pins that are out of reach, if some are, once the drag is over.
    pub(super) fn lost_pins(&self) -> Option<String> {
        match self.ik()?.lost_pins().len() {
            0 => None,
            1 => Some("A pin was out of reach, and holds where its joint is now".to_owned()),
            lost => Some(format!(
                "{lost} pins were out of reach, and hold where their joints are now"
            )),
        }
    }

    /// By how much it has turned or moved, as text, or what is typed for that; with the axes of the joint or shape if it
    /// is along these that keys hold it.
    pub(super) fn readout(&self) -> String {
        let amount = match self.typed.constraint(self.axes) {
            Some((_, axes)) if axes == GizmoAxes::Local || self.scales_turned() => {
                format!("local {}", self.amount())
            }
            _ => self.amount(),
        };
        match self.typed.why_ended() {
            Some(why) => format!("{amount} {why}"),
            None => amount,
        }
    }

    /// Whether it scales a turned shape, which is always along the shape's own axes.
    fn scales_turned(&self) -> bool {
        match &self.drag {
            Drag::Scale(drag) => drag.group().is_turned(),
            _ => false,
        }
    }

    fn amount(&self) -> String {
        let typed = self.typed.shown();
        let constraint = self.typed.constraint(self.axes).map(|(along, _)| along);
        let about = constraint.map_or("", |about| letter(about.named()));
        let turned = |angle: f64| match &typed {
            Some(typed) => format!("{about}{typed}°"),
            None => {
                // What rounds to nothing has no sign.
                let tenths = ((angle * self.sign()).to_degrees() * 10.0).round() / 10.0;
                format!("{about}{:+.1}°", tenths + 0.0)
            }
        };
        // A number goes along the first axis of a plane.
        let along = constraint.and_then(|along| along.axes().next());
        let along = along.map_or("", letter);
        match &self.drag {
            Drag::Bone(drag) => turned(drag.angle()),
            Drag::Ring(drag) => turned(drag.angle()),
            Drag::Turn(drag) => turned(drag.angle()),
            Drag::Scale(drag) => {
                let axes = drag.constraint().into_iter().flat_map(Constraint::axes);
                let letters: String = axes.map(letter).collect();
                let on_ground = match drag.stays_on_ground() {
                    true => ", on its ground",
                    false => "",
                };
                match typed {
                    Some(typed) => format!("{letters}× {typed}{on_ground}"),
                    None => format!("{letters}× {:.2}{on_ground}", drag.factor()),
                }
            }
            Drag::Move(drag) => match typed {
                Some(typed) => format!("{along}{typed}"),
                None => {
                    let by = drag.moved();
                    match self.typed.constraint(self.axes) {
                        Some((along, GizmoAxes::Local)) => moved_along(drag, along),
                        _ => format!("x {:+.2}  y {:+.2}  z {:+.2}", by.x, by.y, by.z),
                    }
                }
            },
            Drag::Ik(drag) => match typed {
                Some(typed) => match ik_trouble(drag) {
                    Some(trouble) => format!("{along}{typed}; {trouble}"),
                    None => format!("{along}{typed}"),
                },
                None => ik_readout(drag),
            },
            Drag::Stuck(..) => "a pin holds it".to_owned(),
        }
    }
}

/// Name of an axis before a number.
fn letter(axis: usize) -> &'static str {
    ["x ", "y ", "z "][axis]
}

/// How far a shape has moved along its own axes.
fn moved_along(drag: &MoveDrag, constraint: Constraint) -> String {
    let directions = match drag.along() {
        MoveAlong::Line(line) => vec![line],
        MoveAlong::Axes(first, second) => vec![first, second],
        MoveAlong::Plane(_) => Vec::new(),
    };
    let along = constraint.axes().zip(directions).map(|(axis, direction)| {
        let length = drag.moved().dot(direction.normalize_or_zero());
        format!("{}{length:+.2}", letter(axis))
    });
    along.collect::<Vec<_>>().join("  ")
}

/// What is amiss in a drag with the IK tool.
fn ik_trouble(drag: &IkDrag) -> Option<String> {
    let missed = drag.off() > IkDrag::OUT_OF_REACH;
    let missed = missed.then(|| format!("out of reach by {:.2}", drag.off()));
    let lost = match drag.lost_pins().len() {
        0 => None,
        1 => Some("a pin is out of reach".to_owned()),
        lost => Some(format!("{lost} pins are out of reach")),
    };
    match (missed, lost) {
        (Some(missed), Some(lost)) => Some(format!("{missed}; {lost}")),
        (missed, lost) => missed.or(lost),
    }
}

fn ik_readout(drag: &IkDrag) -> String {
    if let Some(trouble) = ik_trouble(drag) {
        return trouble;
    }
    match drag.chain().map(|chain| chain.joints().len()) {
        Some(1) => "1 joint follows".to_owned(),
        Some(count) => format!("{count} joints follow"),
        None => "all of it follows".to_owned(),
    }
}
