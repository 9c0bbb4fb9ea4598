"""Reads the built pages into memory once: no name that a browser sends ever becomes a file path."""

from __future__ import annotations

import mimetypes
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "web"
PAGES = {
    "/": "index.html",
    "/stage": "stage.html",
    "/console": "console.html",
    "/cues": "cues.html",
    "/solo": "solo.html",
    "/notes": "notes.html",
    "/runs": "runs.html",
    "/clips": "clips.html",
    "/devices": "devices.html",
    "/camera": "camera.html",
    "/editor": "editor.html",
    "/microphone": "microphone.html",
}
REPLAY_PAGES = {**PAGES, "/replay": "replay.html"}
"""Those of `omote replay`."""
TYPES = {".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css", ".html": "text/html"}


@dataclass(frozen=True)
class Page:
    """A built file as it is sent."""

    body: bytes
    content_type: str
    immutable: bool


def read_pages(folder: Path = FOLDER, pages: Mapping[str, str] = PAGES) -> dict[str, Page]:
    """Every page by its URL path; FileNotFoundError, with how to build them, when one is missing. folder: where they
    are; pages: their files."""
    missing = [name for name in pages.values() if not (folder / name).is_file()]
    if missing:
        raise FileNotFoundError(f"the pages are not built ({', '.join(missing)} missing in {folder}): run `make web`.")
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    built = {f"/{path.relative_to(folder).as_posix()}": _page(path, folder) for path in files}
    return built | {url: built[f"/{name}"] for url, name in pages.items()}


def _page(path: Path, folder: Path) -> Page:
    content_type = TYPES.get(path.suffix) or mimetypes.guess_type(path.name)[0] or "application/octet-stream"
    hashed = path.relative_to(folder).parts[0] == "static"  # vite puts a hash into these names
    return Page(path.read_bytes(), content_type, immutable=hashed)
