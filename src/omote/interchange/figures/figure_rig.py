"""A figure for other programs: joints in T-pose, and meshes of the face, the garment and what it leaves bare on them.

Programs blend bones linearly, which strays the farther from a stage the more a joint turns. So vertices are kept where
the body was modelled, arms half down, and corrected so that the T-pose, in which the file rests, is the stage's own: in
the poses of the library the skin is more than twice as near to a stage's as from vertices in T-pose.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array, vstack
from scipy.spatial import cKDTree

from omote.arrays import Floats, Indices, Points, Triangles, Values
from omote.geometry import mesh
from omote.interchange.figures.cut_mesh import cut_mesh
from omote.interchange.figures.suit import ROLL, SuitParts, suit_parts, wear_suit
from omote.interchange.figures.t_pose import pose_t
from omote.interchange.formats.glb_writer import Material, MorphTarget, Shape
from omote.interchange.formats.rig import Joint, Motion, Rig, strongest_weights
from omote.interchange.skin_texture import decode_srgb
from omote.model.body.body import Body
from omote.model.body.figure_space import FigureSpace
from omote.model.body.figures import Figures
from omote.model.body.garment import Garment
from omote.model.body.posed_bones import PosedBones
from omote.model.body.skeleton import SIDES
from omote.model.cast import Cast, Look
from omote.model.known_names import GENERIC
from omote.perform.figures.figure import RestingFigure, pose_figure, resting_figure, skin_figure, skinning_bones
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.figures.pose_mix import mix_poses
from omote.perform.limits import check_known

HEAD = "head"
SKIN = "skin"
HAIR = "hair"
GARMENT = "garment"
TRIM = "trim"
BARE = "bare"
SHOES = "shoes"
BODY = (GARMENT, TRIM, BARE, SHOES)
"""What there may be of the body, where the garment has it: cloth in its two colours, skin, shoes."""
CLOTH_ROUGHNESS = 0.9
LEATHER = Material(SHOES, colour=(0.008, 0.008, 0.009), roughness=0.45)
MOVES = 5e-7
"""Metres: what moves less is left out of a target."""


@dataclass(frozen=True, eq=False)
class BodyMesh:
    """A part of the figure's mesh: blend (n, V + B): its vertices as sums of rows; uv (n, 2); triangles (t, 3)."""

    blend: csr_array
    uv: Floats
    triangles: Triangles


