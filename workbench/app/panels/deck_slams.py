"""Cards of the pressure over the wet deck by the wet-deck theory: what the slams of a realisation gave.

`CARDS` is the list of the functions that make them, in the order of the page; a further card is one more
function of the panel.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

import ipywidgets as widgets

from workbench import quantities
from workbench.app.figure_view import FigureView
from workbench.app.model import DeckSlams, Model
from workbench.app.panels.panel import Drawing, card, table
from workbench.app.panels.slam_view import SlamView
from workbench.app.theory_in_use import relevant
from workbench.figures.deck_plan import deck_plan_figure
from workbench.figures.pressure import panel_pressure_histogram_figure
from workbench.figures.pressure_area import pressure_area_figure
from workbench.figures.style import number_words

LISTED = 10
"""Slams in the table."""


class DeckSlamsPanel(Protocol):
    """What a card needs of its panel."""

    model: Model
    post: Callable[[], None]

    def view(self, title: str, name: str, **others) -> FigureView:
        """Return a figure view."""
        ...

    def deck_slams(self) -> DeckSlams | None:
        """Return the slams that belong to the present findings."""
        ...


@dataclass(frozen=True, eq=False)
class Card:
    """A card: its widget, the figures in it, and what brings up to date what is no figure."""

    widget: widgets.Widget
    drawings: list[Drawing] = field(default_factory=list)
    refresh: Callable[[bool], None] = lambda is_current: None


def envelope_card(panel: DeckSlamsPanel) -> Card:
    """Largest panel pressure of the record over the deck."""
    view = panel.view("Largest panel pressure of all slams", "pressure-envelope", wide=True)

    def figure():
        found = panel.deck_slams()
        slams, deck = found.slams, found.findings.slam.deck
        if not slams.sizes["slam"]:
            return deck_plan_figure(slams.pressure_envelope, deck, nothing="the deck stays dry")
        one = slams.isel(slam=int(slams.slam_pressure.values.argmax()))
        return deck_plan_figure(
            slams.pressure_envelope, deck, mark=(float(one.slam_x), float(one.slam_y)),
            mark_label=f"largest: {number_words(one.slam_pressure / 1e3)} kPa at {float(one.slam_start):.0f} s",
        )  # fmt: skip

    def words():
        top = float(panel.deck_slams().slams.pressure_envelope.max()) / 1e3
        return (
            f"Plan of the deck with the largest panel pressure of all slams, at most {number_words(top)} kPa."
        )

    def notes():
        found = panel.deck_slams()
        return (what_it_is(found), *relevant(quantities.warnings_of(found.slams), found.findings))

    return Card(view, [Drawing(view, panel.deck_slams, figure, words, notes)])


def slam_view_card(panel: DeckSlamsPanel) -> Card:
    """One slam in time."""
    slam_view = SlamView(panel.post)
    return Card(
        slam_view.view, refresh=lambda is_current: slam_view.show(panel.deck_slams() if is_current else None)
    )


def area_card(panel: DeckSlamsPanel) -> Card:
    """Pressure against area."""
    view = panel.view("Average pressure over an area", "pressure-area")

    def words():
        slams = panel.deck_slams().slams
        return (
            f"Largest average pressure over areas from {number_words(slams.block_area.min())} m² to "
            f"{number_words(slams.block_area.max())} m²: from {number_words(slams.block_pressure.max() / 1e3)} kPa to "
            f"{number_words(slams.block_pressure.values[-1] / 1e3)} kPa."
        )

    def notes():
        return (
            "Over large areas these are upper bounds: each strip of the deck is a flow in its own plane.",
        )

    return Card(
        view,
        [
            Drawing(
                view, panel.deck_slams, lambda: pressure_area_figure(panel.deck_slams().slams), words, notes
            )
        ],
    )


def histogram_card(panel: DeckSlamsPanel) -> Card:
    """Panel pressures of all slams."""
    view = panel.view("Panel pressures of all slams", "panel-pressure-histogram")

    def figure():
        return panel_pressure_histogram_figure(panel.deck_slams().slams)

    def words():
        slams = panel.deck_slams().slams
        return f"Histogram of the largest panel pressures of {slams.sizes['slam']} slams."

    def notes():
        return (what_it_is(panel.deck_slams()),)

    return Card(view, [Drawing(view, panel.deck_slams, figure, words, notes)])


def table_card(panel: DeckSlamsPanel) -> Card:
    """The hardest slams."""
    from workbench.pressure_stage import hardest_slams

    made = card("<p>The slams are being computed.</p>")
    made.add_class("wb-wide")
    listed: list[DeckSlams] = []

    def refresh(is_current: bool) -> None:
        found = panel.deck_slams() if is_current else None
        (made.remove_class if found else made.add_class)("wb-is-old")
        if found is None or listed[-1:] == [found]:
            return
        listed[:] = [found]
        rows = []
        largest = float(found.slams.slam_force.max()) if found.slams.sizes["slam"] else 0.0
        scale, prefix = (1e6, "M") if largest >= 1e6 else (1e3, "k")
        for rank, number in enumerate(hardest_slams(found.slams, LISTED), 1):
            one = found.slams.isel(slam=int(number))
            loads = (number_words(one[name] / scale) for name in ("slam_force", "slam_impulse"))
            rows.append(
                (
                    str(rank), f"{float(one.slam_start):.1f}", f"{float(one.slam_x):.1f}", f"{float(one.slam_y):.1f}",
                    number_words(one.slam_pressure / 1e3), *loads, f"{float(one.slam_duration):.2f}",
                    number_words(one.slam_wetted_area),
                )
            )  # fmt: skip
        made.value = table(
            "The hardest slams by panel pressure",
            (
                "", "begins at [s]", "x [m]", "y [m]", "panel pressure [kPa]", f"force [{prefix}N]",
                f"impulse [{prefix}N s]",
                "duration [s]", "wetted area [m²]",
            ), rows,
            f"{what_it_is(found)} x and y are those of the hardest panel; force and wetted area are the largest of "
            "the slam.",
        )  # fmt: skip

    return Card(made, refresh=refresh)


def what_it_is(found: DeckSlams) -> str:
    """Sentence on what was computed."""
    slams, real = found.slams, found.realised.realisation
    attrs = slams.attrs
    return (
        f"{slams.sizes['slam']} slams in {real.hours:g} h of seed {int(real.seed)}, averaged over panels of "
        f"{attrs['panel_length']:.3g} m by {attrs['strip_width']:.3g} m and over {1e3 * attrs['time_step']:.3g} ms; "
        f"strips {'lengthwise' if attrs['strips'] == 'lengthwise' else 'across'}."
        f"{'' if found.is_whole else ' More of the record is being computed.'}"
    )


CARDS: tuple[Callable[[DeckSlamsPanel], Card], ...] = (
    envelope_card, slam_view_card, area_card, histogram_card, table_card,
)  # fmt: skip
"""Makers of the cards, in the order of the page."""
