"""Serializes figures for the pages: what all bodies share, each body, and the poses."""

from __future__ import annotations

from dataclasses import dataclass
from hashlib import blake2b

import msgspec
import numpy as np

from omote.model.body.body import Body
from omote.model.body.figures import Figures
from omote.model.body.garment import FIELDS, Garment
from omote.model.body.limb_field import LimbField
from omote.model.body.pose import Pose
from omote.show.cast_documents import (
    BodyAsset,
    BodyDocument,
    FigureAsset,
    FiguresDocument,
    GarmentDocument,
    LimbFieldAsset,
    PoseDocument,
)
from omote.show.wire import le_bytes


@dataclass(frozen=True)
class FigureDocuments:
    """The document of the manifest, and the assets by their addresses."""

    document: FiguresDocument
    assets: dict[str, FigureAsset | BodyAsset]


def figure_documents(figures: Figures) -> FigureDocuments:
    """What pages get of the figures of a cast."""
    shared = figure_asset(figures)
    bodies = {name: body_asset(body) for name, body in figures.bodies.items()}
    urls = {name: _address(asset) for name, asset in bodies.items()}
    listed = [
        BodyDocument(name, name.replace("_", " ").capitalize(), urls[name], body.size)
        for name, body in figures.bodies.items()
    ]
    url = _address(shared)
    poses = [pose_document(pose, pose.name) for pose in figures.poses.values()]
    garments = [GarmentDocument(garment.name, garment.label) for garment in figures.garments.values()]
    document = FiguresDocument(url, listed, poses, garments)
    return FigureDocuments(document, {url: shared} | {urls[name]: asset for name, asset in bodies.items()})


def figure_asset(figures: Figures) -> FigureAsset:
    """What all bodies share, garments among it."""
    space = figures.space
    x, y, z = space.head_joint_offset.tolist()
    return FigureAsset(
        bones=[*space.skeleton.names],
        parents=le_bytes(space.skeleton.parents, "<i4"),
        head_rows=space.head_rows,
        row_bones=le_bytes(space.bones, "u1"),
        row_weights=le_bytes(np.rint(space.weights * np.iinfo(np.uint16).max), "<u2"),
        shares=le_bytes(np.rint(space.shares * np.iinfo(np.uint8).max), "u1"),
        triangles=le_bytes(space.triangles, "<u4"),
        edge=le_bytes(space.edge, "<u4"),
        rim=space.rim,
        joined=le_bytes(space.joined, "<u4"),
        join=le_bytes(space.join, "<f4"),
        head_joint=le_bytes(space.head_joint, "<u4"),
        head_joint_offset=(x, y, z),
        uvs=le_bytes(space.uvs, "<f4"),
        uv_rows=le_bytes(space.uv_rows, "<u4"),
        skirt=le_bytes(space.skirt, "<u4"),
        bending=le_bytes(space.bending, "<u4"),
        bending_hinges=le_bytes(space.bending_hinges, "u1"),
        garments=b"".join(garment_bytes(garment) for garment in figures.garments.values()),
        limb_rows=le_bytes(figures.limbs.rows, "<u4"),
        limbs=le_bytes(figures.limbs.limbs, "u1"),
        limb_ways=le_bytes(figures.limbs.ways, "<f4"),
        limb_fields=[limb_field_asset(field) for field in figures.limb_fields.values()],
    )


def garment_bytes(garment: Garment) -> bytes:
    """The fields of one garment."""
    return le_bytes(np.stack([getattr(garment, field) for field in FIELDS], axis=1), "<f4")


def limb_field_asset(field: LimbField) -> LimbFieldAsset:
    """One limb field, where it moves something."""
    places = np.flatnonzero(field.values.any(axis=1))
    return LimbFieldAsset(field.name, field.driver, le_bytes(places, "<u4"), le_bytes(field.values[places], "<f4"))


def body_asset(body: Body) -> BodyAsset:
    """One body."""
    parts = ("positions", "edge", "joints", "ends", "correctives")
    return BodyAsset(*(le_bytes(getattr(body, what), "<f4") for what in parts))


def pose_document(pose: Pose, source: str) -> PoseDocument:
    """One pose, small enough to come with the manifest. source: its name, or the key of an own one's content."""
    x, y, z = pose.travel.tolist()
    turns, feet, feet_turns = (le_bytes(getattr(pose, what), "<f4") for what in ("turns", "feet", "feet_turns"))
    return PoseDocument(pose.name, pose.label, source, turns, (x, y, z), feet, feet_turns)


def _address(asset: msgspec.Struct) -> str:
    digest = blake2b(msgspec.msgpack.encode(asset), digest_size=12).hexdigest()
    return f"/assets/{digest}"
