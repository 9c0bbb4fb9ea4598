"""Learns where landmarks lie on our skin and how they err: python -m tools.photographs.learn_landmarks FOLDER."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.builtin import LANDMARK_TABLE, load_cast, load_identity_modes
from omote.builtin.own_skin import find_skin_moves
from omote.geometry.proximity import nearest_triangles
from omote.inputs.camera.landmark_map import UNITS
from omote.model.fitting.photographs.bundle_problem import measure_errors
from omote.model.fitting.photographs.landmark_table import ON_SKIN
from tools.photographs.observations import Observation, read_observations
from tools.tracking.picture import turn

Values = NDArray[np.float64]
NODES = np.radians([-75.0, -50.0, -25.0, 0.0, 25.0, 50.0, 75.0])
FRONT = np.radians(35.0)
"""From views turned less than this is learned where points lie."""
BASIS = 120
PERSON = 40
"""How many directions errors have, and what is alike in all photographs of a person."""
RIDGE = 300.0
SURE = 0.95
"""So many photographs say nothing of how errors go with modes; what is alike is told from so few people that it is
taken a little smaller."""
FLOOR = 0.0004
"""Metres: no point is surer than that by itself."""


def find_places(observations: list[Observation]) -> tuple[NDArray[np.int32], Values]:
    """Of each landmark the corners (p, 3) and shares (p, 3) on the generic skin: medians of where it was seen."""
    front = np.array([each.lifted[:ON_SKIN] for each in observations if abs(each.camera.yaw) < FRONT])
    middle = np.nanmedian(front, axis=0).astype(np.float64)
    space = load_cast().space
    triangles = space.sheet_triangles
    corners = space.points[triangles]
    _, at = nearest_triangles(np.ascontiguousarray(corners), np.ascontiguousarray(middle))
    chosen = triangles[at]
    return chosen.astype(np.int32), barycentric(space.points[chosen], middle)


def barycentric(corners: Values, points: Values) -> Values:
    """Barycentric shares (p, 3) of the nearest points of triangles (p, 3, 3), none of them negative."""
    u, v, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], points - corners[:, 0]
    uu, uv, vv = (u * u).sum(1), (u * v).sum(1), (v * v).sum(1)
    area = uu * vv - uv * uv
    b = (vv * (w * u).sum(1) - uv * (w * v).sum(1)) / area
    c = (uu * (w * v).sum(1) - uv * (w * u).sum(1)) / area
    shares = np.maximum(np.column_stack([1.0 - b - c, b, c]), 0.0)
    result: Values = shares / shares.sum(axis=1, keepdims=True)
    return result


def find_errors(observations: list[Observation], corners: NDArray[np.int32], shares: Values) -> Values:
    """How far the landmarks of each photograph are off, (o, 2 p) metres."""
    rows = []
    for each in observations:
        places = np.einsum("pk,pkc->pc", shares, each.skin[corners].astype(np.float64))
        pixels = each.points[:ON_SKIN, :2].astype(np.float64) * each.camera.width
        rows.append(measure_errors(pixels, each.camera, places))
    return np.array(rows)


@dataclass(frozen=True, eq=False)
class Sample:
    """What errors are learned from: errors (o, 2 p) metres, weights of modes (o, m), turns (o,), whose (o,); how modes
    move the points of the generic head (m, p, 3)."""

    errors: Values
    modes: Values
    yaws: Values
    whose: NDArray[np.integer]
    moves: Values


def learn_errors(sample: Sample) -> dict[str, NDArray[np.floating]]:
    """The error's part of the table."""
    near = hats(sample.yaws)
    means = []
    slopes = []
    left = sample.errors.copy()
    for node, weight in enumerate(near.T):
        mean, slope = _regress(sample, NODES[node], weight)
        means.append(mean)
        slopes.append(slope)
        left -= weight[:, None] * (mean + sample.modes @ slope)
    rows = np.vstack([left, *np.array(means)[:, None], *np.array(slopes)])
    _, ways = np.linalg.eigh(rows.T @ rows)
    basis = np.ascontiguousarray(ways[:, ::-1][:, :BASIS])
    inside = left @ basis
    person = _persons(inside, near, sample.whose)
    shared = np.array([_whole(inside, weight) - part @ part.T for weight, part in zip(near.T, person, strict=True)])
    outside = left - inside @ basis.T
    return {
        "basis": basis.astype(np.float16), "mean": (np.array(means) @ basis).astype(np.float32),
        "slopes": np.einsum("nmi,ik->nkm", slopes, basis).astype(np.float16), "person": person.astype(np.float32),
        "shared": np.array([_positive(each) for each in shared]).astype(np.float32),
        "alone": (near.T @ outside**2 / near.sum(axis=0)[:, None] + FLOOR**2).astype(np.float32),
    }  # fmt: skip


