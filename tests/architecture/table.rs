//! The table of the layers in ARCHITECTURE.md, which is the only place that says what each may
//! use.

use std::collections::BTreeSet;

/// Layers in the order of the table, from the bottom up.
pub struct Table {
    pub layers: Vec<Layer>,
}

/// One layer.
#[derive(Debug)]
pub struct Layer {
    pub name: String,
    /// The layers that it may use, without itself.
    pub uses: BTreeSet<String>,
    /// What it may name of what is guarded: crates, paths of the standard library, keywords.
    pub names: BTreeSet<String>,
}

impl Table {
    /// Reads the table whose first column is called `layer`.
    ///
    /// # Panics
    /// If there is none, or a cell says something that is no rule.
    pub fn read(markdown: &str) -> Self {
        let rows = markdown
            .lines()
            .skip_while(|line| !line.starts_with("| layer |"))
            .skip(2)
            .take_while(|line| line.starts_with('|'));
        let mut table = Self { layers: Vec::new() };
        for row in rows {
            let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
            let [layers, _, uses, names] = cells[..] else {
                panic!("a row of four cells: {row}");
            };
            let uses = table.used(uses);
            let names = quoted(names).into_iter().map(str::to_owned).collect();
            let new = quoted(layers).into_iter().map(|name| Layer {
                name: name.to_owned(),
                uses: uses.clone(),
                names: BTreeSet::clone(&names),
            });
            table.layers.extend(new.collect::<Vec<_>>());
        }
        assert!(!table.layers.is_empty(), "no table of the layers");
        table
    }

    pub fn layer(&self, name: &str) -> Option<&Layer> {
        self.layers.iter().find(|layer| layer.name == name)
    }

    /// All that no layer may name unless its row says so.
    pub fn guarded(&self) -> BTreeSet<&str> {
        let names = self.layers.iter().flat_map(|layer| &layer.names);
        names.map(|name| &**name).collect()
    }

    /// The layers of a cell such as `` `io`, `scene` and below ``, which means those that either
    /// may use as well.
    fn used(&self, cell: &str) -> BTreeSet<String> {
        let above = || self.layers.iter().map(|layer| layer.name.clone());
        if cell == "everything below" {
            return above().collect();
        }
        let (listed, and_below) = match cell.strip_suffix(" and below") {
            Some(listed) => (listed, true),
            None => (cell, false),
        };
        let named = quoted(listed);
        let mut uses: BTreeSet<String> = named.iter().map(|&name| name.to_owned()).collect();
        for name in named {
            let layer = self.layer(name);
            let layer = layer.unwrap_or_else(|| panic!("`{name}` has no row above: {cell}"));
            if and_below {
                uses.extend(layer.uses.clone());
            }
        }
        uses
    }
}

/// The words between backticks in `cell`, which holds nothing else but commas, or a dash.
fn quoted(cell: &str) -> Vec<&str> {
    if cell == "–" {
        return Vec::new();
    }
    let word =
        |part: &'_ str| -> bool { part.len() > 2 && part.starts_with('`') && part.ends_with('`') };
    cell.split(", ")
        .map(|part| {
            assert!(word(part), "expected names in backticks or a dash: {cell}");
            part.trim_matches('`')
        })
        .collect()
}
