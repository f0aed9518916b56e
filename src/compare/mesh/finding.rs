use super::numbers::{factor_in_words, is_told, length, vector};
use super::signed_axis::SignedAxis;
use crate::compare::Which;
use glam::DVec3;
use serde::Serialize;
use std::fmt;

/// A cause of differences between two meshes. B is compared with the reference A.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum MeshFinding {
    /// Vertices whose coordinates are not numbers or infinite.
    NotFinite {
        /// The mesh that has them.
        mesh: Which,
        /// How many.
        vertices: u64,
    },
    /// B is A moved.
    Offset {
        /// From A to B, in model space.
        by: [f64; 3],
    },
    /// B is A in another size.
    Scaled {
        /// Size of B by size of A.
        factor: f64,
        /// The movement after scaling about the origin; zero if there is none.
        offset: [f64; 3],
    },
    /// B is A with its axes exchanged or turned round.
    Axes {
        /// Which axis of A each of B's is, such as `x`, `-z`, `y`.
        from_a: [SignedAxis; 3],
        /// Whether that mirrors the mesh.
        mirrored: bool,
        /// Size of B by size of A; one if they are as large.
        factor: f64,
        /// The movement after all that; zero if there is none.
        offset: [f64; 3],
    },
    /// B is A turned, by no multiple of a quarter about an axis.
    Turned {
        /// Along which axis A was mirrored before, if it was.
        mirrored: Option<&'static str>,
        /// By how much, 0 to 180, counterclockwise seen from the tip of the axis.
        degrees: f64,
        /// About which axis through the origin; of length one.
        axis: [f64; 3],
        /// Size of B by size of A; one if they are as large.
        factor: f64,
        /// The movement after all that; zero if there is none.
        offset: [f64; 3],
    },
    /// B is A with fewer digits.
    Rounded {
        /// One unit of the last digit.
        to: f64,
    },
    /// Every vertex of B lies in one place.
    OnePlace {
        /// Which, in model space.
        at: [f64; 3],
    },
    /// B has A's vertices in another order.
    Permuted {
        /// How many are in another place of the order.
        vertices: u64,
    },
    /// Triangles wind the other way round.
    Winding {
        /// How many.
        reversed: u64,
        /// Of how many in B.
        of: u64,
    },
    /// Triangles that only one mesh has.
    Triangles {
        /// How many are only in A.
        only_a: u64,
        /// How many are only in B.
        only_b: u64,
    },
    /// The triangles are the same in another order, which does not count as a difference.
    TriangleOrder,
}

/// How far from one a factor is none in words: rounding gives as much.
const NO_SCALE: f64 = 1e-5;

/// What follows a turn, in words; nothing for a factor of one and no movement.
fn scaled_and_moved(f: &mut fmt::Formatter<'_>, factor: f64, offset: [f64; 3]) -> fmt::Result {
    if (factor - 1.0).abs() > NO_SCALE {
        write!(f, ", and {} times as large", factor_in_words(factor))?;
    }
    if is_told(offset) {
        write!(f, ", then moved by {}", vector(offset))?;
    }
    Ok(())
}

impl MeshFinding {
    /// Whether it accounts for `differing` vertices that are not where they should be.
    pub(super) fn explains(&self, differing: u64) -> bool {
        match self {
            Self::NotFinite { vertices, .. } => *vertices == differing,
            Self::Offset { .. }
            | Self::Scaled { .. }
            | Self::Axes { .. }
            | Self::Turned { .. }
            | Self::Rounded { .. }
            | Self::OnePlace { .. }
            | Self::Permuted { .. } => true,
            Self::Winding { .. } | Self::Triangles { .. } | Self::TriangleOrder => false,
        }
    }
}

impl MeshFinding {
    /// That all of `points`, those of B, are in one place, if they are.
    pub(crate) fn one_place(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next().filter(|point| point.is_finite())?;
        let at = first.to_array();
        points
            .all(|point| point == first)
            .then_some(Self::OnePlace { at })
    }

    /// Whether B is A moved, turned or scaled.
    pub fn is_placement(&self) -> bool {
        matches!(
            self,
            Self::Offset { .. } | Self::Scaled { .. } | Self::Axes { .. } | Self::Turned { .. }
        )
    }

    /// Where B has a point of A and by how much it is larger, if it is A moved, scaled or with other axes.
    pub(crate) fn placed(&self, point: DVec3) -> Option<(DVec3, f64)> {
        let (at, factor, offset) = match self {
            Self::Offset { by } => (point, 1.0, by),
            Self::Scaled { factor, offset } => (point, *factor, offset),
            Self::Axes {
                from_a,
                factor,
                offset,
                ..
            } => {
                let at = from_a.map(|axis| axis.of(point));
                (DVec3::from_array(at), *factor, offset)
            }
            _ => return None,
        };
        Some((at * factor + DVec3::from_array(*offset), factor))
    }

    /// What B is, in a few words; `None` for what is no placement of A.
    pub fn brief(&self) -> Option<String> {
        if matches!(self, Self::OnePlace { .. }) {
            return Some("all vertices in one place".to_owned());
        }
        let how = self.how()?;
        Some(match self {
            _ if how.is_empty() => "the exact result".to_owned(),
            Self::Axes { .. } => format!("the exact result with {how}"),
            _ => format!("the exact result, {how}"),
        })
    }

