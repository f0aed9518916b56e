//! The paths that a Rust source names, read from its tokens: in `use` trees of any depth, in
//! expressions, types and the arguments of macros, whatever the line breaks and comments.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A path as the source means it, from `crate`, or from a crate or name in scope.
#[derive(Debug, PartialEq)]
pub struct Named {
    /// Its segments. A last `*` stands for all that is inside: of a glob, or of a module that gets
    /// another name.
    pub path: Vec<String>,
    pub line: usize,
}

/// Keywords after which a path may start with `::`, and which start none.
const BEFORE_PATHS: &[&str] = &[
    "as", "break", "const", "dyn", "else", "for", "if", "impl", "in", "match", "move", "mut",
    "pub", "ref", "return", "static", "unsafe", "use", "where", "while", "yield",
];

/// A source as the rules see it.
#[derive(Debug, Default)]
pub struct Names {
    pub paths: Vec<Named>,
    /// Names of methods called without arguments, as in `path.exists()`, with their lines.
    pub bare_calls: Vec<(String, usize)>,
}

/// What `code` names, the file of the module `module` (`["ui", "theme"]` is `ui/theme.rs`).
///
/// # Panics
/// If `code` is not made of Rust's tokens.
pub fn names(code: &str, module: &[&str]) -> Names {
    let tokens: TokenStream = code.parse().expect("the tokens of a Rust source");
    let mut names = Names::default();
    let module = module.iter().map(|&name| name.to_owned()).collect();
    names.read(&tokens, module);
    names
}

impl Names {
    fn read(&mut self, tokens: &TokenStream, module: Vec<String>) {
        let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Ident(name) if *name == "mod" => {
                    if let [_, TokenTree::Ident(name), TokenTree::Group(inside), ..] = &tokens[at..]
                    {
                        let mut module = module.clone();
                        module.push(name.to_string());
                        self.read(&inside.stream(), module);
                        at += 2;
                    }
                    at += 1;
                }
                TokenTree::Ident(_) => {
                    self.note_bare_call(&tokens, at);
                    at += self.read_path(&tokens[at..], &[], &module);
                }
                TokenTree::Group(group) => {
                    self.read(&group.stream(), module.clone());
                    at += 1;
                }
                _ => at += 1,
            }
        }
    }

    /// Reads the path or `use` tree that `tokens` start with, below `prefix`; says how many of
    /// them it took.
    fn read_path(&mut self, tokens: &[TokenTree], prefix: &[String], module: &[String]) -> usize {
        let line = tokens[0].span().start().line;
        let mut path = prefix.to_vec();
        let mut at = 0;
        loop {
            match &tokens[at] {
                TokenTree::Ident(name) if *name == "self" && !path.is_empty() => {}
                TokenTree::Ident(name) => {
                    path.push(name.to_string().trim_start_matches("r#").to_owned());
                }
                TokenTree::Punct(punct) if punct.as_char() == '*' => path.push("*".into()),
                TokenTree::Group(group) => {
                    self.read_tree(group, &path, module);
                    return at + 1;
                }
                _ => return at + 1,
            }
            at += 1;
            let starts_none = path.len() == 1 && BEFORE_PATHS.contains(&&*path[0]);
            if starts_none || !(is_colon(tokens.get(at)) && is_colon(tokens.get(at + 1))) {
                break;
            }
            let goes_on = match tokens.get(at + 2) {
                Some(TokenTree::Ident(_)) => true,
                Some(TokenTree::Punct(punct)) => punct.as_char() == '*',
                Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Brace,
                _ => false,
            };
            if !goes_on {
                break;
            }
            at += 2;
        }
        let renamed = matches!(tokens.get(at), Some(TokenTree::Ident(name)) if *name == "as");
        let mut path = resolved(path, module);
        let whole =
            matches!(&path[..], [root] if ["crate", "std", "core", "alloc"].contains(&&**root));
        if whole && (renamed || !prefix.is_empty()) {
            path.push("*".into());
        }
        self.paths.push(Named { path, line });
        at
    }

    /// Reads what stands in the braces of a `use` tree.
    fn read_tree(&mut self, group: &Group, prefix: &[String], module: &[String]) {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        let is_comma =
            |token: &TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == ',');
        for branch in tokens.split(is_comma) {
            let colons = branch.iter().take_while(|&token| is_colon(Some(token)));
            let branch = &branch[colons.count()..];
            if !branch.is_empty() {
                self.read_path(branch, prefix, module);
            }
        }
    }

    fn note_bare_call(&mut self, tokens: &[TokenTree], at: usize) {
        let after_dot = at.checked_sub(1).is_some_and(
            |before| matches!(&tokens[before], TokenTree::Punct(p) if p.as_char() == '.'),
        );
        let empty = matches!(tokens.get(at + 1), Some(TokenTree::Group(group))
            if group.delimiter() == Delimiter::Parenthesis && group.stream().is_empty());
        if after_dot && empty {
            let line = tokens[at].span().start().line;
            self.bare_calls.push((tokens[at].to_string(), line));
        }
    }
}

fn is_colon(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == ':')
}

/// `path` from `crate` on, if it starts with `self` or `super`.
fn resolved(path: Vec<String>, module: &[String]) -> Vec<String> {
    let ups = path.iter().take_while(|name| *name == "super").count();
    let (skip, up) = match &*path[0] {
        "self" => {
            let ups = path[1..].iter().take_while(|name| *name == "super").count();
            (1 + ups, ups)
        }
        "super" => (ups, ups),
        _ => return path,
    };
    let kept = &module[..module.len().saturating_sub(up)];
    let mut absolute = vec!["crate".to_owned()];
    absolute.extend(kept.iter().cloned());
    absolute.extend(path.into_iter().skip(skip));
    absolute
}
