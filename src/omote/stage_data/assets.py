"""Serializes the cast for the pages: manifest, face assets, hair, compounds (quantised retargeted expressions)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import blake2b

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Values
from omote.builtin import BakedMesh
from omote.interchange.formats.png import png_bytes
from omote.model import cast as model
from omote.model.action_units import ACTION_UNITS, action_units, read_action_unit
from omote.model.cast import Cast
from omote.model.hair import LINKS, HairStyle, place_strands
from omote.model.recipes.recipe import KEY
from omote.model.space.ears import rotate_ears
from omote.model.space.expression import Expression, Title
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import gain_of
from omote.model.transfer.compound import apply_expression, compile_answer, move_parts
from omote.perform.lights import LIGHTS
from omote.show.cast_documents import (
    BodyAsset,
    CompoundAsset,
    ContentAsset,
    ExpressionDocument,
    FaceAsset,
    FaceDocument,
    FaceGain,
    FigureAsset,
    HairAsset,
    HairDocument,
    Kind,
    LightDocument,
    LineDocument,
    Look,
    Manifest,
    MeshDocument,
)
from omote.show.messages import PROTOCOL_VERSION
from omote.show.wire import le_bytes
from omote.showfile.contents import read_albedo
from omote.stage_data.correctives_document import allowance_document, ball_radii, correctives_document
from omote.stage_data.figure_documents import figure_documents
from omote.stage_data.region_document import region_document

FINEST_STEP = 1e-6
"""Smallest quantisation step, metres per count: smaller displacements round to zero, so that compounds are sparse."""
MOST_COUNTS = 32767
HAIR_STEP = 1e-5
"""Metres per count of hair: it reaches a third of a metre from the middle of the eyes."""
SKIN = "skin"

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Documents:
    """The manifest, and every asset of a face, a hair style or a figure by its address."""

    manifest: Manifest
    faces: dict[str, FaceAsset]
    hair: dict[str, HairAsset]
    figures: dict[str, FigureAsset | BodyAsset]


def documents(cast: Cast, meshes: Sequence[BakedMesh], *, mask: str) -> Documents:
    """Builds the manifest and assets of a cast; mask: the mask picture's address. ValueError for an unknown mesh.

    meshes: what draws the head, the skin first.
    """
    rests = {name: rest_positions(cast, face) for name, face in cast.faces.items()}
    urls = {name: f"/assets/{content_name(rest.tobytes())}" for name, rest in rests.items()}
    hair = {name: hair_asset(style) for name, style in cast.hair.items()}
    combed = {
        name: f"/assets/{content_name(asset.points + asset.rows + asset.light + asset.fullness)}"
        for name, asset in hair.items()
    }
    starts = first_rows(cast)
    figures = None if cast.figures is None else figure_documents(cast.figures)
    manifest = Manifest(
        version=PROTOCOL_VERSION,
        base=cast.digest,
        digest=cast.digest,
        vertices=sum(len(part.points) for part in cast.space.parts.values()) + cast.space.vertex_count,
        skin=cast.space.vertex_count,
        meshes=[_mesh_document(mesh, starts) for mesh in meshes],
        lines=[LineDocument(line.name, le_bytes(line.loop, "<u4")) for line in cast.space.lines],
        mask=mask,
        faces=[_built_in_face(cast, name, url) for name, url in urls.items()],
        expressions=_built_in_expressions(cast),
        lights=[LightDocument(name, light.label) for name, light in LIGHTS.items()],
        hair=[HairDocument(name, url, cast.hair[name].scalp) for name, url in combed.items()],
        correctives=correctives_document(cast, starts),
        regions=region_document(cast.space),
        folding=b"" if cast.folding is None else le_bytes(cast.folding, "u1"),
        figures=None if figures is None else figures.document,
    )
    faces = {urls[name]: FaceAsset(le_bytes(rest, "<f4")) for name, rest in rests.items()}
    return Documents(
        manifest,
        faces,
        hair={combed[name]: asset for name, asset in hair.items()},
        figures={} if figures is None else figures.assets,
    )


def content_name(data: bytes) -> str:
    """The digest of these bytes, hexadecimal."""
    return blake2b(data, digest_size=12).hexdigest()


def first_rows(cast: Cast) -> dict[str, int]:
    """The first row of the skin and of each part of all positions: skin, then parts in the space's order."""
    rows = {SKIN: 0}
    row = cast.space.vertex_count
    for name, part in cast.space.parts.items():
        rows[name] = row
        row += len(part.points)
    return rows


