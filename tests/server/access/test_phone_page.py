"""What a phone opens: the address and the port to copy, and the pictures that open it."""

import re

import pytest

from omote.server.access import phone_page
from omote.server.access.phone_page import goal_address
from omote.show.access.people_list import People
from omote.show.objects.devices import Devices, TrackerOffer
from tests.server.access.conftest import AccessHarness
from tests.server.access.test_access_guard import bearer

pytestmark = pytest.mark.asyncio
HEARD = TrackerOffer("livelink", "Live Link Face", 11112, "", "livelink:11112", False, "choose <Live Link> & type")
SILENT = TrackerOffer("vmc", "VMC", 39539, "", "", False, "in the sender")


@pytest.fixture(autouse=True)
def address(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(phone_page, "own_address", lambda: "192.168.1.20")


async def read(harness: AccessHarness, path: str, role: str = "operate") -> tuple[int, str]:
    async with harness.client.get(path, headers=bearer(harness.tokens[role])) as response:
        return response.status, await response.text()


async def test_a_phone_reads_what_to_type_of_what_is_heard(access_harness: AccessHarness) -> None:
    access_harness.show.enable_phone_page(lambda: Devices([], [HEARD, SILENT]))
    status, text = await read(access_harness, "/connect", "view")
    assert status == 200
    assert re.findall(r'value="([^"]*)"', text) == ["192.168.1.20", "11112"]
    assert "Choose &lt;Live Link&gt; &amp; type." in text
    assert "VMC" not in text
    access_harness.show.enable_phone_page(lambda: Devices([]))
    assert "No tracker is switched on" in (await read(access_harness, "/connect"))[1]


async def test_a_picture_opens_the_page_with_the_token_that_viewers_share(
    access_harness: AccessHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[str] = []

    def draw(text: str) -> bytes:
        drawn.append(text)
        return b"<svg/>"

    monkeypatch.setattr(phone_page, "draw_svg", draw)
    assert (await read(access_harness, "/connect/phone.svg"))[0] == 200
    assert re.fullmatch(rf"http://192\.168\.1\.20:\d+/connect\?token={access_harness.tokens['view']}", drawn[0])
    assert (await read(access_harness, "/connect/nothing.svg"))[0] == 404
    access_harness.show.enable_access(None)
    assert (await read(access_harness, "/connect/phone.svg"))[0] == 200
    assert drawn[1] == "192.168.1.20", "no phone may open the page: it reads the address alone"
    assert "open to its own machine alone" in (await read(access_harness, "/connect"))[1]


async def test_a_viewer_does_not_see_the_token_of_operators(access_harness: AccessHarness) -> None:
    assert (await read(access_harness, "/connect/phone.svg", "view"))[0] == 403


async def test_without_a_shared_token_the_address_is_bare() -> None:
    assert goal_address("http://a:1", "/camera", "operate", People("ab" * 32, ())) == "http://a:1/camera"
