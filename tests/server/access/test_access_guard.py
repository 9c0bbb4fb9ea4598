"""The permission matrix of addresses, and forty handshakes of people who should stay outside."""

import asyncio
import html
import re
from collections.abc import Mapping

import aiohttp
import pytest
from aiohttp.test_utils import TestClient, TestServer

from omote.edit.protocol import messages as editing
from omote.edit.protocol import wire as edit_wire
from omote.edit.protocol.messages import EDITING_PATH
from omote.inputs.microphone.microphone_messages import MICROPHONE_PATH
from omote.inputs.performers.camera_messages import CAMERA_PATH
from omote.inputs.performers.performer_list import PerformerList
from omote.inputs.trackers.tracker_protocols import MEDIAPIPE_PATH
from omote.server.access.people_file import change_people, new_person
from omote.server.access.security import own_names
from omote.server.camera.camera_link import CameraLinks
from omote.server.devices.mediapipe_link import MediapipeLink
from omote.server.devices.rejection_log import RejectionLog
from omote.server.links.links import REVOKED
from omote.server.microphone.microphone_link import MicrophoneLink
from omote.show.access.access_documents import REVOKED_CODE
from omote.show.access.access_role import ACCESS_ROLES, role_allows
from omote.show.access.people_list import People, add_person, cookie_name, remove_person, token_of
from omote.show.access.route_roles import ROUTES
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.documents import READ_ROUTES
from omote.show.objects.link import Hello, Refused, Welcome
from omote.show.wire import decode_answer, encode
from tests.server.access.conftest import AccessHarness
from tests.server.conftest import answer, send_and_wait

pytestmark = pytest.mark.asyncio

DENIED = (401, 403, 429)
CREDENTIALS = ("none", *ACCESS_ROLES, "revoked", "expired", "garbage")
PAGE = {"Accept": "text/html"}
Rejection = editing.EditRefused


def bearer(token: str | None) -> dict[str, str]:
    return {} if token is None else {"Authorization": f"Bearer {token}"}


ROWS = {**ROUTES, **{("GET", route): role for route, role in READ_ROUTES.items()}}


async def test_the_router_has_those_addresses_alone_that_have_a_row(access_harness: AccessHarness) -> None:
    router = access_harness.show.application(own_names()).router
    found = {(each.method, each.resource.canonical) for each in router.routes() if each.resource is not None}
    assert {key for key in found if key[0] != "HEAD"} - set(ROWS) == set()
    assert {("GET", route) for method, route in found if method == "HEAD"} <= set(ROWS)


@pytest.mark.parametrize("credential", CREDENTIALS)
async def test_every_address_is_answered_to_those_alone_whose_role_allows_it(
    access_harness: AccessHarness, credential: str
) -> None:
    role = access_harness.may(credential)
    headers = bearer(access_harness.tokens.get(credential))
    unknown = [("GET", "/no/such/page"), ("PUT", "/manifest"), ("HEAD", "/manifest"), ("OPTIONS", "/people")]
    for method, route in [*ROWS, *unknown]:
        path = route.replace("{file}", "a.json").replace("{", "").replace("}", "")
        needed = ROWS.get((method, route)) or "view"
        async with access_harness.client.request(method, path, headers=headers) as response:
            let_in = response.status not in DENIED
        assert let_in == (role is not None and role_allows(role, needed)), (method, route)
    assert access_harness.control.find_person("id") is None


async def test_without_a_list_everybody_may_do_all(access_harness: AccessHarness) -> None:
    access_harness.show.enable_access(None)
    async with access_harness.client.get("/manifest") as response:
        assert response.status == 200
    async with access_harness.client.get("/people") as response:
        assert (response.status, "asks nobody" in await response.text()) == (404, True)


