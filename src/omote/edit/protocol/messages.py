"""Every message between an editor page and the server; `tools/messages.py` mirrors them in TypeScript.

One WebSocket at `/editing`, binary MessagePack maps with a `type` tag, as on the show's link (`show/messages.py`).
Every request carries a number of the page's own; it is answered with the same number: `done`, `draft`, `saved` or
`refused`. Imports and exports go over HTTP with an id of
the page's own; `cancel` names it.
"""

from __future__ import annotations

import sys
from typing import Annotated, ClassVar, Literal, get_args

import msgspec

from omote.model.body.pose_recipe import Arm, Leg, PoseRecipe  # noqa: F401  (the same)
from omote.model.fitting.doubt import DoubtKind
from omote.model.recipes.recipe import FaceRecipe, GainRow, Layer, Pull, Recipe, Vector  # noqa: F401  (the same)
from omote.model.space.complexion import ComplexionNumbers
from omote.show.access.access_role import AccessRole
from omote.show.declaration import Message, Name, kinds_below
from omote.show.objects.link import Cancel, Notice, Notices, Progress  # noqa: F401  (the mirror has all)
from omote.show.validation import name_escapes
from omote.showfile.changes import Kind

EDITING_VERSION = 10
EDITING_PATH = "/editing"
EDITING_LIMIT = 65536
"""Bytes; no message of an editor is longer."""

EditorId = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
Text = Annotated[str, msgspec.Meta(max_length=200)]
Tags = Annotated[list[Name], msgspec.Meta(max_length=20)]
Rows = Annotated[list[int], msgspec.Meta(max_length=400)]
Vectors = Annotated[list[Vector], msgspec.Meta(max_length=400)]
Layers = Annotated[list[Layer], msgspec.Meta(max_length=200)]
Pulls = Annotated[list[Pull], msgspec.Meta(max_length=40)]

# --- editor to server -------------------------------------------------------------------------------------------------


class EditorMessage(Message, frozen=True):
    """A message of an editor. access: the role that it needs."""

    access: ClassVar[AccessRole] = "edit"


class EditorRequest(EditorMessage, frozen=True):
    """A message that is answered. request: a number of the page's own, which the answer carries."""

    request: int


class ItemRequest(EditorRequest, frozen=True):
    """A request about an item. of_deleted: whether it may be a deleted one."""

    of_deleted: ClassVar[bool] = False

    item: int


class DraftRequest(ItemRequest, frozen=True):
    """A request that waits for what is under way at this editor's draft of the item."""


class RecipeChange(DraftRequest, frozen=True):
    """A request that changes the recipe of a draft: a step that can be undone."""


class Greet(EditorMessage, frozen=True):
    """Opens the link; other messages before it are rejected. `editor` is stored by the browser, so a reload finds its
    draft."""

    access = "view"

    editor: EditorId
    name: Name
    version: int


class CreateExpression(EditorRequest, frozen=True):
    """A new expression, opened at once; start: what it begins from, by weight (built-in names, or `#` and a content
    key; empty: neutral); on_air: from what is on air now instead."""

    label: Name
    start: dict[str, float]
    on_air: bool


class CreateFace(EditorRequest, frozen=True):
    """A new face, opened at once, from a mix of faces (sources by weight); on_air: from what is on air now instead."""

    label: Name
    base: dict[str, float]
    on_air: bool


class CreatePose(EditorRequest, frozen=True):
    """A new pose, opened at once; start: the pose that it begins from (a built-in name, or `#` and a content key)."""

    label: Name
    start: Name


class OpenItem(DraftRequest, frozen=True):
    """Opens an item: this editor's draft of it, made from its newest revision where there is none."""


class CloseItem(DraftRequest, frozen=True):
    """Leaves an item; the draft stays."""

    of_deleted = True


class DragPoints(RecipeChange, frozen=True):
    """Control points (indices in the net) dropped at targets (metres, on this face): solved until they lie there.

    `vectors`: where the page's linearisation puts all points of the net, the start of the solve."""

    face: Name
    points: Rows
    targets: Vectors
    vectors: Vectors


class SetVectors(RecipeChange, frozen=True):
    """Vectors of the whole net at once: numeric entry, nudges, mirror, reset. `what` goes into the history."""

    vectors: Vectors
    what: Text


class SetNet(RecipeChange, frozen=True):
    """Other control points (rows of the sheet): the field stays, the net is built anew."""

    net: Rows


class SetLayers(RecipeChange, frozen=True):
    """The layers (weighted expressions, as of blendshapes) under the control points."""

    layers: Layers


class PreviewLayers(DraftRequest, frozen=True):
    """Asks for the draft as it would be with other layers; no step. alone: these layers and nothing else, no control
    points, muscles, eyes or ground."""

    layers: Layers
    alone: bool


class SetPulls(RecipeChange, frozen=True):
    """The muscles' contractions."""

    pulls: Pulls


