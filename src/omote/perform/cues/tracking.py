"""Tracking: what the cues of a list have left standing, part by part."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from omote.perform.cues.cue import Cue, CueList
from omote.perform.scene.goals import Goal, Part, passes, regions_of

Tracked = Mapping[Part, Goal]
NOTHING_TRACKED: Tracked = {}


def tracked_after(tracked: Tracked, cue: Cue) -> Tracked:
    """What stands once a cue has been called.

    An expression of the whole face takes its regions with it, as on air; what the cue says of regions comes after that.
    Of clips nothing stands: they are over by themselves, and would begin again where a look is asserted.

    Parameters
    ----------
    tracked : mapping
        Goals by part, as they stood before.
    cue : Cue
        What is called.

    Returns
    -------
    mapping
        Goals by part.
    """
    taken = {region for part in cue.moves for region in regions_of(part)}
    kept = {part: goal for part, goal in tracked.items() if part not in taken}
    return {**kept, **{part: move.goal for part, move in cue.moves.items() if not passes(part)}}


def tracked_through(cues: Iterable[Cue]) -> Tracked:
    """What stands once all of some cues have been called, in their order."""
    tracked = NOTHING_TRACKED
    for cue in cues:
        tracked = tracked_after(tracked, cue)
    return tracked


def tracked_at(cues: CueList, place: int) -> Tracked:
    """What stands after the cue at a place of its list; those that are skipped leave nothing.

    cues: the list; place: from 0.
    """
    return tracked_through(cue for at, cue in enumerate(cues[: place + 1]) if at == place or not cue.skip)
