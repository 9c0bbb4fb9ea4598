"""Every message on the wire, once; `tools/messages.py` writes its TypeScript mirror, `web/src/link/messages.ts`.

Messages are MessagePack maps with a `type` tag. Numbers keep plain types here and pass `show/validation.py` when
they are used. Documents (manifest, face asset, compound) travel over HTTP, as MessagePack maps without a tag.
"""

from __future__ import annotations

import re
from typing import Annotated, Literal, get_args

import msgspec

from omote.model.known_names import PlayRegion
from omote.perform.frame import TargetKind
from omote.perform.gestures.gesture_curves import GestureName
from omote.perform.layers.layer_names import LayerName, LayerPart
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.perform.speech.number_words import Language
from omote.perform.speech.speech_timing import TimingKind
from omote.show.access.access_documents import (  # noqa: F401  (the mirror has all)
    ACCESS_DOCUMENTS,
    AccessDocument,
    CodeDocument,
    NewPerson,
    PeopleDocument,
    PersonDocument,
)

PROTOCOL_VERSION = 7
LINK_PATH = "/link"
MESSAGE_LIMIT, SPEECH_LIMIT = 4096, 32768
"""Bytes; no message of a client is longer, and no `say`: 2000 characters of any script and the times of 1000 words."""
STATE_RATE = 60.0
"""States per second."""

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
CharacterName = Annotated[str, msgspec.Meta(min_length=1, max_length=24)]
PointName = Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
StageName = Annotated[str, msgspec.Meta(max_length=24)]
CallId = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
RequestId = Annotated[str, msgspec.Meta(max_length=64)]
Role = Literal["stage", "console"]
Level = Literal["lowest", "low", "medium", "good", "high"]
ConsoleName = Annotated[str, msgspec.Meta(max_length=24)]
LayoutText = Annotated[str, msgspec.Meta(max_length=3600)]
Tags = Annotated[list[Name], msgspec.Meta(max_length=20)]
Kind = Literal["neutral", "performed", "arkit", "makehuman", "omote", "own"]
ItemKind = Literal["face", "expression"]
LeasePart = Literal[
    "face", "expression", "brows", "eyes", "mouth", "channels", "head", "gaze", "place", "light", "framing", "*"
]
DeviceName = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
ControlName = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
DeviceKind = Literal["midi", "gamepad", "space_mouse"]
SourceKind = Literal["midi", "gamepad", "space_mouse", "osc", "sacn", "artnet", "tracker"]
StreamKind = Literal["tracker", "lips", "playback", "program", "breath", "gaze", "blink"]
CalibrationStep = Literal["neutral", "range", "done", "reset"]
SoundState = Literal["", "blocked", "ready"]
MOST_MARKS = 1000
"""Words, characters or mouth shapes of one message."""
MOST_NAMES = 200
"""Channels of a source."""


