"""The part of a scene that keeps pads, and moves their points on characters."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.name_lookup import find_name
from omote.perform.pads import kept_pads
from omote.perform.pads.blend_space import Pad
from omote.perform.pads.kept_pads import Pads
from omote.perform.scene.cast_pads import cast_pads
from omote.perform.scene.scene_memories import SceneMemories
from omote.perform.snapshot import Playable


class ScenePads(SceneMemories):
    """The pads of a scene: any character is played by any of them."""

    _cast: Playable
    _pads: Pads

    @property
    def pads(self) -> Mapping[str, Pad]:
        """The pads by name.

        Returns
        -------
        mapping of Pad
            In the order in which they came.

        Examples
        --------
        >>> list(omote.Scene.begun(cast).pads)
        ['moods', 'mouth', 'faces']
        """
        return self._pads.kept

    def set_pad(self, pad: Pad, *, key: str = "") -> None:
        """Keeps a pad; one of its name makes way, and what that plays follows the new one without a jump.

        Parameters
        ----------
        pad : Pad
            With its name.
        key : str
            What `restore_pad` finds the one before by, its name where none is given. Several changes of one pad with a
            key, one after the other, are taken back together.

        Raises
        ------
        ValueError
            Beyond thirty-two pads.
        TypeError
            On what is no pad.

        Examples
        --------
        >>> calm = omote.PadLook("Calm", {"neutral": 1.0}, (-1.0,))
        >>> glad = omote.PadLook("Glad", {"joy": 1.0}, (1.0,))
        >>> scene = omote.Scene.begun(cast)
        >>> scene.set_pad(omote.Pad("mood", "expression", 1, [calm, glad]))
        >>> scene.move_pad("one", "mood", 1.0)
        >>> dict(scene.advance(0.5).characters["one"].frame.expressions)
        {'joy': 1.0}
        """
        if not isinstance(pad, Pad):
            raise TypeError(f"the pad is a {type(pad).__name__}; give an omote.Pad")
        self._wear_pads(kept_pads.with_pads(self._pads, {pad.name: pad}, key or pad.name, goes_on=key != ""))

    def rename_pad(self, name: str, to: str, *, key: str = "") -> None:
        """Gives a pad another name; what it plays it plays on.

        Parameters
        ----------
        name : str
            The pad.
        to : str
            What it is called from now on, 1 to 24 letters without spaces.
        key : str
            What `restore_pad` finds it by; its old name where none is given.

        Raises
        ------
        ValueError
            On a pad that there is not, and on a name that no pad can have, or that another has.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.rename_pad("moods", "temper")
        >>> list(scene.pads)
        ['temper', 'mouth', 'faces']
        """
        self._wear_pads(kept_pads.with_name(self._pads, name, to, key or name), {name: to})

    def copy_pad(self, name: str, to: str, *, key: str = "") -> None:
        """Keeps a copy of a pad under another name.

        Parameters
        ----------
        name : str
            The pad.
        to : str
            The name of the copy, as of `rename_pad`.
        key : str
            What `restore_pad` finds it by; the name of the copy where none is given.

        Raises
        ------
        ValueError
            As of `rename_pad`, and beyond thirty-two pads.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.copy_pad("mouth", "lips")
        >>> scene.pads["lips"].looks == scene.pads["mouth"].looks
        True
        """
        self._wear_pads(kept_pads.with_copy(self._pads, name, to, key or to))

    def drop_pad(self, name: str, *, key: str = "") -> None:
        """Forgets a pad; what it shows stays on air.

        Parameters
        ----------
        name : str
            The pad.
        key : str
            What `restore_pad` finds it by; its name where none is given.

        Raises
        ------
        ValueError
            On a pad that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.drop_pad("faces")
        >>> list(scene.pads)
        ['moods', 'mouth']
        """
        self._wear_pads(kept_pads.without_pad(self._pads, name, key or name))

    def restore_pad(self, key: str) -> Mapping[str, str]:
        """Takes a change of pads back; again, it is as after that.

        The last sixteen changes can be taken back.

        Parameters
        ----------
        key : str
            What the change was given: the name, where it was given no key.

        Returns
        -------
        mapping of str
            What a pad is called now, by what it was called; empty where the change was no other name.

        Raises
        ------
        ValueError
            On a key that there is not, and beyond thirty-two pads.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.rename_pad("moods", "temper")
        >>> scene.restore_pad("moods")
        {'temper': 'moods'}
        >>> list(scene.pads)
        ['moods', 'mouth', 'faces']
        """
        pads, renamed = kept_pads.with_change_back(self._pads, key)
        self._wear_pads(pads, renamed)
        return renamed

    def add_cast_pads(self, *, key: str = "") -> None:
        """Keeps the pads that come with the cast, as a new show has them; pads of the same names make way.

        Parameters
        ----------
        key : str
            What `restore_pad` finds those before by; "cast pads" where none is given.

        Raises
        ------
        ValueError
            Beyond thirty-two pads.

        Examples
        --------
        >>> scene = omote.Scene(cast)
        >>> scene.add_cast_pads()
        >>> list(scene.pads)
        ['moods', 'mouth', 'faces']
        """
        self._wear_pads(kept_pads.with_pads(self._pads, cast_pads(self._cast), key or "cast pads"))

    def move_pad(
        self,
        character: str,
        name: str,
        x: float | None,
        y: float | None = None,
        *,
        z: float | None = None,
    ) -> None:
        """Moves the point of a pad on a character, as of `Performer.move_pad`.

        Parameters
        ----------
        character : str
            Whom it plays.
        name : str
            The pad, in any case.
        x, y, z : float, optional
            Where to, -1 to 1; what is None stays.

        Raises
        ------
        ValueError
            On a character or a pad that there is not, and as `Performer.move_pad`.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.move_pad("one", "mouth", 0.5, -0.25)
        >>> scene.advance(0.0).characters["one"].frame.pads["mouth"].place
        (0.5, -0.25)
        """
        self._characters[self._present(character)].move_pad(self.find_pad(name), x, y, z=z)

    def find_pad(self, name: str) -> Pad:
        """The pad that a person means.

        Parameters
        ----------
        name : str
            As it is written, or in another case, with hyphens or underscores.

        Returns
        -------
        Pad
            One of `pads`.

        Raises
        ------
        ValueError
            Where none is meant.

        Examples
        --------
        >>> omote.Scene.begun(cast).find_pad("Moods").name
        'moods'
        """
        kept = self._pads.kept
        return kept[name] if name in kept else kept[find_name(name, kept, "pad", where="")]

    def follow_pads(self, first: ScenePads) -> None:
        """Keeps the pads of another scene of the same show from now on.

        Parameters
        ----------
        first : Scene
            Whose pads they are.

        Examples
        --------
        >>> scene, other = omote.Scene.begun(cast), omote.Scene.begun(cast)
        >>> scene.drop_pad("faces")
        >>> other.follow_pads(scene)
        >>> list(other.pads)
        ['moods', 'mouth']
        """
        if first._pads is not self._pads:
            self._wear_pads(first._pads, kept_pads.renamed_between(self._pads.kept, first._pads.kept))

    def _wear_pads(self, pads: Pads, renamed: Mapping[str, str] | None = None) -> None:
        self._pads = pads
        for character in self._characters.values():
            character.wear_pads(pads.kept, renamed)
