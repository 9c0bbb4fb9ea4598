"""Which role each message of a client needs: one table for each link, checked before anything else is."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TypeVar

import msgspec

from omote.show.access.access_role import HIGHEST, AccessRole, explain_missing_role, role_allows
from omote.show.validation import Refusal

Sent = TypeVar("Sent", bound=msgspec.Struct)
RoleTable = Mapping[str, AccessRole]


def _table(**tags: str) -> RoleTable:
    """Each tag with the role that it stands under."""
    roles: dict[AccessRole, str] = {role: tags.get(role, "") for role in ("view", "operate", "edit", "admin")}
    return MappingProxyType({tag: role for role, names in roles.items() for tag in names.split()})


PLAY_MESSAGES = _table(
    view="hello ping drawing",
    operate="""
        call_face call_expression call_light fade_face release_face fade_expression release_expression set_channel
        set_head set_gaze panic set_home say stop_speaking make_gesture
        add_character remove_character rename_character place_character enter_character leave_character call_framing
        restore_character set_layout rename_layout drop_layout cancel
        source drive set_layer set_motion leave_source route_source tune_source calibrate_source measure_source
        watch_source look_at set_gaze_point delete_gaze_point
        plug unplug midi_bytes controls bind unbind learn load_preset choose_bank restore_bindings watch_devices
        switch_device
        lease release_lease
    """,
    edit="keep_face keep_expression rename_item delete_item restore_item copy_item",
    admin="set_leases appoint_manager",
)
"""The link of stages, consoles and programs, by tag. What stays in the cast needs `edit`; layouts are consoles' own."""

EDITOR_MESSAGES = _table(
    view="greet ask_history",
    edit="""
        create_expression create_face open_item close_item drag_points set_vectors set_net set_layers preview_layers
        set_pulls set_eyes flatten set_face undo redo save bring_back describe duplicate delete restore cancel
    """,
)
"""The editors' link, by tag."""


def role_needed(table: RoleTable, message: msgspec.Struct) -> AccessRole:
    """The role that a message needs; the highest for one that nobody has thought of."""
    return table.get(str(message.__struct_config__.tag), HIGHEST)


def check_message(table: RoleTable, held: AccessRole, message: Sent) -> Sent:
    """The message itself; Refusal where a role does not allow it."""
    needed = role_needed(table, message)
    if not role_allows(held, needed):
        raise Refusal(explain_missing_role(held, needed))
    return message
