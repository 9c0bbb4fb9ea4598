"""What a program trusts over https, and where this user's own authority lies."""

from __future__ import annotations

import contextlib
import ssl
from pathlib import Path

from omote.interchange.formats.error_reasons import explain_error
from omote.showfile.show_file import default_path


def https_folder() -> Path:
    """The folder of this user's authority."""
    return default_path().parent / "https"


def authority_path() -> Path:
    """The certificate of this user's authority, which may not be there."""
    return https_folder() / "authority.pem"


def trusted_context(authority: str | Path | None) -> ssl.SSLContext:
    """What a program trusts over https: what this machine trusts, this user's own authority where there is one, and the
    certificate that it names; OSError with a message where that cannot be read."""
    context = ssl.create_default_context()
    if authority_path().is_file():
        with contextlib.suppress(OSError):
            context.load_verify_locations(authority_path())
    try:
        if authority is not None:
            context.load_verify_locations(authority)
    except OSError as error:  # ssl.SSLError is one
        reason = "it holds none" if isinstance(error, ssl.SSLError) else explain_error(error)
        raise OSError(
            f"{authority} is no certificate to trust ({reason}); give what the show's /certificate gives (PEM)"
        ) from error
    return context
