"""Slamming: where, how often, what clearance helps, and whether counting agrees."""

from workbench import quantities
from workbench.app.panels.panel import Drawing, Panel, card, grid, table
from workbench.app.theory_in_use import relevant
from workbench.figures.clearance import clearance_figure
from workbench.figures.counts import counts_figure, velocity_classes_figure
from workbench.figures.deck_plan import deck_plan_figure
from workbench.figures.style import number_words
from workbench.slamming.events import velocity_classes

NO_DECK = (
    "This design has no wet deck: choose a ship with two or three hulls and a wet deck to see its slamming."
)
SHOWN = (
    ("slams_per_hour", "slams per hour"),
    ("slams_per_100_encounters", "slams per 100 encounters"),
    ("mean_entry_velocity", "mean entry velocity"),
    ("required_height", "height that meets the criterion"),
)


class SlammingPanel(Panel):
    """Closed-form and counted slams."""

    title = "Slamming"
    needs_counts = True

    def build(self):
        """Make figures and table."""
        self.plan = self.view(
            "Where the deck slams", "slams-on-deck", wide=True,
            choices=[["field", "Quantity drawn", [list(pair) for pair in SHOWN]]],
            chosen={"field": "slams_per_hour"},
        )  # fmt: skip
        self.curve = self.view("How much clearance", "clearance")
        self.counts = self.view("Counted against closed form", "counted-slams")
        self.classes = self.view("Five classes of velocity squared", "velocity-classes")
        self.numbers = card()
        self.drawings = [
            Drawing(self.plan, self._plan_key, self._plan_figure, self._plan_words, self._plan_notes),
            Drawing(self.curve, lambda: self.model.findings, self._curve_figure, self._curve_words),
            Drawing(
                self.counts, self._counted_key, self._counts_figure, self._counts_words, self._counts_notes
            ),
            Drawing(self.classes, self._counted_key, self._classes_figure, self._classes_words),
        ]
        return [grid(self.plan, self.curve, self.counts, self.classes, self.numbers)]

    def reason(self) -> str:
        """Say why there is nothing to show."""
        if self.model.base.wet_deck is None:
            return NO_DECK
        found = self.model.findings
        return "" if found is not None and found.slam is not None else "The slamming is being computed."

    def _plan_key(self):
        return self.model.findings, self.plan.chosen["field"]

    def _plan_figure(self):
        slam = self.model.findings.slam
        name = self.plan.chosen["field"]
        worst = slam.statistics.isel(slam.worst_point)
        is_rate = name == "slams_per_hour"
        return deck_plan_figure(
            slam.statistics[name], slam.deck,
            mark=(float(worst.x), float(worst.y)),
            mark_label=f"worst point: {number_words(worst.slams_per_hour)} /h",
            line_at=slam.criterion_per_hour if is_rate else None,
            line_label=f"criterion {slam.criterion_per_hour:g} /h",
            nothing="this deck does not slam in this sea",
        )  # fmt: skip

    def _plan_words(self):
        field = dict(SHOWN)[self.plan.chosen["field"]]
        return f"Plan of the wet deck with contours of {field}. {self.model.verdict()}"

    def _plan_notes(self):
        found = self.model.findings
        statistics = found.slam.statistics
        of_pressure = statistics.attrs["pressure_warnings"].split("\n")
        others = (line for line in quantities.warnings_of(statistics) if line not in of_pressure)
        return relevant(others, found)

    def _curve_figure(self):
        found = self.model.findings
        slam = found.slam
        return clearance_figure(
            found.curve, clearance=slam.clearance, slams_per_hour=float(slam.statistics.slams_per_hour.max()),
            criterion_per_hour=slam.criterion_per_hour, least_clearance=slam.least_clearance,
        )  # fmt: skip

    def _curve_words(self):
        slam = self.model.findings.slam
        least = number_words(slam.least_clearance)
        return f"Slams per hour at the worst point against clearance; {least} m meets the criterion."

    def _counted(self):
        counted, found = self.model.counted, self.model.findings
        return counted if counted and found and counted.key == found.case.counting_key else None

    def _counted_key(self):
        return self._counted()

    def share_within(self) -> float:
        """Share of the deck's points whose closed-form rate lies in the band of their count."""
        counted, exact = self._counted(), self.model.findings.slam.statistics.slams_per_hour
        low, high = counted.counts.counted_band_low, counted.counts.counted_band_high
        return float(((low <= exact) & (exact <= high)).mean())

    def _counts_figure(self):
        slam, counted = self.model.findings.slam, self._counted()
        real = self.model.findings.case.realisation
        return counts_figure(
            slam.statistics,
            counted.counts,
            column=slam.worst_point["y"],
            hours=real.hours,
            seed=int(real.seed),
        )

    def _counts_words(self):
        return (
            f"Slams counted along the deck against the closed form; {100 * self.share_within():.0f} % agree."
        )

    def _counts_notes(self):
        counted = self._counted()
        return (
            f"At {100 * self.share_within():.0f} % of the {counted.counts.counted_per_hour.size} "
            f"points of the deck the "
            "closed form lies within the 99 % sampling band of the count.",
            *quantities.warnings_of(counted.counts),
        )

    def _classes_figure(self):
        return velocity_classes_figure(velocity_classes(self._counted().events))

    def _classes_words(self):
        return "Number of entries, over all points of the deck, in five classes of entry velocity squared."

    def refresh(self, is_current: bool) -> None:
        """Fill the table of numbers."""
        found = self.model.findings
        if found is None or found.slam is None or not hasattr(self, "numbers"):
            return
        (self.numbers.remove_class if is_current else self.numbers.add_class)("wb-is-old")
        slam = found.slam
        worst = slam.statistics.isel(slam.worst_point)
        moments = slam.moments.isel(slam.worst_point)
        share = float((slam.statistics.slams_per_hour > slam.criterion_per_hour).mean())
        counted = self._counted()
        count = "being counted"
        if counted is not None:
            here = counted.counts.isel(slam.worst_point)
            count = (
                f"{number_words(here.counted_per_hour)} /h ({number_words(here.counted_band_low)} to "
                f"{number_words(here.counted_band_high)})"
            )
        rows = [
            ("place, x and y", f"{number_words(worst.x)} m, {number_words(worst.y)} m"),
            ("slams per hour", f"{number_words(worst.slams_per_hour)} /h"),
            ("counted (99 % band)", count),
            ("slams per 100 encounters", f"{number_words(worst.slams_per_100_encounters)}"),
            ("relative motion σ", f"{number_words(moments.relative_motion_std)} m"),
            ("relative velocity σ", f"{number_words(moments.relative_velocity_std)} m/s"),
            ("least velocity that counts", f"{number_words(slam.threshold)} m/s"),
            ("mean entry velocity", f"{number_words(worst.mean_entry_velocity)} m/s"),
            (
                f"largest entry velocity in {slam.hours:g} h",
                f"{number_words(worst.most_probable_entry_velocity)} m/s",
            ),
            (
                f"largest peak pressure in {slam.hours:g} h",
                f"{number_words(worst.most_probable_peak_pressure / 1e3)} kPa",
            ),
            ("least clearance for the criterion", f"{number_words(slam.least_clearance)} m"),
            ("deck that slams more often than allowed", f"{100 * share:.0f} %"),
        ]
        self.numbers.value = table("The worst point", ("quantity", "value"), rows)
