"""A program's link to a show: one message at a time, each confirmed; the newest state; linked again when it breaks."""

from __future__ import annotations

import asyncio
import contextlib
import ssl
from collections.abc import Callable
from uuid import uuid4

import aiohttp
import msgspec
from msgspec import structs

from omote.client.message_check import encode_checked, pack_numbers
from omote.client.show_address import DENIALS, NO_ANSWER, explain_https_error
from omote.client.sounds import SentSounds, speak_text, upload_sound
from omote.client.utterance import SpeechWatch, SpeechWatches
from omote.inputs.voices.spoken_text import WantedSpeech
from omote.show.declaration import ClientMessage
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.leases import Leases
from omote.show.objects.link import Bus, Hello, Ping, Pong, Refused, Welcome
from omote.show.objects.sources import Drive, Source, SourceIs
from omote.show.objects.speech import Say
from omote.show.objects.state import State
from omote.show.wire import decode_answer, encode

FIRST_PAUSE = 0.05
LONGEST_PAUSE = 1.0
"""Seconds between two attempts to link again: each twice the one before."""
HEARTBEAT = 10.0
GOODBYE_SECONDS = 0.25
"""How long the goodbye of https takes, for which no closing of aiohttp waits."""


class ProgramLink:
    """A console's link without a page; to be used in one event loop.

    The server answers a program's messages in their order, so a ping behind each one tells when it was obeyed; a
    rejection comes before its pong.
    """

    def __init__(
        self,
        address: str,
        name: str,
        timeout: float,
        token: str = "",
        trusted: ssl.SSLContext | None = None,
        bus: Bus = "air",
    ) -> None:
        self.state: State | None = None
        self.leases = Leases(on=False, held={}, seats=[], you=0)
        self._address = address
        self._name = name
        self._timeout = timeout
        self._show = address.removesuffix(LINK_PATH)
        self._headers = {"Authorization": f"Bearer {token}"} if token else {}
        self._trusted = True if trusted is None else trusted
        self._ends = aiohttp.ClientWSTimeout(ws_close=min(timeout, 10.0))
        self._page = uuid4().hex
        self._bus = bus
        self._calls = self._pings = 0
        self._turn = asyncio.Lock()
        self._news = asyncio.Condition()
        self._socket: aiohttp.ClientWebSocketResponse | None = None
        self._answer: asyncio.Future[str | None] | None = None
        self._reason = "nothing answers there"
        self._refused: str | None = None
        self._reader: asyncio.Task[None] | None = None
        self._called = name
        self._opened: dict[str, Source] = {}
        self._indices: dict[str, int] = {}
        self._sounds = SentSounds()
        self._said = SpeechWatches()
        self._epoch: int | None = None
        self._again: asyncio.Task[None] | None = None

    async def open(self) -> None:
        """Links; ConnectionError with the reason where no show answers in time."""
        self._reader = asyncio.create_task(self._keep_linked())
        try:
            await self._wait(lambda: self._refused is not None or self._is_welcome(), "no show")
            if self._refused is not None:
                raise ConnectionError(f"the show at {self._show} takes no program in: {self._refused}")
        except BaseException:
            await self.close()
            raise

    async def close(self) -> None:
        """Ends the link; what is on air stays."""
        if self._reader is not None:
            for task in filter(None, (self._reader, self._again)):
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await task
            if self._address.startswith("https:"):
                await asyncio.sleep(GOODBYE_SECONDS)
        self._reader = None

    def next_id(self) -> str:
        """A name for a message that is to be obeyed once."""
        self._calls += 1
        return f"{self._page}-{self._calls}"

    async def send(self, message: ClientMessage) -> None:
        """Sends a message and waits until the show has obeyed it; one with an id until the newest state knows of it.

        ValueError with the show's reason where it was rejected, and where it is longer than a show reads;
        ConnectionError where the link does not come back in time, or no answer: then it may have been obeyed or not.
        """
        data = encode_checked(message)
        try:
            async with asyncio.timeout(self._timeout):
                try:
                    await self._send_confirmed(data)
                except ValueError as error:  # a show that was started again has no sounds
                    sound = self._sounds.missing(message, str(error))
                    if sound is None:
                        raise
                    await self.send_sound(sound)
                    await self._send_confirmed(data)
                if getattr(message, "id", ""):
                    await self.wait_for_state(-1 if self.state is None else self.state.number)
        except TimeoutError:
            raise self._explain_silence("no answer of the show") from None

    async def _send_confirmed(self, data: bytes) -> None:
        async with self._turn:
            while True:
                await self._wait(lambda: self._socket is not None, "lost the show")
                try:
                    reason = await self._confirm(data)
                    break
                except ConnectionError:
                    self._socket = None  # it takes nothing more; the reader may not have seen that yet
        if reason is not None:
            raise ValueError(reason)

    async def drive(self, source: Source, frame: Drive) -> None:
        """Sends a frame of a source, which opens first where this link has not opened it as it is now; errors as of
        `send`. Consoles know the source by the name of this program and its own."""
        while True:
            opened = self._opened
            if opened.get(source.name) != source:
                await self.send(structs.replace(source, name=f"{self._called} {source.name}"[:80]))
                opened[source.name] = source
            index = self._indices[f"{self._called} {source.name}"[:80]]
            try:
                await self.send(structs.replace(frame, index=index))
            except ValueError:
                if opened is self._opened:
                    raise
                continue  # linked again meanwhile: there it has not been opened yet
            return

    async def send_sound(self, data: bytes) -> str:
        """Sends a sound and returns its key; errors as of `upload_sound`."""
        headers = self._headers
        trusted = self._trusted
        key = await upload_sound(self._show, data, headers=headers, trusted=trusted, timeout=self._timeout)
        self._sounds.keep(key, data)
        return key

    async def add_sound(self, name: str, data: bytes, *, replace: bool) -> str:
        """Adds a sound (data) to the show file under a name, and returns its key; errors as of `upload_sound`. replace:
        in the place of the one of that name."""
        return await upload_sound(
            self._show,
            data,
            headers=self._headers,
            trusted=self._trusted,
            timeout=self._timeout,
            name=name,
            replace=replace,
        )

    async def speak(self, message: Say, sound: bytes | WantedSpeech | None = None) -> SpeechWatch:
        """Says something, with a sound that is sent first where there is one, or that a voice of the show speaks first;
        errors as of `send` and `send_sound`. message: the speech."""
        if isinstance(sound, WantedSpeech):
            message = await self._give_voice(message, sound)
        elif sound is not None:
            message = structs.replace(message, sound=await self.send_sound(sound))
        await self.send(message)
        assert self.state is not None  # a link is open once it has one
        return self._said.add(message, self.state)

    async def _give_voice(self, message: Say, wanted: WantedSpeech) -> Say:
        """A speech with the sound and the times of a voice of the show."""
        headers = self._headers
        spoken, data = await speak_text(
            self._show, wanted, headers=headers, trusted=self._trusted, timeout=self._timeout
        )
        self._sounds.keep(spoken.sound, data)
        times = pack_numbers(spoken.times, "a time (seconds)")
        return structs.replace(
            message, timing="visemes", marks=spoken.marks, times=times, seconds=spoken.seconds, sound=spoken.sound
        )

    async def wait_until_spoken(self, watch: SpeechWatch, timeout: float | None) -> bool:
        """Whether a speech was said to its end, once it is over; TimeoutError after `timeout` seconds, ConnectionError
        where the show does not come back. watch: what `speak` gave."""
        try:
            async with asyncio.timeout(timeout):
                while (spoken := watch.spoken) is None:
                    await self.wait_for_state(-1 if self.state is None else self.state.number)
                return spoken
        except TimeoutError:
            raise TimeoutError(f"after {timeout:g} s it is still said, or waits; stop_speaking() ends it") from None

    async def wait_for_state(self, number: int) -> State:
        """The first state after that of `number`."""
        await self._wait(lambda: self.state is not None and self.state.number != number, "no news of the show")
        assert self.state is not None
        return self.state

    async def _confirm(self, data: bytes) -> str | None:
        """Sends a message with a ping behind it; the reason of its rejection, None where it was obeyed."""
        if self._reader is None:
            raise ConnectionError("the connection is closed; open another one")
        socket = self._socket
        if socket is None:
            raise ConnectionError("the link is broken")
        self._pings = self._pings + 1
        self._refused = None
        answer: asyncio.Future[str | None] = asyncio.get_running_loop().create_future()
        self._answer = answer
        await socket.send_bytes(data)
        await socket.send_bytes(encode(Ping(float(self._pings))))
        return await answer

    async def _wait(self, ready: Callable[[], bool], what: str) -> None:
        if self._reader is None:
            raise ConnectionError("the connection is closed; open another one")
        try:
            async with asyncio.timeout(self._timeout), self._news:
                await self._news.wait_for(ready)
        except TimeoutError:
            raise self._explain_silence(what) from None  # whose traceback is asyncio's own

    def _explain_silence(self, what: str) -> ConnectionError:
        """What is not there within the time that this link waits."""
        reason = "it does not answer" if self._socket is not None else self._reason
        return ConnectionError(f"{what} at {self._show} for {self._timeout:g} s: {reason}; start it with omote show")

    async def _keep_linked(self) -> None:
        pause = FIRST_PAUSE
        async with aiohttp.ClientSession() as session:
            while True:
                try:
                    opened = session.ws_connect(
                        self._address, heartbeat=HEARTBEAT, headers=self._headers, ssl=self._trusted, timeout=self._ends
                    )
                    async with opened as socket:
                        await self._greet(socket)
                        async for message in socket:
                            await self._hear(socket, message)
                            pause = FIRST_PAUSE
                    self._hear_end(socket.close_code)
                except aiohttp.WSServerHandshakeError as error:
                    await self._hear_denial(error.status)
                except aiohttp.ClientSSLError as error:
                    await self._hear_refusal(explain_https_error(error, self._show))
                except aiohttp.ServerDisconnectedError:
                    self._reason = NO_ANSWER if self._address.startswith("http:") else "it ends the connection"
                except (aiohttp.ClientError, OSError, msgspec.DecodeError) as error:
                    self._reason = str(error)[:200]
                finally:
                    self._break()
                await asyncio.sleep(pause)
                pause = min(2.0 * pause, LONGEST_PAUSE)

    def _hear_end(self, code: int | None) -> None:
        """A message that is too long for this show would be so again: its sender is told."""
        self._reason = "the link was closed"
        if code == aiohttp.WSCloseCode.MESSAGE_TOO_BIG and self._answer is not None and not self._answer.done():
            self._answer.set_result(self._refused or "the message is longer than this show reads")

    async def _hear_denial(self, status: int) -> None:
        """Another try would be answered as this one: whoever waits for the show is told."""
        self._reason = DENIALS.get(status, f"it answers with status {status}")
        if status in DENIALS:
            await self._hear_refusal(DENIALS[status])

    async def _hear_refusal(self, reason: str) -> None:
        self._reason = self._refused = reason
        async with self._news:
            self._news.notify_all()

    async def _greet(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        hello = Hello("console", PROTOCOL_VERSION, self._name, self._page, bus=self._bus)
        await socket.send_bytes(encode(hello))

    async def _hear(self, socket: aiohttp.ClientWebSocketResponse, message: aiohttp.WSMessage) -> None:
        if message.type is not aiohttp.WSMsgType.BINARY:
            return
        match decode_answer(message.data):
            case Welcome() as welcome:
                self._hear_welcome(socket, welcome)
            case SourceIs(index=index, name=name):
                self._indices[name] = index
            case State() as state if state.bus == self._bus and self._is_newer(state):
                self.state = state
                self._said.note(state)
            case Leases() as leases:
                self.leases = leases
            case Refused(reason=reason):
                self._refused = reason
            case Pong(sent=sent):
                self._hear_pong(sent)
            case _:
                return
        async with self._news:
            self._news.notify_all()

    def _hear_welcome(self, socket: aiohttp.ClientWebSocketResponse, welcome: Welcome) -> None:
        self._socket = socket
        self._called = welcome.name
        before = self._epoch
        self._epoch = welcome.epoch
        if before not in (None, self._epoch):
            self._again = asyncio.create_task(self._send_sounds_again())

    async def _send_sounds_again(self) -> None:
        """To a show that was started again: those of what is said and what waits, for stages that have them not yet."""
        with contextlib.suppress(ConnectionError, ValueError):
            for data in self._sounds.find(self._said.sounds()):
                await self.send_sound(data)

    def _hear_pong(self, sent: float) -> None:
        if sent < self._pings:
            self._refused = None  # of a call that has waited long enough
        elif self._answer is not None and not self._answer.done():
            self._answer.set_result(self._refused)

    def _is_welcome(self) -> bool:
        return self._socket is not None and self.state is not None

    def _is_newer(self, state: State) -> bool:
        return self.state is None or (state.epoch, state.number) > (self.state.epoch, self.state.number)

    def _break(self) -> None:
        self._socket = None
        self._opened = {}
        if self._answer is not None and not self._answer.done():
            self._answer.set_exception(ConnectionError("the link broke"))
