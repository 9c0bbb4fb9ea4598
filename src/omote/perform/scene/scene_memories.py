"""The part of a scene that keeps whole looks of it and calls them back."""

from __future__ import annotations

from collections.abc import Mapping

from omote.model.known_names import PLAY_REGIONS
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.limits import check_call_seconds, check_known
from omote.perform.scene.character_names import ALL
from omote.perform.scene.goals import BODY, POSE, POSE_PARTS, WITH_FACE, Goal, Part
from omote.perform.scene.memories import Memories, Memory, with_memory, with_restored, without_memory
from omote.perform.scene.scene_goals import SceneGoals
from omote.perform.snapshot import Playable

REMEMBERED = ("face", "expression", *PLAY_REGIONS, "head", "gaze")
"""What a memory has of each character, and of its figure where the cast has any; of the scene it has light and
framing."""
REMEMBERED_OF_FIGURES = (POSE, *POSE_PARTS, BODY)


class SceneMemories(SceneGoals):
    """The memories of a scene: its whole look under a name, as it shows, and back in one breath."""

    _cast: Playable
    _memories: Memories

    @property
    def memories(self) -> Mapping[str, Memory]:
        """The looks that were kept, by name: another mapping after each change."""
        return self._memories.kept

    def keep_memory(self, name: str, *, key: str = "") -> None:
        """Keeps what shows under a name: faces, expressions, poses, head and gaze of all characters, light and framing.

        Channels, places, sources, black and what moves by itself are no part of it.

        Parameters
        ----------
        name : str
            1 to 40 letters; one of that name is kept anew.
        key : str
            What `restore_memory` finds the one before by; the name where none is given.

        Raises
        ------
        ValueError
            On a name that none can have, and beyond thirty-two memories.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene["one"].call_face("dog", seconds=0)
        >>> scene.keep_memory("finale")
        >>> scene["one"].call_face("old", seconds=0)
        >>> scene.call_memory("finale", seconds=2)
        >>> dict(scene.advance(2.0).characters["one"].frame.faces)
        {'dog': 1.0}
        """
        self.keep_look_of(self, name, key=key)

    def keep_look_of(self, seen: SceneMemories, name: str, *, key: str = "") -> None:
        """Keeps what another scene shows under a name, as `keep_memory` keeps what this one does.

        Parameters
        ----------
        seen : Scene
            The one whose look is kept, such as the preview's.
        name, key : str
            As of `keep_memory`.

        Raises
        ------
        ValueError
            On a name that none can have, and beyond thirty-two memories.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> unseen = omote.Scene.restored(cast, scene.snapshot())
        >>> unseen["one"].call_face("dog", seconds=0)
        >>> scene.keep_look_of(unseen, "finale")
        >>> scene.call_memory("finale", seconds=0)
        >>> dict(scene.advance(0.0).characters["one"].frame.faces)
        {'dog': 1.0}
        """
        remembered = (*REMEMBERED, *(REMEMBERED_OF_FIGURES if seen._cast.poses else ()))
        stay = [other for other in seen._characters if not seen._standings[other].leaves]
        parts = [f"{other}/{part}" for other in stay for part in remembered]
        goals = {part: seen._showing(part, points=False) for part in (*parts, f"{ALL}/light", f"{ALL}/framing")}
        memory = Memory({part: goal for part, goal in goals.items() if goal != WITH_FACE})
        self._memories = with_memory(self._memories, name, memory, key or name)

    def delete_memory(self, name: str, *, key: str = "") -> None:
        """Forgets a memory; nothing changes on air.

        Parameters
        ----------
        name : str
            The memory.
        key : str
            What `restore_memory` finds it by; the name where none is given.

        Raises
        ------
        ValueError
            On a memory that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.keep_memory("finale")
        >>> scene.delete_memory("finale")
        >>> scene.advance(0.0).memories
        ()
        """
        self._memories = without_memory(self._memories, name, key or name)

    def restore_memory(self, key: str) -> None:
        """Takes back that a memory was kept or deleted; again, it is as after that.

        The last sixteen changes can be taken back.

        Parameters
        ----------
        key : str
            What `keep_memory` or `delete_memory` was given: the name, where they were given no key.

        Raises
        ------
        ValueError
            On a key that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.keep_memory("finale")
        >>> scene.delete_memory("finale")
        >>> scene.restore_memory("finale")
        >>> scene.advance(0.0).memories
        ('finale',)
        """
        self._memories = with_restored(self._memories, key)

    def call_memory(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a memory on air from whatever shows, all its parts in the same time; other characters go on.

        Parameters
        ----------
        name : str
            The memory.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.

        Raises
        ------
        ValueError
            On a memory or an easing that there is not, on seconds out of range, and where a character, a face, an
            expression or a light of it has gone; then nothing has changed.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.keep_memory("opening")
        >>> scene["one"].set_head(yaw=0.4, pitch=0.0, roll=0.0)
        >>> scene.call_memory("opening", seconds=1)
        >>> round(scene.advance(0.5).characters["one"].frame.head.yaw, 3)
        0.2
        """
        memory = self._memories.kept[check_known(name, self._memories.kept, "memory")]
        seconds = check_call_seconds(seconds)
        find_easing(easing)
        for part, goal in memory.goals.items():
            self._check_remembered(name, part, goal)
        for part, goal in memory.goals.items():
            self.call_goal(part, goal, seconds=seconds, easing=easing)
        for character in self._characters.values():
            character.note_played()

    def _check_remembered(self, name: str, part: Part, goal: Goal) -> None:
        try:
            self._check_call(part, goal)
        except ValueError as error:
            raise ValueError(f"the memory {name!r} cannot be called any more: {error}; keep it anew") from error
