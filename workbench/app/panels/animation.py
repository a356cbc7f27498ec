"""3-D: the ship in the waves in which the slams were counted."""

import xarray as xr

from workbench import quantities
from workbench.app.panels.panel import card
from workbench.app.panels.slamming import SlammingPanel
from workbench.app.theory_in_use import relevant

HEIGHT = 600


class AnimationPanel(SlammingPanel):
    """The animated view."""

    title = "3-D"
    needs_counts = True
    needs_scene = True
    sea_view = None
    height = HEIGHT

    def build(self):
        """Make the place for the view; the view comes with the first scene."""
        self.note = card(
            "<p>The animation is being built: first the slams of the realisation are counted.</p>"
        )
        self.drawings = []
        return [self.note]

    def refresh(self, is_current: bool) -> None:
        """Show the newest scene, or say that it is out of date."""
        scene = self.model.scene
        if scene is None or not hasattr(self, "note"):
            return
        if self.sea_view is None:
            from workbench.scene.deck_view import DeckView
            from workbench.scene.sea_view import sea_view

            self.sea_view = sea_view(scene, "pressure" if "pressure" in scene else "relative_motion_history")
            self.sea_view.height = self.height
            self.sea_view.add_class("wb-sea")
            self._shown = scene
            self.deck_view = DeckView()
            self.deck_view.follow(self.sea_view)
            self._show_deck(scene)
            self.parts = (self.sea_view, self.deck_view, self.note)
            self.widget.children = (self.message, *self.parts)
        elif scene is not self._shown:
            self.sea_view.show(scene)
            self._show_deck(scene)
            self._shown = scene
        fits = is_current and self.model.scene_key == self.model.findings.case.scene_key
        (self.sea_view.remove_class if fits else self.sea_view.add_class)("wb-is-old")
        self.deck_view.old = not fits
        self.note.value = (
            "<p class='wb-note'>Linear motions in a stretch of the sea about the hardest slam that was "
            "counted, without what slams do to them. Space plays, the arrow keys step.</p>"
            if fits
            else "<p>Out of date: the animation for the present inputs is being built.</p>"
        )

    def _show_deck(self, scene: xr.Dataset) -> None:
        """Show the deck of the scene under it."""
        from workbench.scene.deck_view import scene_history

        step = float(scene.time[1] - scene.time[0])
        notes = (
            f"The wet-deck theory, averaged over panels and {1e3 * scene.attrs['pressure_step']:.3g} ms; each picture "
            f"shows the largest within its {step:.2g} s, so that no slam is lost between two pictures.",
            *relevant(quantities.warnings_of(scene), self.model.findings),
        )
        self.deck_view.show(
            scene_history(scene),
            title="Pressure over the wet deck",
            slow=1.0,
            time=self.sea_view.time,
            notes=notes,
        )
        if not float(scene.pressure.max()) > 0:
            self.deck_view.message, self.deck_view.notes = (
                "The deck stays dry in this stretch of the sea.",
                [],
            )
