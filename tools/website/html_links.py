"""What an HTML page loads by itself, without anybody following a link."""

from __future__ import annotations

from html.parser import HTMLParser

SOURCES = {"script": "src", "img": "src", "iframe": "src", "source": "src", "video": "src", "audio": "src"}
FOLLOWED = frozenset({"canonical", "next", "prev", "alternate", "edit"})
"""Relations of a link element that no browser fetches."""


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Takes what a browser fetches for this element."""
        given = dict(attrs)
        url = given.get(SOURCES.get(tag, ""))
        if tag == "link" and not FOLLOWED & set((given.get("rel") or "").split()):
            url = given.get("href")
        if url:
            self.found.append(url)


def resources(html: str) -> list[str]:
    """The addresses that a browser fetches to show a page."""
    reader = _Reader()
    reader.feed(html)
    return reader.found
