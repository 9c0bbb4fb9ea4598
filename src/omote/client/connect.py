"""Connects a program to a running show, blocking or under asyncio."""

from __future__ import annotations

import asyncio
import ssl
from collections.abc import Awaitable, Coroutine
from contextlib import suppress
from pathlib import Path
from threading import Thread
from types import TracebackType
from typing import Any, NamedTuple, TypeVar, get_args

from omote.client.program_link import ProgramLink
from omote.client.remote_show import RemoteShow
from omote.client.show_address import check_token, link_address
from omote.client.sounds import read_bytes
from omote.client.trust import trusted_context
from omote.client.utterance import AsyncUtterance, SpeechWatch, Utterance
from omote.inputs.voices.spoken_text import WantedSpeech
from omote.perform.limits import check_known, check_within
from omote.show.objects.leases import Leases
from omote.show.objects.link import Bus
from omote.show.objects.speech import Say
from omote.show.objects.state import State

LONGEST_NAME = 24
"""Characters."""
DEFAULT_TIMEOUT = 10.0
"""Seconds that a program waits for a show."""

Result = TypeVar("Result")


class _Wanted(NamedTuple):
    """What a link is made with."""

    address: str
    name: str
    timeout: float
    token: str
    trusted: ssl.SSLContext | None
    bus: Bus


class ConnectedShow(RemoteShow[None, Utterance]):
    """A show whose calls return when it has obeyed; a thread of its own keeps the link. `with` closes it."""

    def __init__(self, wanted: _Wanted) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = Thread(target=self._loop.run_forever, name="omote.connect", daemon=True)
        self._thread.start()
        self._link = self._run(_make(wanted))
        link = self._link
        super().__init__(
            lambda message: self._run(link.send(message)),
            lambda: _newest(link),
            link.next_id,
            lambda source, frame: self._run(link.drive(source, frame)),
            lambda message, sound: Utterance(self._run(link.speak(message, sound)), self._wait_until_spoken),
        )
        try:
            self._run(self._link.open())
        except BaseException:
            self.close()
            raise

    def wait(self) -> State:
        """The next state after the newest: the show sends sixty a second. ConnectionError where none comes."""
        return self._run(self._link.wait_for_state(self.state.number))

    def send_sound(self, sound: bytes | Path) -> str:
        """Sends a sound (WAV, MP3 or Ogg, to 16 MiB), or a file of one, and returns the key for `say(sound=...)`;
        ValueError where it is none."""
        return self._run(self._link.send_sound(read_bytes(sound)))

    def add_sound(self, name: str, sound: bytes | Path, *, replace: bool = False) -> str:
        """Adds a sound (as of `send_sound`) to the show file under a name, by which `say(sound=...)`, clips and cues
        find it, after a restart too; returns its key. `replace`: it takes the place of the one of that name. ValueError
        where it is none, or the show has no room."""
        return self._run(self._link.add_sound(name, read_bytes(sound), replace=replace))

    @property
    def leases(self) -> Leases:
        """Who holds what, as the show told last."""
        return self._link.leases

    def close(self) -> None:
        """Ends the connection; what is on air stays. Again: nothing happens."""
        if self._loop.is_closed():
            return
        with suppress(AttributeError):  # the link could not be made
            self._run(self._link.close())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    def __enter__(self) -> ConnectedShow:
        """The show itself."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Ends the connection."""
        self.close()

    def _wait_until_spoken(self, watch: SpeechWatch, timeout: float | None) -> bool:
        return self._run(self._link.wait_until_spoken(watch, timeout))

    def _run(self, work: Coroutine[Any, Any, Result]) -> Result:
        if self._loop.is_closed():
            work.close()
            raise ConnectionError("the connection is closed; open another one with omote.connect")
        waiting = asyncio.run_coroutine_threadsafe(work, self._loop)
        try:
            return waiting.result()
        except BaseException:
            waiting.cancel()  # Ctrl-C
            raise


class AsyncConnectedShow(RemoteShow[Awaitable[None], Awaitable[AsyncUtterance]]):
    """A show whose calls are awaited; `async with` closes it."""

    def __init__(self, link: ProgramLink) -> None:
        super().__init__(link.send, lambda: _newest(link), link.next_id, link.drive, self._speak)
        self._link = link

    async def _speak(self, message: Say, sound: bytes | WantedSpeech | None) -> AsyncUtterance:
        return AsyncUtterance(await self._link.speak(message, sound), self._link.wait_until_spoken)

    async def wait(self) -> State:
        """The next state after the newest: the show sends sixty a second. ConnectionError where none comes."""
        return await self._link.wait_for_state(self.state.number)

    async def send_sound(self, sound: bytes | Path) -> str:
        """Sends a sound (WAV, MP3 or Ogg, to 16 MiB), or a file of one, and returns the key for `say(sound=...)`;
        ValueError where it is none."""
        return await self._link.send_sound(read_bytes(sound))

    async def add_sound(self, name: str, sound: bytes | Path, *, replace: bool = False) -> str:
        """Adds a sound (as of `send_sound`) to the show file under a name, by which `say(sound=...)`, clips and cues
        find it, after a restart too; returns its key. `replace`: it takes the place of the one of that name. ValueError
        where it is none, or the show has no room."""
        return await self._link.add_sound(name, read_bytes(sound), replace=replace)

    @property
    def leases(self) -> Leases:
        """Who holds what, as the show told last."""
        return self._link.leases

    async def close(self) -> None:
        """Ends the connection; what is on air stays."""
        await self._link.close()

    async def __aenter__(self) -> AsyncConnectedShow:
        """The show itself."""
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None
    ) -> None:
        """Ends the connection."""
        await self.close()


