"""A program's leases: each call is one message that the session obeys."""

import pytest

import omote
from omote.model.cast import Cast
from omote.show import messages as wire
from tests.server.client.link.test_program_link import ticking
from tests.server.client.test_remote_show import Wired
from tests.server.conftest import ShowHarness


def test_a_program_switches_leases_takes_and_releases(cast: Cast) -> None:
    wired = Wired(cast)
    table = wired.session.leasing.table
    wired.show.set_leases(True)
    wired.show.lease("one", "face")
    wired.show.lease("*", "light", take_over=True)
    assert [*table.held] == ["one/face", "*/light"]
    wired.show.release_lease("one", "face")
    assert [*table.held] == ["*/light"]
    wired.show.lease("one")
    assert "one/head" in table.held
    wired.show.release_lease("*")
    assert table.held == {}
    wired.show.set_leases(False)
    assert not table.on


def test_a_part_that_there_is_not_is_refused_with_what_is_near(cast: Cast) -> None:
    with pytest.raises(ValueError, match="there is no part 'fase'"):
        Wired(cast).show.lease("one", "fase")  # type: ignore[arg-type]


@pytest.mark.asyncio
async def test_what_another_holds_raises_its_name_and_the_program_knows_who_holds_what(
    show_harness: ShowHarness,
) -> None:
    url = str(show_harness.client.make_url("/"))
    async with (
        ticking(show_harness),
        await omote.connect_async(url, name="Ana") as ana,
        await omote.connect_async(url, name="robot") as robot,
    ):
        with pytest.raises(ValueError, match="leases are off"):
            await robot.lease("one", "face")
        await ana.set_leases(True)
        await ana["one"].call_face("broad", seconds=0)
        with pytest.raises(ValueError, match=r"Ana holds the face of one: take it over"):
            await robot["one"].fade_face(0.5)
        await robot.lease("one", "face", take_over=True)
        assert {key: (seat.name, seat.number == robot.leases.you) for key, seat in robot.leases.held.items()} == {
            "one/face": ("robot", True)
        }
        with pytest.raises(ValueError, match="robot holds the face of one"):
            await ana["one"].call_face("generic", seconds=0)
        assert isinstance(ana.leases, wire.Leases)
