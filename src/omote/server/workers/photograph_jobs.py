"""The job of photographs that a page brings: with the landmarks that the page found they become a face for a look.

The fitted face lies in the preview's folder as a scan's does, and is taken by the same job (`scan_jobs.TakeScan`).
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast, load_mask, load_meshes
from omote.builtin.own_face import fit_photographs
from omote.edit.compute.photograph_preview import colour_skin, texels_at
from omote.edit.protocol.messages import PhotographPreview
from omote.interchange.formats.png import read_png
from omote.interchange.photograph_look import suggest_photograph_look
from omote.interchange.skin_texture import Canvas, build_canvas, paint_skin
from omote.model.cast import Cast, Look
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_fit import PhotographFit
from omote.server.sandbox.scan_files import read_picture_in_sandbox
from omote.server.workers.job_server import Follow
from omote.server.workers.scan_jobs import FACE, FILES, ORIGIN
from omote.show.wire import le_bytes
from omote.showfile.contents import pack_face
from omote.stage_data.assets import rest_positions

READ, FITTED, WORN = 20, 60, 97
"""Parts of a hundred of the whole that are done by then."""


class SeenPhotograph(msgspec.Struct, frozen=True):
    """A photograph in a preview's folder as the page saw it: its file there, its name on the desk, its size in pixels,
    and landmarks (478 of x, y and depth, in parts of its width, height and width)."""

    file: str
    name: str
    width: int
    height: int
    points: list[tuple[float, float, float]]


class FitPhotographs(msgspec.Struct, frozen=True, tag=True):
    """The photographs in a preview's folder with the face fitted to them. Made: a `PhotographPreview`, encoded."""

    folder: str
    token: str
    photographs: list[SeenPhotograph]


def run_photograph_fit(wanted: FitPhotographs, follow: Follow, /) -> PhotographPreview:
    """Fits photographs and keeps their face in the folder; ValueError with a sentence where that fails."""
    folder, cast = Path(wanted.folder), load_cast()
    photographs = []
    for number, seen in enumerate(wanted.photographs):
        follow(READ * number // len(wanted.photographs), 100, f"photograph {number + 1} is read")
        photographs.append(_read(folder, seen))

    def tell(done: float, what: str) -> None:
        follow(round(READ + (FITTED - READ) * done), 100, what)

    fitted = fit_photographs(cast.space, photographs, name="photograph", follow=tell)
    follow(FITTED, 100, "its colours")
    canvas = build_canvas(read_png(load_mask()), load_meshes()[0], cast.space.points)
    look, shown, unsure = suggest_photograph_look(cast, canvas, fitted.face, photographs, fitted.cameras)
    (folder / FACE).write_bytes(pack_face(fitted.face, look))
    vertices = _at_vertices(cast, shown)
    seen_share = float((vertices[np.unique(cast.space.skin_triangles)] > 0).mean())
    (folder / ORIGIN).write_text(describe_photographs(wanted, seen_share), encoding="utf-8")
    follow(WORN, 100, "it is shown")
    known = replace(fitted, doubts=(*fitted.doubts, *unsure))
    return _describe(cast, canvas, wanted, known, look, vertices, seen_share)


def describe_photographs(wanted: FitPhotographs, seen: float, /) -> str:
    """Where a face comes from, for its revision: the photographs, and how much of the skin they show."""
    count, names = len(wanted.photographs), ", ".join(each.name for each in wanted.photographs)
    return f"from {count} photograph{'' if count == 1 else 's'} ({names}); {seen:.0%} of the skin was seen"


def _read(folder: Path, seen: SeenPhotograph) -> Photograph:
    """A photograph and its landmarks in pixels; ValueError where the page saw another size."""
    try:
        picture = read_picture_in_sandbox(folder / FILES / seen.file)
    except ValueError as error:
        raise ValueError(f"{seen.name}: {str(error).removeprefix(f'{seen.file}: ')}") from error
    height, width = picture.shape[:2]
    if (width, height) != (seen.width, seen.height):
        raise ValueError(
            f"{seen.name} has {width} x {height} pixels, and the page saw {seen.width} x {seen.height}; bring it again"
        )
    return Photograph(np.array(seen.points) * [width, height, width], width, height, picture=picture)


def _at_vertices(cast: Cast, shown: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What of the skin's vertices (V,) was seen, of what of its texels (k, k) was."""
    skin = load_meshes()[0]
    found = np.zeros(cast.space.vertex_count, np.uint8)
    np.maximum.at(found, skin.source, texels_at(skin.uv, shown))
    return found


def _describe(
    cast: Cast, canvas: Canvas, wanted: FitPhotographs, fitted: PhotographFit, look: Look,
    vertices: NDArray[np.uint8], seen: float,
) -> PhotographPreview:  # fmt: skip
    skin = load_meshes()[0]
    drawn = colour_skin(fitted.face.positions[skin.source], skin.uv, skin.triangles, paint_skin(canvas, look))
    return PhotographPreview(
        token=wanted.token,
        doubts=list(fitted.doubts),
        off=list(fitted.residual),
        spread=fitted.spread,
        seen=seen,
        positions=le_bytes(drawn.positions, "<f4"),
        triangles=le_bytes(drawn.triangles, "<u4"),
        colours=le_bytes(drawn.colours, "u1"),
        face=le_bytes(rest_positions(cast, fitted.face), "<f4"),
        shown=le_bytes(vertices, "u1"),
        hair_style=look.hair_style,
        hair=look.hair,
    )
