"""Performers before cameras at a show session: each is a source named after the performer."""

from __future__ import annotations

from collections.abc import Callable

from omote.inputs.camera.body_points import holds_body
from omote.inputs.camera.performer_calibration import PerformerCalibration
from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.body_input import BodyInput
from omote.inputs.performers.camera_performer import CalibrationFit, CameraPerformer
from omote.inputs.performers.hand_input import HandInput
from omote.inputs.performers.performer_list import PerformerList, check_performer_name
from omote.inputs.performers.source_route import SourceChoice, route_source
from omote.inputs.rejection import PacketError
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TrackerProtocol
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.show.session import ShowSession


def _decode_nothing(_: bytes) -> list[TrackerFrame]:
    """Its frames come as landmarks, each read by its performer."""
    return []


def _guide(performer: CameraPerformer, message: wire.FromCamera) -> None:
    match message:
        case wire.BeginGuide(rest):
            performer.begin_guide(rest=rest)
        case wire.RedoStep(step):
            performer.redo(step)
        case wire.CancelGuide():
            performer.cancel_guide()
        case wire.ContinueGuide():
            performer.continue_guide()
        case wire.UseFaces():
            performer.use_faces()


CAMERA = TrackerProtocol(
    "camera", "Camera", None, "open the page /camera of this show in the performer's browser, or run on the machine of "
    "the camera: omote track --to {host} --token TOKEN, which the start printed for operate",
    lambda _: _decode_nothing,
)  # fmt: skip
CAMERA_HERE = (
    "open the page /camera on this machine; this show listens on this machine alone: for a camera at another, start it "
    "with --host 0.0.0.0"
)
"""What is advised where no other machine reaches the show."""
MOST_CAMERAS = 8
MOST_LEFT = 4
"""Performers who left whose faces are kept while the server lives: some megabytes each."""


