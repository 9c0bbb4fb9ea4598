"""A connection to VTube Studio, by the messages of its documentation: the token, reading, setting, and what goes
wrong."""

import json
from typing import Any

import pytest

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.tracker_frame import TrackerError
from omote.inputs.trackers.vtube_studio.api_session import ApiSession

TOKEN = "adcd-123-ef09-some-token-string-abcd"
LISTED: dict[str, Any] = {
    "modelLoaded": True, "modelName": "My Currently Loaded Model", "modelID": "UniqueIDOfModel",
    "customParameters": [
        {"name": "MyCustomParamName1", "addedBy": "My Plugin Name", "value": 12.4, "min": -30, "max": 30,
         "defaultValue": 0},
    ],
    "defaultParameters": [
        {"name": "FaceAngleX", "addedBy": "VTube Studio", "value": 45.78, "min": -30, "max": 30, "defaultValue": 0},
        {"name": "MouthOpen", "addedBy": "VTube Studio", "value": 0.5, "min": 0, "max": 1, "defaultValue": 0},
    ],
}  # fmt: skip


def said(kind: str, **data: Any) -> bytes:
    """A message as VTube Studio writes it."""
    head = {"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "timestamp": 1625405710728, "requestID": "SomeID"}
    return json.dumps({**head, "messageType": kind, "data": data}).encode()


GRANTED = said("AuthenticationTokenResponse", authenticationToken=TOKEN)
DENIED = said("APIError", errorID=50, message="User has denied API access for your plugin.")
VALID = said("AuthenticationResponse", authenticated=True, reason="Token valid.")
INVALID = said("AuthenticationResponse", authenticated=False, reason="Token invalid.")


class Talk:
    """A session, what it has sent, and the tokens it was given to keep."""

    def __init__(self, token: str = "", *, sets: bool = False) -> None:
        self.sent: list[dict[str, Any]] = []
        self.kept: list[str] = []
        self.session = ApiSession(
            lambda data: self.sent.append(json.loads(data)), self.kept.append, token=token, sets=sets
        )
        self.session.begin()

    def hear(self, *messages: bytes) -> list[Any]:
        return [frame for message in messages for frame in self.session.decode(message)]

    @property
    def kinds(self) -> list[str]:
        return [each["messageType"] for each in self.sent]


def test_a_token_is_asked_for_once_and_kept() -> None:
    talk = Talk()
    assert talk.sent[0]["data"] == {"pluginName": "Omote", "pluginDeveloper": "Omote contributors"}
    assert "allow Omote" in talk.session.waits
    talk.hear(GRANTED)
    assert talk.kept == [TOKEN]
    assert talk.sent[1]["data"]["authenticationToken"] == TOKEN
    talk.hear(VALID)
    assert talk.session.ready
    assert talk.session.waits == ""
    assert talk.kinds == [
        "AuthenticationTokenRequest", "AuthenticationRequest", "EventSubscriptionRequest", "FaceFoundRequest",
    ]  # fmt: skip
    assert Talk(TOKEN).kinds == ["AuthenticationRequest"]


def test_a_token_that_was_taken_back_is_asked_for_anew() -> None:
    talk = Talk(TOKEN)
    talk.hear(INVALID)
    assert talk.kinds == ["AuthenticationRequest", "AuthenticationTokenRequest"]
    assert talk.kept == [""]
    talk.hear(GRANTED, VALID)
    with pytest.raises(TrackerError, match="denied API access"):
        talk.hear(DENIED)
    assert talk.kinds[-1] == "AuthenticationTokenRequest"
    assert not talk.session.ready


def test_a_user_who_denies_is_asked_no_more() -> None:
    talk = Talk()
    with pytest.raises(TrackerError, match="denied API access"):
        talk.hear(DENIED)
    assert "denied" in talk.session.waits
    talk.session.poll()
    assert talk.kinds == ["AuthenticationTokenRequest"]


def test_parameters_are_asked_for_one_list_after_the_other() -> None:
    talk = Talk(TOKEN)
    talk.hear(VALID)
    for _ in range(5):
        talk.session.poll()
    assert talk.kinds.count("InputParameterListRequest") == 1
    (frame,) = talk.hear(said("InputParameterListResponse", **LISTED))
    assert frame.weights == {"jawOpen": 0.5}
    assert frame.head is not None
    assert frame.found
    talk.session.poll()
    assert talk.kinds.count("InputParameterListRequest") == 2
    with pytest.raises(TrackerError, match="internal"):
        talk.hear(said("APIError", errorID=0, message="internal"))
    talk.session.poll()
    assert talk.kinds.count("InputParameterListRequest") == 3


def test_a_lost_face_is_a_loss_until_it_is_back() -> None:
    talk = Talk(TOKEN)
    lost = talk.hear(
        VALID, said("TrackingStatusChangedEvent", faceFound=False, leftHandFound=False, rightHandFound=False)
    )
    assert [frame.found for frame in lost] == [False]
    assert not talk.hear(said("InputParameterListResponse", **LISTED))[0].found
    assert talk.hear(said("FaceFoundResponse", found=True)) == []
    assert talk.hear(said("InputParameterListResponse", **LISTED))[0].found


def test_a_face_is_set_by_the_parameters_that_are_there() -> None:
    talk = Talk(TOKEN, sets=True)
    weights = dict.fromkeys(ARKIT_NAMES, 0.25)
    assert not talk.session.set_face(weights, (0.0, 0.0, 0.0), (0.0, 0.0))
    talk.hear(VALID)
    made = [each["data"] for each in talk.sent if each["messageType"] == "ParameterCreationRequest"]
    assert len(made) == 52
    assert made[0] == {
        "parameterName": "OmoteEyeBlinkLeft", "explanation": "The face on air in Omote: eye blink left", "min": 0,
        "max": 1, "defaultValue": 0,
    }  # fmt: skip
    assert talk.hear(said("InputParameterListResponse", **LISTED)) == []
    assert talk.session.set_face(weights, (-0.1, 0.0, 0.0), (0.0, 0.0))
    injected = talk.sent[-1]["data"]
    values = {each["id"]: each["value"] for each in injected["parameterValues"]}
    assert (injected["faceFound"], injected["mode"]) == (True, "set")
    assert values["FaceAngleX"] == pytest.approx(5.72958)
    assert values["MouthOpen"] == 0.0
    assert values["OmoteJawOpen"] == 0.25
    assert "MouthSmile" not in values
    assert len(values) == 54


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (said("AuthenticationTokenResponse"), "cannot be read"),
        (said("AuthenticationTokenResponse", authenticationToken="x" * 65), "cannot be read"),
        (said("InputParameterListResponse", defaultParameters=[{"name": 1}]), "cannot be read"),
        (said("APIError", errorID=8, message="authenticate first"), "authenticate first"),
        (b"{}", "none of VTube Studio"),
    ],
)
def test_what_cannot_be_read_is_rejected(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        Talk(TOKEN).hear(data)


def test_other_messages_are_left_out() -> None:
    assert Talk(TOKEN).hear(said("InjectParameterDataResponse"), said("ModelLoadedEvent", modelLoaded=True)) == []
