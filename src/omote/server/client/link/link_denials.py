"""Why a show lets no program in, in words, and what to do."""

from __future__ import annotations

import aiohttp

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
    """Why https does not come about, and what to do. show: the address."""
    if not isinstance(error, aiohttp.ClientConnectorCertificateError):
        return f"it speaks no https; where it was started without --https, give http{show.removeprefix('https')}"
    if getattr(error.certificate_error, "verify_code", None) in OTHER_NAME:
        return "its certificate is for other names and addresses: give the address that `omote show` prints"
    return (
        f"its certificate is not trusted by this machine: save what {show}/certificate gives in a browser, and name "
        "that file with authority="
    )
