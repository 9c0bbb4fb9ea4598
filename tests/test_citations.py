"""Links between pages, and from comments to the page of the method, lead somewhere."""

import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "src").rglob("*.md")])
FOLDERS = ("src", "web/src", "tools", "benchmarks", "tests", "examples")
CODE = sorted(path for folder in FOLDERS for ending in ("py", "ts") for path in (ROOT / folder).rglob(f"*.{ending}"))
LINK = re.compile(r"\]\((?!\w+:)([^)#\s]*)(?:#([^)\s]+))?\)")
CITATION = re.compile(r"\bdocs/method\.md,\s+(?:[#*/]+\s*)?\"([^\"]+)\"")
OLD = re.compile(r"\bmethod\.md,\s+(?:[#*/]+\s*)?section")


def headings(page: Path) -> list[str]:
    """The headings of a page, code blocks left out."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"^#+ +(.+?) *$", text, re.MULTILINE)


@cache
def anchors(page: Path) -> frozenset[str]:
    """The anchors of a page's headings, as GitHub and Python-Markdown both make them."""
    return frozenset(re.sub(r" ", "-", re.sub(r"[^\w\- ]", "", heading.lower())) for heading in headings(page))


def test_headings_become_anchors(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# One: two `three`\n\n```sh\n# none\n```\n\n### Eq. 3\n")
    assert anchors(page) == {"one-two-three", "eq-3"}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_of_a_page_lead_somewhere(page: Path) -> None:
    for target, anchor in LINK.findall(page.read_text(encoding="utf-8")):
        there = page.parent / target if target else page
        assert there.exists(), f"{target} does not exist"
        assert not anchor or anchor in anchors(there), f"{target}#{anchor} is no heading"


def test_citations_in_comments_name_a_section_that_exists() -> None:
    cited = {name: path for path in CODE for name in CITATION.findall(path.read_text(encoding="utf-8"))}
    assert len(cited) > 10
    there = headings(ROOT / "docs" / "method.md")
    assert {name: path for name, path in cited.items() if " ".join(name.split()) not in there} == {}
    numbered = [path for path in CODE if path != Path(__file__) and OLD.search(path.read_text(encoding="utf-8"))]
    assert numbered == [], "cite a section of docs/method.md by its heading"
