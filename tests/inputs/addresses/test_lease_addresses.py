"""The addresses by which parts are held."""

from omote.inputs.addresses.lease_addresses import lease_addresses
from omote.show import messages as wire


def test_a_part_is_held_taken_over_and_released() -> None:
    made = [address.make("one", "id", "face") for address in lease_addresses("lease", of_show=False)]
    assert made == [
        wire.Lease("id", "one", "face"),
        wire.Lease("id", "one", "face", take_over=True),
        wire.ReleaseLease("id", "one", "face"),
    ]
    assert all(address.of_show for address in lease_addresses("scene_lease", of_show=True))
