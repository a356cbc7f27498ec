"""Pressure: what to expect over the deck, and what the slams of a realisation gave."""

import numpy as np
import xarray as xr

from workbench import quantities
from workbench.app.model import DeckSlams
from workbench.app.panels.deck_slams import CARDS
from workbench.app.panels.panel import Drawing, card, grid, table
from workbench.app.panels.pressure_beside import FURTHER_CARDS
from workbench.app.panels.slamming import SlammingPanel
from workbench.app.theory_in_use import relevant
from workbench.figures.deck_plan import deck_plan_figure
from workbench.figures.pressure import pressure_histogram_figure
from workbench.figures.style import message_figure, number_words

RANKS = 5
"""Number of counted slams, hardest first, that can be looked at."""


def slam_groups(events: xr.Dataset, gap: float, ranks: int = RANKS) -> list[np.ndarray]:
    """Indices of the entries that belong to the hardest slams, hardest slam first.

    Parameters
    ----------
    events : in time order, with ``event_time`` and ``peak_pressure`` (event).
    gap : entries nearer to each other in time than this are one slam [s].
    """
    times = events.event_time.values
    if times.size == 0:
        return []
    groups = np.split(np.arange(times.size), np.flatnonzero(np.diff(times) > gap) + 1)
    pressures = events.peak_pressure.values
    return sorted(groups, key=lambda group: -pressures[group].max())[:ranks]


def slam_pressure(events: xr.Dataset, group: np.ndarray, deck: xr.Dataset) -> xr.DataArray:
    """Largest peak pressure of one slam at every point of the deck (x, y) [Pa]."""
    own = events.isel(event=group)
    field = np.zeros(deck.height.shape)
    rows = np.searchsorted(deck.x.values, own.event_x.values)
    columns = np.searchsorted(deck.y.values, own.event_y.values)
    np.maximum.at(field, (rows, columns), own.peak_pressure.values)
    return xr.DataArray(
        field,
        coords={"x": deck.x, "y": deck.y},
        dims=("x", "y"),
        attrs=quantities.attributes("peak_pressure"),
    )


def _hardest(events: xr.Dataset, group: np.ndarray) -> xr.Dataset:
    """Return the entry of a slam that has the largest peak pressure."""
    return events.isel(event=group[int(np.argmax(events.peak_pressure.values[group]))])


