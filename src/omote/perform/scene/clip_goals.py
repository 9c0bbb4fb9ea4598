"""How a clip plays as a goal: its name with weight 1, and beside it numbers whose names begin with a colon, which no
clip's name does (`{"line1": 1.0, ":start": 12.4, ":mouth": 0.5}`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from omote.perform.clips.clip import FASTEST, LONGEST_SHIFT, SLOWEST, Clip
from omote.perform.clips.clip_parts import CLIP_PARTS
from omote.perform.clips.clip_runs import ClipRun
from omote.perform.limits import check_within

SETTING = ":"
"""What the name of a number begins with that says how a clip plays."""
SETTING_LIMITS: Mapping[str, tuple[float, float]] = {
    ":start": (0.0, LONGEST_SHIFT),
    ":speed": (SLOWEST, FASTEST),
    ":loop": (0.0, 1.0),
    **{f"{SETTING}{part}": (0.0, 1.0) for part in CLIP_PARTS},
}


@dataclass(frozen=True)
class ClipCall:
    """How a clip is called. name: its own; start: seconds from its start, None for 0; speed, loop: None as the clip
    says; weights: how much of it shows by part, None for all of it."""

    name: str
    start: float | None = None
    speed: float | None = None
    loop: bool | None = None
    weights: Mapping[str, float] | None = None


def goal_of_clip(call: ClipCall) -> dict[str, float]:
    """The goal that plays a clip so."""
    numbers = {":start": call.start, ":speed": call.speed, ":loop": None if call.loop is None else float(call.loop)}
    weights = {f"{SETTING}{part}": weight for part, weight in (call.weights or {}).items()}
    return {call.name: 1.0, **{name: value for name, value in numbers.items() if value is not None}, **weights}


def clip_of_goal(goal: Mapping[str, float]) -> ClipCall:
    """How a goal plays a clip; ValueError, TypeError where it plays none, or not so. One name alone is a clip's."""
    names = [*goal] if len(goal) == 1 else [name for name in goal if not name.startswith(SETTING)]
    if len(names) != 1 or goal[names[0]] != 1.0:
        said = ", ".join(f"{name} = {value!r}" for name, value in goal.items())
        raise ValueError(f"clips are called with {said[:120]}; expected one clip, with the weight 1")
    numbers = {name: value for name, value in goal.items() if name != names[0]}
    strange = [name for name in numbers if name not in SETTING_LIMITS]
    if strange:
        raise ValueError(f"a clip is not called with {strange[0][:40]!r}; expected {', '.join(SETTING_LIMITS)}")
    checked = {
        name: check_within(value, *SETTING_LIMITS[name], f"the {name[1:]} of a clip") for name, value in numbers.items()
    }
    loop = checked.get(":loop")
    if loop not in (None, 0.0, 1.0):
        raise ValueError(f"the loop of a clip is {loop:g}; expected 1 (again and again) or 0 (once)")
    weights: dict[str, float] = {
        part: checked[f"{SETTING}{part}"] for part in CLIP_PARTS if f"{SETTING}{part}" in checked
    }
    return ClipCall(
        names[0], checked.get(":start"), checked.get(":speed"), None if loop is None else bool(loop), weights or None
    )


def call_of_run(run: ClipRun, clip: Clip | None) -> ClipCall:
    """How a clip was called that plays. run: it; clip: that of its name; None where it is not there, so that the call
    says all."""
    weights: dict[str, float] = {str(part): weight for part, weight in run.weights.items()}
    return ClipCall(
        run.clip,
        run.start or None,
        None if clip is not None and run.speed == clip.speed else run.speed,
        None if clip is not None and run.loop == clip.loop else run.loop,
        None if clip is not None and weights == dict.fromkeys(clip.parts, 1.0) else weights,
    )
