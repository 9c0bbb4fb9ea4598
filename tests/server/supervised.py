"""A supervisor that plays the synthetic cast from the show file named by its argument."""

import json
import os
import sys
from pathlib import Path

from omote.server.access.access_setup import AccessOptions
from omote.server.persistence.lock import lock_show
from omote.server.process.terminal_relay import relay_terminal
from omote.server.supervision import supervisor
from omote.server.supervision.listening_socket import listen_on
from omote.server.supervision.supervisor import Supervisor

# A busy machine is no hanging server; one test says what is.
supervisor.HANG_SECONDS = float(os.environ.get("SYNTHETIC_HANG", "60"))
supervisor.START_SECONDS = 60.0
PROGRAM = (sys.executable, "-m", "tests.server.synthetic_server")


def say(sentence: str) -> None:
    """Tells the test."""
    sys.stdout.write(sentence + "\n")
    sys.stdout.flush()


def main(path: Path) -> int:
    """Plays until a signal comes."""
    listening = listen_on("127.0.0.1", 0)
    port = listening.getsockname()[1]
    supervisor = Supervisor(
        listening,
        lock_show(path),
        path,
        report=say,
        opened=lambda: say(f"http://127.0.0.1:{port}"),
        program=(*PROGRAM, *AccessOptions(**json.loads(os.environ.get("SYNTHETIC_ACCESS", "{}"))).words),
    )
    with relay_terminal():
        return supervisor.run()


if __name__ == "__main__":
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    sys.exit(main(Path(sys.argv[1])))
