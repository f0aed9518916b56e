//! Curves and surfaces in scene files of version 2, written out.

use super::data::CurveDisplayData;
use super::text::word;
use crate::geometry::{Basis, Curve, CurveForm};
use crate::io::json_text::{Members, Text};
use crate::scene::{CurveItem, CurveItemKind, CurveSet, CurveShape};
use glam::Vec3;
use serde::Deserialize;
use serde::de::Deserializer;
use serde_spanned::Spanned;

/// Curves and surfaces, and how they are drawn.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct CurvesData {
    pub display: CurveDisplayData,
    /// The curves; those of the file if there are none.
    pub items: Option<Vec<Spanned<ItemData>>>,
}

/// A curve or a surface.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ItemData {
    name: String,
    kind: ItemKind,
    flat: Option<bool>,
    steps: Option<u32>,
    radius: Option<f32>,
    control_points: Option<Vec<Point>>,
    profile: Option<u32>,
    sweep: Option<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum ItemKind {
    Bezier,
    Bspline,
    Circle,
    Revolution,
    Sweep,
}

#[derive(Clone, Copy, Debug)]
struct Point(Vec3);

impl<'de> Deserialize<'de> for Point {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        super::data::vector(deserializer).map(Self)
    }
}

/// The set of all `items`.
///
/// # Errors
/// At the first that is no curve or surface, or does not fit those before it: the byte of the text
/// where it starts, and the message.
pub(super) fn set(items: Vec<Spanned<ItemData>>) -> Result<CurveSet, (usize, String)> {
    let mut set = CurveSet::new();
    for item in items {
        let at = item.span().start;
        let item = item.into_inner();
        let name = item.name.clone();
        let kind = item.kind().map_err(|message| (at, message))?;
        set.push(&name, kind)
            .map_err(|error| (at, error.to_string()))?;
    }
    Ok(set)
}

impl ItemData {
    /// What it is, if it has the members of its kind and no others.
    fn kind(self) -> Result<CurveItemKind, String> {
        use ItemKind::{Bezier, Bspline, Circle, Revolution, Sweep};
        let wanted: &[&str] = match self.kind {
            Bezier | Bspline => &["flat", "steps", "control_points"],
            Circle => &["steps", "radius"],
            Revolution => &["steps", "profile"],
            Sweep => &["profile", "sweep"],
        };
        let found = [
            ("flat", self.flat.is_some()),
            ("steps", self.steps.is_some()),
            ("radius", self.radius.is_some()),
            ("control_points", self.control_points.is_some()),
            ("profile", self.profile.is_some()),
            ("sweep", self.sweep.is_some()),
        ];
        for (name, is_there) in found {
            // A curve without `flat` lies in space.
            if is_there != wanted.contains(&name) && (is_there || name != "flat") {
                let [expected, found] = if is_there {
                    ["no", "one"]
                } else {
                    ["a", "none"]
                };
                let message = format!("expected {expected} `{name}` in it, found {found}");
                return Err(message);
            }
        }
        let index = |item: Option<u32>| item.unwrap_or_default() as usize;
        let steps = self.steps.unwrap_or_default();
        let curve = match self.kind {
            Bezier => self.spline(Basis::Bezier)?,
            Bspline => self.spline(Basis::BSpline)?,
            Circle => Curve::circle(steps, self.radius.unwrap_or_default())
                .map_err(|error| error.to_string())?,
            Revolution => {
                let profile = index(self.profile);
                return Ok(CurveItemKind::Revolution { steps, profile });
            }
            Sweep => {
                let (profile, sweep) = (index(self.profile), index(self.sweep));
                return Ok(CurveItemKind::Sweep { profile, sweep });
            }
        };
        Ok(CurveItemKind::Curve(curve))
    }

    fn spline(self, basis: Basis) -> Result<Curve, String> {
        let flat = self.flat.unwrap_or(false);
        let points: Vec<Vec3> = self
            .control_points
            .into_iter()
            .flatten()
            .map(|p| p.0)
            .collect();
        if let Some(point) = points.iter().find(|point| flat && point.z != 0.0) {
            let message = format!("expected z = 0 in a flat curve, found {}", point.z);
            return Err(message);
        }
        Curve::spline(basis, flat, self.steps.unwrap_or_default(), points)
            .map_err(|error| error.to_string())
    }
}

/// The members that are written for `shape`: how it is drawn, and its curves.
pub(super) fn members(shape: &CurveShape) -> Members {
    let mut members = display_only(&CurveDisplayData::of(shape));
    let items = shape.curves().items().iter().map(item_members);
    let items: Vec<Text> = items.map(Text::Object).collect();
    members.push("items", items);
    members
}

/// The members that are written for how curves are drawn.
pub(super) fn display_only(display: &CurveDisplayData) -> Members {
    let standard = CurveDisplayData::default();
    let mut inner = Members::default();
    inner.push_unless(
        "control_points",
        display.control_points,
        standard.control_points,
    );
    if display.curve != standard.curve {
        inner.push("curve", word(display.curve));
    }
    if display.surface != standard.surface {
        inner.push("surface", word(display.surface));
    }
    inner.push_unless("close_frames", display.close_frames, standard.close_frames);
    let mut members = Members::default();
    members.push_some("display", inner);
    members
}

fn item_members(item: &CurveItem) -> Members {
    let mut members = Members::default();
    members.push("name", item.name.as_str());
    match &item.kind {
        CurveItemKind::Curve(curve) => curve_members(curve, &mut members),
        CurveItemKind::Revolution { steps, profile } => {
            members.push("kind", "revolution");
            members.push("steps", *steps);
            members.push("profile", *profile);
        }
        CurveItemKind::Sweep { profile, sweep } => {
            members.push("kind", "sweep");
            members.push("profile", *profile);
            members.push("sweep", *sweep);
        }
    }
    members
}

fn curve_members(curve: &Curve, members: &mut Members) {
    match curve.form() {
        CurveForm::Circle { radius } => {
            members.push("kind", "circle");
            members.push("steps", curve.steps());
            members.push("radius", *radius);
        }
        CurveForm::Spline {
            basis,
            flat,
            control_points,
        } => {
            let kind = match basis {
                Basis::Bezier => "bezier",
                Basis::BSpline => "bspline",
            };
            members.push("kind", kind);
            members.push_unless("flat", *flat, false);
            members.push("steps", curve.steps());
            let points: Vec<Text> = control_points.iter().copied().map(Text::from).collect();
            members.push("control_points", points);
        }
    }
}
