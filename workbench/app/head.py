"""The head of the page: the verdict, what is being computed, and the guard of the session.

The guard keeps the inputs in the browser, so that a reload (also after the
kernel has died) opens the same page, writes the permalink, sends files to the
reader, and says so when the kernel is gone.
"""

from collections.abc import Callable
from typing import Any

import anywidget
import traitlets

from workbench.app.form import STATIC


class Head(anywidget.AnyWidget):
    """Verdict, progress and guard.

    Attributes
    ----------
    verdict : one sentence; tone : 'good', 'bad', 'plain' or 'old'; remark : a line below it.
    busy, progress, task : of the long work; action : '', 'stop', 'resume' or 'refine', the button that is offered.
    origin : by which theory the results were computed.
    problems : sentences why nothing can be computed; error : an unexpected one.
    state : the inputs as JSON, kept by the browser; permalink : the small ones as a query.
    """

    _esm = STATIC / "head.js"
    _css = STATIC / "app.css"

    title = traitlets.Unicode("Wet-deck workbench").tag(sync=True)
    version = traitlets.Unicode("").tag(sync=True)
    verdict = traitlets.Unicode("").tag(sync=True)
    tone = traitlets.Unicode("plain").tag(sync=True)
    remark = traitlets.Unicode("").tag(sync=True)
    busy = traitlets.Bool(False).tag(sync=True)
    progress = traitlets.Float(0.0).tag(sync=True)
    task = traitlets.Unicode("").tag(sync=True)
    action = traitlets.Unicode("").tag(sync=True)
    origin = traitlets.Unicode("").tag(sync=True)
    problems = traitlets.List().tag(sync=True)
    error = traitlets.Unicode("").tag(sync=True)
    state = traitlets.Unicode("").tag(sync=True)
    permalink = traitlets.Unicode("").tag(sync=True)

    def __init__(self, on_message: Callable[[dict[str, Any]], None], **values) -> None:
        super().__init__(**values)
        self._on_message = on_message
        self.on_msg(self._received)

    def _received(self, _widget, content, _buffers) -> None:
        if isinstance(content, dict):
            self._on_message(content)

    def send_file(self, name: str, mime: str, content: bytes) -> None:
        """Let the browser save a file."""
        self.send({"type": "file", "name": name, "mime": mime}, buffers=[content])
