"""What is asked of `omote render` and `omote grid`: every parameter of a picture or a table of them, as it is typed."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from itertools import pairwise

import msgspec

from omote.interchange.formats.file_names import Kind
from omote.perform.name_lookup import find_kind
from omote.stage_data.cast_names import CastNames
from omote.stage_data.picture_setting import Setting, read_size, refuse_count, split_list
from omote.stage_data.pose_words import PoseWords, read_pose, read_weights

MOST_STEPS = 1000
CLIPS_OWN = ("expression", "channel", "turn", "gaze")
"""What a motion clip says of a picture; face and light are asked for beside it."""
RESERVED = frozenset(
    {"CON", "PRN", "AUX", "NUL", *(f"{port}{number}" for port in ("COM", "LPT") for number in range(10))}
)
"""Names of devices, which Windows takes for no file, whatever its ending."""
LONGEST_FILE_NAME = 80
APART = re.compile(r"(\d{1,4}(?:\.\d{1,6})?)\s*(mm|dE)")
"""How far steps of a morph are apart: millimetres of mesh, or CIELAB differences of the pictures."""
LAB = "lab"
"""After a number of steps: they are to be even in CIELAB."""
TITLES = {"eyeBlinkLeft+eyeBlinkRight": "eyes shut"}
"""What mixes are called above a column that nobody would call by their names."""


class PictureOptions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What one picture and a table of them share; show: a show file whose own work can be named, "" for none."""

    size: str
    light: str = "theatre"
    background: str | None = None
    transparent: bool = False
    quality: str = "high"
    hair: bool = True
    mask: str = ""
    luminance: float | None = None
    contrast: float | None = None
    show: str = ""
    framing: str = ""

    @property
    def setting(self) -> Setting:
        """All of it but the light and the show file; ValueError where it cannot be drawn."""
        width, height = read_size(self.size)
        chosen = ("background", "transparent", "quality", "hair", "mask", "luminance", "contrast", "framing")
        return Setting(width, height, **{name: getattr(self, name) for name in chosen})


class RenderRequest(PictureOptions, frozen=True, kw_only=True, tag_field="command", tag="render"):
    """One picture: faces, expressions and channels with their weights; angles in degrees; pose: of its figure, a mix.

    clip: a motion clip of the show file in place of all but the faces, "" for none; at: its second, whatever its speed.
    """

    size: str = "640x720"
    face: tuple[str, ...] = ("generic",)
    expression: tuple[str, ...] = ()
    channel: tuple[str, ...] = ()
    turn: str = ""
    gaze: str = ""
    clip: str = ""
    at: float = 0.0
    pose: str = ""

    @property
    def words(self) -> PoseWords:
        """The pose; ValueError for what is not understood or out of range, and for what a clip has of its own."""
        if self.at and not self.clip:
            raise ValueError(f"the second {self.at:g} is of no clip; name the clip too")
        if self.pose and not self.framing:
            raise ValueError(f"the pose {self.pose} is of a figure; say how much of it is seen: --framing full")
        if self.clip and (own := [name for name in CLIPS_OWN if getattr(self, name)]):
            raise ValueError(f"the clip {self.clip} has {' and '.join(own)} of its own; leave that out")
        face, expression, channel = ("+".join(parts) for parts in (self.face, self.expression, self.channel))
        angles = {"turn": self.turn, "gaze": self.gaze}
        return read_pose(face=face, expression=expression, channel=channel, light=self.light, pose=self.pose, **angles)


class GridRequest(PictureOptions, frozen=True, kw_only=True, tag_field="command", tag="grid"):
    """Pictures in rows and columns: faces by expressions at every turn, or each of them by the steps of a morph."""

    size: str = "240x270"
    faces: str = ""
    morph: str = ""
    expressions: str = "neutral"
    turns: str = "0"
    labels: bool = True


Request = RenderRequest | GridRequest


