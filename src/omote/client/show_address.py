"""The address of a show as people give it, and its validation."""

from __future__ import annotations

import re
from urllib.parse import SplitResult, parse_qs, urlsplit

import aiohttp

from omote.show.messages import LINK_PATH

DENIALS = {
    401: "it asks for a token, and this one is not valid: give token=, as `omote show` or `omote access` prints it",
    403: "this token does not allow it",
    429: "too many wrong tokens came from this address: wait a minute, or show a right one, which is let in at once",
}
"""What a show means that does not let a program in."""
NO_ANSWER = "it ends the connection without an answer; one that was started with --https has an address with https://"
OTHER_NAME = (62, 64)
"""What OpenSSL calls a certificate for another host, for another address (X509_V_ERR_HOSTNAME_MISMATCH)."""


def explain_https_error(error: aiohttp.ClientSSLError, show: str) -> str:
    """Why https does not come about, and what to do. show: the address. error: what the connection raised."""
    if not isinstance(error, aiohttp.ClientConnectorCertificateError):
        return f"it speaks no https; where it was started without --https, give http{show.removeprefix('https')}"
    if getattr(error.certificate_error, "verify_code", None) in OTHER_NAME:
        return "its certificate is for other names and addresses: give the address that `omote show` prints"
    return (
        f"its certificate is not trusted by this machine: save what {show}/certificate gives in a browser, and name "
        "that file with authority="
    )


EXAMPLE = "http://127.0.0.1:8090"
LONGEST_TOKEN = 200
_NAME = re.compile(r"[\w.:%-]+")
"""Letters of a host: a name in any script, or an address."""


def link_address(url: str) -> str:
    """The address of a show's link, from that which `omote show` prints, with or without a page's path.

    ValueError for what is no address of a show, TypeError for what is no text.
    """
    parts, host, port = _split(url)
    place = f"[{host}]" if ":" in host else host
    return f"{parts.scheme}://{place}{'' if port is None else f':{port}'}{LINK_PATH}"


def base_address(url: str, scheme: str = "http") -> str:
    """The address of a show (url) without any page, with this scheme where it has none; errors as `link_address`."""
    return link_address(url if "//" in url else f"{scheme}://{url.strip()}").removesuffix(LINK_PATH)


def token_in(url: str) -> str:
    """The token in an address that `omote show` prints, "" where it has none; errors as `link_address`."""
    return next(iter(parse_qs(_split(url)[0].query).get("token", [])), "")


def check_token(token: str | None, url: str) -> str:
    """The token that a program is given, else that of the address, "" for none; TypeError for what is no text,
    ValueError for what could be none. url: the address."""
    if token is not None and not isinstance(token, str):
        raise TypeError(f"the token is a {type(token).__name__}; give the text that `omote access` prints")
    secret = (token or token_in(url)).strip()
    if not secret.isascii() or not secret.isprintable() or len(secret) > LONGEST_TOKEN:
        raise ValueError("the token has letters or a length that no token has; copy what `omote access` prints")
    return secret


def _split(url: str) -> tuple[SplitResult, str, int | None]:
    if not isinstance(url, str):
        raise TypeError(f"the address of a show is a {type(url).__name__}; give text such as {EXAMPLE!r}")
    text = url.strip()
    try:
        parts = urlsplit(text if "//" in text else f"http://{text}")
        host = parts.hostname
        port = parts.port
    except ValueError as error:
        raise ValueError(f"{url[:80]!r} is no address ({error}); give one such as {EXAMPLE!r}") from error
    if parts.scheme not in ("http", "https") or not host or not _NAME.fullmatch(host):
        raise ValueError(f"{url[:80]!r} is no address of a show; give one such as {EXAMPLE!r}")
    return parts, host, port
