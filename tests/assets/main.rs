//! What lies in `assets/`: that it is what the generator makes, and that it is fit for use.
#[path = "../../examples/make_assets/catalog/mod.rs"]
mod catalog;
mod characters;
mod curves;
mod files;
mod shapes;
mod surface;

/// The text of a file in `assets/`; an empty one where it is missing, which no test takes.
fn asset(path: &str) -> String {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    std::fs::read_to_string(folder.join(path)).unwrap_or_default()
}
