"""Fits heads that are no person's: they begin from sculpted ones, an animal from an animal, bent to its landmarks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Values
from omote.geometry.proximity import winding_numbers
from omote.model.fitting.doubt import Doubt
from omote.model.fitting.find_head import HeadPlacement, find_head
from omote.model.fitting.fit_face import Fit, Follow, find_mouth, fit_face, say_nothing
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.fitting.skin_repair import find_folds
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import measure_misfit
from omote.model.transfer.mouth_at_rest import fit_mouth_at_rest
from omote.model.transfer.mouth_bag import MouthBag, find_mouth_bag

# Landmarks that miss those of people by more, metres in the mean, are no person's: of 100 people of ICT-FaceKit with
# clicks off by 6 % of the eyes' distance 95 miss by less than 9.3 mm, animals by 12 and more. So many are asked for.
BEYOND = 0.010
FEWEST = 5
# How far around itself a landmark bends a head, metres, and how far it gives way to the others.
WIDTH = 0.06
SLACK = 0.02
# Of the points in a mouth each so manieth is looked at; they get so much smaller at a time, down to so much.
RARE = 4
SMALLER = 0.85
SMALLEST = 0.3
# What lies less deep in the mouth, metres along its skin, goes with the lips.
DEEP = 0.01


def fit_kinds(
    space: ParameterSpace, kinds: Mapping[str, IdentityModes], scan: Scan, place: HeadPlacement, *,
    landmarks: Mapping[str, ArrayLike] | None = None, name: str = "scan", shut: bool | None = None,
    follow: Follow | None = None,
) -> Fit:  # fmt: skip
    """Fits the generic head to a scan as `fit_face`; where landmarks are no person's, by the sculpted head that
    folds least.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    kinds : mapping of IdentityModes, by name
        People first, then sculpted heads.
    scan, place
        A scan, and where the first kind was found in it.
    landmarks, name, shut, follow
        As `fit_face`.

    Returns
    -------
    Fit
        With a doubt that names the kind where that is a sculpted one.

    Raises
    ------
    ValueError
        As `fit_face`.
    """
    marks = {mark: np.asarray(point, np.float64) for mark, point in (landmarks or {}).items()}
    (_, people), *others = kinds.items()
    if len(marks) >= FEWEST and measure_miss(space, people, marks) > BEYOND:
        fits = _fit_each(space, others, scan, marks, name, shut, follow or say_nothing)
        if fits:
            return min(fits, key=lambda outcome: outcome[:2])[2]
    return fit_face(space, people, scan, place.similarity, landmarks=landmarks, name=name, shut=shut, follow=follow)


def measure_miss(space: ParameterSpace, head: IdentityModes, landmarks: Mapping[str, Values], /) -> float:
    """How far landmarks (3,) by name are from a head's at their best place, metres in the mean.

    space: of the head; head: the kind; landmarks: in any unit.
    """
    rows = find_landmarks(space)
    return measure_misfit(np.array([*landmarks.values()]), head.skin[[rows[name] for name in landmarks]])


def bend_to_landmarks(space: ParameterSpace, head: IdentityModes, landmarks: Mapping[str, Values], /) -> IdentityModes:
    """The head with its skin and parts bent smoothly so that its landmarks lie near others, (3,) by name in its frame:
    Gaussians around them, regularized (Hastie et al. 2009, section 5.8).

    space: of the head; head: the kind; landmarks: metres.
    """
    rows = find_landmarks(space)
    at = head.skin[[rows[name] for name in landmarks]]
    goals = np.array([*landmarks.values()])

    def near(points: Values) -> Values:
        away = ((points[:, None] - at[None]) ** 2).sum(axis=2)
        return np.exp(-away / (2.0 * WIDTH**2))

    pulls = np.linalg.solve(near(at) + SLACK * np.eye(len(at)), goals - at)
    parts = {name: points + near(points) @ pulls for name, points in head.parts.items()}
    return replace(head, skin=head.skin + near(head.skin) @ pulls, parts=parts)


def _fit_each(
    space: ParameterSpace, kinds: Sequence[tuple[str, IdentityModes]], scan: Scan, marks: Mapping[str, Values],
    name: str, shut: bool | None, follow: Follow,
) -> list[tuple[int, float, Fit]]:  # fmt: skip
    """The fit of each kind that can be fitted, with its folded triangles and its distance in the median."""
    fits = []
    for at, (kind, head) in enumerate(kinds):
        try:
            fit = _fit_bent(space, head, scan, marks, name, shut, partial(_tell_part, follow, at, len(kinds)))
        except ValueError:
            continue
        folds = len(find_folds(space, head.skin, fit.face.positions.astype(np.float64)))
        doubt = Doubt(f"This is no person's head: it began from the cast's {kind}. Look whether all is in its place.")
        seen = fit.residual[np.isfinite(fit.residual)]
        away = float(np.median(seen)) if len(seen) else np.inf
        fits.append((folds, away, replace(fit, doubts=(doubt, *fit.doubts), kind=kind)))
    return fits


def _fit_bent(
    space: ParameterSpace, head: IdentityModes, scan: Scan, marks: Mapping[str, Values], name: str,
    shut: bool | None, follow: Follow,
) -> Fit:  # fmt: skip
    """The fit of one kind of head, bent to landmarks first."""
    placement = find_head(space, head, scan, landmarks=marks).similarity
    bent = bend_to_landmarks(space, head, {mark: placement(point) for mark, point in marks.items()})
    fit = fit_face(space, bent, scan, placement, landmarks=marks, name=name, shut=shut, follow=follow)
    return replace(fit, face=_fit_mouth(space, fit.face))


def _fit_mouth(space: ParameterSpace, face: Face) -> Face:
    """The face with tongue, teeth and mouth bag so much smaller that they lie inside of a muzzle, the mouth closed."""
    (names, around) = find_mouth(space)
    bag = find_mouth_bag(space)
    middle = face.positions[around].mean(axis=0)
    size = 1.0
    smaller = face
    while size > SMALLEST and (
        _is_outside(space, smaller, names, bag, RARE) or _is_outside(space, smaller, names, bag)
    ):
        size *= SMALLER
        parts = dict(face.parts) | {name: middle + size * (face.parts[name] - middle) for name in names}
        skin = face.positions.astype(np.float64)
        if bag is not None:
            share = (size + (1.0 - size) * np.exp(-bag.distance / DEEP))[:, None]
            skin[bag.vertices] = middle + share * (skin[bag.vertices] - middle)
        smaller = replace(face, positions=fit_mouth_at_rest(space, skin.astype(np.float32), parts), parts=parts)
    return smaller


def _is_outside(space: ParameterSpace, face: Face, names: Sequence[str], bag: MouthBag | None, every: int = 1) -> bool:
    """Whether parts or the bag of a face lie outside of its skin, by the winding numbers of one point of so many."""
    skin = face.positions.astype(np.float64)
    inner = [] if bag is None else [skin[bag.vertices[bag.distance > DEEP]]]
    probes = np.concatenate([*(face.parts[name].astype(np.float64) for name in names), *inner])[::every]
    return bool((winding_numbers(skin[space.location_triangles], probes) < 0.5).any())


def _tell_part(follow: Follow, at: int, count: int, done: float, what: str) -> None:
    """Progress of one of several fits."""
    follow((at + done) / count, what)
