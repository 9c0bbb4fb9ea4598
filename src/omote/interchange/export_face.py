"""Exports a face with chosen expressions as a glTF scene: skin, parts and hair with named morph targets."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from omote.builtin import BakedMesh
from omote.geometry import mesh
from omote.interchange import part_textures
from omote.interchange.formats.glb_writer import Material, Scene, Shape, Target
from omote.interchange.formats.png import Picture, png_bytes, read_png
from omote.interchange.hair_mesh import hair_shape
from omote.interchange.skin_texture import Canvas, build_canvas, decode_srgb, paint_skin
from omote.model.cast import Cast, Look
from omote.model.known_names import NEUTRAL
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import apply_expression, compile_answer, move_parts, turn_eyes
from omote.perform.limits import check_known
from omote.perform.name_lookup import ALL, find_kind, find_names

Points = NDArray[np.float64]
Meshes = dict[str, Points]

SKIN, LASHES, TONGUE = "skin", "lashes", "tongue"
REST, STRAIGHT = 5e-7, 1e-4
"""A target leaves out vertices that move less (metres) and whose normal changes less."""
NOTICE = (
    "Made with Omote. The built-in heads, units and pictures come from MakeHuman's CC0 assets and from Omote itself "
    "and are free for any use (CC0); what an artist added is the artist's."
)


@dataclass(frozen=True, eq=False)
class ExportContext:
    """What all exports of a cast share: its meshes, and the skin's layers (a PNG), decoded once."""

    cast: Cast
    meshes: Sequence[BakedMesh]
    layers: bytes = field(repr=False)

    @cached_property
    def canvas(self) -> Canvas:
        """The skin's layers, ready to be coloured."""
        skin = next(part for part in self.meshes if part.name == SKIN)
        return build_canvas(read_png(self.layers), skin, self.cast.space.points)


def choose_expressions(cast: Cast, text: str, /) -> list[str]:
    """Parses a list of expressions: kinds (`arkit`, `performed`, `own`), `all`, or names, by commas; without neutral.

    ValueError for a name that is neither, and where nothing is named.
    """
    found: dict[str, None] = {}
    for word in filter(None, (word.strip() for word in text.split(","))):
        kinds = {name: title.kind for name, title in cast.titles.items()}
        found |= dict.fromkeys(find_kind(word, kinds) or _named_expressions(cast, word))
    if not found:
        raise ValueError(f"{text!r} names no expression; give names or a kind by commas: smile,joy or arkit or neutral")
    return [name for name in found if name != NEUTRAL]


def _named_expressions(cast: Cast, word: str) -> Sequence[str]:
    labels = {name: title.label for name, title in cast.titles.items()}
    try:
        return find_names(word, cast.expressions, "expression", labels)
    except ValueError as error:
        kinds = dict.fromkeys(title.kind for title in cast.titles.values())
        raise ValueError(f"{error}; or name a kind: {', '.join(kinds)}, {ALL}") from None


def named_compound_meshes(cast: Cast, face: str, expression: str, /) -> Meshes:
    """The vertices of skin and parts of a face wearing an expression: {mesh: (n, 3)} metres, eyeballs turned.

    ValueError for a face that is not in the cast.
    """
    return compound_meshes(cast.space, cast.faces[check_known(face, cast.faces, "face")], cast.expressions[expression])


def compound_meshes(space: ParameterSpace, face: Face, expression: Expression, /) -> Meshes:
    """The vertices of skin and parts of any face wearing any expression: {mesh: (n, 3)} metres, eyeballs turned."""
    compiled, fitted = compile_answer(space, face, expression), fit(space, face)
    skin = apply_expression(space, face, compiled)
    parts = turn_eyes(space, move_parts(space, fitted, skin, compiled.parts), fitted.centres, expression.eyes)
    return {name: points.astype(np.float64) for name, points in {SKIN: skin, **parts}.items()}


def build_scene(
    context: ExportContext, face: str, poses: Iterable[tuple[str, Meshes]], /, *, hair: bool = True
) -> Scene:
    """Builds the scene of a face of the cast; poses: `named_compound_meshes` of each expression, by its name.

    ValueError for a face that is not in the cast, and for reserved names.
    """
    cast = context.cast
    check_known(face, cast.faces, "face")
    fitted, look = fit(cast.space, cast.faces[face]), cast.looks[face]
    rest: Meshes = {SKIN: fitted.positions.astype(np.float64)}
    rest |= {name: points.astype(np.float64) for name, points in fitted.parts.items()}
    corners = {name: _corners(cast, name) for name in rest}
    upright = {name: mesh.normals(rest[name], corners[name]) for name in rest}
    targets: dict[str, dict[str, Target]] = {name: {} for name in rest}
    for expression, meshes in poses:
        for name in rest:
            targets[name][expression] = _target(rest[name], meshes[name], corners[name], upright[name])
    surfaces = _materials(context, look)
    shapes = [
        _shape(context, fitted, part, upright[part.name], targets[part.name], surfaces) for part in context.meshes
    ]
    style = cast.hair.get(look.hair_style)
    if hair and style is not None:
        shapes.append(hair_shape(style, cast.space.points, fitted.positions, targets[SKIN], look))
    return Scene(face, shapes, {"notice": NOTICE, "cast": cast.digest, "units": "metres", "rows": "_VID"})


