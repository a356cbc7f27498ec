"""A figure on the page: picture, choices that belong to it, notes on its validity, and saving it."""

from collections.abc import Callable

import anywidget
import traitlets

from workbench.app.form import STATIC


class FigureView(anywidget.AnyWidget):
    """A picture with its title.

    Attributes
    ----------
    title : heading; picture : PNG; words : what the picture shows, for those who cannot see it.
    notes : sentences about the limits of what is shown.
    choices : [name, label, [[value, words], ...]] of the figure's own; chosen : name to value.
    old : whether the picture belongs to former inputs; wide : whether it takes two columns.
    """

    _esm = STATIC / "figure.js"

    title = traitlets.Unicode("").tag(sync=True)
    name = traitlets.Unicode("figure").tag(sync=True)
    picture = traitlets.Bytes(b"").tag(sync=True)
    words = traitlets.Unicode("").tag(sync=True)
    notes = traitlets.List().tag(sync=True)
    choices = traitlets.List().tag(sync=True)
    chosen = traitlets.Dict().tag(sync=True)
    old = traitlets.Bool(False).tag(sync=True)
    wide = traitlets.Bool(False).tag(sync=True)

    def __init__(
        self,
        on_choice: Callable[[], None] | None = None,
        on_save: Callable[["FigureView"], None] | None = None,
        **values,
    ) -> None:
        super().__init__(**values)
        self._on_choice, self._on_save = on_choice, on_save
        self.drawn_for: object = None
        self.on_msg(self._received)

    def _received(self, _widget, content, _buffers) -> None:
        if not isinstance(content, dict):
            return
        if content.get("type") == "svg" and self._on_save:
            self._on_save(self)
        known = {name: {value for value, _ in options} for name, _, options in self.choices}
        if content.get("type") == "choose" and content.get("value") in known.get(content.get("name"), ()):
            self.chosen = {**self.chosen, content["name"]: content["value"]}
            self.drawn_for = None
            if self._on_choice:
                self._on_choice()

    def send_file(self, name: str, mime: str, content: bytes) -> None:
        """Let the browser save a file."""
        self.send({"type": "file", "name": name, "mime": mime}, buffers=[content])