    /// How A was placed where B is, in a few words.
    pub(crate) fn how(&self) -> Option<String> {
        let (how, factor) = match self {
            Self::Offset { by } => {
                let by = DVec3::from_array(*by).length();
                (Some(format!("moved by {}", length(by))), 1.0)
            }
            Self::Scaled { factor, .. } => (None, *factor),
            Self::Axes { from_a, factor, .. } => {
                let axes = from_a.map(SignedAxis::name).join(", ");
                (Some(format!("the axes {axes}")), *factor)
            }
            Self::Turned {
                degrees,
                factor,
                mirrored,
                ..
            } => {
                let mirrored =
                    mirrored.map_or(String::new(), |axis| format!("mirrored along {axis} and "));
                (Some(format!("{mirrored}turned by {degrees:.1}°")), *factor)
            }
            Self::OnePlace { .. }
            | Self::NotFinite { .. }
            | Self::Rounded { .. }
            | Self::Permuted { .. }
            | Self::Winding { .. }
            | Self::Triangles { .. }
            | Self::TriangleOrder => return None,
        };
        let is_scaled = (factor - 1.0).abs() > NO_SCALE;
        let times = is_scaled.then(|| format!("{} times as large", length(factor)));
        let all: Vec<String> = how.into_iter().chain(times).collect();
        Some(all.join(", "))
    }
}

impl fmt::Display for MeshFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { mesh, vertices } => {
                let (vertices, have) = match vertices {
                    1 => ("1 vertex".to_owned(), "has"),
                    vertices => (format!("{vertices} vertices"), "have"),
                };
                write!(
                    f,
                    "{vertices} of {mesh} {have} coordinates that are not finite numbers"
                )
            }
            Self::Offset { by } => write!(f, "B is A moved by {}", vector(*by)),
            Self::Scaled { factor, offset } => {
                write!(f, "B is A {} times as large", factor_in_words(*factor))?;
                if is_told(*offset) {
                    write!(f, ", then moved by {}", vector(*offset))
                } else {
                    Ok(())
                }
            }
            Self::Axes {
                from_a,
                mirrored,
                factor,
                offset,
            } => {
                let [x, y, z] = from_a.map(SignedAxis::name);
                let how = if *mirrored { "mirrored" } else { "turned" };
                write!(
                    f,
                    "B's x, y, z are {x}, {y}, {z} of A: {how}, or another axis points up"
                )?;
                scaled_and_moved(f, *factor, *offset)
            }
            Self::Turned {
                mirrored,
                degrees,
                axis,
                factor,
                offset,
            } => {
                f.write_str("B is A ")?;
                if let Some(axis) = mirrored {
                    write!(f, "mirrored along {axis} and ")?;
                }
                write!(f, "turned by {degrees:.4} degrees about {}", vector(*axis))?;
                scaled_and_moved(f, *factor, *offset)
            }
            Self::Rounded { to } => write!(
                f,
                "B is A rounded to {}: it was written with fewer digits",
                length(*to)
            ),
            Self::OnePlace { at } => {
                write!(f, "all vertices of B lie in one place, {}", vector(*at))
            }
            Self::Permuted { vertices } => write!(
                f,
                "B has the vertices of A in a different order: {vertices} have another index"
            ),
            Self::Winding { reversed, of } if reversed == of => write!(
                f,
                "all triangles of B wind the other way: its normals point the other way"
            ),
            Self::Winding { reversed, of } => {
                let wind = if *reversed == 1 { "winds" } else { "wind" };
                write!(
                    f,
                    "{reversed} of the {of} triangles of B {wind} the other way"
                )
            }
            Self::Triangles { only_a, only_b } => {
                let are = if *only_a == 1 {
                    "triangle is"
                } else {
                    "triangles are"
                };
                write!(f, "{only_a} {are} only in A, {only_b} only in B")
            }
            Self::TriangleOrder => f.write_str("the triangles are the same, in a different order"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placements_are_told_in_a_few_words() {
        let offset = [0.0; 3];
        for (finding, expected) in [
            (
                MeshFinding::Offset {
                    by: [3.0, 0.0, 4.0],
                },
                "the exact result, moved by 5",
            ),
            (
                MeshFinding::Scaled {
                    factor: 100.0,
                    offset,
                },
                "the exact result, 100 times as large",
            ),
            (
                MeshFinding::Axes {
                    from_a: [(0, false), (2, true), (1, false)]
                        .map(|(axis, is_reversed)| SignedAxis { axis, is_reversed }),
                    mirrored: false,
                    factor: 1.0,
                    offset,
                },
                "the exact result with the axes x, -z, y",
            ),
            (
                MeshFinding::Turned {
                    mirrored: Some("x"),
                    degrees: 30.04,
                    axis: [0.0, 1.0, 0.0],
                    factor: 2.0,
                    offset,
                },
                "the exact result, mirrored along x and turned by 30.0°, 2 times as large",
            ),
        ] {
            assert_eq!(finding.brief().as_deref(), Some(expected));
        }
        assert_eq!(MeshFinding::TriangleOrder.brief(), None);
    }
}
