"""The site is built from docs/, and loads nothing from elsewhere."""

from __future__ import annotations

from pathlib import Path

from tools.website.build import loaded_from_hosts
from tools.website.pages import ROOT, examples_page


def test_the_page_of_examples_has_each_script_whole() -> None:
    page = examples_page()
    scripts = sorted((ROOT / "examples").glob("*.py"))
    assert all(f"## {script.stem}\n\n```py\n{script.read_text()}```" in page for script in scripts)


def test_what_a_page_loads_from_other_hosts_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text('<script src="https://cdn.example/x.js"></script><img src="mine.png">')
    assert loaded_from_hosts(page) == ["https://cdn.example/x.js"]
