"""The shape of the code: layers, sizes, names, a test for every module. docs/architecture.md in a form that fails."""

import ast
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SOURCE = ROOT / "src" / "omote"
TOOLS = ROOT / "tools"
MODULES = sorted(path for folder in (SOURCE, TOOLS, ROOT / "benchmarks") for path in folder.rglob("*.py"))
SCRIPTS = sorted((ROOT / "web" / "src").rglob("*.ts"))

LONGEST_MODULE, LONGEST_BODY = 300, 25
LONG_MODULES: dict[str, str] = {
    "benchmarks/evaluate.py": "one claim of four ratios at three sizes, and the peers they are measured against",
    "benchmarks/loss.py": "one claim for seven kinds of source, each played by its own messages or packets",
    "src/omote/server/supervision/supervisor.py": "what keeps the show going must be seen at one place",
    "src/omote/show/messages.py": "every message and document once, in one file",
    "tools/baking/heads/people.py": "one recipe for each person, line by line",
    "src/omote/edit/protocol/messages.py": "every message of an editor's link once, in one file",
    "web/src/link/editing_messages.ts": "written by tools/messages.py from the one file above",
    "web/src/console/console_page_style.ts": "the places of one page, a layout for each size of window",
    "web/src/console/store/console_store.test.ts": "one store, a test for each of its promises",
    "web/src/editor/session/draft_store.test.ts": "one store, a test for each of its promises",
    "web/src/link/messages.ts": "written by tools/messages.py from show/messages.py",
    "benchmarks/tracking.py": "the films of one claim, four ways to track them, and nine measures of each",
    "benchmarks/interruptions.py": "one claim with its bound, its search for the maximum and its picture",
    "src/omote/model/controls/control_net.py": "public: parameters, errors and an example of each method",
    "src/omote/model/space/parameter_space.py": "public: parameters, errors and an example of each method",
    "src/omote/perform/scene/scene.py": "public: parameters, errors and an example of each method",
    "src/omote/perform/performer.py": "public: parameters, errors and an example of each method",
}
LONG_BODIES: dict[str, str] = {
    "tools/tracking/rasterizer.py:draw_triangles": "one loop over the pixels of triangles, compiled",
    "tools/tracking/rasterizer.py:shade_pixels": "one loop over the pixels of a picture, compiled",
}

EMPTY_NAMES = re.compile(r"utils?|helpers?|common|core|misc|stuff|base")
# Which modules need no test file of their own, and why.
UNTESTED: dict[str, str] = {
    "__main__": "one line that calls the command line",
}


def layers() -> list[str]:
    """The layers as import-linter checks them, highest first."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    return next(list(contract["layers"]) for contract in contracts if contract["type"] == "layers")


def bodies(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Every function of a module with the lines of its body, docstring not counted."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            documented = ast.get_docstring(node) is not None and len(node.body) > 1
            first = node.body[1] if documented else node.body[0]
            yield node.name, (node.body[-1].end_lineno or 0) - first.lineno + 1


def clamps(tree: ast.Module) -> list[int]:
    """Lines that clamp: `clip(...)`, `min(max(...))`, `max(min(...))`."""
    return [
        node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and (_called(node) == "clip" or _is_nested_clamp(node))
    ]


def _called(node: ast.Call) -> str:
    return getattr(node.func, "attr", getattr(node.func, "id", ""))


def _is_nested_clamp(node: ast.Call) -> bool:
    inside = {_called(argument) for argument in node.args if isinstance(argument, ast.Call)}
    return (_called(node), *inside) in {("min", "max"), ("max", "min"), ("minimum", "maximum"), ("maximum", "minimum")}


def name_of(path: Path) -> str:
    """The path of a file as the lists above write it."""
    return path.relative_to(ROOT).as_posix()


def test_the_page_shows_the_layers_in_the_order_that_is_checked() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text()
    tree = re.search(r"^src/omote/\n((?:  .*\n)+)", page, re.MULTILINE)
    assert tree is not None
    shown = re.findall(r"^  (\w+)(?:/|\.py)", tree[1], re.MULTILINE)
    assert shown == layers()[::-1]


def test_every_folder_is_a_layer() -> None:
    found = {path.name for path in SOURCE.iterdir() if path.is_dir() and any(path.glob("*.py"))}
    found |= {path.stem for path in SOURCE.glob("*.py")} - {"__init__", "__main__"}
    assert found == set(layers())


@pytest.mark.parametrize("path", [*MODULES, *SCRIPTS], ids=name_of)
def test_modules_are_short_or_say_why(path: Path) -> None:
    assert len(path.read_text().splitlines()) <= LONGEST_MODULE or name_of(path) in LONG_MODULES


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_bodies_are_short_or_say_why(path: Path) -> None:
    long = {f"{name_of(path)}:{name}": n for name, n in bodies(ast.parse(path.read_text())) if n > LONGEST_BODY}
    assert {place: n for place, n in long.items() if place not in LONG_BODIES} == {}


def test_nothing_is_listed_as_long_that_is_short_or_gone() -> None:
    lengths = {name_of(path): len(path.read_text().splitlines()) for path in [*MODULES, *SCRIPTS]}
    long = {f"{name_of(p)}:{name}" for p in MODULES for name, n in bodies(ast.parse(p.read_text())) if n > LONGEST_BODY}
    assert [name for name in LONG_MODULES if lengths.get(name, 0) <= LONGEST_MODULE] == []
    assert LONG_BODIES.keys() <= long


@pytest.mark.parametrize("path", [*MODULES, *SCRIPTS], ids=name_of)
def test_modules_are_named_after_what_they_do(path: Path) -> None:
    assert not [part for part in path.relative_to(ROOT).with_suffix("").parts if EMPTY_NAMES.fullmatch(part)]


@pytest.mark.parametrize("path", [p for p in MODULES if p.is_relative_to(SOURCE) and p.stem != "__init__"], ids=name_of)
def test_every_module_has_a_test_where_the_tree_says(path: Path) -> None:
    test = ROOT / "tests" / path.relative_to(SOURCE).with_name(f"test_{path.name}")
    assert path.stem in UNTESTED or test.is_file(), f"{name_of(path)} wants {name_of(test)}"


@pytest.mark.parametrize(
    "text", ["np.clip(x, 0, 1)", "x.clip(0, 1)", "min(max(x, 0), 1)", "np.maximum(np.minimum(x, 1), 0)"]
)
def test_the_search_for_clamps_finds_one(text: str) -> None:
    assert clamps(ast.parse(text)) == [1]


@pytest.mark.parametrize(
    "path",
    [p for folder in ("show", "server") for p in sorted((SOURCE / folder).rglob("*.py")) if p.name != "validation.py"],
    ids=name_of,
)
def test_only_validation_clamps_what_comes_in(path: Path) -> None:
    assert clamps(ast.parse(path.read_text())) == []
