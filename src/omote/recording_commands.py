"""The commands `omote recording ...` and `omote replay`: what a show has recorded, also while it plays."""

from __future__ import annotations

import re
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.file_commands import JsonOption, ShowFileArgument, format_time, print_rows
from omote.terminal import escape_controls, exit_on_refusal, fail, say

if TYPE_CHECKING:
    from omote.server.recording.recorded_show import RecordedShow, Span
    from omote.showfile.recording_file import RecordingFile

NameArgument = Annotated[str, typer.Argument(help="A recording that was kept; else what the last start has played.")]
_CLOCK = re.compile(r"(-?)(?:(\d+):)?(?:(\d{1,2}):)?(\d{1,2}(?:\.\d+)?)")

recording_app = typer.Typer(help="Looks into the recording of a show.", no_args_is_help=True)


def read_clock(text: str | float) -> float:
    """Seconds, from `12.5`, `1:30` or `1:02:30`; below 0, from `-20:00`, they count from the end."""
    matched = _CLOCK.fullmatch(str(text).strip())
    if matched is None:
        raise typer.BadParameter(
            f"{str(text)[:20]!r} is no time; give 1:30 or 1:02:30.5, from the beginning, or -20:00, from the end"
        )
    sign, hours, minutes, seconds = matched.groups()
    if minutes is None:
        hours, minutes = None, hours
    length = 3600.0 * float(hours or 0) + 60.0 * float(minutes or 0) + float(seconds)
    return -length if sign else length


FromOption = Annotated[
    float,
    typer.Option(
        "--from",
        parser=read_clock,
        metavar="TIME",
        help="Where it begins: 1:30 after the beginning, -20:00 from the end.",
    ),
]
ToOption = Annotated[
    float | None, typer.Option("--to", parser=read_clock, metavar="TIME", help="Where it ends: 1:02:30; else the end.")
]

StartOption = Annotated[
    int | None,
    typer.Option("--start", metavar="N", help="Which start of the show (omote recording list); else the last."),
]


@recording_app.command("list")
def list_recordings(file: ShowFileArgument, json: JsonOption = False) -> None:
    """Lists what is recorded: the last 100 minutes, what is kept under a name, and markers, each with the number of the
    start of the show."""
    from omote.server.persistence.recorded_runs import describe_recordings

    with opened(file) as (_, recorded):
        document = describe_recordings(recorded)
    begins = {span.start: span.written - span.first for span in document.spans}
    rows = [
        {"what": "kept" if span.name else "ring", "name": span.name, "start": span.start,
         "at": format_time(span.written), "length": told_length(span.seconds)}
        for span in (*document.spans, *document.kept)
    ] + [
        {"what": "marker", "name": mark.name, "start": mark.start,
         "at": format_time(begins[mark.start] + mark.at), "length": ""}
        for mark in document.markers
    ]  # fmt: skip
    print_rows(rows, json=json, none=f"nothing of {file} is recorded yet.")


@recording_app.command()
def keep(
    file: ShowFileArgument,
    name: Annotated[str, typer.Argument(help="What it is called.")],
    begin: FromOption = 0.0,
    end: ToOption = None,
    start: StartOption = None,
) -> None:
    """Keeps what a start of the show has played under a name, also while it plays; the ring loses it else."""
    from omote.showfile.recording_file import KeptRecording

    with opened(file) as (show, recorded):
        span = cut(show, "", start, begin, end)
        recorded.keep(KeptRecording(name, span.start, span.first, span.last))
    say(f"{name} is kept: {told_length(span.seconds)} long.")


@recording_app.command()
def delete(file: ShowFileArgument, name: Annotated[str, typer.Argument(help="The recording.")]) -> None:
    """Keeps a recording no longer."""
    with opened(file) as (_, recorded):
        recorded.delete(name)
    say(f"{name} is kept no longer; it goes when the ring needs its place.")


@recording_app.command("forget")
def forget_sounds(
    file: ShowFileArgument,
    sounds: Annotated[list[str], typer.Argument(help="Their keys, as of send_sound.")],
) -> None:
    """Removes sounds for good, with all that was recorded while they were needed; no show plays the file."""
    from omote.server.persistence.offline_show import open_offline_show
    from omote.showfile.recording_file import sound_key

    with opened(file) as (_, recorded), open_offline_show(file):
        missing = [sound for sound in sounds if not recorded.contents([sound_key(sound)])]
        if missing:
            fail(f"there is no sound {missing[0]!r} in this recording; nothing was removed.")
        seconds = recorded.forget([sound_key(sound) for sound in sounds])
    say(f"{file} has no recording of {', '.join(sounds)} any more: {told_length(seconds)} went with it.")


