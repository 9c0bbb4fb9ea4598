"""Random people of ICT-FaceKit as they are photographed: their shape, our colours, their truth on our rows."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
from numpy.typing import NDArray

import omote
from benchmarks.scans.ict_people import SCLERA, read_model
from omote.builtin import load_cast, load_meshes
from omote.geometry import mesh
from omote.geometry.proximity import nearest_triangles
from omote.model.cast import Look
from omote.model.fitting.fit_face import Fit
from tools.photographs.learn_landmarks import barycentric
from tools.photographs.photographer import Model
from tools.photographs.sculpted_people import fit_ball, random_looks
from tools.tracking import rasterizer
from tools.tracking.picture import _colours, _meshes, _traits
from tools.tracking.random_people import Person

Values = NDArray[np.float64]
Rows = NDArray[np.int32]
WIDE = 0.08
"""A triangle wider than that on the texture lies across a seam."""
EYES = {"eye_left": rasterizer.EYE_LEFT, "eye_right": rasterizer.EYE_RIGHT}


@cache
def _mean_fit() -> tuple[Fit, Rows, Values]:
    """Their mean head as a face of ours, and where our vertices lie on it: corners (V, 3), shares (V, 3)."""
    model = read_model()
    fit = omote.fit(load_cast().space, model.points, model.skin, landmarks=model.clicks(model.points))
    head = fit.placement(model.points)
    ours = np.ascontiguousarray(fit.face.positions, np.float64)
    corners = model.skin[nearest_triangles(np.ascontiguousarray(head[model.skin]), ours)[1]]
    return fit, corners, barycentric(head[corners], ours)


@cache
def _drawing() -> tuple[NDArray[np.intp], Rows, Rows, NDArray[np.float32], NDArray[np.float32]]:
    """Of what is drawn: rows of their points (k,), triangles, materials, uv (k, 2) of ours, openness (k,)."""
    model = read_model()
    (fit, _, _) = _mean_fit()
    own = load_meshes()[0]
    balls = {kind: _within(model.triangles, SCLERA[name]) for name, kind in EYES.items()}
    triangles = np.concatenate([model.skin, *balls.values()])
    material = np.concatenate(
        [np.full(len(model.skin), rasterizer.SKIN), *(np.full(len(b), k) for k, b in balls.items())]
    )
    head = fit.placement(model.points)
    used = np.unique(model.skin)
    drawn = fit.face.positions.astype(np.float64)[own.source][own.triangles]
    at = nearest_triangles(np.ascontiguousarray(drawn), np.ascontiguousarray(head[used]))[1]
    shares = barycentric(drawn[at], head[used])
    uv = np.zeros((len(head), 2), np.float32)
    openness = np.ones(len(head), np.float32)
    uv[used] = np.einsum("vk,vkc->vc", shares, own.uv[own.triangles[at]])
    openness[used] = (shares * own.openness[own.triangles[at]] / 255.0).sum(axis=1)
    wide = np.flatnonzero((np.ptp(uv[triangles], axis=1).max(axis=1) > WIDE) & (material == rasterizer.SKIN))
    split = triangles[wide]  # each in a place of its own on the texture
    source = np.concatenate([np.arange(len(head)), split.ravel()])
    triangles = triangles.copy()
    triangles[wide] = len(head) + np.arange(3 * len(wide)).reshape(-1, 3)
    uv = np.concatenate([uv, np.repeat(uv[split[:, 0]], 3, axis=0)])
    return source, triangles.astype(np.int32), material.astype(np.int32), uv, openness[source]


def _within(triangles: Rows, rows: slice) -> Rows:
    chosen: Rows = triangles[((triangles >= rows.start) & (triangles < rows.stop)).all(axis=1)]
    return chosen


def ict_person(draw: np.random.Generator) -> tuple[Values, Callable[[dict[str, float], tuple[float, float]], Model]]:
    """Somebody of theirs, at rest: where our vertices lie on them (V, 3), and how to draw them."""
    model = read_model()
    (fit, corners, shares) = _mean_fit()
    weights = draw.standard_normal(len(model.modes))
    head = fit.placement(model.points + np.tensordot(weights, model.modes, 1))
    look = random_looks(draw)
    return np.einsum("vk,vkc->vc", shares, head[corners]), lambda _, gaze: _model(head, look, gaze)


def _model(head: Values, look: Look, gaze: tuple[float, float]) -> Model:
    source, triangles, material, uv, openness = _drawing()
    local = np.zeros(head.shape, np.float32)
    for rows in SCLERA.values():
        local[rows] = _on_ball(head[rows], gaze)
    normals = mesh.normals(head, read_model().triangles)[source].astype(np.float32)
    described = Person({}, None, look)  # type: ignore[arg-type]
    return Model(
        head[source], normals, triangles, material, uv, openness, local[source], _meshes().mask,
        _colours(described), _traits(described),
    )  # fmt: skip


def _on_ball(points: Values, gaze: tuple[float, float]) -> Values:
    """Where points of an eyeball lie on it, the line of sight along z."""
    off = points - fit_ball(points)
    yaw, pitch = gaze
    way = np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
    across = np.cross([0.0, 1.0, 0.0], way) / np.linalg.norm(np.cross([0.0, 1.0, 0.0], way))
    result: Values = (
        off / np.linalg.norm(off, axis=1, keepdims=True) @ np.column_stack([across, np.cross(way, across), way])
    )
    return result
