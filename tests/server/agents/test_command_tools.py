"""Commands as tools: none that a role may not use, and each with a schema of exactly its arguments."""

import jsonschema
import pytest
from msgspec import structs

from omote.server.agents.command_tools import command_tools
from omote.show.access.access_role import ACCESS_ROLES, AccessRole, role_allows
from omote.show.declaration import tag_of
from omote.show.messages import CLIENT_MESSAGES


@pytest.mark.parametrize("role", ACCESS_ROLES)
def test_a_role_has_the_commands_that_the_show_takes_from_it(role: AccessRole) -> None:
    tools = command_tools(role)
    allowed = {tag_of(kind) for kind in CLIENT_MESSAGES if kind.method is not None and role_allows(role, kind.access)}
    assert tools.keys() == allowed - {"say"}
    assert all(tool.description for tool in tools.values())


def test_schemas_are_valid_and_name_the_fields_that_a_program_gives() -> None:
    for tool in command_tools("admin").values():
        jsonschema.Draft202012Validator.check_schema(dict(tool.schema))
        fields = {field.name for field in structs.fields(tool.command)} - {"id"}
        assert tool.schema["properties"].keys() == fields
        assert set(tool.schema["required"]) == {
            field.name for field in structs.fields(tool.command) if field.required and field.name != "id"
        }


def test_a_schema_says_ranges_units_and_whose_names_are_meant() -> None:
    tools = command_tools("operate")
    assert "kind face" in tools["call_face"].schema["properties"]["name"]["description"]
    assert tools["set_head"].schema["properties"]["yaw"]["description"] == "Radians."
    seconds = tools["call_light"].schema["properties"]["seconds"]
    assert (seconds["minimum"], seconds["maximum"], seconds["description"]) == (0.0, 3600.0, "Seconds.")
