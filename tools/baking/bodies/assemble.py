"""Assembles the arrays of figures.npz from the published files (their list: omote.builtin.figurefile)."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from omote.builtin.figurefile import FIGURE_FORMAT, STEPS_OF_A_METRE
from omote.geometry.ramp import smooth_ramp
from omote.model.body.garment import FIELDS
from omote.model.body.skeleton import SIDES
from tools.baking.assemble import Arrays
from tools.baking.bodies.ball_joints import BallJoint, find_ball_joints, solve_ball_joint
from tools.baking.bodies.builds import FIGURES
from tools.baking.bodies.correctives import Hinge, Skinning, find_hinges, solve_hinge
from tools.baking.bodies.figure_cut import FigureCut, cut_figure, figure_points
from tools.baking.bodies.garments import garments
from tools.baking.bodies.neck_join import find_join
from tools.baking.bodies.rig import Rig, read_rig, row_weights
from tools.baking.bodies.skirt import stand_off
from tools.baking.heads.basemesh import BaseMesh, Floats
from tools.baking.heads.head import Head
from tools.baking.heads.person import person_points
from tools.baking.package import Package

HEAD_JOINT_BAND = 0.008
"""Metres above and below the joint that the head turns on: the rows of the head there carry it on every face."""

LINEAR_AROUND = {"upperarm01": (0.09, 0.17), "upperleg01": (0.14, 0.24)}
"""Around which joints of the generic body (1.67 m) linear blending moves the skin, and from where on dual quaternions
do, metres: those swell a raised shoulder by 44 % (linear 19 %)."""


def figure_arrays(package: Package, base: BaseMesh, head: Head, step: Callable[[str], None]) -> Arrays:
    """All arrays of figures.npz.

    package: the published files; base, head: the base mesh and the head cut from it; step: is called with each body.
    """
    cut = cut_figure(base, head)
    rig = read_rig(package, base)
    generic = figure_points(cut, head, base.points)
    joined, join = find_join(cut, generic)
    bones, weights = row_weights(rig, cut)
    joint = head.metres(rig.joints(base.points))[rig.skeleton.places["head"]]
    band = np.flatnonzero(np.abs(generic[: cut.head_rows, 1] - joint[1]) < HEAD_JOINT_BAND)
    first_of_skirt = int(cut.skirt.min())
    joints = head.metres(rig.joints(base.points))
    worn = garments(rig, joints, generic, first_of_skirt, bones, weights)
    listed = [[garment.name, garment.label] for garment in worn]
    names = json.dumps({"bones": rig.skeleton.names, "bodies": [*FIGURES], "garments": listed})
    shares = dual_shares(rig, generic, head.metres(base.points))
    shares[first_of_skirt:] = 0.0  # cloth between two legs has no limb of its own that could keep it round
    skinning = Skinning(rig.skeleton, bones, weights.astype(np.float32), shares.astype(np.float32))
    hinges = find_hinges(skinning, joints, generic, cut.triangles)
    taken = np.concatenate([hinge.patch.rows[: hinge.patch.free] for hinge in hinges])
    balls = find_ball_joints(skinning, joints, generic, cut.triangles, cut.head_rows, taken)
    patches = [*(hinge.patch for hinge in hinges), *(ball.patch for ball in balls)]
    arrays: Arrays = {
        "format": np.array(FIGURE_FORMAT),
        "about": np.frombuffer(names.encode(), np.uint8),
        "parents": rig.skeleton.parents,
        "triangles": cut.triangles,
        "head_rows": np.array(cut.head_rows),
        "edge": cut.edge,
        "rim": np.array(cut.rim),
        "bones": bones.astype(np.uint8),
        "weights": np.rint(weights * np.iinfo(np.uint16).max).astype(np.uint16),
        "shares": np.rint(shares * np.iinfo(np.uint8).max).astype(np.uint8),
        "joined": joined,
        "join": join.astype(np.float32),
        "head_joint": band.astype(np.int32),
        "head_joint_offset": joint - generic[band].mean(axis=0),
        "uvs": cut.uvs,
        "uv_rows": cut.uv_rows,
        "skirt": cut.skirt,
        "bending": np.concatenate([patch.rows[: patch.free] for patch in patches]).astype(np.int32),
        "bending_hinges": np.repeat(np.arange(len(patches)), [patch.free for patch in patches]).astype(np.uint8),
    }
    for garment in worn:
        arrays[f"garment/{garment.name}"] = in_steps(np.stack([getattr(garment, field) for field in FIELDS]))
    for name in FIGURES:
        arrays |= body_arrays(name, package, base, head, cut, rig, skinning, hinges, balls)
        step(name)
    return arrays


def dual_shares(rig: Rig, generic: Floats, points: Floats) -> Floats:
    """How much of each row's move (V + B,) dual quaternions make: none near shoulders and hips, all of it elsewhere.

    rig: of the figure; generic (V + B, 3): the generic figure; points: the generic base mesh, metres both.
    """
    joints = rig.joints(points)
    shares = np.ones(len(generic))
    for bone, (near, far) in LINEAR_AROUND.items():
        for side in SIDES:
            way = np.linalg.norm(generic - joints[rig.skeleton.places[f"{bone}.{side}"]], axis=1)
            shares = np.minimum(shares, smooth_ramp(near, far, way))
    return np.asarray(shares)


def body_arrays(
    name: str, package: Package, base: BaseMesh, head: Head, cut: FigureCut, rig: Rig, skinning: Skinning,
    hinges: Sequence[Hinge], balls: Sequence[BallJoint],
) -> Arrays:  # fmt: skip
    """The rows, edge, joints, ends and correctives of one body, in steps of a metre. name: of `FIGURES`; the rest as of
    `figure_arrays`, `find_hinges` and `find_ball_joints`."""
    person = FIGURES[name].as_person(name)
    points = person_points(person, package, base, head)
    rows = figure_points(cut, head, points)
    rows[cut.skirt.min() :] = stand_off(rows, cut)
    joints = head.metres(rig.joints(points))
    ends = head.metres(rig.ends(points))
    solved = [
        *(solve_hinge(hinge, skinning, rows, joints, ends) for hinge in hinges),
        *(solve_ball_joint(ball, skinning, rows, joints, ends) for ball in balls),
    ]
    found = {
        "positions": rows[cut.head_rows :],
        "edge": rows[cut.edge],
        "joints": joints,
        "ends": ends,
        "correctives": np.concatenate(solved, axis=1).reshape(-1, 3),
    }
    packed = {what: in_steps(values) for what, values in found.items()}
    return {f"body/{name}/{what}": values for what, values in packed.items()} | {
        f"body/{name}/size": np.array(person.size)
    }


def in_steps(values: Floats) -> NDArray[np.int16]:
    """Metres as they are kept."""
    return np.rint(values * STEPS_OF_A_METRE).astype(np.int16)
