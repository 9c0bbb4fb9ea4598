"""Sounds that programs send: validated by what their bytes are, with their length; browsers decode them."""

from __future__ import annotations

import hashlib
import struct
from typing import Literal, NamedTuple

SoundType = Literal["audio/wav", "audio/mpeg", "audio/ogg"]
LARGEST_SOUND = 2**24
"""Bytes."""
LONGEST_SOUND = 600.0
"""Seconds."""
SHORTEST_SOUND = 0.01
STREAMED = 0x7F000000
"""Bytes that a WAV says it has, from which on its writer did not know: ffmpeg and espeak-ng write so into a pipe."""
_OGG_HEADER = 27
_OPUS_RATE = 48000
_BITRATES = {
    (3, 3): (32, 64, 96, 128, 160, 192, 224, 256, 288, 320, 352, 384, 416, 448),
    (3, 2): (32, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 384),
    (3, 1): (32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320),
    (2, 3): (32, 48, 56, 64, 80, 96, 112, 128, 144, 160, 176, 192, 224, 256),
    (2, 2): (8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160),
    (2, 1): (8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160),
}
"""kbit/s by version (3: MPEG 1, 2: MPEG 2 and 2.5) and layer (3: I, 2: II, 1: III)."""
_RATES = {3: (44100, 48000, 32000), 2: (22050, 24000, 16000), 0: (11025, 12000, 8000)}


class SoundFile(NamedTuple):
    """A sound: its bytes, their key (a hash of them), what it is, and its length in seconds."""

    data: bytes
    key: str
    type: SoundType
    seconds: float


def read_sound(data: bytes) -> SoundFile:
    """What some bytes are that a program has sent.

    Parameters
    ----------
    data : bytes
        A whole file: WAV (PCM or float), MP3, or Ogg with Vorbis or Opus.

    Returns
    -------
    SoundFile
        With its length.

    Raises
    ------
    ValueError
        Where they are no such sound, too large (16 MiB), too long (600 s) or hold nothing.
    """
    if len(data) > LARGEST_SOUND:
        raise ValueError(f"the sound has more than {LARGEST_SOUND} bytes; send it in parts, or as MP3 or Ogg")
    media_type, seconds = _type_and_seconds(data)
    if not SHORTEST_SOUND <= seconds <= LONGEST_SOUND:
        raise ValueError(f"the sound lasts {seconds:.3g} s; send one of {SHORTEST_SOUND:g} to {LONGEST_SOUND:g} s")
    return SoundFile(data, hashlib.sha256(data).hexdigest()[:32], media_type, seconds)


def _type_and_seconds(data: bytes) -> tuple[SoundType, float]:
    try:
        if data[:4] == b"RIFF" and data[8:12] == b"WAVE":
            return "audio/wav", _wav_seconds(data)
        if data[:4] == b"OggS":
            return "audio/ogg", _ogg_seconds(data)
        seconds = _mp3_seconds(data)
    except (struct.error, IndexError) as error:
        raise ValueError("the sound is cut off: send the whole file") from error
    if seconds is None:
        raise ValueError(f"the sound begins with {data[:8]!r}, which is no WAV, MP3 or Ogg; send one of these")
    return "audio/mpeg", seconds


def _wav_seconds(data: bytes) -> float:
    at = 12
    rate = 0
    while at + 8 <= len(data):
        name = data[at : at + 4]
        size = struct.unpack_from("<I", data, at + 4)[0]
        if name == b"fmt ":
            rate = struct.unpack_from("<I", data, at + 16)[0]  # bytes a second
        elif name == b"data":
            if not rate:
                break
            return _seconds_of_wav(size, len(data) - at - 8, rate)
        at += 8 + size + size % 2
    raise ValueError("the WAV has no sound in it: no format or no data; export it again as PCM")


def _seconds_of_wav(declared: int, came: int, rate: int) -> float:
    """The length of the sound in a WAV. declared, came: bytes; rate: bytes a second."""
    if declared < STREAMED and declared - came > SHORTEST_SOUND * rate:
        raise ValueError(
            f"the WAV is cut off: it says that it has {declared} bytes of sound ({declared / rate:.3g} s), "
            f"and {came} came ({came / rate:.3g} s); send the whole file"
        )
    return min(declared, came) / rate


def _ogg_seconds(data: bytes) -> float:
    """By the position that the last page of the stream ends at."""
    begin = _OGG_HEADER + data[26]
    head = data[begin : begin + 48]
    if head[:7] == b"\x01vorbis":
        rate = struct.unpack_from("<I", head, 12)[0]
        skip = 0
    elif head[:8] == b"OpusHead":
        rate = _OPUS_RATE
        skip = struct.unpack_from("<H", head, 10)[0]
    else:
        raise ValueError(f"the Ogg holds {head[:8]!r}; send Vorbis or Opus")
    last = data.rfind(b"OggS")
    position = struct.unpack_from("<q", data, last + 6)[0]
    if not rate or position < 0:
        raise ValueError("the Ogg does not say how long it is: send the whole file")
    return float(max(position - skip, 0) / rate)


def _mp3_seconds(data: bytes) -> float | None:
    """The sum of its frames; None where there is none."""
    at = _after_tag(data)
    seconds = 0.0
    frames = 0
    while at + 4 <= len(data):
        size, length = _mp3_frame(data[at : at + 4])
        if not size:
            break
        at = at + size
        seconds = seconds + length
        frames = frames + 1
    return seconds if frames > 1 else None


def _after_tag(data: bytes) -> int:
    """Where an ID3 tag ends that many files begin with."""
    if data[:3] != b"ID3":
        return 0
    size = 0
    for byte in data[6:10]:
        size = size << 7 | byte & 127
    return 10 + size


def _mp3_frame(head: bytes) -> tuple[int, float]:
    """The bytes of a frame and its seconds; 0 where this is none."""
    word = int.from_bytes(head, "big")
    version = word >> 19 & 3
    layer = word >> 17 & 3
    bitrate = word >> 12 & 15
    rate = word >> 10 & 3
    if word >> 21 != 0x7FF or version == 1 or layer == 0 or bitrate in (0, 15) or rate == 3:
        return 0, 0.0
    kilobits = _BITRATES[3 if version == 3 else 2, layer][bitrate - 1]
    hertz = _RATES[version][rate]
    samples = 384 if layer == 3 else 576 if layer == 1 and version != 3 else 1152
    padding = (4 if layer == 3 else 1) * (word >> 9 & 1)
    unit = samples // 8 * kilobits * 1000 // hertz
    size = (12 * kilobits * 1000 // hertz) * 4 + padding if layer == 3 else unit + padding
    return size, samples / hertz
