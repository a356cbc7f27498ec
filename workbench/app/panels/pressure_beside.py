"""Cards beside the computed pressures: how often each pressure is exceeded, and what classification rules ask for."""

import numpy as np
import xarray as xr

from workbench.app.model import DeckSlams
from workbench.app.panels.deck_slams import Card, DeckSlamsPanel
from workbench.app.panels.panel import Drawing, card, table
from workbench.figures.pressure_statistics import exceedance_figure
from workbench.figures.style import message_figure, number_words
from workbench.slamming.pressure_statistics import counted_exceedance, joint_exceedance

LEVELS = 60
"""Pressures of an exceedance curve."""


def exceedance_card(panel: DeckSlamsPanel) -> Card:
    """Slams per hour above each pressure, at the panel with the largest pressure."""
    view = panel.view("How often a pressure is exceeded", "pressure-exceedance")

    def figure():
        found = panel.deck_slams()
        if not found.slams.sizes["slam"]:
            return message_figure("The deck stays dry in this realisation.")
        return exceedance_figure(exceedance_curves(found), hours=found.findings.slam.hours)

    def words():
        place = hardest_place(panel.deck_slams().slams)
        return f"Slams per hour above each pressure at x {place['x']:.1f} m, y {place['y']:.1f} m."

    def notes():
        found = panel.deck_slams()
        place = hardest_place(found.slams)
        return (
            f"At the panel with the largest pressure, x {place['x']:.1f} m, y {place['y']:.1f} m. The closed form is "
            f"of local peaks by the pressure law chosen, the counted one of averages over the panel.",
        )

    return Card(view, [Drawing(view, panel.deck_slams, figure, words, notes)])


def rules_card(panel: DeckSlamsPanel) -> Card:
    """Rule pressures beside computed ones."""
    made = card("<p>The slams are being computed.</p>")
    made.add_class("wb-wide")
    listed: list[DeckSlams] = []

    def refresh(is_current: bool) -> None:
        found = panel.deck_slams() if is_current else None
        (made.remove_class if found else made.add_class)("wb-is-old")
        if found is not None and listed[-1:] != [found]:
            listed[:] = [found]
            made.value = rules_table(found)

    return Card(made, refresh=refresh)


def hardest_place(slams: xr.Dataset) -> dict[str, float]:
    """Return x and y of the panel with the largest pressure of the record [m]."""
    row, column = np.unravel_index(
        int(np.argmax(slams.pressure_envelope.values)), slams.pressure_envelope.shape
    )
    return {"x": float(slams.x[row]), "y": float(slams.y[column])}


def exceedance_curves(found: DeckSlams) -> dict[str, xr.Dataset]:
    """Return the curves counted and in closed form, at the panel with the largest pressure, by name."""
    slams, slam, case = found.slams, found.findings.slam, found.findings.case
    place = hardest_place(slams)
    top = float(slams.pressure_envelope.max())
    peak = float(slam.statistics.most_probable_peak_pressure.sel(place, method="nearest"))
    levels = np.linspace(0.0, 1.3 * max(top, peak), LEVELS)
    closed = joint_exceedance(slam.moments, slam.statistics, slam.deck, levels, case.law, case.design.density)
    return {
        "wet-deck theory, counted": counted_exceedance(slams, levels).sel(place),
        "law of peak pressure": closed.sel(place, method="nearest"),
    }


def rules_table(found: DeckSlams) -> str:
    """Return the table of rule pressures, the largest computed panel pressures first."""
    from workbench.impact.rule_pressure import rule_pressures

    slams, case = found.slams, found.findings.case
    place = hardest_place(slams)
    area = slams.attrs["panel_length"] * slams.attrs["strip_width"]
    rules = rule_pressures(case.design, case.condition, panel_area=area, x=slams.x.values)
    along = slams.pressure_envelope.max("y").values
    hours = found.realised.realisation.hours
    rows = [
        _row(f"computed here: largest of {hours:g} h", along, slams.x.values, place["x"], "wet-deck theory")
    ]
    for number in range(rules.sizes["rule"]):
        one = rules.isel(rule=number)
        name = f"{one.rule_society.item()}, {one.rule_reference.item()}"
        rows.append(
            _row(name, one.rule_pressure.values, slams.x.values, place["x"], str(one.rule_standing.item()))
        )
    return table(
        "Rule pressures beside computed ones",
        ("source", f"at x = {place['x']:.1f} m [kPa]", "along the deck [kPa]", "standing"), rows,
        f"For a panel of {area:.3g} m². " + " ".join(dict.fromkeys(rules.attrs["warnings"].split("\n"))),
    )  # fmt: skip


def _row(name: str, pressure: np.ndarray, x: np.ndarray, place: float, standing: str) -> tuple[str, ...]:
    """Return the cells of a source: its pressure at a place and along the deck."""
    at, least, most = (
        np.interp(place, x, pressure) / 1e3,
        np.nanmin(pressure) / 1e3,
        np.nanmax(pressure) / 1e3,
    )
    return name, number_words(at), f"{number_words(least)} to {number_words(most)}", standing


FURTHER_CARDS = (exceedance_card, rules_card)
"""Makers of these cards, in the order of the page."""
