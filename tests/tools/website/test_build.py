"""The site is built from docs/ and from pages made of the code, and loads nothing from elsewhere."""

from __future__ import annotations

from pathlib import Path

from tools.website.build import loaded_from_hosts, stage
from tools.website.pages import GENERATED, ROOT, examples_page


def test_a_stage_holds_the_written_and_the_made_pages_and_nothing_old(tmp_path: Path) -> None:
    folder = tmp_path / "staged"
    folder.mkdir()
    (folder / "old.md").write_text("gone")
    stage(folder)
    written = {page.relative_to(ROOT / "docs").as_posix() for page in (ROOT / "docs").rglob("*.md")}
    assert {page.relative_to(folder).as_posix() for page in folder.rglob("*.md")} == written | GENERATED.keys()
    assert not written & GENERATED.keys()


def test_the_page_of_examples_has_each_script_whole() -> None:
    page = examples_page()
    scripts = sorted((ROOT / "examples").glob("*.py"))
    assert all(f"## {script.stem}\n\n```py\n{script.read_text()}```" in page for script in scripts)


def test_what_a_page_loads_from_other_hosts_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text('<script src="https://cdn.example/x.js"></script><img src="mine.png">')
    assert loaded_from_hosts(page) == ["https://cdn.example/x.js"]
