"""What every source of a show can do beside its pages; each does of it what it has."""

from __future__ import annotations

from collections.abc import Callable

from omote.inputs.page_devices.device_health import SourceCounts
from omote.show.objects.state import State


class DeviceSource:
    """A source of which a tick asks everything, and which does nothing yet. Neither `hear` nor `tell` ever waits."""

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time. now: seconds, monotonic."""

    def tell(self, state: State, now: float) -> None:
        """Tells its devices what is on air. state: the newest; now: seconds, monotonic."""

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of it; nothing of what tells of itself, or is shown elsewhere."""
        return []

    async def close(self) -> None:
        """Closes what it holds."""
