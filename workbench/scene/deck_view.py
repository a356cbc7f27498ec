"""The pressure over the wet deck in time, in a notebook or a Voila page: plan of the deck, force and wetted area.

It plays and answers the pointer in the browser; only the time, at most twice a second, and choices of the
reader pass between page and kernel. Beside a `workbench.scene.sea_view.SeaView` it follows the time of that
view, and leads it, in the browser alone.
"""

import uuid
from pathlib import Path

import anywidget
import numpy as np
import traitlets
import xarray as xr

from workbench import quantities
from workbench.errors import InputError
from workbench.scene.deck_packing import packed_history
from workbench.scene.sea_view import SeaView

STATIC = Path(__file__).parent / "static"


class DeckView(anywidget.AnyWidget):
    """The wet deck in plan with its pressure, playing.

    Attributes
    ----------
    time : instant shown [s]; may be set.
    playing : whether the film runs; may be set.
    choices : [name, label, [[value, words], ...]] above the picture; chosen : name to value, set by the reader.
    notes : sentences about the limits of what is shown.
    link : name that this view shares with the view that it follows; empty where it plays by itself.
    message : a sentence that stands in place of the picture, such as why there is none.
    old : whether the picture belongs to former inputs.
    """

    _esm = STATIC / "deck_view.js"
    _css = STATIC / "deck_view.css"

    facts = traitlets.Dict().tag(sync=True)
    pressure = traitlets.Bytes(b"").tag(sync=True)
    curves = traitlets.Bytes(b"").tag(sync=True)
    revision = traitlets.Int(0).tag(sync=True)
    time = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    choices = traitlets.List().tag(sync=True)
    chosen = traitlets.Dict().tag(sync=True)
    notes = traitlets.List(traitlets.Unicode()).tag(sync=True)
    link = traitlets.Unicode("").tag(sync=True)
    message = traitlets.Unicode("").tag(sync=True)
    old = traitlets.Bool(False).tag(sync=True)

    def show(
        self,
        history: xr.Dataset,
        *,
        title: str = "",
        slow: float = 10.0,
        origin: float = 0.0,
        time: float | None = None,
        notes: tuple[str, ...] | None = None,
    ) -> None:
        """Show another history in place.

        Parameters
        ----------
        history : as `workbench.scene.deck_packing.packed_history` takes it, with title, slow and origin.
        time : first instant shown [s]; None shows that of the largest force.
        notes : sentences under the picture; None takes the warnings of the history.
        """
        packed = packed_history(history, title=title, slow=slow, origin=origin)
        if time is None:
            time = float(history.time[int(np.argmax(history.deck_force.values))])
        first, step = packed["facts"]["start"], packed["facts"]["step"]
        last = first + step * (packed["facts"]["count"] - 1)
        with self.hold_sync():
            for name, value in packed.items():
                setattr(self, name, value)
            self.time = min(max(time, first), last)
            self.notes = list(quantities.warnings_of(history) if notes is None else notes)
            self.message = ""
            self.old = False
            self.revision += 1

    def follow(self, sea_view: SeaView) -> None:
        """Tie the time of this view to that of a film over the same stretch, in the browser."""
        self.link = sea_view.link = sea_view.link or f"film-{uuid.uuid4().hex[:12]}"


def deck_view(history: xr.Dataset, title: str = "") -> DeckView:
    """View of one slam, or of a stretch of a film, in time.

    Parameters
    ----------
    history : of `workbench.pressure_stage.slam_history`, or a scene of `workbench.animation` with the pressure
        of the wet-deck theory.
    title : words above the picture.
    """
    if "deck_pressure" not in history and "pressure" in history:
        return scene_deck_view(history, title)
    view = DeckView()
    start = float(history.time[0] - (history.time[1] - history.time[0]) / 2)
    view.show(history, title=title or f"Slam at {start:.1f} s of the record", origin=start)
    return view


def scene_deck_view(scene: xr.Dataset, title: str = "") -> DeckView:
    """View of the deck of a scene, in its time; `InputError` where the scene has no force over the deck."""
    view = DeckView()
    view.show(scene_history(scene), title=title or "Pressure over the wet deck, unrolled", slow=1.0)
    return view


def scene_history(scene: xr.Dataset) -> xr.Dataset:
    """Pressure over the deck of a scene as `DeckView.show` takes it."""
    if "deck_force" not in scene:
        raise InputError(
            "The scene holds no force over the deck; make it with the pressure of the wet-deck theory."
        )
    kept = ["pressure", "deck_force", "deck_force_x", "deck_force_y", "wetted_area"]
    return scene[kept].rename(pressure="deck_pressure")
