"""The commands `omote clip ...`: the motion clips of a show file, out to other programs and in from recordings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.file_commands import JsonOption, ShowFileArgument, print_rows
from omote.recording_commands import FromOption, ToOption
from omote.take_commands import read_take
from omote.terminal import escape_controls, exit_on_refusal, fail, fail_with, say

if TYPE_CHECKING:
    from omote.interchange.clips.body_motion import AnimatedBody
    from omote.interchange.clips.clip_frames import ClipFrames
    from omote.model.cast import Cast
    from omote.perform.clips.clip import Clip
    from omote.showfile.inspection import Inspection

CSV = ".csv"
GLB = ".glb"
VRMA = ".vrma"
BVH = ".bvh"
MOTIONS = (VRMA, BVH)
"""What holds the motion of a body, by its ending."""
FACE_PARTS = ("brows", "eyes", "mouth", "rest", "gaze")
NO_BODY = "it moves the body too, which is not in this: write .vrma or .bvh"
EACH = 60
"""Frames after which it is said how many are drawn."""
FORMATS = {CSV: b"Timecode", GLB: b"glTF", VRMA: b"glTF", BVH: b"HIERARCHY"}
"""What a clip is written as, with how such a file begins."""
WHILE_IT_RUNS = (
    "While it runs, play the recording into it and record a pass of that (omote play-take, the page /clips)."
)
clip_app = typer.Typer(help="The motion clips of a show file.", no_args_is_help=True)


@clip_app.command("list")
def list_clips(file: ShowFileArgument, json: JsonOption = False) -> None:
    """Lists the clips of a show file."""
    with exit_on_refusal():
        clips = clips_in(inspect(file))
    rows = [
        {"name": name, "seconds": round(clip.seconds, 3), "lanes": len(clip.lanes), "parts": " ".join(clip.parts)}
        for name, clip in sorted(clips.items())
    ]
    print_rows(rows, json=json, none=f"{file} has no clips yet.")


@clip_app.command("export")
def export_clip(
    file: ShowFileArgument,
    name: Annotated[str, typer.Argument(help="The clip (omote clip list).")],
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            help="What to write: .csv (Live Link Face), .glb (a head), .vrma, .bvh (body, or head and eyes).",
        ),
    ],
    face: Annotated[str, typer.Option(help="The face that wears it, with its own body.")] = "generic",
    rate: Annotated[float, typer.Option(help="Frames of a second, 1 to 240; of a CSV 60.")] = 60.0,
    force: Annotated[bool, typer.Option("--force", help="Replaces a file that is there.")] = False,
) -> None:
    """Writes a clip for other programs."""
    from omote.interchange.formats.atomic_file import check_writable, require_free, write_whole
    from omote.perform.limits import check_known

    kind = output.suffix.lower()
    if kind not in FORMATS:
        fail(f"{output.name!r} is no name of a clip for other programs; end it with {', '.join(FORMATS)}.")
    with exit_on_refusal():
        check_writable(output, FORMATS[kind])
        require_free(output, force=force)
        inspection = inspect(file)
        clips = clips_in(inspection)
        clip = clips[check_known(name, clips, "clip")]
        from omote.interchange.clips.clip_frames import sample_clip

        frames = sample_clip(clip, rate=rate)
        data, notes = encode_clip(inspection, clip, frames, name, kind, face)
        write_whole(output, data)
    for note in notes:
        say(escape_controls(f"{name}: {note}."))
    say(escape_controls(f"{output} holds {name}, {len(frames.times)} frames, {clip.seconds / clip.speed:.2f} s."))


@clip_app.command("import")
def import_clip(
    file: ShowFileArgument,
    take: Annotated[
        Path,
        typer.Argument(
            help="A recording: Live Link Face (.csv), packets (.pcap, .pcapng), VMC packets (.json); or the motion of "
            "a body: BVH (.bvh), VRM Animation (.vrma)."
        ),
    ],
    name: Annotated[str, typer.Option(help="What to call the clip; as the file without it.")] = "",
    begin: FromOption = 0.0,
    end: ToOption = None,
    protocol: Annotated[str, typer.Option(help="What packets are, as of omote play-take.")] = "",
) -> None:
    """Takes a recording, or a part of it, into a show file that no show plays, as a clip."""
    made = (
        import_motion(take, begin, end) if take.suffix.lower() in MOTIONS else import_take(take, protocol, begin, end)
    )
    from omote.perform.clips.clip_runs import LONGEST_CLIP_NAME
    from omote.server.persistence.offline_show import open_offline_show
    from omote.show.clips.show_clips import name_new_clip
    from omote.show.objects.clips import StoredClip, stored_clip
    from omote.showfile.changes import StoredDocument

    with exit_on_refusal(), open_offline_show(file, new=True, instead=WHILE_IT_RUNS) as show:
        there = show.stored().documents.get(StoredClip.kind, {})
        called = name_new_clip(name or take.stem[:LONGEST_CLIP_NAME], there)
        clip = made()
        show.apply([StoredDocument(StoredClip.kind, called, stored_clip(clip).encode())])
    say(escape_controls(f"{file} has the clip {called}, {clip.seconds:.2f} s."))


def import_take(take: Path, protocol: str, begin: float, end: float | None) -> Callable[[], Clip]:
    """Reads a recording of a tracker and gives what makes its clip; ends the command where it cannot be read.

    take: its file; protocol: of packets; begin, end: seconds of it.
    """
    read = read_take(take, protocol)

    def make() -> Clip:
        from omote.builtin import load_cast
        from omote.inputs.takes.take_clip import clip_of_take
        from omote.perform.clips.clip_runs import LONGEST_CLIP_NAME

        return clip_of_take(read, load_cast(), lane=take.stem[:LONGEST_CLIP_NAME], start=begin, stop=end)

    return make


def import_motion(file: Path, begin: float, end: float | None) -> Callable[[], Clip]:
    """Reads the motion of a body and gives what makes its clip, saying what is otherwise than in the file; ends the
    command where it cannot be read.

    file: of the motion; begin, end: seconds of it.
    """
    from omote.interchange.clips.motion_files import read_motion

    try:
        motion = read_motion(file.name, file.read_bytes())
    except (OSError, ValueError) as error:
        fail_with(error if isinstance(error, OSError) else ValueError(f"{file}: {error}"))

    def make() -> Clip:
        from omote.builtin import load_cast
        from omote.interchange.clips.motion_clip import clip_of_motion
        from omote.perform.clips.clip_runs import LONGEST_CLIP_NAME

        clip, notes = clip_of_motion(motion, load_cast(), lane=file.stem[:LONGEST_CLIP_NAME], start=begin, stop=end)
        for note in notes:
            say(escape_controls(f"{file.name}: {note}."))
        return clip

    return make


@clip_app.command("render")
def render_clip(
    file: ShowFileArgument,
    name: Annotated[str, typer.Argument(help="The clip (omote clip list).")],
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="A folder for PNG pictures, or a film: .mov (ProRes 4444), .webm (VP9)."),
    ],
    face: Annotated[str, typer.Option(help="The face that wears it.")] = "generic",
    rate: Annotated[float, typer.Option(min=1.0, max=240.0, help="Frames of a second.")] = 60.0,
    size: Annotated[str, typer.Option(help="Width and height, pixels.")] = "640x720",
    quality: Annotated[str, typer.Option(help="Of the stage: lowest, low, medium, good, high.")] = "high",
    force: Annotated[bool, typer.Option("--force", help="Replaces a film that is there.")] = False,
) -> None:
    """Draws a clip with nothing behind the head: a picture for each frame at its exact time, or a film of them.

    Where it was stopped in a folder, the same command goes on.
    """
    import hashlib

    from omote.export_commands import load_full_cast
    from omote.interchange.formats.atomic_file import require_free
    from omote.perform.limits import check_known
    from omote.server.headless.clip_pictures import (
        FILMS,
        ClipPictures,
        draw_clip,
        film_clip,
        find_ffmpeg,
        find_film_sound,
    )
    from omote.show.objects.clips import StoredClip
    from omote.stage_data.full_cast import find_face
    from omote.stage_data.picture_setting import read_size

    kind = output.suffix.lower()
    if kind and kind not in FILMS:
        fail(f"{output.name!r} is no name of a film; end it with {' or '.join(FILMS)}, or name a folder.")
    with exit_on_refusal():
        if kind:
            find_ffmpeg()
        require_free(output, force=force)
        inspection = inspect(file)
        clips = clips_in(inspection)
        clip = clips[check_known(name, clips, "clip")]
        cast = load_full_cast(inspection)
        worn = find_face(cast, inspection.stored, face)
        pixels = read_size(size)
        motion = hashlib.sha256(inspection.stored.documents[StoredClip.kind][name]).hexdigest()

        def draw(folder: Path) -> ClipPictures:
            with telling(goes_on=not kind) as tell:
                return draw_clip(
                    cast, clip, folder, name=name, motion=motion, face=worn, rate=rate, size=pixels, quality=quality,
                    tell=tell,
                )  # fmt: skip

        drawn = film_clip(output, draw, find_film_sound(inspection, clip, say)) if kind else draw(output)
    if kind == ".webm":
        say("ffmpeg's own decoder of VP9 shows no alpha: read it with -c:v libvpx-vp9.")
    say(escape_controls(f"{output} holds {name}, {len(drawn.frames)} frames, {drawn.seconds:.2f} s."))


@contextmanager
def telling(*, goes_on: bool) -> Iterator[Callable[[int, int], None]]:
    """Gives what says how many frames are drawn, of how many: those that were before, and each second of a clip.

    goes_on: whether it is said, where Ctrl-C ends it, that the same command goes on.
    """
    counts = list[tuple[int, int]]()

    def tell(done: int, count: int) -> None:
        if done and not counts:
            say(f"{done} of {count} frames were drawn before, and stay.")
        elif done % EACH == 0 and 0 < done < count:
            say(f"{done} of {count} frames")
        counts.append((done, count))

    try:
        yield tell
    except KeyboardInterrupt:
        if counts and goes_on:
            say(f"{counts[-1][0]} of {counts[-1][1]} frames were drawn; the same command goes on.")
        raise


def inspect(file: Path) -> Inspection:
    """What a show file holds; errors of what cannot be one."""
    from omote.showfile.inspection import inspect_show

    return inspect_show(file)


def clips_in(inspection: Inspection) -> Mapping[str, Clip]:
    """The clips of a show file (inspection); of one that cannot be read a word."""
    from omote.show.objects.clips import StoredClip, read_clips

    clips, lost = read_clips(inspection.stored.documents.get(StoredClip.kind, {}))
    for sentence in lost:
        say(escape_controls(sentence))
    return clips


def encode_clip(
    inspection: Inspection, clip: Clip, frames: ClipFrames, name: str, kind: str, face: str
) -> tuple[bytes, tuple[str, ...]]:
    """A clip as the bytes of a file, and what of it the format cannot say, in sentences.

    inspection: of its show file; clip, frames: what is called `name`; kind: the ending; face: who wears it.
    """
    from omote.export_commands import load_full_cast

    whole = "body" in clip.parts
    if kind == CSV:
        from omote.inputs.takes.live_link_writer import live_link_csv

        text, notes = live_link_csv(frames)
        return text.encode(), (*notes, *([NO_BODY] if whole else []))
    if kind == BVH and not whole:
        from omote.interchange.clips.bvh_writer import bvh_text

        return bvh_text(frames).encode(), ()
    cast = load_full_cast(inspection)
    if kind == GLB:
        notes = (*frames.notes, *([NO_BODY] if whole else []))
        return encode_head(inspection, cast, frames, name, face), notes
    body = body_of(inspection, cast, clip, frames, face) if whole else None
    if kind == BVH:
        from omote.interchange.clips.bvh_writer import humanoid_bvh

        assert body is not None
        notes = ("a BVH has no expressions and no gaze",) if any(part in clip.parts for part in FACE_PARTS) else ()
        return humanoid_bvh(body, frames.rate).encode(), notes
    from omote.interchange.avatar.preset_expressions import custom_expressions
    from omote.interchange.clips.glb_animation import vrm_animation

    customs = {ours: theirs for theirs, ours in custom_expressions(cast, ()).items()}
    return vrm_animation(frames, customs, name=name, body=body), frames.notes


def body_of(inspection: Inspection, cast: Cast, clip: Clip, frames: ClipFrames, face: str) -> AnimatedBody:
    """The body of a clip on the body of a face.

    inspection: of the show file; cast: the full one; clip, frames: with a body; face: of the cast.
    """
    from omote.interchange.avatar.humanoid_pose import rest_humanoid
    from omote.interchange.clips.body_motion import animated_body
    from omote.stage_data.full_cast import find_face

    worn = find_face(cast, inspection.stored, face)
    name = worn if worn in cast.bodies else next(iter(cast.bodies))
    if cast.figures is None:
        raise ValueError("this cast has no bodies, so a clip of one has nobody who wears it")
    rest = rest_humanoid(cast.figures, {name: 1.0}, {name: cast.faces[worn].positions})
    return animated_body(clip, frames, rest)


def encode_head(inspection: Inspection, cast: Cast, frames: ClipFrames, name: str, face: str) -> bytes:
    """A head with a clip as its animation, a GLB.

    inspection: of the show file; cast: the full one; frames: of the clip, which is called `name`; face: that wears it.
    """
    from omote.export_commands import shared_context
    from omote.interchange.clips.glb_animation import animated_head, used_names
    from omote.interchange.export_face import named_compound_meshes
    from omote.perform.channels import GAZE_UNITS
    from omote.stage_data.full_cast import find_face

    worn = find_face(cast, inspection.stored, face)
    turning = GAZE_UNITS if frames.gaze.any() else ()
    names = dict.fromkeys(
        (*used_names(frames, cast.expressions), *(unit for unit in turning if unit in cast.expressions))
    )
    poses = ((each, named_compound_meshes(cast, worn, each)) for each in names)
    return animated_head(shared_context(cast), worn, poses, frames, name=name)
