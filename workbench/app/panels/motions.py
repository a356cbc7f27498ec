"""Motions: response in regular waves, and statistics in the sea."""

import numpy as np

from workbench import quantities
from workbench.app.method_inputs import theory_words
from workbench.app.panels.panel import Drawing, Panel, card, grid, table
from workbench.app.theory_in_use import relevant, theories_of
from workbench.conventions import MODES, ROTATIONS
from workbench.figures import motions as figures
from workbench.figures import style
from workbench.hydrodynamics.gap_resonance import GapResonance, gap_resonance
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.motions import lead_over_wave

_NOISE = 1e-8
WHAT = [["three", "heave, roll and pitch, with phases"], ["six", "all six motions"]]


class MotionsPanel(Panel):
    """Motions per wave amplitude, and their standard deviations."""

    title = "Motions"

    def build(self):
        """Make the figure and the table."""
        axes = [[name, name] for name in figures.ABSCISSAE]
        self.rao = self.view(
            "Motions per metre of wave amplitude", "motions", wide=True,
            choices=[["what", "Motions shown", WHAT], ["over", "Drawn over", [["", ""]]]],
        )  # fmt: skip
        self.rao.choices = [
            ["what", "Motions shown", WHAT],
            ["over", "Drawn over", [[a, f"over {b}"] for a, b in axes]],
        ]
        self.rao.chosen = {"what": "three", "over": "wave frequency"}
        self.drawings = [Drawing(self.rao, self._key, self._figure, self._words, self._notes)]
        self.statistics = card()
        self.statistics.add_class("wb-wide")
        self.statistics.add_class("wb-beside")
        return [grid(self.rao, self.statistics)]

    def _key(self):
        found = self.model.findings
        chosen = self.rao.chosen
        return found and (found.ship, found.case.condition.wave_direction, chosen["what"], chosen["over"])

    def _figure(self):
        found = self.model.findings
        ship, chosen = found.ship, self.rao.chosen
        others = {
            "wave_direction": found.case.condition.wave_direction, "length": ship.design.hull.length,
            "abscissa": chosen["over"], "gap_frequency": gap_frequency(ship),
        }  # fmt: skip
        if chosen["what"] == "six":
            return figures.six_motions_figure(ship.motions, **others)
        return figures.motions_figure(ship.motions, lead_over_wave(ship.motions), **others)

    def _words(self):
        found = self.model.findings
        heading = np.degrees(found.case.condition.wave_direction)
        return f"Motions per wave amplitude over {self.rao.chosen['over']}, heading {heading:.0f} degrees."

    def _notes(self):
        sign = "Phases lead the wave elevation at the centre of gravity; pitch is positive bow down."
        found = self.model.findings
        origin = f"Computed by {theory_words(theories_of(found.case))}."
        return (origin, sign, *relevant(quantities.warnings_of(found.ship.motions), found))

    def refresh(self, is_current: bool) -> None:
        """Fill the table of statistics."""
        found = self.model.findings
        if found is None or not hasattr(self, "statistics"):
            return
        (self.statistics.remove_class if is_current else self.statistics.add_class)("wb-is-old")
        if found.slam is None:
            return
        values = found.slam.motion_statistics
        rows = []
        for index, mode in enumerate(MODES):
            turn = mode in ROTATIONS
            factor, unit = (180 / np.pi, "°") if turn else (1.0, " m")
            cells = [
                values[name].values[index] * factor
                for name in ("motion_std", "velocity_std", "acceleration_std")
            ]
            ends = (unit, f"{unit}/s", f"{unit}/s²")
            rows.append(
                (
                    mode,
                    *(f"{_words(cell)}{end}" for cell, end in zip(cells, ends, strict=True)),
                    f"{_words(4 * cells[0])}{unit}",
                )
            )
        self.statistics.value = table(
            "Motions in this sea",
            ("", "motion σ", "velocity σ", "acceleration σ",
             "height 4σ"),
            rows, "At the centre of gravity. σ: standard deviation; 4σ: significant height, from trough to crest.",
        )  # fmt: skip

    def reason(self) -> str:
        """Say why there is nothing to show."""
        return "" if self.model.findings else "The motions are being computed."


def gap_frequency(ship) -> float | None:
    """Estimated resonance of the water between two hulls at rest, where it is in the motions [rad/s]."""
    hull, theory = ship.design.hull, ship.settings
    if isinstance(theory, RecommendedSettings):
        theory = theory.strip if theory.quick else theory.potential_flow
    if ship.speed > 0 or hull.count != 2 or isinstance(theory, HighSpeedSettings):
        return None
    return gap_frequencies(ship).piston if theory.interacts(hull.count, ship.speed, hull.length) else None


def gap_frequencies(ship) -> GapResonance:
    """Estimated resonances of the water between two hulls, whichever theory is used."""
    hull, afloat = ship.design.hull, ship.hydrostatics
    draught = float(afloat.volume / afloat.waterplane_area)
    return gap_resonance(hull.spacing - hull.shape.beam, hull.shape.beam, draught)


def _words(value: float) -> str:
    """Return a number in words, 0 for what is only noise."""
    return style.number_words(value) if value > _NOISE else "0"
