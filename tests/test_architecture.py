"""The shape of the code: layers, sizes, names, a test for every module. docs/architecture.md in a form that fails."""

import ast
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SOURCE = ROOT / "src" / "omote"
TOOLS = ROOT / "tools"
MODULES = sorted(path for folder in (SOURCE, TOOLS, ROOT / "benchmarks") for path in folder.rglob("*.py"))
SCRIPTS = sorted((ROOT / "web" / "src").rglob("*.ts"))

LONGEST_MODULE = 800
"""Lines."""
LONGEST_BODY = 80
"""Lines, docstring not counted."""
LONG_MODULES = {"web/src/link/messages.ts"}
LONG_BODIES = {"tools/tracking/rasterizer.py:shade_pixels"}
"""Longer than that until their subjects are cut apart, and no others."""

EMPTY_NAMES = re.compile(r"utils?|helpers?|common|core|misc|stuff|base")
# Which modules need no test file of their own, and why.
UNTESTED: dict[str, str] = {
    "__main__": "one line that calls the command line",
    "arrays": "types alone, which mypy checks",
    "cast_documents": "documents alone: their tests are those of what writes and reads them",
    "osc": "a declaration: its tests are those of the addresses that are derived from it",
}
DECLARATIONS = SOURCE / "show" / "objects"
"""Nouns, whose tests are those of what is derived from them (`tests/show/test_declaration.py`)."""


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


@cache
def parse(path: Path) -> ast.Module:
    """The syntax tree of a module, read once for all tests."""
    return ast.parse(path.read_text())


def parallel_assignments(tree: ast.Module) -> list[int]:
    """Lines that set several things of which none needs the others; targets of one or two letters are coordinates."""
    return [
        node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign)
        and isinstance(targets := node.targets[0], ast.Tuple)
        and isinstance(values := node.value, ast.Tuple)
        and not any(isinstance(each, ast.Starred) for each in (*targets.elts, *values.elts))
        and not all(isinstance(each, ast.Name) and len(each.id) <= 2 for each in targets.elts)
        and not _depend(targets, values)
    ]


def _depend(targets: ast.Tuple, values: ast.Tuple) -> bool:
    """Whether an earlier target stands in a later value or target."""
    written = set[str]()
    for target, value in zip(targets.elts, values.elts, strict=True):
        if written & {ast.unparse(node) for each in (target, value) for node in ast.walk(each)}:
            return True
        written |= {ast.unparse(node) for node in ast.walk(target) if isinstance(node, ast.expr)}
    return False


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


def powers(tree: ast.Module) -> list[ast.BinOp]:
    """Powers of what is no constant."""
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Pow)
        and not isinstance(node.left, ast.Constant)
        and not isinstance(node.left, ast.UnaryOp)
    ]


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


def test_modules_are_one_subject() -> None:
    long = {name_of(path) for path in [*MODULES, *SCRIPTS] if len(path.read_text().splitlines()) > LONGEST_MODULE}
    assert long == LONG_MODULES


def test_bodies_are_one_thought() -> None:
    long = {f"{name_of(path)}:{name}" for path in MODULES for name, n in bodies(parse(path)) if n > LONGEST_BODY}
    assert long == LONG_BODIES


def test_a_line_holds_one_statement() -> None:
    """Coordinates of one point, such as `x, y`, may be set in one; so may what changes places."""
    parallel = [f"{name_of(path)}:{line}" for path in MODULES for line in parallel_assignments(parse(path))]
    assert parallel == []


def test_no_power_of_a_c_library_is_in_a_state() -> None:
    """`pow` is not correctly rounded: a replay where another library does it would end in other bits."""
    played = [path for path in MODULES if SOURCE / "perform" in path.parents and path.stem != "lights"]
    states = [path for path in played if path.parent.name != "blending"]  # which makes skins, not states
    found = [f"{name_of(path)}:{node.lineno}" for path in states for node in powers(parse(path))]
    assert found == []


@pytest.mark.parametrize(
    ("text", "lines"),
    [("left, right = 1, 2", [1]), ("x, y = 1, 2", []), ("low, high = high, low", []), ("low, high = ends", [])],
)
def test_the_search_for_parallel_assignments_finds_them(text: str, lines: list[int]) -> None:
    assert parallel_assignments(ast.parse(text)) == lines


def test_modules_are_named_after_what_they_do() -> None:
    named = {path: path.relative_to(ROOT).with_suffix("").parts for path in [*MODULES, *SCRIPTS]}
    assert [name_of(path) for path, parts in named.items() if any(map(EMPTY_NAMES.fullmatch, parts))] == []


def test_every_module_has_a_test_where_the_tree_says() -> None:
    tested = [path for path in MODULES if path.is_relative_to(SOURCE) and path.stem not in {"__init__", *UNTESTED}]
    wanted = [
        ROOT / "tests" / path.relative_to(SOURCE).with_name(f"test_{path.name}")
        for path in tested
        if path.parent != DECLARATIONS
    ]
    assert [name_of(test) for test in wanted if not test.is_file()] == []


@pytest.mark.parametrize(
    "text", ["np.clip(x, 0, 1)", "x.clip(0, 1)", "min(max(x, 0), 1)", "np.maximum(np.minimum(x, 1), 0)"]
)
def test_the_search_for_clamps_finds_one(text: str) -> None:
    assert clamps(ast.parse(text)) == [1]


def test_only_validation_clamps_what_comes_in() -> None:
    outer = [path for path in MODULES if any(path.is_relative_to(SOURCE / folder) for folder in ("show", "server"))]
    clamping = {name_of(path): lines for path in outer if (lines := clamps(parse(path)))}
    assert clamping == {}
