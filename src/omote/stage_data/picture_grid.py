"""Grids of pictures: cells, size, light and background, all validated before anything is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, get_args

from omote.interchange.formats.picture_names import Kind
from omote.show.messages import Level
from omote.stage_data.pose_parser import Pose, parse_pose, pose_of

if TYPE_CHECKING:
    from omote.model.cast import Cast

SMALLEST, LARGEST, MOST_PIXELS = 16, 8192, 8192 * 4320
"""Pixels: of a side, and of one picture; no graphics driver draws more everywhere."""
MOST_CELLS = 2000
PAPER = "#000"


@dataclass(frozen=True)
class Setting:
    """What all pictures of a grid share: size in pixels, background, quality."""

    width: int = 640
    height: int = 720
    background: str | None = None
    transparent: bool = False
    quality: str = "high"

    def __post_init__(self) -> None:
        """Rejects sizes that no canvas has, and unknown levels of quality."""
        sides = (self.width, self.height)
        if not (min(sides) >= SMALLEST and max(sides) <= LARGEST and self.width * self.height <= MOST_PIXELS):
            raise ValueError(
                f"a picture of {self.width}x{self.height} pixels cannot be drawn; give {SMALLEST} to {LARGEST} a side, "
                f"{MOST_PIXELS / 1e6:.0f} million in all"
            )
        if self.quality not in get_args(Level):
            raise ValueError(f"there is no quality {self.quality!r}; give one of {', '.join(get_args(Level))}")
        if self.transparent and self.background is not None:
            raise ValueError(f"a picture is transparent or has the background {self.background!r}; leave one out")


@dataclass(frozen=True)
class PictureGrid:
    """Pictures in rows and columns, with or without the names of rows and columns, and words in each picture.

    `part`: what is kept of each picture: left, top, width, height, as shares. `paper`: the colour behind the pictures,
    None for nothing.
    """

    poses: Sequence[Sequence[Pose]]
    rows: Sequence[str] = ()
    columns: Sequence[str] = ()
    captions: Sequence[Sequence[str]] = ()
    part: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0)
    paper: str | None = None
    kind: Kind = "image/png"

    def __post_init__(self) -> None:
        """Rejects an empty grid, one of too many pictures, and names that do not fit."""
        cells = sum(len(row) for row in self.poses)
        if not 0 < cells <= MOST_CELLS:
            raise ValueError(f"the sheet has {cells} pictures; give 1 to {MOST_CELLS}")
        if len(self.rows) not in (0, len(self.poses)) or any(len(self.columns) not in (0, len(r)) for r in self.poses):
            raise ValueError("every row and every column has a name, or none has")
        if self.captions and [len(row) for row in self.captions] != [len(row) for row in self.poses]:
            raise ValueError("every picture has a caption, or none has")

    def on_paper(self, setting: Setting, kind: Kind) -> PictureGrid:
        """Sets the background of a grid for a file of this kind: dark, or none where the pictures are transparent.

        ValueError for a transparent JPEG, which there is not.
        """
        if setting.transparent and kind == "image/jpeg":
            raise ValueError("a JPEG cannot be transparent; write a .png, or leave --transparent out")
        return replace(self, paper=None if setting.transparent else PAPER, kind=kind)


def build_grid(cast: Cast, *, faces: str, expressions: str, turns: str, light: str, labels: bool) -> PictureGrid:
    """Builds a grid of faces (rows) by expressions at every turn, all by commas; ValueError for unknown names."""
    columns = [(expression, turn) for expression in split_list(expressions) for turn in split_list(turns)]
    poses = [
        [
            pose_of(cast, parse_pose(cast, face=face, expression=expression, turn=turn, light=light))
            for expression, turn in columns
        ]
        for face in split_list(faces)
    ]
    turned = len(split_list(turns)) > 1
    titles = [f"{expression} {turn}°" if turned else expression for expression, turn in columns]
    return PictureGrid(poses, split_list(faces), titles) if labels else PictureGrid(poses)


def split_list(text: str) -> list[str]:
    """Splits a text at its commas."""
    return [word.strip() for word in text.split(",") if word.strip()]


def read_size(text: str) -> tuple[int, int]:
    """Parses the width and height of `640x720`; ValueError for anything else."""
    sides = text.lower().split("x")
    if len(sides) != 2 or not all(side.strip().isdecimal() and len(side) < 9 for side in sides):
        raise ValueError(f"the size {text!r} is not understood; give width x height in pixels, as in 640x720")
    return int(sides[0]), int(sides[1])
