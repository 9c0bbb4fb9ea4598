"""What the documentation says holds: links lead somewhere, snippets run and print what they say, commands parse."""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import typer

from omote.cli import app
from omote.show.access.route_roles import ROUTES
from tools.website.pages import DOCS, GENERATED, ROOT

SOURCES = ("src/omote", "web/src", "tools", "benchmarks", "examples")
READMES = [page for folder in SOURCES for page in sorted((ROOT / folder).rglob("README.md"))]
MADE = {DOCS / path: make for path, make in GENERATED.items()}
"""What makes each page that is made from the code; none of them need lie in docs/."""
WRITTEN = [*sorted(ROOT.glob("*.md")), *READMES, *sorted({*DOCS.rglob("*.md")} - MADE.keys())]
PAGES = [*WRITTEN, *(page for page in MADE if page.suffix == ".md")]
FRAGMENT = "<!-- fragment"
RUNS = "<!-- runs -->"
TEACHING = [page for folder in ("tutorials", "howto") for page in sorted((DOCS / folder).glob("*.md"))]
LARGEST_PICTURE = 200_000


def name_of(page: Path) -> str:
    """The path of a page in the repository."""
    return page.relative_to(ROOT).as_posix()


@cache
def text_of(page: Path) -> str:
    """The text of a page, made anew where it is made from the code."""
    return MADE[page]() if page in MADE else page.read_text(encoding="utf-8")


def fences(page: Path, language: str) -> Iterator[tuple[str, str]]:
    """The code blocks of a language, in their order: the line before each, and its text without indentation."""
    pattern = rf"^([^\n]*)\n( *)```{language}\n(.*?)^\2```$"
    for before, indent, code in re.findall(pattern, text_of(page), re.MULTILINE | re.DOTALL):
        yield before, "".join(line.removeprefix(indent) for line in code.splitlines(keepends=True))


def prose(page: Path) -> str:
    """A page without its code, where brackets mean something else."""
    return re.sub(r"^( *)```.*?^\1```$|`[^`\n]*`", "", text_of(page), flags=re.MULTILINE | re.DOTALL)


@cache
def anchors(page: Path) -> frozenset[str]:
    """What a page's headings can be reached by, as code hosts and as mkdocs spell it."""
    without_code = re.sub(r"^( *)```.*?^\1```$", "", text_of(page), flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ (.*)$", without_code, re.MULTILINE)
    words = [re.sub(r"[^\w\s-]", "", title).strip().lower() for title in titles]
    return frozenset(w.replace(" ", "-") for w in words) | {re.sub(r"[-\s]+", "-", w) for w in words}


def broken(page: Path, link: str) -> bool:
    """Whether a link of a page leads nowhere."""
    path, _, anchor = link.partition("#")
    target = Path(os.path.normpath(page.parent / path)) if path else page
    if target not in PAGES:
        return not (target in MADE or target.exists()) or bool(anchor)
    return bool(anchor) and anchor not in anchors(target)


def commands_of(page: Path) -> list[str]:
    """The `omote` command lines of a page's shell blocks, each on one line."""
    blocks = [code.replace("\\\n", " ") for _, code in fences(page, "sh")]
    return [line for block in blocks for line in block.splitlines() if line.startswith("omote ")]


def parse(line: str) -> None:
    """Parses a command line as the command would, and runs nothing; click's own error where it is none."""
    _, *words = shlex.split(line, comments=True)
    command: Any = typer.main.get_command(app)
    while hasattr(command, "commands"):
        command = command.commands[words.pop(0)]
    command.make_context(command.name, words)


def promised(code: str) -> list[str]:
    """What a snippet says that its prints give: the comment behind them, up to a colon or dots."""
    lines = [line for line in code.splitlines() if line.lstrip().startswith("print(")]
    return [re.split(r": |\.\.\.", line.split(")  # ", 1)[1])[0] if ")  # " in line else "" for line in lines]


def test_headings_become_anchors(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# One: two `three`\n\n```sh\n# none\n```\n\n### Eq. 3\n")
    assert anchors(page) == {"one-two-three", "eq-3"}


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_to_pages_and_headings(page: Path) -> None:
    links = re.findall(r"\]\(([^)\s]+)\)", prose(page))
    assert [link for link in links if "://" not in link and broken(page, link)] == []


def test_a_link_to_nowhere_is_found() -> None:
    assert broken(DOCS / "index.md", "nowhere.md")
    assert broken(DOCS / "index.md", "conventions.md#nowhere")
    assert broken(DOCS / "index.md", "#nowhere")
    assert not broken(DOCS / "index.md", "conventions.md#numbers")
    assert not broken(DOCS / "index.md", "reference/wire.md#call_face")


@pytest.mark.parametrize("page", [page for page in WRITTEN if "```sh" in text_of(page)], ids=name_of)
def test_commands_parse(page: Path) -> None:
    for line in commands_of(page):
        parse(line)


@pytest.mark.parametrize("line", ["omote shwo", "omote export dog", "omote render -o x.png --fcae kaori"])
def test_a_command_that_is_none_does_not_parse(line: str) -> None:
    with pytest.raises(Exception, match=r"shwo|output|fcae"):
        parse(line)


@pytest.mark.parametrize("page", [p for p in TEACHING if "```python" in text_of(p)], ids=name_of)
def test_snippets_run_and_print_what_they_say(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}  # later snippets of a page go on where the earlier ones were
    for before, code in fences(page, "python"):
        program = compile(code, name_of(page), "exec")
        if before.startswith(FRAGMENT):
            continue
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            exec(program, names)
        lines = said.getvalue().splitlines()
        assert [line[: len(word)] for line, word in zip(lines, promised(code), strict=True)] == promised(code)


@pytest.mark.parametrize("page", [page for page in WRITTEN if RUNS in text_of(page)], ids=name_of)
def test_shell_blocks_that_say_so_run(page: Path, tmp_path: Path) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    for before, code in fences(page, "sh"):
        if before == RUNS:
            command = ["sh", "-e", "-c", code]
            done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr


def test_every_page_is_in_the_navigation_or_in_the_list_of_decisions() -> None:
    entries = re.findall(r"^ +- (?:.*: )?(\S+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.MULTILINE)
    pages = {page.relative_to(DOCS).as_posix() for page in PAGES if page.is_relative_to(DOCS)}
    once = {page for page in pages if not page.startswith("decisions/")} | {"decisions/README.md"}
    assert sorted(entries) == sorted(once)


def test_pictures_of_tutorials_are_light() -> None:
    pictures = [*(DOCS / "pictures").glob("tutorial-*")]
    assert len(pictures) >= 4
    assert [path.name for path in pictures if path.stat().st_size > LARGEST_PICTURE] == []


def test_the_page_of_addresses_names_what_the_server_and_the_stage_know() -> None:
    page = text_of(DOCS / "reference" / "addresses.md")
    routes = {route.split("/")[1] for _, route in ROUTES if re.match(r"/\w", route)}
    stage = next((ROOT / "web" / "src").rglob("parameters.ts")).read_text()
    known = re.findall(r'"(\w+)"', re.findall(r"PARAMETERS = \[(.*?)\]", stage, re.DOTALL)[0])
    assert len(routes) >= 5
    assert [route for route in sorted(routes) if f"`/{route}" not in page] == []
    assert sorted(
        re.findall(r"^\| `(\w+)` \| .*\| .*\|$", page.split("## Parameters of the other")[0], re.MULTILINE)
    ) == sorted(known)
