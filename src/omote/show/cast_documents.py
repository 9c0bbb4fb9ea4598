"""Documents that pages fetch over HTTP: the manifest of the cast, and its assets."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from omote.model.space.complexion import PALE, ComplexionNumbers
from omote.show.declaration import Name

Tags = Annotated[list[Name], msgspec.Meta(max_length=20)]
Kind = Literal["neutral", "performed", "arkit", "makehuman", "omote", "spring", "limb", "own"]


class Look(msgspec.Struct, frozen=True):
    """Colours of a face, each `#rrggbb`, hair style, garment, and the traits, plain numbers (`model.cast.Look`)."""

    skin: str
    lip: str
    brow: str
    blush: str
    iris: str
    hair: str
    hair_style: str
    iris_size: float
    slit: float
    lashes: float
    coat: str
    pores: float
    age: float
    freckles: float
    stubble: float
    brows: float
    makeup: float
    gloss: float
    fur: float
    stripes: float
    lacquer: float
    scalp: float
    milk: float
    garment: str
    cloth: str
    trim: str
    pinstripes: float
    checks: float
    dots: float


class LineDocument(msgspec.Struct, frozen=True):
    """A line around an opening, `lid_left`, `lid_right` or `lips`: `loop` (n,) u32 little-endian, rows of the skin in
    walking order."""

    name: str
    loop: bytes


class MeshDocument(msgspec.Struct, frozen=True):
    """A drawn mesh, little-endian: `source` (n,) u32 rows of the positions, `uv` (n, 2) f32, `triangles` (t, 3) u32.

    `openness` (n,) u8: how much of the sky each vertex of the generic face sees."""

    name: str
    source: bytes
    uv: bytes
    triangles: bytes
    openness: bytes


class FaceGain(msgspec.Struct, frozen=True):
    """In which strength a face answers expressions in a region, 0 to 4; `expression`: the one that alone it is for."""

    region: str
    value: float
    expression: str | None = None


class FaceDocument(msgspec.Struct, frozen=True):
    """A face: where its positions are, its eyeballs' centres (left, right) and radius in metres, its colours.

    `ball_radii`: of the left and the right eyeball, what lids must leave. `extremes`: the farthest points
    of skin and hair, least then greatest x, y and z, metres: what a picture has to hold. `source`: its name in the
    addresses of compounds, `#` and a content key for an own face; `tags`, `place`: for palettes.
    `gains`: those that differ from a person's. `albedo`: the digest of its picture, a PNG of sRGB and coverage at
    `/albedos/DIGEST/SOURCE`, "" for none.
    """

    name: str
    label: str
    url: str
    centres: tuple[tuple[float, float, float], tuple[float, float, float]]
    eye_radius: float
    ball_radii: tuple[float, float]
    extremes: list[tuple[float, float, float]]
    look: Look
    source: str
    tags: list[str] = []
    place: float = 0.0
    gains: list[FaceGain] = []
    albedo: str = ""


class ExpressionDocument(msgspec.Struct, frozen=True):
    """An expression: its palette, its region, its eyeball angles in radians (left yaw, pitch, right yaw, pitch), and
    what it adds to the pupils (1 as wide as they go, -1 as narrow). `source`, `tags`, `place`: as of a face. `head`:
    yaw, pitch and roll, radians, of a face that answers with its head. `complexion`: what it does to the blood of
    cheeks, nose, forehead, eyes and the whole face, 1 a strong flush, below 0 pallor, to tears and to sweat."""

    name: str
    label: str
    kind: Kind
    region: str
    eyes: tuple[float, float, float, float]
    pupil: float
    source: str
    tags: list[str] = []
    place: float = 0.0
    head: tuple[float, float, float] = (0.0, 0.0, 0.0)
    complexion: ComplexionNumbers = PALE


class HairDocument(msgspec.Struct, frozen=True):
    """A hair style: where its strands are, and the shade on the skin that goes with it, 0..1."""

    name: str
    url: str
    scalp: float


class CrossingDocument(msgspec.Struct, frozen=True):
    """Where two lids or the lips may cross (`model.transfer.corrective_regions.Crossing`), little-endian.

    `upward`: rungs open along +y, else as at rest. `vertices` (32, 4) u32 and `near` (p,) u32: places in the
    document's rows; `weights` (32, 4), `side`, `share` (p,) f32.
    """

    upward: bool
    vertices: bytes
    weights: bytes
    near: bytes
    side: bytes
    share: bytes


class CorrectivesDocument(msgspec.Struct, frozen=True):
    """How stages correct sums that fold or pierce (`perform.blending.correctives`), little-endian.

    `rows` (m,) u32: rows of the positions, all else counts in them: `triangles` (t, 3) u32, `lids` and `eye` (r,) u32
    (0 left), `anchors` (f, k) u32; but `followers` (f,) u32 are rows of the positions too; `weights` (f, k) f32.
    An allowance counts triangles, then 32 rungs a crossing, then lids. Folds are damped in patches: `patch_triangles`
    (n,) u32, patch after patch, `patch_ends` (p,) u32; `row_patches` (m, j) u32 patches of a row, `row_shares` f32.
    """

    rounds: list[int]
    least_area: float
    floor: float
    over_relaxation: float
    least_slope: float
    full: float
    momentum: float
    margin: float
    farthest: float
    bulge: float
    cornea: float
    deep: float
    kept: float
    sliver: float
    rows: bytes
    triangles: bytes
    crossings: list[CrossingDocument]
    lids: bytes
    eye: bytes
    patch_triangles: bytes
    patch_ends: bytes
    row_patches: bytes
    row_shares: bytes
    followers: bytes
    anchors: bytes
    weights: bytes


class RegionDocument(msgspec.Struct, frozen=True):
    """How much of everything belongs to each region in which an expression can be called alone, brows, eyes, mouth,
    rest; 65535 is all. Little-endian: `rows` (n, 4) u16 of the positions, `allowances` (m, 4) u16 of the numbers of an
    allowance."""

    rows: bytes
    allowances: bytes


class LightDocument(msgspec.Struct, frozen=True):
    """A light that can be called."""

    name: str
    label: str


class BodyDocument(msgspec.Struct, frozen=True):
    """A body: where its rows are, and by how much it is drawn larger than its person is."""

    name: str
    label: str
    url: str
    size: float


class PoseDocument(msgspec.Struct, frozen=True):
    """A pose (`model.body.pose`), f32 little-endian: `turns` (bones, 3) radians, `feet` (2, 3) leg lengths,
    `feet_turns` (2, 3) radians; `travel` leg lengths. `source`: changes when an own pose is saved, as a face's."""

    name: str
    label: str
    source: str
    turns: bytes
    travel: tuple[float, float, float]
    feet: bytes
    feet_turns: bytes


