//! The page about diagnosing, held to the table in the program.

use editor_core::diagnose::Mistake;

const PAGE: &str = include_str!("../../docs/diagnosing.md");

/// The row that the page has for a mistake.
fn row(mistake: &Mistake) -> String {
    let ways = mistake.readings.iter().map(|reading| reading.how);
    let ways: Vec<&str> = ways.filter(|how| !how.is_empty()).collect();
    let ways = match &ways[..] {
        [] => String::new(),
        ways => format!(": {}", ways.join("; ")),
    };
    let Mistake {
        id,
        meaning,
        section,
        look_at,
        ..
    } = mistake;
    format!("| `{id}` | {meaning}{ways} | {section} | {look_at} |")
}

#[test]
fn the_page_has_a_row_for_every_mistake_and_none_else() {
    let rows: Vec<&str> = PAGE
        .lines()
        .filter(|line| line.starts_with("| `"))
        .collect();
    let expected: Vec<String> = Mistake::all().map(row).collect();
    assert_eq!(rows, expected, "{}", expected.join("\n"));
}

#[test]
fn mistakes_have_names_of_their_own() {
    for (index, mistake) in Mistake::all().enumerate() {
        let mut earlier = Mistake::all().take(index);
        assert!(
            earlier.all(|earlier| earlier.id != mistake.id),
            "{}",
            mistake.id
        );
        assert!(std::ptr::eq(Mistake::find(mistake.id).unwrap(), mistake));
    }
    assert!(Mistake::find("weights").is_none());
}