def hats(yaws: Values) -> Values:
    """How near turns (o,) are to each node, (o, n); they sum to one."""
    at = np.interp(yaws, NODES, np.arange(len(NODES)))
    return np.maximum(1.0 - np.abs(at[:, None] - np.arange(len(NODES))), 0.0)


def _regress(sample: Sample, yaw: float, weight: Values) -> tuple[Values, Values]:
    """The mean error (2 p,), and how it goes with the modes (m, 2 p): towards what the landmark model knows by a share,
    one across the picture and one along it, and beside that by ridge regression."""
    turned = (sample.moves @ turn("y", yaw).T)[..., :2].reshape(len(sample.moves), -1)
    mean = weight @ sample.errors / weight.sum()
    off = sample.errors - mean
    shown = sample.modes @ turned
    slope = turned.copy()
    for axis in (slice(0, None, 2), slice(1, None, 2)):
        share = weight @ (off[:, axis] * shown[:, axis]).sum(axis=1) / (weight @ (shown[:, axis] ** 2).sum(axis=1))
        slope[:, axis] *= share
    matrix = (sample.modes.T * weight) @ sample.modes + RIDGE * np.eye(len(slope))
    return mean, slope + np.linalg.solve(matrix, (sample.modes.T * weight) @ (off - sample.modes @ slope))


def _whole(inside: Values, weight: Values) -> Values:
    result: Values = (inside.T * weight) @ inside / weight.sum()
    return result


def _persons(inside: Values, near: Values, whose: NDArray[np.integer]) -> Values:
    """What is alike in the errors (o, k) of one person's photographs, (n, k, q): principal directions of the covariance
    between different photographs of one person, over all nodes together."""
    count = near.shape[1]
    size = inside.shape[1]
    sums = np.zeros((count, size, count, size))
    pairs = np.zeros((count, count))
    for who in np.unique(whose):
        rows = whose == who
        spread = near[rows][:, :, None] * inside[rows][:, None]
        total = spread.sum(axis=0)
        sums += np.einsum("ik,jl->ikjl", total, total) - np.einsum("oik,ojl->ikjl", spread, spread)
        pairs += np.outer(near[rows].sum(axis=0), near[rows].sum(axis=0)) - near[rows].T @ near[rows]
    sums /= np.maximum(pairs, 1e-9)[:, None, :, None]
    sizes, ways = np.linalg.eigh(sums.reshape(count * size, -1))
    kept = slice(-PERSON, None)
    loadings: Values = (ways[:, kept] * np.sqrt(np.maximum(sizes[kept], 0.0)) * SURE).reshape(count, size, PERSON)
    return loadings


def _positive(matrix: Values) -> Values:
    """The nearest covariance to a symmetric matrix: no direction is surer than the floor."""
    sizes, ways = np.linalg.eigh(matrix)
    result: Values = (ways * np.maximum(sizes, FLOOR**2)) @ ways.T
    return result


def find_unit_moves(corners: NDArray[np.int32], shares: Values) -> Values:
    """How each unit moves the points on the generic head, (u, p, 3) metres."""
    moves = find_skin_moves(load_cast(), UNITS)
    return np.array([np.einsum("pk,pkc->pc", shares, move[corners]) for move in moves])


def learn(observations: list[Observation]) -> dict[str, NDArray[np.generic]]:
    """The arrays of the table."""
    corners, shares = find_places(observations)
    errors = find_errors(observations, corners, shares)
    good = np.abs(errors).max(axis=1) < FARTHEST
    print(f"{good.sum()} of {len(good)} photographs, {1000 * np.sqrt((errors[good] ** 2).mean()):.2f} mm")
    kept = [each for each, fine in zip(observations, good, strict=True) if fine]
    sample = Sample(
        errors[good], np.array([each.modes for each in kept]), np.array([each.camera.yaw for each in kept]),
        np.unique([each.whose for each in kept], axis=0, return_inverse=True)[1].ravel(),
        np.einsum("pk,mpkc->mpc", shares, load_identity_modes().moves[:, corners]),
    )  # fmt: skip
    return {
        "corners": corners, "shares": shares.astype(np.float32), "nodes": NODES,
        **learn_errors(sample),
        "unit_names": np.array(UNITS), "units": find_unit_moves(corners, shares).astype(np.float16),
    }  # fmt: skip


FARTHEST = 0.08
"""Metres: where a landmark is off by more, the model saw something else."""


def main() -> None:
    """Writes the table beside the built-in cast."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, default=LANDMARK_TABLE)
    asked = parser.parse_args()
    asked.out.parent.mkdir(parents=True, exist_ok=True)
    with asked.out.open("wb") as stream:
        np.savez_compressed(stream, allow_pickle=False, **learn(list(read_observations(asked.folder))))


if __name__ == "__main__":
    main()