class CameraInput:
    """All performers before cameras. session: the show that plays; performers: those of the show file; hands, bodies:
    what their hands and bodies play; heard: frames of landmarks."""

    def __init__(self, session: Callable[[], ShowSession], performers: PerformerList) -> None:
        self.trackers = TrackerInput(CAMERA, session)
        self.hands = HandInput(session)
        self.bodies = BodyInput(session, self.trackers)
        self.performers = performers
        self._session = session
        self._links: dict[str, CameraPerformer] = {}
        self._left: dict[str, CameraPerformer] = {}
        self.heard = 0

    def begin(self, link: str, asked: wire.Perform) -> str | None:
        """Somebody performs at a link; returns the link of a page that played as the same performer and has ended.
        ValueError for another version, a name that cannot be, or one camera too many.

        asked: who, and which version the page speaks.
        """
        if asked.version != wire.CAMERA_VERSION:
            raise ValueError(
                f"this page speaks version {asked.version}, the show {wire.CAMERA_VERSION}: load the page again; with "
                "omote track install the same Omote on both machines"
            )
        name = check_performer_name(asked.name)
        displaced = next(
            (other for other, performer in self._links.items() if performer.name == name and other != link), None
        )
        if link not in self._links and displaced is None and len(self._links) >= MOST_CAMERAS:
            raise ValueError(f"{MOST_CAMERAS} cameras play already; close the page of one")
        for ending in (link, displaced):
            if ending is not None:
                self.end(ending)
        performer = self._links[link] = CameraPerformer(name)
        self._load(performer)
        if (before := self._left.pop(name, None)) is not None:
            performer.take_faces(before)
        return displaced

    def end(self, link: str) -> None:
        """Ends the source of a link with it; the faces that were made wait for the same name."""
        performer = self._links.pop(link, None)
        if performer is None:
            return
        self.trackers.end("", performer.name)
        self.hands.end(performer.name)
        self.bodies.end(performer.name)
        if performer.redoable:
            self._left[performer.name] = performer
            while len(self._left) > MOST_LEFT:
                del self._left[next(iter(self._left))]

    def receive(self, link: str, data: bytes, now: float = 0.0) -> str:
        """Takes a frame of landmarks or of a body, for the next tick; one of a link without a performer is dropped.
        Returns why a body was not read, "" where it was; of landmarks `play` says it.

        data: the page's packet; now: seconds of the show's clock.
        """
        performer = self._links.get(link)
        if performer is None:
            return ""
        if holds_body(data):
            return self.bodies.receive(performer.name, data, now)
        self.heard += 1
        performer.receive(data)
        return ""

    def obey(self, link: str, message: wire.FromCamera) -> str | None:
        """Does what a page asks; returns what `begin` does. ValueError with the reason where it cannot be done.

        link: of the page; message: what it asks for.
        """
        if isinstance(message, wire.Perform):
            return self.begin(link, message)
        performer = self._links.get(link)
        if performer is None:
            raise ValueError("nobody performs at this page yet; say first who does")
        match message:
            case wire.PlayCharacters(characters):
                performer.chosen = [check_known(name, self._session().scene, "character") for name in characters]
            case wire.HandFrame():
                self.hands.receive(performer.name, message)
            case wire.PlayHand():
                self.hands.choose(performer.name, message)
            case wire.PlayBody() | wire.RestBody():
                self.bodies.obey(performer.name, message)
            case wire.BeginGuide() | wire.RedoStep() | wire.CancelGuide() | wire.ContinueGuide() | wire.UseFaces():
                _guide(performer, message)
            case _:
                self._change_list(link, performer, message)
        return None

    def play(self, now: float) -> list[tuple[str, str]]:
        """Drives the session by what has come; returns the links that sent what cannot be read, and why."""
        wrong = []
        for link, performer in self._links.items():
            try:
                for frame in performer.read(now):
                    self.trackers.note("", frame)
            except PacketError as error:
                self.trackers.reject(performer.name, str(error), now)
                wrong.append((link, str(error)))
        self.trackers.play(now)
        self.hands.play(now)
        self.bodies.play(now)
        for performer in self._links.values():
            self._route(performer, now)
        return wrong

    def take_fits(self) -> list[tuple[str, CalibrationFit]]:
        """The calibrations that are to be fitted now, by their links."""
        fits = [(link, performer.take_fit()) for link, performer in self._links.items()]
        return [(link, fit) for link, fit in fits if fit is not None]

    def receive_fit(self, link: str, fit: CalibrationFit, calibration: PerformerCalibration | None) -> None:
        """Reads a performer's face by a calibration that was fitted (None: it could not be), and stores it; ValueError
        where it cannot be stored.

        link: whose frames they were; fit: what was fitted.
        """
        performer = self._links.get(link)
        if performer is not None and performer.name == fit.performer:
            if calibration is None:
                performer.fitting = False
                performer.cancel_guide()
            else:
                performer.use(calibration, "guided" if fit.guided else "rest")
        if calibration is not None:
            self.performers.store(fit.performer, calibration.to_json().encode(), guided=fit.guided)

    def status(self, link: str) -> wire.CameraStatus | None:
        """What the page of a link shows; None before somebody performs there."""
        performer = self._links.get(link)
        if performer is None:
            return None
        return wire.CameraStatus(
            performer=performer.name,
            performers=self.performers.names,
            calibrated=performer.calibrated,
            unrest=performer.unrest,
            characters=self._choices(performer),
            guide=performer.guide.step() if performer.guide else None,
            redoable=performer.redoable,
            missing=performer.missing,
            unused=performer.unused,
            fitting=performer.fitting,
            heard=performer.heard,
            found=performer.found,
            undo=self.performers.undo_label,
            weights={name: round(value, 3) for name, value in performer.weights.items()},
            hand=self.hands.choice(performer.name),
            body=self.bodies.choice(performer.name),
        )

    def _load(self, performer: CameraPerformer) -> None:
        """Reads a performer's face as the show file says; what cannot be read counts as unknown."""
        try:
            document = self.performers.find(performer.name)
            stored = None if document is None else PerformerCalibration.from_json(bytes(document.calibration).decode())
        except ValueError:
            document = None
            stored = None
        performer.use(stored, "no" if document is None else "guided" if document.guided else "rest")

    def _change_list(self, link: str, performer: CameraPerformer, message: wire.FromCamera) -> None:
        before = self.performers.documents
        match message:
            case wire.RenamePerformer(name):
                other = check_performer_name(name)
                self.performers.rename(performer.name, other)
            case wire.DeletePerformer():
                self.performers.delete(performer.name)
                performer.forget_faces()
            case wire.UndoPerformer():
                self.performers.undo()
        after = self.performers.documents
        came = [name for name in after if name not in before]
        if performer.name not in after and len(came) == 1:  # renamed, or a new name taken back
            self.begin(link, wire.Perform(wire.CAMERA_VERSION, came[0]))
            self._links[link].take_faces(self._left.pop(performer.name, performer))
        elif before.get(performer.name) != after.get(performer.name):
            self._load(performer)
        for other_performer in (other for other in self._links.values() if other is not self._links[link]):
            if before.get(other_performer.name) != after.get(other_performer.name):
                self._load(other_performer)

    def _choices(self, performer: CameraPerformer) -> list[wire.CharacterChoice]:
        scene = self._session().scene
        played = self._session().sources.route(self.trackers.title("", performer.name)).characters
        chosen = played if performer.chosen is None else performer.chosen
        return [
            wire.CharacterChoice(name, label, name in chosen or ALL in chosen) for name, label in scene.labels.items()
        ]

    def _route(self, performer: CameraPerformer, now: float) -> None:
        """Plays the characters that a page has chosen, once there is a source."""
        who = self.trackers.client("", performer.name)
        if performer.chosen is None or who is None:
            return
        session = self._session()
        kept = session.sources.route(self.trackers.title("", performer.name)).parts
        choice = SourceChoice(performer.chosen, list(kept))
        performer.chosen = None
        if reason := route_source(session, self.trackers, performer.name, choice, now):
            self.trackers.reject(performer.name, reason, now)
