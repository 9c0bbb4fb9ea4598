"""A rendered hand before the camera page: its guided minute, then play, through the product in Chromium.

Films of fresh seeds are rendered from the rig of the CC0 body (no person was filmed). In a real Chromium their pictures
come to the page in place of the camera's, each at its time by the page's clock: a camera that Chromium plays from a
file falls behind on a busy machine, and nobody knows what was seen when. The performer of a film follows the drawn
hand of the page with a delay of its own; then it plays at random, opens and shuts four times a second, and leaves the
picture three times.

`python -m benchmarks.hands [--seeds 3] [--seed 100] [--slow 1] [--both]`; a film takes two minutes to render and
two to play.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import itertools
import json
import math
import secrets
import sys
import tempfile
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Page, sync_playwright

from omote.builtin import load_cast
from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.hand_input import HandInput
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from tests.browser.conftest import PAGES, QUIET, playing
from tools.baking.package import Package, find_wheel
from tools.browser import ROOT, find_browser
from tools.hands.hand_film import FILM_RATE, HandCamera, jpeg_of, random_hand, random_hand_setting
from tools.hands.posed_hand import HandPose

Values = NDArray[np.float64]
AXES = ("opening", "index", "little", "yaw", "pitch", "roll")
MOVES = json.loads((ROOT / "web" / "src" / "hands" / "guide_moves.json").read_text())
GUIDE = float(MOVES["sections"][-1]["until"])
TURNS = (25.0, 25.0, 20.0)
"""Degrees of the wrist at the farthest turns: away from the lens, up, tilted away."""
TICK = 1.0 / 60.0
CHANNELS = ("jawOpen", "browInnerUp", "browDownLeft", "mouthSmileLeft", "mouthFrownLeft")
RENDERED = 15
"""Pictures a second that are rendered; each is seen twice, as of a camera of `FILM_RATE` pictures a second."""
MANY = 100
"""Pictures of a film that the page is given at once."""
EMPTY = 2.0
READY = 4.0
PLAY = 12.0
FAST = 4.0
SHOWN = 2.0
AWAY = 1.0
"""Seconds of a film: an empty room, a hand that gets ready, the minute, then play, 4 Hz, and three times there and
away."""
RETURNS = 1.2
"""Seconds in which a hand that is back takes over, the page's delay with it: then it plays as before."""
LEAPS = 0.6
"""Seconds in which play leaves what a film's performer does from one picture to the next where 4 Hz begin."""


@dataclass(frozen=True, eq=False)
class Script:
    """What the hand of a film does: axes (n, 6) at RENDERED pictures a second, whether it is there; begins, in seconds,
    of the parts by name."""

    axes: Values
    there: NDArray[np.bool_]
    begins: Mapping[str, float]


def moves_at(axis: str, time: float) -> float:
    """What the drawn hand of the page does. axis: of AXES; time: seconds of the minute."""
    knots = MOVES["moves"][axis]
    if time <= knots[0][0]:
        return float(knots[0][1])
    for (begin, low), (end, high) in itertools.pairwise(knots):
        if time < end:
            share = (time - begin) / (end - begin)
            return float(low + share * share * (3.0 - 2.0 * share) * (high - low))
    return float(knots[-1][1])


def random_play(draw: np.random.Generator, times: Values, hertz: float) -> Values:
    """A smooth random series of unit spread with parts up to a frequency."""
    waves = [
        draw.normal() * np.sin(math.tau * hertz * part / 11.0 * times + draw.uniform(0.0, math.tau))
        for part in range(1, 12)
    ]
    series = np.sum(waves, 0)
    result: Values = series / series.std()
    return result


def write_script(draw: np.random.Generator) -> Script:
    """What the hand does from the film's first picture to its last."""
    delay = draw.uniform(0.15, 0.35)
    parts: list[tuple[str, float]] = [("empty", EMPTY), ("ready", READY), ("minute", GUIDE + 1.0), ("play", PLAY)]
    parts += [("fast", FAST)]
    for number in range(3):
        parts += [(f"away {number}", AWAY), (f"back {number}", SHOWN)]
    begins = dict(zip([name for name, _ in parts], np.cumsum([0.0, *(length for _, length in parts)]), strict=False))
    total = sum(length for _, length in parts)
    times = np.arange(round(total * RENDERED)) / RENDERED
    minute = np.array([[moves_at(axis, t - begins["minute"] - delay) for axis in AXES] for t in times])
    play = [np.clip(0.5 + 0.35 * random_play(draw, times, 2.0), 0.0, 1.0)]
    play += [np.clip(0.5 * random_play(draw, times, hertz), -1.0, 1.0) for hertz in (1.0, 1.0, 0.7, 0.7, 0.7)]
    axes = np.where((times >= begins["play"])[:, None], np.stack(play, 1), minute)
    fast = (times >= begins["fast"]) & (times < begins["away 0"])
    axes[fast] = 0.0
    axes[fast, 0] = 0.5 + 0.35 * np.sin(math.tau * 4.0 * times[fast])
    there = times >= begins["ready"]
    for number in range(3):
        there &= (times < begins[f"away {number}"]) | (times >= begins[f"back {number}"])
    return Script(axes, there, begins)


