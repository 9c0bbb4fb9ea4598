"""Draws a clip as pictures at exact times, and makes a film with alpha of them, through ffmpeg where it is there."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec

from omote import __version__
from omote.interchange.formats.atomic_file import require_parent, write_whole
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip
from omote.perform.frame import Frame
from omote.perform.limits import check_known
from omote.server.headless.picture_renderer import Renderer
from omote.show.objects.speech import StoredSound
from omote.show.speech.named_sounds import NamedSounds, read_sounds
from omote.showfile.inspection import Inspection
from omote.stage_data.clip_poses import ClipPoses, count_frames
from omote.stage_data.picture_sidecar import hash_picture

FILMS = {
    ".mov": ("-c:v", "prores_ks", "-profile:v", "4444", "-pix_fmt", "yuva444p10le", "-alpha_bits", "16"),
    ".webm": ("-c:v", "libvpx-vp9", "-pix_fmt", "yuva420p", "-lossless", "1"),
}
"""What ffmpeg is told, by the ending of the film. Both keep alpha within 1 of 255. VP9 with losses (crf 20) is off by
64 at edges for a seventh of the bytes. ffmpeg's own decoder of VP9 gives no alpha: read it with `-c:v libvpx-vp9`."""
FILM_SOUNDS = {".mov": ("-c:a", "pcm_s16le"), ".webm": ("-c:a", "libopus", "-b:a", "160k")}
"""What ffmpeg is told of sounds: without losses as the pictures are, where the container has that."""
SIDECAR = "frames.json"


class ClipPictures(msgspec.Struct, frozen=True, kw_only=True):
    """What lies beside the pictures of a clip: what they were made from, and of each, by its file, its time and hash.

    omote: the version; clip, face: by name; motion: the SHA-256 of the clip as the show file has it ("" as `clip`: it
    is none of a show file); cast: the digest of the faces; rate: frames of a second; seconds: of the whole; size:
    pixels; quality: of the stage; frames: seconds from the first; pictures: SHA-256, none until all are drawn; row: of
    a table of stimuli, what was asked for by its headings; film: the SHA-256 of what was made of the pictures.
    """

    omote: str
    clip: str
    motion: str
    face: str
    cast: str
    rate: float
    seconds: float
    size: tuple[int, int]
    quality: str
    frames: dict[str, float]
    pictures: dict[str, str] = msgspec.field(default_factory=dict)
    row: dict[str, str] = msgspec.field(default_factory=dict)
    film: str = ""


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
    faces = {check_known(face, cast.faces, "face"): 1.0}
    poses = ClipPoses(cast, {"": clip})
    for number in range(count_frames(clip, rate)):
        now = number / rate
        yield now, replace(poses.frame("", now * clip.speed), faces=faces)


def draw_clip(
    cast: Cast,
    clip: Clip,
    folder: Path,
    *,
    name: str,
    motion: str,
    face: str,
    rate: float,
    size: tuple[int, int],
    quality: str,
    tell: Callable[[int, int], None],
) -> ClipPictures:
    """Draws a clip into a folder, a PNG with alpha for each frame, and `frames.json` with their times beside them.

    What a run of the same that was stopped has drawn stays. FileExistsError for a folder of anything else.

    cast: with the face; folder: made where it is not there; name: of the clip; motion: SHA-256 of what the show file
    has of it; face: that wears it; rate: frames of a second; size: width and height, pixels; quality: of the stage;
    tell: how many are drawn, of how many, at the beginning and after each.
    """
    count = count_frames(clip, rate)
    wanted = ClipPictures(
        omote=__version__, clip=name, motion=motion, face=face, cast=cast.digest, rate=rate,
        seconds=clip.seconds / clip.speed, size=size, quality=quality,
        frames={f"{number:05}.png": number / rate for number in range(count)},
    )  # fmt: skip
    hashes = begin_pictures(folder, wanted)
    tell(len(hashes), count)
    if len(hashes) < count:
        with Renderer(cast, size=size, transparent=True, quality=quality) as draw:
            for file, (_, frame) in zip(wanted.frames, play_frames(cast, clip, face=face, rate=rate), strict=True):
                if file not in hashes:
                    draw(frame, path=folder / file)
                    hashes[file] = hash_picture((folder / file).read_bytes())
                    tell(len(hashes), count)
    drawn = msgspec.structs.replace(wanted, pictures={file: hashes[file] for file in wanted.frames})
    write_sidecar(folder / SIDECAR, drawn)
    return drawn


def begin_pictures(folder: Path, wanted: ClipPictures) -> dict[str, str]:
    """Begins a folder of pictures with their sidecar, so that a run that is stopped goes on; returns the hashes of
    those that are there, by file.

    FileExistsError where something else is in the folder, FileNotFoundError where it would lie in none. wanted: what
    will be drawn, without hashes.
    """
    require_parent(folder)
    if not folder.is_dir() or not any(folder.iterdir()):
        folder.mkdir(exist_ok=True)
        write_sidecar(folder / SIDECAR, wanted)
        return {}
    try:
        begun = msgspec.json.decode((folder / SIDECAR).read_bytes(), type=ClipPictures)
    except (FileNotFoundError, msgspec.DecodeError, UnicodeDecodeError):
        raise FileExistsError(f"the folder {folder} is not empty; name another, or empty it") from None
    for what in wanted.__struct_fields__:
        there = getattr(begun, what)
        asked = getattr(wanted, what)
        if what not in ("pictures", "film") and there != asked:
            raise FileExistsError(
                f"the folder {folder} has pictures of another request ({what}: {there!s:.40}, not {asked!s:.40}); name "
                "another, or empty it"
            )
    paths = [folder / file for file in wanted.frames]
    hashes = {path.name: hash_picture(path.read_bytes()) for path in paths if path.is_file()}
    return {file: value for file, value in hashes.items() if begun.pictures.get(file, value) == value}


