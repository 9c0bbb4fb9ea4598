"""Own things come into the cast of a running show and go out of it; what is on air stays."""

import asyncio
import threading
from collections.abc import Mapping

import msgspec
import pytest

from omote.model.cast import Cast, Look
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import CastReload, gather_cast
from omote.show.cast_documents import Manifest
from omote.show.objects.stages import CastChanged
from omote.show.session import ShowSession
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression, pack_face, unpack_expression
from omote.stage_data import playing_cast
from omote.stage_data.playing_cast import Own, PlayingCast
from tests.server.synthetic_server import MASK, meshes


class Show:
    """A session with its documents and its cast reload."""

    def __init__(self, cast: Cast) -> None:
        self.contents: dict[str, bytes] = {}
        self.said: list[str] = []
        self.documents = CastDocuments(cast, meshes(cast), MASK)
        self.documents.use_workshop(None, self.said.append)
        self.documents.contents = self.contents
        self.session = ShowSession(self.documents.playing)
        self.cast_reload = CastReload(self.session, self.documents, self.said.append)

    def own(self, data: bytes, kind: str, name: str) -> Own:
        """An own thing whose bytes are there."""
        self.contents[content_key(data)] = data
        return Own(kind, name, name.title(), (), 1.0, content_key(data))  # type: ignore[arg-type]

    def recast(self, *own: Own, contents: Mapping[str, bytes] | None = None) -> CastChanged:
        """Plays these."""
        return asyncio.run(self.cast_reload.recast(own, self.contents if contents is None else contents))

    def manifest(self) -> Manifest:
        """What pages get now."""
        return msgspec.msgpack.decode(asyncio.run(self.documents.manifest()), type=Manifest)


@pytest.fixture
def show(cast: Cast) -> Show:
    """A show of the synthetic cast."""
    return Show(cast)


@pytest.fixture
def grin(show: Show, cast: Cast) -> Own:
    """An own expression."""
    return show.own(pack_expression(cast.expressions["smile"]), "expression", "grin")


@pytest.fixture
def cousin(show: Show, cast: Cast) -> Own:
    """An own face."""
    mixed = (cast.faces["broad"].positions + cast.faces["long"].positions) / 2
    return show.own(pack_face(Face("x", mixed), Look()), "face", "cousin")


def test_own_things_can_be_called_and_every_recast_is_told(show: Show, grin: Own, cousin: Own) -> None:
    first = show.recast(grin)
    assert (first.revision, first.digest) == (2, show.manifest().digest)
    second = show.recast(grin, cousin)
    assert second.revision == 3
    assert second.digest == show.manifest().digest != first.digest
    show.session.scene["one"].call_face("cousin", seconds=0.0)
    show.session.scene["one"].set_channel("grin", 0.5)
    state = show.session.tick(0.0)
    assert (state.characters["one"].faces, state.characters["one"].channels, state.revision) == (
        {"cousin": 1.0},
        {"grin": 0.5},
        3,
    )
    show.documents.close()


def test_what_is_on_air_stays_until_it_is_not(show: Show, grin: Own, cousin: Own) -> None:
    show.recast(grin, cousin)
    show.session.scene["one"].call_face("cousin", seconds=2.0)
    show.session.scene["one"].set_channel("grin", 0.5)
    show.recast()
    assert {face.name for face in show.manifest().faces} >= {"cousin"}
    assert show.session.tick(5.0).characters["one"].channels == {"grin": 0.5}
    show.session.scene["one"].set_channel("grin", 0.0)
    show.session.scene["one"].call_face("broad", seconds=0.0)
    assert show.recast().digest == show.documents.cast.digest
    with pytest.raises(ValueError, match="there is no face 'cousin'"):
        show.session.scene["one"].call_face("cousin")
    show.documents.close()


def test_what_is_called_while_documents_are_made_stays_too(show: Show, grin: Own, cousin: Own) -> None:
    show.recast(grin)
    prepare = show.documents.prepare
    calls = iter(["grin"])

    async def meanwhile(playing: PlayingCast) -> bytes:
        for name in calls:
            show.session.scene["one"].call_expression(name, seconds=1.0)
        return await prepare(playing)

    show.documents.prepare = meanwhile  # type: ignore[method-assign]
    show.recast(cousin)
    assert "grin" in show.documents.playing.expressions
    assert "cousin" in show.documents.playing.faces
    show.documents.close()


def test_a_content_that_is_gone_or_damaged_costs_itself_and_nothing_else(show: Show, grin: Own, cousin: Own) -> None:
    lost = Own("expression", "lost", "Lost", (), 1.0, "0" * 24)
    show.contents["1" * 24] = b"noise"
    damaged = Own("expression", "damaged", "Damaged", (), 1.0, "1" * 24)
    show.recast(lost, grin, damaged, cousin)
    assert [each.name for each in show.documents.playing.own] == ["grin", "cousin"]
    assert ["'Lost'" in show.said[0], "'Damaged'" in show.said[1]] == [True, True]
    show.documents.close()


def test_a_face_that_cannot_be_shown_is_kept_from_pages_and_said(show: Show, grin: Own, cast: Cast) -> None:
    bald = show.own(pack_face(cast.faces["broad"], Look(hair_style="crest")), "face", "bald")
    show.recast(grin, bald)
    assert [face.name for face in show.manifest().faces] == [*cast.faces]
    assert "'Bald' cannot be shown" in show.said[0]
    show.documents.close()


def test_the_cast_of_a_start_reports_what_it_left_out(cast: Cast) -> None:
    said: list[str] = []
    taken = Own("expression", "smile", "My smile", (), 1.0, "0" * 24)
    assert gather_cast(cast, (taken,), {}, said.append).own == ()
    assert said[0].startswith("the own expression 'My smile' cannot play")


def test_no_tick_waits_while_contents_are_unpacked(
    show: Show, grin: Own, cast: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    unpacking: list[bool] = []
    other = show.own(pack_expression(cast.expressions["jawOpen"]), "expression", "gape")

    def unpack(data: bytes) -> Expression:
        unpacking.append(threading.current_thread() is threading.main_thread())
        return unpack_expression(data)

    monkeypatch.setattr(playing_cast, "unpack_expression", unpack)
    show.recast(grin, other)
    assert unpacking == [False, False], "each once, beside the loop of the ticks"
