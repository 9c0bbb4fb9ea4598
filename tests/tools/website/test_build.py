"""The site is built from docs/, and loads nothing from elsewhere."""

from __future__ import annotations

import re
from pathlib import Path

from tools.website.build import loaded_from_hosts
from tools.website.pages import ROOT, examples_page


def test_the_page_of_examples_includes_each_script_when_the_site_is_built() -> None:
    included = re.findall(r'^## (\w+)\n\n```py\n--8<-- "(\w+)\.py"\n```$', examples_page(), re.MULTILINE)
    scripts = sorted(script.stem for script in (ROOT / "examples").glob("*.py"))
    assert included == [(name, name) for name in scripts]
    snippets = (ROOT / "mkdocs.yml").read_text().partition("pymdownx.snippets:")[2]
    assert "base_path: [examples]\n      check_paths: true" in snippets, "a script that is not there fails the build"


def test_what_a_page_loads_from_other_hosts_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text('<script src="https://cdn.example/x.js"></script><img src="mine.png">')
    assert loaded_from_hosts(page) == ["https://cdn.example/x.js"]
