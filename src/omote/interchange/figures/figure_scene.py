"""The scene of a face on a body: head, suit, hands and shoes on one rig, on their feet."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from omote.interchange.collar_mesh import COLLAR
from omote.interchange.export_face import SKIN, ExportContext, Meshes, build_scene
from omote.interchange.figures.figure_rig import ExportedFigure, export_figure
from omote.interchange.formats.glb_writer import ExportScene, Shape
from omote.model.body.figure_space import BONES_OF_A_ROW


def build_figure_scene(
    context: ExportContext,
    face: str,
    body: str,
    poses: Iterable[tuple[str, Meshes]],
    /,
    *,
    hair: bool = True,
    influences: int = BONES_OF_A_ROW,
) -> ExportScene:
    """Builds the scene of a face of the cast on a body, with its rig; soles on y = 0.

    context, face: of the cast; body: a body's name, or `own` for the face's; poses: `named_compound_meshes` of each
    expression, by its name; hair: whether it comes along; influences: joints that move a vertex at most. ValueError for
    a face or a body that is not in the cast, and for reserved names.
    """
    worn = dict(poses)
    figure = export_figure(context.cast, face, body, influences=influences)
    bare = build_scene(context, face, worn.items(), hair=hair, drawn=True)
    shapes = [_stand(shape, figure) for shape in bare.shapes if shape.name != COLLAR]
    skins = {name: meshes[SKIN] for name, meshes in worn.items()}
    shapes += [_stand(shape, figure) for shape in figure.body_shapes(skins)]
    extras = {**bare.extras, "body": figure.body.name, "size": figure.body.size}
    return replace(bare, shapes=shapes, extras=extras, rig=figure.rig(shapes, figure.figures.poses))


def _stand(shape: Shape, figure: ExportedFigure) -> Shape:
    """A shape on its feet; one with a place of its own keeps its points."""
    if any(shape.place):
        x, y, z = (np.array(shape.place) + figure.shift).tolist()
        return replace(shape, place=(x, y, z))
    return replace(shape, points=(shape.points.astype(np.float64) + figure.shift).astype(np.float32))
