"""The pages of docs/ that are made from the code: `python -m tools.website.pages` writes them, git ignores them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from tools.website.action_unit_reference import action_unit_page, action_unit_table
from tools.website.binding_reference import binding_page
from tools.website.command_reference import command_page
from tools.website.file_reference import file_page
from tools.website.osc_reference import osc_page
from tools.website.python_reference import connected_page, python_page
from tools.website.tracker_reference import tracker_page
from tools.website.wire_reference import wire_page

ROOT = Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"


def examples_page() -> str:
    """The list of examples, and a place for each of them, where the site shows the script itself (snippets)."""
    readme = (ROOT / "examples" / "README.md").read_text()
    scripts = sorted((ROOT / "examples").glob("*.py"))
    listed = readme
    for script in scripts:
        listed = listed.replace(f"({script.name})", f"(#{script.stem})")
    listed += "\nThe site shows them below; in the repository they lie in `examples/`.\n"
    places = [f'## {script.stem}\n\n```py\n--8<-- "{script.name}"\n```\n' for script in scripts]
    return "\n".join([listed, *places])


GENERATED: Mapping[str, Callable[[], str]] = {
    "reference/python.md": python_page,
    "reference/connected.md": connected_page,
    "reference/wire.md": wire_page,
    "reference/osc.md": osc_page,
    "reference/bindings.md": binding_page,
    "reference/trackers.md": tracker_page,
    "reference/show-file.md": file_page,
    "reference/commands.md": command_page,
    "reference/action-units.md": action_unit_page,
    "reference/action-units.csv": action_unit_table,
    "examples.md": examples_page,
}
"""What makes each page, by its path in docs/."""


def main() -> None:
    """Writes the pages that are not what the code makes now."""
    for path, make in GENERATED.items():
        page = DOCS / path
        text = make()
        if not page.exists() or page.read_text(encoding="utf-8") != text:
            page.write_text(text, encoding="utf-8")
            print(f"docs/{path}")


if __name__ == "__main__":
    main()