def snake_case(name: str) -> str:
    """The tag of a message class: `CallFace` gives `call_face`."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


class Message(msgspec.Struct, frozen=True, tag_field="type", tag=snake_case):
    """A message with its tag."""


# --- client to server -------------------------------------------------------------------------------------------------
# `character`: whom a message is for, "*" for all of them where it plays; one that is unknown is rejected.


class Hello(Message, frozen=True):
    """Opens a link; other messages are rejected before it. `name`: what a console's operator calls it, or what it was
    called the last time; a second hello changes it. `page`: the same for each link of one page, another for each page.
    `seat`: of the operator, whom a reload and a lost link do not change; without one it is the page's.
    """

    role: Role
    version: int
    name: ConsoleName = ""
    page: Annotated[str, msgspec.Meta(max_length=64)] = ""
    seat: Annotated[str, msgspec.Meta(max_length=64)] = ""


class CallFace(Message, frozen=True):
    """Brings a face on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once."""

    character: CharacterName
    id: CallId
    name: Name
    seconds: float | None
    easing: Name


class CallExpression(Message, frozen=True):
    """Brings an expression on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once.

    `region`: where alone it is called, in its own time, which no T-bar moves; `None`: on the whole face. `strength`:
    how much of it, 0 (neutral) to 1; no T-bar moves a call of less than all.
    """

    character: CharacterName
    id: CallId
    name: Name
    seconds: float | None
    easing: Name
    region: PlayRegion | None = None
    strength: float = 1.0


class CallLight(Message, frozen=True):
    """Brings a light on air in `seconds`, from whatever light shows. An `id` executes once."""

    id: CallId
    name: Name
    seconds: float
    easing: Name


class FadeFace(Message, frozen=True):
    """The position of the face T-bar, 0..1."""

    character: CharacterName
    value: float


class ReleaseFace(Message, frozen=True):
    """The operator lets go of the face T-bar."""

    character: CharacterName


class FadeExpression(Message, frozen=True):
    """The position of the expression T-bar, 0..1."""

    character: CharacterName
    value: float


class ReleaseExpression(Message, frozen=True):
    """The operator lets go of the expression T-bar."""

    character: CharacterName


class SetChannel(Message, frozen=True):
    """The weight of one channel (a blendshape weight; any expression's name), -0.5..1.5."""

    character: CharacterName
    name: Name
    value: float


class SetHead(Message, frozen=True):
    """The head's direction in radians: + is the character's left, up, tilt to its left."""

    character: CharacterName
    yaw: float
    pitch: float
    roll: float


class SetGaze(Message, frozen=True):
    """The gaze relative to the head in radians: + is the character's left, up.

    At most 0.698 sideways, 0.524 up or down: beyond, the iris would go out of sight.
    """

    character: CharacterName
    yaw: float
    pitch: float


class Panic(Message, frozen=True):
    """The face on air goes neutral and holds still, now; while `CharacterState.home_next` is true it brings the home
    face."""

    character: CharacterName


class SetHome(Message, frozen=True):
    """The face that a second panic brings on air, and the seconds that it takes; it stays with the show."""

    character: CharacterName
    face: Name
    seconds: float


class KeepFace(Message, frozen=True):
    """Keeps the mix of faces on air as a new own face. An `id` executes once; answered with `kept`."""

    character: CharacterName
    id: CallId


class KeepExpression(Message, frozen=True):
    """Keeps expressions, channels and gaze on air as a new own expression. An `id` executes once; answered with
    `kept`."""

    character: CharacterName
    id: CallId


class AddCharacter(Message, frozen=True):
    """Adds a character, which waits off stage at a free place until it enters. `character`: its name for ever, lower
    case letters, digits, `_` and `-`; `label`: what people call it. `face` is its home face too. An `id` executes once,
    as of the messages below."""

    id: CallId
    character: CharacterName
    label: Name
    face: Name


class RemoveCharacter(Message, frozen=True):
    """Takes a character out of the scene: it leaves the stage first, in `seconds`, and no shot holds it any more; until
    it is gone an `enter_character` keeps it. The last one stays. `key`: what `restore_character` finds it by, "" for
    its name."""

    id: CallId
    character: CharacterName
    key: RequestId = ""
    seconds: float = 1.0


class RestoreCharacter(Message, frozen=True):
    """Brings back a character that was removed, one of the last sixteen: all that it had on air, its place, rank and
    shot, unless another was called since. It enters in `seconds`, if it was on the stage."""

    id: CallId
    key: CallId
    seconds: float


class RenameCharacter(Message, frozen=True):
    """Gives a character another label."""

    id: CallId
    character: CharacterName
    label: Name


class PlaceCharacter(Message, frozen=True):
    """Moves a character to a place in `seconds`, from wherever it is: the fields are those of `Place`. A hand that
    drags sends many, the newest wins."""

    character: CharacterName
    x: float
    depth: float
    size: float
    turn: float
    seconds: float
    id: RequestId = ""


class EnterCharacter(Message, frozen=True):
    """Brings a character onto the stage in `seconds`."""

    id: CallId
    character: CharacterName
    seconds: float


class LeaveCharacter(Message, frozen=True):
    """Takes a character off the stage in `seconds`; it stays in the scene."""

    id: CallId
    character: CharacterName
    seconds: float


class CallFraming(Message, frozen=True):
    """Brings a framing on air in `seconds`, from whatever the picture shows: a shot of these characters, or of all that
    are on the stage where none is named."""

    id: CallId
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)]
    seconds: float
    easing: Name


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


# --- layers and sources ---


class SetLayer(Message, frozen=True):
    """How much of a layer of a character shows, 0..1, in a region of it (`None`: everywhere), and whether it is on;
    `None` leaves either as it is. What is on air follows."""

    character: CharacterName
    layer: LayerName
    region: LayerPart | None = None
    influence: float | None = None
    on: bool | None = None
    id: RequestId = ""


class SetMotion(Message, frozen=True):
    """How much a character moves by itself: `liveliness` 0 (nothing) to 1, 0.5 as people move; `blinks`, `gaze` and
    `breath` each beside the others, 0..2; `seed`: which of all ways to move; `idle`: whether it moves as people do
    while its tracker is lost, where the liveliness is 0 too. `None` leaves a setting as it is."""

    character: CharacterName
    liveliness: float | None = None
    blinks: float | None = None
    gaze: float | None = None
    breath: float | None = None
    seed: int | None = None
    id: RequestId = ""
    idle: bool | None = None


class LookAt(Message, frozen=True):
    """Whom or what the eyes of a character look at by its automatic motion: `ahead`, nothing; `direction`, `yaw` and
    `pitch` of the house in radians, + to the picture's right and up; `point`, `x` metres to the picture's right, `y`
    above the eyes, `z` before the front line; by `name`: a `gaze_point`, a `character`, the camera of a `stage` ("" for
    any). Rejected where there is none of that name."""

    character: CharacterName
    kind: TargetKind
    name: Annotated[str, msgspec.Meta(max_length=80)] = ""
    yaw: float = 0.0
    pitch: float = 0.0
    x: float = 0.0
    y: float = 0.0
    z: float = 2.0
    id: RequestId = ""


