"""Correctives for the stages: one document per space and an allowance per compound (`perform.blending.correctives`)."""

from __future__ import annotations

import numpy as np

from omote.arrays import Floats, Indices
from omote.geometry.orientation import FULL, LEAST_SLOPE, OVER_RELAXATION
from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.corrective_regions import CorrectiveRegions, Crossing, find_corrective_regions
from omote.perform.blending.correctives import (
    BULGE,
    CORNEA,
    DEEP,
    FARTHEST,
    FLOOR,
    KEPT,
    LEAST_AREA,
    MARGIN,
    MOMENTUM,
    ROUNDS,
    SLIVER,
    Eyeballs,
    measure_allowance,
)
from omote.show.cast_documents import AllowanceDocument, CorrectivesDocument, CrossingDocument
from omote.show.wire import le_bytes


def correctives_document(cast: Cast, starts: dict[str, int]) -> CorrectivesDocument | None:
    """What the stages correct of a cast's faces, in rows of all positions; starts: the first row of each part, by name.

    None where the cast's space has no corrective regions.
    """
    regions = find_corrective_regions(cast.space)
    if regions is None:
        return None
    followers, anchors, weights = _followers(cast, regions, starts)
    patches = regions.patches
    return CorrectivesDocument(
        rounds=list(ROUNDS), least_area=LEAST_AREA, floor=FLOOR, over_relaxation=OVER_RELAXATION,
        least_slope=LEAST_SLOPE, full=FULL,
        momentum=MOMENTUM, margin=MARGIN, farthest=FARTHEST, bulge=BULGE, cornea=CORNEA,
        deep=DEEP, kept=KEPT, sliver=SLIVER,
        rows=le_bytes(regions.rows, "<u4"),
        triangles=le_bytes(regions.triangles, "<u4"),
        crossings=[_crossing(crossing) for crossing in regions.crossings],
        lids=le_bytes(regions.lids, "<u4"), eye=le_bytes(regions.eye, "<u4"),
        patch_triangles=le_bytes(patches.triangles, "<u4"), patch_ends=le_bytes(patches.ends, "<u4"),
        row_patches=le_bytes(patches.members, "<u4"), row_shares=le_bytes(patches.shares, "<f4"),
        followers=le_bytes(followers, "<u4"), anchors=le_bytes(anchors, "<u4"), weights=le_bytes(weights, "<f4"),
    )  # fmt: skip


def _crossing(crossing: Crossing) -> CrossingDocument:
    return CrossingDocument(
        upward=crossing.kind == "lips",
        vertices=le_bytes(crossing.vertices, "<u4"), weights=le_bytes(crossing.weights, "<f4"),
        near=le_bytes(crossing.near, "<u4"), side=le_bytes(crossing.side, "<f4"), share=le_bytes(crossing.share, "<f4"),
    )  # fmt: skip


def _followers(cast: Cast, regions: CorrectiveRegions, starts: dict[str, int]) -> tuple[Indices, Indices, Floats]:
    """Rows, anchors and weights of inner skin and of the attached parts, the anchors in places of the regions."""
    place = np.full(cast.space.vertex_count, -1)
    place[regions.rows] = np.arange(len(regions.rows))
    rows = [regions.followers]
    anchors = [regions.anchors]
    weights = [regions.weights]
    width = regions.anchors.shape[1]
    for name in regions.attached_parts:
        part = cast.space.parts[name]
        own = place[part.anchors]
        share = np.where(own >= 0, part.weights, 0.0)
        short = ((0, 0), (0, width - share.shape[1]))
        hangs = share.any(axis=1)
        rows.append((starts[name] + np.flatnonzero(hangs)).astype(np.int32))
        anchors.append(np.pad(np.maximum(own, 0), short)[hangs].astype(np.int32))
        weights.append(np.pad(share, short)[hangs].astype(np.float32))
    return np.concatenate(rows), np.concatenate(anchors), np.concatenate(weights)


def allowance_document(
    space: ParameterSpace, face: Face, expression: Expression, skin: Floats
) -> AllowanceDocument | None:
    """What one compound uses up by itself; None where the space has no corrective regions.

    face, expression: of the space; skin (V, 3): the face wearing the expression, metres.
    """
    regions = find_corrective_regions(space)
    if regions is None:
        return None
    allowed = measure_allowance(regions, fit(space, face), expression, skin)
    places = np.flatnonzero(allowed)
    return AllowanceDocument(places=le_bytes(places, "<u4"), values=le_bytes(allowed[places], "<f4"))


def ball_radii(space: ParameterSpace, face: Face) -> tuple[float, float]:
    """The radii of the eyeballs of a face on a space, left and right, metres; zero where there is none."""
    regions = find_corrective_regions(space)
    if regions is None or len(regions.eyes) != 2:
        return 0.0, 0.0
    left, right = Eyeballs.of(fit(space, face), regions.eyes, np.zeros((2, 2))).radii.tolist()
    return left, right
