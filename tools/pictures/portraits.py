"""Draws the portraits that come with the pages: `python -m tools.pictures.portraits`.

Console and editor show them at their first look, where a machine without a graphics processor needs minutes to draw as
many: every face at rest, and every expression on the generic face. They lie in one picture, cut and sized as
`web/src/ui/thumbnails.ts` has them drawn; `portraits.json` beside it says whose they are, row by row. They are drawn
anew when faces or expressions change.
"""

from __future__ import annotations

import sys
from pathlib import Path

import omote
from omote.interchange.formats.atomic_file import write_whole
from omote.model.body.limb_recipe import LIMB_KIND
from omote.model.cast import Cast
from omote.model.known_names import GENERIC, NEUTRAL
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Setting
from omote.stage_data.pose_parser import parse_pose, pose_of
from tools.pictures.drawing import Picture, draw_wanted

FOLDER = Path(__file__).resolve().parents[2] / "web" / "src" / "ui"
NAMES = FOLDER / "portraits.json"
COLUMNS = 13
WIDTH = 130
HEIGHT = 120
"""Of a portrait, pixels: `THUMBNAIL_SIZE`."""
SHARE = 0.185 / 0.305
"""Of a stage's picture that a thumbnail shows: one over the zoom of `THUMBNAIL` (web/src/face/framing.ts)."""
LOWER = 0.003 / 0.305
"""By how much lower its middle lies, as a share of that picture's height."""


def name_portraits(cast: Cast) -> list[tuple[str, str]]:
    """Face and expression of each portrait, row by row: of expressions that heads wear."""
    faces = [(face, NEUTRAL) for face in cast.faces]
    worn = [name for name in cast.expressions if name != NEUTRAL and cast.titles[name].kind != LIMB_KIND]
    return faces + [(GENERIC, name) for name in worn]


def portraits(cast: Cast) -> Picture:
    """The sheet of all portraits."""
    poses = [pose_of(cast, parse_pose(cast, face=face, expression=name)) for face, name in name_portraits(cast)]
    rows = [poses[first : first + COLUMNS] for first in range(0, len(poses), COLUMNS)]
    edge = (1 - SHARE) / 2
    part = (edge, edge + LOWER, SHARE, SHARE)
    sheet = PictureGrid(rows, part=part, paper="#000", kind="image/jpeg")
    return Picture("portraits", sheet, Setting(round(WIDTH / SHARE), round(HEIGHT / SHARE), quality="low"), FOLDER)


def main() -> int:
    """Draws the sheet, and writes whose portraits it holds."""
    cast = omote.load_cast()
    names = ",\n".join(f'  ["{face}", "{expression}"]' for face, expression in name_portraits(cast))
    write_whole(NAMES, f"[\n{names}\n]\n".encode())
    return draw_wanted([portraits(cast)], [])


if __name__ == "__main__":
    sys.exit(main())