class GarmentDocument(msgspec.Struct, frozen=True):
    """A garment that looks may name."""

    name: Name
    label: str


class FiguresDocument(msgspec.Struct, frozen=True):
    """The bodies, poses and garments of a cast; `url`: where its `FigureAsset` is."""

    url: str
    bodies: list[BodyDocument]
    poses: list[PoseDocument]
    garments: list[GarmentDocument]


class Manifest(msgspec.Struct, frozen=True):
    """All that a page needs to know of the cast; `vertices` counts skin then parts in the order of the meshes.

    `base`: the digest of the built-in cast, which stays as long as the server does; `digest`: with own things.
    `folding` (skin,) u8: how far expressions press each vertex together at most, of 255; empty: nothing folds."""

    version: int
    base: str
    digest: str
    vertices: int
    skin: int
    meshes: list[MeshDocument]
    lines: list[LineDocument]
    mask: str
    faces: list[FaceDocument]
    expressions: list[ExpressionDocument]
    lights: list[LightDocument]
    hair: list[HairDocument]
    correctives: CorrectivesDocument | None = None
    regions: RegionDocument | None = None
    folding: bytes = b""
    figures: FiguresDocument | None = None


class FaceAsset(msgspec.Struct, frozen=True):
    """The positions of a face, (vertices, 3) f32 little-endian, metres."""

    positions: bytes


