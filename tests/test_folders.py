"""Folders hold at most twelve modules, their READMEs name these, and a module name has one meaning."""

import re
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
GLOSSARY = ROOT / "docs" / "glossary.md"
FULLEST, LONGEST_README = 12, 20

FULL_FOLDERS: dict[str, str] = {
    "benchmarks": "one command for each claim; `make bench` runs them all, and people look for a claim by its name",
}
"""Folders with more than twelve modules, and why."""

RETIRED = """
adopt apart beat bench blame bucket casting closed company copies craft crowd customs deeds desk door ensemble
errands greeting grip grounds hands holdings intake keeper lanes ledger library likeness lining ribbons scribe
settle settler settling shelf sitters studio supply surroundings troupe upright wardrobe weave
""".split()
"""Names that nobody of the field would search for, or that once meant several things."""


def is_source(path: Path) -> bool:
    """Whether a file is a module of ours: no test, no package file, nothing built."""
    return (
        path.stem != "__init__" and not path.name.endswith((".test.ts", ".d.ts")) and "node_modules" not in path.parts
    )


def modules() -> dict[Path, list[Path]]:
    """The modules of every folder of the sources, in both languages."""
    found = defaultdict[Path, list[Path]](list)
    for top, suffix in (("src/omote", "py"), ("tools", "py"), ("benchmarks", "py"), ("web/src", "ts")):
        for path in sorted((ROOT / top).rglob(f"*.{suffix}")):
            if is_source(path):
                found[path.parent].append(path)
    return dict(found)


FOLDERS = modules()


def name_of(path: Path) -> str:
    """The path of a file or folder from the root."""
    return path.relative_to(ROOT).as_posix()


def shared_names() -> dict[str, set[str]]:
    """The module names that occur in more than one folder, with these folders."""
    places = defaultdict[str, set[str]](set)
    for folder, paths in FOLDERS.items():
        for path in paths:
            places[path.stem].add(name_of(folder))
    return {name: where for name, where in places.items() if len(where) > 1}


@pytest.mark.parametrize("folder", FOLDERS, ids=name_of)
def test_a_folder_holds_at_most_twelve_modules_or_says_why(folder: Path) -> None:
    assert (len(FOLDERS[folder]) > FULLEST) == (name_of(folder) in FULL_FOLDERS)


@pytest.mark.parametrize("folder", FOLDERS, ids=name_of)
def test_the_readme_of_a_folder_is_short_and_names_what_is_there(folder: Path) -> None:
    text = (folder / "README.md").read_text()
    named = set(re.findall(r"`([\w./]+)`", text))
    below = {path.name for path in folder.iterdir() if path in FOLDERS}
    assert len(text.splitlines()) <= LONGEST_README
    assert {path.stem for path in FOLDERS[folder]} <= {name.removesuffix(".py").removesuffix(".ts") for name in named}
    assert below <= {name.rstrip("/") for name in named}


@pytest.mark.parametrize("folder", FOLDERS, ids=name_of)
def test_retired_names_do_not_come_back(folder: Path) -> None:
    assert [name_of(path) for path in FOLDERS[folder] if set(path.stem.split("_")) & set(RETIRED)] == []


def test_a_name_in_several_folders_has_one_meaning_in_the_glossary() -> None:
    section = GLOSSARY.read_text().partition("## Module names in several folders\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| `(\w+)` \| (.+?) \| (.+) \|$", section, re.MULTILINE)
    told = {name: set(re.findall(r"`([\w/]+)`", where)) for name, where, _ in rows}
    assert told == shared_names()
    assert all(len(meaning) > 10 for _, _, meaning in rows)