def rest_positions(cast: Cast, face: Face) -> Floats:
    """The positions of a face without expression, (vertices, 3) metres: skin, then the parts.

    cast: whose space the face is on.
    """
    fitted = fit(cast.space, face)
    return np.concatenate([fitted.positions, *(fitted.parts[name] for name in cast.space.parts)])


def compound_positions(cast: Cast, face: Face, expression: Expression) -> Floats:
    """The positions of a face wearing an expression, (vertices, 3) metres; eyeballs before their turn.

    cast: whose space both are on.
    """
    fitted = fit(cast.space, face)
    compiled = compile_answer(cast.space, face, expression)
    skin = apply_expression(cast.space, face, compiled)
    parts = move_parts(cast.space, fitted, skin, compiled.parts)
    return np.concatenate([skin, *(parts[name] for name in cast.space.parts)])


def compound_asset(cast: Cast, face: Face, expression: str | Expression) -> CompoundAsset:
    """The compound minus its face, quantised: the error of a vertex is at most half of `scale` along each axis.

    Face and expression need not be of the cast; an expression of the cast goes by its name.
    """
    own = cast.expressions[expression] if isinstance(expression, str) else expression
    positions = compound_positions(cast, face, own)
    moves = quantise(positions.astype(np.float64) - rest_positions(cast, face))
    skin = positions[: cast.space.vertex_count]
    return msgspec.structs.replace(moves, allowed=allowance_document(cast.space, face, own, skin))


def content_asset(cast: Cast, key: str, face: Face, look: model.Look) -> ContentAsset:
    """The asset of an authored face; ValueError where it does not fit the cast's space, or its hair is unknown.

    cast: that it is to play with; key: of its content; look: its colours and traits.
    """
    if look.hair_style not in ("", *cast.hair):
        raise ValueError(
            f"the face has hair {look.hair_style!r}, which this cast has not: give it {', '.join(cast.hair)}"
        )
    if cast.garments and look.garment not in cast.garments:
        raise ValueError(
            f"the face wears {look.garment!r}, which this cast has not: give it {', '.join(cast.garments)}"
        )
    document = face_document(cast, face, look, label=key, url=f"/contents/{key}", source=KEY + key)
    return ContentAsset(document, le_bytes(rest_positions(cast, face), "<f4"))


def find_albedo(cast: Cast, source: str, contents: Mapping[str, bytes]) -> bytes:
    """The picture on a face's skin, a PNG, by the face's source; contents: of authored faces. KeyError where the face
    has none, ContentError where its content is damaged.

    cast: with the built-in looks.
    """
    if source.startswith(KEY):
        picture = read_albedo(contents[source.removeprefix(KEY)])
    else:
        albedo = cast.looks[source].albedo
        picture = None if albedo is None else png_bytes(albedo.pixels)
    if picture is None:
        raise KeyError(f"picture on the face {source[:40]}")
    return picture


def hair_asset(style: HairStyle) -> HairAsset:
    """A hair style, quantised: places to 10 micrometres, weights to a 255th."""
    return HairAsset(
        stations=style.points.shape[1],
        links=LINKS,
        width=style.width,
        scale=HAIR_STEP,
        points=le_bytes(np.rint(style.points / HAIR_STEP), "<i2"),
        rows=le_bytes(style.rows, "<u4"),
        weights=le_bytes(np.rint(style.weights * 255), "u1"),
        anchors=le_bytes(style.anchors, "<u4"),
        facing=le_bytes(np.rint(style.facing * 127), "i1"),
        light=le_bytes(np.rint(style.light * 255), "u1"),
        fullness=le_bytes(np.rint(style.fullness * 255), "u1"),
    )


def quantise(moves: Values) -> CompoundAsset:
    """Quantises displacements (n, 3), metres, to integers of one scale, without the vertices that do not move."""
    scale = float(max(np.abs(moves).max(initial=0.0) / MOST_COUNTS, FINEST_STEP))
    counts = np.rint(moves / scale).astype(np.int16)
    moved = np.flatnonzero(counts.any(axis=1))
    return CompoundAsset(scale=scale, indices=le_bytes(moved, "<u4"), deltas=le_bytes(counts[moved], "<i2"))


def _mesh_document(mesh: BakedMesh, starts: dict[str, int]) -> MeshDocument:
    if mesh.name not in starts:
        raise ValueError(f"there is no part {mesh.name!r} to draw; the space has {', '.join(starts)}")
    source = np.asarray(mesh.source, np.int64) + starts[mesh.name]
    return MeshDocument(
        mesh.name,
        le_bytes(source, "<u4"),
        le_bytes(mesh.uv, "<f4"),
        le_bytes(mesh.triangles, "<u4"),
        le_bytes(mesh.openness, "u1"),
    )