@recording_app.command()
def check(
    file: ShowFileArgument,
    name: NameArgument = "",
    begin: FromOption = 0.0,
    end: ToOption = None,
    start: StartOption = None,
) -> None:
    """Replays a recording and says whether every state is the one that was sent."""
    from rich.console import Console
    from rich.progress import Progress

    with opened(file) as (show, _):
        span = cut(show, name, start, begin, end)
        ticks = 0
        with Progress(console=Console(stderr=True), transient=True) as progress:
            task = progress.add_task("replaying", total=span.seconds)
            for tick in show.replay(span):
                ticks += 1
                progress.update(task, completed=tick.now - span.first)
                if tick.same is False:
                    at = told_length(tick.now - show.find_span(name, start).first)
                    fail(f"the state {tick.state.number}, {at} after the beginning, is not the one that was sent.")
    say(f"all {ticks} states are those that were sent: {told_length(span.seconds)}.")


@recording_app.command()
def log(
    file: ShowFileArgument,
    name: NameArgument = "",
    begin: FromOption = 0.0,
    end: ToOption = None,
    start: StartOption = None,
    json: JsonOption = False,
) -> None:
    """Lists who did what; what a hand sends again and again is one line."""
    with opened(file) as (show, _):
        span = cut(show, name, start, begin, end)
        whole = show.find_span(name, start)
        rows = [
            {"at": told_length(line.at - whole.first), "who": line.who, "what": line.what, "of": line.of[:120],
             "times": line.times}
            for line in show.log(span)
        ]  # fmt: skip
    print_rows(rows, json=json, none="nobody has done anything in this time.")


@recording_app.command()
def curves(
    file: ShowFileArgument,
    output: Annotated[Path, typer.Option("-o", "--output", help="The table (.csv), which is not there yet.")],
    name: NameArgument = "",
    begin: FromOption = 0.0,
    end: ToOption = None,
    start: StartOption = None,
) -> None:
    """Writes what showed of each character, ten times a second, as a table (CSV), also while the show plays."""
    from omote.server.persistence.recorded_runs import write_curves

    with opened(file) as (show, recorded):
        span = cut(show, name, start, begin, end)
        with output.open("x", encoding="utf-8", newline="") as text:
            rows = write_curves(recorded, span.start, span.first, span.last, text)
        if rows == 0:
            output.unlink()
            fail("it was recorded without curves, by an older Omote.")
    say(f"{output} has {rows} rows: {told_length(span.seconds)}.")


@recording_app.command("notes")
def list_notes(
    file: ShowFileArgument,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="A table (.csv), which is not there yet; else they are said.")
    ] = None,
    start: StartOption = None,
    json: JsonOption = False,
) -> None:
    """Lists the notes (markers) of all that is recorded, or of one start, with the cue that was called last then."""
    import msgspec

    from omote.server.persistence.recorded_runs import describe_recordings, write_markers

    with opened(file) as (show, recorded):
        document = describe_recordings(recorded)
        if start is not None:
            of_start = [mark for mark in document.markers if mark.start == show.find_played(start).start]
            document = msgspec.structs.replace(document, markers=of_start)
        if output is not None:
            with output.open("x", encoding="utf-8", newline="") as text:
                write_markers(document, text)
    rows = [
        {"day": format_time(mark.written), "cue": mark.cue, "who": mark.who, "note": mark.name}
        for mark in document.markers
    ]
    if output is None:
        print_rows(rows, json=json, none=f"nobody has noted anything of {file}.")
    else:
        say(f"{output} has {len(rows)} notes.")


