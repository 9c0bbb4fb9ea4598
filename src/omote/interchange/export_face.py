"""Exports a face with chosen expressions as a glTF scene: skin, parts and hair with named morph targets."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Points
from omote.builtin import BakedMesh
from omote.geometry import mesh
from omote.interchange import part_textures
from omote.interchange.collar_mesh import collar_shape
from omote.interchange.drawn_mouth import DrawnMouth, DrawnPart
from omote.interchange.formats.glb_writer import ExportScene, Material, MorphTarget, Shape
from omote.interchange.formats.png import png_bytes, read_png
from omote.interchange.name_choices import choose_expressions as choose_expressions
from omote.interchange.part_textures import paint_strands
from omote.interchange.relief_texture import paint_relief, tangents_of
from omote.interchange.skin_texture import Canvas, build_canvas, decode_srgb, paint_skin
from omote.model.cast import Cast, Look
from omote.model.hair import HairStyle, place_strands
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import apply_expression, compile_answer, move_parts, turn_eyes
from omote.model.transfer.gum_line import GUMS
from omote.model.transfer.teeth_clearance import keep_teeth_inside
from omote.perform.limits import check_known

Meshes = dict[str, Points]

HAIR = "hair"
STRANDS = 7
"""Hairs on a ribbon."""
SKIN = "skin"
LASHES = "lashes"
TONGUE = "tongue"
JAW_OPEN = "jawOpen"
MOUTH_CLOSE = "mouthClose"
SPARE = 0.0005
"""Metres that teeth stay behind lips closed over a whole open jaw: over a half open one lips press further in."""
REST = 5e-7
STRAIGHT = 1e-4
"""A target leaves out vertices that move less (metres) and whose normal changes less."""
NOTICE = (
    "Made with Omote. The built-in heads, units and pictures come from MakeHuman's CC0 assets and from Omote itself "
    "and are free for any use (CC0); what an artist added is the artist's."
)


def hair_shape(
    style: HairStyle, generic: Points, positions: NDArray[np.floating], targets: Mapping[str, MorphTarget], look: Look
) -> Shape:
    """Builds the hair of a face with positions (V, 3): two vertices for each strand point; targets: the skin's.

    style, generic (V, 3): strands, and the head that they were combed on, metres; positions (V, 3): metres; look: for
    its colour.
    """
    strands = place_strands(style, generic, positions.astype(np.float64))
    count, places = strands.shape[:2]
    along = np.gradient(strands, axis=1)
    facing = style.facing.astype(np.float64)
    side = _unit(np.cross(along, facing)) * (0.5 * style.width * style.fullness[:, None, None])
    points = np.stack([strands - side, strands + side], axis=2).reshape(-1, 3)
    normals = np.repeat(_unit(np.cross(side, along)).reshape(-1, 3), 2, axis=0)
    shape = (count, places, 2)
    across = np.broadcast_to([0.0, 1.0], shape)
    down = np.broadcast_to(np.linspace(0.0, 1.0, places)[None, :, None], shape)
    rows = np.repeat(style.anchors, 2 * places)
    still = np.zeros((len(rows), 3), np.float32)
    picture = paint_strands(decode_srgb(look.hair), STRANDS, columns=128, rows=256)
    return Shape(
        name=HAIR,
        points=points.astype(np.float32),
        normals=normals.astype(np.float32),
        uv=np.stack([across, down], axis=-1).reshape(-1, 2).astype(np.float32),
        triangles=_ribbon_triangles(count, places),
        material=Material(HAIR, png_bytes(picture), roughness=0.55, cut=0.4, both=True),
        targets={name: MorphTarget(target.moves[rows], still) for name, target in targets.items()},
        shade=np.repeat(0.25 + 0.75 * style.light.reshape(-1), 2).astype(np.float32),
    )


def _ribbon_triangles(count: int, places: int) -> NDArray[np.int32]:
    """The triangles of ribbons, two vertices a place, seen from where they face."""
    first = (np.arange(count)[:, None] * places + np.arange(places - 1)).ravel() * 2
    left = first
    right = first + 1
    down = first + 2
    far = first + 3
    return np.concatenate([np.stack([left, right, far], axis=1), np.stack([left, far, down], axis=1)]).astype(np.int32)


def _unit(vectors: Points) -> Points:
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    result: Points = np.where(size > 1e-12, vectors / np.maximum(size, 1e-12), [0.0, 0.0, 1.0])
    return result


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


def named_compound_meshes(cast: Cast, face: str, expression: str, /) -> Meshes:
    """The vertices of skin and parts of a face wearing an expression: {mesh: (n, 3)} metres, eyeballs turned.

    ValueError for a face that is not in the cast.
    """
    return compound_meshes(cast.space, cast.faces[check_known(face, cast.faces, "face")], cast.expressions[expression])


def meshes_of(fitted: FittedFace, /) -> Meshes:
    """The vertices of skin and parts of a face at rest: {mesh: (n, 3)} metres."""
    return {name: points.astype(np.float64) for name, points in {SKIN: fitted.positions, **fitted.parts}.items()}


def compound_meshes(space: ParameterSpace, face: Face, expression: Expression, /) -> Meshes:
    """The vertices of skin and parts of any face wearing any expression: {mesh: (n, 3)} metres, eyeballs turned.

    space, face, expression: of one topology.
    """
    compiled = compile_answer(space, face, expression)
    fitted = fit(space, face)
    skin = apply_expression(space, face, compiled)
    parts = turn_eyes(space, move_parts(space, fitted, skin, compiled.parts), fitted.centres, expression.eyes)
    return {name: points.astype(np.float64) for name, points in {SKIN: skin, **parts}.items()}


def build_scene(
    context: ExportContext,
    face: str,
    poses: Iterable[tuple[str, Meshes]],
    /,
    *,
    hair: bool = True,
    drawn: bool = False,
    relief: bool = True,
) -> ExportScene:
    """Builds the scene of a face of the cast; poses: `named_compound_meshes` of each expression, by its name.

    ValueError for a face that is not in the cast, and for reserved names.

    context, face: of the cast; hair: whether it comes along; drawn: whether it has a mouth as stages draw it and its
    neck ends in a collar, in place of the head's own vertices alone; relief: whether the skin has pores and lines of
    age as normals, which need tangents.
    """
    cast = context.cast
    check_known(face, cast.faces, "face")
    fitted = fit(cast.space, cast.faces[face])
    look = cast.looks[face]
    mouth = DrawnMouth(cast.space, look if drawn else None)
    rest = mouth.draw(meshes_of(fitted))
    corners = {name: mouth.parts[name].triangles if name in mouth.parts else _corners(cast, name) for name in rest}
    upright = {name: mesh.normals(rest[name], corners[name]) for name in rest}
    targets: dict[str, dict[str, MorphTarget]] = {name: {} for name in rest}
    for expression, meshes in close_over_teeth(cast.space, fitted, dict(poses)).items():
        worn = mouth.draw(meshes)
        for name in rest:
            targets[name][expression] = _target(rest[name], worn[name], corners[name], upright[name])
    surfaces = _materials(context, look, mouth, relief=relief)
    shapes = [
        _drawn_shape(part.name, mouth.parts[part.name], rest, upright, targets, surfaces)
        if part.name in mouth.parts
        else _shape(context, fitted, part, upright[part.name], targets[part.name], surfaces)
        for part in context.meshes
    ]
    style = cast.hair.get(look.hair_style)
    if hair and style is not None:
        shapes.append(hair_shape(style, cast.space.points, fitted.positions, targets[SKIN], look))
    if drawn:
        shapes.append(collar_shape(cast.space, fitted.positions, targets[SKIN]))
    return ExportScene(face, shapes, {"notice": NOTICE, "cast": cast.digest, "units": "metres", "rows": "_VID"})


def close_over_teeth(space: ParameterSpace, fitted: FittedFace, poses: dict[str, Meshes], /) -> dict[str, Meshes]:
    """The poses, teeth of `mouthClose` drawn in by as much as they come out of lips that close over an open jaw.

    ARKit means the one with the other alone, and programs that add targets up have nothing that keeps teeth inside.

    space, fitted: the face at rest; poses: `named_compound_meshes` of each expression, by its name.
    """
    if not {JAW_OPEN, MOUTH_CLOSE} <= set(poses):
        return poses
    rest = meshes_of(fitted)
    closed = poses[MOUTH_CLOSE]
    both = {
        name: (poses[JAW_OPEN][name] + closed[name] - rest[name]).astype(np.float32)
        for name in (SKIN, *GUMS)
        if name in rest
    }
    skin = both.pop(SKIN)
    kept = keep_teeth_inside(space, fitted, skin, both, clearance=SPARE)
    return poses | {MOUTH_CLOSE: closed | {name: closed[name] + (kept[name] - both[name]) for name in both}}


def _corners(cast: Cast, name: str) -> NDArray[np.int32]:
    """The triangles of a mesh with doubled vertices welded, so that normals are smooth across texture seams."""
    if name != SKIN:
        return cast.space.parts[name].triangles
    return cast.space.welded[cast.space.triangles]


def _target(rest: Points, posed: Points, corners: NDArray[np.int32], upright: Points) -> MorphTarget:
    moves = posed - rest
    turns = mesh.normals(rest + moves, corners) - upright
    moves[np.abs(moves).max(axis=1) < REST] = 0.0
    turns[np.abs(turns).max(axis=1) < STRAIGHT] = 0.0
    return MorphTarget(moves.astype(np.float32), turns.astype(np.float32))


def _shape(
    context: ExportContext,
    fitted: FittedFace,
    part: BakedMesh,
    upright: Points,
    targets: Mapping[str, MorphTarget],
    surfaces: Mapping[str, Material],
) -> Shape:
    """One mesh split at its texture's seams; an eyeball around its own centre, so that it can be turned."""
    rows = part.source
    space = context.cast.space
    points = (fitted.positions if part.name == SKIN else fitted.parts[part.name]).astype(np.float64)
    eye = part.name != SKIN and bool(space.parts[part.name].eye)
    place = fitted.centres[part.name].astype(np.float32).astype(np.float64) if eye else np.zeros(3)
    own = space.welded if part.name == SKIN else np.arange(len(points))
    uv = _uv(context, part)
    material = surfaces[part.name]
    bumpy = material.relief is not None
    return Shape(
        name=part.name,
        points=(points - place)[rows].astype(np.float32),
        normals=upright[own][rows].astype(np.float32),
        uv=uv,
        tangents=tangents_of(points[rows], upright[own][rows], uv, part.triangles).astype(np.float32)
        if bumpy
        else None,
        rows=rows,
        triangles=part.triangles,
        material=material,
        targets={name: MorphTarget(target.moves[rows], target.turns[own][rows]) for name, target in targets.items()},
        place=(float(place[0]), float(place[1]), float(place[2])),
    )


