"""The part of a performer that pads play."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

from omote.model.body.pose import STAND
from omote.model.known_names import GENERIC, NEUTRAL, PLAY_REGIONS
from omote.perform import axis
from omote.perform.axis import Axis, call_regions
from omote.perform.called_mix import CalledMix
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import AT_REST, FigureAxes, on_poses
from omote.perform.frame import PadStatus, with_fields
from omote.perform.mappings.renamed_pads import mappings_after_rename
from omote.perform.pads.blend_space import Pad, PadPlace, fitted, mix_of_place
from omote.perform.pads.pad_point import FACE_SECONDS, FOLLOW_SECONDS, TAKE_UP_SECONDS
from omote.perform.snapshot import Snapshot

Region = TypeVar("Region", bound=str)
NO_PADS: Mapping[str, Pad] = {}


class PadPlaying(CalledMix):
    """Plays mixtures of looks by points that are moved among them."""

    _pads: Mapping[str, Pad] = NO_PADS

    def move_pad(self, pad: Pad, x: float | None, y: float | None = None, *, z: float | None = None) -> None:
        """Moves the point of a pad: what the pad plays shows the mixture of its looks there, without a jump.

        What shows makes way in a third of a second where something else has played it; from then on it follows the
        point. Who moves a pad or calls last has the part that it plays; a pad of the whole face that is taken up takes
        all regions with it, as a call does, and leaves alone those that are taken from it while it is moved on.

        Parameters
        ----------
        pad : Pad
            Whose point is moved. Looks that the cast does not have count as neutral, faces as generic.
        x, y, z : float, optional
            Where to, -1 to 1; what is not given stays where it is, at first in the middle.

        Raises
        ------
        ValueError
            On a number out of range, and on one of a dimension that the pad does not have.
        TypeError
            On what is no pad and no number.

        Examples
        --------
        >>> calm = omote.PadLook("Calm", {"neutral": 1.0}, (-1.0,))
        >>> glad = omote.PadLook("Glad", {"joy": 1.0}, (1.0,))
        >>> mood = omote.Pad("mood", "expression", 1, [calm, glad])
        >>> performer = omote.Performer(cast)
        >>> performer.move_pad(mood, 1.0)
        >>> dict(performer.advance(0.5).expressions)
        {'joy': 1.0}

        References
        ----------
        docs/method.md, "Pads".
        """
        if not isinstance(pad, Pad):
            raise TypeError(f"the pad is a {type(pad).__name__}; give an omote.Pad")
        place = pad.moved(self._now.pads.get(pad.name, ()), x, y, z)
        self._play(**self._moved(pad, place, TAKE_UP_SECONDS))

    def wear_pads(self, pads: Mapping[str, Pad], renamed: Mapping[str, str] | None = None) -> None:
        """Goes on with other pads: what they play follows them; what a pad has played that is gone stays as it is.

        Macros that move a pad follow it to another name.

        Parameters
        ----------
        pads : mapping of Pad
            All that there are, by name.
        renamed : mapping of str, optional
            What pads were called before, with what they are called now.

        Examples
        --------
        >>> calm = omote.PadLook("Calm", {"neutral": 1.0}, (-1.0,))
        >>> glad = omote.PadLook("Glad", {"joy": 1.0}, (1.0,))
        >>> performer = omote.Performer(cast)
        >>> performer.move_pad(omote.Pad("mood", "expression", 1, [calm, glad]), 1.0)
        >>> performer.wear_pads({})
        >>> frame = performer.advance(0.5)
        >>> dict(frame.expressions), dict(frame.pads)
        ({'joy': 1.0}, {})
        """
        self._pads = pads
        names = renamed or {}
        if names:
            self._rename_in_mappings(names)
        now = self._now
        if not now.pads:
            return
        places = {names.get(name, name): place for name, place in now.pads.items()}

        def worn(where: str, on: Axis) -> Axis:
            if on.point is None:
                return on
            pad = pads.get(names.get(on.point.pad, on.point.pad))
            if pad is None or where not in (pad.part, *(PLAY_REGIONS if pad.part == "expression" else ())):
                return axis.let_go(on, TAKE_UP_SECONDS)
            place = fitted(on.point.place, pad.dimensions)
            return axis.replayed(on, pad.name, place, self._mix(pad, place))

        self._now = with_fields(
            now,
            pads={name: fitted(place, pads[name].dimensions) for name, place in places.items() if name in pads},
            face=worn("face", now.face),
            expression=worn("expression", now.expression),
            regions={region: worn(region, on) for region, on in now.regions.items()},
            figure=now.figure and on_poses(now.figure, lambda on: worn("pose", on)),
        )

    def _rename_in_mappings(self, renamed: Mapping[str, str]) -> None:
        """Mappings follow pads that have other names."""
        self._now = with_fields(self._now, mappings=mappings_after_rename(self._now.mappings, renamed))

    def _moved(
        self,
        pad: Pad,
        place: PadPlace,
        seconds: float,
        easing: str = DEFAULT_EASING,
        pace: float | None = None,
        *,
        along: bool = False,
    ) -> dict[str, object]:
        """What changes of a performer where the point of a pad is moved to a place.

        seconds: in which what shows makes way, where another plays it; 0 cuts in any case; easing, pace: of that call;
        along: whether a pad of the whole face takes all regions along, though it plays already.
        """
        now = self._now
        mix = self._mix(pad, place)
        pads = {**now.pads, pad.name: place}
        follow = FACE_SECONDS if pad.part == "face" else FOLLOW_SECONDS

        def play(on: Axis) -> Axis:
            after = axis.played(on, pad.name, place, mix, seconds, easing, follow)
            return after if pace is None or after.call is on.call else axis.with_pace(after, pace)

        if pad.part == "face":
            return {"pads": pads, "face": play(now.face)}
        if pad.part == "expression":
            takes = along or now.expression.point is None or now.expression.point.pad != pad.name
            regions = call_regions(now.regions, now.expression, play) if takes else _played(now.regions, pad.name, play)
            return {"pads": pads, "expression": play(now.expression), "regions": regions}
        if pad.part == "pose":
            return {"pads": pads, "figure": self._posed(pad.name, play, along=along)}
        region = pad.part
        return {"pads": pads, "regions": {**now.regions, region: play(now.regions.get(region, now.expression))}}

    def _posed(self, pad: str, play: Callable[[Axis], Axis], *, along: bool) -> FigureAxes:
        """The figure where the point of a pad of poses is moved: taken up, it takes all regions along. pad: its name;
        play, along: as of `_moved`."""
        here = self._now.figure or AT_REST
        takes = along or here.pose.point is None or here.pose.point.pad != pad
        regions = call_regions(here.regions, here.pose, play) if takes else _played(here.regions, pad, play)
        return with_fields(here, pose=play(here.pose), regions=regions)

    def _mix(self, pad: Pad, place: PadPlace) -> dict[str, float]:
        """What a pad shows at a place, of what the cast has."""
        if pad.part == "face":
            return mix_of_place(pad, place, self._cast.faces, instead=GENERIC)
        if pad.part == "pose":
            return mix_of_place(pad, place, self._cast.poses, instead=STAND)
        return mix_of_place(pad, place, self._cast.expressions, instead=NEUTRAL)

    def _pad_statuses(self) -> dict[str, PadStatus]:
        """The points that have been moved, by pad."""
        now = self._now
        if not now.pads:
            return {}
        playing = {on.point.pad for on in axes_of_pads(now) if on.point is not None}
        return {name: PadStatus(place, name in playing) for name, place in now.pads.items()}


def axes_of_pads(now: Snapshot) -> Iterable[Axis]:
    """All of a performer that pads can play. now: as it is."""
    figure = () if now.figure is None else (now.figure.pose, *now.figure.regions.values())
    return (now.face, now.expression, *now.regions.values(), *figure)


def _played(regions: Mapping[Region, Axis], pad: str, play: Callable[[Axis], Axis]) -> Mapping[Region, Axis]:
    """The regions where a pad of the whole is moved on: those that it plays go with it. play: what moves one."""
    return {region: play(on) if on.point is not None and on.point.pad == pad else on for region, on in regions.items()}
