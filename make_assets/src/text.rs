//! The files' texts: `.skel`, `.attach`, `.obj`, with as few characters as carry the numbers.
use super::mesh::Mesh;
use super::rig::{Character, Joint};
use std::fmt::Write;

/// A number with at most `decimals` decimals, without trailing zeros.
pub fn number(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    let short = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    if short == "-0" {
        "0".to_owned()
    } else {
        short.to_owned()
    }
}

/// One joint a line: offset, parent, name.
pub fn skeleton(joints: &[Joint]) -> String {
    let mut text = String::new();
    for joint in joints {
        let [x, y, z] = joint.offset.to_array().map(|c| number(c, 5));
        let parent = joint.parent.map_or("-1".to_owned(), |p| p.to_string());
        let _ = writeln!(text, "{x} {y} {z} {parent} # {}", joint.name);
    }
    text
}

/// One vertex a line: its weights in ten-thousandths, which sum to exactly 1.
pub fn attachments(character: &Character) -> String {
    let mut text = String::new();
    for row in &character.weights {
        let words: Vec<String> = ten_thousandths(row)
            .into_iter()
            .map(|n| number(f64::from(n) / 1e4, 4))
            .collect();
        text.push_str(&words.join(" "));
        text.push('\n');
    }
    text
}

/// Rounds weights so that their sum stays 1: what is missing goes to the largest.
fn ten_thousandths(row: &[f64]) -> Vec<i32> {
    let mut rounded: Vec<i32> = row.iter().map(|w| (w * 1e4).round() as i32).collect();
    let missing = 10_000 - rounded.iter().sum::<i32>();
    let largest = (0..row.len()).rev().max_by_key(|&c| rounded[c]);
    if let Some(c) = largest {
        rounded[c] += missing;
    }
    rounded
}

/// Vertices and triangles.
pub fn mesh(mesh: &Mesh) -> String {
    let mut text = String::new();
    for p in &mesh.positions {
        let [x, y, z] = p.to_array().map(|c| number(c, 5));
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|v| v + 1);
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    text
}
