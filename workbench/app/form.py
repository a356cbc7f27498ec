"""The form with all inputs, drawn by the browser from a description; it knows nothing of what they mean."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import anywidget
import traitlets

STATIC = Path(__file__).parent / "static"


class Form(anywidget.AnyWidget):
    """Groups of number boxes with sliders and choices, each with its label, note and problem.

    Attributes
    ----------
    groups : [key, heading, open at first]; fields : descriptions from `workbench.app.inputs.Input.as_dict`.
    values, notes, problems : by name of the field.
    designs : [name, title] to choose from; design : the chosen name.
    """

    _esm = STATIC / "form.js"

    groups = traitlets.List().tag(sync=True)
    fields = traitlets.List().tag(sync=True)
    values = traitlets.Dict().tag(sync=True)
    notes = traitlets.Dict().tag(sync=True)
    problems = traitlets.Dict().tag(sync=True)
    designs = traitlets.List().tag(sync=True)
    design = traitlets.Unicode("").tag(sync=True)
    changed = traitlets.Bool(False).tag(sync=True)

    def __init__(self, on_message: Callable[[dict[str, Any]], None], **values) -> None:
        super().__init__(**values)
        self._on_message = on_message
        self.on_msg(self._received)

    def _received(self, _widget, content, _buffers) -> None:
        if isinstance(content, dict):
            self._on_message(content)
