"""The performer's body from a camera: points in, smoothed bones of a humanoid out, each region as far as it is seen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.body_points import BodyPoints
from omote.inputs.camera.one_euro import LONGEST_GAP, OneEuroFilter, Smoothing
from omote.inputs.camera.solve_body import BodyRest, measure_rest, solve_body
from omote.model.body.pose_regions import PoseRegion

REST_SECONDS = 2.0
"""Of a body that is seen, from which it is known how its performer is at rest."""
FEWEST = 5
"""Pictures that this is measured from."""
FADE = 0.35
"""Seconds within which a region that comes or goes is believed: one picture without an elbow is not."""
CALM = Smoothing(calm=1.2, lively=8.0, slope=1.5)
"""Of points, in metres: depth, which a single camera guesses, shakes more than a face. Points are filtered, not bones:
an arm that is nearly straight makes a large turn of a small error."""
PLACES = [0, 1, 2, 4, 5]
VISIBLE = 3
"""Of a point's numbers."""
GONE = 0.002
"""A share below is none."""


@dataclass(frozen=True, eq=False)
class BodyReading:
    """What is tracked of a body now. bones: quaternions (4,), x, y, z, w, against the bone above from the T-pose, by
    VRM's names; shares: how far each region is seen, 0..1: none, where nothing is. time: seconds of the page's
    clock."""

    bones: Mapping[str, Values]
    shares: Mapping[PoseRegion, float]
    time: float


class BodyTracker:
    """Follows one performer; the first two seconds that a body is seen are taken as how it is at rest."""

    def __init__(self, rest: BodyRest | None = None, smoothing: Smoothing = CALM) -> None:
        self.rest = rest
        self._seen: list[BodyPoints] = []
        self._filter = OneEuroFilter(smoothing)
        self._places: Values | None = None
        self._bones: dict[str, Values] = {}
        self._shares: dict[PoseRegion, float] = {}
        self._time: float | None = None

    def measure_again(self) -> None:
        """Forgets how the performer is at rest: the next two seconds say it."""
        self.rest = None
        self._seen = []

    def step(self, frame: BodyPoints) -> BodyReading:
        """What a frame shows.

        Parameters
        ----------
        frame : BodyPoints
            The newest, later than those before.

        Returns
        -------
        BodyReading
            Bones keep the last that was seen of them while their region fades to what is called.
        """
        smooth = self._smooth(frame)
        if self.rest is None:
            self._wait(smooth)
        gap = 0.0 if self._time is None else min(max(frame.time - self._time, 0.0), LONGEST_GAP)
        self._time = frame.time
        wanted: dict[PoseRegion, float] = {"trunk": 0.0, "arm_left": 0.0, "arm_right": 0.0}
        if self.rest is not None:
            solved = solve_body(smooth, self.rest)
            wanted = {"trunk": solved.trunk, "arm_left": solved.left, "arm_right": solved.right}
            self._bones |= solved.bones
        step = 1.0 - np.exp(-3.0 * gap / FADE)
        for region, share in wanted.items():
            before = self._shares.get(region, 0.0)
            self._shares[region] = before + float(step) * (share - before)
        shares = {region: share for region, share in self._shares.items() if share > GONE}
        return BodyReading(self._bones.copy() if shares else {}, shares, frame.time)

    def _smooth(self, frame: BodyPoints) -> BodyPoints:
        """A frame whose points are filtered; one that says nothing stays where it was."""
        if frame.values is None:
            self._filter.reset()
            self._places = None
            return frame
        places = frame.values[:, PLACES].astype(np.float64)
        if self._places is not None:
            lost = frame.values[:, VISIBLE] == 0.0
            places[lost] = self._places[lost]
        self._places = self._filter.follow(places.ravel(), frame.time).reshape(places.shape)
        values = frame.values.copy()
        values[:, PLACES] = self._places
        return BodyPoints(values, frame.width, frame.height, frame.time)

    def _wait(self, frame: BodyPoints) -> None:
        """Takes the first seconds as how the performer is at rest."""
        if self._seen and frame.time < self._seen[0].time:
            self._seen.clear()
        if frame.found:
            self._seen.append(frame)
        if self._seen and frame.time - self._seen[0].time >= REST_SECONDS and len(self._seen) >= FEWEST:
            self.rest = measure_rest(self._seen)
            self._seen.clear()
