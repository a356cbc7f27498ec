"""3-D: the ship in the waves in which the slams were counted."""

from workbench.app.panels.panel import card
from workbench.app.panels.slamming import SlammingPanel

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
            from workbench.scene.sea_view import sea_view

            self.sea_view = sea_view(scene, "pressure" if "pressure" in scene else "relative_motion_history")
            self.sea_view.height = self.height
            self.sea_view.add_class("wb-sea")
            self._shown = scene
            self.parts = (self.sea_view, self.note)
            self.widget.children = (self.message, *self.parts)
        elif scene is not self._shown:
            self.sea_view.show(scene)
            self._shown = scene
        fits = is_current and self.model.scene_key == self.model.findings.case.counting_key
        (self.sea_view.remove_class if fits else self.sea_view.add_class)("wb-is-old")
        self.note.value = (
            "<p class='wb-note'>Linear motions in a stretch of the sea about the hardest slam that was "
            "counted. The deck shows "
            "the peak pressure of the latest entry of each point while it stays in the water. "
            "Space plays, the arrow keys step.</p>"
            if fits
            else "<p>Out of date: the animation for the present inputs is being built.</p>"
        )
