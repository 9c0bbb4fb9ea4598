"""Pictures of a stage: one page, opened with the first picture."""

import base64
from pathlib import Path

import pytest

from omote.server.agents.stage_picture import StagePicture
from omote.server.headless.devtools import BrowserError
from tests.server.false_browser import ANSWERS, false_browser

SHOT = base64.b64encode(b"picture").decode()
SCREEN = f"""
opened = []
def answer(method, parameters):
    if method == "Page.navigate":
        opened.append(parameters["url"])
        return {{}}
    if method == "Page.captureScreenshot":
        good = opened == ["http://127.0.0.1:1/stage?quality=medium&token=secret"]
        return {{"data": "{SHOT}"}} if good else str(opened)
    return {{"targetId": "t", "sessionId": "s", "result": {{"value": True}}}}
"""


@pytest.mark.asyncio
async def test_the_page_opens_once_with_the_token(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path, SCREEN)))
    stage = StagePicture("http://127.0.0.1:1", "secret", (320, 180))
    assert [await stage.take() for _ in range(2)] == [b"picture"] * 2
    await stage.close()


@pytest.mark.asyncio
async def test_a_stage_that_does_not_open_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    refusing = ANSWERS.replace(
        'if method == "Runtime.evaluate":',
        'if method == "Runtime.evaluate":\n        return {"result": {}, "exceptionDetails": {"exception": '
        '{"value": "no show"}}}\n    if False:',
    )
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path, refusing)))
    stage = StagePicture("http://127.0.0.1:1", "", (320, 180))
    with pytest.raises(BrowserError, match="no show"):
        await stage.take()
    await stage.close()