class SetGazePoint(Message, frozen=True):
    """Names a point of the house that eyes may look at, such as a seat, or moves it: metres as of `look_at`. It is kept
    with the show. An `id` executes once, as of the one below."""

    id: CallId
    name: PointName
    x: float
    y: float
    z: float


class DeleteGazePoint(Message, frozen=True):
    """Forgets a gaze point; who looked at it looks ahead."""

    id: CallId
    name: PointName


class Say(Message, frozen=True):
    """A character speaks: its lips move in time with a sound. `timing`: what `marks` are, each beginning at its place
    of `times` (float32, little-endian, seconds from the beginning of the sound; one more is the end of the last):
    words, characters, visemes (Oculus), azure (ids), rhubarb (letters); `text`: none, the text's letters are timed by
    rule, in `language`. `seconds`: the length, where it is known. `sound`: the key of one that was sent to `/sounds`,
    which one stage plays; "": something else does. `delay`: seconds until the sound begins; `offset`: by which the
    mouth is later. `queue`: after all that is said already, else in its place. `key`: what to call it: the
    state's `speech.keys` have it until it is over, and `spoken` once it was said to its end. An `id` executes once."""

    character: CharacterName
    id: CallId
    text: Annotated[str, msgspec.Meta(max_length=2000)] = ""
    timing: TimingKind = "text"
    marks: Annotated[list[Annotated[str, msgspec.Meta(max_length=80)]], msgspec.Meta(max_length=MOST_MARKS)] = []
    times: Annotated[bytes, msgspec.Meta(max_length=4 * (MOST_MARKS + 1))] = b""
    language: Language = "en"
    seconds: float | None = None
    sound: Annotated[str, msgspec.Meta(max_length=64)] = ""
    delay: float = 0.0
    offset: float = 0.0
    queue: bool = False
    key: Annotated[str, msgspec.Meta(max_length=64)] = ""


class StopSpeaking(Message, frozen=True):
    """Ends what a character says, and all that it would say after: its mouth goes to rest."""

    character: CharacterName
    id: RequestId = ""


class MakeGesture(Message, frozen=True):
    """A short motion on top of all that plays: nod, shake, tilt, bow, shrug, brows or wink. `amplitude`: -2..2, 1 as it
    is, below 0 to the other side; `seconds`: 0.2..10, `None` as long as it takes. An `id` executes once."""

    character: CharacterName
    id: CallId
    name: GestureName
    amplitude: float = 1.0
    seconds: float | None = None


class Source(Message, frozen=True):
    """Something that sends values all the time: a tracker, a microphone, a program. `names`: the expressions (channels)
    that each of its frames has a value for. `characters`: whom it drives, where it says so; else the route that was
    made for its name the last time. `performer`: whose face it sees, by whose calibration it is read; "" for one of its
    own. `smoothing`: seconds, to 2, in which its steps are followed, 0 as its layer is. `direct`: its frames are smooth
    already and show as they are. Answered with `source_is`; the end of its link is its end."""

    name: Name
    kind: StreamKind
    names: Annotated[list[Name], msgspec.Meta(max_length=MOST_NAMES)]
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)] = []
    performer: Annotated[str, msgspec.Meta(max_length=80)] = ""
    id: RequestId = ""
    smoothing: float = 0.0
    direct: bool = False


class Drive(Message, frozen=True):
    """One frame of a source, the newest wins: `values` as float32, little-endian, in the order of its names, -0.5..1.5;
    `head` (yaw, pitch, roll) and `gaze` (yaw, pitch) in radians, or `None`. `found`: false while it does not see its
    performer. Half a second without one that is found, and its layers fade out. `share`, of a direct source: how much
    of its layer it takes, 0..1; none while a voice is silent, so that what lies below shows."""

    index: int
    values: Annotated[bytes, msgspec.Meta(max_length=4 * MOST_NAMES)]
    head: tuple[float, float, float] | None = None
    gaze: tuple[float, float] | None = None
    found: bool = True
    share: float = 1.0


class LeaveSource(Message, frozen=True):
    """A source of this link ends; its layers fade out."""

    index: int


class RouteSource(Message, frozen=True):
    """Which characters a source drives, on which layer, in which regions (none named: all). It stays with the show
    under the source's name. An `id` executes once, as of the two below."""

    id: CallId
    source: Name
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)]
    layer: LayerName
    regions: Annotated[list[LayerPart], msgspec.Meta(max_length=6)] = []


class CalibrateSource(Message, frozen=True):
    """Measures the performer before a source: `neutral` takes what it sends now as the face at rest, `range` listens to
    the performer's largest moves until `done`, `reset` forgets both. `channels`: those that a range is of; none named:
    all. It stays with the show under the performer."""

    id: CallId
    source: Name
    step: CalibrationStep
    channels: Annotated[list[Name], msgspec.Meta(max_length=MOST_NAMES)] = []


