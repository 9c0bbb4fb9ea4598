"""What a recording holds, for people: its spans, its markers, and the curves of its runs, also as text."""

from __future__ import annotations

import csv
import time
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from typing import TextIO

import msgspec
import numpy as np

from omote.show.objects.recordings import (
    CalledCue,
    MarkedMoment,
    RecordedSpan,
    RecordingsDocument,
    RunDocument,
)
from omote.show.recording.curves import QUANTITIES, WORDS, CueCall, Curves, join_curves, unpack_curves
from omote.showfile.recording_file import RecordingFile

APART = 1.0
"""Seconds between two pieces of one span; more is a gap."""
DECIMALS = 3


def describe_recordings(file: RecordingFile) -> RecordingsDocument:
    """What a recording holds, for people; sqlite3.Error where it cannot be read. file: the open recording."""
    pieces = file.pieces()
    offsets = {piece.start: piece.written - piece.first for piece in pieces}
    spans: list[RecordedSpan] = []
    for piece in pieces:
        before = spans[-1] if spans else None
        if before is not None and before.start == piece.start and piece.first - before.first - before.seconds < APART:
            spans[-1] = msgspec.structs.replace(before, seconds=piece.last - before.first)
        else:
            spans.append(RecordedSpan(piece.start, piece.first, piece.written, piece.last - piece.first))
    kept = [
        RecordedSpan(
            each.start, each.first, offsets.get(each.start, 0.0) + each.first, each.last - each.first, each.name
        )
        for each in file.kept()
    ]
    cues = file.cue_calls(pieces[-1].start) if pieces else []
    return RecordingsDocument(spans, kept, describe_markers(file, offsets), cue=cues[-1][2] if cues else "")


def describe_markers(file: RecordingFile, offsets: Mapping[int, float]) -> list[MarkedMoment]:
    """The markers of a recording in their order, each with the cue that was called last then. file: the open recording;
    offsets: what is added to the clock of each start of the show for seconds since 1970."""
    calls = {start: [CueCall(*call) for call in file.cue_calls(start)] for start in offsets}
    return [
        MarkedMoment(
            each.id, each.start, each.at, offsets[each.start] + each.at, each.name, each.who,
            cue_at(calls[each.start], each.at),
        )
        for each in file.markers()
    ]  # fmt: skip


def cue_at(calls: Sequence[CueCall], at: float) -> str:
    """The number of the cue that was called last up to a time, "" for none. calls: in their order; at: seconds of their
    clock."""
    place = bisect_right(calls, at, key=lambda call: call.at)
    return calls[place - 1].number if place else ""


def curves_of(file: RecordingFile, start: int, first: float, last: float) -> Curves:
    """The curves of a part of a recording; empty where it was recorded without. ValueError where they are damaged.
    file: the open recording; start: of the show; first, last: seconds of its clock."""
    pieces = file.pieces_between(start, first, last)
    parts = [unpack_curves(data) for data in file.curves(piece.id for piece in pieces)]
    return join_curves(parts).between(first, last)


def cues_of(file: RecordingFile, start: int, first: float, last: float) -> list[CueCall]:
    """The cues that were called in a part of a recording, in their order. file: the open recording; start: of the
    show; first, last: seconds of its clock."""
    calls = [CueCall(*call) for call in file.cue_calls(start)]
    return [call for call in calls if first <= call.at <= last]


def describe_run(file: RecordingFile, start: int, first: float, last: float) -> RunDocument:
    """The curves and cues of a part of a recording, for a page, which unpacks them: a process that plays a show has no
    time for it. file: the open recording; start: of the show; first, last: seconds of its clock."""
    pieces = file.pieces_between(start, first, last)
    calls = cues_of(file, start, first, last)
    return RunDocument(
        start=start,
        first=first,
        seconds=max(0.0, last - first),
        quantities=dict(QUANTITIES),
        pieces=file.curves(piece.id for piece in pieces),
        cues=[CalledCue(round(call.at - first, DECIMALS), call.cue_list, call.number) for call in calls],
    )


def write_curves(file: RecordingFile, start: int, first: float, last: float, text: TextIO) -> int:
    """Writes the curves of a part of a recording as CSV and returns how many rows: one for each character ten times a
    second, with the seconds from the beginning, the cue that was called last ("" for none), who, and the quantities.
    Nothing is written where it was recorded without curves.

    Parameters
    ----------
    file : RecordingFile
        The open recording.
    start : int
        Of the show.
    first, last : float
        Seconds of its clock.
    text : TextIO
        To write to.

    Raises
    ------
    ValueError
        Where the curves are damaged.
    """
    curves = curves_of(file, start, first, last)
    calls = [CueCall(*call) for call in file.cue_calls(start)]
    writer = csv.writer(text, lineterminator="\n")
    words = {name: [curves.words(name, word) for word in WORDS] for name in curves.values}
    rows = 0
    for row, at in enumerate(curves.times):
        for name, table in curves.values.items():
            if np.isnan(table[row, 0]):
                continue
            if rows == 0:
                writer.writerow(["seconds", "cue", "character", *WORDS, *QUANTITIES])
            rows += 1
            numbers = [f"{value:.{DECIMALS}f}" for value in table[row, : len(QUANTITIES)]]
            cue = cue_at(calls, float(at))
            writer.writerow([f"{at - first:.3f}", cue, name, *(word[row] for word in words[name]), *numbers])
    return rows


def write_markers(document: RecordingsDocument, text: TextIO) -> None:
    """Writes the markers of a recording as CSV: the day and time, the seconds of its start, the cue, who, and what it
    says. document: what is recorded; text: to write to."""
    begins: dict[int, float] = {}
    for span in document.spans:
        begins.setdefault(span.start, span.first)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["day", "seconds", "cue", "who", "note"])
    for mark in document.markers:
        day = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(mark.written))
        seconds = mark.at - begins.get(mark.start, mark.at)
        writer.writerow([day, f"{seconds:.1f}", mark.cue, mark.who, mark.name])
