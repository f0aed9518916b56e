use crate::geometry::{Basis, Curve, CurveForm};
use crate::scene::{CurveItemKind, CurveSet};
use std::collections::HashSet;
use std::fmt::{self, Write};

/// `set` as the text of a `.swp` file. Numbers are written with as many digits as it takes to
/// read the same ones back.
///
/// A surface finds its curves by name, the latest of several. Where a curve is meant that a
/// later one of the same name hides, it is written under a name of its own.
pub fn to_swp(set: &CurveSet) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write_items(&mut text, set);
    text
}

fn write_items(text: &mut String, set: &CurveSet) -> fmt::Result {
    let names = names(set);
    for (item, name) in set.items().iter().zip(&names) {
        if !text.is_empty() {
            text.push('\n');
        }
        match &item.kind {
            CurveItemKind::Curve(curve) => write_curve(text, name, curve)?,
            CurveItemKind::Revolution { steps, profile } => {
                writeln!(text, "srev {name} {steps} {}", names[*profile])?;
            }
            CurveItemKind::Sweep { profile, sweep } => {
                writeln!(text, "gcyl {name} {} {}", names[*profile], names[*sweep])?;
            }
        }
    }
    Ok(())
}

fn write_curve(text: &mut String, name: &str, curve: &Curve) -> fmt::Result {
    let steps = curve.steps();
    match curve.form() {
        CurveForm::Circle { radius } => writeln!(text, "circ {name} {steps} {radius}"),
        CurveForm::Spline {
            basis,
            flat,
            control_points,
        } => {
            let basis = match basis {
                Basis::Bezier => "bez",
                Basis::BSpline => "bsp",
            };
            let dimension = if *flat { 2 } else { 3 };
            let count = control_points.len();
            writeln!(text, "{basis}{dimension} {name} {steps} {count}")?;
            for point in control_points {
                if *flat {
                    writeln!(text, "[{} {}]", point.x, point.y)?;
                } else {
                    writeln!(text, "[{} {} {}]", point.x, point.y, point.z)?;
                }
            }
            Ok(())
        }
    }
}

/// The name under which each item is written.
fn names(set: &CurveSet) -> Vec<String> {
    let items = set.items();
    let mut names: Vec<String> = items.iter().map(|item| item.name.clone()).collect();
    let mut taken: HashSet<String> = names.iter().cloned().collect();
    for (index, item) in items.iter().enumerate() {
        let used = match item.kind {
            CurveItemKind::Curve(_) => vec![],
            CurveItemKind::Revolution { profile, .. } => vec![profile],
            CurveItemKind::Sweep { profile, sweep } => vec![profile, sweep],
        };
        for curve in used {
            let hidden = (curve + 1..index)
                .any(|later| items[later].curve().is_some() && names[later] == names[curve]);
            if hidden {
                names[curve] = free_name(&items[curve].name, &taken);
                taken.insert(names[curve].clone());
            }
        }
    }
    names
}

fn free_name(base: &str, taken: &HashSet<String>) -> String {
    let base = if base == "." { "curve" } else { base };
    (1..)
        .map(|number| format!("{base}{number}"))
        .find(|name| !taken.contains(name))
        .unwrap_or_else(|| base.to_owned())
}