@pytest.mark.parametrize("page", ["/", "/stage?character=two", "/console", "/editor"])
async def test_a_token_leaves_the_address_bar_for_a_cookie(access_harness: AccessHarness, page: str) -> None:
    token = access_harness.tokens["operate"]
    joint = "&" if "?" in page else "?"
    async with access_harness.client.get(f"{page}{joint}token={token}", headers=PAGE) as response:
        text = await response.text()
        cookie = response.headers["Set-Cookie"]
    assert token not in text
    assert f'content="0;url={page}"' in text
    assert cookie.startswith(f"{access_harness.control.cookie}={token}; ")
    assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(cookie.split("; "))
    assert "Secure" not in cookie  # this is http
    if page != "/editor":  # which the synthetic show has not
        async with access_harness.client.get(page, headers=PAGE) as response:
            assert (response.status, await response.text()) == (200, f"page {page.partition('?')[0]}")


@pytest.mark.parametrize("credential", ["none", "revoked", "expired", "garbage"])
async def test_who_may_not_enter_sees_a_page_that_asks_for_a_token(
    access_harness: AccessHarness, credential: str
) -> None:
    async with access_harness.client.get(
        "/console", headers=PAGE | bearer(access_harness.tokens.get(credential))
    ) as response:
        text = await response.text()
        assert response.status == 401
        assert "Set-Cookie" not in response.headers
        assert "form-action 'self'" in response.headers["Content-Security-Policy"]
    assert 'name="token"' in text
    assert "whoever runs the show" in text.lower()


@pytest.mark.parametrize("form", ["{}", " {}\n", "http://10.0.0.7:8090/console?token={}", "HTTP://a/?token={}&x=1#y"])
async def test_a_whole_address_is_as_good_as_its_token(access_harness: AccessHarness, form: str) -> None:
    pasted = {"token": form.format(access_harness.tokens["operate"]), "tile": "0,0"}
    async with access_harness.client.get("/stage", params=pasted, headers=PAGE) as response:
        assert response.status == 200
        assert 'content="0;url=/stage?tile=0,0"' in await response.text()
        assert f"={access_harness.tokens['operate']}; " in response.headers["Set-Cookie"]


@pytest.mark.parametrize(
    ("credential", "said"),
    [("garbage", "no token of this show"), ("revoked", "was revoked"), ("expired", "has ended")],
)
async def test_a_token_that_is_not_taken_leaves_the_address_bar(
    access_harness: AccessHarness, credential: str, said: str
) -> None:
    pasted = {"token": access_harness.tokens[credential], "tile": "0,0"}
    async with access_harness.client.get("/stage", params=pasted, headers=PAGE) as response:
        text = await response.text()
        assert (response.status, "Set-Cookie" in response.headers) == (401, False)
    assert pasted["token"] not in text
    (goal,) = re.findall('content="0;url=([^"]+)"', text)
    async with access_harness.client.get(html.unescape(goal), headers=PAGE) as response:
        text = await response.text()
        assert (response.status, said in text, 'name="tile" value="0,0"' in text) == (401, True, True)
    assert 'name="denied"' not in text
    good = {"token": access_harness.tokens["view"], "denied": "wrong"}
    async with access_harness.client.get("/stage", params=good, headers=PAGE) as response:
        assert 'content="0;url=/stage"' in await response.text()


async def test_a_link_hears_what_its_role_may_not(access_harness: AccessHarness) -> None:
    link = await access_harness.client.ws_connect(LINK_PATH, headers=bearer(access_harness.tokens["view"]))
    await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
    assert isinstance(await answer(link), Welcome)
    await link.send_bytes(encode(Panic("one")))
    refused = await answer(link)
    assert isinstance(refused, Refused)
    assert '"operate"' in refused.reason
    editor = await access_harness.client.ws_connect(editing.EDITING_PATH, headers=bearer(access_harness.tokens["view"]))
    await editor.send_bytes(encode(editing.Greet("e1", "Ada", editing.EDITING_VERSION)))
    await editor.send_bytes(encode(editing.CreateFace(7, "Mine", {}, False)))
    while not isinstance(message := edit_wire.decode_answer(await editor.receive_bytes(timeout=60.0)), Rejection):
        pass
    assert message.request == 7
    assert '"edit"' in message.reason


async def test_a_page_is_called_as_its_token(access_harness: AccessHarness) -> None:
    ann = new_person("Ann", "operate", 0.0)
    control = access_harness.control
    control.people = add_person(control.people, ann)
    for token, name in ((access_harness.tokens["operate"], "console 1"), (token_of(control.people, ann), "Ann")):
        link = await access_harness.client.ws_connect(LINK_PATH, headers=bearer(token))
        await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION, "ann")))
        welcome = await answer(link)
        assert isinstance(welcome, Welcome)
        assert welcome.name == name


