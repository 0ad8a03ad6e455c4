//! Imports between the files of a source folder, and circles of them.
//!
//! A file imports another if a path in it (`use`, or inline) leads there. Test modules are free. Test binaries of several crates
//! include this file with `#[path]`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Every file of the source folder `src` by its module path, without its tests and comments. The crate itself has the empty path.
fn sources(src: &Path) -> BTreeMap<Vec<String>, String> {
    fn collect(folder: &Path, module: &[String], into: &mut BTreeMap<Vec<String>, String>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            if name == "tests" || name == "testing" || name.ends_with("_tests") {
                continue;
            }
            let below = [module, std::slice::from_ref(&name)].concat();
            if path.is_dir() {
                collect(&path, &below, into);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let own = if name == "mod" || name == "lib" { module.to_vec() } else { below };
                into.insert(own, production_code(&fs::read_to_string(&path).unwrap()));
            }
        }
    }
    let mut found = BTreeMap::new();
    collect(src, &[], &mut found);
    found
}

/// `text` without comments and without its module of tests, which is the last item of a file.
fn production_code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    text[..end].lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// The paths that `code` names, `use a::{b, c::d}` as `a::b` and `a::c::d`.
fn paths(code: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find(is_of_word) {
        let (path, after) = path_at(&rest[at..], &[], &mut found);
        found.push(path);
        rest = after;
    }
    found.retain(|path| path.len() > 1);
    found
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The path at the beginning of `code`, which continues `prefix`, and what follows it. Of a list in braces all items go into `found`.
fn path_at<'a>(code: &'a str, prefix: &[String], found: &mut Vec<Vec<String>>) -> (Vec<String>, &'a str) {
    let mut path = prefix.to_vec();
    let mut rest = code;
    loop {
        let end = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
        if end > 0 {
            path.push(rest[..end].to_owned());
        }
        let Some(after) = rest[end..].strip_prefix("::") else { return (path, &rest[end..]) };
        rest = after;
        let Some(mut list) = rest.strip_prefix('{') else { continue };
        loop {
            list = list.trim_start_matches(|c: char| c == ',' || c.is_whitespace());
            if let Some(after) = list.strip_prefix('}') {
                return (Vec::new(), after);
            }
            let (item, after) = path_at(list, &path, found);
            found.push(item);
            // Another name may follow.
            list = &after[after.find([',', '}']).expect("a list in braces has an end")..];
        }
    }
}

/// The file that `path`, named in the file `module`, leads to; `module` itself where it leads to none.
fn leads_to(path: &[String], module: &[String], is_file: impl Fn(&[String]) -> bool) -> Vec<String> {
    let mut at = module.to_vec();
    for (k, part) in path.iter().enumerate() {
        match part.as_str() {
            "crate" if k == 0 => at.clear(),
            "self" if k == 0 => (),
            "super" => drop(at.pop()),
            _ => {
                at.push(part.clone());
                if !is_file(&at) {
                    at.pop();
                    break;
                }
            }
        }
    }
    at
}

/// The imports of each file of the source folder `src`, by names such as `pair::part`; the crate itself is `lib`.
pub(crate) fn imports(src: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let files = sources(src);
    let name = |module: &[String]| if module.is_empty() { "lib".to_owned() } else { module.join("::") };
    let imported = |module: &Vec<String>, code: &String| {
        let all = paths(code).into_iter().map(|path| leads_to(&path, module, |at| files.contains_key(at)));
        all.filter(|other| other != module).map(|other| name(&other)).collect()
    };
    files.iter().map(|(module, code)| (name(module), imported(module, code))).collect()
}

/// A circle of files of which each imports the next, if there is one.
pub(crate) fn circle(imports: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn visit<'a>(
        file: &'a str,
        imports: &'a BTreeMap<String, BTreeSet<String>>,
        way: &mut Vec<&'a str>,
        done: &mut BTreeSet<&'a str>,
    ) -> Option<Vec<String>> {
        if let Some(start) = way.iter().position(|&other| other == file) {
            return Some(way[start..].iter().map(|&file| file.to_owned()).collect());
        }
        if done.contains(file) {
            return None;
        }
        way.push(file);
        let found = imports[file].iter().find_map(|next| visit(next, imports, way, done));
        way.pop();
        done.insert(file);
        found
    }
    let mut done = BTreeSet::new();
    imports.keys().find_map(|file| visit(file, imports, &mut Vec::new(), &mut done))
}

#[test]
fn a_circle_is_found() {
    let graph = |arrows: &[(&str, &[&str])]| {
        let imported = |to: &[&str]| to.iter().map(|other| (*other).to_owned()).collect();
        arrows.iter().map(|(file, to)| ((*file).to_owned(), imported(to))).collect()
    };
    assert_eq!(circle(&graph(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])])), None);
    let found = circle(&graph(&[("a", &["b"]), ("b", &["c"]), ("c", &["d"]), ("d", &["b"])]));
    assert_eq!(found.unwrap(), ["b", "c", "d"]);
}

#[test]
fn paths_are_read_from_lists_and_from_within_code() {
    let code = production_code(
        "use super::{a::{self, B as C}, d};\nuse std::fs; // crate::not_this\nfn f() { crate::g::h(x.y, self::i::J) }\n\
         #[cfg(test)]\nmod tests {\n    use crate::nor_that;\n}\n",
    );
    let found: Vec<String> = paths(&code).iter().map(|path| path.join("::")).collect();
    assert_eq!(found, ["super::a::self", "super::a::B", "super::d", "std::fs", "crate::g::h", "self::i::J"]);
    let files = [vec!["g"], vec!["m"], vec!["m", "a"], vec!["m", "k"]];
    let is_file = |at: &[String]| files.iter().any(|file| file.iter().eq(at));
    let from_k = |path: &str| {
        let path: Vec<String> = path.split("::").map(str::to_owned).collect();
        leads_to(&path, &["m".to_owned(), "k".to_owned()], is_file).join("::")
    };
    assert_eq!(["super::a::B", "crate::g::h", "std::fs", "super::x"].map(from_k), ["m::a", "g", "m::k", "m"]);
}
