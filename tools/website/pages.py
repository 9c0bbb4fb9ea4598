"""The pages of the site that are not in docs/: made from the code each time the site is built."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from tools.website.command_reference import command_page
from tools.website.file_reference import file_page
from tools.website.wire_reference import wire_page

ROOT = Path(__file__).resolve().parent.parent.parent


def examples_page() -> str:
    """The list of examples, and each of them whole."""
    readme = (ROOT / "examples" / "README.md").read_text()
    scripts = sorted((ROOT / "examples").glob("*.py"))
    listed = readme
    for script in scripts:
        listed = listed.replace(f"({script.name})", f"(#{script.stem})")
    whole = [f"## {script.stem}\n\n```py\n{script.read_text()}```\n" for script in scripts]
    return "\n".join([listed, *whole])


def decisions_page() -> str:
    """The list of decisions, newest first."""
    pages = sorted((ROOT / "docs" / "decisions").glob("[0-9]*.md"), reverse=True)
    titles = [page.read_text().splitlines()[0].removeprefix("# ") for page in pages]
    entries = [f"* [{title}]({page.name})" for page, title in zip(pages, titles, strict=True)]
    return "\n".join(
        ["# Decisions", "", "What was decided, when and why; one page each, newest first.", "", *entries, ""]
    )


GENERATED: Mapping[str, Callable[[], str]] = {
    "reference/wire.md": wire_page,
    "reference/show-file.md": file_page,
    "reference/commands.md": command_page,
    "decisions/index.md": decisions_page,
    "examples.md": examples_page,
}
"""What makes each page, by its path in the site."""
