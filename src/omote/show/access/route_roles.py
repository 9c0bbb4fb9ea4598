"""Which role each address of the web server needs."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omote.show.access.access_role import HIGHEST, AccessRole

ROUTES: Mapping[tuple[str, str], AccessRole] = MappingProxyType(
    {
        ("GET", "/link"): "view",  # each message is checked by itself
        ("GET", "/editing"): "view",
        ("GET", "/access"): "view",
        ("GET", "/certificate"): "view",
        ("GET", "/people"): "admin",
        ("POST", "/people"): "admin",
        ("DELETE", "/people/{id}"): "admin",
        ("GET", "/people/{id}/code"): "admin",
        ("GET", "/cue_lists/{name}"): "view",
        ("POST", "/cue_lists/{name}"): "edit",
        ("GET", "/recordings"): "view",
        ("GET", "/curves"): "view",
        ("POST", "/markers"): "view",  # a director notes, and plays nothing
        ("POST", "/markers/{id}"): "view",  # own ones: others' need operate
        ("DELETE", "/markers/{id}"): "view",
        ("GET", "/clip_outlines/{name}"): "view",
        ("GET", "/exports/{file}"): "operate",
        ("POST", "/imports/{file}"): "edit",
        ("POST", "/photographs"): "edit",
        ("POST", "/photographs/picture"): "edit",
        ("POST", "/photographs/{token}"): "edit",
        ("POST", "/scans"): "edit",
        ("POST", "/scans/{token}"): "edit",
        ("POST", "/scans/{token}/face"): "edit",
        ("DELETE", "/scans/{token}"): "edit",
        ("GET", "/manifest"): "view",
        ("GET", "/assets/{name}"): "view",
        ("GET", "/compounds/{base}/{face}/{expression}"): "view",
        ("GET", "/tangents/{base}/{face}"): "view",
        ("GET", "/handles"): "view",
        ("GET", "/contents/{key}"): "view",
        ("GET", "/albedos/{digest}/{source}"): "view",
        ("GET", "/mediapipe"): "operate",
        ("POST", "/sounds"): "operate",
        ("GET", "/sounds/{key}"): "view",
        ("GET", "/voices"): "view",
        ("POST", "/voices"): "operate",
        ("GET", "/camera/link"): "operate",
        ("GET", "/connect"): "view",
        ("GET", "/connect/{page}.svg"): "operate",  # it may hold the token that operators share
        ("GET", "/voice"): "operate",
        ("GET", "/omote"): "view",
        ("GET", "/omote/{path}"): "view",
        ("GET", "/touchosc/omote.tosc"): "view",
        ("GET", "/"): "view",
        ("GET", "/stage"): "view",
        ("GET", "/console"): "view",
        ("GET", "/editor"): "view",
        ("GET", "/cues"): "view",
        ("GET", "/solo"): "view",
        ("GET", "/notes"): "view",
        ("GET", "/runs"): "view",
        ("GET", "/clips"): "view",
        ("GET", "/devices"): "view",
        ("GET", "/camera"): "view",
        ("GET", "/microphone"): "view",
        ("GET", "/{page}"): "view",
    }
)
"""By method and address, as the web server's router writes it."""
OSCQUERY_ROUTES = frozenset({"/", "/omote", "/omote/{path}", "/touchosc/omote.tosc"})
"""What surfaces read that play by OSC."""
UNKNOWN_ROUTE: AccessRole = "view"
"""What is answered with "there is no such page": strangers are told nothing, not even that."""


def role_for_route(method: str, route: str | None) -> AccessRole:
    """The role that a request needs: the highest for a route that nobody has thought of. route: None where there is
    none. method: of HTTP, HEAD counts as GET."""
    if route is None:
        return UNKNOWN_ROUTE
    return ROUTES.get(("GET" if method == "HEAD" else method, route), HIGHEST)
