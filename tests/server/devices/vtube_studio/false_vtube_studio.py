"""A VTube Studio of our own, made from its documentation: its user allows plugins, its parameters move."""

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from typing import Any

from aiohttp import web
from aiohttp.test_utils import TestServer

TOKEN = "adcd-123-ef09-some-token-string-abcd"
DEFAULTS = {"FaceAngleX": 0.0, "FaceAngleY": 0.0, "FaceAngleZ": 0.0, "MouthOpen": 0.0, "MouthSmile": 0.5}


@dataclass
class FalseVtubeStudio:
    """Its state: whether its user allows, its parameters, those that plugins have added, and what was injected."""

    allows: bool = True
    valid: set[str] = field(default_factory=set)
    parameters: dict[str, float] = field(default_factory=lambda: dict(DEFAULTS))
    added: dict[str, float] = field(default_factory=dict)
    injected: list[dict[str, Any]] = field(default_factory=list)
    heard: list[str] = field(default_factory=list)
    links: list[web.WebSocketResponse] = field(default_factory=list)
    news: asyncio.Event = field(default_factory=asyncio.Event)

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """A connection of a plugin; only one that has shown its token may ask for more."""
        link = web.WebSocketResponse()
        await link.prepare(request)
        self.links.append(link)
        entered = False
        async for message in link:
            asked = json.loads(message.data)
            assert asked["apiName"] == "VTubeStudioPublicAPI"
            assert asked["apiVersion"] == "1.0"
            assert 1 <= len(asked["requestID"]) <= 64
            kind = asked["messageType"]
            data = asked["data"]
            self.heard.append(kind)
            if kind == "AuthenticationTokenRequest":
                kind, data = self._grant()
            elif kind == "AuthenticationRequest":
                entered = data["authenticationToken"] in self.valid
                kind = "AuthenticationResponse"
                data = {"authenticated": entered, "reason": ""}
            elif not entered:
                kind = "APIError"
                data = {"errorID": 8, "message": "Request requires authentication."}
            else:
                kind, data = self._obey(kind, data)
            await link.send_str(
                json.dumps(
                    {
                        "apiName": "VTubeStudioPublicAPI",
                        "apiVersion": "1.0",
                        "timestamp": 1625405710728,
                        "requestID": asked["requestID"],
                        "messageType": kind,
                        "data": data,
                    }
                )
            )
            self.news.set()
        return link

    def _grant(self) -> tuple[str, dict[str, Any]]:
        if not self.allows:
            return "APIError", {"errorID": 50, "message": "User has denied API access for your plugin."}
        self.valid.add(TOKEN)
        return "AuthenticationTokenResponse", {"authenticationToken": TOKEN}

    def _obey(self, kind: str, data: dict[str, Any]) -> tuple[str, dict[str, Any]]:
        if kind == "InputParameterListRequest":
            return "InputParameterListResponse", {
                "modelLoaded": True,
                "modelName": "My Currently Loaded Model",
                "modelID": "UniqueIDOfModel",
                "customParameters": _listed(self.added, "Plugin"),
                "defaultParameters": _listed(self.parameters, "VTube Studio"),
            }
        if kind == "ParameterCreationRequest":
            self.added[data["parameterName"]] = data["defaultValue"]
        if kind == "InjectParameterDataRequest":
            unknown = [each["id"] for each in data["parameterValues"] if each["id"] not in self.parameters | self.added]
            if unknown:
                return "APIError", {"errorID": 453, "message": f"no parameter {unknown[0]}"}
            self.injected.append(data)
        if kind == "FaceFoundRequest":
            data = {"found": True}
        return kind.replace("Request", "Response"), data


def _listed(values: dict[str, float], who: str) -> list[dict[str, Any]]:
    return [
        {"name": name, "addedBy": who, "value": value, "min": -30, "max": 30, "defaultValue": 0}
        for name, value in values.items()
    ]


@asynccontextmanager
async def open_false_vtube_studio() -> AsyncIterator[tuple[FalseVtubeStudio, TestServer]]:
    """One that runs, and its server."""
    false = FalseVtubeStudio()
    application = web.Application()
    application.router.add_get("/", false.respond)
    server = TestServer(application)
    async with server:
        yield false, server
        for link in false.links:
            await link.close()