def _drawn_shape(
    name: str,
    part: DrawnPart,
    rest: Meshes,
    upright: Meshes,
    targets: Mapping[str, Mapping[str, MorphTarget]],
    surfaces: Mapping[str, Material],
) -> Shape:
    """A part of the mouth as it is drawn."""
    return Shape(
        name=name,
        points=rest[name].astype(np.float32),
        normals=upright[name].astype(np.float32),
        uv=part.uv,
        rows=part.rows,
        triangles=part.triangles,
        material=surfaces[name],
        targets=targets[name],
        shade=part.shade,
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


def _materials(context: ExportContext, look: Look, mouth: DrawnMouth, *, relief: bool) -> dict[str, Material]:
    """The material of each mesh."""
    jaw = replace(_textured_material("teeth", part_textures.paint_jaw(look), roughness=0.25), both=True)
    lashes = _lashes(look)
    eye = _textured_material("eye", part_textures.paint_eye(look), roughness=0.15)
    return {
        SKIN: _skin_material(context, look, relief=relief),
        "eye_left": eye,
        "eye_right": eye,
        **{name: jaw if name in mouth.parts else _teeth(name, look) for name in GUMS},
        TONGUE: replace(_textured_material(TONGUE, part_textures.paint_tongue(), roughness=0.35), both=True),
        LASHES: replace(_textured_material(LASHES, lashes, roughness=0.8), both=True, cut=0.0),
    }


def _skin_material(context: ExportContext, look: Look, *, relief: bool) -> Material:
    """The skin of a look.

    context: for the skin's layers; look: whose skin; relief: whether it has that of its pores and lines of age.
    """
    roughness = 0.62 - 0.3 * look.lacquer + 0.3 * look.fur
    painted = _textured_material(SKIN, paint_skin(context.canvas, look), roughness=roughness)
    return replace(painted, relief=png_bytes(paint_relief(context.canvas, look))) if relief else painted


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
