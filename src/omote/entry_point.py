"""The command `omote` as it is installed: loads the command line, during which Ctrl-C ends it without a word.

Loading takes some tenths of a second, and Ctrl-C would print a traceback of whatever module was being loaded then.
"""

from __future__ import annotations

import signal


def main() -> None:
    """Runs the command `omote`."""
    heard = signal.getsignal(signal.SIGINT)
    if heard is signal.default_int_handler:  # not where a shell has a job in the background ignore it
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from omote.cli import main as run

    signal.signal(signal.SIGINT, heard)
    run()