def check_request(request: Request, kind: Kind) -> None:
    """Raises ValueError for a request that no cast and no file of this kind could fulfil: all but the names in it."""
    request.setting.paper(kind)
    cells = [request] if isinstance(request, RenderRequest) else plan_cells(request).all
    for cell in cells:
        _ = cell.words


ANY_WEIGHT = (-math.inf, math.inf)


def check_names(request: Request, names: CastNames) -> None:
    """Raises ValueError where a request names a face, an expression or a channel that is none. names: of the cast."""
    spelled = request if isinstance(request, RenderRequest) else spell_kinds(request, names.kinds)
    for cell in [spelled] if isinstance(spelled, RenderRequest) else plan_cells(spelled).all:
        for what, parts in {"face": cell.face, "expression": cell.expression, "channel": cell.channel}.items():
            names.check_names([name for name, _ in read_weights("+".join(parts), what, ANY_WEIGHT)], what)
        names.check_words(cell.words)


def spell_kinds(grid: GridRequest, kinds: Mapping[str, str]) -> GridRequest:
    """The table with every kind among its expressions (`performed`, `own`) replaced by its expressions; ValueError
    where there are no own ones.

    grid: as it is asked for; kinds: of every expression, by name.
    """
    spelled = [name for word in split_list(grid.expressions) for name in find_kind(word, kinds) or [word]]
    return msgspec.structs.replace(grid, expressions=",".join(spelled))


class CellPlan(msgspec.Struct, frozen=True):
    """The pictures of a table, row by row, each with its file's name without suffix; titles of rows and columns."""

    rows: list[str]
    columns: list[str]
    cells: list[list[tuple[str, RenderRequest]]]

    @property
    def all(self) -> list[RenderRequest]:
        """The pictures one after the other."""
        return [cell for row in self.cells for _, cell in row]


def plan_cells(grid: GridRequest) -> CellPlan:
    """Lays out the pictures of a table; ValueError where it names neither faces nor a morph, or both."""
    if bool(grid.faces.strip()) == bool(grid.morph.strip()):
        raise ValueError("give the faces (--faces kaori,dog) or a morph (--morph kaori:dog:11), one of the two")
    turned = len(split_list(grid.turns)) > 1
    worn = [(expression, turn) for expression in split_list(grid.expressions) for turn in split_list(grid.turns)]
    count = len(morph_steps(grid.morph)) if grid.morph.strip() else len(split_list(grid.faces))
    refuse_count(count * len(worn))
    called = [TITLES.get(expression, expression) for expression, _ in worn]
    titles = [f"{title} {turn}°" if turned else title for title, (_, turn) in zip(called, worn, strict=True)]
    files = [file_name(f"{expression}-{turn}" if turned else expression) for expression, turn in worn]
    if grid.morph.strip():
        steps = morph_steps(grid.morph)
        cells = [
            [(f"{file}-{name}", cell_of(grid, face, *pose)) for _, name, face in steps]
            for pose, file in zip(worn, files, strict=True)
        ]
        return CellPlan(titles, [title for title, _, _ in steps], _unique(cells))
    faces = split_list(grid.faces)
    cells = [
        [(f"{file_name(face)}-{file}", cell_of(grid, face, *pose)) for pose, file in zip(worn, files, strict=True)]
        for face in faces
    ]
    return CellPlan(faces, titles, _unique(cells))


def cell_of(grid: GridRequest, face: str, expression: str, turn: str) -> RenderRequest:
    """One picture of a table.

    grid: what all pictures share; face, expression: mixes as they are typed; turn: degrees, as they are typed.
    """
    shared = {name: getattr(grid, name) for name in PictureOptions.__struct_fields__}
    return RenderRequest(face=(face,), expression=(expression,), turn=turn, **shared)


