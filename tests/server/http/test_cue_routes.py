"""Cue lists over real sockets: as data, as text, and back."""

from io import BytesIO

import msgspec
import pytest

from omote.interchange.formats.cue_toml import parse_cues
from omote.server.http.cue_routes import LONGEST_TEXT, CueRoutes
from omote.show.objects.cues import CueListDocument, Go
from omote.showfile.changes import DocumentRemoval
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio

EVENING = """
[[cue]]
number = "1"
label = "Curtain"
[cue.moves]
"*/light" = { to = "flat", seconds = 2 }

[[cue]]
number = "2.5"
note = "Kaori breathes in"
"""
ADDRESS = "/cue_lists/main"


async def test_a_list_comes_as_text_and_leaves_as_text(show_harness: ShowHarness) -> None:
    client = show_harness.client
    taken = await client.post(ADDRESS, data=EVENING)
    assert await taken.json() == {"cues": 2}
    text = await (await client.get(ADDRESS, params={"as": "toml"})).text()
    assert parse_cues(text) == parse_cues(EVENING)
    order = await client.get(ADDRESS, params={"as": "csv"})
    assert (order.content_type, len((await order.text()).splitlines())) == ("text/csv", 3)
    document = msgspec.json.decode(await (await client.get(ADDRESS)).read(), type=CueListDocument)
    assert [cue.number for cue in document.cues] == ["1", "2.5"]
    again = await client.post(ADDRESS, data=text)
    assert await again.json() == {"cues": 2}
    later = msgspec.json.decode(await (await client.get(ADDRESS)).read(), type=CueListDocument)
    assert later == document  # the same cues, and no edit


async def test_what_is_no_list_is_refused_with_its_lines_and_the_list_stays(show_harness: ShowHarness) -> None:
    client = show_harness.client
    await client.post(ADDRESS, data=EVENING)
    book = show_harness.show.session.cues.book
    for wrong, said in (
        (EVENING.replace('"flat"', "7"), r"line 6: */light goes to 7"),
        ("\xff".encode("latin-1"), "no text"),
        (BytesIO(b"#" * (LONGEST_TEXT + 1)), "no list of cues has"),
    ):
        refused = await client.post(ADDRESS, data=wrong)
        assert refused.status == 400
        assert said in await refused.text()
    assert show_harness.show.session.cues.book is book
    assert (await client.get("/cue_lists/none")).status == 204
    assert (await client.get(ADDRESS, params={"as": "pdf"})).status == 400


async def test_an_edit_is_for_the_show_file_once_and_another_server_plays_on_from_it(show_harness: ShowHarness) -> None:
    session = show_harness.show.session
    routes = CueRoutes(session)
    await show_harness.client.post(ADDRESS, data=EVENING)
    session.join("osc", "OSC")
    assert session.receive("osc", Go("g1"), 1.0) == []
    stored: dict[str, dict[str, bytes]] = {}
    for change in session.cues.take_changes():
        assert not isinstance(change, DocumentRemoval)
        stored.setdefault(change.kind, {})[change.name] = change.body
    assert session.cues.take_changes() == []
    book = session.cues.book
    stored["cue"]["broken"] = b"{"
    said: list[str] = []
    routes.load(lambda kind: stored.get(kind, {}), said.append)
    assert (session.cues.book, len(said)) == (book, 1)