@recording_app.command("clip")
def cut_clip(
    file: ShowFileArgument,
    clip: Annotated[str, typer.Argument(help="What to call the clip; one that is there gets one more lane.")],
    character: Annotated[str, typer.Option(help="Of whom, by name.")] = "one",
    begin: FromOption = 0.0,
    end: ToOption = None,
    name: Annotated[str, typer.Option("--recording", help="A recording that was kept; else the last start.")] = "",
    parts: Annotated[str, typer.Option(help="Only these: brows,eyes,mouth,rest,head,gaze,body.")] = "",
    lane: Annotated[str, typer.Option(help="What to call the lane.")] = "",
    start: StartOption = None,
) -> None:
    """Cuts a motion clip from what was recorded, into a show file that no show plays."""
    from omote.perform.clips.clip_parts import CLIP_PARTS
    from omote.perform.limits import check_known
    from omote.server.recording.recorded_clip import keep_clip

    with opened(file) as (show, _):
        span = cut(show, name, start, begin, end)
        wanted = [check_known(part.strip(), CLIP_PARTS, "part") for part in parts.split(",") if part.strip()]
        made = keep_clip(file, show, span, character, clip, parts=wanted, lane=lane)
    say(escape_controls(f"{file} has the clip {clip}, {made.seconds:.2f} s, {len(made.lanes)} lanes."))


@recording_app.command()
def archive(
    file: ShowFileArgument,
    output: Annotated[Path, typer.Option("-o", "--output", help="The archive (.zip), which is not there yet.")],
) -> None:
    """Puts the show file, its recording, the cues as text and who did what into one archive, also while it plays."""
    from omote.server.recording.archive import write_archive

    with opened(file) as (show, recorded), exit_on_refusal():
        names = write_archive(file, recorded, show, output, lambda step: say(escape_controls(f"{step} ...")))
    say(f"{output} has {', '.join(names)}.")


def replay(
    file: ShowFileArgument,
    name: NameArgument = "",
    begin: FromOption = 0.0,
    end: ToOption = None,
    start: StartOption = None,
    beside: Annotated[
        Path | None, typer.Option("--beside", help="Another show file, whose runs are compared with those of this one.")
    ] = None,
    port: Annotated[int, typer.Option(min=0, max=65535, help="The port to listen on; 0 for any.")] = 8096,
    open_page: Annotated[bool, typer.Option("--open/--no-open", help="Opens the page in the browser.")] = True,
) -> None:
    """Shows a recording again in the browser, with pause, seek, loop, notes and two runs compared."""
    from omote.server.recording import replay_server
    from omote.showfile.recording_file import open_recording, recording_path

    def announce(address: str) -> None:
        say(f"the replay: {address} (Ctrl-C ends)")
        if open_page:
            webbrowser.open(address)

    with opened(file) as (show, _), exit_on_refusal():
        files = [recording_path(path) for path in (file, beside) if path is not None]
        for path in files[1:]:
            open_recording(path).close()  # what cannot be read is said now
        replay_server.serve(show, cut(show, name, start, begin, end), files, port, announce)


@contextmanager
def opened(file: Path) -> Iterator[tuple[RecordedShow, RecordingFile]]:
    """The recording of a show file; ends the command, with the reason, where there is none. file: the show file."""
    import omote
    from omote.server.recording.recorded_show import RecordedShow
    from omote.showfile.recording_file import open_recording, recording_path

    with exit_on_refusal():
        recorded = open_recording(recording_path(file))
        show = RecordedShow(recorded, omote.load_cast())
        try:
            yield show, recorded
        finally:
            show.close()
            recorded.close()


def cut(show: RecordedShow, name: str, start: int | None, begin: float, end: float | None) -> Span:
    """A part of what was recorded. show: the recording; name: of one that is kept; start: of the show, None for the
    last; begin, end: seconds from there, below 0 from its end."""
    from omote.server.recording.recorded_show import Span

    whole = show.find_span(name, start)
    last = whole.last if end is None else min(whole.last, _moment(whole, end))
    first = max(whole.first, _moment(whole, begin))
    if first >= last:
        until = "the end" if end is None else told_length(last - whole.first)
        length = told_length(whole.seconds)
        fail(f"there is nothing between {told_length(first - whole.first)} and {until}: it is {length} long.")
    return Span(whole.start, first, last)


def _moment(whole: Span, seconds: float) -> float:
    return (whole.last if seconds < 0.0 else whole.first) + seconds


def told_length(seconds: float) -> str:
    """A length as people write it: 1:02:30.5."""
    whole, tenths = divmod(round(10.0 * seconds), 10)
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}.{tenths}"