class Morph(msgspec.Struct, frozen=True):
    """A morph as it is typed: the mixes at its ends, and its steps.

    first, last: mixes; count: of the steps; apart: how far these are to be apart instead, None where they are counted;
    colour: whether they are to be even in CIELAB of the pictures, not in millimetres of mesh; percents: of the last
    face at each step, where they were listed.
    """

    first: str
    last: str
    count: int
    apart: float | None = None
    colour: bool = False
    percents: tuple[float, ...] = ()

    @property
    def measured(self) -> bool:
        """Whether only who knows the faces, or draws them, can say what its steps are."""
        return self.apart is not None or self.colour

    @property
    def shares(self) -> list[float]:
        """Of the last face at each step, 0 to 1; what is to be measured first is even in mesh until then."""
        if self.percents:
            return [round(percent / 100.0, 6) for percent in self.percents]
        return [round(step / (self.count - 1), 6) for step in range(self.count)]


def read_morph(text: str) -> Morph:
    """Parses a morph: `kaori:man:11`, `kaori:man:11lab`, `kaori:man:0.5mm`, `kaori:man:2dE` or `kaori:man:0/30/100`;
    ValueError for anything else.

    Steps that are a distance apart count as the two ends: only who knows the faces can count them.
    """
    parts = [part.strip() for part in text.split(":")]
    if len(parts) == 3 and all(parts):
        first, last, steps = parts
        counted = steps.removesuffix(LAB).strip()
        if counted.isdecimal() and 2 <= int(counted[:6]) <= MOST_STEPS:
            return Morph(first, last, int(counted), colour=steps != counted)
        if (apart := APART.fullmatch(steps)) and float(apart[1]) > 0.0:
            return Morph(first, last, 2, float(apart[1]), colour=apart[2] == "dE")
        if "/" in steps and (percents := _read_percents(steps)):
            return Morph(first, last, len(percents), percents=percents)
    raise ValueError(
        f"the morph {text!r} is not understood; give two faces and a number of steps from 2 to {MOST_STEPS}, "
        "as in kaori:man:11 (even in millimetres of mesh) or kaori:man:11lab (even in CIELAB), how far apart they "
        "are, as in kaori:man:0.5mm or kaori:man:2dE, or percents that rise from 0 to 100, as in kaori:man:0/30/100"
    )


def _read_percents(steps: str) -> tuple[float, ...]:
    """Percents that rise from 0 to 100, "0/12.5/100"; none where they are no such."""
    words = [word.strip() for word in steps.split("/")]
    if len(words) > MOST_STEPS or not all(re.fullmatch(r"\d{1,3}(\.\d{1,6})?", word) for word in words):
        return ()
    percents = tuple(float(word) for word in words)
    rise = all(before < after for before, after in pairwise(percents))
    return percents if rise and (percents[0], percents[-1]) == (0.0, 100.0) else ()


def morph_steps(text: str) -> list[tuple[str, str, str]]:
    """For each step of a morph (`read_morph`) its title, the name of its file and the mix of the two faces."""
    morph = read_morph(text)
    first = morph.first
    last = morph.last
    steps = []
    for step, share in enumerate(morph.shares):
        mix = first if share == 0.0 else last if share == 1.0 else f"{first}={1 - share:.6f}+{last}={share:.6f}"
        steps.append((f"{100 * share:.4g} %", f"{file_name(first)}-{file_name(last)}-{step:03d}", mix))
    return steps


def file_name(text: str) -> str:
    """A text as a part of a file name that every system takes."""
    name = re.sub(r"[^\w.+=-]+", "_", text)[:LONGEST_FILE_NAME]
    return f"_{name}"[:LONGEST_FILE_NAME] if name.partition(".")[0].upper() in RESERVED else name


def _unique(cells: list[list[tuple[str, RenderRequest]]]) -> list[list[tuple[str, RenderRequest]]]:
    """Numbers file names that come again, also where only their case differs."""
    seen: dict[str, int] = {}
    rows = []
    for row in cells:
        named = []
        for name, cell in row:
            count = seen[name.casefold()] = seen.get(name.casefold(), 0) + 1
            named.append((name if count == 1 else f"{name}-{count}", cell))
        rows.append(named)
    return rows