def face_document(cast: Cast, face: Face, look: model.Look, *, label: str, url: str, source: str) -> FaceDocument:
    """The manifest's entry of a face; url: where its positions are.

    cast: whose space and hair it has; look: its colours and traits; label: what people read; source: a built-in name,
    or `#` and the key of its content.
    """
    fitted = fit(cast.space, face)
    eyes = {part.eye: name for name, part in cast.space.eyes.items()}
    centres = {eye: fitted.centres[name] for eye, name in eyes.items()}
    spans = [np.linalg.norm(fitted.parts[name] - centres[eye], axis=1).max() for eye, name in eyes.items()]
    return FaceDocument(
        name=face.name,
        label=label,
        url=url,
        centres=(_vector(centres.get("left")), _vector(centres.get("right"))),
        eye_radius=float(np.mean(spans)) if spans else 0.0,
        ball_radii=ball_radii(cast.space, face),
        extremes=[_vector(point) for point in extremes(outline(cast, face, look.hair_style))],
        look=Look(**{name: value for name, value in vars(look).items() if name != "albedo"}),
        albedo="" if look.albedo is None else look.albedo.digest,
        source=source,
        gains=[FaceGain(gain.region, gain.value, gain.expression) for gain in face.gains],
    )


def _built_in_face(cast: Cast, name: str, url: str) -> FaceDocument:
    return face_document(cast, cast.faces[name], cast.looks[name], label=face_label(name), url=url, source=name)


def _built_in_expressions(cast: Cast) -> list[ExpressionDocument]:
    return [expression_document(name, own, cast.titles[name], name) for name, own in cast.expressions.items()]


def face_label(name: str) -> str:
    """What people read of a built-in face."""
    return name.replace("_", " ").capitalize()


def outline(cast: Cast, face: Face, hair_style: str) -> Floats:
    """The points (n, 3), metres, that a camera must frame: a face's skin, its hair, and its ears as performed
    expressions turn them, so that the picture holds them all and does not move with each.

    cast: with the styles and the performed expressions; hair_style: by name, "" for none.
    """
    framed = [face.positions, *_turned_ears(cast, face)]
    style = cast.hair.get(hair_style)
    if style is not None:
        strands = place_strands(style, cast.space.points, face.positions.astype(np.float64)).reshape(-1, 3)
        framed.append(strands.astype(np.float32))
    return np.concatenate(framed)


def _turned_ears(cast: Cast, face: Face) -> list[Floats]:
    """The skin of a face whose ears answer expressions, once for each performed one that turns them."""
    performed = [name for name, title in cast.titles.items() if title.kind == "performed"]
    turns = [gain_of(face.gains, "ears", name) * cast.expressions[name].ears for name in performed]
    return [rotate_ears(cast.space, face.positions, face.positions, turn) for turn in turns if turn.any()]


def extremes(positions: Floats) -> Floats:
    """The farthest of positions (V, 3), (6, 3): least and greatest x, then y, then z."""
    ends = [end for axis in range(3) for end in (positions[:, axis].argmin(), positions[:, axis].argmax())]
    return positions[ends]


def expression_document(name: str, expression: Expression, title: Title, source: str) -> ExpressionDocument:
    """The manifest's entry of an expression.

    name: of the expression; title: its label, kind and region; source: a built-in name, or `#` and the key of its
    content.
    """
    eyes = expression.eyes.ravel().tolist()
    return ExpressionDocument(
        name=name,
        label=title.label,
        kind=msgspec.convert(title.kind, Kind),
        region=title.region,
        eyes=(eyes[0], eyes[1], eyes[2], eyes[3]),
        pupil=expression.pupil,
        source=source,
        tags=unit_tags(name),
        head=_vector(expression.head),
        complexion=expression.complexion,
    )


def unit_tags(name: str) -> list[str]:
    """The action units of FACS that a channel is nearest to, by number and by name, so that palettes find it so."""
    units = [read_action_unit(f"AU{code}") for code in action_units(name)]
    return [word for unit in units if unit for word in (str(unit), ACTION_UNITS[unit.number])]


def _vector(point: NDArray[np.floating] | None) -> Vector:
    return (0.0, 0.0, 0.0) if point is None else (float(point[0]), float(point[1]), float(point[2]))
