"""Adds authored faces and expressions to the playing cast and removes them again, but never what is on air."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping

from omote.interchange.formats.error_reasons import explain_error
from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments
from omote.show.objects.stages import CastChanged
from omote.show.session import ShowSession
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast

Report = Callable[[str], None]


class CastReload:
    """Replaces the cast of a running session together with its documents."""

    def __init__(self, session: ShowSession, documents: CastDocuments, report: Report) -> None:
        self._session = session
        self._documents = documents
        self._report = report

    async def recast(self, own: tuple[Own, ...], contents: Mapping[str, bytes]) -> CastChanged:
        """Plays these authored items beside the built-in cast; returns the message for every page.

        Items on air that are not among them stay until the next reload. All documents are ready before any page is told
        of them. own: the items; contents: their bytes by key.
        """
        documents = self._documents
        tried = None
        while True:
            wanted = (*own, *self._still_on_air(own))
            playing = await self._gather(wanted, contents)
            await documents.prepare(playing)
            try:
                changed = self._session.recast(playing)
            except ValueError:
                if wanted == tried:
                    raise
                tried = wanted  # something was called meanwhile
                continue
            documents.play(playing)
            return changed

    async def _gather(self, wanted: tuple[Own, ...], contents: Mapping[str, bytes]) -> PlayingCast:
        """Gathers a cast in a thread: unpacking fifty new expressions would hold up the ticks."""
        named = {item.content: contents[item.content] for item in wanted if item.content in contents}
        before = self._documents.playing
        sentences = list[str]()
        playing = await asyncio.get_running_loop().run_in_executor(
            None, lambda: gather_cast(self._documents.cast, wanted, named, sentences.append, before=before)
        )
        for sentence in sentences:
            self._report(sentence)
        return playing

    def _still_on_air(self, own: tuple[Own, ...]) -> list[Own]:
        held = self._session.names_held()
        names = {"face": held.faces, "expression": held.expressions, "pose": held.poses}
        stays = {(item.kind, item.name) for item in own}
        return [
            item
            for item in self._documents.playing.own
            if (item.kind, item.name) not in stays and item.name in names[item.kind]
        ]


def gather_cast(
    base: Cast,
    own: tuple[Own, ...],
    contents: Mapping[str, bytes],
    report: Report,
    *,
    before: PlayingCast | None = None,
) -> PlayingCast:
    """Builds the cast with all authored items that can play; the others are reported to the operator.

    At the start of a show (`before` None) contents are not checked first, so that a restarted server is back soon.
    base: the built-in cast; own: the authored items; contents: their bytes by key; report: tells the operator.
    """
    playing = build_playing_cast(base, (), contents)
    try:
        return build_playing_cast(base, own, contents, before=before, check=before is not None)
    except (ValueError, KeyError):
        for item in own:  # one by one, to leave out as few as possible
            try:
                playing = build_playing_cast(base, (*playing.own, item), contents, before=playing)
            except (ValueError, KeyError) as error:
                report(f"the own {item.kind} {item.label!r} cannot play ({explain_error(error)}); it is left out.")
        return playing
