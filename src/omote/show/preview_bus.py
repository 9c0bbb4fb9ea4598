"""The preview bus of a session: a second set of performers off air, on which a look is built up unseen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, cast

from omote.perform.cues.cue import Cue, CueList
from omote.perform.cues.cue_player import CuePlayer, advance_lists
from omote.perform.cues.tracking import tracked_at, tracked_through
from omote.perform.scene.goals import Goal, Part, rank_of
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame
from omote.perform.scene.scene_snapshot import SceneSnapshot
from omote.perform.scene.two_scenes import follow, shared_of
from omote.perform.snapshot import Playable
from omote.show.cues.cue_edits import LookedAt, shown_goals
from omote.show.declaration import Session


@dataclass(frozen=True)
class PreviewSnapshot:
    """What a restarted server needs of the preview: its scene, and the cue that is looked at."""

    scene: SceneSnapshot
    looked_at: LookedAt = field(default_factory=LookedAt)


class PreviewBus:
    """A scene beside the one on air, made of it when it is first needed; who is in the show is in both.

    It costs nothing until then, and no time goes by in it while nobody looks at it: it catches up when somebody does.
    air: the scene on air, whichever the session has now; cast: what plays.
    """

    def __init__(self, air: Callable[[], Scene], cast: Callable[[], Playable]) -> None:
        self._air = air
        self._cast = cast
        self._scene: Scene | None = None
        self._time = 0.0
        self._shared: tuple[object, ...] = ()
        self._players: tuple[CuePlayer, ...] = ()
        self.looked_at = LookedAt()
        self.touched = False
        """Something was set on it that is to be kept."""

    def scene(self) -> Scene:
        """Its scene, with the characters, points and memories that the show has now."""
        air = self._air().snapshot()
        shared = shared_of(air)
        scene = self._scene
        if scene is None:
            scene = self._set_scene(replace(air, removals={}))
            scene.set_pace(1.0)  # where cues are paused, what they have called comes to its end here
        elif shared != self._shared:
            scene = self._set_scene(follow(scene.snapshot(), air))
        self._shared = shared
        scene.follow_pads(self._air())
        if scene.clips is not self._air().clips:
            scene.set_clips(self._air().clips)
        return scene

    @property
    def is_there(self) -> bool:
        """Whether it has been needed."""
        return self._scene is not None

    def session(self, session: Session) -> Session:
        """What a command that is played in preview has before it: its session, with the scene of the preview. session:
        of the show."""
        self.touched = True
        return cast(Session, _UnseenSession(session, self.scene()))

    def _set_scene(self, snapshot: SceneSnapshot) -> Scene:
        self._shared = ()
        self._scene = Scene.restored(self._cast(), snapshot)
        self._time = snapshot.time
        for player in self._players:
            player.scene = self._scene
        return self._scene

    def reset(self) -> Scene:
        """Makes it what is on air now; returns its scene."""
        self.forget()
        return self.scene()

    def forget(self) -> None:
        """Begins anew when it is needed again."""
        self._scene = None
        self._players = ()
        self.looked_at = LookedAt()
        self.touched = False

    def forget_character(self, name: str) -> None:
        """Forgets a character that is gone: another of its name has come on air."""
        if self._scene is not None and name in self._scene:
            own = self._scene.snapshot()
            others = {other: each for other, each in own.characters.items() if other != name}
            self._set_scene(follow(replace(own, characters=others), self._air().snapshot()))

    def advance(self, time: float) -> SceneFrame:
        """What shows in it at the time of the scene on air, seconds."""
        scene = self.scene()
        frame = advance_lists(scene, self._players, max(0.0, time - self._time))
        self._time = frame.time
        return frame

    def look_at(self, name: str, cues: CueList, cue: Cue, *, run: bool) -> tuple[str, ...]:
        """Shows a cue in it: all that its list leaves standing there, and all else as it comes to stand on air; returns
        what cannot be called, in sentences.

        name: of the list; cues: of it; cue: one of them; run: whether the cue's own moves go, in their times, from what
        the cues before it leave.
        """
        place = cues.index(cue)
        scene = self.reset()
        standing = {part: scene.goal_of(part) for part in shown_goals(scene)}
        lost = call_at_once(scene, {**standing, **tracked_at(cues, place)})
        self.touched = True
        self.looked_at = LookedAt(name, cue.identity, shown_goals(scene))
        if run:
            before = tracked_through(each for each in cues[:place] if not each.skip)
            call_at_once(scene, {**standing, **before})
            player = CuePlayer(scene, (cue,))
            player.go_to(cue.number)
            self._players = (player,)
        return lost

    def go_on_at(self, looked_at: LookedAt) -> None:
        """Looks at the cue that was recorded of it; nothing moves."""
        self.touched = True
        self.looked_at = looked_at

    def recast(self, other: Playable) -> Scene | None:
        """Its scene as another cast plays it, to be given to `play`, None where nothing was set; ValueError where that
        lacks what is called."""
        return None if self._scene is None or not self.touched else Scene.restored(other, self._scene.snapshot())

    def play(self, scene: Scene | None) -> None:
        """Goes on with a scene that `recast` gave."""
        self._scene = scene
        for player in self._players:
            player.scene = scene or player.scene

    def snapshot(self) -> PreviewSnapshot | None:
        """What a restarted server needs; None where nothing was set."""
        if self._scene is None or not self.touched:
            return None
        return PreviewSnapshot(self._scene.snapshot(), self.looked_at)

    def restore(self, snapshot: PreviewSnapshot) -> None:
        """Goes on from a snapshot; ValueError where the cast cannot play it."""
        self._set_scene(snapshot.scene)
        self.looked_at = snapshot.looked_at
        self.touched = True


class _UnseenSession:
    """A session whose scene is another; all else is its own."""

    def __init__(self, session: Session, scene: Scene) -> None:
        self._session = session
        self.scene = scene

    def __getattr__(self, name: str) -> Any:
        """What the session has."""
        return getattr(self._session, name)


def call_at_once(scene: Scene, goals: dict[Part, Goal]) -> tuple[str, ...]:
    """Brings parts to goals at once; returns what cannot be, in sentences: it costs that part. scene: of the parts."""
    lost = []
    for part in sorted(goals, key=rank_of):
        try:
            scene.call_goal(part, goals[part], seconds=0.0)
        except ValueError as error:
            lost.append(f"{part}: {error}")
    return tuple(lost)
