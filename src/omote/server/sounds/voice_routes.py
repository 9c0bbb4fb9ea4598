"""The synthetic voices of a show: which there are, and texts that they speak, by a process beside the show."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

import msgspec
import numpy as np
from aiohttp import web

from omote.inputs.sounds.sound_file import read_sound
from omote.inputs.voices.spoken_text import VOICES_PATH, SpokenAnswer, SpokenText, Voice, WantedSpeech
from omote.server.sounds.sound_routes import Sounds
from omote.server.workers.file_jobs import ListVoices, SpeakText
from omote.server.workers.job_server import Follow, JobError
from omote.show.objects.link import Refused
from omote.show.objects.speech import Say
from omote.show.session import ShowSession
from omote.show.speech.texts_to_speak import TextToSpeak

MOST_TURNS = 16
"""Texts that wait until another is spoken."""
NOTHING_SAID = "nothing was said"
"""How a reason begins."""
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
        self._saying = set[asyncio.Task[None]]()
        self._listing: asyncio.Task[bytes] | None = None

    def add_routes(self, application: web.Application) -> None:
        """Adds where voices are read, and where one speaks."""
        application.router.add_get(VOICES_PATH, self.respond)
        application.router.add_post(VOICES_PATH, self.speak)

    async def respond(self, _: web.Request) -> web.Response:
        """Responds with the voices that there are now (JSON), none where none is installed."""
        voices = list[Voice]()
        if self._run_job() is not None:
            if self._listing is None or self._listing.done():  # who asks meanwhile gets the same answer
                self._listing = asyncio.create_task(self._do(ListVoices()))
            voices = msgspec.msgpack.decode(await asyncio.shield(self._listing), type=list[Voice])
        return web.Response(body=msgspec.json.encode(voices), content_type="application/json")

    async def speak(self, request: web.Request) -> web.Response:
        """Speaks the text of the body (JSON, `WantedSpeech`), keeps its sound, and responds with what `say` takes of it
        (JSON, `SpokenAnswer`); 400 with a sentence where it cannot be spoken, 503 where too many wait."""
        try:
            answer = await self._speak(msgspec.json.decode(await request.read(), type=WantedSpeech))
        except (ValueError, msgspec.DecodeError) as error:
            raise web.HTTPBadRequest(text=f"{NOTHING_SAID}: {error}.") from error
        return web.Response(body=msgspec.json.encode(answer), content_type="application/json")

    def begin(self, session: ShowSession, clock: Callable[[], float]) -> None:
        """Begins to speak what characters are to say by a voice; each text is said once it is spoken, where it is still
        wanted. session: of the show; clock: seconds, monotonic."""
        for text in session.texts.take():
            task = asyncio.create_task(self._say(session, text, clock))
            self._saying.add(task)
            task.add_done_callback(self._saying.discard)

    async def _say(self, session: ShowSession, text: TextToSpeak, clock: Callable[[], float]) -> None:
        asked = text.message
        try:
            spoken = await self._speak(WantedSpeech(asked.text, asked.voice))
        except (ValueError, web.HTTPException) as error:
            reason = error.text if isinstance(error, web.HTTPException) else f"{NOTHING_SAID}: {error}."
            session.texts.finish(text, reason or NOTHING_SAID)
            return
        if not session.texts.finish(text) or text.who not in session.crew:
            return
        times = np.asarray(spoken.times, "<f4").tobytes()
        call = f"{asked.id} spoken"[:64]
        said = Say(
            asked.character,
            call,
            asked.text,
            "visemes",
            spoken.marks,
            times,
            seconds=spoken.seconds,
            sound=spoken.sound,
        )
        for answer in session.receive(text.who, said, clock()):
            if isinstance(answer.message, Refused):
                session.texts.refuse(text, answer.message.reason)

    async def _speak(self, wanted: WantedSpeech) -> SpokenAnswer:
        """What `say` takes of a text that is spoken, whose sound is kept; ValueError where it cannot be."""
        spoken = msgspec.msgpack.decode(await self._do(SpeakText(wanted)), type=SpokenText)
        sound = await asyncio.to_thread(read_sound, spoken.sound)
        self._sounds.keep(sound)
        return SpokenAnswer(sound.key, sound.seconds, spoken.marks, spoken.times)

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
