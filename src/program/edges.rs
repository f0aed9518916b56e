//! Whether the live view of a comparison has smooth edges.

/// How far it is known whether the reference has smooth edges, as pictures of this program have and those of the
/// course's have not: the live view is drawn both ways, and that which is nearer is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edges {
    Unknown,
    /// Hard ones leave so many pixels that differ.
    Hard(u64),
    /// Those of fewer differences were chosen, which are so many.
    Found(u64),
    /// The user has chosen.
    Chosen,
}

/// Part by which numbers of pixels that differ are alike: where the figure is elsewhere they differed by 0.005 to 0.009.
const ALIKE: f64 = 0.1;

/// Part of the differences, one in so many, from which on edges are chosen anew: where the figure was elsewhere they hardly told, and
/// it has come to its place since. Of a robot in its place the wrong edges left a sixteenth to a seventh of what had differed, and a
/// quarter beside the lines of its bones.
const LEFT_ONE_IN: u64 = 2;

impl Edges {
    /// Whether the reference has smooth edges, as so many pixels that differ tell clearly; `None` where they do not.
    pub fn tell(self, differing: u64) -> Option<bool> {
        match self {
            Self::Unknown if differing == 0 => Some(false),
            Self::Hard(hard) => {
                let are_alike = differing.abs_diff(hard) as f64 <= ALIKE * hard as f64;
                (!are_alike).then_some(differing < hard)
            }
            _ => None,
        }
    }

    /// What is known, and whether the live view has smooth edges then, after so many pixels of it differ from the reference as
    /// it is drawn now, which is smooth or not, and of which reference it may be clear whether its own edges are; `None` if nothing
    /// is to be found any more.
    pub fn after(
        self,
        differing: u64,
        is_smooth: bool,
        is_reference_smooth: Option<bool>,
    ) -> Option<(Self, bool)> {
        match self {
            Self::Unknown if differing > 0 => Some((Self::Hard(differing), true)),
            Self::Unknown => Some((Self::Found(0), false)),
            // Where the figure is elsewhere, its edges leave as much to differ either way, and the reference's own ones tell.
            Self::Hard(hard) => {
                let own = is_reference_smooth.filter(|_| self.tell(differing).is_none());
                let is_smooth = own.unwrap_or(differing < hard);
                Some((Self::Found(differing.min(hard)), is_smooth))
            }
            Self::Found(least) if LEFT_ONE_IN * differing < least => {
                // The other ones are tried: hard ones first.
                Some(match is_smooth {
                    true => (Self::Unknown, false),
                    false => (Self::Hard(differing), true),
                })
            }
            Self::Found(_) | Self::Chosen => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The edges that are chosen after differences of these numbers of pixels one after the other, beginning with hard ones: whether the
    /// live view is smooth after each.
    fn chosen(differing: &[u64]) -> Vec<bool> {
        let mut state = (Edges::Unknown, false);
        let after = differing.iter().map(|&differing| {
            state = state.0.after(differing, state.1, None).unwrap_or(state);
            state.1
        });
        after.collect()
    }

    #[test]
    fn the_reference_has_the_edges_that_leave_clearly_fewer_differences() {
        assert_eq!(Edges::Unknown.tell(0), Some(false));
        assert_eq!(Edges::Unknown.tell(900), None);
        let after_hard = [0, 800, 890, 910, 1000].map(|smooth| Edges::Hard(900).tell(smooth));
        assert_eq!(
            after_hard,
            [Some(true), Some(true), None, None, Some(false)]
        );
        assert_eq!(
            [Edges::Found(5), Edges::Chosen].map(|edges| edges.tell(0)),
            [None; 2]
        );
    }

    #[test]
    fn edges_that_were_chosen_far_from_the_reference_are_chosen_anew_near_it() {
        // Smooth ones leave fewer by chance; then the figure comes to its place, where hard ones leave nothing.
        assert_eq!(chosen(&[900, 890, 100, 0]), [true, true, false, false]);
        // Hard ones leave fewer by chance, and smooth ones nothing.
        assert_eq!(chosen(&[890, 900, 100, 0]), [true, false, true, true]);
        // As long as much is left, those that were chosen stay.
        assert_eq!(chosen(&[900, 890, 800, 500, 900]), [true; 5]);
    }
}
