"""What all panels have in common: lazy building, drawing what is shown, and greying what is out of date."""

from collections.abc import Callable, Hashable
from dataclasses import dataclass

import ipywidgets as widgets
from matplotlib.figure import Figure

from workbench.app.figure_view import FigureView
from workbench.app.model import Model
from workbench.figures import style


@dataclass(frozen=True, eq=False)
class Drawing:
    """A figure of a panel.

    Parameters
    ----------
    view : on the page.
    key : what the figure depends on, or None while there is nothing to draw.
    figure : draws it; words : says in a sentence what it shows; notes : limits of its validity.
    """

    view: FigureView
    key: Callable[[], Hashable | None]
    figure: Callable[[], Figure]
    words: Callable[[], str]
    notes: Callable[[], tuple[str, ...]] = tuple


class Panel:
    """A tab. `show` is called by one thread alone."""

    title = ""
    needs_counts = False
    needs_scene = False
    needs_pressures = False

    def __init__(self, model: Model, post: Callable[[], None]) -> None:
        self.model, self.post = model, post
        self.message = widgets.HTML()
        self.message.add_class("wb-message")
        self.widget = widgets.VBox([self.message])
        self.widget.add_class("wb-panel")
        self.drawings: list[Drawing] = []
        self.parts: tuple[widgets.Widget, ...] = ()
        self._is_built = False

    def build(self) -> list[widgets.Widget]:
        """Make the widgets and fill `drawings`; called once."""
        raise NotImplementedError

    def refresh(self, is_current: bool) -> None:
        """Update what is no figure."""

    def reason(self) -> str:
        """Return a sentence why there is nothing to show, or nothing."""
        return ""

    def show(self, is_newest: Callable[[], bool], is_current: bool) -> None:
        """Bring the panel up to date, figure by figure, until something newer is wanted."""
        reason = self.reason()
        self.message.value = f"<p>{reason}</p>" if reason else ""
        if reason:
            self.widget.children = (self.message,)
            return
        if not self._is_built:
            self._is_built = True
            self.parts = tuple(self.build())
        if self.widget.children != (self.message, *self.parts):
            self.widget.children = (self.message, *self.parts)
        self.refresh(is_current)
        due = []
        for drawing in self.drawings:
            key = drawing.key() if is_current else None
            fits = key is not None and key == drawing.view.drawn_for
            drawing.view.old = not fits and bool(drawing.view.picture)
            if key is not None and not fits:
                due.append((drawing, key))
        for drawing, key in due:
            if not is_newest():
                return
            self._draw(drawing, key)

    def _draw(self, drawing: Drawing, key: Hashable) -> None:
        picture = style.picture(drawing.figure())
        with drawing.view.hold_sync():
            drawing.view.picture = picture
            drawing.view.words = drawing.words()
            drawing.view.notes = list(drawing.notes())
            drawing.view.old = False
            drawing.view.drawn_for = key

    def view(self, title: str, name: str, **others) -> FigureView:
        """Return a figure view of this panel that can be saved as SVG."""
        return FigureView(on_choice=self.post, on_save=self._save, title=title, name=name, **others)

    def _save(self, view: FigureView) -> None:
        for drawing in self.drawings:
            if drawing.view is view and drawing.key() is not None:
                view.send_file(f"{view.name}.svg", "image/svg+xml", style.picture(drawing.figure(), "svg"))


def grid(*children: widgets.Widget) -> widgets.Box:
    """Cards in as many columns as fit."""
    box = widgets.Box(list(children))
    box.add_class("wb-grid")
    return box


def card(content: str = "") -> widgets.HTML:
    """A card with a table or text."""
    made = widgets.HTML(content)
    made.add_class("wb-card")
    return made


def table(heading: str, columns: tuple[str, ...], rows: list[tuple[str, ...]], note: str = "") -> str:
    """HTML of a table; the cells are text and are escaped."""
    from html import escape

    head = "".join(f"<th scope='col'>{escape(column)}</th>" for column in columns)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    below = f"<p class='wb-note'>{escape(note)}</p>" if note else ""
    return (
        f"<h2>{escape(heading)}</h2><div class='wb-scroll'><table class='wb-table'><thead><tr>{head}</tr>"
        f"</thead><tbody>{body}</tbody></table></div>{below}"
    )
