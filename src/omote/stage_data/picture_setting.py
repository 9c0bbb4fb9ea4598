"""What all pictures of a table share: size, background, quality, hair, mask and luminance; all of it is checked without
a cast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import get_args

from omote.interchange.formats.file_names import Kind
from omote.perform.lights import find_background
from omote.perform.scene.framings import FIGURE_SHOTS
from omote.show.objects.stages import Level

SMALLEST = 16
LARGEST = 8192
MOST_PIXELS = 8192 * 4320
"""Pixels: of a side, and of one picture; no graphics driver draws more everywhere."""
MOST_CELLS = 2000
PAPER = "#000"
MASKS = ("oval", "face")
LUMINANCES = (0.01, 0.9)
CONTRASTS = (0.01, 2.0)
"""The means of relative luminance that a picture may be given, and its deviation over the mean."""


@dataclass(frozen=True)
class Clipped:
    """The shares of what counts of a picture, 0 to 1, that were to be darker than black and lighter than white to match
    its luminance and contrast, and are black and white."""

    black: float
    white: float


@dataclass(frozen=True)
class Setting:
    """What all pictures of a grid share: size in pixels, background, quality, whether heads wear hair.

    mask: "oval" or "face", what is left of a picture, "" for all; luminance: the mean of relative luminance in linear
    light; contrast: its standard deviation over the mean; None: as drawn. framing: how much of a figure the picture
    shows, "" for a head alone.
    """

    width: int = 640
    height: int = 720
    background: str | None = None
    transparent: bool = False
    quality: str = "high"
    hair: bool = True
    mask: str = ""
    luminance: float | None = None
    contrast: float | None = None
    framing: str = ""

    def __post_init__(self) -> None:
        """Rejects sizes that no canvas has, unknown levels of quality, and what is no colour."""
        sides = (self.width, self.height)
        if not all(isinstance(side, int) and not isinstance(side, bool) for side in sides):
            raise TypeError(f"width and height are {self.width!r} and {self.height!r}; give whole numbers of pixels")
        if not (min(sides) >= SMALLEST and max(sides) <= LARGEST and self.width * self.height <= MOST_PIXELS):
            raise ValueError(
                f"a picture of {self.width}x{self.height} pixels cannot be drawn; give {SMALLEST} to {LARGEST} a side, "
                f"{MOST_PIXELS / 1e6:.0f} million in all"
            )
        if self.quality not in get_args(Level):
            raise ValueError(f"there is no quality {self.quality!r}; give one of {', '.join(get_args(Level))}")
        if self.transparent and self.background is not None:
            raise ValueError(f"a picture is transparent or has the background {self.background!r}; leave one out")
        if not isinstance(self.background, str | None):
            raise TypeError(f"the background is {self.background!r}; give a colour as text, as in '#00b140'")
        if self.background is not None:
            object.__setattr__(self, "background", find_background(self.background))
        self._refuse_finish()

    def _refuse_finish(self) -> None:
        if not isinstance(self.hair, bool):
            raise TypeError(f"hair is {self.hair!r}; give True or False")
        if self.framing not in ("", *FIGURE_SHOTS):
            raise ValueError(
                f"there is no framing {self.framing!r}; give one of {', '.join(FIGURE_SHOTS)}, or none: a head alone"
            )
        if self.mask not in ("", *MASKS):
            raise ValueError(f"there is no mask {self.mask!r}; give one of {', '.join(MASKS)}")
        if self.mask and not self.transparent and self.background is None:
            raise ValueError(
                f"a picture with the mask {self.mask!r} needs something around it: a background, as #808080, or "
                "transparent"
            )
        for name, wish, (least, most) in (
            ("luminance", self.luminance, LUMINANCES),
            ("contrast", self.contrast, CONTRASTS),
        ):
            if wish is not None and (isinstance(wish, bool) or not isinstance(wish, int | float)):
                raise TypeError(f"the {name} is {wish!r}; give a number, such as 0.3")
            if wish is not None and not least <= wish <= most:
                raise ValueError(f"a {name} of {wish:g} cannot be given to a picture; give {least:g} to {most:g}")

    @property
    def finished(self) -> bool:
        """Whether something is done to the picture after it is drawn."""
        return bool(self.mask) or self.luminance is not None or self.contrast is not None

    @property
    def clear(self) -> bool:
        """Whether the stage draws nothing behind the head: what is finished gets its background afterwards."""
        return self.transparent or (self.finished and self.background is not None)

    def paper(self, kind: Kind) -> str | None:
        """The colour behind the pictures of a file of this kind: dark, or None where the pictures are transparent.

        ValueError for a transparent JPEG, which there is not.
        """
        if self.transparent and kind == "image/jpeg":
            raise ValueError("a JPEG cannot be transparent; write a .png, or leave --transparent out")
        if self.finished and kind == "image/jpeg":
            raise ValueError("a JPEG would change what is masked or matched; write a .png")
        return None if self.transparent else PAPER


def refuse_count(cells: int) -> None:
    """Raises ValueError for a table of no pictures, and for one of too many."""
    if not 0 < cells <= MOST_CELLS:
        raise ValueError(f"the table has {cells} pictures; give 1 to {MOST_CELLS}")


def split_list(text: str) -> list[str]:
    """Splits a text at its commas."""
    return [word.strip() for word in text.split(",") if word.strip()]


def read_size(text: str) -> tuple[int, int]:
    """Parses the width and height of `640x720`; ValueError for anything else."""
    sides = text.lower().split("x")
    if len(sides) != 2 or not all(side.strip().isdecimal() and len(side) < 9 for side in sides):
        raise ValueError(f"the size {text!r} is not understood; give width x height in pixels, as in 640x720")
    return int(sides[0]), int(sides[1])
