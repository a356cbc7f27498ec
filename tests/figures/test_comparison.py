"""Several ships in one picture: every line is that of its ship."""

import numpy as np
import pytest

from workbench.errors import InputError
from workbench.figures.comparison import motions_comparison_figure
from workbench.hulls import library
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.sailing import sailing_motions

COARSE = StripSettings(formulation="heave-only", stations=11, panels=12, frequencies=8)
DIRECTIONS = np.radians([180.0, 135.0])


@pytest.fixture(scope="module")
def sets():
    omega = np.linspace(0.4, 2.0, 6)
    ships = {"catamaran": "catamaran-35", "trimaran": "trimaran-35"}
    return {
        label: sailing_motions(library.design(name), 7.7, omega, DIRECTIONS, settings=COARSE)
        for label, name in ships.items()
    }


def test_lines_are_the_amplitudes_of_their_ships(sets):
    figure = motions_comparison_figure(sets, wave_direction=2.3)
    heave, roll, pitch = figure.axes
    for index, one in enumerate(sets.values()):
        drawn = heave.get_lines()[index]
        np.testing.assert_allclose(drawn.get_xdata(), one.encounter_frequency.values[:, 1])
        np.testing.assert_allclose(drawn.get_ydata(), np.abs(one.motion_rao.values[:, 1, 2]))
        turned = np.degrees(np.abs(one.motion_rao.values[:, 1, 4]))
        np.testing.assert_allclose(pitch.get_lines()[index].get_ydata(), turned)
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["catamaran", "trimaran"]
    assert roll.get_title(loc="left") == "roll [deg/m]"
    figure.canvas.draw()


def test_ships_or_modes_that_cannot_be_drawn_are_refused(sets):
    with pytest.raises(InputError, match="ships in one picture must be 1 to 4, got 0"):
        motions_comparison_figure({}, wave_direction=0.0)
    with pytest.raises(InputError, match="mode of the picture must be one of"):
        motions_comparison_figure(sets, wave_direction=0.0, modes=("rol",))
