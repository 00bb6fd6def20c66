//! Files of the user are left alone: what a command reads, it does not write, and folders of others stay as they are.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::common::{code, copy, ertel, read, text, write};

/// All that a folder holds: texts of files, targets of links.
fn content(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let meta = std::fs::symlink_metadata(&path).unwrap();
        if meta.is_dir() {
            found.extend(content(&path));
            found.insert(path, b"folder".to_vec());
        } else if meta.is_symlink() {
            let target = std::fs::read_link(&path).unwrap();
            found.insert(path, target.to_string_lossy().into_owned().into_bytes());
        } else {
            let bytes = std::fs::read(&path).unwrap();
            found.insert(path, bytes);
        }
    }
    found
}

/// Exit code and words on stderr, and nothing has changed.
fn refused(folder: &TempDir, arguments: &str, code: i32, words: &str) {
    let before = content(folder.path());
    let output = ertel(folder, arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
    assert!(message.contains(words), "{arguments:?}: {message}");
    assert!(
        content(folder.path()) == before,
        "{arguments:?} changed a file"
    );
}

const STUDY: &str =
    "case = \"base.toml\"\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";

/// A folder with a base case and a study of two points.
fn workspace() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy("tests/good/quick.toml", &folder, "base.toml");
    write(&folder, "study.toml", STUDY);
    folder
}

#[test]
fn a_fit_does_not_overwrite_what_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    copy(
        "../../validation/appendix-c/fluid-a.csv",
        &folder,
        "mine.csv",
    );
    let absolute = folder.path().join("mine.csv");
    std::fs::create_dir(folder.path().join("below")).unwrap();
    std::fs::hard_link(&absolute, folder.path().join("hard.toml")).unwrap();
    std::fs::hard_link(&absolute, folder.path().join("hard.svg")).unwrap();
    let mut names = vec![
        "mine.csv",
        "./mine.csv",
        "below/../mine.csv",
        absolute.to_str().unwrap(),
        "hard.toml",
        // The picture next to this entry.
        "hard.csv",
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("mine.csv", folder.path().join("soft.toml")).unwrap();
        names.push("soft.toml");
    }
    let fit = |more: &str| format!("fit viscosity mine.csv --law roelands {more}");
    for name in names {
        refused(&folder, &fit(&format!("-o {name}")), 2, "would overwrite");
    }
    refused(&folder, &fit("--plot hard.svg"), 2, "would overwrite");
    // Two outputs of one command in one place.
    refused(
        &folder,
        &fit("-o entry.svg"),
        2,
        "both the entry and the picture",
    );
    code(&ertel(&folder, &fit("-o entry.toml")), 0);

    write(
        &folder,
        "films.svg",
        "speed_m_per_s,film_central_m\n1,1e-7\n2,1.6e-7\n4,2.6e-7\n8,4.1e-7\n",
    );
    let film = "fit film films.svg --form speed --plot ./films.svg";
    refused(&folder, film, 2, "would overwrite");
}

#[test]
fn the_volume_of_a_law_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    copy(
        "../../validation/appendix-c/fluid-a.csv",
        &folder,
        "mine.csv",
    );
    write(
        &folder,
        "volume.toml",
        "[density]\nlaw = \"tait\"\nrho_0 = \"800 kg/m^3\"\nk_0r = \"9 GPa\"\nk_0r_prime = 11.0\n",
    );
    let arguments = "fit viscosity mine.csv --law doolittle --density volume.toml -o volume.toml";
    refused(&folder, arguments, 2, "would overwrite");
}

#[test]
fn results_are_not_written_over_their_case() {
    let folder = workspace();
    let solve = "solve base.toml -q -o out";
    code(&ertel(&folder, solve), 0);
    // A change that the results would undo.
    let case = read(&folder, "out/case.toml");
    write(&folder, "out/case.toml", &(case + "# mine\n"));
    let again = "solve out/case.toml -q -o ./out";
    refused(&folder, again, 2, "out/case.toml");

    // A table that the lubricant names.
    write(
        &folder,
        "out/centreline.csv",
        "temperature [degC], pressure [MPa], viscosity [mPa.s]\n40,0,40\n40,500,4000\n40,2000,90000\n",
    );
    let base = read(&folder, "base.toml");
    let law = "{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"20 1/GPa\" }";
    assert!(base.contains(law));
    let table = "{ law = \"table\", file = \"out/centreline.csv\" }";
    write(&folder, "table.toml", base.replace(law, table));
    let arguments = "solve table.toml -q -o out";
    refused(&folder, arguments, 2, "out/centreline.csv");
}

#[test]
fn a_study_does_not_overwrite_what_it_reads() {
    let folder = workspace();
    let sweep = "sweep study.toml -q -o out";
    code(&ertel(&folder, sweep), 0);
    write(&folder, "out/results.csv", "contact.load [kN/m]\n25\n35\n");
    write(
        &folder,
        "second.toml",
        "case = \"base.toml\"\npoints = \"out/results.csv\"\n",
    );
    let arguments = "sweep second.toml -q -o out";
    refused(&folder, arguments, 2, "out/results.csv");
}

#[test]
fn a_table_of_comparisons_does_not_overwrite_a_study() {
    let folder = workspace();
    copy("tests/good/quick.toml", &folder, "studies/roller/case.toml");
    write(
        &folder,
        "studies/roller/reference.toml",
        "title = \"Roller\"\nsource = \"made up\"\n\n[[run]]\nname = \"roller\"\ncase = \"case.toml\"\nquick = true\n\n\
         [[check]]\nquantity = \"central-film\"\nvalue = 1.0\ntolerance = \"1 %\"\nreason = \"none\"\n",
    );
    for table in ["studies/roller/case.toml", "studies/roller/reference.toml"] {
        let arguments = format!("validate --folder studies --table {table}");
        refused(&folder, &arguments, 2, "would overwrite");
    }
}

