"""The sounds that a program has sent: kept, so that a show that has them no more gets them again."""

from __future__ import annotations

import io
import re
import ssl
from collections.abc import Iterable, Mapping
from pathlib import Path

import aiohttp
import msgspec

from omote.inputs.voices.spoken_text import VOICES_PATH, SpokenAnswer, WantedSpeech
from omote.show.declaration import ClientMessage
from omote.show.objects.speech import MOST_BYTES, MOST_SOUNDS, SOUNDS_PATH, Say
from omote.show.speech.known_sounds import NO_SOUND

_FILE = re.compile(r"[/\\]|\.(wav|mp3|og[ga]|opus)$", re.IGNORECASE)


class SentSound(msgspec.Struct, frozen=True):
    """What a show answers to a sound."""

    sound: str


def read_bytes(sound: object) -> bytes:
    """The bytes of a sound, or of its file; TypeError for something else, OSError where the file cannot be read."""
    if isinstance(sound, Path):
        return sound.read_bytes()
    if isinstance(sound, str):
        raise TypeError(f"the sound is the text {sound[:80]!r}; for a file give its Path, pathlib.Path({sound[:80]!r})")
    if not isinstance(sound, bytes | bytearray | memoryview):
        raise TypeError(f"the sound is a {type(sound).__name__}; give the bytes of a file, or its Path")
    return bytes(sound)


def split_sound(sound: object) -> tuple[str, bytes | None]:
    """The key of a sound that was sent or the name of one, or the bytes of one that is to be sent first; "" and None
    for none.

    ValueError for a text that is the path of a file, TypeError and OSError as `read_bytes`.
    """
    if sound is None:
        return "", None
    if not isinstance(sound, str):
        return "", read_bytes(sound)
    if _FILE.search(sound):
        raise ValueError(
            f"sound is {sound[:80]!r}, which is neither a key of send_sound nor the name of a sound; for a file give "
            f"pathlib.Path({sound[:80]!r})"
        )
    return sound, None


async def upload_sound(
    show: str,
    data: bytes,
    *,
    headers: Mapping[str, str],
    trusted: ssl.SSLContext | bool,
    timeout: float,
    name: str | None = None,
    replace: bool = False,
) -> str:
    """The key of a sound that is sent to a show at an address, within some seconds.

    ValueError with the show's reason where it is none, ConnectionError where the show does not answer. show: its
    address; data: of the sound; headers: of the request; trusted: the certificates; timeout: seconds; name: under which
    the show file keeps it, None: it does not; replace: in the place of the one of that name.
    """
    limit = aiohttp.ClientTimeout(timeout)
    query = {} if name is None else {"name": name, "replace": str(int(replace))}
    try:
        async with (
            aiohttp.ClientSession(headers=headers, timeout=limit) as session,
            session.post(f"{show}{SOUNDS_PATH}", params=query, data=io.BytesIO(data), ssl=trusted) as response,
        ):
            if response.status >= 500:
                raise ConnectionError(f"the show at {show} took no sound: {await response.text()}")
            if response.status != 200:
                raise ValueError(await response.text())
            return msgspec.json.decode(await response.read(), type=SentSound).sound
    except TimeoutError as error:
        raise ConnectionError(
            f"the show at {show} took no sound of {len(data)} bytes in {timeout:g} s; connect with a longer timeout="
        ) from error
    except aiohttp.ClientError as error:
        raise ConnectionError(f"the show at {show} took no sound: {error}") from error


async def speak_text(
    show: str, wanted: WantedSpeech, *, headers: Mapping[str, str], trusted: ssl.SSLContext | bool, timeout: float
) -> tuple[SpokenAnswer, bytes]:
    """What a voice of a show at an address makes of a text, within some seconds: what to say, and its sound.

    ValueError with the show's reason where it cannot be spoken, ConnectionError where the show does not answer. show:
    its address; wanted: the text; headers: of the request; trusted: the certificates; timeout: seconds.
    """
    try:
        async with aiohttp.ClientSession(headers=headers, timeout=aiohttp.ClientTimeout(timeout)) as session:
            body = msgspec.json.encode(wanted)
            async with session.post(f"{show}{VOICES_PATH}", data=body, ssl=trusted) as response:
                if response.status != 200:
                    raise ValueError(await response.text())
                answer = msgspec.json.decode(await response.read(), type=SpokenAnswer)
            async with session.get(f"{show}{SOUNDS_PATH}/{answer.sound}", ssl=trusted) as response:
                return answer, await response.read()
    except TimeoutError as error:
        raise ConnectionError(
            f"the show at {show} spoke no text in {timeout:g} s; connect with a longer timeout="
        ) from error
    except aiohttp.ClientError as error:
        raise ConnectionError(f"the show at {show} spoke no text: {error}") from error


class SentSounds:
    """The newest sounds by key, as many as a show keeps."""

    def __init__(self) -> None:
        self._sounds: dict[str, bytes] = {}

    def keep(self, key: str, data: bytes) -> None:
        """Keeps a sound as the newest, in the place of the oldest where there is no room. key: its key; data: its
        bytes."""
        self._sounds.pop(key, None)
        self._sounds[key] = data
        while len(self._sounds) > MOST_SOUNDS or sum(map(len, self._sounds.values())) > MOST_BYTES:
            del self._sounds[next(iter(self._sounds))]

    def find(self, keys: Iterable[str]) -> list[bytes]:
        """Those of these keys that are kept, each once."""
        return [self._sounds[key] for key in dict.fromkeys(keys) if key in self._sounds]

    def missing(self, message: ClientMessage, reason: str) -> bytes | None:
        """The sound to send again where a show rejected a speech (message) because it has its sound no more, else None.
        reason: that of the show."""
        if not isinstance(message, Say) or not reason.startswith(NO_SOUND):
            return None
        return self._sounds.get(message.sound)
