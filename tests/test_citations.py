"""Citations of the method in comments name a section that exists; links between pages: test_documentation.py."""

import re
from pathlib import Path

ROOT = Path(__file__).parent.parent
FOLDERS = ("src", "web/src", "tools", "benchmarks", "tests", "examples")
CODE = sorted(path for folder in FOLDERS for ending in ("py", "ts") for path in (ROOT / folder).rglob(f"*.{ending}"))
CITATION = re.compile(r"\bdocs/method\.md,\s+(?:[#*/]+\s*)?\"([^\"]+)\"")
OLD = re.compile(r"\bmethod\.md,\s+(?:[#*/]+\s*)?section")


def headings(page: Path) -> list[str]:
    """The headings of a page, code blocks left out."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"^#+ +(.+?) *$", text, re.MULTILINE)


def test_citations_in_comments_name_a_section_that_exists() -> None:
    cited = {name: path for path in CODE for name in CITATION.findall(path.read_text(encoding="utf-8"))}
    assert len(cited) > 10
    there = headings(ROOT / "docs" / "method.md")
    assert {name: path for name, path in cited.items() if " ".join(name.split()) not in there} == {}
    numbered = [path for path in CODE if path != Path(__file__) and OLD.search(path.read_text(encoding="utf-8"))]
    assert numbered == [], "cite a section of docs/method.md by its heading"
