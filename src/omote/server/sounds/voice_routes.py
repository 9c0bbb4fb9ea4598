"""The synthetic voices of a show: which there are, and texts that they speak, by a process beside the show."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

import msgspec
from aiohttp import web

from omote.inputs.sounds.sound_file import read_sound
from omote.inputs.voices.spoken_text import VOICES_PATH, SpokenAnswer, SpokenText, Voice, WantedSpeech
from omote.server.sounds.sound_routes import Sounds
from omote.server.workers.file_jobs import ListVoices, SpeakText
from omote.server.workers.job_server import Follow, JobError

MOST_TURNS = 16
"""Texts that wait until another is spoken."""
NO_FILE = "this show has no file, and so no process that speaks; open one with omote show NAME.omote."
RunJob = Callable[[bytes, Follow], Awaitable[bytes]]


class Voices:
    """Speaks texts, one at a time, and keeps their sounds; run_job: gives what does a `FileJob`, None where nothing
    does."""

    def __init__(self, sounds: Sounds, run_job: Callable[[], RunJob | None]) -> None:
        self._sounds = sounds
        self._run_job = run_job
        self._turn = asyncio.Lock()
        self._waiting = 0
        self._voices = list[Voice]()

    def add_routes(self, application: web.Application) -> None:
        """Adds where voices are read, and where one speaks."""
        application.router.add_get(VOICES_PATH, self.respond)
        application.router.add_post(VOICES_PATH, self.speak)

    async def respond(self, _: web.Request) -> web.Response:
        """Responds with the voices (JSON), none where none is installed."""
        if not self._voices and self._run_job() is not None:
            self._voices = msgspec.msgpack.decode(await self._do(ListVoices()), type=list[Voice])
        return web.Response(body=msgspec.json.encode(self._voices), content_type="application/json")

    async def speak(self, request: web.Request) -> web.Response:
        """Speaks the text of the body (JSON, `WantedSpeech`), keeps its sound, and responds with what `say` takes of it
        (JSON, `SpokenAnswer`); 400 with a sentence where it cannot be spoken, 503 where too many wait."""
        try:
            wanted = msgspec.json.decode(await request.read(), type=WantedSpeech)
            spoken = msgspec.msgpack.decode(await self._do(SpeakText(wanted)), type=SpokenText)
            sound = await asyncio.to_thread(read_sound, spoken.sound)
        except (ValueError, msgspec.DecodeError) as error:
            raise web.HTTPBadRequest(text=f"nothing was said: {error}.") from error
        self._sounds.keep(sound)
        answer = SpokenAnswer(sound.key, sound.seconds, spoken.marks, spoken.times)
        return web.Response(body=msgspec.json.encode(answer), content_type="application/json")

    async def _do(self, job: ListVoices | SpeakText) -> bytes:
        """What a job makes, once no other is done; ValueError with its sentence where it fails."""
        run_job = self._run_job()
        if run_job is None:
            raise web.HTTPServiceUnavailable(text=NO_FILE)
        if self._waiting >= MOST_TURNS:
            raise web.HTTPServiceUnavailable(text=f"{MOST_TURNS} texts wait to be spoken; try again in a moment.")
        self._waiting += 1
        try:
            async with self._turn:
                return await run_job(msgspec.msgpack.encode(job), lambda *_: None)
        except JobError as error:
            raise ValueError(str(error).rstrip(".")) from error
        finally:
            self._waiting -= 1
