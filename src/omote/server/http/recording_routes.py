"""The recording of a playing show: what its session did goes to the disk, and what is asked of it is carried out."""

from __future__ import annotations

import asyncio
import zlib
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Protocol

import msgspec

from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.run_routes import Alter, RunRoutes
from omote.server.http.uploads import RunFileJob
from omote.server.workers.recorded_clip_job import CutRecordedClip
from omote.show.declaration import KeepRequest, Outgoing
from omote.show.objects.clips import StoredClip, clip_of
from omote.show.objects.documents import read_document
from omote.show.objects.link import Refused
from omote.show.objects.recordings import (
    DeleteRecording,
    KeepClip,
    KeepRecording,
    RecordingKept,
)
from omote.show.recording.entries import AnyEntry
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.stage_data.playing_cast import PlayingCast

Deliver = Callable[[list[Outgoing]], None]


class Recording(Protocol):
    """Keeps what a show does (`recording/recording_thread.py`)."""

    def note(self, entries: Sequence[AnyEntry], state: bytes = b"") -> None:
        """Queues what happened up to a tick (entries); returns at once. state: as it was sent, for curves."""

    def note_cast(self, cast: Cast | PlayingCast, contents: Mapping[str, bytes]) -> None:
        """Queues a cast that is played. contents: of own items, by key."""

    def keep(self, name: str, seconds: float, now: float, answer: Callable[[str], None]) -> None:
        """Keeps the last seconds under a name. now: seconds, monotonic; answer: told why it was refused, "" for done,
        on another thread."""

    path: Path

    def flush(self, answer: Callable[[str], None]) -> None:
        """Writes what was queued so far. answer: as of `keep`."""

    def delete(self, name: str, answer: Callable[[str], None]) -> None:
        """Keeps a recording no longer. name: of it; answer: as of `keep`."""

    def alter(self, work: Alter, answer: Callable[[str], None]) -> None:
        """Does some work on the file. answer: as of `keep`."""

    @property
    def paths(self) -> tuple[Path]:
        """Where the recording lies."""


class RecordingRoutes:
    """Records a session, once it is enabled. documents: of the cast that it plays; clock: seconds, monotonic; deliver:
    answers; runs: what pages read of it."""

    def __init__(
        self,
        session: ShowSession,
        documents: CastDocuments,
        clock: Callable[[], float],
        deliver: Deliver,
        runs: RunRoutes,
    ) -> None:
        self._session = session
        self._documents = documents
        self._clock = clock
        self._deliver = deliver
        self._runs = runs
        self._recording: Recording | None = None
        self._recorder: Recorder | None = None
        self._run_job: RunFileJob | None = None
        self._cutting: set[asyncio.Task[None]] = set()
        self._cast: Cast | PlayingCast | None = None

    def enable(self, recording: Recording, run_job: RunFileJob | None = None) -> None:
        """Records what the session does from now on. recording: keeps it; run_job: does a `CutRecordedClip`, None where
        nothing does."""
        self._runs.enable(recording, plays=True)
        self._recording = recording
        self._run_job = run_job
        self._recorder = Recorder(self._session)

    def record(self, data: bytes) -> None:
        """Hands over what happened up to a tick, and what is asked of the recording. data: the state as it is sent."""
        if self._recording is None or self._recorder is None:
            return
        playing = self._documents.playing
        if playing is not self._cast and playing.digest == self._session.cast.digest:
            self._cast = playing
            self._recording.note_cast(playing, self._documents.contents)
        self._recording.note(self._recorder.take(zlib.crc32(data)), data)
        for request in self._session.take_recording_requests():
            self._ask(self._recording, request)

    def _ask(self, recording: Recording, request: KeepRequest) -> None:
        message = request.message
        if isinstance(message, KeepRecording):
            answer = self._answering(request.who, message)
            recording.keep(message.name, 60.0 * message.minutes, self._clock(), answer)
        elif isinstance(message, DeleteRecording):
            recording.delete(message.name, self._answering(request.who, message))
        elif isinstance(message, KeepClip):
            task = asyncio.ensure_future(self._keep_clip(recording, request.who, message, self._clock()))
            self._cutting.add(task)  # which nobody else holds
            task.add_done_callback(self._cutting.discard)

    async def _keep_clip(self, recording: Recording, who: str, message: KeepClip, now: float) -> None:
        """Has a clip cut in another process, and takes it in. who: the client; now: where it ends, seconds."""
        try:
            if self._run_job is None:
                raise ValueError("no process of this show can cut clips")
            await self._flushed(recording)
            job = CutRecordedClip(str(recording.path), message.character, now - message.seconds, now)
            stored = await self._run_job(msgspec.msgpack.encode(job), lambda *_: None)
            loop = asyncio.get_running_loop()
            clip = await loop.run_in_executor(None, lambda: clip_of(read_document(StoredClip, stored)))
            curve = clip.lanes[0].curve
            told = self._session.clips.add_pass(message.name, curve, message.parts, message.lane)
        except (ValueError, OSError, RuntimeError) as error:
            self._answering(who, message)(str(error).removesuffix("."))
        else:
            self._deliver(told)
            self._answering(who, message)("")

    async def _flushed(self, recording: Recording) -> None:
        """Returns when what has happened so far can be read; ValueError where it cannot be written."""
        loop = asyncio.get_running_loop()
        written: asyncio.Future[str] = loop.create_future()

        def answer(refusal: str) -> None:
            loop.call_soon_threadsafe(written.set_result, refusal)

        recording.flush(answer)
        if refusal := await written:
            raise ValueError(refusal)

    def _answering(self, who: str, message: KeepRecording | DeleteRecording | KeepClip) -> Callable[[str], None]:
        """What tells a client (who), from any thread, what became of its message."""
        loop = asyncio.get_running_loop()

        def answer(refusal: str) -> None:
            done = RecordingKept(message.id, message.name)
            reply = Refused(f"{refusal}. Nothing was changed.", message.id) if refusal else done
            with suppress(RuntimeError):  # a loop that has ended sends nothing any more
                loop.call_soon_threadsafe(self._deliver, [Outgoing(who, reply)])

        return answer
