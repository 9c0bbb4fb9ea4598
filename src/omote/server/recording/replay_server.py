"""Serves the pages with a recording in the place of a show: a process of its own, beside a show that plays."""

from __future__ import annotations

import asyncio
import sqlite3
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path

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
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.server.recording.replay_player import ReplayPlayer, TransportRequest
from omote.server.sounds.sound_routes import Sounds
from omote.show.declaration import ClientMessage, Outgoing
from omote.show.messages import STATE_RATE
from omote.show.objects.stages import CastChanged
from omote.show.objects.state import CharacterState, State
from omote.show.recording.show_log import FOLLOWED, LogLine
from omote.show.session import ShowSession
from omote.show.validation import Refusal
from omote.showfile.database_errors import describe_error
from omote.showfile.recording_file import RecordingFile, open_recording
from omote.showfile.schema import ShowFileError
from omote.stage_data.playing_cast import PlayingCast, build_playing_cast

TRANSPORT_PATH = "/replay/transport"
MOMENTS_PATH = "/replay/moments"
MARKED = "mark_moment"
CALLED = ("go", "go_to_cue", FOLLOWED)
ACTS = (*CALLED, "go_back", "panic", "begin_show")
"""Beside markers, what is shown on the line of time: what a stage manager finds a moment by."""
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
    built-in cast; pages: the built files; files: the recordings that are compared, its own first."""

    def __init__(
        self,
        show: RecordedShow,
        span: Span,
        documents: CastDocuments,
        pages: Mapping[str, Page],
        files: Sequence[Path],
    ) -> None:
        self._show = show
        self._documents = documents
        self.player = ReplayPlayer(show, span)
        self._moments: tuple[Span, list[LogLine]] | None = None
        self.server = ShowServer(ReplaySession(documents.playing, self.player), documents, pages)
        self.server.sounds = Sounds(self.server.session.set_sounds, show.find_sound)
        self.server.more_routes.append(self.add_routes)
        self.server.runs.enable(ReplayedFiles(files), plays=False)

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
        loop = asyncio.get_running_loop()
        try:
            moments = await loop.run_in_executor(None, self._read_moments, self.player.span)
        except (sqlite3.Error, ValueError) as error:
            raise web.HTTPServiceUnavailable(text=f"the recording cannot be read: {error}.") from error
        return web.json_response(moments, headers={"Cache-Control": NO_CACHE})

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

    def _read_moments(self, span: Span) -> list[dict[str, object]]:
        """The moments of a span, of which what was played is read once, and markers each time."""
        if self._moments is None or self._moments[0] != span:
            self._moments = (span, [line for line in self._show.log(span) if line.what in ACTS])
        marks = [LogLine(mark.at, mark.who, MARKED, mark.name) for mark in self._show.markers(span)]
        lines = sorted((*self._moments[1], *marks), key=lambda line: line.at)
        return [
            {"at": line.at - span.first, "what": line.what, "name": _name_of(line), "who": line.who} for line in lines
        ]


class ReplayedFiles:
    """The recordings that a replay's pages look at. paths: where they lie; the first is the one that is marked."""

    def __init__(self, paths: Sequence[Path]) -> None:
        self.paths = paths
        self._writer = ThreadPoolExecutor(max_workers=1, thread_name_prefix="markers")

    def alter(self, work: Callable[[RecordingFile], None], answer: Callable[[str], None]) -> None:
        """Does some work on the first file, which raises ValueError for what cannot be done. answer: told why it was
        refused, "" for done, on another thread."""
        self._writer.submit(self._alter, work, answer)

    def _alter(self, work: Callable[[RecordingFile], None], answer: Callable[[str], None]) -> None:
        try:
            file = open_recording(self.paths[0])
            try:
                work(file)
            finally:
                file.close()
        except (ValueError, OSError, sqlite3.Error, ShowFileError) as error:
            answer(describe_error(error).removesuffix("."))
        else:
            answer("")


def _name_of(line: LogLine) -> str:
    return line.of if line.what in (MARKED, *CALLED) else ""


def serve(show: RecordedShow, span: Span, files: Sequence[Path], port: int, announce: Callable[[str], None]) -> None:
    """Serves a replay until Ctrl-C.

    Parameters
    ----------
    show : RecordedShow
        The recording.
    span : Span
        What of it is played.
    files : sequence of Path
        The recordings that are compared, its own first.
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
        asyncio.run(_serve(show, span, files, port, announce))


async def _serve(
    show: RecordedShow, span: Span, files: Sequence[Path], port: int, announce: Callable[[str], None]
) -> None:
    documents = built_in_documents()
    replay = ReplayServer(show, span, documents, read_pages(pages=REPLAY_PAGES), files)
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
