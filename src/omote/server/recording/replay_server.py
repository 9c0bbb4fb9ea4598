"""Serves the pages with a recording in the place of a show: a process of its own, beside a show that plays."""

from __future__ import annotations

import asyncio
import sqlite3
import time
from collections.abc import Callable, Mapping
from contextlib import suppress

import msgspec
from aiohttp import web

from omote.interchange.formats.error_reasons import explain_error
from omote.model.cast import Cast
from omote.server.access.listening import listen
from omote.server.access.security import own_names
from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import CastDocuments, built_in_documents
from omote.server.http.document_routes import NO_CACHE
from omote.server.http.static_pages import REPLAY_PAGES, Page, read_pages
from omote.server.recording.recorded_show import LogLine, RecordedShow, Span
from omote.server.recording.replay_player import ReplayPlayer, TransportRequest
from omote.server.sounds.sound_routes import Sounds
from omote.show.declaration import ClientMessage, Outgoing
from omote.show.messages import STATE_RATE
from omote.show.objects.stages import CastChanged
from omote.show.objects.state import CharacterState, State
from omote.show.session import ShowSession
from omote.show.validation import Refusal
from omote.stage_data.playing_cast import PlayingCast, build_playing_cast

TRANSPORT_PATH = "/replay/transport"
MOMENTS_PATH = "/replay/moments"
ACTS = ("go", "go_back", "go_to_cue", "panic", "begin_show", "mark_moment")
"""What is shown on the line of time: what a stage manager finds a moment by."""
LONGEST_REQUEST = 4096


class ReplaySession(ShowSession):
    """A session whose states are those of a recording; it is only looked at. player: plays the recording."""

    def __init__(self, cast: Cast | PlayingCast, player: ReplayPlayer) -> None:
        super().__init__(cast)
        self._player = player
        self._advanced: float | None = None
        self._jumps = 0

    def _obey(self, who: str, message: ClientMessage, now: float) -> list[Outgoing]:
        if message.access != "view":
            raise Refusal("this is a replay: it is only looked at. Nothing has changed.")
        return super()._obey(who, message, now)

    def tick(self, now: float) -> State:
        """What the recording shows at `now` (seconds, monotonic), under numbers of this session."""
        elapsed = 0.0 if self._advanced is None else now - self._advanced
        self._advanced = now
        self.number += 1
        shown = self._player.advance(elapsed)
        if shown is None:
            return super().tick(now)
        played = self._player.transport()
        is_heard = played.playing and played.rate == 1.0 and played.jumps == self._jumps
        self._jumps = played.jumps  # a state without sounds ends those of before
        epoch = self.epoch + played.jumps
        heard = shown if is_heard else silenced(shown)
        state = msgspec.structs.replace(heard, epoch=epoch, number=self.number, revision=self.revision)
        self._time = state.time
        return state


def silenced(state: State) -> State:
    """A state with nothing to be heard: sounds have one speed, and cannot stand."""
    replace = msgspec.structs.replace

    def silent(character: CharacterState) -> CharacterState:
        said = character.speech
        speech = None if said is None else replace(said, sound="", next_sound="")
        return replace(character, speech=speech, clips=[replace(clip, sound="") for clip in character.clips])

    return replace(state, characters={name: silent(each) for name, each in state.characters.items()})


