"""Theories: the motions by each of them laid over each other, with what was measured."""

from collections.abc import Callable
from html import escape

import ipywidgets as widgets
import numpy as np

from workbench import quantities
from workbench.app.model import Model
from workbench.app.panels.panel import Drawing, Panel, card, grid, table
from workbench.conventions import froude_number
from workbench.figures.theories import theories_figure
from workbench.hydrodynamics.settings import LOW_FROUDE_NUMBER

WITH_PANELS = "with the panel method (up to a minute for a new hull)"


class TheoriesPanel(Panel):
    """Strip theory, high-speed theory and, when asked for, the panel method, for speed and heading of the page."""

    title = "Theories"

    def __init__(self, model: Model, post: Callable[[], None], compare: Callable[[bool], None]) -> None:
        super().__init__(model, post)
        self.compare = compare

    def build(self):
        """Make button, figure and table."""
        self.button = widgets.Button(description="Compare theories", tooltip="Compare theories")
        self.button.add_class("wb-data-button")
        self.button.on_click(lambda _: self.compare(bool(self.panels.value)))
        self.panels = widgets.Checkbox(value=False, description=WITH_PANELS, indent=False)
        row = widgets.HBox([self.button, self.panels])
        row.add_class("wb-button-row")
        self.state = widgets.HTML()
        top = widgets.VBox([row, self.state])
        top.add_class("wb-card")
        self.picture = self.view("Heave and pitch by each theory", "theories", wide=True)
        self.numbers = card()
        self.numbers.add_class("wb-wide")
        self.numbers.add_class("wb-beside")
        self.drawings = [
            Drawing(self.picture, self._compared, self._figure, self._words, self._notes),
        ]
        self.results = grid(self.picture, self.numbers)
        return [top, self.results]

    def reason(self) -> str:
        """Say why there is nothing to compare."""
        return "" if self.model.findings else "The first results are being computed."

    def _compared(self):
        """Return the comparison that fits the inputs, or None."""
        compared, case = self.model.compared, self.model.quiet_case()
        return compared if compared and case and compared.key == case.comparison_key else None

    def _figure(self):
        compared = self.model.compared
        return theories_figure(compared.motions, compared.measured)

    def _words(self):
        names = ", ".join(str(name) for name in self.model.compared.motions.theory_name.values)
        return f"Heave and pitch over wavelength by {names}."

    def _notes(self):
        compared = self.model.compared
        sign = "Phases lead the wave elevation at the centre of gravity; pitch is positive bow down."
        left_out = [line for line in compared.motions.attrs["left_out"].split("\n") if line]
        sources = dict.fromkeys(f"Measured: {series.attrs['source']}." for series in compared.measured)
        return (*left_out, sign, *sources, *quantities.warnings_of(compared.motions))

    def refresh(self, is_current: bool) -> None:
        """Say what a comparison would show, and fill the table."""
        if not hasattr(self, "state"):
            return
        compared, case = self._compared(), self.model.quiet_case()
        (self.results.remove_class if self.model.compared else self.results.add_class)("wb-not-yet")
        if case is not None:
            self.state.value = f"<p class='wb-note'>{escape(_condition_words(case))}</p>"
        (self.numbers.remove_class if compared else self.numbers.add_class)("wb-is-old")
        if compared is not None:
            self.numbers.value = "".join(tables(compared.motions, compared.measured))


def _condition_words(case) -> str:
    """Return for which condition theories are compared."""
    condition, hull = case.condition, case.design.hull
    froude = froude_number(condition.speed, hull.length)
    words = (
        f"For this ship at Fn {froude:.2f} in regular waves of heading "
        f"{np.degrees(condition.wave_direction):.0f} degrees, 0.4 to 3 ship lengths long."
    )
    if froude > LOW_FROUDE_NUMBER:
        return f"{words} The panel method is a rough guide at this speed."
    return words


def tables(motions, measured) -> list[str]:
    """Tables of the peaks, and of the differences from each measured series."""
    from workbench.theory_comparison import summary

    found = summary(motions, measured)
    rows = []
    for theory in found.theory.values:
        one = found.sel(theory=theory)
        cells = [
            f"{float(one[name].sel(dof=mode)):.2f}"
            for mode in ("heave", "pitch")
            for name in ("peak_ratio", "peak_wavelength")
        ]
        rows.append((str(one.theory_name.values), *cells, f"{float(one.computing_time):.1f} s"))
    made = [
        table(
            "Peaks, and what they cost",
            ("theory", "heave", "at λ/L", "pitch", "at λ/L", "time"),
            rows,
            "Heave over wave amplitude, pitch over wave slope. The time is less where the workbench knows the "
            "hull already.",
        )
    ]
    for series in found.series.values if "series" in found.coords else ():
        rows = []
        for theory in found.theory.values:
            one = found.sel(theory=theory, series=series)
            cells = [
                words
                for mode in ("heave", "pitch")
                for words in (
                    f"{float(one.mean_difference.sel(dof=mode)):.2f}",
                    f"{np.degrees(float(one.lead_difference.sel(dof=mode))):.0f}°",
                )
            ]
            rows.append((str(one.theory_name.values), *cells))
        made.append(
            table(
                f"Against the {series}",
                ("theory", "heave", "phase", "pitch", "phase"),
                rows,
                "Mean difference from the measured points over their peak; mean difference of phase.",
            )
        )
    return made
