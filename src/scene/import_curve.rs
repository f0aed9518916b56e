use crate::geometry::{Basis, Curve, CurveError, CurveForm, MAX_STEPS};
use glam::Vec3;

/// Curves and surfaces of one `.swp` file, in its order; any number of either.
///
/// Surfaces refer to their curves by index, always of an item before them that is a curve. Names
/// need not be unique: where a file uses a name twice, a surface takes the last curve of that name
/// before it.
#[derive(Clone, Debug, Default, PartialEq)]
#[doc(alias = "ImportCurve")]
pub struct CurveSet {
    items: Vec<CurveItem>,
    /// Sum of [`CurveSet::cost`].
    points: usize,
}

/// Curve or surface of a `.swp` file, with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveItem {
    /// Name, without white space and brackets; by convention `.` where no name is needed.
    pub name: String,
    /// Curve or surface.
    pub kind: CurveItemKind,
}

/// A curve, or a surface made from curves.
#[derive(Clone, Debug, PartialEq)]
pub enum CurveItemKind {
    /// Curve: `bez2`, `bez3`, `bsp2`, `bsp3` or `circ`.
    Curve(Curve),
    /// Surface of revolution, `srev`: a flat profile turned about +Y.
    Revolution {
        /// Steps of the whole turn.
        steps: u32,
        /// Index of the profile.
        profile: usize,
    },
    /// Generalized cylinder, `gcyl`: a flat profile swept along another curve.
    Sweep {
        /// Index of the profile.
        profile: usize,
        /// Index of the curve that it is swept along.
        sweep: usize,
    },
}

/// Largest number of points and vertices of all curves and surfaces of a set.
pub const MAX_SET_POINTS: usize = 2_000_000;

/// Reason why something does not fit into a set of curves.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CurveSetError {
    /// Numbers that do not describe a curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// Index of a surface, or of nothing.
    #[error("expected the index of a curve, found {0}")]
    NotACurve(usize),
    /// Profile that is not in the plane z = 0.
    #[error("expected a profile in the plane z = 0, found “{0}”, which leaves it")]
    Uneven(String),
    /// Too many points to be kept in memory and drawn.
    #[error("expected at most {MAX_SET_POINTS} points and vertices in all, found {0}")]
    TooLarge(usize),
    /// Name that cannot be written to a file.
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
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }

    /// Set of one curve, for the Insert menu: a Bézier curve or B-spline of four control points in
    /// the plane z = 0, to be dragged into shape. All of them are right of the axis, so that its
    /// surface of revolution is a bowl and does not intersect itself.
    pub fn start_spline(basis: Basis) -> Self {
        let points = [
            Vec3::new(0.3, -1.0, 0.0),
            Vec3::new(1.4, -0.5, 0.0),
            Vec3::new(0.1, 0.4, 0.0),
            Vec3::new(0.9, 1.0, 0.0),
        ];
        Self::of_one(Curve::spline(basis, false, 20, points.to_vec()))
    }

    /// Set of one circle of radius 1, for the Insert menu.
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

    /// Curves and surfaces, in the order of the file.
    pub fn items(&self) -> &[CurveItem] {
        &self.items
    }

    /// Curve at index `item`, if that is one.
    pub fn curve(&self, item: usize) -> Option<&Curve> {
        self.items.get(item)?.curve()
    }

    /// Index of the curve that `name` means in a surface that is added now.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.items
            .iter()
            .rposition(|item| item.name == name && item.curve().is_some())
    }

    /// Appends a curve or surface and returns its index.
    ///
    /// # Errors
    /// If a surface refers to something that is no curve or to a profile that is not flat, if the
    /// name cannot be written to a file, or if there would be too many points in all.
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

    /// The same set with control point `point` of the curve `item` at `position`, in model space.
    /// Flat curves, and profiles of surfaces, keep z = 0; a closed curve stays closed. A point that
    /// does not exist changes nothing.
    ///
    /// # Errors
    /// If `item` is no curve, or `position` is not finite or too large.
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

    /// The same set with one more control point, or piece, of the curve `item` after `point` (see
    /// [`Curve::with_point_after`]).
    ///
    /// # Errors
    /// If `item` is no curve or there would be too many points.
    pub fn with_point_after(&self, item: usize, point: usize) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        let changed = curve.with_point_after(point)?;
        self.with_kind(item, CurveItemKind::Curve(changed))
    }

    /// The same set without control point `point` of the curve `item`, if it can be removed (see
    /// [`Curve::without_point`]).
    ///
    /// # Errors
    /// If `item` is no curve.
    pub fn without_point(&self, item: usize, point: usize) -> Result<Self, CurveSetError> {
        let curve = self.curve(item).ok_or(CurveSetError::NotACurve(item))?;
        let changed = curve.without_point(point)?;
        self.with_kind(item, CurveItemKind::Curve(changed))
    }

    /// The same set without the curve or surface `index`, and without the surfaces made from it. An
    /// item that does not exist changes nothing.
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

    /// The same set with another number of steps of one item: per piece of a curve, or of the whole
    /// turn of a surface of revolution. A sweep has the steps of its curves and does not change.
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

    /// The same set with another radius of a circle, in model space. A spline does not change.
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

    /// Whether the curve `item` is the profile of a surface.
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
        self.sweeps().any(|sweep| sweep == item)
    }

    /// Indices of the curves that a surface is swept along, one per surface.
    pub fn sweeps(&self) -> impl Iterator<Item = usize> {
        self.items.iter().filter_map(|item| match item.kind {
            CurveItemKind::Sweep { sweep, .. } => Some(sweep),
            CurveItemKind::Curve(_) | CurveItemKind::Revolution { .. } => None,
        })
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

    /// The same set with one item replaced, built anew so that every check is made again.
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

    /// Upper bound of the number of points or vertices of `kind`.
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