def connect(
    url: str,
    *,
    name: str = "program",
    timeout: float = DEFAULT_TIMEOUT,
    token: str | None = None,
    authority: str | Path | None = None,
    bus: Bus = "air",
) -> ConnectedShow:
    """Connects this program to a running show, which it then plays with the calls of a performer.

    `show["one"].call_face("old", seconds=2)` returns when the show has obeyed; `show["one"].frame` is what is on air,
    sixty times a second anew. The link comes back by itself when the show is started again.

    Parameters
    ----------
    url : str
        The address that `omote show` prints.
    name : str
        What the consoles call this program where it moves something, 1 to 24 letters.
    timeout : float
        Seconds that it waits for the show, now and where the link breaks, 0.1 to 3600.
    token : str, optional
        The token of a show that asks for one; the one in the address without it.
    authority : str or Path, optional
        A certificate (.pem) to trust over https: that which the show's `/certificate` gives. On the machine of the show
        it is known.
    bus : {"air", "preview"}
        What it looks at and plays: what is on air, or the preview, which `take` brings on air.

    Returns
    -------
    ConnectedShow
        The show; its `close()` ends the connection, as does the end of a `with` block.

    Raises
    ------
    ConnectionError
        Where no show answers, one of another version, or one that does not take the token.
    OSError
        Where the certificate cannot be read.
    ValueError
        On an address, a name or a time that cannot be.
    TypeError
        On what is no text or no number.

    Examples
    --------
    >>> with omote.connect("http://127.0.0.1:1", timeout=0.1) as show:  # doctest: +ELLIPSIS
    ...     show["one"].call_face("old", seconds=2)
    ...     show["one"].frame.face_call.target
    Traceback (most recent call last):
    ConnectionError: no show at http://127.0.0.1:1 for 0.1 s: ...

    References
    ----------
    docs/architecture.md, "The way of the data".
    """
    return ConnectedShow(_checked(url, name, timeout, token, authority, bus))


async def connect_async(
    url: str,
    *,
    name: str = "program",
    timeout: float = DEFAULT_TIMEOUT,
    token: str | None = None,
    authority: str | Path | None = None,
    bus: Bus = "air",
) -> AsyncConnectedShow:
    """Connects this program to a running show under asyncio: as `connect`, and every call is awaited.

    Parameters
    ----------
    url : str
        The address that `omote show` prints.
    name : str
        What the consoles call this program where it moves something, 1 to 24 letters.
    timeout : float
        Seconds that it waits for the show, now and where the link breaks, 0.1 to 3600.
    token : str, optional
        The token of a show that asks for one; the one in the address without it.
    authority : str or Path, optional
        A certificate (.pem) to trust over https: that which the show's `/certificate` gives. On the machine of the show
        it is known.
    bus : {"air", "preview"}
        What it looks at and plays: what is on air, or the preview, which `take` brings on air.

    Returns
    -------
    AsyncConnectedShow
        The show; `await show.close()` ends the connection, as does the end of an `async with` block.

    Raises
    ------
    ConnectionError
        Where no show answers, one of another version, or one that does not take the token.
    OSError
        Where the certificate cannot be read.
    ValueError
        On an address, a name or a time that cannot be.
    TypeError
        On what is no text or no number.

    Examples
    --------
    >>> import asyncio
    >>> async def play():
    ...     async with await omote.connect_async("http://127.0.0.1:1", timeout=0.1) as show:
    ...         await show["one"].call_face("old", seconds=2)
    >>> asyncio.run(play())  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ConnectionError: no show at http://127.0.0.1:1 for 0.1 s: ...

    References
    ----------
    docs/architecture.md, "The way of the data".
    """
    link = await _make(_checked(url, name, timeout, token, authority, bus))
    await link.open()
    return AsyncConnectedShow(link)


def _checked(url: str, name: str, timeout: float, token: str | None, authority: str | Path | None, bus: Bus) -> _Wanted:
    address = link_address(url)
    trusted = trusted_context(authority) if address.startswith("https:") else None
    check_known(bus, get_args(Bus), "bus")
    return _Wanted(address, _checked_name(name), _checked_timeout(timeout), check_token(token, url), trusted, bus)


async def _make(wanted: _Wanted) -> ProgramLink:
    """A link made in the loop that it lives in."""
    return ProgramLink(*wanted)


def _newest(link: ProgramLink) -> State:
    assert link.state is not None  # a link is open once it has one
    return link.state


def _checked_name(name: str) -> str:
    if not isinstance(name, str):
        raise TypeError(f"the name of a program is a {type(name).__name__}; give text of 1 to {LONGEST_NAME} letters")
    if not 1 <= len(name.strip()) <= LONGEST_NAME:
        raise ValueError(f"the program is called {name[:80]!r}; give 1 to {LONGEST_NAME} letters")
    return name.strip()


def _checked_timeout(timeout: float) -> float:
    return check_within(timeout, 0.1, 3600.0, "the time to wait for a show (seconds)")
