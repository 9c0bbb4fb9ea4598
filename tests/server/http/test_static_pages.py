"""The pages are all there, or the server says how to make them."""

import re
from pathlib import Path

import pytest

from omote.server.http.static_pages import PAGES, read_pages


def built(folder: Path) -> Path:
    """A bundle as vite writes it."""
    (folder / "static").mkdir(parents=True)
    for name in PAGES.values():
        (folder / name).write_text(f"<title>{name}</title>")
    (folder / "static" / "stage-a1b2.js").write_text("export {}")
    (folder / "static" / "font.woff2").write_bytes(b"wOF2")
    (folder / "favicon.svg").write_text("<svg/>")
    return folder


def test_every_file_has_its_address(tmp_path: Path) -> None:
    pages = read_pages(built(tmp_path))
    assert pages["/stage"] == pages["/stage.html"]
    assert pages["/stage"].body == b"<title>stage.html</title>"
    assert set(pages) >= {"/", "/stage", "/console", "/editor", "/static/stage-a1b2.js", "/favicon.svg"}


@pytest.mark.parametrize(
    ("path", "content_type", "immutable"),
    [
        ("/console", "text/html", False),
        ("/static/stage-a1b2.js", "text/javascript", True),
        ("/static/font.woff2", "font/woff2", True),
        ("/favicon.svg", "image/svg+xml", False),
    ],
)
def test_files_are_sent_as_what_they_are(tmp_path: Path, path: str, content_type: str, immutable: bool) -> None:
    page = read_pages(built(tmp_path))[path]
    assert (page.content_type, page.immutable) == (content_type, immutable)


@pytest.mark.parametrize("name", PAGES.values())
def test_a_missing_page_says_how_to_build_it(tmp_path: Path, name: str) -> None:
    (built(tmp_path) / name).unlink()
    with pytest.raises(FileNotFoundError, match=rf"not built \({name} missing in .*: run `make web`"):
        read_pages(tmp_path)


def test_no_bundle_at_all_says_the_same(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=re.escape(", ".join(PAGES.values()))):
        read_pages(tmp_path / "nowhere")
