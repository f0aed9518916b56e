use crate::geometry::{Basis, Curve, CurveError, CurveForm, MAX_STEPS};
use glam::Vec3;
use std::collections::HashSet;

/// The curves and surfaces of one `.swp` file, in its order; any number of either.
///
/// Surfaces name their curves by index, always of an item before them that is a curve. Names
/// need not be unique: where a file says a name twice, a surface takes the latest curve of that
/// name before it.
#[derive(Clone, Debug, Default, PartialEq)]
#[doc(alias = "ImportCurve")]
pub struct CurveSet {
    items: Vec<CurveItem>,
    /// Sum of [`CurveSet::cost`].
    points: usize,
}

/// One line of a `.swp` file, so to speak.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveItem {
    /// Its name, without white space and brackets; `.` by custom where nobody needs one.
    pub name: String,
    /// What it is.
    pub kind: CurveItemKind,
}

/// A curve, or a surface made from curves.
#[derive(Clone, Debug, PartialEq)]
pub enum CurveItemKind {
    /// `bez2`, `bez3`, `bsp2`, `bsp3` or `circ`.
    Curve(Curve),
    /// `srev`: a flat profile turned about +Y.
    Revolution {
        /// Steps of the whole turn.
        steps: u32,
        /// Index of the item that is turned.
        profile: usize,
    },
    /// `gcyl`: a flat profile carried along another curve.
    Sweep {
        /// Index of the item that is carried.
        profile: usize,
        /// Index of the item that it is carried along.
        sweep: usize,
    },
}

/// The largest number of points and vertices that all curves and surfaces of a set may have.
pub const MAX_SET_POINTS: usize = 2_000_000;

/// Why something does not fit into a set of curves.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CurveSetError {
    /// Numbers that do not make a curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// An index of no curve, or of a surface.
    #[error("expected the index of a curve, found {0}")]
    NotACurve(usize),
    /// A profile in space.
    #[error("expected a profile in the plane z = 0, found “{0}”, which leaves it")]
    Uneven(String),
    /// More points than can be kept in memory and drawn.
    #[error("expected at most {MAX_SET_POINTS} points and vertices in all, found {0}")]
    TooLarge(usize),
    /// A name that would not survive a file.
    #[error("expected a name without white space and brackets, found “{0}”")]
    Name(String),
}

impl CurveItem {
    /// The curve, if it is one.
    pub fn curve(&self) -> Option<&Curve> {
        match &self.kind {
            CurveItemKind::Curve(curve) => Some(curve),
            _ => None,
        }
    }
}

impl CurveSet {
    /// A set without curves.
    pub fn new() -> Self {
        Self::default()
    }

    /// A set of one curve, for the Insert menu: a Bézier curve or B-spline of four control
    /// points in the plane z = 0, to be dragged into shape. All of them lie right of the axis,
    /// so that a surface of revolution of it is a bowl at once and does not run through itself.
    pub fn start_spline(basis: Basis) -> Self {
        let points = [
            Vec3::new(0.3, -1.0, 0.0),
            Vec3::new(1.4, -0.5, 0.0),
            Vec3::new(0.1, 0.4, 0.0),
            Vec3::new(0.9, 1.0, 0.0),
        ];
        Self::of_one(Curve::spline(basis, false, 20, points.to_vec()))
    }

    /// A set of one circle of radius 1, for the Insert menu.
    pub fn start_circle() -> Self {
        Self::of_one(Curve::circle(60, 1.0))
    }

    fn of_one(curve: Result<Curve, CurveError>) -> Self {
        let mut set = Self::new();
        if let Ok(curve) = curve {
            // One small curve always fits.
            let _ = set.push("curve", CurveItemKind::Curve(curve));
        }
        set
    }

    /// The curves and surfaces, in the order of the file.
    pub fn items(&self) -> &[CurveItem] {
        &self.items
    }

    /// The curve at index `item`, if that is one.
    pub fn curve(&self, item: usize) -> Option<&Curve> {
        self.items.get(item)?.curve()
    }

