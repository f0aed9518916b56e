//! Whether the live view of a comparison has smooth edges.

/// How far it is known whether the reference has smooth edges, as pictures of this program have and those of the
/// course's have not: the live view is drawn both ways, and that which is nearer is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edges {
    Unknown,
    /// Hard ones leave so many pixels that differ.
    Hard(u64),
    /// Those of fewer differences were chosen.
    Found,
    /// The user has chosen.
    Chosen,
}

/// Part by which numbers of pixels that differ are alike: where the figure is elsewhere they differed by 0.005 to 0.009.
const ALIKE: f64 = 0.1;

impl Edges {
    /// What is known, and whether the live view has smooth edges then, after so many pixels of it differ from the reference as
    /// it is drawn now, of which it may be clear whether its own edges are smooth; `None` if nothing is to be found any more.
    pub fn after(self, differing: u64, is_reference_smooth: Option<bool>) -> Option<(Self, bool)> {
        match self {
            Self::Unknown if differing > 0 => Some((Self::Hard(differing), true)),
            Self::Unknown => Some((Self::Found, false)),
            // Where the figure is elsewhere, its edges leave as much to differ either way, and the reference's own ones tell.
            Self::Hard(hard) => {
                let are_alike = differing.abs_diff(hard) as f64 <= ALIKE * hard as f64;
                let own = is_reference_smooth.filter(|_| are_alike);
                Some((Self::Found, own.unwrap_or(differing < hard)))
            }
            Self::Found | Self::Chosen => None,
        }
    }
}
