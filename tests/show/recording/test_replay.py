"""A replay does again what a session did, to the last bit, from the beginning and from anywhere."""

from __future__ import annotations

import zlib

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.perform.snapshot import Playable
from omote.show.objects.clips import DropClip, KeepPass, PlayClip, RecordClip
from omote.show.objects.state import State
from omote.show.preview_bus import PreviewBus
from omote.show.recording import recorder
from omote.show.recording.entries import AnyEntry, Ticked, begins_piece
from omote.show.recording.replay import ReplayError, replay
from omote.show.wire import encode
from tests import synthetic
from tests.show.recording.random_show import RandomShow, as_stored
from tests.synthetic import Recast

CAST = synthetic.cast()
OTHER = Recast(CAST, [*CAST.faces, "cousin"], [*CAST.expressions, "grin"])
NO_CASTS: dict[str, Playable] = {}
CASTS: dict[str, Playable] = {CAST.digest: CAST, OTHER.digest: OTHER}


@pytest.fixture(autouse=True)
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorder, "SNAPSHOT_SECONDS", 0.5)
    monkeypatch.setattr(recorder, "PIECE_SNAPSHOTS", 4)


@pytest.mark.parametrize("seed", range(6))
def test_every_state_of_a_random_show_comes_again_to_the_last_bit(seed: int) -> None:
    show = RandomShow(seed, CASTS)
    show.play(20.0)
    entries, clips = as_stored(show.entries)
    ticks = list(replay([entries], CASTS.__getitem__, clips.__getitem__))
    different = [number for number, tick in enumerate(ticks) if encode(tick.state) != show.states[number]]
    assert (different[:1], len(ticks)) == ([], len(show.states))
    assert all(tick.same for tick in ticks)


@pytest.mark.parametrize("seed", range(3))
def test_a_seek_ends_at_the_same_states_from_any_tick_on(seed: int) -> None:
    show = RandomShow(100 + seed, CASTS)
    show.play(10.0)
    times = [entry.now for entry in show.entries if isinstance(entry, Ticked)]
    for number in show.rng.integers(0, len(times) - 1, 8).tolist():
        ticks = list(replay([show.entries], CASTS.__getitem__, after=times[number]))
        assert [encode(tick.state) for tick in ticks] == show.states[number + 1 :]


def test_a_seek_plays_no_preview_and_encodes_no_state_before_its_first(monkeypatch: pytest.MonkeyPatch) -> None:
    show = RandomShow(100, CASTS)
    show.play(5.0)
    times = [entry.now for entry in show.entries if isinstance(entry, Ticked)]
    encoded: list[State] = []

    def note(state: State) -> bytes:
        encoded.append(state)
        return encode(state)

    monkeypatch.setattr(PreviewBus, "advance", lambda *_: pytest.fail("nobody sees the preview of a replay"))
    monkeypatch.setattr("omote.show.recording.replay.encode", note)
    tick = next(replay([show.entries], CASTS.__getitem__, after=times[200]))
    assert encode(tick.state) == show.states[201]
    assert encoded == [tick.state]


def test_a_piece_needs_no_entry_before_it() -> None:
    show = RandomShow(7, CASTS)
    show.play(10.0)
    begins = [place for place, entry in enumerate(show.entries) if begins_piece(entry)]
    assert len(begins) > 3
    for place in begins:
        ticks = list(replay([show.entries[place:]], CASTS.__getitem__))
        assert [encode(tick.state) for tick in ticks] == show.states[len(show.states) - len(ticks) :]


def pieces_of(entries: list[AnyEntry]) -> list[list[AnyEntry]]:
    begins = [place for place, entry in enumerate(entries) if begins_piece(entry)]
    return [entries[begin:end] for begin, end in zip(begins, [*begins[1:], len(entries)], strict=True)]


@settings(max_examples=5)
@given(missing=st.integers(0, 4))
def test_after_a_gap_a_replay_goes_on_from_the_next_piece(missing: int) -> None:
    show = RandomShow(11, CASTS)
    show.play(10.0)
    pieces = pieces_of(show.entries)
    assert len(pieces) > 5
    left = [piece for number, piece in enumerate(pieces) if number != missing]
    lost = sum(isinstance(entry, Ticked) for entry in pieces[missing])
    begin = sum(isinstance(entry, Ticked) for piece in pieces[:missing] for entry in piece)
    states = [encode(tick.state) for tick in replay(left, CASTS.__getitem__)]
    assert states == [*show.states[:begin], *show.states[begin + lost :]]


def test_a_replay_says_at_the_first_tick_that_it_is_not_the_same() -> None:
    show = RandomShow(8, CASTS)
    show.play(3.0)
    places = [place for place, entry in enumerate(show.entries) if isinstance(entry, Ticked)]
    entries = list(show.entries)
    wrong = places[70]
    entries[wrong] = msgspec.structs.replace(entries[wrong], check=zlib.crc32(b"another"))
    assert [number for number, tick in enumerate(replay([entries], CASTS.__getitem__)) if not tick.same] == [70]


def test_what_cannot_be_replayed_is_said() -> None:
    show = RandomShow(9, CASTS)
    show.play(1.0)
    with pytest.raises(ReplayError, match="begins with a snapshot"):
        list(replay([show.entries[1:]], CASTS.__getitem__))
    with pytest.raises(ReplayError, match="cast that played"):
        list(replay([show.entries], NO_CASTS.__getitem__))


def test_a_seek_plays_a_clip_as_it_was_called_whatever_was_edited_since() -> None:
    show = RandomShow(1, {CAST.digest: CAST})
    show.calm = 1e9
    show.send("ana", RecordClip("a", "one", "c1"))
    show.play(1.0)
    show.send("ana", KeepPass("b", "one"))
    show.send("ana", PlayClip("one", "c", "c1", 0.0, loop=True))
    show.play(0.5)
    show.send("ana", DropClip("d", "c1"))
    show.play(3.0)
    stored, clips = as_stored(show.entries)
    times = [entry.now for entry in stored if isinstance(entry, Ticked)]
    ticks = list(replay([stored], CASTS.__getitem__, clips.__getitem__, after=times[200]))
    assert [encode(tick.state) for tick in ticks] == show.states[201:]
    assert [clip.name for clip in ticks[-1].state.characters["one"].clips] == ["c1"]