class SetEyes(RecipeChange, frozen=True):
    """Eyeballs' angles (left yaw, pitch, right yaw, pitch, radians) and pupils."""

    eyes: tuple[float, float, float, float]
    pupil: float


class SetComplexion(RecipeChange, frozen=True):
    """Blood of cheeks, nose, forehead, eyes and the whole face, 1 a strong flush, below 0 pallor, and tears and sweat,
    1 as they run."""

    complexion: ComplexionNumbers


class Flatten(RecipeChange, frozen=True):
    """Bakes layers, muscles and control points into one field, on which the points stand at rest again; muted layers
    stay as they are."""


class SetFace(RecipeChange, frozen=True):
    """The whole recipe of a face. `what` goes into the history."""

    recipe: FaceRecipe
    what: Text


class SetPose(RecipeChange, frozen=True):
    """The whole recipe of a pose. `what` goes into the history."""

    recipe: PoseRecipe
    what: Text


class Undo(DraftRequest, frozen=True):
    """One step back in the draft."""


class Redo(DraftRequest, frozen=True):
    """One step forward again."""


class Save(DraftRequest, frozen=True):
    """Makes the draft a revision, which plays from now on, unless another editor saved meanwhile: then it is kept
    aside."""

    note: Text


class BringBack(DraftRequest, frozen=True):
    """Makes an old revision (one aside too) the newest step of the draft; saving it makes it play."""

    revision: int


class Describe(ItemRequest, frozen=True):
    """The label, tags and place of an item."""

    label: Name
    tags: Tags
    place: float


class Duplicate(ItemRequest, frozen=True):
    """A new item with the newest revision of another, under another label."""

    label: Name


class Delete(ItemRequest, frozen=True):
    """Takes an item out of the cast; its revisions stay. Refused while it is on air."""

    of_deleted = True


class Restore(ItemRequest, frozen=True):
    """Undoes a deletion."""

    of_deleted = True


class AskHistory(ItemRequest, frozen=True):
    """Asks for the revisions of an item."""

    access = "view"
    of_deleted = True


# --- server to editor -------------------------------------------------------------------------------------------------


class ItemDocument(msgspec.Struct, frozen=True):
    """An own item as lists show it; `content`: `#` and the key of what plays, "" before its first save; `editors`:
    names of those who have it open."""

    id: int
    kind: Kind
    name: str
    label: str
    tags: list[str]
    place: float
    head: int
    content: str
    deleted: bool
    editors: list[str]


class RevisionDocument(msgspec.Struct, frozen=True):
    """A revision as the history shows it; `content`: `#` and a key: any face can be asked to wear it."""

    number: int
    parent: int
    content: str
    written: float
    editor: str
    note: str
    aside: bool


class MuscleDocument(msgspec.Struct, frozen=True):
    """A muscle: its field at full contraction, little-endian f32 (V, 3): dtheta, dh, R - 1; its line on S as rows of
    the skin, from the bone to the skin (a sphincter: its ring)."""

    name: str
    label: str
    kind: Literal["linear", "sheet", "sphincter"]
    line: list[int]
    field: bytes


class NetDocument(msgspec.Struct, frozen=True):
    """A control net: `net` (n,) rows of the skin under its points; `triangles` (t, 3) u16 places, rings beyond n;
    `corners` (V, 3) u16 places and `weights` (V, 3) f32: the field at vertex v is the weighted sum of its corners'
    vectors (places from n on rest); off the sheet all weights are zero. All little-endian. `mirror`: for each point
    the place of its mirror image, its own on the midline, -1 for none."""

    net: list[int]
    triangles: bytes
    corners: bytes
    weights: bytes
    mirror: list[int]


class Greeted(Message, frozen=True):
    """Answers greet: the muscles, the regions, `masks`: how much each region owns of each vertex of the skin,
    (regions, V) u8 little-endian, 255 all; `followers`, `anchors`, `shares`: the rows (skin, then parts, as in the
    manifest) that follow the sheet, (f,) u32, (f, k) u32, (f, k) f32; all items; `show`: which show this is, as in
    `Welcome`: requests that wait for answers of another one are not sent again; `unsaved`: the items of which this
    editor has a draft that is not saved; `unwritable`: the endings of downloads that the show's computer cannot make,
    and why."""

    version: int
    digest: str
    show: str
    muscles: list[MuscleDocument]
    regions: list[str]
    masks: bytes
    followers: bytes
    anchors: bytes
    shares: bytes
    items: list[ItemDocument]
    unsaved: list[int]
    unwritable: dict[str, str]


class Items(Message, frozen=True):
    """All items, whenever one has changed, and the digest of the cast that pages may load now."""

    digest: str
    items: list[ItemDocument]


class DraftState(Message, frozen=True, tag="draft"):
    """The draft as it is after a request: its recipe, `content` (`#` and a key that `/compounds/` serves), how many
    steps can be undone and redone, whether it differs from revision `base`, what the last step was.

    `net` goes with the first draft of an expression and whenever the net changed. `miss`: how far the worst dragged
    point is from where it was put, metres. `others`: names of other editors at this item.
    """

    request: int
    item: int
    recipe: Recipe | FaceRecipe | PoseRecipe
    content: str
    undo: int
    redo: int
    base: int
    dirty: bool
    what: str
    net: NetDocument | None
    miss: float
    others: list[str]


