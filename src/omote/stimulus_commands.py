"""The command `omote stimuli`: the pictures and clips of a table, checked whole before the first is drawn."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.picture_commands import (
    STOPPED,
    ForceOption,
    FreshOption,
    JobsOption,
    ShowOption,
    shown_progress,
    tell_clipped,
)
from omote.terminal import exit_on_refusal, fail, say

if TYPE_CHECKING:
    from omote.server.headless.picture_run import PictureStudio
    from omote.server.headless.stimulus_run import StimulusRun

MOST_TOLD = 20


def stimuli(
    table: Annotated[Path, typer.Argument(help="The design: a CSV, a row for each picture or clip.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The folder that gets them.")],
    show: ShowOption = None,
    jobs: JobsOption = 1,
    fresh: FreshOption = False,
    force: ForceOption = False,
) -> None:
    """Draws the pictures, clips and films of a table, and a table of what was drawn; goes on where it was stopped."""
    with exit_on_refusal():
        data = table.read_bytes()
        if output.exists() and not output.is_dir():
            fail(f"{output} is a file; give the name of a folder for the pictures.")
        studio, planned = plan(table, data, output, show, fresh=fresh)
        if not force:
            planned.refuse_foreign()
        lost = draw_shown(studio, planned, jobs=jobs)
    drawn = [stimulus for stimulus in planned.stimuli if stimulus.row not in lost]
    pictures = [planned.folder / name for stimulus in drawn for name in stimulus.files]
    say(f"{output} has {len(pictures)} pictures of {len(drawn)} rows, and drawn.csv, which lists them.")
    tell_clipped(pictures)
    for sentence in lost.values():
        say(f"{table.name}, {sentence}")
    if lost:
        fail(f"rows that could not be drawn: {len(lost)}; mend them, and the same command draws them.")


def plan(
    table: Path, data: bytes, output: Path, show: Path | None, *, fresh: bool
) -> tuple[PictureStudio, StimulusRun]:  # fmt: skip
    """What is to be drawn and by what; ends the command with all that is wrong in the table.

    table: its file, data: what that holds; output: the folder; show: the show file, None for none; fresh: whether what
    is there is drawn again.
    """
    from omote.server.headless.chromium import find_chromium
    from omote.showfile.inspection import inspect_show

    inspection = None if show is None else inspect_show(show)
    find_chromium()
    from omote.server.headless.picture_run import PictureStudio
    from omote.server.headless.stimulus_run import plan_stimuli, refuse_own_table
    from omote.stage_data.stimulus_table import TableError

    refuse_own_table(table, output)
    studio = PictureStudio(inspection, say)
    try:
        planned = plan_stimuli(studio, data, output, show="" if show is None else str(show), fresh=fresh)
    except TableError as error:
        for sentence in error.sentences[:MOST_TOLD]:
            say(f"{table.name}, {sentence}")
        left = len(error.sentences) - MOST_TOLD
        more = f", {left} more than are said here" if left > 0 else ""
        fail(f"nothing was drawn: mend what is wrong in {table} ({len(error.sentences)}{more}).")
    if planned.own:
        say(f"headings of your own, carried into drawn.csv as they are: {', '.join(planned.own)}.")
    return studio, planned


def draw_shown(studio: PictureStudio, planned: StimulusRun, *, jobs: int) -> dict[int, str]:
    """Draws, and shows how far it is; returns why rows could not be drawn, by their numbers.

    studio: what draws; planned: what; jobs: browsers at once.
    """
    from omote.server.headless.stimulus_run import draw_planned, finish_stimuli

    with shown_progress(planned.count, planned.waiting, planned.folder, STOPPED) as report:
        lost = draw_planned(studio, planned, report, jobs=jobs)
    return finish_stimuli(studio, planned, lost, say)
