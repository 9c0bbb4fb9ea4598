"""Shapes of heads with other triangles come back as the expressions that they were; what is none is said."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry import mesh
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.scan import Scan
from omote.model.fitting.take_expressions import TakenExpressions
from tests.model.fitting.retriangulated import retriangulate

CAST = omote.load_cast()
SPACE = CAST.space
OLD = CAST.faces["old"]
FACE = head_zones(CAST.space).face
NAMES = ("jawOpen", "mouthSmileLeft", "eyeBlinkRight", "mouthPucker")
WORN = {name: omote.compound(SPACE, OLD, CAST.expressions[name]).astype(float) - OLD.positions for name in NAMES}
ODD = {
    "nothing": np.zeros((SPACE.vertex_count, 3)),
    "far away": np.tile([0.0, 0.2, 0.0], (SPACE.vertex_count, 1)),
    "fat": 0.1 * OLD.positions.astype(float),
}


@pytest.fixture(scope="module")
def scan() -> Scan:
    """Old's head in another topology, with four expressions and three shapes that are none."""
    return retriangulate(SPACE, OLD, {**WORN, **ODD})


@pytest.fixture(scope="module")
def fitted(scan: Scan) -> Fit:
    """The face that is found in it."""
    return omote.fit(SPACE, scan.positions, scan.triangles, name="stranger")


@pytest.fixture(scope="module")
def taken(scan: Scan, fitted: Fit) -> TakenExpressions:
    """What its shapes are."""
    return omote.take_expressions(SPACE, fitted, scan)


@pytest.mark.parametrize("name", NAMES)
def test_the_fitted_face_does_what_the_stranger_does(name: str, fitted: Fit, taken: TakenExpressions) -> None:
    skin = fitted.face.positions.astype(float)
    worn = omote.compound(SPACE, fitted.face, taken.expressions[name]) - skin
    off = np.linalg.norm(worn - WORN[name], axis=1)[FACE]
    far = np.linalg.norm(WORN[name], axis=1)[FACE]
    assert np.linalg.norm(off) < 0.25 * np.linalg.norm(far)  # vertices of a fit lie millimetres beside the stranger's
    assert np.median(off[far > 0.2 * far.max()]) < 0.1 * far.max()


@pytest.mark.parametrize("name", NAMES)
def test_others_wear_it_as_the_cast_s_own(name: str, taken: TakenExpressions) -> None:
    kaori = CAST.faces["kaori"]
    mine, own = (
        omote.compound(SPACE, kaori, each).astype(float) - kaori.positions
        for each in (taken.expressions[name], CAST.expressions[name])
    )
    cosine = (mine * own)[FACE].sum() / (np.linalg.norm(mine[FACE]) * np.linalg.norm(own[FACE]))
    assert cosine > 0.95


def test_lids_that_meet_meet_on_a_face_whose_lids_lie_beside_the_scan_s(fitted: Fit, scan: Scan) -> None:
    wide = omote.compound(SPACE, fitted.face, CAST.expressions["eyeWideRight"])
    beside = replace(fitted, face=replace(fitted.face, positions=wide))
    blink = omote.take_expressions(SPACE, beside, replace(scan, shapes={"wink": scan.shapes["eyeBlinkRight"]}))
    line = next(line for line in SPACE.lines if line.name == "lid_right")
    for face in (beside.face, CAST.faces["kaori"]):
        rungs = line.rungs(face.positions.astype(float))
        now = line.rungs(omote.compound(SPACE, face, blink.expressions["wink"]).astype(float))
        opening = (rungs * now).sum(axis=1) / np.linalg.norm(rungs, axis=1)
        fifths = [part.sum() for part in np.array_split(opening, 5)]
        assert (
            np.max(np.divide(fifths, [np.linalg.norm(part, axis=1).sum() for part in np.array_split(rungs, 5)])) < 0.05
        )
    assert not blink.notes


def test_what_is_no_expression_is_left_out_and_said(taken: TakenExpressions) -> None:
    assert set(taken.expressions) == set(NAMES)
    said = " ".join(taken.notes)
    assert "'nothing' moves nothing of the face" in said
    assert "'far away' moves the face by 20 cm" in said
    assert "'fat' moves the skull" in said


def test_eyeballs_that_turn_turn_ours(scan: Scan, fitted: Fit) -> None:
    placed = fitted.placement(scan.positions)
    labels = mesh.components(np.asarray(scan.triangles), len(scan.positions))
    middle = fitted.face.parts["eye_left"].mean(axis=0)
    near = np.linalg.norm(placed - middle, axis=1) < 0.018
    ball = np.isin(labels, [label for label in np.unique(labels[near]) if near[labels == label].all()])
    assert 72 <= ball.sum() < 300
    turned = (placed - middle) @ look_left(0.3).T + middle - placed
    moves = np.where(ball[:, None], turned, 0.0) @ fitted.placement.rotation / fitted.placement.scale
    looking = omote.take_expressions(SPACE, fitted, replace(scan, shapes={"look": moves}))
    assert np.degrees(looking.expressions["look"].eyes[0]) == pytest.approx([np.degrees(0.3), 0.0], abs=1.0)
    assert np.degrees(looking.expressions["look"].eyes[1]) == pytest.approx([0.0, 0.0], abs=0.1)


def look_left(yaw: float) -> NDArray[np.float64]:
    """A turn to the left."""
    return np.array([[np.cos(yaw), 0.0, np.sin(yaw)], [0.0, 1.0, 0.0], [-np.sin(yaw), 0.0, np.cos(yaw)]])


def test_progress_is_told_from_nothing_to_done(scan: Scan, fitted: Fit) -> None:
    told = list[tuple[float, str]]()
    few = replace(scan, shapes={name: scan.shapes[name] for name in NAMES[:2]})
    omote.take_expressions(SPACE, fitted, few, follow=lambda done, what: told.append((done, what)))
    assert told == [(0.0, NAMES[0]), (0.5, NAMES[1]), (1.0, "done")]


def test_a_cloud_and_a_head_without_shapes_are_refused(scan: Scan, fitted: Fit) -> None:
    with pytest.raises(ValueError, match="the scan is a cloud of points; expected triangles"):
        omote.take_expressions(SPACE, fitted, replace(scan, triangles=None))
    with pytest.raises(ValueError, match="the scan has no shapes"):
        omote.take_expressions(SPACE, fitted, replace(scan, shapes={}))
