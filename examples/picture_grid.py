"""Draws a grid of faces by expressions, without a window: a figure for a paper.

For researchers; the same cast, size and machine give the same bytes. Needs a Chromium or Chrome.
Run: python examples/picture_grid.py [FOLDER]       writes FOLDER/grid.png

The same from a shell: omote grid --faces kaori,old,dog --expressions neutral,smile,angry -o grid.png
"""

import sys
from pathlib import Path

import omote
from omote.server.headless.picture_renderer import draw_grid
from omote.stage_data.picture_grid import lay_out
from omote.stage_data.picture_request import GridRequest

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

request = GridRequest(
    faces="kaori,old,kaori=0.5+dog=0.5",  # rows: faces, or mixes of them
    expressions="neutral,smile",  # columns
    turns="0,30",  # each at these yaws, degrees
    light="portrait",
    size="160x180",  # of one picture, pixels
    quality="low",  # "high" for print
)
sheet = lay_out(request, omote.load_cast()).on_paper(request.setting, "image/png")

picture = draw_grid(sheet, request.setting)
(out / "grid.png").write_bytes(picture)
print(f"{out / 'grid.png'}: {len(sheet.rows)} rows, {len(sheet.columns)} columns, {len(picture) / 1000:.0f} kB")
