"""Slams of a record with their pressure over the deck go through the statistics as they come."""

import numpy as np
import pytest

from workbench import pipeline
from workbench.hulls.library import design
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.pressure_stage import RealisedDeck, slam_pressures
from workbench.seas import Condition, SeaState
from workbench.slamming.pressure_statistics import counted_exceedance
from workbench.slamming.tail_fit import deck_slams, panel_slams, tail_extremes
from workbench.time_domain import Realisation

QUICK = StripSettings(stations=21, panels=16, frequencies=12)
HOURS = 0.3


@pytest.fixture(scope="module")
def record():
    ship_design = design("austal-63")
    condition = Condition(speed=10.0, wave_direction=np.pi, sea_state=SeaState.from_mean_period(3.5, 8.0))
    ship = pipeline.response(ship_design, 10.0, [np.pi], None, QUICK)
    relative = pipeline.deck_response(ship, ship_design.wet_deck, (12, 3))
    slam = pipeline.slamming(ship, relative, ship_design.wet_deck, condition)
    realised = RealisedDeck(ship, relative, slam, ship_design.wet_deck, Realisation(hours=HOURS))
    return slam_pressures(realised)


def test_panels_of_a_record_are_counted(record):
    largest = float(record.slam_panel_pressure.max())
    found = counted_exceedance(record, np.linspace(0.0, largest, 30))
    wet = (record.slam_panel_pressure > 0).sum("slam") / HOURS
    np.testing.assert_allclose(found.exceedance_per_hour[0], wet)
    assert float(found.exceedance_per_hour[-1].max()) == 0.0
    assert (found.exceedance_low <= found.exceedance_per_hour).all()
    assert (found.exceedance_high >= found.exceedance_per_hour).all()


def test_largest_pressure_of_the_deck_is_expected_above_that_of_its_panels(record):
    number = (record.slam_panel_pressure > 0).sum("slam").values
    row, column = np.unravel_index(int(number.argmax()), number.shape)
    x, y = float(record.x[row]), float(record.y[column])
    duration = record.attrs["duration"]
    panel, deck = (
        tail_extremes(*slams, duration, 10.0, tail="exponential", count=20)
        for slams in (panel_slams(record, x, y), deck_slams(record))
    )
    assert float(deck.tail_threshold) >= float(panel.tail_threshold) > 0
    names = ("most_probable_low", "most_probable_peak_pressure", "most_probable_high")
    low, best, high = (float(deck[name]) for name in names)
    assert 0 < low < best < high
    assert best > float(record.slam_panel_pressure.max()) * 0.9