async def test_links_end_with_their_token(access_harness: AccessHarness) -> None:
    tokens = access_harness.tokens
    client = access_harness.client
    gone = await client.ws_connect(LINK_PATH, headers=bearer(tokens["operate"]))
    editor = await client.ws_connect(editing.EDITING_PATH, headers=bearer(tokens["operate"]))
    stays = await client.ws_connect(LINK_PATH, headers=bearer(tokens["edit"]))
    person = next(each for each in access_harness.control.people.people if each.role == "operate")
    async with client.delete(f"/people/{person.id}", headers=bearer(tokens["admin"])) as response:
        assert response.status == 200
    refused = decode_answer(await gone.receive_bytes(timeout=60.0))
    assert refused == Refused(REVOKED)
    closed = await gone.receive(timeout=60.0)
    assert (closed.type, closed.data, closed.extra) == (aiohttp.WSMsgType.CLOSE, REVOKED_CODE, REVOKED)
    await editor.receive_bytes(timeout=60.0)
    assert (await editor.receive(timeout=60.0)).data == REVOKED_CODE
    await stays.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
    await send_and_wait_welcomed(stays)
    with pytest.raises(aiohttp.WSServerHandshakeError) as denied:
        await client.ws_connect(LINK_PATH, headers=bearer(tokens["operate"]))
    assert denied.value.status == 401


async def send_and_wait_welcomed(link: aiohttp.ClientWebSocketResponse) -> None:
    assert isinstance(await answer(link), Welcome)
    await send_and_wait(link)


async def test_a_console_without_a_name_carries_that_of_its_token(access_harness: AccessHarness) -> None:
    ada = new_person("Ada", "operate", 0.0)
    access_harness.control.people = add_person(access_harness.control.people, ada)
    token = token_of(access_harness.control.people, ada)
    link = await access_harness.client.ws_connect(LINK_PATH, headers=bearer(token))
    await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
    welcome = await answer(link)
    assert isinstance(welcome, Welcome)
    assert welcome.name == "Ada"


async def test_guessing_is_slow_but_for_others(access_harness: AccessHarness) -> None:
    statuses = []
    for number in range(12):
        async with access_harness.client.get("/manifest", headers=bearer(f"guess-{number}")) as response:
            statuses.append(response.status)
            waits = response.headers.get("Retry-After")
    assert statuses[:10] == [401] * 10
    assert statuses[10:] == [429] * 2
    assert waits == "2"
    async with access_harness.client.get("/manifest", headers=bearer(access_harness.tokens["view"])) as response:
        assert response.status == 200


@pytest.mark.parametrize("allowed", [True, False])
async def test_who_may_play_by_osc_may_read_its_addresses_and_nothing_else(
    access_harness: AccessHarness, allowed: bool
) -> None:
    access_harness.show.enable_oscquery(9000, lambda host: allowed and host == "127.0.0.1")
    async with TestClient(TestServer(access_harness.show.application(own_names()))) as surface:
        for path in ("/?HOST_INFO", "/omote", "/omote/panic"):
            async with surface.get(path) as response:
                assert response.status == (200 if allowed else 401)
        for path, headers in (("/manifest", {}), ("/link", {}), ("/", PAGE), ("/console", {})):
            async with surface.get(path, headers=headers) as response:
                assert response.status == 401


# --- forty handshakes -------------------------------------------------------------------------------------------------