/// A journal of another program, in a folder without a study and in one with a study.
#[test]
fn journals_of_others_are_not_adopted() {
    let folder = workspace();
    let foreign = "{\"event\": \"start\"}\nthe last line has no end";
    write(&folder, "theirs/journal.jsonl", foreign);
    let sweep = |out: &str| format!("sweep study.toml -q -o {out}");
    refused(&folder, &sweep("theirs"), 1, "theirs");
    let dry = "sweep study.toml --dry-run -o theirs";
    refused(&folder, dry, 1, "theirs");

    code(&ertel(&folder, &sweep("out")), 0);
    write(&folder, "out/journal.jsonl", foreign);
    refused(&folder, &sweep("out"), 1, "out/journal.jsonl");
    write(&folder, "empty/journal.jsonl", "not a line");
    refused(&folder, &sweep("empty"), 1, "empty");
    write(&folder, "locked/.lock", "1234\n");
    refused(&folder, &sweep("locked"), 1, ".lock");
    // A part to be joined.
    refused(&folder, "sweep --merge whole out", 1, "out/journal.jsonl");
}

/// Without a list of points of ertel a folder is no study, whatever its files are called.
#[test]
fn a_folder_without_a_list_of_points_is_no_study() {
    let folder = workspace();
    code(&ertel(&folder, "sweep study.toml -q -o part"), 0);
    let journal = read(&folder, "part/journal.jsonl");
    for (name, records) in [("empty", ""), ("copied", &journal)] {
        write(&folder, &format!("{name}/journal.jsonl"), records);
        write(&folder, &format!("{name}/results.csv"), "mine");
        write(&folder, &format!("{name}/report.html"), "mine");
        refused(
            &folder,
            &format!("sweep study.toml -q -o {name}"),
            1,
            "no study.json of ertel",
        );
        refused(
            &folder,
            &format!("sweep --merge {name} part"),
            1,
            "no study.json of ertel",
        );
        refused(&folder, &format!("sweep --merge whole {name}"), 2, name);
    }
    for shard in [
        "9223372036854775808/18446744073709551615",
        "1/1000001",
        "3/2",
        "0/2",
    ] {
        refused(
            &folder,
            &format!("sweep study.toml -q --shard {shard}"),
            2,
            "of eight parts",
        );
    }
}

#[cfg(unix)]
#[test]
fn links_in_the_folder_of_a_study_are_not_followed() {
    use std::os::unix::fs::symlink;
    let folder = workspace();
    write(&folder, "precious.txt", "precious, without an end");
    let arguments = "sweep study.toml -q -o out";
    let out = folder.path().join("out");
    std::fs::create_dir(&out).unwrap();
    for name in [".lock", "journal.jsonl", "study.json"] {
        for target in ["../precious.txt", "../nothing"] {
            symlink(target, out.join(name)).unwrap();
            refused(&folder, arguments, 1, name);
            std::fs::remove_file(out.join(name)).unwrap();
        }
    }
    // Likewise where there is a study.
    code(&ertel(&folder, arguments), 0);
    for name in [".lock", "journal.jsonl", "results.csv", "study.json"] {
        let copy = folder.path().join(format!("copy-{name}"));
        std::fs::rename(out.join(name), &copy).unwrap();
        symlink(&copy, out.join(name)).unwrap();
        refused(&folder, arguments, 1, name);
        std::fs::remove_file(out.join(name)).unwrap();
        std::fs::rename(&copy, out.join(name)).unwrap();
    }
    code(&ertel(&folder, arguments), 0);
}

/// A user's own things under the names of ertel's files, in a former result.
#[test]
fn a_former_result_with_things_of_others_is_kept() {
    let folder = workspace();
    let curve = "[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\nfolders = true\n";
    let base = read(&folder, "base.toml");
    write(&folder, "curve.toml", &(base + curve));
    for case in ["base.toml", "curve.toml"] {
        let arguments = format!("solve {case} -q -o out");
        let out = folder.path().join("out");
        let solved = || code(&ertel(&folder, &arguments), 0);
        solved();
        // One of ertel's own names as a folder.
        std::fs::remove_file(out.join("report.txt")).unwrap();
        write(&folder, "out/report.txt/keep", "mine");
        refused(&folder, &arguments, 1, "report.txt");
        std::fs::remove_dir_all(&out).unwrap();
        solved();
        // Folders of points.
        let names: &[&str] = match case {
            "base.toml" => &["points/1/report.txt", "points/report.txt"],
            _ => &["points/mine/report.txt", "points/3/report.txt"],
        };
        for name in names {
            write(&folder, &format!("out/{name}"), "mine");
            refused(
                &folder,
                &arguments,
                1,
                "out: it holds a former result, but also points",
            );
            std::fs::remove_dir_all(&out).unwrap();
            solved();
        }
        #[cfg(unix)]
        {
            write(&folder, "mine.txt", "mine");
            std::fs::remove_file(out.join("report.txt")).unwrap();
            std::os::unix::fs::symlink("../mine.txt", out.join("report.txt")).unwrap();
            refused(&folder, &arguments, 1, "report.txt");
        }
        std::fs::remove_dir_all(&out).unwrap();
    }
}
