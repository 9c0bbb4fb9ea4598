"""Draws a clip as pictures at exact times, and makes a film with alpha of them, through ffmpeg where it is there."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec

from omote.interchange.formats.atomic_file import write_whole
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip
from omote.perform.frame import Frame
from omote.perform.limits import check_known
from omote.perform.performer import Performer
from omote.server.headless.picture_renderer import Renderer

FILMS = {
    ".mov": ("-c:v", "prores_ks", "-profile:v", "4444", "-pix_fmt", "yuva444p10le", "-alpha_bits", "16"),
    ".webm": ("-c:v", "libvpx-vp9", "-pix_fmt", "yuva420p", "-lossless", "1"),
}
"""What ffmpeg is told, by the ending of the film. Both keep alpha within 1 of 255. VP9 with losses (crf 20) is off by
64 at edges for a seventh of the bytes. ffmpeg's own decoder of VP9 gives no alpha: read it with `-c:v libvpx-vp9`."""
FILM_SOUNDS = {".mov": ("-c:a", "pcm_s16le"), ".webm": ("-c:a", "libopus", "-b:a", "160k")}
"""What ffmpeg is told of sounds: without losses as the pictures are, where the container has that."""
SIDECAR = "frames.json"
MOST_FRAMES = 20_000


class ClipPictures(msgspec.Struct, frozen=True):
    """What lies beside the pictures: the clip, who wears it, the digest of the cast, the frames of a second, and the
    time (s) of each picture from the clip's start, by its file."""

    clip: str
    face: str
    cast: str
    rate: float
    seconds: float
    frames: dict[str, float]


@dataclass(frozen=True)
class FilmSound:
    """What is heard in a film. data: the bytes of the sound; at: when it begins, seconds of the film, below 0: so long
    before it."""

    data: bytes
    at: float


def play_frames(cast: Cast, clip: Clip, *, face: str, rate: float) -> Iterator[tuple[float, Frame]]:
    """The frames of a face that wears a clip, each with its time: whole, without fades.

    cast: with the face; clip: which is not begun again at its end; face: by name; rate: frames of a second.
    """
    performer = Performer(cast)
    performer.call_face(check_known(face, cast.faces, "face"), seconds=0.0)
    whole = replace(clip, blend_out=0.0, loop=False)
    for number in range(count_frames(clip, rate)):
        now = number / rate
        performer.stop_clip(seconds=0.0)  # each begins at its own time, so that no sum of steps is off
        performer.advance(0.0)
        performer.play_clip(whole, seconds=0.0, start=now * clip.speed)
        yield now, performer.advance(0.0)


def count_frames(clip: Clip, rate: float) -> int:
    """How many frames a clip has before its end; ValueError for too many. rate: of a second."""
    count = math.ceil(clip.seconds / clip.speed * rate - 1e-6)
    if count > MOST_FRAMES:
        raise ValueError(f"the clip has {count} frames at {rate:g} a second; expected at most {MOST_FRAMES}")
    return count


def draw_clip(
    cast: Cast,
    clip: Clip,
    folder: Path,
    *,
    name: str,
    face: str,
    rate: float,
    size: tuple[int, int],
    quality: str,
    tell: Callable[[int, int], None],
) -> ClipPictures:
    """Draws a clip into a folder, a PNG with alpha for each frame, and `frames.json` with their times beside them.

    cast: with the face; folder: made where it is not there; name: of the clip; face: that wears it; rate: frames of a
    second; size: width and height, pixels; quality: of the stage; tell: how many are drawn, of how many.
    """
    folder.mkdir(parents=True, exist_ok=True)
    count = count_frames(clip, rate)
    times = dict[str, float]()
    with Renderer(cast, size=size, transparent=True, quality=quality) as draw:
        for number, (time, frame) in enumerate(play_frames(cast, clip, face=face, rate=rate)):
            file = f"{number:05}.png"
            draw(frame, path=folder / file)
            times[file] = time
            tell(number + 1, count)
    drawn = ClipPictures(name, face, cast.digest, rate, clip.seconds / clip.speed, times)
    write_whole(folder / SIDECAR, msgspec.json.format(msgspec.json.encode(drawn), indent=2))
    return drawn


def find_ffmpeg() -> str:
    """The path of ffmpeg; FileNotFoundError that says what to do where it is not there."""
    path = shutil.which("ffmpeg")
    if path is None:
        raise FileNotFoundError("films are made by ffmpeg, which is not installed; install it, or name a folder")
    return path


def film_command(
    ffmpeg: str, folder: Path, film: Path, rate: float, sound: Sequence[str] = (), heard: Sequence[str] = ()
) -> list[str]:
    """The command that makes a film of a folder of pictures. ffmpeg: its path; film: what is written; rate: frames of a
    second; sound, heard: what it is told of a sound that comes in, and of what is written of it (`sound_options`)."""
    begin = [ffmpeg, "-y", "-v", "error", "-framerate", f"{rate:.9g}", "-i", str(folder / "%05d.png")]
    return [*begin, *sound, *FILMS[film.suffix.lower()], *heard, str(film)]


def sound_options(sound: FilmSound, file: Path, kind: str, seconds: float) -> tuple[list[str], list[str]]:
    """What ffmpeg is told of a sound: before its file, and of what is written, as long as the film.

    file: with its bytes; kind: the ending of the film; seconds: how long the film is.
    """
    skipped = ["-ss", f"{-sound.at:.6f}"] if sound.at < 0.0 else []
    later = f"adelay={round(1000.0 * max(0.0, sound.at))}:all=1,apad"
    return [*skipped, "-i", str(file)], ["-af", later, "-t", f"{seconds:.6f}", *FILM_SOUNDS[kind]]


def film_clip(film: Path, draw: Callable[[Path], ClipPictures], sound: FilmSound | None = None) -> ClipPictures:
    """Makes a film of a clip, with the sidecar of its frames beside it (`NAME.frames.json`).

    film: what is written; draw: draws the pictures into a folder; sound: what is heard. RuntimeError
    with what ffmpeg says where it fails.
    """
    ffmpeg = find_ffmpeg()
    with TemporaryDirectory(dir=film.parent) as made:
        drawn = draw(Path(made))
        kind = film.suffix.lower()
        whole = Path(made) / f"film{kind}"
        options: tuple[list[str], list[str]] = ([], [])
        if sound is not None:
            (Path(made) / "sound").write_bytes(sound.data)
            options = sound_options(sound, Path(made) / "sound", kind, len(drawn.frames) / drawn.rate)
        command = film_command(ffmpeg, Path(made), whole, drawn.rate, *options)
        done = subprocess.run(command, capture_output=True, check=False)
        if done.returncode:
            raise RuntimeError(f"ffmpeg could not write {film}: {done.stderr.decode(errors='replace')[-300:].strip()}")
        film.with_name(f"{film.stem}.{SIDECAR}").write_bytes((Path(made) / SIDECAR).read_bytes())
        whole.replace(film)
    return drawn
