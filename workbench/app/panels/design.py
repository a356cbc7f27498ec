"""Design: lines, arrangement, hydrostatics, and where each figure comes from."""

from html import escape

import numpy as np

from workbench import quantities
from workbench.app.panels.motions import gap_frequencies
from workbench.app.panels.panel import Drawing, Panel, card, grid, table
from workbench.figures.hull_lines import arrangement_figure, body_plan_figure
from workbench.geometry.sections import sections, surface

_UNITS = {"m3": "m³", "m2": "m²"}


class DesignPanel(Panel):
    """What the ship is."""

    title = "Design"

    def build(self):
        """Make figures and tables."""
        self.arrangement = self.view("Profile and plan", "arrangement", wide=True)
        self.body = self.view("Body plan of one hull", "body-plan")
        self.afloat, self.sources = card(), card()
        self.sources.add_class("wb-wide")
        self.drawings = [
            Drawing(
                self.arrangement, self._key, self._arrangement_figure,
                lambda: "Profile and plan of hulls and wet deck, to scale.",
            ),
            Drawing(
                self.body, lambda: self.model.findings.ship, self._body_figure,
                lambda: "Wetted sections of one hull.",
                lambda: quantities.warnings_of(self.model.findings.ship.hydrostatics),
            ),
        ]  # fmt: skip
        return [grid(self.arrangement, self.body, self.afloat, self.sources)]

    def reason(self) -> str:
        """Say why there is nothing to show."""
        return "" if self.model.findings else "The hydrostatics are being computed."

    def _key(self):
        found = self.model.findings
        return found.ship, found.case.design.wet_deck

    def _arrangement_figure(self):
        found = self.model.findings
        design = found.case.design
        deck = found.slam.deck if found.slam else None
        return arrangement_figure(*surface(design.hull, 41, 25), deck, design.masses.centre_of_gravity)

    def _body_figure(self):
        return body_plan_figure(sections(self.model.findings.case.design.hull)[0])

    def refresh(self, is_current: bool) -> None:
        """Fill the tables."""
        found = self.model.findings
        if found is None or not hasattr(self, "afloat"):
            return
        (self.afloat.remove_class if is_current else self.afloat.add_class)("wb-is-old")
        design, ship = found.case.design, found.ship
        rows = [
            ("waterline length", f"{design.hull.length:.4g} m"),
            ("beam of the whole ship", f"{design.hull.beam:.4g} m"),
        ]
        for name in (
            "volume", "displacement", "waterplane_area", "wetted_surface", "block_coefficient",
            "transverse_metacentric_height", "longitudinal_metacentric_height",
        ):  # fmt: skip
            rows.append(
                (
                    quantities.TABLE[name].long_name,
                    _with_unit(float(ship.hydrostatics[name]), quantities.TABLE[name].units),
                )
            )
        for name, axis in (("centre_of_buoyancy", "x"), ("centre_of_flotation", "x")):
            value = float(np.ravel(ship.hydrostatics[name].values)[0])
            rows.append((f"{name.replace('_', ' ')}, {axis}", f"{value:.4g} m"))
        rows.append(("mass", _with_unit(design.masses.mass, "kg")))
        rows += gap_rows(ship)
        self.afloat.value = table("Hydrostatics as it floats", ("quantity", "value"), rows)
        standings = {"published": "published", "derived": "derived", "ours": "our own choice"}
        body = "".join(
            f"<tr><td>{escape(quantity)}</td><td>{escape(value)}</td><td><span class='wb-tag "
            f"wb-{escape(standing)}'>"
            f"{standings[standing]}</span></td><td>{escape(source)}</td></tr>"
            for quantity, value, source, standing in self.model.base.provenance
        )
        self.sources.value = (
            f"<h2>Where the figures of {escape(design.title or design.name)} come from</h2><div "
            f"class='wb-scroll'>"
            "<table class='wb-table wb-sources'><thead><tr><th scope='col'>quantity</th><th "
            "scope='col'>value</th>"
            f"<th scope='col'>standing</th><th "
            f"scope='col'>source</th></tr></thead><tbody>{body}</tbody></table></div>"
            if body
            else "<h2>Sources</h2><p class='wb-note'>This design names no sources.</p>"
        )


def gap_rows(ship) -> list[tuple[str, str]]:
    """Rows on the resonance of the water between two hulls, none for a ship without that."""
    if ship.design.hull.count != 2:
        return []
    return [
        (
            f"water between the hulls resonates ({mode}, estimate)",
            f"{frequency:.3g} rad/s, waves of {2 * np.pi / frequency:.3g} s",
        )
        for mode, frequency in gap_frequencies(ship)._asdict().items()
    ]


def _with_unit(value: float, unit: str) -> str:
    """Return a value with its unit, masses above a tonne in tonnes."""
    if unit == "kg" and value >= 1000:
        return f"{value / 1e3:.4g} t"
    return f"{value:.4g} {_UNITS.get(unit, '' if unit == '1' else unit)}".strip()