def pose_of(axes: Values) -> HandPose:
    """The pose of a hand that does this."""
    opening, index, little, yaw, pitch, roll = axes.tolist()
    turns = [-math.radians(most) * turn for most, turn in zip(TURNS, (yaw, pitch, roll), strict=True)]
    return HandPose(opening, (index, little), *turns)


def take_film(wheel: Path, seed: int) -> tuple[Script, list[bytes]]:
    """Renders a film of a fresh hand, JPEGs. wheel: of the package; seed: of hand, room, noise and moves."""
    script = write_script(np.random.default_rng(seed))
    workers = os.cpu_count() or 1
    parts = np.array_split(np.arange(len(script.axes)), 8 * workers)
    with ProcessPoolExecutor(workers) as pool:
        return script, list(itertools.chain(*pool.map(render, repeat(wheel), repeat(seed), parts)))


def render(wheel: Path, seed: int, pictures: NDArray[np.intp]) -> list[bytes]:
    """Some pictures of a film, by their numbers; wheel, seed: as of `take_film`."""
    script = write_script(np.random.default_rng(seed))
    draw = np.random.default_rng(seed + 1)
    hand = random_hand(Package(wheel), draw)
    camera = HandCamera(hand, random_hand_setting(draw), np.random.default_rng([seed, int(pictures[0])]))
    return [jpeg_of(camera.take(pose_of(script.axes[place]) if script.there[place] else None)) for place in pictures]


CAMERA = """(({ slow, rate, rendered, places, many }) => {
  const real = performance.now.bind(performance);
  performance.now = () => real() / slow;
  const seconds = () => performance.now() / 1000;
  if (slow > 1) requestAnimationFrame = (draw) => setTimeout(draw, 100 * slow); // a busy machine has passes to make
  const load = async () => {
    const parts = [];
    for (let part = 0; part * many < places.length - 1; part++) parts.push(await (await fetch(`/film/${part}`)).blob());
    return new Blob(parts);
  };
  const whole = load();
  window.film = { began: Infinity };
  const pull = async (controller) => {
    const pictures = await whole;
    const next = Math.floor(seconds() * rate + 1) / rate;
    await new Promise((done) => setTimeout(done, 1000 * slow * (next - seconds())));
    const place = Math.max(0, Math.min(places.length - 2, Math.floor((seconds() - film.began) * rendered)));
    const picture = await createImageBitmap(pictures.slice(places[place], places[place + 1]));
    controller.enqueue(new VideoFrame(picture, { timestamp: 0 }));
    picture.close();
  };
  window.MediaStreamTrackProcessor = class {
    readable = new ReadableStream({ pull }, { highWaterMark: 0 });
  };
})"""
"""Hands the film's pictures to the page as its camera's, the newest at each time; until it begins, its first."""
WATCH = """({ slow, minute }) => {
  const { session } = document.querySelector("omote-camera-page");
  const log = { readings: [], sent: [], faces: 0, began: performance.now() / 1000 + 0.5 };
  window.log = log;
  const { host } = session.hand;
  const send = host.send;
  host.send = (message) => {
    if (message.type === "hand_frame") log.sent.push([performance.now() / 1000, message]);
    return send(message);
  };
  const { face, hands } = session.drawing;
  session.drawing.face = (landmarks) => { log.faces += 1; face(landmarks); };
  session.drawing.hands = (found, playing) => {
    const { time, axes } = session.hand.reading;
    log.readings.push([time, axes && Object.values(axes)]);
    hands(found, playing);
  };
  if (slow > 1) session.video.style.display = "none";
  film.began = log.began;
  session.hand.beginMinute(log.began + minute - 3); // it gives three seconds to get ready
}"""
SESSION = "document.querySelector('omote-camera-page')?.session"

GATHER = f"(({{ hand }}) => ({{ ...log, kept: hand.calibration, failed: hand.failed, model: hand.model }}))({SESSION})"


