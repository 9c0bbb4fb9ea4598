"""An admin lists, makes and revokes tokens; every page may ask who it is."""

import msgspec
import pytest

from omote.server.access.people_file import read_people
from omote.show.access.access_documents import AccessDocument, CodeDocument, NewPerson, PeopleDocument
from omote.show.access.people_list import find_person
from omote.show.wire import encode
from tests.server.access.conftest import AccessHarness
from tests.server.access.test_access_guard import bearer

pytestmark = pytest.mark.asyncio


async def test_a_page_learns_who_it_is(access_harness: AccessHarness) -> None:
    async with access_harness.client.get("/access", headers=bearer(access_harness.tokens["edit"])) as response:
        assert msgspec.msgpack.decode(await response.read(), type=AccessDocument) == AccessDocument("edit", "", True)
    access_harness.show.enable_access(None)
    async with access_harness.client.get("/access") as response:
        assert msgspec.msgpack.decode(await response.read(), type=AccessDocument) == AccessDocument("admin", "", False)


async def test_an_admin_makes_a_token_shows_it_again_and_revokes_it(access_harness: AccessHarness) -> None:
    client = access_harness.client
    headers = bearer(access_harness.tokens["admin"])
    async with client.post("/people", data=encode(NewPerson("Ada", "operate", 8.0)), headers=headers) as response:
        made = msgspec.msgpack.decode(await response.read(), type=CodeDocument)
    address, _, token = made.address.partition("/console?token=")
    assert address.startswith("http://")
    assert made.picture.startswith("data:image/svg+xml")
    person = find_person(access_harness.control.people, token, 1000.0)
    assert person is not None
    assert (person.name, person.role) == ("Ada", "operate")
    assert person in read_people(access_harness.control.path).people
    async with client.get(f"/people/{person.id}/code", headers=headers) as response:
        assert msgspec.msgpack.decode(await response.read(), type=CodeDocument) == made
    async with client.get("/people", headers=headers) as response:
        listed = msgspec.msgpack.decode(await response.read(), type=PeopleDocument).people
    assert [each.own for each in listed] == [each.name == "admin" for each in listed]
    assert listed[-1].name == "Ada"
    async with client.delete(f"/people/{person.id}", headers=headers) as response:
        assert person.id not in {
            each.id for each in msgspec.msgpack.decode(await response.read(), type=PeopleDocument).people
        }
    async with client.get(f"/people/{person.id}/code", headers=headers) as response:
        assert response.status == 404
    assert find_person(access_harness.control.people, token, 1000.0) is None


@pytest.mark.parametrize(
    ("wish", "status"),
    [
        (b"", 400),
        (encode(NewPerson("", "view", None)), 400),
        (encode(NewPerson("Ada", "view", -1.0)), 400),
        (encode(NewPerson("view", "view", None)), 409),
    ],
)
async def test_a_wish_that_cannot_be_is_rejected_in_words(
    access_harness: AccessHarness, wish: bytes, status: int
) -> None:
    before = access_harness.control.people
    headers = bearer(access_harness.tokens["admin"])
    async with access_harness.client.post("/people", data=wish, headers=headers) as response:
        assert response.status == status
        assert (await response.text()).endswith(".")
    assert access_harness.control.people == before


async def test_the_last_admin_stays(access_harness: AccessHarness) -> None:
    (admin,) = [each for each in access_harness.control.people.people if each.name == "admin"]
    headers = bearer(access_harness.tokens["admin"])
    async with access_harness.client.delete(f"/people/{admin.id}", headers=headers) as response:
        assert (response.status, "the last who may" in await response.text()) == (409, True)


async def test_a_tablet_gets_the_certificate_of_the_authority(access_harness: AccessHarness) -> None:
    headers = bearer(access_harness.tokens["view"])
    async with access_harness.client.get("/certificate", headers=headers) as response:
        assert (response.content_type, await response.read()) == ("application/x-x509-ca-cert", b"PEM")
    access_harness.show.enable_access(access_harness.control)
    async with access_harness.client.get("/certificate", headers=headers) as response:
        assert response.status == 404
