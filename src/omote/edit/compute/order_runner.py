"""Runs editors' orders (`edit.protocol.orders`): bakes recipes, solves for dragged points, changes control nets."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TypeVar

import msgspec

from omote.edit.compute.layer_correction import LayerCorrection
from omote.edit.protocol.messages import NetDocument, TangentsAsset
from omote.edit.protocol.orders import Baked, Contents, EditOrder, Flat, Renet, Solve
from omote.model.body.compose_pose import pose_of
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.cast import Cast
from omote.model.controls.inverse_solve import solve_vectors
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.controls.tangents import tangents
from omote.model.recipes.compose_expression import change_net
from omote.model.recipes.compose_face import FaceWithLook, compose_face
from omote.model.recipes.recipe import KEY, FaceRecipe, Recipe, sources
from omote.model.space.expression import Expression
from omote.show.wire import le_bytes
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression, pack_face, pack_pose, unpack_expression, unpack_face

_CACHED = 64
"""Unpacked contents and control nets that stay cached."""
_DRAFT = "draft"

Thing = TypeVar("Thing")


class OrderRunner:
    """Runs editors' orders on one cast; caches what it unpacked and the nets that it built last."""

    def __init__(self, cast: Cast) -> None:
        self._cast = cast
        self._expressions: OrderedDict[str, Expression] = OrderedDict()
        self._faces: OrderedDict[str, FaceWithLook] = OrderedDict()
        self._layers = LayerCorrection(cast.space)
        self._net_field = lru_cache(maxsize=_CACHED)(lambda rows: build_net_field(cast.space, rows))

    def run(self, order: EditOrder, /) -> Baked:
        """Runs an order. ValueError with a message for names that do not exist and numbers out of range."""
        if isinstance(order, Solve):
            return self._solve(order)
        if isinstance(order, Renet):
            return self._change_net(order)
        if isinstance(order, Flat):
            return self._flatten(order)
        if isinstance(order.recipe, FaceRecipe):
            return self._bake_face(order.recipe, order.contents)
        if isinstance(order.recipe, PoseRecipe):
            return self._bake_pose(order.recipe)
        return self._bake(order.recipe, order.contents, with_net=order.with_net)

    def net_document(self, net: tuple[int, ...], /) -> NetDocument:
        """The document of a control net; ValueError for rows that make none."""
        return net_document(self._net_field(tuple(net)))

    def tangents_asset(self, source: str, contents: Contents, /) -> TangentsAsset:
        """The tangents of a face (its derivative with respect to a field); contents hold an authored face.

        source: the face's; contents: by their keys.
        """
        return TangentsAsset(le_bytes(tangents(self._cast.space, self._face(source, contents).face), "<f4"))

    def _bake(self, recipe: Recipe, contents: Contents, *, with_net: bool, miss: float = 0.0) -> Baked:
        net = self._net_field(recipe.net)
        data = pack_expression(self._layers.compose(recipe, self._load_expressions(recipe, contents), net))
        key = content_key(data)
        return Baked(recipe, key, {key: data}, net_document(net) if with_net else None, miss)

    def _bake_face(self, recipe: FaceRecipe, contents: Contents) -> Baked:
        named = {source: self._face(source, contents) for source in sorted(sources(recipe))}
        composed = compose_face(self._cast.space, _DRAFT, recipe, named, atlas=self._cast.atlas)
        data = pack_face(composed.face, composed.look)
        return Baked(recipe, content_key(data), {content_key(data): data})

    def _bake_pose(self, recipe: PoseRecipe) -> Baked:
        if self._cast.figures is None:
            raise ValueError("this cast has no figures, so nothing can do a pose; bake the cast again")
        pose_of(recipe, self._cast.figures.space.skeleton, _DRAFT)  # raises where no figure can do it
        data = pack_pose(recipe)
        return Baked(recipe, content_key(data), {content_key(data): data})

    def _solve(self, order: Solve) -> Baked:
        net = self._net_field(order.recipe.net)
        still = msgspec.structs.replace(order.recipe, vectors=((0.0, 0.0, 1.0),) * len(order.recipe.net))
        under = self._layers.compose(still, self._load_expressions(order.recipe, order.contents), net)
        face = self._face(order.face, order.contents).face
        solved = solve_vectors(self._cast.space, face, under, net, order.vectors, order.points, order.targets)
        vectors = tuple((float(a), float(b), float(c)) for a, b, c in solved.vectors)
        recipe = msgspec.structs.replace(order.recipe, vectors=vectors)
        return self._bake(recipe, order.contents, with_net=False, miss=solved.miss)

    def _change_net(self, order: Renet) -> Baked:
        named = self._load_expressions(order.recipe, order.contents)
        before = None if order.recipe.ground is None else named[order.recipe.ground]
        recipe, _, ground = change_net(self._cast.space, order.recipe, before, order.net)
        added = Contents()
        if ground is not None and ground is not before:
            data = pack_expression(ground)
            key = content_key(data)
            added[key] = data
            recipe = msgspec.structs.replace(recipe, ground=KEY + key)
        baked = self._bake(recipe, {**order.contents, **added}, with_net=True)
        return msgspec.structs.replace(baked, contents={**added, **baked.contents})

    def _flatten(self, order: Flat) -> Baked:
        whole = self._bake(order.recipe, order.contents, with_net=False)
        still = ((0.0, 0.0, 1.0),) * len(order.recipe.net)
        muted = tuple(layer for layer in order.recipe.layers if layer.muted)
        flat = Recipe(order.recipe.net, still, KEY + whole.key, muted)
        return msgspec.structs.replace(whole, recipe=flat)

    def _load_expressions(self, recipe: Recipe, contents: Contents) -> dict[str, Expression]:
        """The expressions that a recipe names; ValueError where one is missing."""
        expressions = {}
        for source in sources(recipe):
            if not source.startswith(KEY) and source in self._cast.expressions:
                expressions[source] = self._cast.expressions[source]
            elif source.removeprefix(KEY) in contents:
                expressions[source] = _unpack_once(self._expressions, source, contents, unpack_expression)
        missing = sorted(sources(recipe) - expressions.keys())
        if missing:
            raise ValueError(f"there is no expression {missing[0]!r}: choose another layer, or import it again")
        return expressions

    def _face(self, source: str, contents: Contents) -> FaceWithLook:
        if not source.startswith(KEY) and source in self._cast.faces:
            return FaceWithLook(self._cast.faces[source], self._cast.looks[source])
        if source.startswith(KEY) and source.removeprefix(KEY) in contents:
            return _unpack_once(self._faces, source, contents, lambda data: FaceWithLook(*unpack_face(data, _DRAFT)))
        raise ValueError(f"there is no face {source!r}; expected one of {', '.join(self._cast.faces)}, or an own one")


def net_document(net_field: NetField, /) -> NetDocument:
    """Serializes a control net for pages."""
    net = net_field.net
    return NetDocument(
        net=list(net_field.rows),
        triangles=le_bytes(net.triangles, "<u2"),
        corners=le_bytes(net.corners, "<u2"),
        weights=le_bytes(net.weights, "<f4"),
        mirror=list(net_field.mirror),
    )


def _unpack_once(
    cache: OrderedDict[str, Thing], source: str, contents: Mapping[str, bytes], unpack: Callable[[bytes], Thing]
) -> Thing:
    """Unpacks a content through a cache (least recently used)."""
    if source not in cache:
        key = source.removeprefix(KEY)
        if content_key(contents[key]) != key:
            raise ValueError(f"the content under {source!r} does not match it; expected bytes that hash to their key")
        cache[source] = unpack(contents[key])
        if len(cache) > _CACHED:
            cache.popitem(last=False)
    cache.move_to_end(source)
    return cache[source]
