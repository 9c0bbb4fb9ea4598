"""Notes and two runs compared, in a real browser: curves are drawn, a press seeks the replay, a note is stamped."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.server.recording.recording_thread import RecordingThread
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.cues import Go, PutCue, PutMove
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetMotion
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.recording_file import recording_path
from omote.showfile.show_file import open_show
from tests.browser.conftest import playing, replaying
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]
RUNS = "document.querySelector('omote-runs-page')"
CHART = f"{RUNS}.renderRoot.querySelector('omote-run-chart')"
NIGHTS = ((60, 180), (90, 270))
"""The ticks at which the two cues of each night are called: the second comes 1 s later in the second night."""


def play_night(path: Path, cast: Cast, go_at: tuple[int, int]) -> None:
    """Records six seconds, in which two cues are called."""
    writer = RecordingThread(recording_path(path), pytest.fail, "test")
    session = ShowSession(cast)
    recorder = Recorder(session)
    writer.note_cast(cast, {})
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    session.receive("ana", SetMotion("one", liveliness=0.0), 0.0)
    for number, weight in (("1", 0.5), ("2", 1.0)):
        session.receive("ana", PutCue(f"put-{number}", number=number), 0.0)
        cue = list(session.cues.book.cues)[-1]
        mix = {"joy": weight, "neutral": 1.0 - weight}
        session.receive("ana", PutMove(f"move-{number}", cue, "one/expression", mix, 0.5), 0.0)
    for tick in range(360):
        now = 1000.0 + tick / 60
        if tick in go_at:
            session.receive("ana", Go(f"go-{tick}"), now)
        data = encode(session.tick(now))
        writer.note(recorder.take(zlib.crc32(data)), data)
    writer.close()


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a replay of two nights."""
    path = tmp_path_factory.mktemp("nights") / "evening.omote"
    open_show(path).close()
    for go_at in NIGHTS:
        play_night(path, load_cast(), go_at)
    yield from replaying(path)


def drawn(page: Page, colour: tuple[int, int, int]) -> int:
    """How many columns of the first chart have a pixel of a colour below its upper fifth, where labels stand."""
    count = page.evaluate(
        f"""([red, green, blue]) => {{
          const canvas = {CHART}.renderRoot.querySelector('canvas');
          const {{ width, height }} = canvas;
          const top = Math.round(height / 5);
          const {{ data }} = canvas.getContext('2d').getImageData(0, top, width, height - top);
          const columns = new Set();
          for (let at = 0; at < data.length; at += 4) {{
            const far = Math.abs(data[at] - red) + Math.abs(data[at + 1] - green) + Math.abs(data[at + 2] - blue);
            if (data[at + 3] > 200 && far < 40) columns.add((at / 4) % width);
          }}
          return columns.size;
        }}""",
        list(colour),
    )
    return int(count)


def test_two_runs_lie_over_one_another_and_a_press_seeks_the_replay(open_page: OpenPage) -> None:
    page = open_page("/runs", pictures=False)
    wait_until(page, f"{RUNS}?.both && {CHART}?.plot")
    rows = page.locator("tbody tr")
    expect(rows).to_have_count(2)
    expect(rows.nth(0)).to_contain_text("together")
    expect(rows.nth(1)).to_contain_text("1.0 s later")
    expect(rows.nth(1)).to_contain_text("+1.0 s")
    white, blue = (244, 246, 248), (105, 167, 255)
    wait_until(page, f"{CHART}.a.values.filter((value) => value > 0.9).length > 10")
    assert drawn(page, white) > 100
    page.keyboard.press("a")
    wait_until(page, f"{CHART}.a.values.length === 0")
    assert drawn(page, blue) > 100
    assert drawn(page, white) < 20  # cues alone
    page.keyboard.press("a")
    page.get_by_label("Aligned at").select_option("start")
    wait_until(page, f"{RUNS}.anchor === 'start'")
    expect(rows.nth(0)).to_contain_text("0.5 s later")
    box = page.locator("omote-run-chart .u-over").first.bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 60)
    wait_until(page, f"{RUNS}.here > 2 && {RUNS}.here < 4")
    asked = "(async () => (await (await fetch('/replay/transport')).json()))()"
    here = page.evaluate(f"{RUNS}.here")
    transport = page.evaluate(asked)
    assert transport["start"] == 2
    assert here - 0.5 <= transport["position"] <= 6.0
    page.mouse.wheel(0, -200)
    wait_until(page, f"{RUNS}.view.max - {RUNS}.view.min < 5.5")
    page.keyboard.press("0")
    wait_until(page, f"{RUNS}.view.max - {RUNS}.view.min > 5.5")
    page.get_by_role("button", name="Look at A").click()
    wait_until(page, f"{RUNS}.looks === 'a'")
    page.keyboard.press("Period")
    wait_until(page, f"Math.abs({RUNS}.here - 3) < 0.2 || Math.abs({RUNS}.here - 4.5) < 0.2")


def test_a_note_is_stamped_when_its_writer_began(tmp_path: Path, open_page: OpenPage) -> None:
    for address in playing(tmp_path / "live.omote"):
        page = open_page("/notes", pictures=False)
        page.goto(f"{address}/notes")
        book = "document.querySelector('omote-notes-page').book"
        wait_until(page, f"{book}?.document.spans.length > 0")
        field = page.get_by_label("Note", exact=True)
        page.get_by_label("Your name").fill("dora")
        page.get_by_label("Your name").blur()
        field.fill("t")
        begun = page.evaluate(f"{book}.document.now")
        field.press_sequentially("oo late")
        wait_until(page, f"{book}.document.now > {begun} + 1.5")
        field.press("Enter")
        expect(page.locator("omote-note-list li")).to_contain_text("too late dora")
        (note,) = page.evaluate(f"{book}.document.markers")
        assert note["written"] < page.evaluate(f"{book}.document.now") - 1.0
        page.get_by_role("button", name="Change: too late").click()
        words = page.get_by_label("What it says")
        words.fill("much too late")
        words.press("Enter")
        expect(page.locator("omote-note-list li")).to_contain_text("much too late")
        page.get_by_role("button", name="Delete: much too late").click()
        expect(page.get_by_text("No notes yet.")).to_be_visible()
        page.get_by_role("button", name="Bring back").click()
        expect(page.locator("omote-note-list li")).to_contain_text("much too late dora")
        assert page.evaluate(f"{book}.document.markers[0].at") == note["at"]
