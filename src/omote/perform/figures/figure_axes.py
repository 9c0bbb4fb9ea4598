"""What is called of a figure: its pose, the poses of regions that go their own way, and its body."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from omote.model.body.pose import STAND
from omote.model.body.pose_regions import PoseRegion
from omote.perform import axis
from omote.perform.axis import Axis
from omote.perform.figures.tracked_body import TrackedBody, advance_body, tracked_pose
from omote.perform.frame import FigureFrame, with_fields
from omote.perform.layers.layer_names import LayerName
from omote.perform.mix import Weights, combine

FACES_OWN = "own"
"""In a mix of bodies: those of the faces on air, by their weights."""


@dataclass(frozen=True)
class FigureAxes:
    """pose: of the whole figure; regions: of those that go their own way; body: bodies and `FACES_OWN`; tracked: the
    body of a performer whom a source sees."""

    pose: Axis = field(default_factory=lambda: Axis(STAND))
    regions: Mapping[PoseRegion, Axis] = field(default_factory=dict)
    body: Axis = field(default_factory=lambda: Axis(FACES_OWN))
    tracked: TrackedBody | None = None


AT_REST = FigureAxes()


def advance_figure(
    figure: FigureAxes | None, dt: float, is_on: Callable[[LayerName], bool] = lambda _: True
) -> FigureAxes | None:
    """The figure `dt` seconds later; None where it has come to rest. is_on: whether a layer plays, by which a body is
    tracked."""
    if figure is None:
        return None
    pose = axis.advanced(figure.pose, dt)
    regions = axis.advance_regions(figure.regions, pose, dt) if figure.regions else figure.regions
    on = figure.tracked
    tracked = None if on is None else advance_body(on, dt, on=is_on(on.layer))
    later = with_fields(figure, pose=pose, regions=regions, body=axis.advanced(figure.body, dt), tracked=tracked)
    return None if later == AT_REST else later


def figure_frame(figure: FigureAxes) -> FigureFrame:
    """What the axes show now."""
    return FigureFrame(
        poses=axis.weights(figure.pose),
        regions={region: axis.weights(on) for region, on in figure.regions.items()},
        bodies=axis.weights(figure.body),
        pose_call=axis.status(figure.pose),
        region_calls={region: call for region, on in figure.regions.items() if (call := axis.status(on)) is not None},
        body_call=axis.status(figure.body),
        fader=figure.pose.hand,
        tracked=None if figure.tracked is None else tracked_pose(figure.tracked),
    )


def on_poses(figure: FigureAxes, change: Callable[[Axis], Axis]) -> FigureAxes:
    """A figure with its poses, of the whole and of regions, changed. change: of an axis."""
    regions = {region: change(on) for region, on in figure.regions.items()}
    return with_fields(figure, pose=change(figure.pose), regions=regions)


def on_all(figure: FigureAxes | None, change: Callable[[Axis], Axis]) -> FigureAxes | None:
    """A figure with all that is called of it changed; None where nothing was. change: of an axis."""
    return None if figure is None else with_fields(on_poses(figure, change), body=change(figure.body))


def halt_figure(figure: FigureAxes | None, seconds: float) -> FigureAxes | None:
    """The figure that comes to a stand where its speed carries it, within `seconds`."""
    return on_all(figure, lambda on: axis.halted(on, seconds))


def mixed_bodies(bodies: Weights, faces: Weights, known: Mapping[str, object]) -> dict[str, float]:
    """The mix of bodies by their own names.

    bodies: as of `FigureFrame`; faces: weights of those on air; known: bodies by name; a face without a body of its
    name wears the first.
    """
    first = next(iter(known))
    own = {name if name in known else first: 0.0 for name in faces}
    for name, weight in faces.items():
        own[name if name in known else first] += weight
    share = bodies.get(FACES_OWN, 0.0)
    apart = {name: weight for name, weight in bodies.items() if name != FACES_OWN}
    return combine(((share, own), (1.0, apart)))
