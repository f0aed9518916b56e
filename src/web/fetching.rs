//! Files that are fetched from beside the page: built-in ones that are not inside the program, when they
//! are used, and those that others name.

use super::browser;
use super::given_files::GivenFiles;
use crate::io::{Diagnostic, builtin};
use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::{JsFuture, future_to_promise, spawn_local};

/// Folder beside the page.
const FOLDER: &str = "assets/";

/// Files that are on their way. A clone is another handle to the same ones.
#[derive(Clone, Default)]
pub(super) struct Fetching(Rc<RefCell<State>>);

#[derive(Default)]
struct State {
    /// Bytes that each file has brought so far; all those that were asked for since nothing was on
    /// its way.
    brought: HashMap<PathBuf, usize>,
    /// Number of files on their way.
    under_way: usize,
    /// Why one of them could not be had.
    failed: Option<Diagnostic>,
}

impl Fetching {
    /// Fetches those of `paths` that are not on their way already, and adds them to `given`. `done` is
    /// called, and told what went wrong, when nothing is on its way any more.
    pub fn begin(
        &self,
        paths: Vec<PathBuf>,
        given: &GivenFiles,
        done: impl Fn(Result<(), Diagnostic>) + Clone + 'static,
    ) {
        for path in paths {
            if self.0.borrow().brought.contains_key(&path) {
                continue;
            }
            {
                let mut state = self.0.borrow_mut();
                state.brought.insert(path.clone(), 0);
                state.under_way += 1;
            }
            let (fetching, given, done) = (self.clone(), given.clone(), done.clone());
            spawn_local(async move {
                let fetched = fetching.fetch(&path).await;
                let mut state = fetching.0.borrow_mut();
                match fetched {
                    Ok(bytes) => given.add_builtin(path, bytes),
                    Err(error) => state.failed = Some(error),
                }
                state.under_way -= 1;
                if state.under_way == 0 {
                    let failed = std::mem::take(&mut *state).failed;
                    drop(state);
                    done(failed.map_or(Ok(()), Err));
                }
            });
        }
    }

    /// The part of all bytes that are on their way that is here, from 0 to 1; `None` if nothing is.
    pub fn part(&self) -> Option<f32> {
        let state = self.0.borrow();
        let whole: usize = state.brought.keys().map(|path| builtin::size(path)).sum();
        let here: usize = state.brought.values().sum();
        (state.under_way > 0).then(|| here as f32 / whole.max(1) as f32)
    }

    async fn fetch(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        fetch(path, |here| {
            self.0.borrow_mut().brought.insert(path.to_owned(), here);
        })
        .await
    }
}

/// Fetches all of `paths` at once, and adds them to `given`. What cannot be had is missed when it is
/// read.
pub(super) async fn fetch_all(paths: Vec<PathBuf>, given: &GivenFiles) {
    let each = |path: PathBuf| {
        let given = given.clone();
        async move {
            if let Ok(bytes) = fetch(&path, |_| {}).await {
                given.add_builtin(path, bytes);
            }
        }
    };
    at_once(paths, each).await;
}

/// Those of `paths` that the page's site has, by their ways from the page, fetched all at once.
pub(super) async fn fetch_from_site(paths: Vec<PathBuf>) -> Vec<(PathBuf, Vec<u8>)> {
    let fetched = Rc::new(RefCell::new(Vec::new()));
    let each = |path: PathBuf| {
        let fetched = Rc::clone(&fetched);
        async move {
            if let Ok(bytes) = browser::fetch_of_site(&path.to_string_lossy()).await {
                fetched.borrow_mut().push((path, bytes));
            }
        }
    };
    at_once(paths, each).await;
    fetched.take()
}

/// Does `work` for all of `paths` at the same time.
async fn at_once<F: Future<Output = ()> + 'static>(
    paths: Vec<PathBuf>,
    work: impl Fn(PathBuf) -> F,
) {
    let begun = paths.into_iter().map(|path| {
        let work = work(path);
        future_to_promise(async move {
            work.await;
            Ok(JsValue::UNDEFINED)
        })
    });
    let begun: Vec<js_sys::Promise> = begun.collect();
    for promise in begun {
        // None of them is ever rejected.
        let _ = JsFuture::from(promise).await;
    }
}

async fn fetch(path: &Path, here: impl FnMut(usize)) -> Result<Vec<u8>, Diagnostic> {
    let name = path.to_string_lossy();
    let name = name.strip_prefix(builtin::PREFIX).unwrap_or(&name);
    let fetched = browser::fetch(&format!("{FOLDER}{name}"), here).await;
    fetched.map_err(|error| {
        let message = format!("it could not be fetched, and is not inside the page: {error}");
        Diagnostic::new(path, message)
    })
}