class ContentAsset(msgspec.Struct, frozen=True):
    """An own face by its content, as `FaceDocument` and `FaceAsset` have it; its name is its content's key."""

    face: FaceDocument
    positions: bytes


class HairAsset(msgspec.Struct, frozen=True):
    """Strands of hair on the generic face (`model.hair.HairStyle`), little-endian; n strands of `stations` places.

    `scale`: metres per count of `points` (n, stations, 3) i16; `rows` (n, stations, links) u32 and `weights` u8 (counts
    that are to be divided by their sum); `anchors` (n,) u32; `facing` (n, stations, 3) i8, 127 is one; `light`
    (n, stations) u8, 255 is one; `fullness` (n,) u8, 255 is one: of `width`, metres.
    """

    stations: int
    links: int
    width: float
    scale: float
    points: bytes
    rows: bytes
    weights: bytes
    anchors: bytes
    facing: bytes
    light: bytes
    fullness: bytes


class LimbFieldAsset(msgspec.Struct, frozen=True):
    """A limb field: its channel's name, what drives it (`model.body.limb_field`); `places` (k,) u32 among the rows that
    lie on limbs, `values` (k, 3) f32: out (a ratio of the radius), round (radians), along (a ratio of the length)."""

    name: str
    driver: str
    places: bytes
    values: bytes


class FigureAsset(msgspec.Struct, frozen=True):
    """What all bodies share (`model.body.figure_space`), little-endian; V rows of the head's skin, B of the body.

    `bones`: their names, `parents` (bones,) i32 -1 for the first; `row_bones` (V + B, 8) u8, `row_weights` u16 of
    65535; `shares` (V + B,) u8, 255 is all of dual quaternions; `triangles` (t, 3) u32; `edge` (e,) u32 rows of the
    head, the first `rim` of them the rim; `joined` (n,) u32 rows of the body, `join` (n, e) f32; `head_joint` (h,) u32,
    `head_joint_offset` metres; `uvs` (k, 2) f32, `uv_rows` (t, 3) u32; `skirt` (s, 3) u32: its triangles, whose rows
    are the last of the body; `bending` (c,) u32 rows with correctives, `bending_hinges` (c,) u8; `garments` (g, V + B,
    4) f32, metres: cover, thick, trim and hidden of each garment, in the manifest's order (`model.body.garment`);
    `limb_rows` (l,) u32 rows that lie on limbs, `limbs` (l,) u8 which one, `limb_ways` (l,) f32 how far along it.
    """

    bones: list[str]
    parents: bytes
    head_rows: int
    row_bones: bytes
    row_weights: bytes
    shares: bytes
    triangles: bytes
    edge: bytes
    rim: int
    joined: bytes
    join: bytes
    head_joint: bytes
    head_joint_offset: tuple[float, float, float]
    uvs: bytes
    uv_rows: bytes
    skirt: bytes
    bending: bytes
    bending_hinges: bytes
    garments: bytes
    limb_rows: bytes
    limbs: bytes
    limb_ways: bytes
    limb_fields: list[LimbFieldAsset]


class BodyAsset(msgspec.Struct, frozen=True):
    """A body, f32 little-endian, metres: `positions` (B, 3), `edge` (e, 3), `joints` and `ends` (bones, 3),
    `correctives` (4 c, 3) of the rows that bend."""

    positions: bytes
    edge: bytes
    joints: bytes
    ends: bytes
    correctives: bytes


class AllowanceDocument(msgspec.Struct, frozen=True):
    """What one compound alone uses up of the correctives' limits (`perform.blending.correctives`), little-endian:
    `places` (n,) u32, `values` (n,) f32."""

    places: bytes
    values: bytes


class CompoundAsset(msgspec.Struct, frozen=True):
    """A retargeted expression: a compound minus its face at rest, little-endian: `scale` metres per count, `indices`
    (n,) u32, `deltas` (n, 3) i16."""

    scale: float
    indices: bytes
    deltas: bytes
    allowed: AllowanceDocument | None = None
