//! Numbers as Collada lists them.
use super::super::super::text::number;
use glam::{DMat4, DVec3};
use std::collections::HashMap;
use std::fmt::{Display, Write};

/// Where lists of numbers are broken into lines.
const LINE: usize = 110;

/// A 4×4 matrix by rows.
pub fn matrix(m: DMat4) -> String {
    let rows = m.transpose().to_cols_array();
    rows.map(|x| number(x, 7)).join(" ")
}

/// Words in lines that are not too long.
pub fn lines<T: Display>(words: impl IntoIterator<Item = T>) -> String {
    let mut out = String::new();
    let mut length = 0;
    for word in words {
        let word = word.to_string();
        if length + word.len() >= LINE {
            out.push('\n');
            length = 0;
        } else if !out.is_empty() {
            out.push(' ');
        }
        length += word.len() + 1;
        out.push_str(&word);
    }
    out
}

pub fn vector(v: DVec3, decimals: usize) -> String {
    v.to_array().map(|x| number(x, decimals)).join(" ")
}

/// A `<source>` of rows of numbers.
pub fn float_source(out: &mut String, id: &str, columns: &[&str], rows: &[String]) {
    let is_matrix = columns == ["TRANSFORM"];
    let (kind, stride) = if is_matrix {
        ("float4x4", 16)
    } else {
        ("float", columns.len())
    };
    let count = rows.len() * stride;
    let params: String = columns
        .iter()
        .map(|name| format!(r#"<param name="{name}" type="{kind}"/>"#))
        .collect();
    let _ = writeln!(
        out,
        r##"<source id="{id}">
<float_array id="{id}-array" count="{count}">{}</float_array>
<technique_common><accessor source="#{id}-array" count="{}" stride="{stride}">{params}</accessor></technique_common>
</source>"##,
        lines(rows),
        rows.len(),
    );
}

/// Rows that are written once each, and the index of each that was asked for.
#[derive(Default)]
pub struct Distinct {
    pub rows: Vec<String>,
    known: HashMap<String, usize>,
}

impl Distinct {
    pub fn index(&mut self, row: String) -> usize {
        let rows = &mut self.rows;
        *self.known.entry(row).or_insert_with_key(|row| {
            rows.push(row.clone());
            rows.len() - 1
        })
    }
}
