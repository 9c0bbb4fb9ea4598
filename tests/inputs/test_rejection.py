"""One kind of error for all that devices send."""

import pytest

from omote.inputs.dmx.artnet_packet import ArtNetError
from omote.inputs.dmx.sacn_packet import SacnError
from omote.inputs.osc_packet import OscError
from omote.inputs.rejection import PacketError


@pytest.mark.parametrize("kind", [OscError, SacnError, ArtNetError])
def test_every_protocol_rejects_by_the_same_error(kind: type[PacketError]) -> None:
    with pytest.raises(PacketError, match="why"):
        raise kind("why")
