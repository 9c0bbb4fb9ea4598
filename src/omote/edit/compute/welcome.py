"""Builds the welcome message to editors: muscles, regions, follower weights of a cast; and the handles of its faces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Rows, Values
from omote.edit.protocol.messages import EDITING_VERSION, Greeted, HandlesAsset, MuscleDocument
from omote.interchange.exports.export_formats import unwritable_kinds
from omote.model.cast import Cast
from omote.model.controls.face_muscles import muscle_fields, muscles
from omote.model.recipes.face_handles import default_handles
from omote.model.space.head_regions import REGIONS, region_weights
from omote.model.space.parameter_space import ParameterSpace
from omote.show.wire import le_bytes


def handles_asset(space: ParameterSpace, /) -> HandlesAsset:
    """The handles of a head by feature; pages compute their effect on a face themselves (warp.ts)."""
    handles = default_handles(space)
    return HandlesAsset(
        points=[handle.row for handle in handles],
        labels=[handle.label for handle in handles],
        mirror=[handle.mirror for handle in handles],
    )


def build_welcome(cast: Cast, /) -> Greeted:
    """Builds the answer to `greet`, still without show, items and drafts; ValueError where the head has no two eyes."""
    rows, anchors, shares = followers(cast.space)
    weights = region_weights(cast.space)
    return Greeted(
        version=EDITING_VERSION,
        digest=cast.digest,
        show="",
        muscles=muscle_documents(cast.space),
        regions=list(REGIONS),
        masks=b"".join(le_bytes(np.rint(255 * weights[region]), "u1") for region in REGIONS),
        followers=le_bytes(rows, "<u4"),
        anchors=le_bytes(anchors, "<u4"),
        shares=le_bytes(shares, "<f4"),
        items=[],
        unsaved=[],
        unwritable={kind.removeprefix("."): why for kind, why in unwritable_kinds().items()},
    )


def muscle_documents(space: ParameterSpace, /) -> list[MuscleDocument]:
    """Serializes the muscles for pages."""
    fields = muscle_fields(space)
    return [
        MuscleDocument(name, muscle.label, muscle.kind, list(muscle.rows), le_bytes(fields[name], "<f4"))
        for name, muscle in muscles(space).items()
    ]


def followers(space: ParameterSpace, /) -> tuple[Rows, Rows, Values]:
    """The rows (f,) of inner skin and parts (as in the manifest: skin, then parts) that move with the sheet, the k
    vertices of the skin that move each (f, k), and how much of each one's way it goes (f, k); unused ones weigh
    nothing. Where an anchor is inner skin itself, its own anchors stand for it."""
    inner = space.inner
    groups: list[tuple[Rows, Rows, Values]] = [
        (inner.vertices.astype(np.int64), inner.anchors.astype(np.int64), inner.weights.astype(np.float64))
    ]
    first = space.vertex_count
    for part in space.parts.values():
        moved = part.weights.any(axis=1)
        rows = np.asarray(first + np.flatnonzero(moved), np.int64)
        groups.append((rows, *_on_sheet(space, part.anchors[moved], part.weights[moved])))
        first += len(part.points)
    most = max(anchors.shape[1] for _, anchors, _ in groups)
    return (
        np.concatenate([rows for rows, _, _ in groups]),
        np.concatenate([_pad(anchors.astype(np.int64), most) for _, anchors, _ in groups]),
        np.concatenate([_pad(shares, most) for _, _, shares in groups]),
    )


def _on_sheet(space: ParameterSpace, anchors: NDArray[np.int32], weights: Values) -> tuple[Rows, Values]:
    """Anchors (n, k) that lie on the sheet, inner ones replaced by theirs: (n, k * 10) where there is such a one."""
    if space.on_sheet[anchors].all():
        return anchors.astype(np.int64), weights
    theirs = space.inner.anchors.shape[1]
    own = np.tile(np.arange(space.vertex_count)[:, None], (1, theirs))
    share = np.zeros((space.vertex_count, theirs))
    share[:, 0] = 1.0
    own[space.inner.vertices] = space.inner.anchors
    share[space.inner.vertices] = space.inner.weights
    count = len(anchors)
    return own[anchors].reshape(count, -1), (weights[..., None] * share[anchors]).reshape(count, -1)


def _pad(table: NDArray[np.generic], most: int) -> NDArray[np.generic]:
    return np.pad(table, ((0, 0), (0, most - table.shape[1])))
