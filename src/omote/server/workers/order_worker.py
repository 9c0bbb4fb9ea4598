"""Computes orders in a worker process: encoded orders in, encoded answers out.

Orders carry all that they need beside the built-in cast, so any worker can compute any of them; a worker caches the
contents that it unpacked last.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from functools import cached_property

import msgspec

from omote.edit.compute.order_runner import OrderRunner
from omote.edit.compute.welcome import build_welcome, handles_asset
from omote.edit.protocol.messages import Greeted
from omote.edit.protocol.orders import Contents, EditOrder
from omote.model.cast import Cast, Look
from omote.model.controls.default_net import default_net
from omote.model.recipes.recipe import KEY
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.show.wire import encode
from omote.showfile.contents import content_kind, unpack_expression, unpack_face
from omote.stage_data.assets import compound_asset, content_asset

CACHED_CONTENTS = 64
"""Contents that a worker caches unpacked: a megabyte each at most."""


class CompoundOrder(msgspec.Struct, frozen=True, tag=True):
    """A face wearing an expression, by their sources; answered with a `CompoundAsset`."""

    face: str
    expression: str
    contents: Contents


class TangentsOrder(msgspec.Struct, frozen=True, tag=True):
    """The tangents of a face (derivative with respect to a field), by its source; answered with a `TangentsAsset`."""

    face: str
    contents: Contents


class FaceOrder(msgspec.Struct, frozen=True, tag=True):
    """An authored face by the key of its content; answered with a `ContentAsset`."""

    key: str
    contents: Contents


class HandlesOrder(msgspec.Struct, frozen=True, tag=True):
    """The handles of the face editor; answered with a `HandlesAsset`."""


WorkshopOrder = CompoundOrder | TangentsOrder | FaceOrder | HandlesOrder | EditOrder

_order: msgspec.msgpack.Decoder[WorkshopOrder] = msgspec.msgpack.Decoder(WorkshopOrder)


class OrderWorker:
    """Computes orders on one built-in cast; ValueError with a message for orders that cannot be carried out."""

    def __init__(self, cast: Cast) -> None:
        self.cast = cast
        self._unpacked: OrderedDict[str, Expression | tuple[Face, Look]] = OrderedDict()

    def make(self, data: bytes) -> bytes:
        """Computes an encoded order and returns the encoded answer."""
        order = _order.decode(data)
        if isinstance(order, CompoundOrder):
            face, _ = self._face(order.face, order.contents)
            return encode(compound_asset(self.cast, face, self._expression(order.expression, order.contents)))
        if isinstance(order, FaceOrder):
            return encode(content_asset(self.cast, order.key, *self._face(KEY + order.key, order.contents)))
        if isinstance(order, TangentsOrder):
            return encode(self.runner.tangents_asset(order.face, order.contents))
        if isinstance(order, HandlesOrder):
            return encode(handles_asset(self.cast.space))
        return encode(self.runner.run(order))

    @cached_property
    def welcome(self) -> Greeted:
        """The constant part of the welcome to an editor."""
        return build_welcome(self.cast)

    @cached_property
    def net(self) -> tuple[int, ...]:
        """The control points of a new expression."""
        return default_net(self.cast.space)

    @cached_property
    def runner(self) -> OrderRunner:
        """Runs editors' orders."""
        return OrderRunner(self.cast)

    def _face(self, source: str, contents: Mapping[str, bytes]) -> tuple[Face, Look]:
        if not source.startswith(KEY):
            if source not in self.cast.faces:
                raise ValueError(f"there is no face {source[:80]!r} in this cast")
            return self.cast.faces[source], self.cast.looks[source]
        content = self._content(source.removeprefix(KEY), contents)
        if isinstance(content, Expression):
            raise ValueError(f"{source[:80]} is an expression, not a face")
        return content

    def _expression(self, source: str, contents: Mapping[str, bytes]) -> Expression:
        if not source.startswith(KEY):
            if source not in self.cast.expressions:
                raise ValueError(f"there is no expression {source[:80]!r} in this cast")
            return self.cast.expressions[source]
        content = self._content(source.removeprefix(KEY), contents)
        if not isinstance(content, Expression):
            raise ValueError(f"{source[:80]} is a face, not an expression")
        return content

    def _content(self, key: str, contents: Mapping[str, bytes]) -> Expression | tuple[Face, Look]:
        if key not in self._unpacked:
            if key not in contents:
                raise ValueError(f"the content {key[:80]!r} did not come with its order")
            self._unpacked[key] = _unpack(key, contents[key])
        self._unpacked.move_to_end(key)
        while len(self._unpacked) > CACHED_CONTENTS:
            self._unpacked.popitem(last=False)
        return self._unpacked[key]


def _unpack(key: str, data: bytes) -> Expression | tuple[Face, Look]:
    return unpack_face(data, key) if content_kind(data) == "face" else unpack_expression(data)