class MeasureSource(Message, frozen=True):
    """Sets what was measured of the performer before a source, by channel: the face at rest and the largest moves, as
    `SourceState` tells them. So a measure is taken back, or comes from a program."""

    id: CallId
    source: Name
    neutral: dict[str, float]
    highest: dict[str, float]


class TuneSource(Message, frozen=True):
    """How a source is read: `mirror` swaps left and right; less than `dead_zone` (0..0.5) is nothing; `curve` -1..1:
    above 0 small moves grow, below they shrink; `gain` 0..4 of all channels, `lids` 0..4 beside it of those that shut
    the eyes; `smoothing` 0..2: seconds in which a step is followed, 0 as the source asks or its layer is."""

    id: CallId
    source: Name
    mirror: bool
    dead_zone: float
    curve: float
    gain: float
    smoothing: float = 0.0
    lids: float = 1.0


class WatchSource(Message, frozen=True):
    """Asks for what a source sends, as it comes (`SourceValues`): for a page that shows it; "" ends it."""

    source: Annotated[str, msgspec.Meta(max_length=80)]


class Cancel(Message, frozen=True):
    """Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
    the page's own. One that has ended is left as it is."""

    request: CallId


class Ping(Message, frozen=True):
    """Asks for a pong; `sent` is the client's own clock and comes back unchanged."""

    sent: float


class Drawing(Message, frozen=True):
    """A stage's heartbeat, once a second: the rate of frames that it really drew, and its level of quality. `name`: as
    its address has it; `camera`: where that is, metres as of `look_at`. `sound`: whether it can play sounds: "" never,
    `blocked` until somebody clicks it, `ready`; `sound_here`: its address asks that it plays them."""

    fps: float
    level: Level
    name: StageName = ""
    camera: tuple[float, float, float] | None = None
    sound: SoundState = ""
    sound_here: bool = False


# --- leases -----------------------------------------------------------------------------------------------------------
# `part`: of a character, or `light` and `framing` of the scene, whose character is "*"; "*" for all parts.


class Lease(Message, frozen=True):
    """Holds a part of a character: nobody else may play it until it is released; of one that the seat holds already,
    answers those who want it that it is kept. Rejected where another seat holds it, but for `take_over`; all parts of
    others are the stage manager's to take over. An `id` executes once, as of the messages below."""

    id: CallId
    character: CharacterName
    part: LeasePart
    take_over: bool = False


class ReleaseLease(Message, frozen=True):
    """Releases a part, or takes back the wish for one that another holds; "*": all of a character, or of all."""

    id: CallId
    character: CharacterName
    part: LeasePart


class SetLeases(Message, frozen=True):
    """Switches leases on, which makes the sender's seat the stage manager, or off, which releases all; on again, while
    no stage manager is there, makes the sender the stage manager."""

    id: CallId
    on: bool


class AppointManager(Message, frozen=True):
    """Makes another seat the stage manager, by its number; the stage manager alone may."""

    id: CallId
    seat: int


# --- devices ---
# Devices at a page, and what their controls play. A device belongs to one page at a time, the first that plugs it in.


class BindingDocument(msgspec.Struct, frozen=True):
    """A control of a device, and what it plays (`inputs/bindings`).

    `control`: as a reading names it (`1/cc7`, `1/note60`, `axis0`); `to`: an address of OSC with its character, or
    `bank:NAME`. `axis`: `yaw` of a head; `arguments`: of a call. `low`, `high`: values at both ends of the control
    (nil: the target's own); `curve`: exponent between them; `pick_up`: a fader acts once it has crossed the value on
    air. `button`: how a key moves a level, `relative`: how an encoder counts, "" for neither; `step`: the part of the
    range that one step moves. `bank`: where it plays, "" in all.
    """

    device: DeviceName
    control: ControlName
    to: Annotated[str, msgspec.Meta(min_length=1, max_length=160)]
    axis: Annotated[str, msgspec.Meta(max_length=24)] = ""
    arguments: Annotated[list[float | str], msgspec.Meta(max_length=8)] = []
    low: float | None = None
    high: float | None = None
    curve: float = 1.0
    pick_up: bool = True
    button: Literal["", "momentary", "toggle"] = ""
    relative: Literal["", "twos_complement", "binary_offset", "sign_magnitude"] = ""
    step: float = 1.0 / 128.0
    bank: Annotated[str, msgspec.Meta(max_length=80)] = ""


class Plug(Message, frozen=True):
    """A device is at this page from now on, until `unplug` or the end of the link. Rejected while another page has one
    of that name: two of a kind need two names."""

    device: DeviceName
    kind: DeviceKind
    id: RequestId = ""


class Unplug(Message, frozen=True):
    """A device is gone; its bindings wait for it."""

    device: DeviceName


class MidiBytes(Message, frozen=True):
    """What a MIDI device has sent, as it came."""

    device: DeviceName
    data: Annotated[bytes, msgspec.Meta(max_length=1024)]