class ReplayServer:
    """The pages and the transport of a replay. show: the recording; span: what of it is played; documents: of the
    built-in cast; pages: the built files."""

    def __init__(self, show: RecordedShow, span: Span, documents: CastDocuments, pages: Mapping[str, Page]) -> None:
        self._show = show
        self._span = span
        self._documents = documents
        self.player = ReplayPlayer(show, span)
        self._moments: list[dict[str, object]] | None = None
        self.server = ShowServer(ReplaySession(documents.playing, self.player), documents, pages)
        self.server.sounds = Sounds(self.server.session.set_sounds, show.find_sound)
        self.server.more_routes.append(self.add_routes)

    def add_routes(self, application: web.Application) -> None:
        """Adds the addresses of the transport."""
        application.router.add_get(TRANSPORT_PATH, self.tell)
        application.router.add_post(TRANSPORT_PATH, self.ask)
        application.router.add_get(MOMENTS_PATH, self.list_moments)

    async def tell(self, _: web.Request) -> web.Response:
        """Responds with how far it is (JSON)."""
        body = msgspec.json.encode(self.player.transport())
        return web.Response(body=body, content_type="application/json", headers={"Cache-Control": NO_CACHE})

    async def ask(self, request: web.Request) -> web.Response:
        """Plays, pauses, seeks, loops; responds as `tell`, 400 with the reason for what it cannot do."""
        body = await request.content.read(LONGEST_REQUEST)
        try:
            self.player.obey(msgspec.json.decode(body, type=TransportRequest))
        except (ValueError, TypeError) as error:
            raise web.HTTPBadRequest(text=f"{explain_error(error)}. Nothing has changed.") from error
        return await self.tell(request)

    async def list_moments(self, _: web.Request) -> web.Response:
        """Responds with the moments of the recording that people look for (JSON), in seconds from its beginning."""
        if self._moments is None:
            loop = asyncio.get_running_loop()
            try:
                self._moments = await loop.run_in_executor(None, self._read_moments)
            except (sqlite3.Error, ValueError) as error:
                raise web.HTTPServiceUnavailable(text=f"the recording cannot be read: {error}.") from error
        return web.json_response(self._moments, headers={"Cache-Control": NO_CACHE})

    async def tick(self) -> None:
        """Broadcasts the next state; where another cast plays then, its documents first."""
        self.server.tick()
        digest = self.player.digest
        if digest and digest != self._documents.playing.digest:
            await self._play_cast(digest)

    async def _play_cast(self, digest: str) -> None:
        cast = self._show.find_cast(digest)
        self._documents.contents = self._show.contents_of(digest)
        playing = cast if isinstance(cast, PlayingCast) else build_playing_cast(cast, (), {})
        await self._documents.prepare(playing)
        self._documents.play(playing)
        session = self.server.session
        session.cast = playing
        session.revision += 1
        self.server.announce(CastChanged(session.revision, digest))

    def _read_moments(self) -> list[dict[str, object]]:
        lines = [line for line in self._show.log(self._span) if line.what in ACTS]
        return [
            {"at": line.at - self._span.first, "what": line.what, "name": _name_of(line), "who": line.who}
            for line in lines
        ]


def _name_of(line: LogLine) -> str:
    return line.of if line.what in ("mark_moment", "go", "go_to_cue") else ""


def serve(show: RecordedShow, span: Span, port: int, announce: Callable[[str], None]) -> None:
    """Serves a replay until Ctrl-C.

    Parameters
    ----------
    show : RecordedShow
        The recording.
    span : Span
        What of it is played.
    port : int
        To listen on, on this machine alone; 0 for any.
    announce : callable
        Is told the address of the page.

    Raises
    ------
    OSError
        Where the port cannot be had, FileNotFoundError where cast or pages are not there.
    ReplayError
        Where nothing of it can be replayed.
    """
    with suppress(KeyboardInterrupt):
        asyncio.run(_serve(show, span, port, announce))


async def _serve(show: RecordedShow, span: Span, port: int, announce: Callable[[str], None]) -> None:
    documents = built_in_documents()
    replay = ReplayServer(show, span, documents, read_pages(pages=REPLAY_PAGES))
    opened = listen(port)
    runner = web.AppRunner(replay.server.application(own_names()), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    try:
        await web.SockSite(runner, opened).start()
        announce(f"http://localhost:{opened.getsockname()[1]}/replay")
        begun = time.monotonic()
        count = 0
        while True:
            await replay.tick()
            count = max(count + 1, round((time.monotonic() - begun) * STATE_RATE))  # late ticks are left out
            await asyncio.sleep(max(0.0, begun + count / STATE_RATE - time.monotonic()))
    finally:
        await replay.server.close_all()
        await runner.cleanup()
        documents.close()
