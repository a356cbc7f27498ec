"""Responses per wave amplitude or wave slope, from spectra of records.

.. [Grande2002] K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis,
    Curtin University of Technology, 2002, 3.2 (eqs 3.1, 3.2).
.. [BendatPiersol2010] J. S. Bendat and A. G. Piersol, "Random data", 4th ed., 2010, 6.1, 9.2.
"""

import numpy as np
import xarray as xr
from scipy import signal

from workbench import quantities
from workbench.conventions import wavenumber
from workbench.encounter import encounter_jacobian, highest_overtaking, wave_frequency
from workbench.errors import InputError, checked_number
from workbench.records.reading import channel, channel_unit
from workbench.records.spectra import (
    SpectrumSettings,
    degrees_of_freedom,
    length_notes,
    segments_in,
    slope_spectrum,
    spectral_periods,
)

LEAST_ENERGY = 0.05
"""Share of the peak of the wave spectrum below which a response is not trusted."""


def estimated_response(
    record_set: xr.Dataset,
    wave: str,
    speed: float = 0.0,
    wave_direction: float = np.pi,
    settings: SpectrumSettings | None = None,
    *,
    least_energy: float = LEAST_ENERGY,
) -> xr.Dataset:
    """Responses of all channels to the wave of one channel, over encounter frequency.

    Parameters
    ----------
    record_set : from `workbench.records.reading.record`, in the ship's frame.
    wave : name of the channel of the true wave elevation [m].
    speed : of the ship [m/s]; wave_direction : [rad], pi is head seas.
    settings : of the spectra.
    least_energy : share of the peak of the wave spectrum that makes a frequency usable.

    Returns
    -------
    Dataset over (record_omega, channel):

    ``response_amplitude``
        sqrt(S_response/S_wave); channels in rad or rad/s are per wave slope, with k^2 S.
    ``cross_amplitude``, ``response_lead``
        of the cross-spectrum over the wave spectrum, per wave amplitude or slope; lead
        over the wave where it was measured [rad].
    ``coherence``, ``response_error``
        coherence squared, and the relative standard error of ``cross_amplitude``.

    and over record_omega: ``wave_record_spectrum``, ``wave_slope_spectrum``,
    ``wave_omega`` (of the long waves, where several belong), ``usable`` (1 or 0).

    Notes
    -----
    Noise in the response raises the first estimate and leaves the second alone; noise in
    the wave lowers both ([BendatPiersol2010]_). The two differ as 1/sqrt(coherence).
    In following seas, frequencies from 0.8 of g/(4 U cos(beta)) are not usable; below
    it, energy is taken to be of the long waves.
    """
    settings = settings or SpectrumSettings()
    checked_number("least_energy", least_energy, above=0, below=1)
    if channel_unit(record_set, wave) not in ("m", "?"):
        raise InputError(f"wave must be a channel in m, {wave} is in {channel_unit(record_set, wave)}.")
    others = [str(name) for name in record_set.channel.values if str(name) != wave]
    if not others:
        raise InputError("record must hold a channel besides the wave to find a response.")
    step = float(record_set.attrs["time_step"])
    elevation = channel(record_set, wave)
    segments = segments_in(len(elevation), settings, step)
    arguments = settings.welch_arguments(step)
    omega, energy = signal.welch(elevation, **arguments)
    if not np.any(energy > 0):
        raise InputError(f"wave must have energy, channel {wave} is constant.")
    values = np.stack([channel(record_set, name) for name in others], axis=1)
    own = signal.welch(values, axis=0, **arguments)[1]
    cross = signal.csd(elevation[:, None], values, axis=0, **arguments)[1]
    wave_omega = wave_frequency(omega, speed, wave_direction)
    known = np.isfinite(wave_omega)
    k = wavenumber(np.where(known, wave_omega, 0.0))
    usable = (energy >= least_energy * energy.max()) & (omega > 0) & known
    usable &= omega < 0.8 * highest_overtaking(speed, wave_direction)
    units = [channel_unit(record_set, name) for name in others]
    rotational = np.array([unit.startswith("rad") for unit in units])
    slope = slope_spectrum(omega, energy, k)
    input_energy = np.where(rotational, slope[:, None], energy[:, None])
    scale = np.where(rotational, k[:, None], 1.0)
    floor = np.finfo(float).tiny
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        amplitude = np.sqrt(own / input_energy)
        first = cross / energy[:, None] / scale
        coherence = np.abs(cross) ** 2 / np.maximum(own * energy[:, None], floor)
        freedom = degrees_of_freedom(segments, settings)
        error = np.sqrt(np.clip(1 - coherence, 0, None) / np.maximum(coherence, 1e-12) / freedom)
    seen = usable[:, None] & np.ones(len(others), bool)
    dims = ("record_omega", "channel")
    return quantities.dataset(
        {"record_omega": omega, "channel": others, "channel_unit": ("channel", units)},
        method="spectra of records",
        warnings=(
            *quantities.warnings_of(record_set),
            *length_notes(record_set.sel(channel=[wave]), spectral_periods(omega, energy[:, None])[0]),
            *_energy_notes(omega, energy, usable, speed, wave_direction),
        ),
        attrs={
            "speed": float(speed),
            "wave_direction": float(wave_direction),
            "segments": segments,
            "degrees_of_freedom": freedom,
            "wave": wave,
        },
        response_amplitude=(dims, np.where(seen, amplitude, np.nan)),
        cross_amplitude=(dims, np.where(seen, np.abs(first), np.nan)),
        response_lead=(dims, np.where(seen, np.angle(first), np.nan)),
        coherence=(dims, np.where(seen, coherence, np.nan)),
        response_error=(dims, np.where(seen, error, np.nan)),
        wave_record_spectrum=("record_omega", energy),
        wave_slope_spectrum=("record_omega", slope),
        wave_omega=("record_omega", wave_omega),
        usable=("record_omega", usable.astype(int)),
    )


def phasor(response: xr.Dataset, name: str) -> np.ndarray:
    """Complex response of a channel with this package's exp(-i omega_e t), per wave where it was measured."""
    one = response.sel(channel=name)
    return one.cross_amplitude.values * np.exp(-1j * one.response_lead.values)


def _energy_notes(omega, energy, usable, speed: float, wave_direction: float) -> list[str]:
    """Sentences about energy where the encounter is not single-valued."""
    most = highest_overtaking(speed, wave_direction)
    if not np.isfinite(most):
        return []
    lost = np.trapezoid(np.where(usable, 0.0, energy), omega) / np.trapezoid(energy, omega)
    slowest = np.min(np.abs(encounter_jacobian(wave_frequency(omega[usable], speed, wave_direction), speed,
                                               wave_direction)), initial=1.0)  # fmt: skip
    return [
        f"In following seas several waves share an encounter frequency; responses are given below 0.8 of {most:.3g} "
        f"rad/s as of the long waves (Jacobian down to {slowest:.2g}), {100 * lost:.0f} % of the energy is left out."
    ]
