"""A stage that plays what a character says: once, at one stage, in time with the lips that it draws."""

from __future__ import annotations

import io
import wave
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, Route

import omote
from omote.client.connect import ConnectedShow
from tests.browser.waiting import wait_until

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
RATE = 16000
LATEST = 0.12
"""Seconds by which what is heard and what is seen may differ: half of a syllable; a browser test's machine is busy."""

ON = (0.05, 0.15)
"""Of loudness and of the jaw: from there on a beep is heard, and seen."""
LOUD = 0.2
"""Seconds of a beep."""
BEGINS = 0.5 + np.cumsum(np.random.default_rng(5).uniform(0.6, 1.2, 40))
"""Seconds at which beeps begin; no part of them is like another."""
ENOUGH = 20
"""Looks at a beep and at an open jaw, however seldom a busy machine looks."""

BLOCKED = """
const state = Object.getOwnPropertyDescriptor(BaseAudioContext.prototype, "state").get;
let clicked = false;
addEventListener("pointerdown", () => { clicked = true; }, true);
const found = { get() { return clicked ? state.call(this) : "suspended"; } };
Object.defineProperty(BaseAudioContext.prototype, "state", found);
"""
"""Contexts do not run before a click, as in a browser with a window; without one all of them do."""

RECORD = """async ([seconds]) => {
    const rows = [];
    let seen = 0;
    const begin = performance.now();
    while (performance.now() - begin < 1000 * seconds) {
        await new Promise(requestAnimationFrame); // right after the stage has drawn, and before that is seen
        rows.push([performance.now() / 1000, window.omoteStage.sound().level, seen]);
        seen = window.omoteStage.pose()?.channels.jawOpen ?? 0;
    }
    return rows;
}"""
"""What plays while each picture is seen, until the next: a machine that shows few a second has as few looks at both."""


