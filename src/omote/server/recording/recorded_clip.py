"""A motion clip of what was recorded: it is replayed, and what shows of a character is cut from the states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from omote.perform.clips.clip import Clip, Lane, with_lane
from omote.perform.clips.clip_parts import CLIP_PARTS, ClipPart
from omote.perform.clips.cut_clip import cut_curve
from omote.perform.clips.motion_curve import MotionCurve
from omote.perform.clips.packed_motion import rounded
from omote.perform.limits import check_known
from omote.server.persistence.offline_show import open_offline_show
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.show.clips.show_clips import name_new_clip
from omote.show.objects.clips import StoredClip, clip_of, stored_clip
from omote.show.objects.documents import read_document
from omote.show.objects.state import CharacterState
from omote.showfile.changes import StoredDocument


def keep_clip(
    file: Path,
    show: RecordedShow,
    span: Span,
    character: str,
    name: str,
    *,
    parts: Sequence[ClipPart] = (),
    lane: str = "",
) -> Clip:
    """Cuts a clip and keeps it in the show file.

    Parameters
    ----------
    file : Path
        The show file, which no show plays.
    show : RecordedShow
        Its recording.
    span : Span
        What is cut.
    character : str
        Of whom, by name.
    name : str
        Of the clip; one that is there gets one more lane, which begins where it begins.
    parts : sequence of str
        What the lane gives of brows, eyes, mouth, rest, head, gaze and body; none named: all.
    lane : str
        What to call it.

    Returns
    -------
    Clip
        As it is kept.

    Raises
    ------
    ValueError
        Where nobody of that name was on stage, on a name that no clip can have, and where there are too many clips.
    ReplayError, ShowFileError, OSError, sqlite3.Error
        Where the recording or the show file cannot be used.
    """
    made = Lane(curve_of(show, span, character), lane, tuple(parts) or CLIP_PARTS)
    with open_offline_show(file) as opened:
        there = opened.stored().documents.get(StoredClip.kind, {})
        if name in there:
            clip = with_lane(clip_of(read_document(StoredClip, there[name])), made)
        else:
            name = name_new_clip(name, there)
            clip = Clip([made])
        opened.apply([StoredDocument(StoredClip.kind, name, stored_clip(clip).encode())])
    return clip


def curve_of(show: RecordedShow, span: Span, character: str) -> MotionCurve:
    """What a character did in a span of a recording, as a clip keeps it; ValueError where it was not on stage. show:
    the recording; character: by name."""
    shown = list(_shown(show, span, character))
    if not shown:
        raise ValueError("nothing was recorded then; choose other times")
    return rounded(cut_curve(shown, show.base, start=shown[0][0], stop=shown[-1][0]))


def _shown(show: RecordedShow, span: Span, character: str) -> Iterator[tuple[float, CharacterState]]:
    """What shows of a character, each with its time; ValueError where nobody of that name is there."""
    found = False
    names: dict[str, None] = {}
    for tick in show.replay(span):
        names |= dict.fromkeys(tick.state.characters)
        state = tick.state.characters.get(character)
        if state is not None:
            found = True
            yield tick.state.time, state
    if names and not found:
        check_known(character, names, "character")