def handshakes(tokens: Mapping[str, str], cookie: str, other: str) -> dict[str, tuple[str, str]]:
    """What strangers send, each as the line of the request and headers of their own; HOST, ORIGIN and UPGRADE are put
    in unless they are there."""
    good = tokens["admin"]
    own = "Origin: http://127.0.0.1:8090"
    link = "GET /link HTTP/1.1"
    carried = f"Cookie: {cookie}={good}"
    return {
        "nothing": (link, ""),
        "nothing, from our page": (link, own),
        "another's page with our cookie": (link, f"{carried}\r\nOrigin: http://evil.example"),
        "another's port with our cookie": (link, f"{carried}\r\nOrigin: http://127.0.0.1:9999"),
        "a sandboxed page with our cookie": (link, f"{carried}\r\nOrigin: null"),
        "a file with our cookie": (link, f"{carried}\r\nOrigin: file://"),
        "an origin that begins as ours": (link, f"{carried}\r\nOrigin: http://127.0.0.1:8090.evil.example"),
        "an origin with our name before an at": (link, f"{carried}\r\nOrigin: http://127.0.0.1:8090@evil.example"),
        "our cookie without an origin": (link, carried),
        "an empty origin": (link, f"{carried}\r\nOrigin: "),
        "another's page with a token": (f"GET /link?token={good} HTTP/1.1", "Origin: http://evil.example"),
        "a foreign host": (link, f"Host: evil.example\r\nOrigin: http://evil.example\r\n{carried}"),
        "a foreign host with a token": (f"GET /link?token={good} HTTP/1.1", "Host: evil.example"),
        "an empty host": (link, f"Host: \r\n{carried}\r\n{own}"),
        "two hosts": (link, f"Host: 127.0.0.1:8090\r\nHost: evil.example\r\nOrigin: http://evil.example\r\n{carried}"),
        "a cookie of another show": (link, f"Cookie: {other}={good}\r\n{own}"),
        "a cookie without a name": (link, f"Cookie: {good}\r\n{own}"),
        "a forged cookie": (link, f"Cookie: {cookie}={good[:-1]}!\r\n{own}"),
        "an empty cookie": (link, f"Cookie: {cookie}=\r\n{own}"),
        "two cookies, the first ours": (link, f"Cookie: {cookie}={good}; {cookie}=x\r\n{own}"),
        "two cookies, the second ours": (link, f"Cookie: {cookie}=x; {cookie}={good}\r\n{own}"),
        "two cookie headers": (link, f"Cookie: {cookie}=x\r\nCookie: {cookie}={good}\r\n{own}"),
        "a cookie in capitals": (link, f"Cookie: {cookie.upper()}={good}\r\n{own}"),
        "a huge cookie": (link, f"Cookie: {cookie}={'x' * 6000}\r\n{own}"),
        "a header that is too long": (link, f"Cookie: {cookie}={'x' * 20000}\r\n{own}"),
        "a cookie with a NUL": (link, f"Cookie: {cookie}={good}\0\r\n{own}"),
        "a cookie of other letters": (link, f"Cookie: {cookie}={'é' * 30}\r\n{own}"),
        "full-width letters": (link, f"Cookie: {cookie}={chr(0xFF41) * 30}\r\n{own}"),
        "a revoked token": (link, f"Authorization: Bearer {tokens['revoked']}"),
        "an expired token": (link, f"Authorization: Bearer {tokens['expired']}"),
        "another scheme": (link, f"Authorization: Basic {good}"),
        "no scheme": (link, f"Authorization: {good}"),
        "a wrong header hides no right cookie": (link, f"Authorization: Bearer x\r\n{carried}\r\n{own}"),
        "two headers": (link, f"Authorization: Bearer x\r\nAuthorization: Bearer {good}"),
        "a header folded": (link, f"Authorization: Bearer\r\n {good}"),
        "a space before the colon": (link, f"Authorization : Bearer {good}"),
        "a bare line feed": (link, f"X-A: b\nAuthorization: Bearer {good}"),
        "a token with a NUL in the query": (f"GET /link?token={good}%00 HTTP/1.1", ""),
        "two tokens in the query": (f"GET /link?token=x&token={good} HTTP/1.1", ""),
        "a token in the path": (f"GET /link/{good} HTTP/1.1", ""),
        "a token in the fragment": (f"GET /link#token={good} HTTP/1.1", ""),
        "a token under another name": (f"GET /link?Token={good} HTTP/1.1", ""),
        "a token in a list": (f"GET /link?token[]={good} HTTP/1.1", ""),
        "a token twice encoded": (f"GET /link?token={''.join(f'%25{ord(c):02x}' for c in good)} HTTP/1.1", ""),
        "a role": ("GET /link?role=admin HTTP/1.1", "X-Role: admin"),
        "one who says that he is here": (link, "X-Forwarded-For: 127.0.0.1\r\nForwarded: for=127.0.0.1"),
        "one who says who he is": (link, "X-Forwarded-User: admin\r\nRemote-User: admin"),
        "an absolute address": ("GET http://evil.example/link HTTP/1.1", f"{carried}\r\nOrigin: http://evil.example"),
        "another method": ("POST /link HTTP/1.1", f"{carried}"),
        "a second request in the first": (link, f"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n{carried}"),
    }


