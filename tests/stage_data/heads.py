"""What tests of exchange share: the synthetic cast's meshes and a picture of its skin's layers."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from omote.builtin import BakedMesh
from omote.interchange.export_face import ExportContext
from omote.interchange.formats.png import png_bytes
from omote.interchange.skin_texture import LAYERS
from omote.model.cast import Cast
from omote.model.space.expression import Title
from tests import synthetic

SIZE = 16


@cache
def meshes() -> tuple[BakedMesh, ...]:
    """The synthetic head's meshes; the skin's first vertex is split in two, as at a seam."""
    space = synthetic.space()
    source = np.append(np.arange(space.vertex_count), 0).astype(np.int32)
    triangles = space.triangles.copy()
    triangles[np.flatnonzero((triangles == 0).any(axis=1))[0]][triangles[0] == 0] = len(source) - 1
    place = np.stack([(space.theta + np.pi) / (2 * np.pi), (space.h - space.h.min()) / np.ptp(space.h)], axis=1)
    skin = BakedMesh(
        "skin", source, np.clip(place, 0, 1)[source].astype(np.float32), triangles, np.full(len(source), 255, np.uint8)
    )
    parts = [
        BakedMesh(name, np.arange(len(part.points), dtype=np.int32), np.zeros((len(part.points), 2), np.float32),
                  part.triangles, np.full(len(part.points), 255, np.uint8))
        for name, part in space.parts.items()
    ]  # fmt: skip
    return skin, *parts


def layers() -> bytes:
    """The skin's layers, nothing painted."""
    picture = np.zeros((len(LAYERS) * SIZE, SIZE, 4), np.uint8)
    picture[:, :, 3] = 128
    picture[:SIZE, :, 3] = 255
    return png_bytes(picture)


@cache
def synthetic_cast() -> Cast:
    """The synthetic cast with kinds of expressions."""
    cast = synthetic.cast()
    titles = {name: replace(title, kind="arkit") for name, title in cast.titles.items()}
    return replace(
        cast, titles={**titles, "neutral": Title("neutral", "neutral"), "smile": Title("Smile", "performed")}
    )


def context() -> ExportContext:
    """What exports of the synthetic cast share."""
    return ExportContext(synthetic_cast(), meshes(), layers())
