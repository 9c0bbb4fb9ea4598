"""Set-ups by messages: what they name, and who is refused at once. What they change: `inputs/page_devices`."""

from omote.model.cast import Cast
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.bindings import BindingDocument
from omote.show.objects.documents import read_document
from omote.show.objects.hand.setups import CallSetup, DropSetup, KeepSetup, StoredSetup
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession


def test_it_names_its_characters_their_targets_and_what_bindings_call() -> None:
    mapping = MacroMapping("m", (MacroTarget("channel/beam"), MacroTarget("head/yaw", high=0.1)))
    bound = BindingDocument("pad", "1/note60", "/omote/one/expression", arguments=["joy", 0.5])
    setup = StoredSetup({"kaori": [mapping]}, [bound])
    assert {"kaori", "beam", "joy"} <= {*setup.names()}
    assert read_document(StoredSetup, setup.encode()) == setup


def test_one_that_is_not_there_is_refused_at_once_and_one_that_is_just_kept_is_there(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    for message in (CallSetup("1", "left"), DropSetup("2", "left")):
        (answer,) = session.receive("ana", message, 0.0)
        assert isinstance(answer.message, Refused)
    assert session.receive("ana", KeepSetup("3", "left"), 0.0) == []
    assert session.receive("ana", CallSetup("4", "left"), 0.0) == []
    assert len(session.take_device_messages()) == 2
