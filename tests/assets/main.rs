//! What lies in `assets/`: that it is what the generator makes, and that it is fit for use.
#[path = "../../examples/make_assets/catalog/mod.rs"]
mod catalog;
mod characters;
mod curves;
mod files;
mod rigs;
mod shapes;
mod surface;

/// A file in `assets/`; an empty one where it is missing, which no test takes.
fn bytes(path: &str) -> Vec<u8> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    std::fs::read(folder.join(path)).unwrap_or_default()
}

/// The text of a file in `assets/`.
fn asset(path: &str) -> String {
    String::from_utf8(bytes(path)).unwrap_or_default()
}
