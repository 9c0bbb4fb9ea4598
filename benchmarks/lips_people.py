"""Lips from recordings of people, none of whom the network was trained on; measures, bars and baseline of `lips.py`.

* a Russian: 100 minutes with labels of their maker, of which random sentences are played; Russian is no language of the
  training either (`apt-get install festvox-ru`);
* an Englishwoman: five sentences of LibriVox, aligned with their text by pocketsphinx (`apt-get install
  pocketsphinx-testdata`, `pip install pocketsphinx`).

Their labels come from aligners, whose boundaries are good to 10 or 20 ms, and in running speech vowels shade into each
other: what is 70 % for a synthesizer is less here. `python -m benchmarks.lips_people [--sentences N] [--seed S]`; who
is not installed is left out.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import sys
from collections.abc import Iterator

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.lips import TITLES, Options, Said, measure, row
from tools.lips.corpus import join_speech
from tools.lips.human_voices import read_librivox, read_russian, russian_names

CONDITIONS = ("plain", "loud, clipped", "whisper", "noise at -10 dB", "people at -10 dB")
TOGETHER = 5
"""Sentences that are played one after the other; two more calibrate."""


def say_russian(options: Options) -> Iterator[Said]:
    """Random sentences of the Russian."""
    names = options.rng.permutation(russian_names()).tolist()[: options.sentences + 2]
    calibrate = join_speech([read_russian(name) for name in names[-2:]], options.rng)
    for start in range(0, len(names) - 2, TOGETHER):
        said = [read_russian(name) for name in names[start : min(start + TOGETHER, len(names) - 2)]]
        yield join_speech(said, options.rng), calibrate


def say_english(options: Options) -> Iterator[Said]:
    """The sentences of the Englishwoman; she is calibrated by the two shortest of them, which are played too."""
    said = list(read_librivox())
    if said:
        calibrate = join_speech(sorted(said, key=lambda each: len(each.sound))[:2], options.rng)
        yield join_speech(said, options.rng), calibrate


def main() -> int:
    """Prints the table; exit status 1 where nobody is installed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sentences", type=int, default=20)
    parser.add_argument("--seed", type=int, default=None)
    asked = parser.parse_args()
    options = Options(np.random.default_rng(asked.seed), asked.sentences)
    options.others = np.concatenate([options.speak(voice, 3).sound for voice in ("en+m1", "en+f1")])
    table = Table(*TITLES, title="Lips from recordings of people")
    for name, say in (("a Russian", say_russian), ("an Englishwoman", say_english)):
        for condition in CONDITIONS:
            (ours, peer), late = measure(say(options), condition, True, options)
            if not ours.right:
                continue
            table.add_row(*row(f"{name} ({len(ours.closed)} bilabials, {1000 * late:.0f} ms late)", condition, ours))
            table.add_row(*row("  as uLipSync", "", peer), style="dim")
            print(*row(name, condition, ours), f"late {1000 * late:.0f} |", *row("ulipsync", "", peer)[2:], flush=True)
    Console(width=150).print(table)
    return int(not table.rows)


if __name__ == "__main__":
    sys.exit(main())
