"""Every message on the wire, once; `tools/messages.py` writes its TypeScript mirror, `web/src/link/messages.ts`.

Messages are MessagePack maps with a `type` tag. Numbers keep plain types here and pass `show/validation.py` when
they are used. Documents (manifest, face asset, compound) travel over HTTP, as MessagePack maps without a tag.
"""

from __future__ import annotations

import re
from typing import Annotated, Literal, get_args

import msgspec

PROTOCOL_VERSION = 4
LINK_PATH = "/link"
MESSAGE_LIMIT = 4096
"""Bytes; no message of a client is longer."""
STATE_RATE = 60.0
"""States per second."""

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
CallId = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
RequestId = Annotated[str, msgspec.Meta(max_length=64)]
Role = Literal["stage", "console"]
Level = Literal["lowest", "low", "medium", "high"]
ConsoleName = Annotated[str, msgspec.Meta(max_length=24)]
LayoutText = Annotated[str, msgspec.Meta(max_length=3600)]
Tags = Annotated[list[Name], msgspec.Meta(max_length=20)]
Kind = Literal["neutral", "performed", "arkit", "makehuman", "omote", "own"]
ItemKind = Literal["face", "expression"]


def snake_case(name: str) -> str:
    """The tag of a message class: `CallFace` gives `call_face`."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


class Message(msgspec.Struct, frozen=True, tag_field="type", tag=snake_case):
    """A message with its tag."""


# --- client to server -------------------------------------------------------------------------------------------------


class Hello(Message, frozen=True):
    """Opens a link; other messages are rejected before it. `name`: what a console's operator calls it, or what it was
    called the last time; a second hello changes it. `page`: the same for each link of one page, another for each page.
    """

    role: Role
    version: int
    name: ConsoleName = ""
    page: Annotated[str, msgspec.Meta(max_length=64)] = ""


class CallFace(Message, frozen=True):
    """Brings a face on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once."""

    id: CallId
    name: Name
    seconds: float | None
    easing: Name


class CallExpression(Message, frozen=True):
    """Brings an expression on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once."""

    id: CallId
    name: Name
    seconds: float | None
    easing: Name


class CallLight(Message, frozen=True):
    """Brings a light on air in `seconds`, from whatever light shows. An `id` executes once."""

    id: CallId
    name: Name
    seconds: float
    easing: Name


class FadeFace(Message, frozen=True):
    """The position of the face T-bar, 0..1."""

    value: float


class ReleaseFace(Message, frozen=True):
    """The operator lets go of the face T-bar."""


class FadeExpression(Message, frozen=True):
    """The position of the expression T-bar, 0..1."""

    value: float


class ReleaseExpression(Message, frozen=True):
    """The operator lets go of the expression T-bar."""


class SetChannel(Message, frozen=True):
    """The weight of one channel (a blendshape weight; any expression's name), -0.5..1.5."""

    name: Name
    value: float


class SetHead(Message, frozen=True):
    """The head's direction in radians: + is the character's left, up, tilt to its left."""

    yaw: float
    pitch: float
    roll: float


class SetGaze(Message, frozen=True):
    """The gaze relative to the head in radians: + is the character's left, up.

    At most 0.698 sideways, 0.524 up or down: beyond, the iris would go out of sight.
    """

    yaw: float
    pitch: float


class Panic(Message, frozen=True):
    """The face on air goes neutral and holds still, now; while `State.home_next` is true it brings the home face."""


class SetHome(Message, frozen=True):
    """The face that a second panic brings on air, and the seconds that it takes; it stays with the show."""

    face: Name
    seconds: float


class KeepFace(Message, frozen=True):
    """Keeps the mix of faces on air as a new own face. An `id` executes once; answered with `kept`."""

    id: CallId


class KeepExpression(Message, frozen=True):
    """Keeps expressions, channels and gaze on air as a new own expression. An `id` executes once; answered with
    `kept`."""

    id: CallId


class RenameItem(Message, frozen=True):
    """Gives an own face or expression another label, which no other of its kind has. An `id` executes once; answered,
    as the two below, with `item_changed`."""

    id: CallId
    kind: ItemKind
    name: Name
    label: Name


class DeleteItem(Message, frozen=True):
    """Takes an own face or expression out of the cast; rejected while it is on air or the home face. `unedited`:
    rejected too once somebody has worked on what a console kept."""

    id: CallId
    kind: ItemKind
    name: Name
    unedited: bool = False


class RestoreItem(Message, frozen=True):
    """Puts a deleted face or expression back into the cast."""

    id: CallId
    kind: ItemKind
    name: Name


class CopyItem(Message, frozen=True):
    """Copies an own face or expression to a new one under a label of its own. An `id` executes once; answered with
    `kept`."""

    id: CallId
    kind: ItemKind
    name: Name


class SetLayout(Message, frozen=True):
    """Stores a page's layout (JSON) in the show file under a name; `/layouts/NAME` returns it. Answered, as the two
    below, with `layouts`; `id`: named where it is rejected."""

    name: Name
    document: LayoutText
    id: RequestId = ""


class RenameLayout(Message, frozen=True):
    """Gives a layout of the show file another name, which none has yet."""

    name: Name
    to: Name
    id: RequestId = ""


class DropLayout(Message, frozen=True):
    """Takes a layout out of the show file."""

    name: Name
    id: RequestId = ""


class Cancel(Message, frozen=True):
    """Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
    the page's own. One that has ended is left as it is."""

    request: CallId


class Ping(Message, frozen=True):
    """Asks for a pong; `sent` is the client's own clock and comes back unchanged."""

    sent: float


class Drawing(Message, frozen=True):
    """A stage's heartbeat, once a second: the rate of frames that it really drew, and its level of quality."""

    fps: float
    level: Level


# --- server to client -------------------------------------------------------------------------------------------------


class Welcome(Message, frozen=True):
    """Answers hello: `epoch` rises with each server start, `revision` with each change of the documents. `name`: what
    the others call this console."""

    version: int
    epoch: int
    revision: int
    digest: str
    name: str = ""


class CastChanged(Message, frozen=True, tag="cast"):
    """The cast has changed: pages fetch the manifest again and go on."""

    revision: int
    digest: str


class Kept(Message, frozen=True):
    """Answers keep_face, keep_expression and copy_item: the new name in the cast, and its label."""

    id: str
    name: str
    label: str


class ItemChanged(Message, frozen=True):
    """Answers rename_item, delete_item and restore_item: the label of the item now, and before."""

    id: str
    label: str
    before: str


class Layouts(Message, frozen=True):
    """The names of all layouts in the show file, sorted: complete, to consoles after the welcome and with each
    change."""

    names: list[str]


class Hands(Message, frozen=True):
    """What hands at other consoles have moved within the last second, and the name of the console: complete, to each
    console when it changes, and once a second. Keys are tags of messages (`fade_face`, `set_head`), of a channel with
    its name (`set_channel:jawOpen`)."""

    hands: dict[str, str]


class CallState(msgspec.Struct, frozen=True):
    """A running call: `progress` 0..1, `remaining` seconds (`None`: the T-bar decides).

    `fader`: where its T-bar stands; `pickup`: where that takes over. Both 0..1. `start`: the mix that it left.
    """

    target: str
    progress: float
    remaining: float | None
    by_hand: bool
    fader: float
    pickup: float
    start: dict[str, float]


class State(Message, frozen=True):
    """All that is on air: complete and absolute; the highest (epoch, number) wins, any may be lost.

    `time`: the show's clock, seconds. `head`: yaw, pitch, roll; `gaze`: yaw, pitch; `eyes`: left yaw, pitch, right yaw,
    pitch (radians), as the eyeballs stand. `lids`: what the gaze adds to the channels.
    `face_fader`, `expression_fader`: where the T-bars stand, 0..1, with or without a call. `light`: sums to one.
    `panics` counts them: when it rises, hands are off. `home_next`: the next one brings `home_face` in `home_seconds`.
    """

    epoch: int
    number: int
    time: float
    revision: int
    faces: dict[str, float]
    expressions: dict[str, float]
    channels: dict[str, float]
    head: tuple[float, float, float]
    gaze: tuple[float, float]
    eyes: tuple[float, float, float, float]
    lids: dict[str, float]
    face_call: CallState | None
    expression_call: CallState | None
    face_fader: float
    expression_fader: float
    light: dict[str, float]
    light_call: CallState | None
    panics: int
    home_face: str
    home_seconds: float
    home_next: bool


class Pong(Message, frozen=True):
    """Answers ping: `time` is the show's clock at that moment, as in `State.time`."""

    sent: float
    time: float


class Refused(Message, frozen=True):
    """A message was rejected, and why, in one sentence for the operator. `id`: of the message, where it had one, also
    where nothing else of it could be read."""

    reason: str
    id: str = ""


class Notice(msgspec.Struct, frozen=True):
    """What the crew must know until each has dismissed it; `id` is its own for ever, `time` seconds since 1970."""

    id: str
    time: float
    text: str


class Notices(Message, frozen=True):
    """All notices of this show, oldest first: complete, so any may be lost. Consoles and editors get them after the
    welcome, with each new one, and once a second while there are any."""

    notices: list[Notice]


class Progress(Message, frozen=True):
    """How far a long request (an import, an export) is: steps done of `total` (0: not known yet), and what is done now,
    for people. To consoles and editors; any may be lost, and the request's own answer says that it has ended."""

    request: str
    done: int
    total: int
    what: str


class StageReport(msgspec.Struct, frozen=True):
    """The last report of a stage: frames per second, and the level of quality."""

    fps: float
    level: Level


class Crew(Message, frozen=True):
    """Who is connected, once a second, with each stage's last report (`None`: it is silent).

    `lost`: stages whose link broke while their page was open, and that have not come back.
    """

    stages: list[StageReport | None]
    consoles: int
    lost: int = 0


KeepMessage = (
    KeepFace | KeepExpression | RenameItem | DeleteItem | RestoreItem | CopyItem | SetLayout | RenameLayout | DropLayout
)
"""What a console asks of the show file."""
FromClient = (
    Hello
    | CallFace
    | CallExpression
    | CallLight
    | FadeFace
    | ReleaseFace
    | FadeExpression
    | ReleaseExpression
    | SetChannel
    | SetHead
    | SetGaze
    | Panic
    | SetHome
    | KeepFace
    | KeepExpression
    | RenameItem
    | DeleteItem
    | RestoreItem
    | CopyItem
    | SetLayout
    | RenameLayout
    | DropLayout
    | Cancel
    | Ping
    | Drawing
)
FromServer = (
    Welcome | CastChanged | State | Pong | Kept | ItemChanged | Refused | Notices | Layouts | Hands | Progress | Crew
)


# --- documents over HTTP ----------------------------------------------------------------------------------------------


class Look(msgspec.Struct, frozen=True):
    """Colours of a face, each `#rrggbb`, the hair style, and the traits, plain numbers (`model.cast.Look`)."""

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
    `gains`: those that differ from a person's.
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


class ExpressionDocument(msgspec.Struct, frozen=True):
    """An expression: its palette, its region, its eyeball angles in radians (left yaw, pitch, right yaw, pitch), and
    what it adds to the pupils (1 as wide as they go, -1 as narrow). `source`, `tags`, `place`: as of a face. `head`:
    yaw, pitch and roll, radians, of a face that answers with its head."""

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


class HairDocument(msgspec.Struct, frozen=True):
    """A hair style: where its strands are."""

    name: str
    url: str


class CrossingDocument(msgspec.Struct, frozen=True):
    """Where two lids or the lips may cross (`model.transfer.corrective_regions.Crossing`), little-endian.

    `upward`: rungs open along +y, else as at rest. `vertices` (32, 4) u32 and `near` (p,) u32: places in the settling's
    rows; `weights` (32, 4), `side`, `share` (p,) f32.
    """

    upward: bool
    vertices: bytes
    weights: bytes
    near: bytes
    side: bytes
    share: bytes


class SettlingDocument(msgspec.Struct, frozen=True):
    """Correctives: how stages repair sums that fold or pierce (`perform.blending.correctives`), little-endian.

    `rows` (m,) u32: rows of the positions, all else counts in them: `triangles` (t, 3) u32, `lids` and `eye` (r,) u32
    (0 left), `anchors` (f, k) u32; but `followers` (f,) u32 are rows of the positions too; `weights` (f, k) f32.
    An allowance counts triangles, then 32 rungs a crossing, then lids.
    """

    rounds: int
    upright: float
    eager: float
    flattest: float
    full: float
    bulge: float
    cornea: float
    rows: bytes
    triangles: bytes
    crossings: list[CrossingDocument]
    lids: bytes
    eye: bytes
    followers: bytes
    anchors: bytes
    weights: bytes


class LightDocument(msgspec.Struct, frozen=True):
    """A light that can be called."""

    name: str
    label: str


class Manifest(msgspec.Struct, frozen=True):
    """All that a page needs to know of the cast; `vertices` counts skin then parts in the order of the meshes.

    `base`: the digest of the built-in cast, which stays as long as the server does; `digest`: with own things."""

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
    settling: SettlingDocument | None = None


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
    (n, stations) u8, 255 is one; `width` metres.
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


CLIENT_MESSAGES: tuple[type[Message], ...] = get_args(FromClient)
SERVER_MESSAGES: tuple[type[Message], ...] = get_args(FromServer)
DOCUMENTS: tuple[type[msgspec.Struct], ...] = (Manifest, FaceAsset, ContentAsset, HairAsset, CompoundAsset)
