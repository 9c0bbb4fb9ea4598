"""Where a show says that it can be reached."""

import ipaddress

import pytest

from omote.server.access.people_file import new_people
from omote.server.access.show_addresses import (
    certificate_names,
    entry_address,
    is_loopback,
    local_address,
    outside_address,
    own_address,
    own_entries,
    own_network,
    reachable_addresses,
    split_url,
    url,
)


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("127.0.0.1", "http://127.0.0.1:8090"),
        ("0.0.0.0", "http://127.0.0.1:8090"),
        ("::", "http://127.0.0.1:8090"),
        ("::1", "http://[::1]:8090"),
        ("stage.local", "http://stage.local:8090"),
    ],
)
def test_a_browser_on_this_machine_finds_the_show(host: str, expected: str) -> None:
    assert local_address(host, 8090) == expected


def test_on_loopback_there_is_one_address() -> None:
    assert reachable_addresses("127.0.0.1", 1) == ["http://127.0.0.1:1"]


@pytest.mark.parametrize("place", [("http", "0.0.0.0", 8090), ("https", "2001:db8::7", 1), ("https", "a.local", 65535)])
def test_an_address_is_taken_apart_again(place: tuple[str, str, int]) -> None:
    scheme, host, port = place
    assert split_url(url(host, port, scheme)) == place


@pytest.mark.parametrize("text", ["", "http://[::1", "http://a:b", "http://a", "ftp://a:1", "notes"])
def test_what_is_no_address_has_no_host(text: str) -> None:
    assert split_url(text) == ("http", "", 0)


def test_for_the_network_there_is_the_outer_address_too() -> None:
    outer = own_address()
    expected = ["http://127.0.0.1:1"] if outer is None else ["http://127.0.0.1:1", url(outer, 1)]
    assert reachable_addresses("0.0.0.0", 1) == expected


@pytest.mark.parametrize(("address", "network"), [("192.0.2.2", "192.0.2.0/24"), (None, "192.168.1.0/24")])
def test_the_network_that_is_offered_holds_the_own_address(
    monkeypatch: pytest.MonkeyPatch, address: str | None, network: str
) -> None:
    monkeypatch.setattr("omote.server.access.show_addresses.own_address", lambda: address)
    assert own_network() == network


def test_the_outer_address_is_one_that_others_can_use() -> None:
    outer = own_address()
    assert outer is None or not ipaddress.ip_address(outer).is_loopback


@pytest.mark.parametrize(
    ("host", "loopback"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("LOCALHOST", True),
        ("0.0.0.0", False),
        ("::", False),
        ("192.168.1.7", False),
        ("theatre.local", False),
        ("", False),
    ],
)
def test_what_only_this_machine_reaches_is_known(host: str, loopback: bool) -> None:
    assert is_loopback(host) is loopback


def test_who_enters_comes_by_an_address_of_the_network() -> None:
    outer = own_address()
    assert entry_address("http://10.0.0.7:1", "view", "abc") == "http://10.0.0.7:1/stage?token=abc"
    place = "https://127.0.0.1:1" if outer is None else url(outer, 1, "https")
    assert entry_address("https://127.0.0.1:1", "edit", "abc") == f"{place}/editor?token=abc"


def test_who_has_started_the_show_needs_a_token_only_where_it_asks_for_one() -> None:
    assert own_entries("http://127.0.0.1:1", None) == ["http://127.0.0.1:1/stage", "http://127.0.0.1:1/console"]
    assert all("?token=" in each for each in own_entries("http://127.0.0.1:1", new_people(0.0)))


def test_a_certificate_has_the_names_of_this_machine_once_each() -> None:
    names = certificate_names("192.168.1.7")
    assert {"localhost", "127.0.0.1", "::1", "192.168.1.7"} <= set(names)
    assert len(names) == len(set(names))
    assert "0.0.0.0" not in certificate_names("0.0.0.0")


def test_other_machines_reach_what_listens_off_loopback() -> None:
    outer = own_address()
    assert outside_address("0.0.0.0", 8095, "https") == ("" if outer is None else url(outer, 8095, "https"))
    assert outside_address("192.168.1.7", 8095) == "http://192.168.1.7:8095"
    for host in ("127.0.0.1", "::1", "localhost"):
        assert outside_address(host, 8095) == ""