    /// Index of the curve that a surface added now would get for `name`.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.items
            .iter()
            .rposition(|item| item.name == name && item.curve().is_some())
    }

    /// Adds a curve or surface at the end and returns its index.
    ///
    /// # Errors
    /// If a surface names something that is no curve or a profile that is not flat, if the name
    /// would not survive a file, or if there would be too many points in all.
    pub fn push(&mut self, name: &str, kind: CurveItemKind) -> Result<usize, CurveSetError> {
        let split = |c: char| c.is_whitespace() || c == '[' || c == ']';
        if name.is_empty() || name.contains(split) {
            return Err(CurveSetError::Name(name.to_owned()));
        }
        match kind {
            CurveItemKind::Curve(_) => {}
            CurveItemKind::Revolution { steps, profile } => {
                if !(1..=MAX_STEPS).contains(&steps) {
                    return Err(CurveError::Steps(steps.into()).into());
                }
                self.check_profile(profile)?;
            }
            CurveItemKind::Sweep { profile, sweep } => {
                self.check_profile(profile)?;
                self.curve(sweep).ok_or(CurveSetError::NotACurve(sweep))?;
            }
        }
        let points = self.points.saturating_add(self.cost(&kind));
        if points > MAX_SET_POINTS {
            return Err(CurveSetError::TooLarge(points));
        }
        self.points = points;
        self.items.push(CurveItem {
            name: name.to_owned(),
            kind,
        });
        Ok(self.items.len() - 1)
    }

    /// The same set with control point `point` of the curve `item` at `position`, in model
    /// space. Flat curves, and curves that a surface has for its profile, keep z = 0; a curve
    /// that closes stays closed. A point that does not exist changes nothing.
    ///
    /// # Errors
    /// If `item` is no curve or `position` is no place.
    pub fn with_control_point(
        &self,
        item: usize,
        point: usize,
        mut position: Vec3,
    ) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        if self.is_profile(item) {
            position.z = 0.0;
        }
        let moved = curve.with_control_point(point, position)?;
        self.with_kind(item, CurveItemKind::Curve(moved))
    }

    /// The same set with one more control point, or piece, of the curve `item` behind `point` (see
    /// [`Curve::with_point_after`]).
    ///
    /// # Errors
    /// If `item` is no curve or there would be too many points.
    pub fn with_point_after(&self, item: usize, point: usize) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        let changed = curve.with_point_after(point)?;
        self.with_kind(item, CurveItemKind::Curve(changed))
    }

    /// The same set without control point `point` of the curve `item`, where that can be spared
    /// (see [`Curve::without_point`]).
    ///
    /// # Errors
    /// If `item` is no curve.
    pub fn without_point(&self, item: usize, point: usize) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        let changed = curve.without_point(point)?;
        self.with_kind(item, CurveItemKind::Curve(changed))
    }

    /// The same set without the curve or surface `index`, and without the surfaces made from it.
    /// An item that does not exist changes nothing.
    pub fn without_item(&self, index: usize) -> Self {
        let mut set = Self::new();
        // Where each of the items that stay is now.
        let mut places = Vec::with_capacity(self.items.len());
        for (i, item) in self.items.iter().enumerate() {
            let place = |old: usize| places.get(old).copied().flatten();
            let kind = match &item.kind {
                _ if i == index => None,
                CurveItemKind::Curve(curve) => Some(CurveItemKind::Curve(curve.clone())),
                CurveItemKind::Revolution { steps, profile } => {
                    place(*profile).map(|profile| CurveItemKind::Revolution {
                        steps: *steps,
                        profile,
                    })
                }
                CurveItemKind::Sweep { profile, sweep } => place(*profile)
                    .zip(place(*sweep))
                    .map(|(profile, sweep)| CurveItemKind::Sweep { profile, sweep }),
            };
            // What was valid in a larger set is valid in a smaller one.
            places.push(kind.and_then(|kind| set.push(&item.name, kind).ok()));
        }
        set
    }

    /// The same set with `steps` steps: per piece of a curve, of the whole turn of a surface of
    /// revolution. A sweep has the steps of its curves, and does not change.
    ///
    /// # Errors
    /// If there is no such item, or there would be no or too many points.
    pub fn with_steps(&self, item: usize, steps: u32) -> Result<Self, CurveSetError> {
        let known = self.items.get(item).ok_or(CurveSetError::NotACurve(item))?;
        let kind = match &known.kind {
            CurveItemKind::Curve(curve) => CurveItemKind::Curve(curve.with_steps(steps)?),
            CurveItemKind::Revolution { profile, .. } => CurveItemKind::Revolution {
                steps,
                profile: *profile,
            },
            sweep => sweep.clone(),
        };
        self.with_kind(item, kind)
    }

    /// The same set with a circle of another radius. A spline does not change.
    ///
    /// # Errors
    /// If `item` is no curve or `radius` is not finite or too large.
    pub fn with_radius(&self, item: usize, radius: f32) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        let changed = match curve.form() {
            CurveForm::Circle { .. } => Curve::circle(curve.steps(), radius)?,
            CurveForm::Spline { .. } => curve.clone(),
        };
        self.with_kind(item, CurveItemKind::Curve(changed))
    }

    /// Whether a surface has the curve `item` for its profile.
    pub fn is_profile(&self, item: usize) -> bool {
        self.items.iter().any(|other| match other.kind {
            CurveItemKind::Curve(_) => false,
            CurveItemKind::Revolution { profile, .. } | CurveItemKind::Sweep { profile, .. } => {
                profile == item
            }
        })
    }

    /// Whether a surface is swept along the curve `item`.
    pub fn is_sweep(&self, item: usize) -> bool {
        self.items
            .iter()
            .any(|other| matches!(other.kind, CurveItemKind::Sweep { sweep, .. } if sweep == item))
    }

    /// The curves that a surface is swept along, as [`CurveSet::is_sweep`] says of one.
    pub fn sweeps(&self) -> HashSet<usize> {
        let sweep = |item: &CurveItem| match item.kind {
            CurveItemKind::Sweep { sweep, .. } => Some(sweep),
            _ => None,
        };
        self.items.iter().filter_map(sweep).collect()
    }

    /// A name that no item has, made from `base`.
    pub fn free_name(&self, base: &str) -> String {
        let taken = |name: &str| self.items.iter().any(|item| item.name == name);
        if !taken(base) {
            return base.to_owned();
        }
        (2..)
            .map(|number| format!("{base}{number}"))
            .find(|name| !taken(name))
            .unwrap_or_else(|| base.to_owned())
    }

    /// Everything pushed anew with one item replaced, so that every check is made again.
    fn with_kind(&self, index: usize, kind: CurveItemKind) -> Result<Self, CurveSetError> {
        let mut set = Self::new();
        for (i, item) in self.items.iter().enumerate() {
            let kind = if i == index { &kind } else { &item.kind };
            set.push(&item.name, kind.clone())?;
        }
        Ok(set)
    }

    fn check_profile(&self, profile: usize) -> Result<(), CurveSetError> {
        let item = self.items.get(profile);
        let curve = item.and_then(CurveItem::curve);
        match (item, curve) {
            (Some(item), Some(curve)) if !curve.is_flat() => {
                Err(CurveSetError::Uneven(item.name.clone()))
            }
            (_, Some(_)) => Ok(()),
            _ => Err(CurveSetError::NotACurve(profile)),
        }
    }

    /// How many points or vertices `kind` has at most.
    fn cost(&self, kind: &CurveItemKind) -> usize {
        let points = |item: usize| self.curve(item).map_or(0, Curve::max_points);
        match kind {
            CurveItemKind::Curve(curve) => curve.max_points(),
            CurveItemKind::Revolution { steps, profile } => {
                points(*profile).saturating_mul(*steps as usize + 1)
            }
            CurveItemKind::Sweep { profile, sweep } => {
                points(*profile).saturating_mul(points(*sweep))
            }
        }
    }
}
