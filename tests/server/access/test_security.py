"""Who may speak to the server, decided from two headers."""

import socket

import pytest
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer
from hypothesis import given
from hypothesis import strategies as st

from omote.server.access.security import (
    POLICY,
    adding_headers,
    check_embedder,
    host_allowed,
    origin_allowed,
    own_names,
    refusal,
)

NAMES = frozenset({"localhost", "theatre", "theatre.local"})


@pytest.mark.parametrize(
    "host", ["localhost", "localhost:8090", "LOCALHOST", "127.0.0.1:1", "[::1]:8090", "10.0.0.7", "theatre.local:8090"]
)
def test_this_machine_is_known_by_its_names_and_by_addresses(host: str) -> None:
    assert host_allowed(host, NAMES)


@pytest.mark.parametrize(
    "host",
    ["", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "theatre.example", "0x7f.1", ":8090"],
)
def test_other_names_are_somebody_elses(host: str) -> None:
    assert not host_allowed(host, NAMES)


@pytest.mark.parametrize(
    ("origin", "host", "allowed"),
    [
        (None, "localhost:8090", True),
        ("http://localhost:8090", "localhost:8090", True),
        ("https://theatre.local", "theatre.local", True),
        ("http://LOCALHOST:8090", "localhost:8090", True),
        ("http://localhost", "localhost:8090", False),
        ("http://localhost:8091", "localhost:8090", False),
        ("http://127.0.0.1:8090", "localhost:8090", False),
        ("http://evil.example", "localhost:8090", False),
        ("http://localhost:8090@evil.example", "localhost:8090", False),
        ("chrome-extension://localhost:8090", "localhost:8090", False),
        ("null", "localhost:8090", False),
        ("", "localhost:8090", False),
    ],
)
def test_a_page_may_play_the_server_it_came_from(origin: str | None, host: str, allowed: bool) -> None:
    assert origin_allowed(origin, host) is allowed


@given(host=st.text(max_size=40), origin=st.none() | st.text(max_size=40))
def test_any_pair_of_headers_is_passed_or_refused_with_a_sentence(host: str, origin: str | None) -> None:
    reason = refusal(host, origin, NAMES)
    assert reason is None or (reason.endswith((".", ").")) and len(reason) < 250)


def test_this_machine_knows_its_names() -> None:
    assert {"localhost", socket.gethostname().lower()} <= own_names()


@pytest.mark.parametrize(
    ("typed", "origin"),
    [
        ("https://museum.example", "https://museum.example"),
        ("HTTPS://Museum.Example:443", "https://museum.example"),
        ("http://127.0.0.1:3000", "http://127.0.0.1:3000"),
        ("http://[::1]:3000", "http://[::1]:3000"),
    ],
)
def test_an_origin_is_read_as_browsers_write_it(typed: str, origin: str) -> None:
    assert check_embedder(typed) == origin == check_embedder(origin)


@pytest.mark.parametrize(
    "typed",
    [
        "", "*", "museum.example", "https://*.museum.example", "https://museum.example/", "https://a.example/page",
        "file:///page.html", "null", "https://a.example; script-src *", "https://a.example https://b.example",
        "https://me@a.example", "https://a.example:0", "https://a.example:99999", "'self'", "https://[::g]",
    ],
)  # fmt: skip
def test_what_is_no_origin_may_embed_nothing(typed: str) -> None:
    with pytest.raises(ValueError, match="museum"):
        check_embedder(typed)


@given(st.text(max_size=60))
def test_no_text_gets_a_second_rule_into_the_header(text: str) -> None:
    try:
        origin = check_embedder(text)
    except ValueError:
        return
    assert not set(origin) & set(" ;,'\"*\n")


@pytest.mark.asyncio
async def test_stages_alone_stand_in_frames_of_the_pages_that_are_named() -> None:
    application = web.Application()
    application.on_response_prepare.append(adding_headers(("https://museum.example", "http://127.0.0.1:3000")))
    for path in ("/stage", "/console", "/"):
        application.router.add_get(path, respond)
    async with TestClient(TestServer(application)) as client:
        ancestors = {}
        for path in ("/stage", "/stage?transparent", "/console", "/"):
            (_, ancestors[path]) = (await client.get(path)).headers[POLICY].split("frame-ancestors ")
    framed = "'self' https://museum.example http://127.0.0.1:3000"
    assert ancestors == {"/stage": framed, "/stage?transparent": framed, "/console": "'self'", "/": "'self'"}


@pytest.mark.asyncio
async def test_a_page_that_gets_no_frame_is_told_once() -> None:
    told: list[str] = []
    application = web.Application()
    application.on_response_prepare.append(adding_headers(("http://127.0.0.1:3000",), told.append))
    for path in ("/stage", "/console"):
        application.router.add_get(path, respond)
    framed = {"Sec-Fetch-Dest": "iframe", "Sec-Fetch-Site": "same-site"}
    async with TestClient(TestServer(application)) as client:
        for origin in (
            "http://127.0.0.1:3000",
            "http://localhost:3000",
            "http://localhost:3000",
            "about:blank",
            "x; y",
        ):
            for path in ("/stage", "/console"):
                await client.get(path, headers={**framed, "Referer": f"{origin}/page.html"})
        await client.get("/stage", headers={"Referer": "http://other.example/"})
        await client.get("/stage", headers=framed)
    assert told == [
        "a page of http://localhost:3000 shows no stage in its frame: --embed http://localhost:3000 allows it"
    ]


async def respond(_: web.Request) -> web.Response:
    return web.Response()
