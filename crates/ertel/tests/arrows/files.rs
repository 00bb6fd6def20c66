//! Which file of a crate uses an item of which other file, read from `use` items and paths in the code.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Longest chain of re-exports that is followed.
const LONGEST_CHAIN: usize = 12;

/// Words in front of the name of an item.
const ITEMS: [&str; 9] = [
    "fn",
    "struct",
    "enum",
    "trait",
    "type",
    "const",
    "static",
    "union",
    "macro_rules",
];

type Module = Vec<String>;

/// A file without its tests.
#[derive(Default)]
struct File {
    /// Where it is, relative to the folder of all crates.
    name: String,
    /// Names of the items that it defines.
    items: BTreeSet<String>,
    /// Paths of `use` items, by the name that they bring into scope.
    imports: BTreeMap<String, Vec<Module>>,
    /// Modules whose items are all imported.
    globs: Vec<Module>,
    /// Paths in the code.
    paths: Vec<Module>,
    /// Modules that it declares.
    declared: BTreeSet<String>,
    /// Those among them that are for tests alone.
    tests: Vec<String>,
}

/// Arrows between the files of the crate whose source is in `root`, from a file to those that define what it uses.
pub fn arrows(root: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let modules = modules(root);
    let mut arrows = BTreeMap::new();
    for (module, file) in &modules {
        let mut used = BTreeSet::new();
        for path in file.imports.values().flatten().chain(&file.paths) {
            used.extend(defined_in(&modules, module, path, LONGEST_CHAIN));
        }
        used.remove(&file.name);
        arrows.insert(file.name.clone(), used);
    }
    arrows
}

/// Sets of more than one file in which each file uses, directly or through others, each other one.
pub fn circles(arrows: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<BTreeSet<String>> {
    let reached: BTreeMap<&String, BTreeSet<&String>> = (arrows.keys())
        .map(|start| {
            let mut found = BTreeSet::new();
            let mut open = vec![start];
            while let Some(file) = open.pop() {
                open.extend(arrows[file].iter().filter(|next| found.insert(*next)));
            }
            (start, found)
        })
        .collect();
    (arrows.keys())
        .filter(|file| reached[file].contains(file))
        .map(|file| {
            let returns = |other: &&String| reached[*other].contains(file);
            (reached[file].iter().copied())
                .filter(returns)
                .cloned()
                .collect()
        })
        .collect()
}

fn modules(root: &Path) -> BTreeMap<Module, File> {
    let mut paths = Vec::new();
    super::sources(root, &mut paths);
    let mut modules: BTreeMap<Module, File> = (paths.into_iter())
        .map(|path| {
            let mut file = read(&std::fs::read_to_string(&path).unwrap());
            let all = root.ancestors().nth(2).unwrap();
            file.name = path.strip_prefix(all).unwrap().display().to_string();
            (module_of(path.strip_prefix(root).unwrap()), file)
        })
        .collect();
    let tests: Vec<Module> = (modules.iter())
        .flat_map(|(module, file)| {
            (file.tests.iter()).map(|name| [module.as_slice(), std::slice::from_ref(name)].concat())
        })
        .collect();
    modules.retain(|module, _| !tests.iter().any(|test| module.starts_with(test)));
    modules
}

fn module_of(inside: &Path) -> Module {
    let mut module: Module = (PathBuf::from(inside).with_extension("").iter())
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if (module.last()).is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
        module.pop();
    }
    module
}

/// The file that defines what `path` means in `module`, if it is an item of this crate and no module.
fn defined_in(
    modules: &BTreeMap<Module, File>,
    module: &Module,
    path: &[String],
    links: usize,
) -> Option<String> {
    let links = links.checked_sub(1)?;
    let (first, rest) = path.split_first()?;
    let mut place = module.clone();
    let mut rest = rest;
    match first.as_str() {
        "crate" => place.clear(),
        "self" => {}
        "super" => {
            place.pop();
        }
        _ => {
            let child = [module.as_slice(), std::slice::from_ref(first)].concat();
            if modules.contains_key(&child) {
                place = child;
            } else {
                return (modules[module].imports.get(first)?.iter())
                    .filter(|import| import[..] != path[..import.len().min(path.len())])
                    .find_map(|import| {
                        let whole = [import.as_slice(), rest].concat();
                        defined_in(modules, module, &whole, links)
                            .or_else(|| defined_in(modules, module, import, links))
                    });
            }
        }
    }
    while let Some((name, others)) = rest.split_first() {
        let child = [place.as_slice(), std::slice::from_ref(name)].concat();
        if name == "super" {
            place.pop();
        } else if modules.contains_key(&child)
            && !(others.is_empty() && is_item(modules, &place, name))
        {
            place = child;
        } else {
            let file = modules.get(&place)?;
            if file.items.contains(name) {
                return Some(file.name.clone());
            }
            let imported = (file.imports.get(name).into_iter().flatten()).find_map(|import| {
                let whole = [import.as_slice(), others].concat();
                defined_in(modules, &place, &whole, links)
                    .or_else(|| defined_in(modules, &place, import, links))
            });
            let through = || {
                file.globs.iter().find_map(|glob| {
                    let whole = [glob.as_slice(), std::slice::from_ref(name)].concat();
                    defined_in(modules, &place, &whole, links)
                })
            };
            // A module whose file is elsewhere, and an item of another crate.
            let external = file.declared.contains(name) || file.imports.contains_key(name);
            return imported
                .or_else(through)
                .or_else(|| (!external).then(|| file.name.clone()));
        }
        rest = others;
    }
    None
}

