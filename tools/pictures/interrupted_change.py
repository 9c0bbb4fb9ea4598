"""Draws docs/pictures/interrupted-change.webp: a change of face and expression, interrupted half-way by another.

Frames of the engine, drawn by the stage's own page as `omote render` does; below them the mixes on air, above them
what is called.
"""

from __future__ import annotations

import asyncio
import io
import sys
from collections.abc import Iterator, Mapping

from PIL import Image, ImageDraw, ImageFont

import omote
from omote.perform.frame import Frame
from omote.server.headless.chromium import open_chromium
from omote.server.headless.picture_renderer import open_picture_page, serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Setting
from omote.stage_data.pose_parser import Pose, pose_of
from tools.browser import SENTENCE, find_browser
from tools.pictures.drawing import PICTURES

RATE = 10
"""Frames a second."""
LENGTH = 6.6
"""Seconds; it ends as it begins."""
CALLS = {
    0.4: ("face", "dog", 2.4),
    0.9: ("expression", "smile", 1.4),
    1.6: ("both", "old angry", 2.0),
    4.1: ("both", "kaori neutral", 2.0),
}
"""What is called at which second: face, expression or both, their names, and the seconds of the call."""
HALF_WAY = 1.6
"""The second at which both changes are half done, and interrupted."""
SHOWN = 0.9
"""Seconds for which a call is told in the picture's corner."""
SETTING = Setting(320, 360, quality="good")
STRIP = 52
"""Pixels below the picture, for the mixes."""
BAND = 30
"""Pixels over its upper edge, for what is called."""
STRIP_COLOUR = "#14161a"
COLOURS = {
    **{"kaori": "#c9a27c", "dog": "#8a6a4f", "old": "#7d8a94"},
    **{"neutral": "#4a4f57", "smile": "#4f9d69", "angry": "#b5483f"},
}


def played() -> Iterator[tuple[float, Frame]]:
    """The frames of the show and their seconds."""
    performer = omote.Performer(omote.load_cast())
    performer.call_face("kaori", seconds=1)
    performer.advance(2.0)
    waiting = dict(sorted(CALLS.items()))
    for number in range(round(LENGTH * RATE)):
        now = number / RATE
        for at in [at for at in waiting if at <= now]:
            axis, names, seconds = waiting.pop(at)
            if axis != "expression":
                performer.call_face(names.split()[0], seconds=seconds)
            if axis != "face":
                performer.call_expression(names.split()[-1], seconds=seconds)
        yield now, performer.advance(1 / RATE if number else 0.0)


async def drawn(poses: list[Pose]) -> list[Image.Image]:
    """The pictures of poses, by one browser."""
    browser = find_browser()
    if browser is None:
        sys.exit(SENTENCE)
    pictures = []
    async with serve_pages(built_in_documents(), read_pages()) as address, open_chromium(browser) as tools:
        page = await open_picture_page(tools, address, SETTING)
        for pose in poses:
            data = (await page.draw(PictureGrid([[pose]]).on_paper(SETTING, "image/png"))).data
            pictures.append(Image.open(io.BytesIO(data)).convert("RGB"))
            print(f"{len(pictures)} of {len(poses)}", file=sys.stderr, flush=True)
    return pictures


def captioned(picture: Image.Image, now: float, frame: Frame) -> Image.Image:
    """A picture (`now` seconds, of `frame`) with both mixes below it, and above what has just been called."""
    whole = Image.new("RGB", (picture.width, picture.height + STRIP), STRIP_COLOUR)
    whole.paste(picture)
    draw = ImageDraw.Draw(whole)
    for row, mix in enumerate((frame.faces, frame.expressions)):
        _draw_mix(draw, picture.height + 4 + row * 24, picture.width, mix)
    draw.rectangle((0, 0, whole.width, BAND), STRIP_COLOUR)
    called = [at for at in CALLS if at <= now < at + SHOWN]
    if called:
        _, names, _ = CALLS[called[-1]]
        sentence = f"call {names.replace(' ', ', ')}" + (" (half-way)" if called[-1] == HALF_WAY else "")
        draw.text((8, 6), sentence, "#ffffff", ImageFont.load_default(16))
    return whole


def _draw_mix(draw: ImageDraw.ImageDraw, top: int, width: int, mix: Mapping[str, float]) -> None:
    left = 4.0
    shares = {name: max(mix.get(name, 0.0), 0.0) for name in COLOURS}
    for name, share in shares.items():
        right = left + (width - 8) * share / sum(shares.values())
        if right - left >= 1:
            draw.rectangle((left, top, right, top + 20), COLOURS[name])
        if right - left >= 60:
            draw.text((left + 6, top + 3), name, "#ffffff", ImageFont.load_default(13))
        left = right


def main() -> None:
    """Draws the picture and writes it."""
    cast = omote.load_cast()
    frames = list(played())
    pictures = asyncio.run(drawn([pose_of(cast, frame) for _, frame in frames]))
    first, *rest = [captioned(picture, *frame) for picture, frame in zip(pictures, frames, strict=True)]
    target = PICTURES / "interrupted-change.webp"
    first.save(target, append_images=rest, duration=round(1000 / RATE), loop=0, quality=75, method=4)
    print(f"docs/pictures/{target.name}: {target.stat().st_size // 1000} kB", file=sys.stderr)


if __name__ == "__main__":
    main()