class Previewed(Message, frozen=True):
    """Answers preview_layers; `content`: `#` and the key that `/compounds/` serves."""

    request: int
    item: int
    content: str


class Saved(Message, frozen=True):
    """A draft became a revision; `aside`: another editor had saved meanwhile, and what plays is `head`, theirs."""

    request: int
    item: int
    revision: int
    head: int
    aside: bool
    sentence: str


class History(Message, frozen=True):
    """The revisions of an item, oldest first."""

    request: int
    item: int
    revisions: list[RevisionDocument]


class Done(Message, frozen=True):
    """A request was carried out."""

    request: int


class EditRefused(Message, frozen=True, tag="refused"):
    """A request was rejected, and why, in one sentence; request -1: what came was no valid request."""

    request: int
    reason: str

    def __post_init__(self) -> None:
        msgspec.structs.force_setattr(self, "reason", name_escapes(self.reason))


FromEditor = EditorMessage | Cancel
ToEditor = Greeted | Items | DraftState | Previewed | Saved | History | Done | EditRefused | Notices | Progress

EDITOR_MESSAGES: tuple[type[Message], ...] = (*kinds_below(EditorMessage, [sys.modules[__name__]]), Cancel)
"""The kinds of messages of an editor, in the order of their declaration."""
ANSWERS: tuple[type[Message], ...] = get_args(ToEditor)


# --- documents over HTTP ----------------------------------------------------------------------------------------------


class TangentsAsset(msgspec.Struct, frozen=True):
    """The tangents of a face, its derivative by the field, `/tangents/FACE-CONTENT`: (3, V, 3) f32 little-endian,
    metres on the face per radian of dtheta, per metre of dh and per unit of R - 1, at each vertex of the sheet (zero
    off it)."""

    tangents: bytes


class HandlesAsset(msgspec.Struct, frozen=True):
    """Handles of the face editor, `/handles`: rows of the skin, their labels, `mirror` places as in a net."""

    points: list[int]
    labels: list[str]
    mirror: list[int]


class ScanFigures(msgspec.Struct, frozen=True):
    """How far a fitted face is from its scan, millimetres: half of what was seen of the face lies within `median`, 95 %
    of it within `p95`; `seen`: the part of the face that the scan shows, 0 to 1."""

    median: float
    p95: float
    seen: float


class ScanDoubt(msgspec.Struct, frozen=True):
    """What is not sure of a fitted scan; kind: what it is about, and so what ends it."""

    kind: DoubtKind
    sentence: str


class ScanPreview(msgspec.Struct, frozen=True):
    """A scan that an editor looks at before its face is taken, `/scans`.

    token: names it until it is taken or thrown away. placement: from the scan's own frame and unit to the face's
    metres: the scale, the rotation row by row, the shift. unit: the scan's, in words; doubts: what to look at,
    none when sure; notes: what of the file could not be used. given: points that people clicked, found:
    those that were found, by name, in the scan's own frame.
    positions (n, 3) float32 in the face's metres, triangles (t, 3) uint32 (none of a cloud), colours (n, 3) uint8
    (sRGB; none where the file has none): a thinned copy of the scan. face (v, 3) float32, residual (v,) float32 in
    millimetres (nan: not seen): the fitted face; None where none could be made. shut: what was said of the eyes.
    hair_style, hair: the style and the colour that are proposed.
    """

    token: str
    file: str
    placement: list[float]
    unit: str
    doubts: list[ScanDoubt]
    notes: list[str]
    given: dict[str, list[float]]
    found: dict[str, list[float]]
    positions: bytes
    triangles: bytes
    colours: bytes
    face: bytes | None = None
    residual: bytes | None = None
    figures: ScanFigures | None = None
    shut: bool | None = None
    hair_style: str = ""
    hair: str = ""


class PhotographPreview(msgspec.Struct, frozen=True):
    """A face made of photographs that an editor looks at before it is taken, `/photographs`.

    token: as a scan's, whose addresses take it and throw it away. doubts: what to look at, in sentences. off: how far
    the landmarks of each photograph lie from the face, pixels; spread: how far the face may lie from the person's,
    millimetres; seen: which share of its skin a photograph shows.
    positions (n, 3) float32 metres, triangles (t, 3) uint32, colours (n, 3) uint8 (sRGB): its skin as photographed.
    face (v, 3) float32: skin and parts; shown (s,) uint8: how well a photograph shows each vertex of the skin, 0 to
    255. hair_style, hair: the style and the colour that are proposed.
    """

    token: str
    doubts: list[str]
    off: list[float]
    spread: float
    seen: float
    positions: bytes
    triangles: bytes
    colours: bytes
    face: bytes
    shown: bytes
    hair_style: str
    hair: str
