"""What a page has chosen that its source plays, as a route of the show."""

from __future__ import annotations

from dataclasses import dataclass, field
from uuid import uuid4

from omote.inputs.trackers.tracker_input import TrackerInput
from omote.perform.layers.layer_names import LayerName, RoutePart
from omote.show.objects.link import Refused
from omote.show.objects.sources import RouteSource
from omote.show.session import ShowSession


@dataclass(frozen=True)
class SourceChoice:
    """characters: by name; regions: none for all."""

    characters: list[str]
    regions: list[RoutePart] = field(default_factory=list)


def route_source(session: ShowSession, trackers: TrackerInput, name: str, choice: SourceChoice, now: float) -> str:
    """Has a performer's source play what was chosen; returns why not, "" where it does.

    session: the show; trackers: where the source is; name: the performer's; choice: what it is to play; now: seconds of
    the show's clock.
    """
    who = trackers.client("", name)
    if who is None:
        return ""
    title = trackers.title("", name)
    before = session.sources.route(title)
    layer: LayerName = before.layer if before.characters else "tracker"
    asked = RouteSource(uuid4().hex, title, choice.characters, layer, choice.regions)
    answers = [answer.message for answer in session.receive(who, asked, now)]
    return next((answer.reason for answer in answers if isinstance(answer, Refused)), "")
