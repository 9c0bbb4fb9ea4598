"""Grids of pictures (contact sheets): what is drawn in which row and column, validated before anything is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from omote.interchange.formats.file_names import Kind
from omote.stage_data.clip_poses import ClipPoses
from omote.stage_data.picture_request import RenderRequest, Request, plan_cells, spell_kinds
from omote.stage_data.picture_setting import Setting, refuse_count
from omote.stage_data.playing_cast import PlayingCast, kinds_of
from omote.stage_data.pose_parser import Pose, find_pose, pose_of

if TYPE_CHECKING:
    from omote.model.cast import Cast


@dataclass(frozen=True)
class PictureGrid:
    """Pictures in rows and columns, with or without the names of rows and columns, and words in each picture.

    `part`: what is kept of each picture: left, top, width, height, as shares. `paper`: the colour behind the pictures,
    None for nothing.
    """

    poses: Sequence[Sequence[Pose]]
    rows: Sequence[str] = ()
    columns: Sequence[str] = ()
    captions: Sequence[Sequence[str]] = ()
    part: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0)
    paper: str | None = None
    kind: Kind = "image/png"

    def __post_init__(self) -> None:
        """Rejects an empty grid, one of too many pictures, and names that do not fit."""
        refuse_count(sum(len(row) for row in self.poses))
        if len(self.rows) not in (0, len(self.poses)) or any(len(self.columns) not in (0, len(r)) for r in self.poses):
            raise ValueError("every row and every column has a name, or none has")
        if self.captions and [len(row) for row in self.captions] != [len(row) for row in self.poses]:
            raise ValueError("every picture has a caption, or none has")

    def on_paper(self, setting: Setting, kind: Kind) -> PictureGrid:
        """Sets the background of a grid for a file of this kind; ValueError as `Setting.paper`.

        setting: with background and transparency; kind: of the file.
        """
        return replace(self, paper=setting.paper(kind), kind=kind)


def spell_out(request: Request, cast: PlayingCast) -> Request:
    """The request with every kind among a table's expressions (`performed`, `own`) replaced by its expressions.

    ValueError where there are no own ones, or too many in all.

    cast: whose expressions the kinds stand for.
    """
    return request if isinstance(request, RenderRequest) else spell_kinds(request, kinds_of(cast))


def lay_out(request: Request, cast: Cast | PlayingCast, clips: ClipPoses | None = None) -> PictureGrid:
    """What a request asks for, one picture as a table of one; ValueError for unknown names and invalid numbers.

    cast, clips: in which the names are looked up; None: there are no clips.
    """
    if isinstance(request, RenderRequest):
        frame = find_pose(cast, request.words)
        if request.clip:
            moved = (clips or ClipPoses(cast, {})).frame(request.clip, request.at)
            frame = replace(moved, faces=frame.faces, light=frame.light)
        return PictureGrid([[pose_of(cast, frame)]])
    plan = plan_cells(request)
    poses = [[pose_of(cast, find_pose(cast, cell.words)) for _, cell in row] for row in plan.cells]
    return PictureGrid(poses, plan.rows, plan.columns) if request.labels else PictureGrid(poses)
