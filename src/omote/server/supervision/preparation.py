"""What `omote show` does before anything plays: locks the show file, listens, and opens or makes the file once."""

from __future__ import annotations

import socket
from collections.abc import Callable
from pathlib import Path

from omote.server.http.static_pages import read_pages
from omote.server.persistence.lock import lock_show, release_lock
from omote.server.persistence.restore import open_newest
from omote.server.supervision.listening_socket import listen_on

Report = Callable[[str], None]
Prepared = tuple[int, socket.socket]
"""The lock of a show file, and the listening socket."""


def prepare_show(path: Path, host: str, port: int, *, tell: Report, report: Report) -> Prepared:
    """The lock of a show file and the listening socket; where one of them cannot be, nothing is left behind.

    tell: gets which file was opened or made; report: what was wrong with it. OSError, ShowFileError, ShowLockedError.
    path: of the show file; host, port: where to listen.
    """
    read_pages()
    lock = lock_show(path)
    try:
        listening = listen_on(host, port)  # before the file is made: a refused port leaves none
        try:
            tell(open_or_make(path, report))
        except BaseException:
            listening.close()
            raise
    except BaseException:
        release_lock(path, lock)
        raise
    return lock, listening


def open_or_make(path: Path, report: Report) -> str:
    """Opens a show file, or makes it, so that what is wrong with it is known at once; says which of the two.

    path: of the file; report: told what was wrong with it.
    """
    new = not path.exists() or path.stat().st_size == 0
    show = open_newest(path, report)
    try:
        own = sum(not item.deleted for item in show.stored().items)
        begun = new and show.journal().snapshot is None and not own
    finally:
        show.close()
    works = f"{own} own {'face or expression' if own == 1 else 'faces and expressions'}"
    return f"a new show begins in {path}" if begun else f"the show of {path} goes on; it holds {works}"