def film_part(film: list[bytes], part: int) -> bytes:
    """Some pictures of a film: a whole one is too long for one answer. part: its number."""
    return b"".join(film[MANY * part : MANY * (part + 1)])


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition holds on a page; its content security lets the browser wait for no text."""
    while not page.evaluate(condition):
        page.wait_for_timeout(500)


def perform(address: str, film: list[bytes], *, slow: int, both: bool, minute: float) -> dict[str, Any]:
    """What the page read and sent while it saw a film. address: of the show; film: pictures; slow: how many times as
    slow as real the page's clock goes; both: looks for a face too; minute: when the guided minute begins, seconds."""
    places = [0, *itertools.accumulate(map(len, film))]
    of_film = {"slow": slow, "rate": FILM_RATE, "rendered": RENDERED, "places": places, "many": MANY}
    camera = f"--use-fake-device-for-media-stream=fps={FILM_RATE if slow == 1 else 5}", "--use-fake-ui-for-media-stream"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=str(find_browser()), chromium_sandbox=False, args=[*PAGES, *QUIET, *camera]
        )
        page = browser.new_context(permissions=["camera"]).new_page()
        page.route(
            "**/film/*", lambda route: route.fulfill(body=film_part(film, int(route.request.url.split("/")[-1])))
        )
        page.add_init_script(f"localStorage['omote.camera.tracked'] = '{'both' if both else 'hand'}'")
        page.add_init_script(f"{CAMERA}({json.dumps(of_film)})")
        page.goto(f"{address}/camera", timeout=0)
        wait_for(
            page, f"{SESSION}?.hand.reading != null && ({SESSION}.model.kind === 'ready' || {str(not both).lower()})"
        )
        page.evaluate(WATCH, {"slow": slow, "minute": minute})
        wait_for(page, f"performance.now() / 1000 > log.began + {len(film) / RENDERED}")
        found: dict[str, Any] = page.evaluate(GATHER)
        browser.close()
    return found


def correlate(first: Values, second: Values) -> float:
    """The correlation of two series."""
    return float(np.corrcoef(first, second)[0, 1])


@dataclass(frozen=True, eq=False)
class Played:
    """What was on its way to the show while a film played: times (n,) of the film, axes (n, 6) as the page sent them,
    the truth (m, 6) of the film."""

    times: Values
    axes: Values
    script: Script

    def compare(self, part: str, until: str) -> tuple[float, list[tuple[float, float]]]:
        """The lag (seconds) of a part of the film, and of each axis the correlation and the rms error without it.

        part, until: names of parts.
        """
        begin = self.script.begins[part] + 0.5
        end = self.script.begins[until]
        inside = (self.times >= begin) & (self.times < end)
        times = self.times[inside]
        read = self.axes[inside]
        lags = np.arange(0.0, 0.4, 0.01)
        jaw = [correlate(read[:, 0], self._truth(times - lag)[:, 0]) for lag in lags]
        lag = float(lags[int(np.argmax(jaw))])
        truth = self._truth(times - lag)
        return lag, [
            (correlate(read[:, axis], truth[:, axis]), float(np.sqrt(((read[:, axis] - truth[:, axis]) ** 2).mean())))
            for axis in range(len(AXES))
        ]

    def amplitude(self) -> float:
        """Of an opening at 4 Hz, how much of its amplitude is left."""
        begin = self.script.begins["fast"] + 0.5
        end = self.script.begins["away 0"]
        inside = (self.times >= begin) & (self.times < end)
        times = self.times[inside]
        read = self.axes[inside, 0]
        waves = np.stack([np.sin(math.tau * 4.0 * times), np.cos(math.tau * 4.0 * times), np.ones_like(times)], 1)
        sine, cosine, _ = np.linalg.lstsq(waves, read, rcond=None)[0]
        return float(math.hypot(sine, cosine) / 0.35)

    def _truth(self, times: Values) -> Values:
        at = np.arange(len(self.script.axes)) / RENDERED
        return np.stack([np.interp(times, at, self.script.axes[:, axis]) for axis in range(len(AXES))], 1)


