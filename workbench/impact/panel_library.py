"""Panels whose k, area-averaged peak pressure over rho V**2/2, is known: published ones, and computed ones.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 6.2 and tables 7.1-7.3.
"""

from dataclasses import dataclass

import numpy as np

from workbench.conventions import SEAWATER_DENSITY
from workbench.errors import InputError, checked_choice, checked_number
from workbench.impact.entry import entry
from workbench.impact.pressure import PressureLaw
from workbench.impact.section import Section, Wedge
from workbench.impact.wagner import PANEL_COEFFICIENTS, impact_pressure

DIRECTIONS = ("longitudinal", "transverse")
"""How the plane of the section lies in the ship."""
GRANDE = 'K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, Curtin University of Technology'
SLAM2D = "two-dimensional non-linear water entry by boundary elements (SLAM2D), constant velocity"
_INSTANTS, _FIRST, _WEDGE_DEPTH = 160, 0.01, 10.0


@dataclass(frozen=True, kw_only=True)
class PanelCoefficient:
    """A panel and its k.

    Parameters
    ----------
    name : by which it is chosen.
    coefficient : k, largest pressure averaged over the area of the panel over rho V**2/2 [-]; it is a matter
        of the shape alone.
    vessel, panel : whose, and which, in words.
    section_direction : of the plane of the section, one of `DIRECTIONS`.
    method, source : how k was found, and where it stands.
    """

    name: str
    coefficient: float
    vessel: str
    panel: str
    section_direction: str
    method: str
    source: str

    def __post_init__(self):
        for field in ("name", "vessel", "panel", "method", "source"):
            text = getattr(self, field)
            if not isinstance(text, str) or not text.strip():
                raise InputError(f"{field} of the panel must be text, got {text!r}; say whose k it is.")
        number = checked_number(
            f"coefficient of {self.name}", self.coefficient, above=0, at_most=1e5, cure="give k of the panel"
        )
        object.__setattr__(self, "coefficient", number)
        checked_choice(f"section direction of {self.name}", self.section_direction, DIRECTIONS)

    @property
    def law(self) -> PressureLaw:
        """Pressure law of the panel."""
        return PressureLaw(name="panel", coefficient=self.coefficient)

    def pressure(self, velocity, density: float = SEAWATER_DENSITY):
        """Pressure rho k V**2/2 [Pa] at an entry velocity [m/s] ([Grande2002]_ 6.9)."""
        return impact_pressure(velocity, self.coefficient, density)


def _published(name: str, vessel: str, panel: str, direction: str, where: str) -> PanelCoefficient:
    return PanelCoefficient(
        name=name, coefficient=PANEL_COEFFICIENTS[name], vessel=vessel, panel=panel,
        section_direction=direction, method=SLAM2D, source=f"{GRANDE}, 2002, {where}",
    )  # fmt: skip


PANELS = (
    _published(
        "austal-63 wet deck", "austal-63", "1.4 m long panel between frames of the forward wet deck",
        "longitudinal", "7.1.1 and table 7.1",
    ),
    _published(
        "crowther-318 pod", "crowther-318", "pod, wedge of 45 degrees deadrise, panel 0.4 m wide",
        "transverse", "7.1.2 and table 7.2",
    ),
    _published(
        "crowther-318 main beam", "crowther-318", "0.4 m panel under the main beam", "longitudinal",
        "7.2 and table 7.3",
    ),
)  # fmt: skip
"""The published panels."""


def panel_coefficient(name: str) -> PanelCoefficient:
    """Published panel of that name."""
    checked_choice("panel", name, [panel.name for panel in PANELS], cure="or give k as a number")
    return next(panel for panel in PANELS if panel.name == name)


def computed_panel(
    section: Section,
    inner: float,
    outer: float,
    *,
    name: str,
    vessel: str,
    panel: str,
    section_direction: str,
    method: str = "generalised-wagner",
    deepest: float | None = None,
) -> PanelCoefficient:
    """Panel whose k is computed by a theory of water entry.

    Parameters
    ----------
    section : of `workbench.impact.section`; inner, outer : edges of the panel, half-breadths [m].
    name, vessel, panel, section_direction : as in `PanelCoefficient`.
    method : of `workbench.impact.entry.entry`, one with a distribution of pressure.
    deepest : penetration up to which the largest average is sought [m]; if None, the height of the section at
        ``outer``, of a wedge 10 times that: on a steep wedge the average keeps rising towards
        the pressure at the apex.

    Notes
    -----
    Largest of the averages over the panel at 160 penetrations, each some percent deeper than the one before, at
    constant velocity. Costs some seconds for a table, tenths of a second for a wedge.
    """
    outer = checked_number("outer edge of the panel", outer, "m", above=inner)
    if method == "chuang":
        raise InputError("Chuang's k has no average over a panel; take generalised-wagner or another theory.")
    if deepest is None:
        deepest = float(section.height(np.array([outer]))[0])
        deepest *= _WEDGE_DEPTH if isinstance(section, Wedge) else 1.0
    deepest = checked_number("deepest penetration", deepest, "m", above=0)
    times = deepest * np.geomspace(_FIRST, 1.0, _INSTANTS)
    found = entry(section, 1.0, method, 1.0, times, panels=[(inner, outer)])
    return PanelCoefficient(
        name=name,
        coefficient=2.0 * float(found.panel_pressure.max()),
        vessel=vessel,
        panel=panel,
        section_direction=section_direction,
        method=f"water entry of a {section.kind}, {method}, constant velocity",
        source="computed here",
    )
