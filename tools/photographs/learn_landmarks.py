"""Learns where landmarks lie on our skin and how they err: python -m tools.photographs.learn_landmarks FOLDER."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.builtin import LANDMARK_TABLE, load_cast
from omote.geometry.proximity import nearest_triangles
from omote.inputs.camera.landmark_map import UNITS
from omote.model.fitting.photographs.landmark_table import ON_SKIN
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.fitting.photographs.view_errors import measure_errors
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame
from tools.photographs.observations import Observation, read_observations

Values = NDArray[np.float64]
NODES = np.radians([-75.0, -50.0, -25.0, 0.0, 25.0, 50.0, 75.0])
FRONT = np.radians(35.0)
"""From views turned less than this is learned where points lie."""
BASIS, RIDGE = 140, 30.0
"""How many directions errors have in common; so many people say nothing of how errors depend on modes."""
FLOOR = 0.0004
"""Metres: no point is surer than that by itself."""
PIECES = 8


def find_places(observations: list[Observation]) -> tuple[NDArray[np.int32], Values]:
    """Of each landmark the corners (p, 3) and shares (p, 3) on the generic skin: medians of where it was seen."""
    front = np.array([each.lifted[:ON_SKIN] for each in observations if abs(each.camera.yaw) < FRONT])
    middle = np.nanmedian(front, axis=0).astype(np.float64)
    space = load_cast().space
    triangles = space.sheet_triangles
    corners = space.points[triangles]
    _, at = nearest_triangles(np.ascontiguousarray(corners), np.ascontiguousarray(middle))
    chosen = triangles[at]
    return chosen.astype(np.int32), _shares(space.points[chosen], middle)


def _shares(corners: Values, points: Values) -> Values:
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
    """How far the landmarks of each photograph are off, (o, 3 p) metres."""
    rows = []
    for each in observations:
        places = np.einsum("pk,pkc->pc", shares, each.skin[corners].astype(np.float64))
        pixels = each.points[:ON_SKIN].astype(np.float64) * each.camera.width
        rows.append(measure_errors(pixels, each.camera, places))
    return np.array(rows)


def learn_errors(errors: Values, modes: Values, yaws: Values) -> dict[str, NDArray[np.floating]]:
    """The error's part of the table, from errors (o, 3 p), weights of modes (o, m) and turns (o,)."""
    middle = errors - errors.mean(axis=0)
    size, ways = np.linalg.eigh(middle.T @ middle / len(errors))
    basis = np.ascontiguousarray(ways[:, ::-1][:, :BASIS])
    inside = errors @ basis
    outside = errors - inside @ basis.T
    near = hats(yaws)
    means, slopes, shared, alone = [], [], [], []
    for weight in near.T:
        answer, left, count = _regress(inside, modes, weight)
        means.append(answer[0])
        slopes.append(answer[1:].T)
        shared.append((left.T * weight) @ left / count)
        alone.append((weight @ outside**2) / weight.sum() + FLOOR**2)
    return {
        "basis": basis.astype(np.float16), "mean": np.array(means, np.float32),
        "slopes": np.array(slopes).astype(np.float16), "shared": np.array(shared, np.float32),
        "alone": np.array(alone, np.float32),
    }  # fmt: skip


def hats(yaws: Values) -> Values:
    """How near turns (o,) are to each node, (o, n); they sum to one."""
    at = np.interp(yaws, NODES, np.arange(len(NODES)))
    return np.maximum(1.0 - np.abs(at[:, None] - np.arange(len(NODES))), 0.0)


def _regress(inside: Values, modes: Values, weight: Values) -> tuple[Values, Values, float]:
    """Weighted ridge regression of errors (o, k) on the modes (o, m): mean and slopes (1 + m, k), what is left (o, k),
    and how many photographs that stands for."""
    regressors = np.column_stack([np.ones(len(modes)), modes])
    penalty = np.diag([0.0, *np.full(modes.shape[1], RIDGE)])
    matrix = (regressors.T * weight) @ regressors
    answer = np.linalg.solve(matrix + penalty, (regressors.T * weight) @ inside)
    spent = np.trace(np.linalg.solve(matrix + penalty, matrix))
    count = weight.sum() ** 2 / (weight**2).sum()
    return answer, inside - regressors @ answer, float(weight.sum() * max(1.0 - spent / count, 0.2))


def find_unit_moves(corners: NDArray[np.int32], shares: Values) -> Values:
    """How each unit moves the points on the generic head, (u, p, 3) metres."""
    cast = load_cast()
    rest = evaluate(cast, Frame({"generic": 1.0}, {"neutral": 1.0}, {})).astype(np.float64)
    moves = []
    for name in UNITS:
        worn = evaluate(cast, Frame({"generic": 1.0}, {"neutral": 1.0}, {name: 1.0})).astype(np.float64)
        moves.append(np.einsum("pk,pkc->pc", shares, (worn - rest)[corners]))
    return np.array(moves)


def learn(observations: list[Observation]) -> dict[str, NDArray[np.generic]]:
    """The arrays of the table."""
    corners, shares = find_places(observations)
    errors = find_errors(observations, corners, shares)
    modes = np.array([each.modes for each in observations])
    yaws = np.array([each.camera.yaw for each in observations])
    good = np.abs(errors).max(axis=1) < FARTHEST
    print(f"{good.sum()} of {len(good)} photographs, {1000 * np.sqrt((errors[good] ** 2).mean()):.2f} mm")
    return {
        "corners": corners, "shares": shares.astype(np.float32), "nodes": NODES,
        **learn_errors(errors[good], modes[good], yaws[good]),
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
        np.savez_compressed(stream, allow_pickle=False, **learn(list(read_observations(asked.folder))))  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
