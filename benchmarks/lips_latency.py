"""From the sound at a browser to the state: below 80 ms at the pace of the machine (issue 12, lips from a microphone).

A real show, the real page in Chromium, whose microphone plays a file of vowels and pauses. A vowel begins at the first
sample that is loud in what the page sends, at the time when that sample was handed to the page; the state has it when
the jaw on air has parted the lips by a tenth of the way that it goes, as the browser hears it by the link of stages.
What the sound card takes before that is said by the browser and printed, but is not in it.

`python -m benchmarks.lips_latency [--vowels N]`.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import sys
import tempfile
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from playwright.sync_api import Page, sync_playwright
from scipy.io import wavfile

from benchmarks.pace import measure_waiting_pace
from omote.inputs.microphone.sound_features import SAMPLE_RATE
from tests.browser.conftest import PAGES, QUIET, playing
from tests.inputs.microphone.voices import pause, pcm, vowel
from tools.browser import SENTENCE, find_browser

RATE = 48000
BAR = 0.08
LOUD = 0.02
QUIET_BEFORE = 0.3
PARTED = 0.1
LOG = """
window.log = [];
const send = WebSocket.prototype.send;
WebSocket.prototype.send = function (data) {
  if (this.url.endsWith("/voice")) log.push(["sent", performance.now(), [...new Uint8Array(data)]]);
  else if (!this.seen) {
    this.seen = true;
    this.addEventListener("message", ({ data }) => log.push(["state", performance.now(), [...new Uint8Array(data)]]));
  }
  return send.call(this, data);
};
"""


def record(address: str, sound: Path, seconds: float) -> tuple[list[Any], str]:
    """What a page sent and heard, and what the browser says of its microphone."""
    fake = ["--use-fake-device-for-media-stream", f"--use-file-for-fake-audio-capture={sound}", "--disable-gpu"]
    with sync_playwright() as playwright:
        found = find_browser()
        if found is None:
            raise SystemExit(SENTENCE)
        browser = playwright.chromium.launch(executable_path=str(found), args=[*PAGES, *QUIET, *fake])
        context = browser.new_context(permissions=["microphone"])
        context.add_init_script(LOG)
        page = context.new_page()
        page.goto(f"{address.rstrip('/')}/microphone")
        listen_to_states(page)
        page.get_by_role("button", name="Start the microphone").click()
        page.wait_for_timeout(1000 * seconds)
        log = page.evaluate("log")
        card = (page.evaluate(
            "navigator.mediaDevices.getUserMedia({ audio: true })"
            ".then((s) => JSON.stringify(s.getAudioTracks()[0].getSettings().latency ?? null))"
        ))  # fmt: skip
        browser.close()
    return log, card


def listen_to_states(page: Page) -> None:
    """Opens the link of stages beside the microphone's."""
    hello = msgspec.msgpack.encode({"type": "hello", "role": "stage", "version": 6, "name": "latency"})
    page.evaluate(
        "(hello) => { const link = new WebSocket(`ws://${location.host}/link`); link.binaryType = 'arraybuffer';"
        " link.onopen = () => link.send(new Uint8Array(hello)); }",
        list(hello),
    )


def onsets_of(log: list[Any]) -> list[float]:
    """When the first sample of each vowel was handed to the page, ms."""
    found = []
    last = -1e9
    for kind, time, data in log:
        message = msgspec.msgpack.decode(bytes(data)) if kind == "sent" else {}
        if message.get("type") != "sound":
            continue
        samples = np.frombuffer(message["samples"], "<i2") / 32768
        loud = np.flatnonzero(np.abs(samples) > LOUD)
        if not len(loud):
            continue
        if time - last > 1000 * QUIET_BEFORE:
            found.append(time - 1000 * (len(samples) - loud[0]) / SAMPLE_RATE)
        last = time
    return found


def jaws_of(log: list[Any]) -> list[tuple[float, float]]:
    """When each state came, ms, and its jaw."""
    found = []
    for kind, time, data in log:
        message = msgspec.msgpack.decode(bytes(data)) if kind == "state" else {}
        if message.get("type") == "state":
            found.append((time, message["characters"]["one"]["channels"].get("jawOpen", 0.0)))
    return found


def main() -> int:
    """Prints the latencies; exit status 1 where the median is above the bar."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--vowels", type=int, default=20)
    vowels = parser.parse_args().vowels
    with tempfile.TemporaryDirectory() as folder:
        sound = Path(folder) / "vowels.wav"
        show = playing(Path(folder) / "show.omote")
        parts = [pause(0.9, rate=RATE), vowel(0.3, rate=RATE)] * 5
        wavfile.write(sound, RATE, np.frombuffer(pcm(np.concatenate(parts)), "<i2"))
        log, card = record(next(show), sound, 1.2 * vowels + 2.0)
        next(show, None)  # ends it
    jaws = jaws_of(log)
    lags = []
    for onset in onsets_of(log)[1:]:
        after = [(time, jaw) for time, jaw in jaws if onset <= time < onset + 600]
        most = max((jaw for _, jaw in after), default=0.0)
        parted = [time for time, jaw in after if jaw > PARTED * most and most > 0.05]
        lags.append(parted[0] - onset if parted else float("inf"))
    median, high = np.percentile(lags, [50, 90])
    most = 1000 * BAR * measure_waiting_pace()
    print(
        f"{len(lags)} vowels: sound at the page to the state at the page {median:.0f} ms in the median, {high:.0f} ms"
    )
    print(f"at 90 %; bar {most:.0f} ms. Beside it: the browser's word on its microphone, {card} s.")
    return int(not median <= most)


if __name__ == "__main__":
    sys.exit(main())