def steps_on_air(sent: list[tuple[float, dict[str, Any]]], script: Script) -> tuple[float, float]:
    """What the head's and the channels' speed changes by in a tick at most, played by the show's own engine, beside
    play's: where the hand goes and takes over again; and from the first loss to the end, beside play before it.

    Between two losses the hand plays: for the first that is play too, and the second says of two stretches of play
    which is the wilder.

    sent: what the page sent, by the film's time; script: of the film.
    """
    session = ShowSession(load_cast())
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    hands = HandInput(lambda: session)
    hands.choose("Ada", wire.PlayHand(["one"], []))
    waiting = list(sent)
    shown = []
    times = []
    now = sent[0][0]
    while waiting:
        while waiting and waiting[0][0] <= now:
            message = waiting.pop(0)[1]
            head = None if message["head"] is None else tuple(message["head"])
            hands.receive("Ada", wire.HandFrame(message["time"], message["found"], message["weights"], head))
        hands.play(now)
        character = session.tick(now).characters["one"]
        angles = [math.degrees(angle) / 10.0 for angle in character.head]
        shown.append([character.channels.get(name, 0.0) for name in CHANNELS] + angles)
        times.append(now)
        now += TICK
    steps = np.abs(np.diff(np.array(shown), 2, axis=0)).max(1) / TICK
    at = np.array(times[2:])
    begins = script.begins
    lost = np.zeros(len(at), bool)
    for number in range(3):
        lost |= (at >= begins[f"away {number}"]) & (at < begins[f"back {number}"] + RETURNS)
    after = at >= begins["away 0"]
    play = at > begins["play"] + 1.0
    leap = (at >= begins["fast"]) & (at < begins["fast"] + LEAPS)
    most = [float(steps[part].max()) for part in (lost, play & ~lost & ~leap, after, play & ~after)]
    return most[0] / most[1], most[2] / most[3]


def judge(found: dict[str, Any], script: Script, seconds: float) -> list[tuple[str, float, float, bool]]:
    """The figures of a film: what, how much, the bar, and whether it holds. seconds: of the film."""
    sent = [(time - found["began"], message) for time, message in found["sent"]]
    readings = [(time - found["began"], axes) for time, axes in found["readings"] if axes is not None]
    played = Played(np.array([time for time, _ in readings]), np.array([axes for _, axes in readings]), script)
    lag, axes = played.compare("play", "fast")
    lost, after = steps_on_air(sent, script)
    passes = len(found["readings"]) / seconds
    rows = [("jaw, correlation", axes[0][0], 0.95, axes[0][0] >= 0.95)]
    rows += [("jaw, rms error", axes[0][1], 0.12, axes[0][1] <= 0.12)]
    rows += [(f"{AXES[axis]}, correlation", axes[axis][0], 0.85, axes[axis][0] >= 0.85) for axis in (1, 2)]
    rows += [
        (f"{AXES[axis]}, rms error, degrees", axes[axis][1] * TURNS[axis - 3], math.nan, True) for axis in (3, 4, 5)
    ]
    amplitude = played.amplitude()
    rows += [("opening at 4 Hz, amplitude left", amplitude, 0.7, amplitude >= 0.7)]
    rows += [("steps lost and back, beside play's", lost, 1.0, lost <= 1.0)]
    rows += [("steps after a loss, beside before it", after, math.nan, True)]
    rows += [
        ("passes a second of the film", passes, math.nan, True),
        ("faces a second of the film", found["faces"] / seconds, math.nan, True),
    ]
    rows += [("delay found, seconds", found["kept"]["delay"], math.nan, True), ("lag, seconds", lag, math.nan, True)]
    return rows


def main() -> int:
    """Prints the figures of each film; 1 where one misses its bar."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=3, help="films")
    parser.add_argument("--seed", type=int, default=secrets.randbelow(10**6), help="of the first")
    parser.add_argument("--slow", type=int, default=1, help="film and page go so many times as slow, on a busy machine")
    parser.add_argument("--both", action="store_true", help="finds a face in the same pictures")
    options = parser.parse_args()
    wheel = find_wheel(ROOT / "build" / "cast")
    missed = False
    for seed in range(options.seed, options.seed + options.seeds):
        script, film = take_film(wheel, seed)
        seconds = len(film) / RENDERED
        with tempfile.TemporaryDirectory() as folder:
            for address in playing(Path(folder) / "show.omote"):
                found = perform(address, film, slow=options.slow, both=options.both, minute=script.begins["minute"])
        if found["kept"] is None:
            print(f"seed {seed}: no calibration: {found['failed']}")
            missed = True
            continue
        print(f"seed {seed}, {found['model']}")
        for what, value, bar, holds in judge(found, script, seconds):
            asked = "" if math.isnan(bar) else f"  (bar {bar:g}{'' if holds else ', MISSED'})"
            print(f"  {what:<36} {value:7.3f}{asked}", flush=True)
            missed = missed or not holds
    return int(missed)


if __name__ == "__main__":
    sys.exit(main())
