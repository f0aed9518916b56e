//! Pictures that are written upside down or mirrored, with or without a mistake in skinning.

use super::found_otherwise::PICTURE_TURNED;
use super::picture_search::PictureSearch;
use super::search::Explanation;
use super::ways::{Made, ways};
use crate::geometry::Picture;

/// In words, and whether columns and rows are in reverse order.
const WAYS: [(&str, [bool; 2]); 3] = [
    ("upside down", [false, true]),
    ("left and right exchanged", [true, false]),
    ("by half a turn", [true, true]),
];

/// What gives the silhouette of `picture` to within `enough` where it is turned or mirrored. `search` looks for what gives
/// the one of another picture.
pub(super) fn find<'a>(
    picture: &Picture,
    enough: f64,
    search: impl Fn(&Picture) -> Option<PictureSearch<'a>>,
) -> Vec<Explanation> {
    for (how, reversed) in WAYS {
        let Some(search) = search(&in_reverse(picture, reversed)) else {
            continue;
        };
        let turned = |explanation: Explanation| Explanation {
            made: [explanation.made, vec![Made::by_numbers(&PICTURE_TURNED)]].concat(),
            how: Some(how.to_owned()),
            ..explanation
        };
        if search.error_from_exact <= enough {
            return vec![turned(Explanation {
                made: Vec::new(),
                error: search.error_from_exact,
                how: None,
            })];
        }
        let found = search.within(enough, ways());
        if !found.is_empty() {
            return found.into_iter().map(turned).collect();
        }
    }
    Vec::new()
}

fn in_reverse(picture: &Picture, [columns, rows]: [bool; 2]) -> Picture {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let width = (picture.width as usize).max(1);
    let mut lines: Vec<Vec<[u8; 4]>> = pixels.chunks(width).map(<[_]>::to_vec).collect();
    if rows {
        lines.reverse();
    }
    if columns {
        lines.iter_mut().for_each(|line| line.reverse());
    }
    Picture {
        width: picture.width,
        height: picture.height,
        rgba: lines.concat().concat(),
    }
}