class Controls(Message, frozen=True):
    """Where controls of a gamepad or a space mouse stand now, those that have moved: 0..1, an axis rests at .5; one
    whose name begins with `button` is a key."""

    device: DeviceName
    values: Annotated[dict[ControlName, float], msgspec.Meta(max_length=64)]


class Bind(Message, frozen=True):
    """Binds a control, in the place of the same one with the same target, and of `replaces`. An `id` executes once;
    answered, as the messages below that have one, with `bindings_changed`."""

    id: CallId
    binding: BindingDocument
    replaces: BindingDocument | None = None


class Unbind(Message, frozen=True):
    """Takes a binding away."""

    id: CallId
    binding: BindingDocument


class Learn(Message, frozen=True):
    """Binds the next control that moves to an address, in the place of nothing; `to` "" stops. Ends by itself after
    half a minute."""

    id: CallId
    to: Annotated[str, msgspec.Meta(max_length=160)]
    axis: Annotated[str, msgspec.Meta(max_length=24)] = ""
    arguments: Annotated[list[float | str], msgspec.Meta(max_length=8)] = []
    bank: Annotated[str, msgspec.Meta(max_length=80)] = ""


class LoadPreset(Message, frozen=True):
    """Binds a device as a preset has it, in the place of all its bindings; `character`: whom it plays, `*` all."""

    id: CallId
    device: DeviceName
    preset: Name
    character: CharacterName = "*"


class RestoreBindings(Message, frozen=True):
    """Takes back what the message of the id `change` did to the bindings; that can be taken back itself."""

    id: CallId
    change: CallId


class ChooseBank(Message, frozen=True):
    """Turns a device to one of its banks, "" to none."""

    device: DeviceName
    bank: Annotated[str, msgspec.Meta(max_length=80)]


class WatchDevices(Message, frozen=True):
    """This page shows devices from now on, or no more: while it does it hears of them ten times a second."""

    on: bool


class SwitchDevice(Message, frozen=True):
    """Switches on or off what is heard (`listen`: a tracker) or told (`send`: a receiver of faces), by the word that
    stands after `--listen` or `--send`."""

    direction: Literal["listen", "send"]
    word: Annotated[str, msgspec.Meta(min_length=1, max_length=200)]
    on: bool
    id: RequestId = ""


# --- server to client -------------------------------------------------------------------------------------------------


class Welcome(Message, frozen=True):
    """Answers hello: `epoch` rises with each server start, `revision` with each change of the documents. `name`: what
    the others call this console. `show`: which show file is played, "" for none; another one has another."""

    version: int
    epoch: int
    revision: int
    digest: str
    name: str = ""
    show: str = ""


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
    console when it changes, and once a second. Keys are a character and the tag of a message
    (`one/fade_face`, `one/set_head`), of a channel with its name (`one/set_channel:jawOpen`), of a layer with its name
    and its region (`one/set_layer:tracker:mouth`)."""

    hands: dict[str, str]


# --- leases, server to client -----------------------------------------------------------------------------------------


class SeatState(msgspec.Struct, frozen=True):
    """An operator, or a source that holds something: its number, its name and its colour, `#rrggbb`. `manager`: the
    stage manager; `here`: a link of it is there."""

    number: int
    name: str
    colour: str
    manager: bool = False
    here: bool = True


class LeaseWish(msgspec.Struct, frozen=True):
    """A part that somebody holds, as in `Leases.held`, the number of the seat that wants it, and for how many seconds.
    It stands until the part is released or taken over, its holder holds it again (`lease`), or the seat takes the wish
    back (`release_lease`) or has gone."""

    part: str
    by: int
    seconds: int


class Leases(Message, frozen=True):
    """Who holds what, complete, to consoles once leases have been switched on: when it changes and once a second.
    `held`: by character and part (`one/face`; the character of light and framing is `*`); `seats`: all operators, and
    what else holds or wants something; `you`: the number of this console's own. While leases are not `on` the last
    touch wins.
    """

    on: bool
    held: dict[str, SeatState]
    seats: list[SeatState]
    you: int
    wishes: list[LeaseWish] = []


class LeaseClaim(Message, frozen=True):
    """To the consoles of a seat: another touched parts that it holds, or has `taken` them over, or, holding what it
    wanted, has `kept` them. `parts`: as in `Leases.held`."""

    parts: list[str]
    by: SeatState
    taken: bool
    kept: bool = False


class SourceIs(Message, frozen=True):
    """Answers source: the index by which this link's frames name it."""

    index: int
    name: str


class SourceState(msgspec.Struct, frozen=True):
    """A source that sends: `console` is the name of the link that it comes by; its route; `rate`: frames in the last
    second; `found`: whether it sees its performer. `ranging`: it listens to the performer's largest moves. `neutral`,
    `highest`: what was measured, by channel."""

    name: str
    kind: StreamKind
    console: str
    characters: list[str]
    layer: LayerName
    regions: list[LayerPart]
    performer: str
    rate: int
    found: bool
    calibrated: bool
    ranging: bool
    mirror: bool
    dead_zone: float
    curve: float
    gain: float
    smoothing: float = 0.0
    lids: float = 1.0
    neutral: dict[str, float] = {}
    highest: dict[str, float] = {}


