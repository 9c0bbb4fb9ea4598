"""Imports that a page uploads: `omote file import` into a copy of the show file, in a process beside the show; what it
brought into the copy is then saved in the show.

So a file is read by the one command that reads files of strangers, in its sandbox, and the show loses nothing by one
that is no face and no expression.
"""

from __future__ import annotations

import asyncio
import contextlib
import sqlite3
import tempfile
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path

from aiohttp import web

from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.glb_reader import LARGEST
from omote.server.http.command_process import COMMAND, CommandError, run_command
from omote.showfile.authored_rows import read_all, read_content
from omote.showfile.changes import BroughtItem
from omote.showfile.integrity import open_read_only

SUFFIXES = (".json", ".glb", ".obj")
KINDS = ("expression", "face")
CHUNK = 2**18

TakeIn = Callable[[Sequence[BroughtItem]], Awaitable[str]]
"""Saves items in the show; returns why not, "" once they are stored and play."""


class Uploads:
    """Takes in the files that pages send, one at a time; show: where the show file lies."""

    def __init__(self, show: Callable[[], Path], command: Sequence[str] = COMMAND) -> None:
        self._show, self._command, self._turn = show, tuple(command), asyncio.Lock()

    async def respond(self, request: web.Request, take_in: TakeIn) -> web.Response:
        """Responds with what was taken in and what the command said of it (JSON); 400 or 503 with a sentence."""
        try:
            name, kind = plan_upload(request.match_info["file"], request.query.get("as", KINDS[0]))
            async with self._turn:
                with tempfile.TemporaryDirectory(prefix="omote-") as folder:
                    await _receive(request, Path(folder) / name)
                    brought, said = await self._import(Path(folder) / name, kind)
        except (ValueError, CommandError) as error:
            raise web.HTTPBadRequest(text=str(error)) from error
        except (OSError, sqlite3.Error) as error:
            raise web.HTTPServiceUnavailable(text=f"nothing was taken in ({explain_error(error)}).") from error
        trouble = await take_in(brought)
        if trouble:
            raise web.HTTPServiceUnavailable(text=trouble)
        return web.json_response({"labels": [each.item.label for each in brought], "said": said[: len(brought)]})

    async def _import(self, path: Path, kind: str) -> tuple[list[BroughtItem], list[str]]:
        copy, run = path.with_name("show.omote"), asyncio.get_running_loop().run_in_executor
        before = await run(None, _copy, self._show(), copy)
        said = await run_command(["file", "import", "--as", kind, "--", str(copy), str(path)], self._command)
        return await run(None, _read_new, copy, before), said


def plan_upload(file: str, kind: str) -> tuple[str, str]:
    """The name under which a file is read, and what it is; ValueError for what nothing can be made of."""
    name = "".join(each for each in Path(file).name if each.isprintable())[-80:].lstrip("-.")
    if kind not in KINDS:
        raise ValueError(f"a file is taken in as {' or '.join(KINDS)}, not as {kind[:80]!r}.")
    suffix = Path(name).suffix.lower()
    if suffix not in SUFFIXES or (kind == "face" and suffix == ".json"):
        expected = (
            "a head (.glb, .obj)" if kind == "face" else "an expression (.json), or a head with shapes (.glb, .obj)"
        )
        raise ValueError(f"{file[:80]!r} is no {kind} that can be read; expected {expected}. Nothing has changed.")
    return name, kind


async def _receive(request: web.Request, path: Path) -> None:
    """Writes what a page sends into a file; ValueError where it is too large."""
    size = 0
    with path.open("wb") as file:
        async for chunk in request.content.iter_chunked(CHUNK):
            size += len(chunk)
            if size > LARGEST:
                raise ValueError(f"{path.name} has more than {LARGEST} bytes, which no face has; export a smaller one.")
            file.write(chunk)


def _copy(show: Path, copy: Path) -> int:
    """Copies a show file as it is now, others may write it meanwhile; returns the highest id of its items."""
    with contextlib.closing(open_read_only(show)) as source, contextlib.closing(sqlite3.connect(copy)) as target:
        source.backup(target)
        return int(target.execute("SELECT coalesce(max(id), 0) FROM item").fetchone()[0])


def _read_new(copy: Path, before: int) -> list[BroughtItem]:
    """The items that are in a copy beyond those before."""
    with contextlib.closing(open_read_only(copy)) as connection:
        stored = read_all(connection)
        items = {item.id: item for item in stored.items if item.id > before}
        revisions = [revision for revision in stored.revisions if revision.item in items]
        return [
            BroughtItem(items[revision.item], revision, read_content(connection, revision.content))
            for revision in sorted(revisions, key=lambda each: each.item)
        ]