@dataclass(frozen=True, eq=False)
class ExportedFigure:
    """A face on a body, ready to be written.

    cast, face: whose head and garment; body: whose body, as cloth spans it; resting: of both; rest: bones in T-pose;
    shift: what brings a point of the face to its place in the scene, ankles above the origin and soles on y = 0,
    metres; influences: joints that move a vertex at most.
    """

    cast: Cast
    face: str
    body: Body
    figures: Figures
    resting: RestingFigure
    rest: PosedBones
    influences: int

    @property
    def space(self) -> FigureSpace:
        """What all figures share."""
        return self.figures.space

    @cached_property
    def bound(self) -> PosedBones:
        """The bones in T-pose as skin follows them."""
        return skinning_bones(self.space, self.resting, self.rest)

    @cached_property
    def shift(self) -> Points:
        """What brings a point of the face to its place in the scene, metres."""
        ankles = self.rest.joints[[self.space.skeleton.places[f"foot.{side}"] for side in SIDES]]
        soles = self.worn(SHOES)[0][:, 1].min()
        return np.array([0.0, -soles, -ankles[:, 2].mean()])

    @cached_property
    def joints(self) -> tuple[Joint, ...]:
        """The bones in T-pose, in their order, by their names."""
        skeleton = self.space.skeleton
        parents = ["", *(skeleton.names[parent] for parent in skeleton.parents[1:])]
        places = (self.rest.joints + self.shift).tolist()
        return tuple(
            Joint(name, (place[0], place[1], place[2]), parent)
            for name, place, parent in zip(skeleton.names, places, parents, strict=True)
        )

    @cached_property
    def inverse(self) -> Values:
        """From where vertices are kept (moved by `shift`) to each joint's frame, (J, 4, 4)."""
        matrices = np.tile(np.eye(4), (len(self.joints), 1, 1))
        matrices[:, :3, :3] = self.bound.turns
        away = self.bound.shifts(self.resting.joints) - self.rest.joints
        matrices[:, :3, 3] = away - self.bound.turns @ self.shift
        return matrices

    def rig(self, shapes: Iterable[Shape], /, poses: Iterable[str] = ()) -> Rig:
        """The joints with shapes of the scene on them, the skin among these, and poses. poses: by name."""
        given = {shape.name: shape for shape in shapes}
        found = {name: self._weights(shape, given[SKIN]) for name, shape in given.items()}
        weights = {name: each for name, each in found.items() if each is not None}
        return Rig(self.joints, self.inverse, weights, HEAD, {name: self.motion(name) for name in poses})

    def body_shapes(self, skins: Mapping[str, Points], /) -> list[Shape]:
        """Garment, bare skin and shoes, in the face's frame; skins: the head's skin (V, 3) in each expression."""
        look = self.cast.looks[self.face]
        cloth = {name: _cloth(name, colour) for name, colour in ((GARMENT, look.cloth), (TRIM, look.trim))}
        surfaces = {**cloth, BARE: _bare(look), SHOES: LEATHER}
        moves = {name: self._follow(skin) for name, skin in skins.items()}
        return [self._shape(name, part, surfaces[name], moves) for name, part in self.meshes.items()]

    def worn(self, name: str, /) -> tuple[Points, Points]:
        """Where a mesh of the body is in T-pose as stages draw them, in the face's frame, and their normals, (n, 3)
        both."""
        part = self.meshes[name]
        rows = skin_figure(self.space, self.resting, self.rest).astype(np.float64)
        welded = np.concatenate([self.cast.space.welded, np.arange(len(self.cast.space.welded), len(rows))])
        corners = welded[np.concatenate([self.cast.space.triangles, self.space.triangles, self.space.skirt])]
        upright = mesh.normals(rows, corners)[welded]
        normals = _unit(part.blend @ upright)
        points = part.blend @ rows + (part.blend @ self._parts.cloth)[:, None] * normals
        rolled = (part.blend @ self._parts.rolled)[:, None]
        return points, _unit(normals + 0.7 * rolled * [0.0, 1.0, 0.0])

    def _shape(self, name: str, part: BodyMesh, surface: Material, moves: Mapping[str, Points]) -> Shape:
        points, normals = self._kept(part, *self.worn(name))
        still = np.zeros(points.shape, np.float32)
        return Shape(
            name=name,
            points=points.astype(np.float32),
            normals=normals.astype(np.float32),
            uv=part.uv,
            triangles=part.triangles,
            material=surface,
            targets={each: MorphTarget((part.blend @ rows).astype(np.float32), still) for each, rows in moves.items()},
        )

    def _follow(self, skin: Points) -> Points:
        """What an expression moves of all rows (V + B, 3): the body follows the edge of the head."""
        space = self.space
        head = skin - self.resting.rows[: space.head_rows]
        shift = head[space.rim_rows].mean(axis=0)
        body = np.tile(shift, (space.body_rows, 1))
        body[space.joined] += space.join @ (head[space.edge] - shift)
        moves = np.concatenate([head, body])
        moves[np.abs(moves).max(axis=1) < MOVES] = 0.0
        return moves

    def _kept(self, part: BodyMesh, points: Points, normals: Points) -> tuple[Points, Points]:
        """Where vertices are kept, and their normals, so that linear blending brings them where they are in T-pose."""
        joints, weights = strongest_weights(part.blend @ self._rows, self.influences)
        turns = np.einsum("nk,nkab->nab", weights, self.bound.turns[joints])
        shifts = np.einsum("nk,nka->na", weights, self.bound.shifts(self.resting.joints)[joints])
        kept = np.linalg.solve(turns, np.stack([points - shifts, normals], axis=2))
        return kept[:, :, 0], _unit(kept[:, :, 1])

    def _weights(self, shape: Shape, skin: Shape) -> csr_array | None:
        """How much each joint moves each vertex of a shape; None of what hangs on the head's alone."""
        if shape.name in self.meshes:
            return csr_array(self.meshes[shape.name].blend @ self._rows)
        if shape.name == SKIN:
            rows = shape.rows
        elif shape.name == HAIR:
            anchors = self.cast.hair[self.cast.looks[self.face].hair_style].anchors
            rows = np.repeat(anchors, len(shape.points) // len(anchors))
        elif shape.rows is None:
            rows = None if skin.rows is None else skin.rows[cKDTree(skin.points).query(shape.points, workers=1)[1]]
        else:
            return None  # a part of the head
        return csr_array(self._rows[rows])

    def motion(self, name: str, /) -> Motion:
        """A pose of the library on this body. name: the pose's."""
        called = pose_figure(self.space, self.resting, mix_poses(self.figures.poses, {name: 1.0}, {}, {}))
        posed = skinning_bones(self.space, self.resting, called)
        turns = posed.turns @ np.swapaxes(self.bound.turns, 1, 2)
        parents = self.space.skeleton.parents[1:]
        against = np.concatenate([turns[:1], np.swapaxes(turns[parents], 1, 2) @ turns[1:]])
        return Motion(against, posed.joints[0] + self.shift)

    @cached_property
    def _rows(self) -> csr_array:
        """The weights of all rows, (V + B, J)."""
        space = self.space
        count, most = space.bones.shape
        rows = np.repeat(np.arange(count), most)
        shape = (count, len(space.skeleton.names))
        return csr_array((space.weights.ravel().astype(np.float64), (rows, space.bones.ravel())), shape=shape)

    @cached_property
    def _parts(self) -> SuitParts:
        first = next(iter(self.figures.bodies.values()))
        generic = self.cast.faces.get(GENERIC)
        face = self.cast.space.points if generic is None else generic.positions.astype(np.float64)
        return suit_parts(self.space, first, face, self._garment)

    @property
    def _garment(self) -> Garment:
        return self.figures.garments[self.cast.looks[self.face].garment]

    @cached_property
    def meshes(self) -> dict[str, BodyMesh]:
        """What there is of `BODY`: the figure below the roll at the neck, without what a skirt hides, and the skirt,
        cut where colours, bare skin and shoes begin."""
        parts = self._parts
        garment = self._garment
        whole = _whole_mesh(self.space, self.cast.space.triangles, parts.height)
        below = _cut(whole, parts.height, ROLL)[0]
        shown = _cut(below, garment.hidden, 0.0)[0]
        clad, shoes = _cut(shown, parts.shoe, 0.5)
        bare, cloth = _cut(clad, garment.cover, 0.0)
        skirt = _cut(_skirt_mesh(self.space), garment.cover, 0.0)[1]
        halves = zip(_cut(cloth, garment.trim, 0.0), _cut(skirt, garment.trim, 0.0), strict=True)
        plain, trim = (_joined(one, other) for one, other in halves)
        meshes = {GARMENT: plain, TRIM: trim, BARE: bare, SHOES: shoes}
        return {name: part for name, part in meshes.items() if len(part.triangles)}


def export_figure(cast: Cast, face: str, body: str, /, *, influences: int) -> ExportedFigure:
    """A face of the cast on a body, ready to be written.

    face: by name; body: a body's name, or `FACES_OWN` for the face's; influences: joints that move a vertex at most.
    ValueError for a cast without figures and for a body that is not in it.
    """
    figures = cast.figures
    if figures is None:
        raise ValueError("this cast has no bodies; export the head alone")
    check_known(face, cast.faces, "face")
    name = face if body == FACES_OWN else check_known(body, figures.bodies, "body")
    first = next(iter(figures.bodies.values()))
    worn = wear_suit(figures.space, first, figures.body_of(name))
    alone = Figures(figures.space, {worn.name: worn}, figures.poses, figures.garments)
    whole = resting_figure(alone, {worn.name: 1.0}, cast.faces[face].positions.astype(np.float64))
    resting = replace(whole, correctives=np.zeros_like(whole.correctives))  # files carry none, nor may a rest wear some
    ends = worn.ends + (resting.joints[0] - worn.joints[0])
    rest = pose_t(figures.space.skeleton, resting, ends)
    return ExportedFigure(cast, face, worn, figures, resting, rest, influences)


def _bare(look: Look) -> Material:
    red, green, blue = (float(part) for part in decode_srgb(look.skin))
    return Material(BARE, colour=(red, green, blue), roughness=0.62)


def _cloth(name: str, colour: str) -> Material:
    red, green, blue = (float(part) for part in decode_srgb(colour))
    return Material(name, colour=(red, green, blue), roughness=CLOTH_ROUGHNESS, both=True)


def _skirt_mesh(space: FigureSpace) -> BodyMesh:
    """The skirt, of which no texture is known."""
    rows = np.arange(space.first_of_skirt, len(space.bones))
    blend = csr_array((np.ones(len(rows)), (np.arange(len(rows)), rows)), shape=(len(rows), len(space.bones)))
    triangles = (space.skirt - space.first_of_skirt).astype(np.int32)
    return BodyMesh(blend, np.zeros((len(rows), 2), np.float32), triangles)


def _joined(one: BodyMesh, other: BodyMesh) -> BodyMesh:
    blend = csr_array(vstack([one.blend, other.blend]))
    triangles = np.concatenate([one.triangles, other.triangles + one.blend.shape[0]])
    return BodyMesh(blend, np.concatenate([one.uv, other.uv]), triangles)


def _whole_mesh(space: FigureSpace, skin: Triangles, height: Values) -> BodyMesh:
    """The body, torn at the seams of its texture, and the neck up to the roll."""
    neck = skin[(height[skin] < ROLL).any(axis=1)]
    blank = np.full(neck.shape, len(space.uvs))
    corners = np.stack([np.concatenate([space.triangles, neck]), np.concatenate([space.uv_rows, blank])], axis=2)
    pairs, place = np.unique(corners.reshape(-1, 2), axis=0, return_inverse=True)
    uv = np.concatenate([space.uvs, np.zeros((1, 2))])[pairs[:, 1]]
    shape = (len(pairs), len(space.bones))
    blend = csr_array((np.ones(len(pairs)), (np.arange(len(pairs)), pairs[:, 0])), shape=shape)
    return BodyMesh(blend, uv.astype(np.float32), place.reshape(-1, 3).astype(np.int32))


def _cut(part: BodyMesh, values: Values | Floats, level: float) -> tuple[BodyMesh, BodyMesh]:
    """What of a part lies under a level and over it. values (V + B,): of all rows."""
    cut = cut_mesh(part.triangles, part.blend @ values, level)
    blend = cut.blend @ part.blend
    uv = cut.blend @ part.uv
    return _used(blend, uv, cut.under), _used(blend, uv, cut.over)


def _used(blend: csr_array, uv: Floats, triangles: Indices) -> BodyMesh:
    kept, place = np.unique(triangles, return_inverse=True)
    return BodyMesh(csr_array(blend[kept]), uv[kept].astype(np.float32), place.reshape(-1, 3).astype(np.int32))


def _unit(vectors: Points) -> Points:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-12))
