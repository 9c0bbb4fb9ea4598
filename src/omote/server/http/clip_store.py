"""What the show file keeps of clips: read at the start, and written after each edit, packed beside the ticks; and their
outlines for pages, which are drawn there too."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping, Sequence

import msgspec
from aiohttp import web

from omote.perform.clips.clip import Clip
from omote.server.http.document_routes import NO_CACHE
from omote.show.objects.clips import CLIP_OUTLINE_PATH, StoredClip, read_clips, stored_clip
from omote.show.session import ShowSession
from omote.showfile.changes import DocumentRemoval, StoredDocument

Change = StoredDocument | DocumentRemoval


class ClipStore:
    """Keeps the clips of a session."""

    def __init__(self, session: ShowSession) -> None:
        self.session = session
        self._last: asyncio.Future[None] | None = None

    def add_routes(self, application: web.Application) -> None:
        """Adds the address of the outlines."""
        application.router.add_get(CLIP_OUTLINE_PATH, self.respond)

    async def respond(self, request: web.Request) -> web.Response:
        """Responds with what is drawn of a clip (JSON); 204 where there is none."""
        outline = self.session.clips.outline(request.match_info["name"])
        headers = {"Cache-Control": NO_CACHE}
        if outline is None:
            return web.Response(status=204, headers=headers)
        drawn = await asyncio.get_running_loop().run_in_executor(None, outline)
        return web.Response(body=msgspec.json.encode(drawn), content_type="application/json", headers=headers)

    def load(self, documents: Callable[[str], Mapping[str, bytes]], report: Callable[[str], None]) -> None:
        """Plays what the show file keeps. documents: of a kind, by name; report: tells the operator what of it cannot
        be read."""
        clips, lost = read_clips(documents(StoredClip.kind))
        self.session.clips.load(clips)
        for sentence in lost:
            report(sentence)

    def keep(self, commit: Callable[[Sequence[Change]], None]) -> None:
        """Writes what was edited since the last tick, in one commit and in the order of the edits: a minute of motion
        takes sixty milliseconds to pack, which no tick has. commit: writes changes into the show file."""
        changes = self.session.clips.take_changes()
        if changes:
            self._last = asyncio.ensure_future(self._write(self._last, changes, commit))

    async def settled(self) -> None:
        """Returns when all that was edited has been handed over to be written."""
        if self._last is not None:
            await self._last

    async def _write(
        self,
        before: asyncio.Future[None] | None,
        changes: Mapping[str, Clip | None],
        commit: Callable[[Sequence[Change]], None],
    ) -> None:
        packed = await asyncio.get_running_loop().run_in_executor(None, pack_changes, changes)
        if before is not None:
            await before
        commit(packed)


def pack_changes(clips: Mapping[str, Clip | None]) -> list[Change]:
    """What the show file has to keep of clips, by name; None for one that is gone."""
    return [
        DocumentRemoval(StoredClip.kind, name)
        if clip is None
        else StoredDocument(StoredClip.kind, name, stored_clip(clip).encode())
        for name, clip in clips.items()
    ]
