//! What a diagnosis is in grading: its outcome, and what the rubric counts.

use super::graded::Outcome;
use super::report::NEARLY;
use super::rubric::MOSTLY_POSED;
use crate::diagnose::{
    Diagnosis, MOVED_AS_A_WHOLE, NearlyRight, OtherPose, Verdict, within_everywhere,
};
use crate::io::{RIGHT_BUT_FOR_DIGITS, RIGHT_BUT_FOR_FEW, RIGHT_BUT_FOR_LITTLE};

pub(super) fn outcome(verdict: Verdict) -> Outcome {
    match verdict {
        Verdict::Right => Outcome::Right,
        Verdict::Triangles | Verdict::Explained => Outcome::Explained,
        Verdict::OtherPose => Outcome::OtherPose,
        Verdict::Unexplained => Outcome::Unexplained,
    }
}

/// The other pose of a mesh, if most of it is as asked.
pub(super) fn mostly_posed(found: &Diagnosis) -> Option<&OtherPose> {
    let other = found.other_pose.as_ref();
    other.filter(|other| other.as_expected > MOSTLY_POSED)
}

/// What is known of a mesh that nothing explains whole, in a few words.
pub(super) fn hint(found: &Diagnosis) -> Option<String> {
    if let Some(other) = mostly_posed(found) {
        let (joints, all) = (other.joints.len(), other.posed_joints);
        return Some(match joints {
            _ if 2 * joints > all => {
                let turned = other.joints.iter().map(|joint| joint.turned_by);
                let most = turned.fold(0.0, f64::max);
                format!("{joints} of {all} joints turned otherwise, by up to {most:.1}°")
            }
            1 => "right but for 1 joint".to_owned(),
            joints => format!("right but for {joints} joints"),
        });
    }
    if found.verdict != Verdict::Unexplained {
        return None;
    }
    if found.nearly_right() == Some(NearlyRight::Close) {
        return Some(within_everywhere(found.error_from_exact));
    }
    let mut findings = found.findings.iter();
    if let Some(brief) = findings.find_map(|finding| finding.0.brief()) {
        return Some(brief);
    }
    Some(match found.nearly_right()? {
        NearlyRight::Rounded => "too few digits".to_owned(),
        NearlyRight::Close | NearlyRight::Placed => return None,
        NearlyRight::ButForFewWith(mistake) => format!("{NEARLY}{}", mistake.id),
        NearlyRight::ButForFew => match found.off {
            1 => "all but 1 vertex".to_owned(),
            off => format!("all but {off} vertices"),
        },
    })
}

/// What is wrong with a mesh that is nearly right, for the rubric.
pub(super) fn nearly(found: &Diagnosis) -> Vec<&'static str> {
    let mut nearly = match found.nearly_right() {
        Some(NearlyRight::Rounded) => vec![RIGHT_BUT_FOR_DIGITS],
        Some(NearlyRight::Close) => vec![RIGHT_BUT_FOR_LITTLE],
        Some(NearlyRight::Placed) => vec![MOVED_AS_A_WHOLE],
        Some(NearlyRight::ButForFewWith(mistake)) => vec![mistake.id, RIGHT_BUT_FOR_FEW],
        Some(NearlyRight::ButForFew) => vec![RIGHT_BUT_FOR_FEW],
        None if mostly_posed(found).is_some() && found.coarse.is_some() => {
            return vec![RIGHT_BUT_FOR_DIGITS];
        }
        None => return Vec::new(),
    };
    nearly.extend(found.faces.mistakes().map(|mistake| mistake.id));
    nearly
}

/// Names in the form in which results keep them.
pub(super) fn owned(ids: &[&str]) -> Vec<String> {
    ids.iter().map(|&id| id.to_owned()).collect()
}

/// The explanations, the one that is told in words first; none without one.
pub(super) fn explanations(
    told: Vec<&'static str>,
    same_as: &[Vec<&'static str>],
) -> Vec<Vec<String>> {
    let first = (!told.is_empty()).then_some(&told);
    let all = first.into_iter().chain(same_as);
    all.map(|ids| owned(ids)).collect()
}