class Sources(Message, frozen=True):
    """All sources that send: complete, to consoles once a second and with each change."""

    sources: list[SourceState]


class PlaysSound(Message, frozen=True):
    """To a stage: whether it is the one that plays sounds, when that changes. One does at a time."""

    on: bool


class SpeechState(msgspec.Struct, frozen=True):
    """What a character says. `number`: counts all that it has said; `text`: its first 120 characters; `elapsed`:
    seconds since its sound began, below 0 before; `seconds`: its length. `sound`: the key of what a stage plays, ""
    for none; `waiting`: how many speeches follow, `next_sound`: the key of the next one's. `keys`: what
    programs call this one and those that follow, in their order."""

    number: int
    text: str
    elapsed: float
    seconds: float
    sound: str = ""
    waiting: int = 0
    next_sound: str = ""
    keys: list[str] = []


class SourceValues(Message, frozen=True):
    """What a source that is watched sends now, and what its measure makes of it: `sent` and `weights` as float32,
    little-endian, in the order of `names`; up to twenty times a second."""

    source: str
    names: list[str]
    sent: bytes
    weights: bytes


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


class Place(msgspec.Struct, frozen=True):
    """Where a character is, in the eyes of the audience: `x` metres to the picture's right, `depth` metres behind the
    front line, `size` a factor, `turn` radians about the vertical, + to the character's own left, as the head's yaw."""

    x: float = 0.0
    depth: float = 0.0
    size: float = 1.0
    turn: float = 0.0


class LayerSource(msgspec.Struct, frozen=True):
    """One of the sources of a layer: how far it is trusted, and the parts that it has."""

    source: str
    trust: float
    parts: list[str]


class LayerState(msgspec.Struct, frozen=True):
    """A layer: its influence on brows, eyes, mouth, rest, head and gaze, and its switch, as set. `source`: what drives
    it, of several the one with the most parts, "" for nothing; `trust`: 0 lost, 1 followed. `share`: how much of it is
    on air where it shows most, 0..1; `strongest`: the few channels that it moves most now. `sources`: all of them where
    there are several, the newest first."""

    influence: list[float]
    on: bool
    trust: float
    source: str
    share: float
    strongest: dict[str, float]
    sources: list[LayerSource] = []


class HeldState(msgspec.Struct, frozen=True):
    """What hands hold, where layers mix it with what sources send: channels, head and gaze as faders stand."""

    channels: dict[str, float]
    head: tuple[float, float, float]
    gaze: tuple[float, float]


class GazeTargetState(msgspec.Struct, frozen=True):
    """Whom or what a character looks at, as of `look_at`."""

    kind: TargetKind = "ahead"
    name: str = ""
    yaw: float = 0.0
    pitch: float = 0.0
    x: float = 0.0
    y: float = 0.0
    z: float = 2.0


class MotionState(msgspec.Struct, frozen=True):
    """What is set of a character's automatic motion, as of `set_motion` and `look_at`."""

    liveliness: float
    blinks: float
    gaze: float
    breath: float
    seed: int
    idle: bool = False
    target: GazeTargetState = GazeTargetState()


class CharacterState(msgspec.Struct, frozen=True):
    """All that a character has on air.

    `head`: yaw, pitch, roll; `gaze`: yaw, pitch; `eyes`: left yaw, pitch, right yaw, pitch (radians), as the eyeballs
    stand. `lids`: what the gaze adds to the channels. `face_fader`, `expression_fader`: where the T-bars stand, 0..1,
    with or without a call. `panics` counts them: when it rises, hands are off. `home_next`: the next one brings
    `home_face` in `home_seconds`. `place`: as it is now, on its way; `presence`: 0 off stage, 1 on it. `leaves`: it has
    been removed and will be gone. `regions`: the mixes of the regions that show another expression than the face does;
    `region_calls`: their own calls. `layers`: those that a source drives or that are set otherwise than at first, the
    lowest first; all else is what they make together. `held`: what hands hold, `None` where that is what is on air.
    `motion`: what is set of its automatic motion, `None` where nothing was. `speech`: what it says, `None` while it
    says nothing; `spoken`: the key of what it said to its end last.
    """

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
    panics: int
    home_face: str
    home_seconds: float
    home_next: bool
    label: str
    place: Place
    presence: float
    leaves: bool = False
    regions: dict[PlayRegion, dict[str, float]] = {}
    region_calls: dict[PlayRegion, CallState] = {}
    layers: dict[LayerName, LayerState] = {}
    held: HeldState | None = None
    motion: MotionState | None = None
    speech: SpeechState | None = None
    spoken: str = ""