def write_sidecar(path: Path, pictures: ClipPictures) -> None:
    """Writes what lies beside pictures. path: of the sidecar."""
    write_whole(path, msgspec.json.format(msgspec.json.encode(pictures), indent=2))


def find_ffmpeg() -> str:
    """The path of ffmpeg; FileNotFoundError that says what to do where it is not there."""
    path = shutil.which("ffmpeg")
    if path is None:
        raise FileNotFoundError("films are made by ffmpeg, which is not installed; install it, or take the pictures")
    return path


def film_command(
    ffmpeg: str, pictures: Path, film: Path, rate: float, sound: Sequence[str] = (), heard: Sequence[str] = ()
) -> list[str]:
    """The command that makes a film of pictures. ffmpeg: its path; pictures: `folder/%05d.png`; film: what is written;
    rate: frames of a second; sound, heard: what it is told of a sound that comes in, and of what is written of it
    (`sound_options`)."""
    begin = [ffmpeg, "-y", "-v", "error", "-framerate", f"{rate:.9g}", "-i", str(pictures)]
    return [*begin, *sound, *FILMS[film.suffix.lower()], *heard, str(film)]


def sound_options(sound: FilmSound, file: Path, kind: str, seconds: float) -> tuple[list[str], list[str]]:
    """What ffmpeg is told of a sound: before its file, and of what is written, as long as the film.

    file: with its bytes; kind: the ending of the film; seconds: how long the film is.
    """
    skipped = ["-ss", f"{-sound.at:.6f}"] if sound.at < 0.0 else []
    later = f"adelay={round(1000.0 * max(0.0, sound.at))}:all=1,apad"
    return [*skipped, "-i", str(file)], ["-af", later, "-t", f"{seconds:.6f}", *FILM_SOUNDS[kind]]


def film_clip(film: Path, draw: Callable[[Path], ClipPictures], sound: FilmSound | None = None) -> ClipPictures:
    """Makes a film of a clip, with the sidecar of its frames beside it (`NAME.mov.frames.json`).

    film: what is written; draw: draws the pictures into a folder; sound: what is heard; errors as `film_pictures`.
    """
    find_ffmpeg()
    require_parent(film)
    with TemporaryDirectory(dir=film.parent) as made:
        drawn = draw(Path(made))
        made_of = film_pictures(film, Path(made) / "%05d.png", drawn.rate, len(drawn.frames), sound)
    drawn = msgspec.structs.replace(drawn, film=made_of)
    write_sidecar(film.with_name(f"{film.name}.{SIDECAR}"), drawn)
    return drawn


def film_pictures(film: Path, pictures: Path, rate: float, count: int, sound: FilmSound | None = None) -> str:
    """Makes a film of pictures; returns its SHA-256. RuntimeError with what ffmpeg says where it fails.

    film: what is written; pictures: `folder/%05d.png`; rate: frames of a second; count: of the pictures; sound: what is
    heard.
    """
    with TemporaryDirectory(dir=film.parent) as made:
        kind = film.suffix.lower()
        whole = Path(made) / f"film{kind}"
        options: tuple[list[str], list[str]] = ([], [])
        if sound is not None:
            (Path(made) / "sound").write_bytes(sound.data)
            options = sound_options(sound, Path(made) / "sound", kind, count / rate)
        command = film_command(find_ffmpeg(), pictures, whole, rate, *options)
        done = subprocess.run(command, capture_output=True, check=False)
        if done.returncode:
            raise RuntimeError(f"ffmpeg could not write {film}: {done.stderr.decode(errors='replace')[-300:].strip()}")
        whole.replace(film)
    return hash_picture(film.read_bytes())


def find_film_sound(inspection: Inspection, clip: Clip, say: Callable[[str], None]) -> FilmSound | None:
    """What is heard in a film of a clip, None for nothing; where its sound is missing, or has another speed, that is
    said. inspection: of its show file; say: tells the person."""
    if not clip.sound:
        return None
    sounds, _ = read_sounds(inspection.stored.documents.get(StoredSound.kind, {}), inspection.contents)
    named = NamedSounds()
    named.load(sounds)
    key = named.called().get(clip.sound, clip.sound)
    found = next((sound for sound in sounds.values() if sound.sound == key), None)
    if found is None:
        say(f"the show file has no sound {clip.sound}, so the film has none.")
        return None
    if clip.speed != 1.0:
        say(f"the clip plays at the speed {clip.speed:g}, its sound at 1 alone: the film has none.")
        return None
    at = clip.sound_at - clip.start
    return FilmSound(inspection.contents[found.content], at) if -at < found.seconds else None
