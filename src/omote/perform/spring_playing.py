"""The part of a performer that has springs: what hangs and shakes of its faces, above all layers."""

from __future__ import annotations

from omote.perform.frame import Frame, Held, with_fields
from omote.perform.macro_playing import MacroPlaying
from omote.perform.springs.cast_springs import springs_of
from omote.perform.springs.springs import AT_HOME, AT_REST, Travel, advance_springs, set_amount, with_springs


class SpringPlaying(MacroPlaying):
    """Plays the springs of the cast by the motion of the head."""

    def set_spring(self, name: str, amount: float) -> None:
        """Sets how much of a spring shows, beside the liveliness: what is on air follows within half a second.

        Springs move ears, jowls and cheeks of the faces that have such, by how head and body move. Their amounts are
        multiplied by twice the liveliness (`set_motion`): a character that holds still has none.

        Parameters
        ----------
        name : {"ears-sway", "ears-flap", "jowls-sway", "cheeks-bounce"}
            Which.
        amount : float
            0 (none) to 2; 1 at first.

        Raises
        ------
        ValueError
            On a spring that there is not, and on an amount out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_face("dog", seconds=0)
        >>> performer.set_motion(0.5)
        >>> performer.set_spring("ears-sway", 0.5)
        >>> dict(performer.advance(1 / 60).springs)
        {'ears-sway': 0.5}

        References
        ----------
        docs/method.md, "Springs".
        """
        self._play(springs=set_amount(self._now.springs or AT_REST, name, amount))

    def _with_springs(self, frame: Frame, dt: float, held: Held) -> Frame:
        """A frame with what springs add, which go on by `dt` seconds. frame: all else that shows now; held: what
        hands hold."""
        now = self._now
        scale = 0.0 if now.motion is None else 2.0 * now.motion.acting.liveliness
        springs = now.springs
        if springs is None:
            if not scale:
                return frame
            springs = AT_REST
        known = springs_of(self._cast.expressions)
        if dt > 0.0 and (scale or springs.moving):
            springs = advance_springs(springs, known, frame, self._find_travel(), scale, dt)
            self._now = with_fields(now, springs=springs)
        return with_springs(frame, springs, known, self._cast.expressions, held)

    def _find_travel(self) -> Travel:
        """Where the body is; a performer that is in no scene stays."""
        return AT_HOME
