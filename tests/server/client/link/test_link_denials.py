"""Why a show lets nobody in, in words that say what to do."""

import aiohttp

from omote.server.client.link.link_denials import DENIALS, explain_https_error


def test_where_no_https_is_spoken_the_other_address_is_named() -> None:
    error = aiohttp.ClientSSLError.__new__(aiohttp.ClientSSLError)
    assert "give http://desk:8090" in explain_https_error(error, "https://desk:8090")


def test_a_token_that_is_not_valid_says_where_one_is() -> None:
    assert "omote access" in DENIALS[401]
