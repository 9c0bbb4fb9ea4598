"""A list of cues on a real scene."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_player import CuePlayer
from omote.perform.figures.figure_axes import FigureAxes, figure_frame
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    MACROS,
    PASSING,
    POSE_PARTS,
    SCENE_PARTS,
    Goal,
    Part,
    is_setting,
    ranges_of,
)
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame
from tests import synthetic

PARTS = (
    *(
        f"one/{part}" for part in CHARACTER_PARTS if part not in (*PASSING, MACROS)
    ),  # a character has no macros at first
    *(f"*/{part}" for part in SCENE_PARTS),
)
NAMES = {
    "face": synthetic.FACES,
    "light": ("theatre", "flat", "portrait"),
    "framing": ("*", "one", "two"),
    **dict.fromkeys(("pose", *POSE_PARTS), synthetic.POSES),
    "body": (*synthetic.BODIES, "own"),
}
LOOKS: tuple[Goal, ...] = (
    {"ahead": 1.0},
    {"character two": 1.0},
    {"stage": 1.0},
    {"yaw": 0.2, "pitch": 0.1},
    {"x": 1.0, "y": 0.0, "z": 2.0},
)
STILL = 30.0
"""Seconds after which nothing moves any more."""


def random_goal(rng: np.random.Generator, part: Part) -> Goal:
    ranges = ranges_of(part)
    if part.endswith("/look"):
        return LOOKS[int(rng.integers(len(LOOKS)))]
    if ranges is not None:
        return {name: float(rng.uniform(low, high)) for name, (low, high) in ranges.items() if name != "liveliness"} | (
            {"liveliness": 0.0} if "liveliness" in ranges else {}
        )
    names = NAMES.get(part.rpartition("/")[2], synthetic.EXPRESSIONS)
    first, second = (str(name) for name in rng.choice(names, 2, replace=False))
    share = float(rng.choice([1.0, 0.75]))
    return {first: share, second: 1.0 - share} if share < 1.0 else {first: 1.0}


def random_cues(rng: np.random.Generator, count: int, parts: Sequence[Part] = PARTS) -> list[Cue]:
    times = [0.0, 0.25, 0.7, 1.3]
    return [
        Cue(
            f"cue {number}",
            str(number),
            {
                str(part): Move(random_goal(rng, str(part)), float(rng.choice(times)), delay=float(rng.choice(times)))
                for part in rng.choice(parts, 4, replace=False)
            },
            pre_wait=float(rng.choice(times)),
        )
        for number in range(count)
    ]


def begun(cast: Cast) -> Scene:
    scene = Scene.begun(cast)
    scene.add("two")
    scene.enter("two", seconds=0.0)
    scene.advance(1.0)
    return scene


def shown(frame: SceneFrame) -> object:
    """All that cues move, without the times."""
    one = frame.characters["one"]
    played = (one.frame.faces, one.frame.expressions, one.frame.regions, one.frame.head, one.frame.gaze)
    figure = one.frame.figure or figure_frame(FigureAxes())
    return (
        played,
        (figure.poses, figure.regions, figure.bodies),
        one.place,
        one.presence,
        frame.light,
        frame.framing,
        frame.black,
    )


@pytest.mark.parametrize("seed", range(3))
def test_back_brings_back_the_picture_before_every_cue(cast: Cast, seed: int) -> None:
    rng = np.random.default_rng(seed)
    player = CuePlayer(begun(cast), random_cues(rng, 6))
    before = [shown(player.advance(STILL))]
    while player.standby is not None:
        player.go()
        before.append(shown(player.advance(STILL)))
        assert player.rejected == ()
    while player.state.steps:
        assert shown(player.advance(STILL)) == before.pop()
        player.go_back()
    assert shown(player.advance(STILL)) == before.pop()


@pytest.mark.parametrize("seed", range(3))
def test_one_long_step_lands_where_short_ones_do(cast: Cast, seed: int) -> None:
    """What is due between two ticks begins at its time: the picture does not depend on when the ticks fall.

    Settings are followed by filters, which take steps as they come.
    """
    rng = np.random.default_rng(seed)
    timed = [part for part in PARTS if not is_setting(part.rpartition("/")[2])]
    cues = [Cue(**{**vars(cue), "goes_on": "continue"}) for cue in random_cues(rng, 5, timed)]
    frames = []
    for steps in ([3.0], [3.0 * share for share in rng.dirichlet(np.ones(7))]):
        player = CuePlayer(begun(cast), cues)
        player.go()
        for step in steps:
            frame = player.advance(step)
        frames.append(frame)
    long, short = (frame.characters["one"] for frame in frames)
    assert long.frame.faces == pytest.approx(short.frame.faces, abs=1e-9)
    assert long.frame.expressions == pytest.approx(short.frame.expressions, abs=1e-9)
    assert vars(long.place) == pytest.approx(vars(short.place), abs=1e-9)
    assert vars(long.frame.head) == pytest.approx(vars(short.frame.head), abs=1e-9)
    assert frames[0].light == pytest.approx(frames[1].light, abs=1e-9)


def test_go_for_a_cue_that_does_not_stand_by_is_refused_and_moves_nothing(cast: Cast) -> None:
    """Two people press GO for the same cue: the second press finds the next one."""
    player = CuePlayer(begun(cast), [Cue("a", "1"), Cue("b", "2", {"*/black": Move({"black": 1.0})})])
    player.go(seen="1")
    with pytest.raises(ValueError, match="cue 2 stands by, not 1; nothing was called"):
        player.go(seen="1")
    assert player.current is not None
    assert player.current.number == "1"
    player.go(seen="2")
    with pytest.raises(ValueError, match="the list is at its end"):
        player.go()


def test_panic_forgets_what_waits_for_its_character_alone(cast: Cast) -> None:
    scene = begun(cast)
    face = Move({synthetic.FACES[1]: 1.0}, 0.0, delay=1.0)
    player = CuePlayer(scene, [Cue("a", "1", {"one/face": face, "two/face": face})])
    player.go()
    scene["one"].panic()
    frame = player.advance(2.0)
    assert dict(frame.characters["one"].frame.faces) == {synthetic.FACES[0]: 1.0}
    assert dict(frame.characters["two"].frame.faces) == {synthetic.FACES[1]: 1.0}


def test_what_is_called_after_a_panic_waits_and_what_waited_before_it_does_not(cast: Cast) -> None:
    """Also where both come between two steps."""
    scene = begun(cast)
    early = Cue("a", "1", {"one/face": Move({synthetic.FACES[1]: 1.0}, 0.0, delay=1.0)})
    late = Cue("b", "2", {"one/expression": Move({"jawOpen": 1.0}, 0.0, delay=1.0)})
    player = CuePlayer(scene, [early, late])
    player.go()
    scene["one"].panic()
    player.go()
    frame = player.advance(2.0).characters["one"].frame
    assert dict(frame.faces) == {synthetic.FACES[0]: 1.0}
    assert dict(frame.expressions) == {"jawOpen": 1.0}


def test_a_move_that_cannot_be_called_costs_that_move_and_is_said(cast: Cast) -> None:
    scene = begun(cast)
    moves = {"two/face": Move({synthetic.FACES[1]: 1.0}, 0.0), "*/black": Move({"black": 1.0}, 0.0)}
    player = CuePlayer(scene, [Cue("a", "1", {**moves, "one/face": Move({"nobody": 1.0}, 0.0)})])
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    player.go()
    assert player.advance(0.0).black == 1.0
    player.go_to("1")
    rejected = player.rejected
    assert len(rejected) == 2
    assert rejected[0].startswith("cue 1: there is no face 'nobody'")
    assert rejected[1].startswith("cue 1: there is no character 'two'")


def test_an_edition_moves_nothing_and_is_played_from_then_on(cast: Cast) -> None:
    player = CuePlayer(begun(cast), [Cue("a", "1"), Cue("b", "2")])
    player.go()
    player.edit([Cue("b", "7", {"*/black": Move({"black": 1.0}, 0.0)}), Cue("a", "8")])
    assert player.advance(1.0).black == 0.0
    player.go(seen="7")
    assert player.advance(0.0).black == 1.0
    with pytest.raises(ValueError, match="there is no cue of this list '1'"):
        player.set_standby("1")
    player.set_standby("8")
    with pytest.raises(ValueError, match="two cues have the number 8"):
        player.edit([Cue("b", "8"), Cue("a", "8")])


def test_a_cue_calls_a_clip_back_stops_it_and_a_look_does_not_begin_it_again(cast: Cast) -> None:
    scene = begun(cast)
    still = Clip([Lane(make_curve([0.0, 2.0], {"jawOpen": [0.9] * 2}, {}))])
    scene.set_clips({"line1": still})
    cues = [Cue("a", "1", {"one/clip": Move({"line1": 1.0}, 0.1)}), Cue("b", "2", {"*/light": Move({"flat": 1.0})})]
    player = CuePlayer(scene, cues)

    def playing() -> list[str]:
        return [clip.name for clip in player.advance(0.5).characters["one"].frame.clips]

    player.go()
    assert playing() == ["line1"]
    player.go()
    player.advance(2.0)
    player.assert_look()
    assert playing() == []
    player.go_to("2", whole=True)
    assert playing() == []
    player.go_to("1")
    assert playing() == ["line1"]
    player.go_back()
    player.advance(1.0)
    assert playing() == []
    scene.set_clips({})
    player.go_to("1")
    assert len(player.rejected) == 1


def test_a_cue_says_how_a_clip_plays_and_back_begins_it_again_so(cast: Cast) -> None:
    scene = begun(cast)
    moved = Clip([Lane(make_curve([0.0, 4.0], {"jawOpen": [0.9] * 2}, {}))], loop=True)
    scene.set_clips({"line1": moved})
    goal = {"line1": 1.0, ":start": 1.0, ":speed": 0.5, ":loop": 0.0, ":mouth": 0.5}
    cues = [
        Cue("a", "1", {"one/clip": Move(goal, 0.0)}),
        Cue("b", "2", {"one/clip": Move({}, 0.0)}),
        Cue("c", "3", {"one/clip": Move({"line1": 1.0, ":start": 4.0}, 0.0)}),
        Cue("d", "4", {"one/clip": Move({"line1": 1.0}, 0.0)}),
    ]
    player = CuePlayer(scene, cues)
    player.go()
    run = player.advance(1.0).characters["one"].frame.clips[0]
    assert (run.elapsed, run.share, run.loop) == (1.5, 1.0, False)
    assert scene.goal_of("one/clip") == scene.shown_goal("one/clip") == goal
    player.go()
    assert player.advance(0.5).characters["one"].frame.clips == ()
    player.go_back()
    assert scene.goal_of("one/clip") == goal
    assert player.advance(0.0).characters["one"].frame.clips[0].elapsed == 1.0
    player.go_to("3")
    assert "it cannot begin at 4 s" in player.rejected[0]
    player.go_to("4")
    assert scene.goal_of("one/clip") == {"line1": 1.0}
