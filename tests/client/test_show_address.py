"""Addresses of shows as people write them."""

from typing import Any

import aiohttp
import pytest

from omote.client.show_address import DENIALS, check_token, explain_https_error, link_address, token_in


@pytest.mark.parametrize(
    ("given", "link"),
    [
        ("http://127.0.0.1:8090", "http://127.0.0.1:8090/link"),
        ("http://127.0.0.1:8090/console?layout=Evening", "http://127.0.0.1:8090/link"),
        (" stage.local:8090 ", "http://stage.local:8090/link"),
        ("https://show.example/", "https://show.example/link"),
        ("http://[::1]:8090/stage", "http://[::1]:8090/link"),
    ],
)
def test_an_address_gives_that_of_its_link(given: str, link: str) -> None:
    assert link_address(given) == link


@pytest.mark.parametrize("given", ["", "ftp://stage", "http://", "http://[::1", "http://stage:99999", "http://a:b"])
def test_what_is_no_address_is_refused_with_one_that_is(given: str) -> None:
    with pytest.raises(ValueError, match=r"give one such as 'http://127\.0\.0\.1:8090"):
        link_address(given)


def test_what_is_no_text_is_refused() -> None:
    wrong: Any = 8090
    with pytest.raises(TypeError, match="the address of a show is a int"):
        link_address(wrong)


def test_a_token_is_taken_from_the_address_or_given() -> None:
    address = "http://10.0.0.7:8090/console?token=abc"
    assert link_address(address) == "http://10.0.0.7:8090/link"
    assert token_in(address) == check_token(None, address) == "abc"
    assert check_token(" def ", address) == "def"
    assert check_token(None, "10.0.0.7") == token_in("10.0.0.7") == ""


@pytest.mark.parametrize("token", ["a\r\nX-A: b", "\u00e9", "x" * 201])
def test_what_can_be_no_token_is_refused(token: str) -> None:
    with pytest.raises(ValueError, match="that no token has"):
        check_token(token, "10.0.0.7")
    wrong: Any = 7
    with pytest.raises(TypeError, match="the token is a int"):
        check_token(wrong, "10.0.0.7")


def test_where_no_https_is_spoken_the_other_address_is_named() -> None:
    error = aiohttp.ClientSSLError.__new__(aiohttp.ClientSSLError)
    assert "give http://desk:8090" in explain_https_error(error, "https://desk:8090")


def test_a_token_that_is_not_valid_says_where_one_is() -> None:
    assert "omote access" in DENIALS[401]
