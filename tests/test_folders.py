"""Folders hold at most twenty-five modules, and retired names stay away."""

from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parent.parent
FULLEST = 25

FULL_FOLDERS: dict[str, str] = {
    "benchmarks": "one command for each claim; `make bench` runs them all, and people look for a claim by its name",
}
"""Folders with more than that, and why."""

RETIRED = """
adopt apart beat bench blame bucket casting closed company copies craft crowd customs deeds desk door ensemble
errands greeting grip grounds holdings intake keeper lanes ledger library likeness lining ribbons scribe
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


def test_folders_are_not_too_full() -> None:
    assert {name_of(folder) for folder, paths in FOLDERS.items() if len(paths) > FULLEST} == FULL_FOLDERS.keys()


def test_retired_names_do_not_come_back() -> None:
    paths = [path for folder in FOLDERS.values() for path in folder]
    assert [name_of(path) for path in paths if set(path.stem.split("_")) & set(RETIRED)] == []