class State(Message, frozen=True):
    """All that is on air: complete and absolute; the highest (epoch, number) wins, any may be lost.

    `time`: the show's clock, seconds. `characters`: at least one, in the order in which they were added. `light` sums
    to one, and so does `framing`: a framing is `*`, all that are on the stage, or names joined by `+`, sorted.
    `gaze_points`: the named points that eyes may look at, metres as of `look_at`.
    """

    epoch: int
    number: int
    time: float
    revision: int
    characters: dict[str, CharacterState]
    light: dict[str, float]
    light_call: CallState | None
    framing: dict[str, float]
    framing_call: CallState | None
    gaze_points: dict[str, tuple[float, float, float]] = {}


class Pong(Message, frozen=True):
    """Answers ping: `time` is the show's clock at that moment, as in `State.time`."""

    sent: float
    time: float


class Refused(Message, frozen=True):
    """A message was rejected, and why, in one sentence for the operator. `id`: of the message, where it had one, also
    where nothing else of it could be read. `held`: the parts that others hold, where that was the reason."""

    reason: str
    id: str = ""
    held: list[str] = []


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
    """The last report of a stage: frames per second, the level of quality, and its name, where its address has one; of
    sounds as in `drawing`."""

    fps: float
    level: Level
    name: StageName = ""
    sound: SoundState = ""
    sound_here: bool = False


class Crew(Message, frozen=True):
    """Who is connected, once a second, with each stage's last report (`None`: it is silent).

    `lost`: stages whose link broke while their page was open, and that have not come back.
    """

    stages: list[StageReport | None]
    consoles: int
    lost: int = 0


# --- devices ---


class DeviceState(msgspec.Struct, frozen=True):
    """A device, or another source of a show: where it is (a console's name, a host), whether it is there now.

    `rate`: readings or packets a second; `heard`, `rejected`: counts since the server began. `values`: where its
    controls stood last, 0..1, the newest sixty-four; `waiting`: controls that wait to be picked up, and the position
    at which they will be. `bank`: the one that it is turned to, of its `banks`; `preset`: the one it was given.
    `advice`: what to do at whoever sends it, such as what to type into a phone.
    """

    name: str
    kind: SourceKind
    where: str
    plugged: bool
    rate: float
    heard: int
    rejected: int
    values: dict[str, float]
    waiting: dict[str, float] = {}
    bank: str = ""
    banks: list[str] = []
    preset: str = ""
    advice: str = ""


class PresetDocument(msgspec.Struct, frozen=True):
    """A preset: its name, what people call the device, and whether it is made for it (`matches`: device names, as
    regular expressions in any case)."""

    name: str
    label: str
    kind: SourceKind
    matches: list[str]


class TrackerOffer(msgspec.Struct, frozen=True):
    """A tracker that can be heard. name: as `--listen` spells it; port: its usual one, or where it is heard, None where
    it comes to the port of the pages; asks: what its word may name behind "@": a phone that is asked for frames, a
    computer that we connect to, a sender that may play beside this machine, or "".

    word: what it is switched on by, "" while it is off; fixed: the command line has; advice: what to do at the sender.
    stranger: a host that has sent and may not, or ""; strange: the word by which it may. fault: why it is off though
    the start has asked for it, or ""; again: the word by which it is switched on then.
    """

    name: str
    title: str
    port: int | None
    asks: Literal["", "phone", "computer", "sender"]
    word: str
    fixed: bool
    advice: str
    stranger: str = ""
    strange: str = ""
    fault: str = ""
    again: str = ""


class FoundTracker(msgspec.Struct, frozen=True):
    """A program that has announced itself, and the word by which it is heard."""

    word: str
    title: str
    where: str


class ReceiverState(msgspec.Struct, frozen=True):
    """A program that faces are sent to. word: as after `--send`; character: whose face, "" where nobody is called so;
    sent: packets since it was switched on; fault: why it does not arrive, or ""; fixed: the command line has it."""

    word: str
    title: str
    where: str
    character: str
    sent: int
    fault: str
    fixed: bool


class SendWay(msgspec.Struct, frozen=True):
    """A way to send a face: its name as `--send` spells it, and the port where receivers usually hear it."""

    name: str
    title: str
    port: int


class Devices(Message, frozen=True):
    """All sources: complete, to consoles when one comes or goes and once a second, to pages that watch ten times a
    second. trackers: what can be heard; found: what has announced itself; receivers: to whom faces are sent, in one of
    these ways; phone_page: the address that a phone opens to copy what to type, "" where the show listens on its own
    machine alone; host: that machine's address in its network, to which trackers send, "" where it is in none."""

    devices: list[DeviceState]
    trackers: list[TrackerOffer] = []
    found: list[FoundTracker] = []
    receivers: list[ReceiverState] = []
    ways: list[SendWay] = []
    phone_page: str = ""
    host: str = ""


class LearningState(msgspec.Struct, frozen=True):
    """What the next control that moves will be bound to, and who asked for it (a console's name)."""

    id: str
    to: str
    axis: str
    arguments: list[float | str]
    who: str


