"""Cues and lists under way follow a pad that is given another name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_state import CueState, Step
from omote.perform.scene.goals import Goal, Part
from omote.perform.scene.pad_goals import goal_after_rename, is_pad_goal, point_of_goal


def moves_pad(cue: Cue, pad: str) -> bool:
    """Whether a cue moves the point of a pad (by its name)."""
    return any(is_pad_goal(part, move.goal) and point_of_goal(move.goal)[0] == pad for part, move in cue.moves.items())


def cue_after_rename(cue: Cue, pad: str, to: str) -> Cue:
    """A cue that moves a pad under its new name. cue: as it is; pad: the name before; to: the name now."""
    moves = {part: _move(move, pad, to) for part, move in cue.moves.items()}
    return cue if moves == cue.moves else replace(cue, moves=moves)


def state_after_rename(state: CueState, pad: str, to: str) -> CueState:
    """A list that goes on with a pad under its new name: what it tracks, what waits, and what Back brings.

    state: as it is; pad: the name before; to: the name now.
    """

    def goals(given: Mapping[Part, Goal]) -> dict[Part, Goal]:
        return {part: goal_after_rename(goal, pad, to) for part, goal in given.items()}

    def step(one: Step) -> Step:
        stood = {part: None if goal is None else goal_after_rename(goal, pad, to) for part, goal in one.stood.items()}
        return replace(one, stood=stood, before=goals(one.before))

    return replace(
        state,
        tracked=goals(state.tracked),
        waiting=tuple(replace(one, move=_move(one.move, pad, to)) for one in state.waiting),
        steps=tuple(step(one) for one in state.steps),
    )


def _move(move: Move, pad: str, to: str) -> Move:
    goal = goal_after_rename(move.goal, pad, to)
    return move if goal == move.goal else replace(move, goal=goal)
