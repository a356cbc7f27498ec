"""What the direct method counts, in closed form, against counting in records."""

import numpy as np
import pytest
import xarray as xr

from workbench import quantities
from workbench.slamming.direct_statistics import direct_statistics
from workbench.slamming.statistics import response_moments, slamming_statistics

SPEED, HEIGHT = 12.0, 1.3


@pytest.fixture(scope="module")
def sea():
    """Relative motion of one point with a slope that is partly its own, and the energy of a sea."""
    rng = np.random.default_rng(4)
    omega = np.linspace(0.5, 1.6, 60)
    met = omega + omega**2 / 9.80665 * SPEED
    rise = (1.2 + 0.4 * omega) * np.exp(1j * rng.normal(0.0, 0.05, len(omega)))
    slope = 0.12 * omega**2 * np.exp(1j * (-0.2 + rng.normal(0.0, 0.1, len(omega))))
    dims = ("omega", "wave_direction", "x", "y")

    def shaped(values):
        return dims, values[:, None, None, None]

    relative = quantities.dataset(
        {"omega": omega, "wave_direction": [np.pi], "x": [0.0], "y": [0.0]},
        method="made up",
        attrs={"speed": SPEED, "density": 1025.0},
        relative_motion=shaped(rise),
        relative_velocity=shaped(-1j * met * rise),
        relative_slope=shaped(slope),
    )
    energy = xr.DataArray(
        (0.4 * np.exp(-(((omega - 0.9) / 0.25) ** 2)))[:, None],
        coords={"omega": omega, "wave_direction": [np.pi]},
        dims=("omega", "wave_direction"),
    )
    return relative, energy, met


def height_of(value):
    return xr.DataArray([[value]], dims=("x", "y"))


def counted(sea, seeds):
    """Crossings, slams and mean velocity past the water in so many half hours, sines of irregular frequencies."""
    relative, energy, met = sea
    omega, weight = relative.omega.values, energy.values[:, 0]
    time = np.arange(0.0, 1800.0, 0.1)
    crossings, slams, velocities = 0, 0, []
    for seed in range(seeds):
        rng = np.random.default_rng(seed)
        edges = np.sort(np.concatenate([[omega[0], omega[-1]], rng.uniform(omega[0], omega[-1], 149)]))
        middle = (edges[1:] + edges[:-1]) / 2
        amplitude = np.sqrt(2 * np.interp(middle, omega, weight) * np.diff(edges))
        phase = np.exp(2j * np.pi * rng.uniform(size=len(middle)))

        def record(name, more=1.0, middle=middle, amplitude=amplitude, phase=phase):
            values = relative[name].values[:, 0, 0, 0]
            transfer = np.interp(middle, omega, values.real) + 1j * np.interp(middle, omega, values.imag)
            turning = np.exp(-1j * np.outer(time, np.interp(middle, omega, met)))
            return (turning @ (amplitude * phase * transfer * more)).real

        rise = record("relative_motion")
        past = record("relative_velocity") - SPEED * record("relative_slope")
        before = np.flatnonzero((rise[:-1] < HEIGHT) & (rise[1:] >= HEIGHT))
        share = (HEIGHT - rise[before]) / (rise[before + 1] - rise[before])
        velocity = (1 - share) * past[before] + share * past[before + 1]
        crossings += len(before)
        slams += int((velocity > 0).sum())
        velocities += velocity[velocity > 0].tolist()
    return crossings, slams, float(np.mean(velocities))


def test_slams_past_the_water_are_those_counted_in_records(sea):
    relative, energy, _ = sea
    moments = response_moments(relative, energy)
    found = direct_statistics(moments, height_of(HEIGHT))
    plain = slamming_statistics(moments, height_of(HEIGHT))
    crossings, slams, velocity = counted(sea, 4)
    share = float(found.slams_per_hour[0, 0] / plain.slams_per_hour[0, 0])
    assert 0.5 < share < 0.95  # the rule matters here
    assert slams / crossings == pytest.approx(share, abs=3 * np.sqrt(share * (1 - share) / crossings))
    assert slams / 2 == pytest.approx(float(found.slams_per_hour[0, 0]), abs=3 * np.sqrt(slams) / 2)
    assert float(found.mean_entry_velocity[0, 0]) == pytest.approx(velocity, rel=0.04)


def test_at_rest_it_is_rice_and_rayleigh(sea):
    relative, energy, _ = sea
    moments = response_moments(relative, energy).assign_attrs(speed=0.0)
    found, plain = direct_statistics(moments, height_of(0.7)), slamming_statistics(moments, height_of(0.7))
    for name in ("slams_per_hour", "mean_entry_velocity"):
        assert float(found[name][0, 0]) == pytest.approx(float(plain[name][0, 0]), rel=1e-6)


def test_scatter_of_the_slope_is_in_the_mean_velocity(sea):
    """Rates drawn from Rayleigh's distribution, slopes from the normal one about their line in height and rate."""
    relative, energy, _ = sea
    moments = response_moments(relative, energy).assign_attrs(speed=40.0)
    motion, rate, slope, on_rate, on_motion = (
        float(moments[name][0, 0])
        for name in (
            "relative_motion_std", "relative_velocity_std", "relative_slope_std", "velocity_slope_covariance",
            "motion_slope_covariance",
        )
    )  # fmt: skip
    rng = np.random.default_rng(5)
    fast = rate * np.sqrt(-2 * np.log(rng.uniform(size=400_000)))
    scatter = np.sqrt(slope**2 - on_motion**2 / motion**2 - on_rate**2 / rate**2)
    slopes = on_motion / motion**2 * HEIGHT + on_rate / rate**2 * fast + scatter * rng.normal(size=fast.size)
    past = fast - 40.0 * slopes
    found = direct_statistics(moments, height_of(HEIGHT))
    plain = slamming_statistics(moments, height_of(HEIGHT))
    share = float(found.slams_per_hour[0, 0] / plain.slams_per_hour[0, 0])
    assert share == pytest.approx(np.mean(past > 0), rel=0.03)
    assert float(found.mean_entry_velocity[0, 0]) == pytest.approx(past[past > 0].mean(), rel=0.02)