def _corners(cast: Cast, name: str) -> NDArray[np.int32]:
    """The triangles of a mesh with doubled vertices welded, so that normals are smooth across texture seams."""
    if name != SKIN:
        return cast.space.parts[name].triangles
    return cast.space.welded[cast.space.triangles]


def _target(rest: Points, posed: Points, corners: NDArray[np.int32], upright: Points) -> Target:
    moves = posed - rest
    turns = mesh.normals(rest + moves, corners) - upright
    moves[np.abs(moves).max(axis=1) < REST] = 0.0
    turns[np.abs(turns).max(axis=1) < STRAIGHT] = 0.0
    return Target(moves.astype(np.float32), turns.astype(np.float32))


def _shape(
    context: ExportContext,
    fitted: FittedFace,
    part: BakedMesh,
    upright: Points,
    targets: Mapping[str, Target],
    surfaces: Mapping[str, Material],
) -> Shape:
    """One mesh split at its texture's seams; an eyeball around its own centre, so that it can be turned."""
    rows, space = part.source, context.cast.space
    points = (fitted.positions if part.name == SKIN else fitted.parts[part.name]).astype(np.float64)
    eye = part.name != SKIN and bool(space.parts[part.name].eye)
    place = fitted.centres[part.name].astype(np.float32).astype(np.float64) if eye else np.zeros(3)
    own = space.welded if part.name == SKIN else np.arange(len(points))
    return Shape(
        name=part.name,
        points=(points - place)[rows].astype(np.float32),
        normals=upright[own][rows].astype(np.float32),
        uv=_uv(context, part),
        rows=rows,
        triangles=part.triangles,
        material=surfaces[part.name],
        targets={name: Target(target.moves[rows], target.turns[own][rows]) for name, target in targets.items()},
        place=(float(place[0]), float(place[1]), float(place[2])),
    )


def _uv(context: ExportContext, part: BakedMesh) -> NDArray[np.float32]:
    """The places that the mesh's picture is painted for: the cast's own for the skin."""
    if part.name == SKIN:
        return part.uv
    space = context.cast.space
    points = space.parts[part.name].points
    if space.parts[part.name].eye:
        return part_textures.eye_uv(points - points.mean(axis=0))[part.source]
    if part.name == LASHES:
        balls = {ball.eye: ball.points.mean(axis=0) for ball in space.parts.values() if ball.eye}
        sides = [part_textures.lash_uv(points, balls[side]) for side in ("left", "right")]
        return np.where(points[:, :1] > 0.0, *sides)[part.source]
    if part.name == TONGUE:
        return part_textures.tongue_uv(points)[part.source]
    return part_textures.arch_uv(points, upper=part.name == "teeth_upper")[part.source]


def _materials(context: ExportContext, look: Look) -> dict[str, Material]:
    """The material of each mesh."""
    lashes = _lashes(look)
    eye = _textured_material("eye", part_textures.paint_eye(look), roughness=0.15)
    return {
        SKIN: _textured_material(
            "skin", paint_skin(context.canvas, look), roughness=0.62 - 0.3 * look.lacquer + 0.3 * look.fur
        ),
        "eye_left": eye,
        "eye_right": eye,
        "teeth_upper": _teeth("teeth_upper", look),
        "teeth_lower": _teeth("teeth_lower", look),
        TONGUE: replace(_textured_material(TONGUE, part_textures.paint_tongue(), roughness=0.35), both=True),
        LASHES: replace(_textured_material(LASHES, lashes, roughness=0.8), both=True, cut=0.0),
    }


def _lashes(look: Look) -> Picture:
    """Lashes all around the eyeball, as many and as dense as a look has."""
    strands = 30 + round(70 * look.lashes)
    cover = 0.1 + 0.08 * look.lashes
    return part_textures.paint_strands(decode_srgb(look.brow) * 0.3, strands, columns=2048, rows=64, cover=cover)


def _teeth(name: str, look: Look) -> Material:
    picture = part_textures.paint_teeth(look, upper=name == "teeth_upper")
    return replace(_textured_material(name, picture, roughness=0.25), both=True, cut=0.5)


def _textured_material(name: str, picture: Picture, *, roughness: float) -> Material:
    return Material(name, png_bytes(picture), roughness=round(roughness, 3))