class PressurePanel(SlammingPanel):
    """Pressures over the deck: expected, by the wet-deck theory in every slam, and by the law of each entry."""

    title = "Pressure"
    needs_counts = True
    needs_pressures = True

    def build(self):
        """Make the figures."""
        ranks = [["0", "the hardest slam"], *[[str(n), f"slam number {n + 1}"] for n in range(1, RANKS)]]
        self.expected = self.view("Largest peak pressure to expect", "expected-pressure", wide=True)
        self.event = self.view(
            "One slam by the law of peak pressure", "slam-pressure", wide=True, choices=[["rank", "Slam shown", ranks]],
            chosen={"rank": "0"},
        )  # fmt: skip
        self.histogram = self.view("Peak pressures of all entries", "pressure-histogram")
        self.drawings = [
            Drawing(
                self.expected,
                lambda: self.model.findings,
                self._expected_figure,
                self._expected_words,
                self._plan_notes,
            ),
            Drawing(
                self.event, self._event_key, self._event_figure, lambda: self._event()[1], self._event_notes
            ),
            Drawing(self.histogram, self._counted_key, self._histogram_figure, self._histogram_words),
        ]
        self.hardest = card()
        self.cards = [make(self) for make in (*CARDS, *FURTHER_CARDS)]
        self.drawings += [drawing for one in self.cards for drawing in one.drawings]
        computed = [one.widget for one in self.cards]
        return [grid(self.expected, *computed, self.histogram, self.hardest, self.event)]

    def deck_slams(self) -> DeckSlams | None:
        """Return the slams by the wet-deck theory that belong to the present findings."""
        slams, found = self.model.deck_slams, self.model.findings
        return slams if slams and found and slams.key == found.case.deck_pressure_key else None

    def refresh(self, is_current: bool) -> None:
        """Show the chosen slam and fill the tables of the hardest ones."""
        if not hasattr(self, "hardest"):
            return
        for one in self.cards:
            one.refresh(is_current)
        counted = self._counted() if is_current else None
        (self.hardest.remove_class if counted else self.hardest.add_class)("wb-is-old")
        if counted is None or counted is getattr(self, "_listed", None):
            return
        self._listed = counted
        rows = []
        for rank, group in enumerate(self._groups(), 1):
            one = _hardest(counted.events, group)
            rows.append(
                (
                    str(rank), f"{float(one.event_time):.1f} s", f"{float(one.event_x):.1f} m",
                    f"{float(one.entry_velocity):.2f} m/s", f"{np.degrees(float(one.entry_angle)):.1f}°",
                    f"{number_words(one.peak_pressure / 1e3)} kPa",
                )
            )  # fmt: skip
        self.hardest.value = table(
            "The hardest entries by the law of peak pressure",
            ("", "time", "x", "velocity", "angle", "peak pressure"), rows,
            "Velocity and angle at the entry with the largest pressure of each slam; entries less than "
            "a quarter of the "
            "peak period apart are one slam.",
        )  # fmt: skip

    def _expected_figure(self):
        slam = self.model.findings.slam
        field = slam.statistics.most_probable_peak_pressure
        at = np.unravel_index(int(np.argmax(field.values)), field.shape)
        return deck_plan_figure(
            field, slam.deck, mark=(float(field.x[at[0]]), float(field.y[at[1]])),
            mark_label=f"largest: {number_words(field.max() / 1e3)} kPa in {slam.hours:g} h",
            nothing=f"no slam is expected in {slam.hours:g} h",
        )  # fmt: skip

    def _expected_words(self):
        slam = self.model.findings.slam
        top = float(slam.statistics.most_probable_peak_pressure.max()) / 1e3
        return (
            f"Plan of the deck with the most probable largest peak pressure in {slam.hours:g} h, at most "
            f"{number_words(top)} kPa."
        )

    def _event_key(self):
        counted = self._counted()
        return counted and (counted, self.event.chosen["rank"])

    def _groups(self):
        gap = 0.25 * self.model.findings.slam.condition.sea_state.peak_period
        return slam_groups(self._counted().events, gap)

    def _event(self):
        counted, slam = self._counted(), self.model.findings.slam
        groups = self._groups()
        rank = int(self.event.chosen["rank"])
        if rank >= len(groups):
            return None, "Fewer slams than that were counted in this realisation."
        group = groups[rank]
        field = slam_pressure(counted.events, group, slam.deck)
        hardest = _hardest(counted.events, group)
        words = (
            f"{len(group)} entries about {float(hardest.event_time):.1f} s; the hardest, at x "
            f"{number_words(hardest.event_x)} m, "
            f"y {number_words(hardest.event_y)} m, enters at {number_words(hardest.entry_velocity)} m/s and "
            f"{np.degrees(float(hardest.entry_angle)):.2g} degrees and reaches "
            f"{number_words(hardest.peak_pressure / 1e3)} kPa."
        )
        return (field, hardest), words

    def _event_figure(self):
        found, words = self._event()
        if found is None:
            return message_figure(words, (9.7, 1.6))
        field, hardest = found
        return deck_plan_figure(
            field, self.model.findings.slam.deck, mark=(float(hardest.event_x), float(hardest.event_y)),
            mark_label=f"hardest: {number_words(hardest.peak_pressure / 1e3)} kPa",
        )  # fmt: skip

    def _plan_notes(self):
        return relevant(quantities.warnings_of(self.model.findings.slam.statistics), self.model.findings)

    def _event_notes(self):
        return (self._event()[1],)

    def _histogram_figure(self):
        slam = self.model.findings.slam
        expected = float(slam.statistics.most_probable_peak_pressure.max())
        return pressure_histogram_figure(self._counted().events, expected_peak=expected, hours=slam.hours)

    def _histogram_words(self):
        return f"Histogram of the peak pressures of {self._counted().events.sizes['event']} entries."
