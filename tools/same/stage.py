"""Records what a stage's GPU blends: the positions of seeded random poses, read back from a page in Chromium."""

from __future__ import annotations

import asyncio
from typing import Any

import msgspec
import numpy as np

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.perform.frame import Frame
from omote.server.headless.chromium import open_chromium
from omote.server.headless.devtools import DevTools
from omote.server.headless.picture_renderer import OPENED, OPENING, query, serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from omote.stage_data.picture_setting import Setting
from omote.stage_data.pose_parser import pose_of as whole_pose_of
from tools.browser import SENTENCE, find_browser
from tools.same.compounds import SEED, pool, random_frame
from tools.same.recording import Numbers, Recording

POSES = 40
STEP = 1e-6
"""Metres to which positions are rounded."""
POSE = ("faces", "expressions", "channels", "added", "head", "eyes")
SETTING = Setting(320, 240, quality="low")


def record_stage(recording: Recording) -> None:
    """The positions of every pose, rounded to a micrometre; all of them are kept."""
    cast = load_cast()
    rng = np.random.default_rng(SEED)
    faces, expressions = pool(cast, rng)
    frames = [random_frame(faces, expressions, rng) for _ in range(POSES)]
    for place, found in enumerate(asyncio.run(_drawn([pose_of(cast, frame) for frame in frames]))):
        counts = np.rint(found / STEP).astype(np.int32)
        recording.data("positions", f"pose {place:02d}", counts.tobytes())
        recording.samples[f"positions|pose {place:02d}"] = (counts * STEP).astype(np.float32)


def pose_of(cast: Cast, frame: Frame) -> dict[str, Any]:
    """What the server would tell a stage of this frame."""
    whole = whole_pose_of(cast, frame)
    return {name: whole[name] for name in POSE}


async def _drawn(poses: list[dict[str, Any]]) -> list[Numbers]:
    browser = find_browser()
    if browser is None:
        raise FileNotFoundError(SENTENCE)
    async with serve_pages(built_in_documents(), read_pages()) as address, open_chromium(browser) as tools:
        page = await _opened(tools, f"{address}/stage{query(SETTING)}")
        found = []
        for pose in poses:
            await tools.evaluate(page, f"window.omoteStage.hold({msgspec.json.encode(pose).decode()})")
            found.append(np.array(await tools.evaluate(page, "window.omoteStage.readPositions()"), np.float64))
        return found


async def _opened(tools: DevTools, address: str) -> str:
    """The DevTools session of a page that shows a stage."""
    target = await tools.call("Target.createTarget", url="about:blank")
    attached = await tools.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)
    session = str(attached["sessionId"])
    size = {"width": SETTING.width, "height": SETTING.height, "deviceScaleFactor": 1, "mobile": False}
    await tools.call("Emulation.setDeviceMetricsOverride", session=session, **size)
    await tools.call("Page.navigate", session=session, url=address)
    await asyncio.wait_for(tools.evaluate(session, OPENED), OPENING)
    return session
