"""Exports that a page downloads: the commands `omote export` and `omote file export` in a process of their own.

A process beside the show, one at a time and at a lower priority: no tick waits for it, and what it writes is what the
commands write.
"""

from __future__ import annotations

import asyncio
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from aiohttp import web

from omote.server.http.command_process import COMMAND, CommandError, run_command
from omote.stage_data.playing_cast import PlayingCast

GLB, JSON = "model/gltf-binary", "application/json"
KINDS = ("arkit", "performed", "makehuman", "all")


@dataclass(frozen=True)
class Download:
    """What is to be written: the options and the arguments of the command, and the name and type of the file."""

    options: Sequence[str]
    arguments: Sequence[str]
    file: str
    content_type: str


class Downloads:
    """Writes exports of a show file's own work and of the cast, and responds with them; show: where the file lies."""

    def __init__(self, show: Callable[[], Path], command: Sequence[str] = COMMAND) -> None:
        self._show, self._command, self._turn = show, tuple(command), asyncio.Lock()

    async def respond(self, request: web.Request, playing: PlayingCast) -> web.Response:
        """Responds with the file; 404 or 503 with a sentence for the person who asked."""
        try:
            wanted = plan_download(self._show(), request.match_info["file"], request.query, playing)
        except ValueError as error:
            raise web.HTTPNotFound(text=f"{error}.") from error
        async with self._turn:
            data = await self._write(wanted)
        headers = {"Content-Disposition": f'attachment; filename="{wanted.file}"', "Cache-Control": "no-store"}
        return web.Response(body=data, content_type=wanted.content_type, headers=headers)

    async def _write(self, wanted: Download) -> bytes:
        with tempfile.TemporaryDirectory(prefix="omote-") as folder:
            path = Path(folder) / wanted.file
            try:
                await run_command([*wanted.options, "-o", str(path), "--", *wanted.arguments], self._command)
            except CommandError as error:
                raise web.HTTPServiceUnavailable(text=str(error)) from error
            return await asyncio.get_running_loop().run_in_executor(None, path.read_bytes)


def plan_download(show: Path, file: str, query: Mapping[str, str], playing: PlayingCast) -> Download:
    """What a page asks for by the name of a file: `crooked_smile.json`, `my_aunt.glb`, `dog.glb?expressions=smile`.

    ValueError with a message for a name that does not play, or is not saved yet, and for another format.
    """
    name, _, suffix = file.rpartition(".")
    if suffix == "json":
        _check(name, "expression", playing.expression_sources)
        return Download(["file", "export"], [str(show), name], f"{name}.json", JSON)
    if suffix != "glb":
        raise ValueError(f"{file[:80]!r} is no export; there are .json for expressions and .glb for faces")
    _check(name, "face", playing.faces)
    expressions = query.get("expressions", "arkit")
    options = ["export", "--expressions", expressions, "--show", str(show)]
    if expressions not in KINDS:
        for each in expressions.split(","):
            _check(each, "expression", playing.expression_sources)
    whole = name if expressions == "arkit" else f"{name}-{expressions[:60].replace(',', '-')}"
    return Download(options, [name], f"{whole}.glb", GLB)


def _check(name: str, what: str, names: Mapping[str, str]) -> None:
    if name not in names:
        raise ValueError(f"there is no {what} {name[:80]!r} in this show; save it first: only what is saved goes out")
