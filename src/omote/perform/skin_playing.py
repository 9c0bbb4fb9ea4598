"""The part of a performer that has skin: blood, tears and sweat that follow its expressions, above all layers."""

from __future__ import annotations

from omote.perform.complexion import AS_IT_IS, advance_skin, complexion_of, is_at_rest, set_skin, with_skin
from omote.perform.frame import Frame, with_fields
from omote.perform.spring_playing import SpringPlaying


class SkinPlaying(SpringPlaying):
    """Plays blood, tears and sweat by what is on air."""

    def set_skin(self, name: str, amount: float) -> None:
        """Sets how much of the skin's folds, or of its blood, shows; what is on air follows, folds in half a second.

        Parameters
        ----------
        name : {"folds", "blood"}
            The folds that skin under pressure makes, or the flush and the pallor of expressions.
        amount : float
            0 (none) to 1.5; 1 at first.

        Raises
        ------
        ValueError
            On a fader that there is not, and on an amount out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_skin("blood", 0.0)
        >>> performer.call_expression("angry", seconds=0)
        >>> performer.advance(5.0).complexion.forehead
        0.0

        References
        ----------
        docs/method.md, "Blood, tears and sweat".
        """
        self._play(skin=set_skin(self._now.skin, name, amount))

    def _with_skin(self, frame: Frame, dt: float) -> Frame:
        """A frame with blood, tears and sweat, which go on by `dt` seconds. frame: all else that shows now."""
        skin = self._now.skin
        goal = complexion_of(self._cast.expressions, frame)
        if skin is None:
            if not any(goal):
                return frame
            skin = AS_IT_IS
        if dt > 0.0:
            skin = advance_skin(skin, goal, dt)
            self._now = with_fields(self._now, skin=None if is_at_rest(skin) and not any(goal) else skin)
        return with_skin(frame, skin)