fn is_item(modules: &BTreeMap<Module, File>, place: &Module, name: &String) -> bool {
    (modules.get(place))
        .is_some_and(|file| file.items.contains(name) || file.imports.contains_key(name))
}

fn read(text: &str) -> File {
    let words = without_tests(words(text));
    let mut file = File {
        tests: words.1,
        ..File::default()
    };
    let words = words.0;
    let mut depth = 0;
    let mut at = 0;
    while at < words.len() {
        let word = words[at].as_str();
        let next = words.get(at + 1).map_or("", String::as_str);
        depth += nesting(word);
        if word == "use" && next != "<" {
            at = read_use(&words, at + 1, &Vec::new(), &mut file);
        } else if word == "mod" {
            file.declared.insert(next.to_owned());
            at += 2;
        } else if ITEMS.contains(&word) && depth == 0 {
            let skipped = usize::from(word == "macro_rules" || next == "fn" || next == "unsafe");
            file.items.extend(words.get(at + 1 + skipped).cloned());
            at += 1;
        } else if is_name(word) && next == "::" {
            let mut path = vec![words[at].clone()];
            while (words.get(at + 1)).is_some_and(|sign| sign == "::")
                && words.get(at + 2).is_some_and(|name| is_name(name))
            {
                path.push(words[at + 2].clone());
                at += 2;
            }
            file.paths.push(path);
            at += 1;
        } else {
            at += 1;
        }
    }
    file
}

/// Reads a tree of a `use` item from `at`, returns where it ends.
fn read_use(words: &[String], mut at: usize, before: &Module, file: &mut File) -> usize {
    let mut path = before.clone();
    loop {
        match words[at].as_str() {
            "{" => {
                at += 1;
                while words[at] != "}" {
                    at = read_use(words, at, &path, file);
                    if words[at] == "," {
                        at += 1;
                    }
                }
                return at + 1;
            }
            "*" => {
                file.globs.push(path);
                return at + 1;
            }
            "::" => at += 1,
            "as" => {
                let name = words[at + 1].clone();
                file.imports.entry(name).or_default().push(path);
                return at + 2;
            }
            word if is_name(word) => {
                if word != "self" || path.is_empty() {
                    path.push(words[at].clone());
                }
                at += 1;
            }
            _ => {
                if let Some(name) = path.last().cloned() {
                    file.imports.entry(name).or_default().push(path);
                }
                return at;
            }
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// How many brackets a word opens, less those that it closes.
fn nesting(word: &str) -> i32 {
    i32::from(["(", "[", "{"].contains(&word)) - i32::from([")", "]", "}"].contains(&word))
}

/// The words without items for tests alone, and the names of modules among these.
fn without_tests(words: Vec<String>) -> (Vec<String>, Vec<String>) {
    let mut kept = Vec::new();
    let mut modules = Vec::new();
    let mut at = 0;
    while at < words.len() {
        let attribute = words[at..].iter().take(6).map(String::as_str);
        let attribute: Vec<&str> = attribute.collect();
        if !(attribute.starts_with(&["#", "[", "cfg", "(", "test", ")"])
            || attribute.starts_with(&["#", "[", "cfg", "(", "all", "("])
                && words.get(at + 6).is_some_and(|word| word == "test"))
        {
            kept.push(words[at].clone());
            at += 1;
            continue;
        }
        let mut depth = 0;
        while at < words.len() {
            let word = words[at].as_str();
            depth += nesting(word);
            if word == "mod" && depth == 0 && words[at + 2] == ";" {
                modules.push(words[at + 1].clone());
            }
            at += 1;
            if depth == 0 && (word == ";" || word == "}") {
                break;
            }
        }
    }
    (kept, modules)
}

/// Names and signs of code, without comments and literals.
fn words(text: &str) -> Vec<String> {
    let text: Vec<char> = text.chars().collect();
    let at = |place: usize| text.get(place).copied().unwrap_or(' ');
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut place = 0;
    while place < text.len() {
        let c = at(place);
        let start = place;
        place += 1;
        if c == '/' && at(place) == '/' {
            while place < text.len() && at(place) != '\n' {
                place += 1;
            }
        } else if c == '/' && at(place) == '*' {
            while place < text.len() && !(at(place) == '*' && at(place + 1) == '/') {
                place += 1;
            }
            place += 2;
        } else if c == '"' {
            while place < text.len() && at(place) != '"' {
                place += 1 + usize::from(at(place) == '\\');
            }
            place += 1;
        } else if c == '\'' && (at(place) == '\\' || at(place + 1) == '\'') {
            place += 1 + usize::from(at(place) == '\\');
            while place < text.len() && at(place) != '\'' {
                place += 1;
            }
            place += 1;
        } else if is_part(c) {
            while is_part(at(place)) {
                place += 1;
            }
            let word: String = text[start..place].iter().collect();
            let mut hashes = place;
            while at(hashes) == '#' {
                hashes += 1;
            }
            if ["r", "br"].contains(&word.as_str()) && at(hashes) == '"' {
                let end = format!("\"{}", "#".repeat(hashes - place));
                let end: Vec<char> = end.chars().collect();
                place = hashes + 1;
                while place < text.len() && !text[place..].starts_with(&end) {
                    place += 1;
                }
                place += end.len();
            } else {
                words.push(word);
            }
        } else if c == ':' && at(place) == ':' {
            place += 1;
            words.push("::".to_owned());
        } else if !c.is_whitespace() {
            words.push(c.to_string());
        }
    }
    words
}
