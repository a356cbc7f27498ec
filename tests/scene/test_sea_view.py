import numpy as np
import pytest

from workbench.errors import InputError
from workbench.scene.packing import BLOCKS
from workbench.scene.sea_view import sea_view


@pytest.fixture
def sent(monkeypatch):
    """Names of the traits that go to the page, a set for each message."""
    messages = []
    monkeypatch.setattr(
        "ipywidgets.Widget._send", lambda self, msg, buffers=None: messages.append(msg), raising=True
    )
    return messages


def names_sent(messages) -> set[str]:
    names: set[str] = set()
    for message in messages:
        if message.get("method") == "update":
            names |= set(message["state"]) | {path[0] for path in message["buffer_paths"]}
    return names


def test_state_holds_every_block_and_control(short_scene):
    view = sea_view(short_scene)
    state = view.get_state()
    assert {"scene", *BLOCKS} <= set(state)
    assert {"time", "playing", "field", "camera", "status", "height", "_esm"} <= set(state)
    assert state["scene"]["count"] == short_scene.sizes["time"]
    assert [field["name"] for field in state["scene"]["fields"]] == [
        "relative_motion_history",
        "clearance_left",
        "pressure",
    ]


def test_only_changed_blocks_are_sent(short_scene, sent):
    view = sea_view(short_scene, field="pressure")
    sent.clear()
    louder = short_scene.copy()
    louder["pressure"] = (
        short_scene["pressure"] * np.linspace(0.5, 1, short_scene.sizes["time"])[:, None, None]
    )
    view.show(louder)
    names = names_sent(sent)
    assert {"pressure", "revision"} <= names
    assert not names & {"pose", "water", "hull_vertices", "hull_faces", "deck", "clearance_left"}
    assert len([message for message in sent if message.get("method") == "update"]) == 1


def test_time_and_field_survive_where_the_new_scene_has_them(short_scene):
    view = sea_view(short_scene, field="clearance_left")
    view.time = 9.0
    view.show(short_scene.isel(time=slice(0, 50)))
    assert view.time == 0.0
    assert view.field == "clearance_left"
    view.show(short_scene.drop_vars("clearance_left"))
    assert view.field == "relative_motion_history"


def test_unknown_field_is_refused(short_scene):
    with pytest.raises(InputError, match="relative_motion_history, clearance_left, pressure"):
        sea_view(short_scene, field="temperature")


def test_scene_without_fields_can_be_shown(short_scene):
    bare = short_scene.drop_vars(["relative_motion_history", "clearance_left", "pressure"])
    assert sea_view(bare).field == ""