class BindingList(Message, frozen=True):
    """All bindings in their order: complete, to consoles after the welcome and with each change. `fixed`: those of
    these that a file of the command line has made, which no page changes. `missing`: for each of the bindings why it
    waits, where it names a face, an expression or a character that is not there, else ""."""

    bindings: list[BindingDocument]
    fixed: list[BindingDocument]
    learning: LearningState | None
    presets: list[PresetDocument]
    missing: list[str] = []


class BindingsChanged(Message, frozen=True):
    """Answers bind, unbind, learn (when a control has been bound), load_preset and restore_bindings: what is new and
    what is gone; `restore_bindings` takes it back. `preset`: nobody asked, the preset of this label was loaded when its
    device was plugged in for the first time: all consoles are told, `here` says whether it was at this one."""

    id: str
    added: list[BindingDocument]
    removed: list[BindingDocument]
    preset: str = ""
    here: bool = True


class InputLine(msgspec.Struct, frozen=True):
    """What came from a source, or why it was rejected; `count`: how often the same within a second; `time`: seconds
    since 1970. Of a sender of a face there is one line while it sends: `rate` a second, `bars`: the channels that move
    most, and where each stands."""

    number: int
    time: float
    source: str
    text: str
    rejected: bool
    count: int = 1
    rate: float = 0.0
    bars: dict[str, float] = {}


class InputLog(Message, frozen=True):
    """What came in last, the oldest first, at most two hundred lines: complete, to pages that watch devices."""

    lines: list[InputLine]


class DeviceBytes(Message, frozen=True):
    """What a device is to be sent (MIDI): to the page that has it."""

    device: str
    data: bytes


KeepMessage = (
    KeepFace | KeepExpression | RenameItem | DeleteItem | RestoreItem | CopyItem | SetLayout | RenameLayout | DropLayout
)
"""What a console asks of the show file."""
LeaseMessage = Lease | ReleaseLease | SetLeases | AppointManager
"""What a console or a program asks of leases."""
SourceMessage = Source | Drive | LeaveSource | WatchSource
"""What comes of a source, and who asks to see it."""
BindingMessage = Bind | Unbind | Learn | LoadPreset | RestoreBindings
"""What a page asks of bindings; each executes once."""
DeviceMessage = Plug | Unplug | MidiBytes | Controls | BindingMessage | ChooseBank | WatchDevices | SwitchDevice
"""What pages say of devices; `inputs/` plays them."""
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
    | AddCharacter
    | RemoveCharacter
    | RestoreCharacter
    | RenameCharacter
    | PlaceCharacter
    | EnterCharacter
    | LeaveCharacter
    | CallFraming
    | RenameItem
    | DeleteItem
    | RestoreItem
    | CopyItem
    | SetLayout
    | RenameLayout
    | DropLayout
    | Plug
    | Unplug
    | MidiBytes
    | Controls
    | Bind
    | Unbind
    | Learn
    | LoadPreset
    | RestoreBindings
    | ChooseBank
    | WatchDevices
    | SwitchDevice
    | SetLayer
    | SetMotion
    | Say
    | StopSpeaking
    | MakeGesture
    | LookAt
    | SetGazePoint
    | DeleteGazePoint
    | Source
    | Drive
    | LeaveSource
    | RouteSource
    | CalibrateSource
    | MeasureSource
    | TuneSource
    | WatchSource
    | Cancel
    | Ping
    | Drawing
    | Lease
    | ReleaseLease
    | SetLeases
    | AppointManager
)
FromServer = (
    Welcome
    | PlaysSound
    | CastChanged
    | State
    | Pong
    | Kept
    | ItemChanged
    | Refused
    | Notices
    | Layouts
    | Hands
    | SourceIs
    | Sources
    | SourceValues
    | Progress
    | Crew
    | Leases
    | LeaseClaim
    | Devices
    | BindingList
    | BindingsChanged
    | InputLog
    | DeviceBytes
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
    An allowance counts triangles, then 32 rungs a crossing, then lids. Patches in which sums are damped: `heard` (n,)
    u32 triangles, patch after patch, `ends` (p,) u32 of each; `members` (m, j) u32 patches of a row, `shares` f32.
    """

    rounds: list[int]
    upright: float
    floor: float
    eager: float
    flattest: float
    full: float
    momentum: float
    margin: float
    farthest: float
    bulge: float
    cornea: float
    deep: float
    kept: float
    rows: bytes
    triangles: bytes
    crossings: list[CrossingDocument]
    lids: bytes
    eye: bytes
    heard: bytes
    ends: bytes
    members: bytes
    shares: bytes
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
    regions: RegionDocument | None = None


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
DOCUMENTS: tuple[type[msgspec.Struct], ...] = (
    *(Manifest, FaceAsset, ContentAsset, HairAsset, CompoundAsset),
    *ACCESS_DOCUMENTS,
)