def beeps(times: list[float], seconds: float) -> bytes:
    """A WAV that is loud for 0.2 s from each of these times on."""
    at = np.arange(int(seconds * RATE)) / RATE
    loud = sum(((at >= begin) & (at < begin + LOUD)).astype(float) for begin in times)
    samples = (12000 * loud * np.sin(2 * np.pi * 440 * at)).astype("<i2")
    made = io.BytesIO()
    with wave.open(made, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(samples.tobytes())
    return made.getvalue()


@pytest.fixture
def program(show: str) -> Iterator[ConnectedShow]:
    """A program at the show, which ends what it said."""
    with omote.connect(show, name="chat") as connected:
        yield connected
        connected["*"].stop_speaking()


def sound(page: Page) -> dict[str, Any]:
    """What a stage tells of its sounds."""
    found: dict[str, Any] = page.evaluate("window.omoteStage.sound()")
    return found


def say_beeps(program: ConnectedShow, times: list[float], seconds: float) -> None:
    """Says an open vowel with each beep, silence between them."""
    marks = list[str]()
    starts = list[float]()
    for begin in times:
        marks += ["aa", "sil"]
        starts += [begin, begin + LOUD]
    key = program.send_sound(beeps(times, seconds))
    program["one"].say(timing="visemes", marks=marks, times=[*starts, seconds], sound=key)


def open_stage(open_page: OpenPage, query: str = "") -> Page:
    """A stage that draws, in a corner so small that it draws in time."""
    page = open_page(f"/stage?quality=lowest{query}", width=160, height=120, disposable=True)
    wait_until(page, "window.omoteStage && window.omoteStage.counters().drawn > 0")
    return page


def test_a_stage_that_may_not_play_yet_says_what_to_do_and_plays_after_a_click(
    open_page: OpenPage, program: ConnectedShow
) -> None:
    page = open_stage(open_page)
    page.add_init_script(BLOCKED)
    page.reload()
    wait_until(page, "window.omoteStage && window.omoteStage.counters().drawn > 0")
    say_beeps(program, [0.5, 60.0], 62.0)
    wait_until(page, "document.getElementById('notice').textContent.includes('click it once')")
    assert sound(page)["begun"] == 0
    page.mouse.click(20, 20)
    wait_until(page, "window.omoteStage.sound().begun === 1 && document.getElementById('notice').textContent === ''")
    program["one"].stop_speaking()
    wait_until(page, "window.omoteStage.sound().playing.length === 0")


def test_a_sound_that_comes_late_to_a_show_is_heard_from_there_on(open_page: OpenPage, program: ConnectedShow) -> None:
    page = open_stage(open_page)
    asked = list[str]()

    def miss_twice(route: Route) -> None:
        asked.append(route.request.url)
        if len(asked) <= 2:
            route.fulfill(status=404, body="there is no such sound any more")
        else:
            route.continue_()

    page.route("**/sounds/*", miss_twice)
    page.mouse.click(20, 20)
    say_beeps(program, [0.5, 60.0], 62.0)
    wait_until(page, "window.omoteStage.sound().begun === 1")
    assert len(asked) == 3
    program["one"].stop_speaking()
    wait_until(page, "window.omoteStage.sound().playing.length === 0")


def test_lips_move_in_time_with_the_sound_which_is_heard_once(open_page: OpenPage, program: ConnectedShow) -> None:
    page = open_stage(open_page)
    other = open_stage(open_page)
    page.mouse.click(20, 20)
    other.mouse.click(20, 20)
    say_beeps(program, BEGINS.tolist(), BEGINS[-1] + 1.0)
    wait_until(page, "true")
    rows = np.empty((0, 3))
    while len(rows) == 0 or (sound(page)["playing"] and (rows[:, 1:] > ON).sum(axis=0).min() < ENOUGH):
        rows = np.concatenate([rows, page.evaluate(RECORD, [3.0])])
    heard = [sound(each)["begun"] for each in (page, other)]
    assert [count > 0 for count in sorted(heard)] == [False, True]  # one begins anew where its picture fell behind
    if heard[0] > 0:
        assert (rows[:, 1:] > ON).sum(axis=0).min() >= ENOUGH
        latency = sound(page)["latency"]
        loud, open_jaw = (begin_of(rows[:, 0], rows[:, column] > on) for column, on in enumerate(ON, start=1))
        assert abs(open_jaw - (loud + latency)) < LATEST


def begin_of(times: np.ndarray, on: np.ndarray) -> float:
    """When a speech of beeps began, by the looks that found it on or off: where most of them agree with the beeps."""
    starts = np.arange(times[0] - BEGINS[-1], times[-1], 0.01)
    since = times[None, :] - starts[:, None]
    latest = BEGINS[np.searchsorted(BEGINS, since, side="right") - 1]
    expected = (since >= BEGINS[0]) & (since - latest < LOUD)
    agreed = (expected == on[None, :]).sum(axis=1)
    return float(np.median(starts[agreed == agreed.max()]))


def test_a_stage_whose_address_asks_for_it_plays_before_all_others(open_page: OpenPage, program: ConnectedShow) -> None:
    first = open_stage(open_page)
    named = open_stage(open_page, "&sound=1")
    never = open_stage(open_page, "&sound=0")
    for page in (first, named, never):
        page.mouse.click(20, 20)
    wait_until(named, "window.omoteStage.sound().plays")
    wait_until(first, "!window.omoteStage.sound().plays")
    assert not sound(never)["plays"]
    assert sound(never)["state"] == ""


def test_the_mouth_of_the_picture_moves(open_page: OpenPage, program: ConnectedShow) -> None:
    page = open_stage(open_page, "&sound=0")
    wait_until(page, "window.omoteStage.settled()")
    rest = np.array(page.evaluate("window.omoteStage.readPositions()"))
    program["one"].say(timing="visemes", marks=["aa"], times=[0.0, 20.0])
    wait_until(page, "(window.omoteStage.pose().channels.jawOpen ?? 0) > 0.3 && window.omoteStage.settled()")
    opened = np.array(page.evaluate("window.omoteStage.readPositions()"))
    assert np.abs(opened - rest).max() > 0.004  # metres
    program["one"].stop_speaking()
    wait_until(page, "(window.omoteStage.pose().channels.jawOpen ?? 0) < 0.02")
