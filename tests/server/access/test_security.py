"""Who may speak to the server, decided from two headers."""

import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.server.access.security import host_allowed, origin_allowed, own_names, refusal

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
