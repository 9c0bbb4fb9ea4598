"""A source of a show that has nothing of its own does nothing, and is told of nowhere."""

import asyncio
from typing import Any

from omote.server.devices.device_source import DeviceSource


def test_a_source_without_anything_of_its_own_is_silent() -> None:
    source = DeviceSource()
    nothing: Any = None
    source.hear(0.0)
    source.tell(nothing, 0.0)
    asyncio.run(source.close())
    assert source.probes == []
