"""The kernels of the layers are what whole arrays give, to the bit."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.layers.layer_kernels import FILLS, OFFSETS, REPLACES, SKIPS, find_strongest, mix_streams

PARTS = np.array([0, 2, 1, 6, 2, 3], np.int64)
WIDTH = len(PARTS)
seeds = st.integers(0, 2**32 - 1)


@given(seeds, st.lists(st.sampled_from([SKIPS, OFFSETS, REPLACES, FILLS]), min_size=1, max_size=6))
def test_layers_are_mixed_one_over_the_other(seed: int, does: list[int]) -> None:
    rng = np.random.default_rng(seed)
    streams = rng.uniform(-0.5, 1.5, (len(does), WIDTH))
    shares = rng.random((8, 7))
    rows = np.arange(len(does) + 1, dtype=np.int64)
    hold, hands = rng.random((2, WIDTH))
    lowest, highest = np.full(WIDTH, -0.25), np.full(WIDTH, 1.25)
    found = np.empty(WIDTH)
    mix_streams(streams, shares, PARTS, np.array(does, np.int64), rows, hold, hands, lowest, highest, found)
    mixed = np.zeros(WIDTH)
    for rule, stream, row in zip(does, streams, shares[:, PARTS], strict=False):
        if rule == REPLACES:
            mixed = (1.0 - row) * mixed + row * stream
        elif rule == OFFSETS:
            mixed = mixed + row * stream
        elif rule == FILLS:
            mixed = mixed + row * stream * (1.0 - mixed)
    held = shares[len(does), PARTS] * hold
    wanted = np.maximum(np.minimum((1.0 - held) * mixed + held * hands, highest), lowest)
    assert found.tobytes() == wanted.tobytes()


@given(seeds, st.integers(1, 3), st.integers(0, 3))
def test_the_strongest_columns_come_first_and_of_equals_the_first(seed: int, most: int, more: int) -> None:
    streams = np.random.default_rng(seed).integers(-3, 4, (4, most + more + 2)) / 2.0  # many are equal
    found = np.empty((4, most), np.int64)
    values = np.empty((4, most))
    find_strongest(streams, most + more, found, values)
    order = np.argsort(-np.abs(streams[:, : most + more]), axis=1, kind="stable")
    assert found.tolist() == order[:, :most].tolist()
    assert values.tolist() == np.take_along_axis(streams, found, axis=1).tolist()
