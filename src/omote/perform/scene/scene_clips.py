"""The part of a scene that knows its clips and plays them on characters."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.clips.clip import Clip
from omote.perform.limits import check_known
from omote.perform.scene.scene_character import SceneCharacter


class SceneClips:
    """The clips of a scene, by name: any character wears any of them."""

    _characters: dict[str, SceneCharacter]
    _clips: Mapping[str, Clip]

    @property
    def clips(self) -> Mapping[str, Clip]:
        """The clips that can be played.

        Returns
        -------
        mapping of Clip
            By name.

        Examples
        --------
        >>> dict(omote.Scene.begun(cast).clips)
        {}
        """
        return self._clips

    def set_clips(self, clips: Mapping[str, Clip]) -> None:
        """Says which clips can be played from now on; those that play go on as they were called.

        A scene that was restored finds in them what it played.

        Parameters
        ----------
        clips : mapping of Clip
            By name.

        Raises
        ------
        TypeError
            On what is no clip.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> scene = omote.Scene.begun(cast)
        >>> scene.set_clips({"line1": clip})
        >>> scene.play_clip("one", "line1")
        >>> scene.advance(0.5).characters["one"].frame.clips[0].name
        'line1'
        """
        for name, clip in clips.items():
            if not isinstance(clip, Clip):
                raise TypeError(f"the clip {name!s:.40} is a {type(clip).__name__}; give an omote.Clip")
        self._clips = dict(clips)
        for character in self._characters.values():
            character.find_clips(self._clips)

    def play_clip(
        self,
        character: str,
        name: str,
        *,
        seconds: float | None = None,
        start: float = 0.0,
        speed: float | None = None,
        loop: bool | None = None,
        weights: Mapping[str, float] | None = None,
        pace: float | None = None,
    ) -> None:
        """Plays a clip of the scene on a character, as of `Performer.play_clip`.

        Parameters
        ----------
        character : str
            Who plays it.
        name : str
            The clip.
        seconds : float, optional
            In which it comes; as the clip says without it.
        start : float
            Seconds from its start.
        speed : float, optional
            As the clip says without it.
        loop : bool, optional
            As the clip says without it.
        weights : mapping of float, optional
            By part, 0 to 1; all of it without them.
        pace : float, optional
            As of `call_goal`.

        Raises
        ------
        ValueError
            On a character or a clip that there is not, and as `Performer.play_clip`.
        TypeError
            On what is no number.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> scene = omote.Scene.begun(cast)
        >>> scene.set_clips({"line1": clip})
        >>> scene.play_clip("one", "line1", weights={"mouth": 1.0})
        >>> scene.advance(1.0).characters["one"].frame.clips
        ()
        """
        clip = self._clips[check_known(name, self._clips, "clip")]
        self._characters[check_known(character, self._characters, "character")].play_clip(
            clip,
            name=name,
            seconds=seconds,
            start=start,
            speed=speed,
            loop=loop,
            weights=weights,
            pace=pace,
        )