async def test_of_forty_strangers_none_comes_in(access_harness: AccessHarness) -> None:
    server = access_harness.client.server
    tried = handshakes(access_harness.tokens, access_harness.control.cookie, cookie_name(People("00" * 32)))
    assert len(tried) >= 40
    came_in = {}
    for name, (line, headers) in tried.items():
        access_harness.clock.now += 60.0  # nobody is kept out by having guessed before
        status = await shake(server.host or "", server.port or 0, line, headers)
        came_in[name] = status
    assert {name: status for name, status in came_in.items() if status is None or not 400 <= status < 500} == {}
    assert len(access_harness.show.links) == 0
    good = (f"Authorization: Bearer {access_harness.tokens['admin']}", f"Cookie: {access_harness.control.cookie}=")
    assert await shake(server.host or "", server.port or 0, "GET /link HTTP/1.1", good[0]) == 101
    own = f"{good[1]}{access_harness.tokens['view']}\r\nOrigin: http://127.0.0.1:8090"
    assert await shake(server.host or "", server.port or 0, "GET /link HTTP/1.1", own) == 101


async def shake(host: str, port: int, line: str, headers: str) -> int | None:
    """The status that a handshake is answered with; None where the server says nothing."""
    lines = [line, *([] if "Host:" in headers else ["Host: 127.0.0.1:8090"]), *([headers] if headers else [])]
    upgrade = ["Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: " + KEY]
    reader, writer = await asyncio.open_connection(host, port)
    try:
        writer.write("\r\n".join((*lines, *upgrade, "", "")).encode())
        first = await reader.readline()
    finally:
        writer.close()
    return int(first.split()[1]) if first else None


KEY = "dGhlIHNhbXBsZSBub25jZQ=="


async def test_a_token_is_revoked_by_another_program_while_the_show_runs(access_harness: AccessHarness) -> None:
    link = await access_harness.client.ws_connect(LINK_PATH, headers=bearer(access_harness.tokens["view"]))
    change_people(access_harness.control.path, lambda people: remove_person(people, "view")[0])
    access_harness.show.broadcast_crew()
    assert decode_answer(await link.receive_bytes(timeout=60.0)) == Refused(REVOKED)
    while (last := await link.receive(timeout=60.0)).type is aiohttp.WSMsgType.BINARY:
        pass
    assert last.data == REVOKED_CODE


async def test_links_of_every_kind_end_with_their_token(access_harness: AccessHarness) -> None:
    show = access_harness.show
    log = RejectionLog(access_harness.said.append)
    mediapipe = MediapipeLink(lambda: show.session, log)
    mediapipe.on = True
    microphones = MicrophoneLink(lambda: show.session)
    cameras = CameraLinks(lambda: show.session, PerformerList({}, lambda *_: None), log)
    senders: dict[str, MediapipeLink | MicrophoneLink | CameraLinks] = {
        MEDIAPIPE_PATH: mediapipe,
        MICROPHONE_PATH: microphones,
        CAMERA_PATH: cameras,
    }
    for path, sender in senders.items():
        show.enable_sender(path, sender.respond, sender.links)
    async with TestClient(TestServer(show.application(own_names()))) as client:
        paths = [LINK_PATH, EDITING_PATH, *senders]
        sockets = [await client.ws_connect(path, headers=bearer(access_harness.tokens["edit"])) for path in paths]
        change_people(access_harness.control.path, lambda people: remove_person(people, "edit")[0])
        show.broadcast_crew()
        for socket in sockets:
            while (last := await socket.receive(timeout=60.0)).type is not aiohttp.WSMsgType.CLOSE:
                pass
            assert last.data == REVOKED_CODE
