//! What lies in `assets/`: that it is fit for use. `make check-assets` compares it with what the
//! generator makes.

mod characters;
mod curves;
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

/// The paths of the files in the folder `name` of `assets/`, such as `curves/vase.swp`.
fn paths(name: &str) -> impl Iterator<Item = String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let mut files: Vec<String> = std::fs::read_dir(folder.join(name))
        .unwrap()
        .map(|entry| format!("{name}/{}", entry.unwrap().file_name().to_str().unwrap()))
        .collect();
    files.sort();
    files.into_iter()
}
