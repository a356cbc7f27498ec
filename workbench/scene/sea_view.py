"""The animated 3-D view of a scene in a notebook or a Voila page.

The film plays in the browser: after the scene has been sent, nothing passes
between page and kernel except the time, at most twice a second.
"""

from pathlib import Path

import anywidget
import traitlets
import xarray as xr

from workbench.errors import checked_choice
from workbench.scene.packing import packed_scene

BUNDLE = Path(__file__).parent / "static" / "sea_view.js"
CAMERAS = ("quarter", "bow", "under", "side")


class SeaView(anywidget.AnyWidget):
    """Ship, sea and wet deck, playing.

    Attributes
    ----------
    time : instant shown [s]; may be set.
    playing : whether the film runs; may be set.
    field : field of the deck that is drawn; may be set.
    camera : one of `CAMERAS`; may be set, empty after the reader has turned the view.
    height : height of the view [px].
    link : name that views of the same film share, which then keep the same time in the browser; empty for none.
    status : ``'ready'``, ``'ready-software'`` (drawn without a graphics card, slower) or
        ``'nowebgl'`` (the browser cannot draw it: offer a film), empty until the page has answered.
    """

    _esm = BUNDLE

    scene = traitlets.Dict().tag(sync=True)
    revision = traitlets.Int(0).tag(sync=True)
    pose = traitlets.Bytes().tag(sync=True)
    water = traitlets.Bytes().tag(sync=True)
    water_grid = traitlets.Bytes().tag(sync=True)
    hull_vertices = traitlets.Bytes().tag(sync=True)
    hull_faces = traitlets.Bytes().tag(sync=True)
    deck = traitlets.Bytes().tag(sync=True)
    slams = traitlets.Bytes().tag(sync=True)
    curves = traitlets.Bytes().tag(sync=True)
    relative_motion_history = traitlets.Bytes().tag(sync=True)
    clearance_left = traitlets.Bytes().tag(sync=True)
    pressure = traitlets.Bytes().tag(sync=True)

    time = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(True).tag(sync=True)
    field = traitlets.Unicode("").tag(sync=True)
    camera = traitlets.Unicode("quarter").tag(sync=True)
    height = traitlets.Int(500, min=320).tag(sync=True)
    link = traitlets.Unicode("").tag(sync=True)
    status = traitlets.Unicode("").tag(sync=True)

    def show(self, scene: xr.Dataset) -> None:
        """Show another scene in place; only blocks that differ are sent.

        The time is kept if the new scene contains it; the field is kept if the new scene has it.
        """
        blocks = packed_scene(scene)
        facts = blocks["scene"]
        start, end = facts["start"], facts["start"] + facts["step"] * (facts["count"] - 1)
        names = [field["name"] for field in facts["fields"]]
        with self.hold_sync():
            for name, block in blocks.items():
                setattr(self, name, block)
            if not start <= self.time <= end:
                self.time = start
            if self.field not in names:
                self.field = names[0] if names else ""
            self.revision += 1


def sea_view(scene: xr.Dataset, field: str = "relative_motion_history") -> SeaView:
    """Animated view of a scene (`workbench.scene.description`), drawing this field on the deck.

    If the scene has fields but not this one, `InputError` names those it has.
    """
    view = SeaView()
    view.show(scene)
    names = [one["name"] for one in view.scene["fields"]]
    if names:
        view.field = checked_choice("The field drawn on the deck", field, names)
    return view
