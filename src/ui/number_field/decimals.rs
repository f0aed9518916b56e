//! Numbers as text, with as many decimals as there is room for.

use std::ops::RangeInclusive;

/// `value` with up to 4 decimals, without trailing zeros.
pub(super) fn precise(value: f64) -> String {
    rounded(value, 0, 4)
}

/// `value` with as many of `decimals` as fit, and with `unit` if it fits without dropping a
/// decimal; if nothing fits, without decimals. Angles, between half a `turn` either way, have their
/// unit if every whole one has room for it, so that rows look alike: it then comes before the
/// decimals, unless they are wanted because the field `is_used`.
pub(super) fn fitted(
    value: f64,
    unit: &str,
    decimals: RangeInclusive<usize>,
    (turn, is_used): (Option<f64>, bool),
    fits: impl Fn(&str) -> bool,
) -> String {
    let (least, most) = (*decimals.start(), *decimals.end());
    let widest = turn.map(|turn| rounded(1.0 - turn / 2.0, 0, 0));
    let unit = match &widest {
        Some(widest) if !fits(&format!("{widest}{unit}")) => "",
        _ => unit,
    };
    let needs_unit = widest.is_some() && !unit.is_empty() && !is_used;
    let mut number = String::new();
    for places in (0..=most).rev() {
        number = rounded(value, least.min(places), places);
        let with_unit = format!("{number}{unit}");
        if fits(&with_unit) {
            return with_unit;
        }
        if !needs_unit && fits(&number) {
            return number;
        }
    }
    number
}

/// `value` rounded to `most` decimals, of which at least `least` are written.
fn rounded(value: f64, least: usize, most: usize) -> String {
    let mut text = format!("{value:.most$}");
    if let Some(point) = text.find('.') {
        let zeros = text.len() - text.trim_end_matches('0').len();
        let spare = (text.len() - point - 1).saturating_sub(least);
        text.truncate(text.len() - zeros.min(spare));
        if text.ends_with('.') {
            text.pop();
        }
    }
    if text.starts_with('-') && text.chars().all(|c| matches!(c, '-' | '0' | '.')) {
        text.remove(0);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trailing_zeros_and_a_minus_before_zero_are_not_written() {
        assert_eq!(precise(45.0), "45");
        assert_eq!(precise(-0.000_01), "0");
        assert_eq!(precise(-2.25), "-2.25");
        assert_eq!(precise(29.999_999), "30");
    }

    #[test]
    fn decimals_give_way_where_room_is_short_and_stay_where_they_are_wanted() {
        let up_to = |letters: usize| move |text: &str| text.chars().count() <= letters;
        assert_eq!(
            fitted(329.567, "°", 0..=3, (None, false), up_to(8)),
            "329.567°"
        );
        assert_eq!(
            fitted(329.567, "°", 0..=3, (None, false), up_to(7)),
            "329.567"
        );
        assert_eq!(
            fitted(329.567, "°", 0..=3, (None, false), up_to(5)),
            "329.6"
        );
        assert_eq!(fitted(329.567, "°", 0..=3, (None, false), up_to(4)), "330°");
        assert_eq!(fitted(329.567, "°", 0..=3, (None, false), up_to(1)), "330");
        assert_eq!(fitted(1.0, "", 2..=3, (None, false), up_to(8)), "1.00");
        assert_eq!(fitted(1.0, "", 2..=3, (None, false), up_to(3)), "1.0");
    }

    #[test]
    fn an_angle_has_its_unit_where_every_angle_has_room_for_it() {
        let up_to = |letters: usize| move |text: &str| text.chars().count() <= letters;
        for (angle, narrow, middle, wide) in [
            (7.0, "7", "7°", "7°"),
            (-30.0, "-30", "-30°", "-30°"),
            (-154.744, "-155", "-155°", "-154.7°"),
            (7.25, "7.2", "7.2°", "7.2°"),
        ] {
            let turn = (Some(360.0), false);
            let fitted = |letters| fitted(angle, "°", 0..=1, turn, up_to(letters));
            assert_eq!([fitted(4), fitted(5), fitted(7)], [narrow, middle, wide]);
        }
    }

    #[test]
    fn an_angle_keeps_its_unit_rather_than_its_decimal_unless_it_is_being_used() {
        let fitted = |is_used| {
            let fits = |text: &str| text.chars().count() <= 6;
            fitted(-120.3, "°", 0..=1, (Some(360.0), is_used), fits)
        };
        assert_eq!([fitted(false), fitted(true)], ["-120°", "-120.3"]);
    }
}
