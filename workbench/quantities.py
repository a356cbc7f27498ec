"""The one table of names: what each quantity is called, its unit and its symbol; and the maker of result Datasets.

Every variable and coordinate of every result carries ``units``, ``long_name``
and ``symbol`` from this table. A name that is not here cannot enter a result.
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import xarray as xr

from workbench import __version__


class Quantity(NamedTuple):
    """Unit (SI, '1' if none), label for axes, and symbol (matplotlib mathtext)."""

    units: str
    long_name: str
    symbol: str


TABLE: dict[str, Quantity] = {
    # coordinates
    "omega": Quantity("rad/s", "wave frequency", r"$\omega$"),
    "encounter_omega": Quantity("rad/s", "encounter frequency of the solution", r"$\omega_e$"),
    "wave_direction": Quantity("rad", "wave direction", r"$\beta$"),
    "x": Quantity("m", "distance forward of amidships", "$x$"),
    "y": Quantity("m", "distance to port of the centreline", "$y$"),
    "z": Quantity("m", "height above still water", "$z$"),
    "time": Quantity("s", "time", "$t$"),
    "clearance": Quantity("m", "wet-deck clearance", "$d$"),
    "vertex": Quantity("1", "vertex number", "$i$"),
    "face": Quantity("1", "panel number", "$i$"),
    "corner": Quantity("1", "corner number", "$i$"),
    "axis": Quantity("1", "axis", ""),
    "component": Quantity("1", "wave component number", "$j$"),
    "event": Quantity("1", "slam number", "$i$"),
    "velocity_class": Quantity("1", "class of entry velocity squared", "$i$"),
    "point": Quantity("1", "point number", "$i$"),
    "variant": Quantity("1", "number of the variant, the base first", "$i$"),
    "condition": Quantity("1", "number of the condition", "$j$"),
    "dof": Quantity("1", "mode of motion", "$j$"),
    "radiating_dof": Quantity("1", "mode that moves", "$k$"),
    "influenced_dof": Quantity("1", "mode that feels", "$j$"),
    "frame": Quantity("1", "part of the wave field", ""),
    "field_x": Quantity("m", "distance forward of amidships", "$x$"),
    "field_y": Quantity("m", "distance to port of the centreline", "$y$"),
    "sea_x": Quantity("m", "distance forward of amidships", "$x$"),
    "sea_y": Quantity("m", "distance to port of the centreline", "$y$"),
    # design and hydrostatics
    "volume": Quantity("m3", "volume of displacement", r"$\nabla$"),
    "displacement": Quantity("kg", "displacement", r"$\Delta$"),
    "waterplane_area": Quantity("m2", "waterplane area", "$A_w$"),
    "wetted_surface": Quantity("m2", "wetted surface", "$S$"),
    "centre_of_buoyancy": Quantity("m", "centre of buoyancy", "$x_B$"),
    "centre_of_flotation": Quantity("m", "centre of flotation", "$x_F$"),
    "transverse_metacentric_height": Quantity("m", "transverse metacentric height", "$GM_T$"),
    "longitudinal_metacentric_height": Quantity("m", "longitudinal metacentric height", "$GM_L$"),
    "block_coefficient": Quantity("1", "block coefficient of one hull", "$C_B$"),
    "hydrostatic_stiffness": Quantity("N/m, N, N m", "hydrostatic stiffness", "$C_{jk}$"),
    "steady_elevation": Quantity("m", "rise of the water by the ship's own wave", r"$\zeta_s$"),
    "running_sinkage": Quantity("m", "sinkage of the centre of gravity at speed, down", "$s$"),
    "running_trim": Quantity("rad", "trim at speed, bow down", r"$\theta_s$"),
    "stiffness_correction": Quantity(
        "N/m, N, N m", "change of hydrostatic stiffness at speed", r"$\Delta C_{jk}$"
    ),
    "mass_matrix": Quantity("kg, kg m, kg m2", "mass matrix", "$M_{jk}$"),
    "height": Quantity("m", "height of the wet deck above still water", "$z_d$"),
    "slope_x": Quantity("1", "longitudinal slope of the wet deck", r"$\partial z_d/\partial x$"),
    "slope_y": Quantity("1", "transverse slope of the wet deck", r"$\partial z_d/\partial y$"),
    "area": Quantity("m2", "area of the wet deck at the point", "$a$"),
    # hydrodynamics
    "added_mass": Quantity("kg, kg m, kg m2", "added mass", "$A_{jk}$"),
    "radiation_damping": Quantity("kg/s, kg m/s, kg m2/s", "radiation damping", "$B_{jk}$"),
    "excitation_force": Quantity("N/m, N", "wave exciting force per wave amplitude", "$F_j$"),
    "froude_krylov_force": Quantity("N/m, N", "Froude-Krylov force per wave amplitude", "$F^I_j$"),
    "diffraction_force": Quantity("N/m, N", "diffraction force per wave amplitude", "$F^D_j$"),
    "encounter_frequency": Quantity("rad/s", "encounter frequency", r"$\omega_e$"),
    "wavenumber": Quantity("rad/m", "wave number", "$k$"),
    "damping": Quantity("kg/s, kg m/s, kg m2/s", "damping beside radiation", "$B_{jk}$"),
    "stiffness": Quantity("N/m, N, N m", "stiffness beside hydrostatics", "$C_{jk}$"),
    "radiation_potential": Quantity("m2", "radiation potential per unit velocity", r"$\varphi_k$"),
    "radiated_elevation": Quantity("m/m, m/rad", "radiated wave elevation per motion amplitude", r"$\eta_k$"),
    "diffracted_elevation": Quantity("m/m", "diffracted wave elevation per wave amplitude", r"$\eta_D$"),
    "panel_centre": Quantity("m", "panel centre", "$x$"),
    "panel_normal": Quantity("1", "panel normal, outward", "$n$"),
    "panel_is_transom": Quantity("1", "panel of a transom", ""),
    "panel_area": Quantity("m2", "panel area", "$a$"),
    # motions
    "motion_rao": Quantity("m/m, rad/m", "motion per wave amplitude", r"$\xi_j/\zeta_a$"),
    "theory": Quantity("1", "theory of the motions", ""),
    "theory_name": Quantity("1", "theory of the motions in words", ""),
    "series": Quantity("1", "measured series", ""),
    "wavelength_over_length": Quantity("1", "wavelength over ship length", r"$\lambda/L$"),
    "motion_ratio": Quantity("1", "heave over wave amplitude, pitch over wave slope", r"$|\xi_j|/\zeta_j$"),
    "motion_lead": Quantity("rad", "lead over the wave at the centre of gravity", r"$\epsilon_j$"),
    "peak_ratio": Quantity("1", "largest heave over amplitude, pitch over slope", r"$(|\xi_j|/\zeta_j)_p$"),
    "peak_wavelength": Quantity("1", "wavelength of the peak over ship length", r"$\lambda_p/L$"),
    "mean_difference": Quantity("1", "mean difference over the measured peak", r"$\Delta$"),
    "lead_difference": Quantity("rad", "mean difference of phase", r"$\Delta\epsilon$"),
    "computing_time": Quantity("s", "time of computing", "$t$"),
    "wave_at_reference": Quantity("m/m", "wave elevation at the centre of gravity", r"$\zeta_G$"),
    "relative_motion": Quantity("m/m", "relative motion per wave amplitude", r"$r/\zeta_a$"),
    "relative_velocity": Quantity("m/s/m", "relative velocity per wave amplitude", r"$\dot r/\zeta_a$"),
    "relative_slope": Quantity("1/m", "relative slope along the deck per wave amplitude", r"$r_x/\zeta_a$"),
    "wave_spectrum": Quantity("m2 s/rad", "wave spectrum", r"$S_\zeta$"),
    # statistics
    "significant_wave_height": Quantity("m", "significant wave height", "$H_s$"),
    "peak_period": Quantity("s", "peak period", "$T_p$"),
    "motion_std": Quantity("m, rad", "standard deviation of motion", r"$\sigma_j$"),
    "velocity_std": Quantity("m/s, rad/s", "standard deviation of velocity", r"$\dot\sigma_j$"),
    "acceleration_std": Quantity("m/s2, rad/s2", "standard deviation of acceleration", r"$\ddot\sigma_j$"),
    "relative_motion_std": Quantity("m", "standard deviation of relative motion", r"$\sigma_r$"),
    "relative_velocity_std": Quantity("m/s", "standard deviation of relative velocity", r"$\sigma_{\dot r}$"),
    "relative_slope_std": Quantity("1", "standard deviation of relative slope", r"$\sigma_{r_x}$"),
    "velocity_slope_covariance": Quantity(
        "m/s", "covariance of relative velocity and relative slope", r"$\sigma_{\dot r r_x}$"
    ),
    "motion_slope_covariance": Quantity(
        "m", "covariance of relative motion and relative slope", r"$\sigma_{r r_x}$"
    ),
    "upcrossing_rate": Quantity("1/s", "zero up-crossing rate of relative motion", r"$\nu_0$"),
    "slamming_probability": Quantity("1", "probability of a slam per cycle of relative motion", "$P$"),
    "slamming_rate": Quantity("1/s", "slamming rate", r"$\nu$"),
    "slams_per_hour": Quantity("1/h", "slams per hour", "$N$"),
    "slams_per_100_encounters": Quantity("1", "slams per 100 encounters", "$N_{100}$"),
    "change_of_slams": Quantity("1", "change of the number of slams against the base", r"$\Delta N/N$"),
    "worst_x": Quantity("m", "place of the point that slams most, forward of amidships", "$x$"),
    "mean_entry_velocity": Quantity("m/s", "mean entry velocity", r"$\bar v$"),
    "most_probable_entry_velocity": Quantity("m/s", "most probable largest entry velocity", r"$\hat v$"),
    "most_probable_peak_pressure": Quantity("Pa", "most probable largest peak pressure", r"$\hat p$"),
    "required_height": Quantity("m", "height of the wet deck that meets the criterion", "$z_{req}$"),
    "least_clearance": Quantity("m", "least clearance that meets the criterion", "$d_{min}$"),
    "counted_per_hour": Quantity("1/h", "slams counted per hour", "$N_c$"),
    "counted_band_low": Quantity("1/h", "lower end of the sampling band", "$N_-$"),
    "counted_band_high": Quantity("1/h", "upper end of the sampling band", "$N_+$"),
    # time histories and events
    "motion": Quantity("m, rad", "motion", r"$\xi_j$"),
    "linear_motion": Quantity("m, rad", "motion by linear forces", r"$\xi_j$"),
    "point_x": Quantity("m", "distance of the point forward of amidships", "$x$"),
    "point_y": Quantity("m", "distance of the point to port of the centreline", "$y$"),
    "slam_count": Quantity("1", "number of slams", "$n$"),
    "elevation": Quantity("m", "wave elevation", r"$\zeta$"),
    "relative_motion_history": Quantity("m", "relative motion", "$r$"),
    "clearance_left": Quantity("m", "clearance left", "$d - r$"),
    "pressure": Quantity("Pa", "peak impact pressure", "$p$"),
    "event_time": Quantity("s", "time of entry", "$t_i$"),
    "event_x": Quantity("m", "position of entry", "$x_i$"),
    "event_y": Quantity("m", "position of entry", "$y_i$"),
    "entry_velocity": Quantity("m/s", "entry velocity", "$v$"),
    "entry_angle": Quantity("rad", "angle between deck and water at entry", r"$\xi$"),
    "entry_pitch": Quantity("rad", "pitch at entry", r"$\theta$"),
    "peak_pressure": Quantity("Pa", "peak pressure of the entry", "$p_t$"),
    "class_limit": Quantity("m2/s2", "upper limit of entry velocity squared", "$v^2$"),
    "class_count": Quantity("1", "number of slams in the class", "$n$"),
    "component_amplitude": Quantity("m", "amplitude of the wave component", "$a_j$"),
    "component_omega": Quantity("rad/s", "frequency of the wave component", r"$\omega_j$"),
    "component_direction": Quantity("rad", "direction of the wave component", r"$\beta_j$"),
    "component_frequency": Quantity("rad/s", "encounter frequency of the component", r"$\omega_{e,j}$"),
    "component_kx": Quantity("rad/m", "longitudinal wave number of the component", "$k_x$"),
    "component_ky": Quantity("rad/m", "transverse wave number of the component", "$k_y$"),
    "component_phase": Quantity("rad", "phase of the wave component", r"$\varepsilon_j$"),
    # measured records
    "channel": Quantity("1", "channel", ""),
    "channel_unit": Quantity("1", "unit of the channel", ""),
    "level": Quantity("unit of the record", "level", "$x$"),
    "record_omega": Quantity("rad/s", "frequency of the record", r"$\omega_e$"),
    "measured": Quantity("unit of the channel", "measured value", "$y$"),
    "record_mean": Quantity("unit of the channel", "mean", r"$\bar y$"),
    "record_std": Quantity("unit of the channel", "standard deviation", r"$\sigma_y$"),
    "record_spectrum": Quantity("unit of the channel squared, s/rad", "spectrum", "$S_y$"),
    "spectrum_low": Quantity("unit of the channel squared, s/rad", "lower end of the band", "$S_-$"),
    "spectrum_high": Quantity("unit of the channel squared, s/rad", "upper end of the band", "$S_+$"),
    "mean_period": Quantity("s", "mean period", "$T_{01}$"),
    "zero_crossing_period": Quantity("s", "zero-crossing period", "$T_{02}$"),
    "wave_record_spectrum": Quantity("m2 s/rad", "spectrum of the encountered waves", r"$S_\zeta$"),
    "wave_slope_spectrum": Quantity("rad2 s/rad", "spectrum of the wave slope", r"$k^2 S_\zeta$"),
    "wave_omega": Quantity("rad/s", "wave frequency", r"$\omega$"),
    "usable": Quantity("1", "enough wave energy at the frequency", ""),
    "response_amplitude": Quantity(
        "unit of the channel per m or rad", "response per wave amplitude or slope", r"$|y|/\zeta_a$"
    ),
    "cross_amplitude": Quantity(
        "unit of the channel per m or rad", "response from the cross-spectrum", r"$|H_1|$"
    ),
    "response_lead": Quantity("rad", "lead over the wave", r"$\epsilon$"),
    "response_error": Quantity("1", "relative standard error of the response", r"$\varepsilon$"),
    "coherence": Quantity("1", "coherence squared", r"$\gamma^2$"),
    "wave_period": Quantity("s", "period between zero up-crossings", "$T$"),
    "crest": Quantity("unit of the record", "crest", "$a_+$"),
    "trough": Quantity("unit of the record", "depth of the trough", "$a_-$"),
    "double_amplitude": Quantity("unit of the record", "double amplitude", "$H$"),
    "exceedance_counted": Quantity("1", "share of crests above the level, counted", "$P_c$"),
    "exceedance_rayleigh": Quantity("1", "share of crests above the level, Rayleigh", "$P$"),
    "slam_acceleration": Quantity("m/s2", "acceleration of the slam", "$a$"),
    "slam_strength": Quantity("1", "strength of the slam over the threshold or the noise", "$s$"),
    "point_displacement": Quantity("m", "vertical displacement of the point", r"$\xi_{3i}$"),
    "point_velocity": Quantity("m/s", "vertical velocity of the point", r"$\dot\xi_{3i}$"),
    "elevation_at_point": Quantity("m", "wave elevation at the point", r"$\zeta_i$"),
    "closing_velocity": Quantity("m/s", "closing velocity of water and point", r"$-\dot Z_R$"),
    "event_vertex": Quantity("1", "number of the point", "$i$"),
    "added_resistance": Quantity(
        "N/m2", "added resistance per wave amplitude squared", r"$R_{AW}/\zeta_a^2$"
    ),
    # water entry of a section
    "panel": Quantity("1", "panel of the section", "$i$"),
    "panel_inner": Quantity("m", "inner edge of the panel, half-breadth", "$y_1$"),
    "panel_outer": Quantity("m", "outer edge of the panel, half-breadth", "$y_2$"),
    "penetration": Quantity("m", "penetration below calm water", "$h$"),
    "section_acceleration": Quantity("m/s2", "downward acceleration of the section", r"$\ddot h$"),
    "wetted_half_breadth": Quantity("m", "wetted half-breadth", "$c$"),
    "wetted_rate": Quantity("m/s", "speed of the edge of the wetted part", r"$\dot c$"),
    "section_force": Quantity("N/m", "vertical force per length, both sides", "$F$"),
    "pressure_position": Quantity("m", "half-breadth of the pressure point", "$y$"),
    "section_pressure": Quantity("Pa", "pressure on the section", "$p$"),
    "panel_pressure": Quantity("Pa", "pressure averaged over the panel", r"$\bar p$"),
    "peak_coefficient": Quantity("1", "peak pressure over dynamic pressure", "$k$"),
    "peak_height": Quantity("m", "height of the peak pressure above calm water", "$z_{max}$"),
    "jet_height": Quantity("m", "height of the jet tip above calm water", "$z_{jet}$"),
    # pressure over the wet deck
    "slam": Quantity("1", "slam number", "$i$"),
    "block": Quantity("1", "block of panels, smallest first", "$i$"),
    "deck_pressure": Quantity("Pa", "pressure averaged over the panel", r"$\bar p$"),
    "deck_force": Quantity("N", "vertical force on the deck", "$F$"),
    "deck_pitch_moment": Quantity("N m", "moment of the deck force that lifts the bow", "$M$"),
    "deck_force_x": Quantity("m", "distance of the deck force forward of amidships", "$x_F$"),
    "deck_force_y": Quantity("m", "distance of the deck force to port", "$y_F$"),
    "wetted_area": Quantity("m2", "wetted area of the deck", "$A$"),
    "root_pressure": Quantity("Pa", "largest pressure at a jet root", r"$p_{max}$"),
    "pressure_envelope": Quantity("Pa", "largest pressure averaged over the panel", r"$\bar p_{max}$"),
    "slam_start": Quantity("s", "start of the slam", "$t_1$"),
    "slam_duration": Quantity("s", "duration of the slam", "$T_s$"),
    "slam_force": Quantity("N", "largest vertical force of the slam", "$F_{max}$"),
    "slam_impulse": Quantity("N s", "impulse of the upward force of the slam", "$I$"),
    "slam_force_x": Quantity("m", "distance forward of amidships of the largest force", "$x_F$"),
    "slam_force_y": Quantity("m", "distance to port of the largest force", "$y_F$"),
    "slam_pressure": Quantity("Pa", "largest pressure of the slam averaged over a panel", r"$\bar p_{max}$"),
    "slam_x": Quantity("m", "distance forward of amidships of the largest pressure", "$x$"),
    "slam_y": Quantity("m", "distance to port of the largest pressure", "$y$"),
    "slam_wetted_area": Quantity("m2", "largest wetted area of the slam", "$A_{max}$"),
    "slam_root_pressure": Quantity("Pa", "largest pressure of the slam at a jet root", r"$p_{max}$"),
    "slam_is_whole": Quantity("1", "whether the slam begins and ends within the record", ""),
    "slam_panel_pressure": Quantity(
        "Pa", "largest pressure of the slam averaged over the panel", r"$\bar p_{max}$"
    ),
    "slam_block_pressure": Quantity(
        "Pa", "largest pressure of the slam averaged over a block", r"$\bar p_{max}$"
    ),
    "block_area": Quantity("m2", "area of the block of panels", "$A$"),
    "block_pressure": Quantity("Pa", "largest pressure averaged over a block of panels", r"$\bar p_{max}$"),
    # immersions of the deck and fitted slams
    "immersion_count": Quantity("1", "number of immersions", "$n$"),
    "immersion_duration": Quantity("s", "duration of the immersion", r"$\Delta t$"),
    "immersion_depth": Quantity("m", "deepest immersion", r"$\delta$"),
    "immersion_angle": Quantity("rad", "angle between deck and water at deepest entry", r"$\xi$"),
    "time_of_depth": Quantity("s", "time of deepest immersion", r"$t_\delta$"),
    "wetted_duration": Quantity("s", "time under water in all", "$t_w$"),
    "longest_immersion": Quantity("s", "longest immersion", r"$\Delta t_{max}$"),
    "first_entry_time": Quantity("s", "time of the first entry", "$t_1$"),
    "deepest_entry_time": Quantity("s", "time of entry of the deepest immersion", r"$t_\delta$"),
    "ever_wet": Quantity("1", "touched by the water", ""),
    "starts_in_water": Quantity("1", "in the water at the start", ""),
    "always_wet": Quantity("1", "never out of the water", ""),
    "slam_number": Quantity("1", "slam to which the immersion belongs", "$i$"),
    "slam_spread": Quantity("s", "time from first contact to the last wetted point", r"$\Delta t$"),
    "slam_points": Quantity("1", "number of points that the slam wets", "$n$"),
    "contact_x": Quantity("m", "place of first contact", "$x_0$"),
    "contact_y": Quantity("m", "place of first contact", "$y_0$"),
    "time_since_contact": Quantity("s", "time since first contact", "$t$"),
    "panel_aft": Quantity("m", "aft edge of the panel", "$x_1$"),
    "panel_fore": Quantity("m", "fore edge of the panel", "$x_2$"),
    "impact_velocity": Quantity("m/s", "impact velocity of the panel", "$V$"),
    "wetted_length_fore": Quantity("m", "wetted length forward of first contact", "$c_f$"),
    "wetted_length_aft": Quantity("m", "wetted length aft of first contact", "$c_a$"),
    "running_impulse": Quantity("N s", "impulse since first contact", "$I$"),
    "steps": Quantity("1", "number of time steps", "$n$"),
    "nodal_force": Quantity("N", "slam load on the node", "$F_i$"),
    "lengthwise_share": Quantity("1", "lengthwise distribution of the load", "$L$"),
    "transverse_share": Quantity("1", "transverse distribution of the load", "$T$"),
    # Chuang's impact kinematics, records and design loads
    "heave_velocity": Quantity("m/s", "heave velocity at impact, downward", "$V_{hea}$"),
    "surface_velocity": Quantity("m/s", "velocity of the wave surface at the ship, downward", "$V_{wav}$"),
    "pitch_velocity": Quantity("m/s", "velocity of the point by pitching, downward", "$V_p$"),
    "attitude": Quantity("rad", "attitude of the deck at impact, bow up", r"$\theta_p$"),
    "wave_slope": Quantity("rad", "slope of the wave surface, rising to the bow", r"$\theta_w$"),
    "roll_angle": Quantity("rad", "roll at impact", r"$\theta_r$"),
    "normal_velocity": Quantity("m/s", "relative velocity normal to the wave surface", "$V_n$"),
    "tangential_velocity": Quantity("m/s", "relative velocity along the wave surface", "$V_t$"),
    "impact_angle": Quantity("rad", "impact angle", r"$\xi$"),
    "pressure_constant": Quantity("1", "pressure constant of the prediction", "$k$"),
    "recorded_constant": Quantity("1", "pressure constant from the record", "$k_c$"),
    "impact_pressure": Quantity("Pa", "impact pressure", "$p_i$"),
    "planing_pressure": Quantity("Pa", "planing pressure", "$p_p$"),
    "recorded_pressure": Quantity("Pa", "recorded peak pressure", "$p_r$"),
    "gauge": Quantity("1", "pressure gauge", ""),
    "gauge_area": Quantity("1", "area of an average over gauges", ""),
    "gauge_peak": Quantity("Pa", "largest pressure of the gauge", "$p_{max}$"),
    "gauge_peak_time": Quantity("s", "time of the gauge's largest pressure", "$t$"),
    "rise_time": Quantity("s", "rise from a tenth to the peak", "$t_r$"),
    "pulse_duration": Quantity("s", "duration above half the peak", "$t_p$"),
    "second_peak_share": Quantity("1", "second peak over the first", ""),
    "peak_gauge": Quantity("1", "gauge of the largest pressure", ""),
    "is_excluded": Quantity("1", "left out of comparisons", ""),
    "average_pressure": Quantity("Pa", "average of simultaneous gauges", r"$\bar p$"),
    "largest_average": Quantity("Pa", "largest average of simultaneous gauges", r"$\bar p_{max}$"),
    "average_time": Quantity("s", "time of the largest average", "$t$"),
    "peak_over_average": Quantity("1", "largest pressure over largest average", r"$p_{max}/\bar p$"),
    "design_pressure": Quantity("Pa", "design pressure, quasi-static", "$p_d$"),
    "design_line": Quantity("Pa", "design pressure on the centreline", "$p_0$"),
    "station": Quantity("1", "station from the fore perpendicular, 20 in the length", "$s$"),
    # wedges that enter the water, theory by theory
    "entry_theory": Quantity("1", "theory of water entry", ""),
    "deadrise_angle": Quantity("rad", "deadrise of the wedge", r"$\beta$"),
    "force_coefficient": Quantity("1", "force over rho V**3 t", "$C_F$"),
    "peak_height_ratio": Quantity("1", "height of the peak pressure over penetration", r"$z_{max}/h$"),
    "wetted_rate_ratio": Quantity("1", "speed of the edge of the wetted part over velocity", r"$\dot c/V$"),
    # statistics of slam pressure
    "pressure_level": Quantity("Pa", "pressure", "$p$"),
    "exceedance_per_hour": Quantity("1/h", "slams per hour above the pressure", "$N(p)$"),
    "exceedance_low": Quantity("1/h", "lower end of the band of the slams above the pressure", "$N_-$"),
    "exceedance_high": Quantity("1/h", "upper end of the band of the slams above the pressure", "$N_+$"),
    "exceedance_dispersion": Quantity("1", "variance of the number of slams over Poisson's", "$D$"),
    "extreme_pressure": Quantity("Pa", "pressure exceeded with the risk", r"$p_\alpha$"),
    "largest_low": Quantity("Pa", "lower end of the range of the largest pressure", "$p_-$"),
    "largest_high": Quantity("Pa", "upper end of the range of the largest pressure", "$p_+$"),
    "most_probable_low": Quantity("Pa", "lower end of the band of the most probable largest", r"$\hat p_-$"),
    "most_probable_high": Quantity("Pa", "upper end of the band of the most probable largest", r"$\hat p_+$"),
    "extreme_low": Quantity("Pa", "lower end of the band of the pressure with the risk", r"$p_{\alpha-}$"),
    "extreme_high": Quantity("Pa", "upper end of the band of the pressure with the risk", r"$p_{\alpha+}$"),
    "tail_threshold": Quantity("Pa", "threshold of the tail", "$u$"),
    "tail_count": Quantity("1", "number of slams above the threshold", "$n_u$"),
    "tail_rate": Quantity("1/h", "slams per hour above the threshold", r"$\lambda_u$"),
    "tail_scale": Quantity("Pa", "scale of the tail", r"$\sigma$"),
    "tail_shape": Quantity("1", "shape of the tail, 0 for an exponential one", r"$\xi$"),
    "class_per_hour": Quantity("1/h", "slams per hour in the class", "$N_i$"),
    "class_mean_velocity": Quantity("m/s", "mean entry velocity of the class", r"$\bar v_i$"),
    "class_pressure": Quantity("Pa", "pressure of the class", "$p_i$"),
    "share": Quantity("1", "share of the time", "$s_j$"),
    "forward_speed": Quantity("m/s", "speed", "$U$"),
    "contribution": Quantity("1", "share of the condition in the slams above the pressure", "$c_j$"),
    # studies over conditions
    "place": Quantity("1", "place on the deck", ""),
    "period": Quantity("s", "period of the sea", "$T$"),
    "worst_y": Quantity("m", "place of the point that slams most, to port of the centreline", "$y$"),
    "is_slamming": Quantity("1", "at least one slam in the time of the study", ""),
    "counted_mean_velocity": Quantity("m/s", "mean entry velocity, counted", r"$\bar v_c$"),
    # rule pressures
    "rule": Quantity("1", "rule", ""),
    "rule_pressure": Quantity("Pa", "design pressure of the rule", "$p$"),
    "rule_society": Quantity("1", "society", ""),
    "rule_reference": Quantity("1", "place of the formula", ""),
    "rule_standing": Quantity("1", "standing of the formula here", ""),
    # free surface and averages of a water entry
    "surface_point": Quantity("1", "point of the free surface", "$i$"),
    "surface_position": Quantity("m", "half-breadth of the point of the free surface", "$y_s$"),
    "surface_height": Quantity("m", "height of the free surface above calm water", "$z_s$"),
    "panel_mean": Quantity("Pa", "pressure averaged over panel and time", r"$\bar p_T$"),
    "panel_largest": Quantity("Pa", "largest pressure averaged over panel and time", r"$\bar p_{T,max}$"),
    # drawing
    "pose": Quantity("m, rad", "motion of the origin", r"$\xi_j$"),
    "hull_vertices": Quantity("m", "hull surface points", "$x$"),
    "hull_faces": Quantity("1", "hull surface faces", ""),
    "deck_height": Quantity("m", "height of the wet deck above still water", "$z_d$"),
}


def attributes(name: str) -> dict[str, str]:
    """Return the ``units``, ``long_name`` and ``symbol`` of a quantity; KeyError if it is not in the table."""
    return dict(TABLE[name]._asdict())


def labelled(dataset: xr.Dataset) -> xr.Dataset:
    """Return the Dataset with the attributes of this table on every variable and coordinate."""
    labelled_dataset = dataset.copy()
    for name in list(labelled_dataset.variables):
        labelled_dataset[name].attrs.update(attributes(str(name)))
    return labelled_dataset


def dataset(
    coords: Mapping | None = None,
    *,
    method: str = "",
    warnings: Iterable[str] = (),
    attrs: Mapping | None = None,
    **variables,
) -> xr.Dataset:
    """Make a result Dataset.

    Parameters
    ----------
    coords : as for `xarray.Dataset`.
    method : name of the method that made the result.
    warnings : sentences about limits of validity; kept in the attribute ``warnings``, a line each.
    attrs : further attributes (inputs, versions).
    **variables : as for `xarray.Dataset`, by names of the table.

    Notes
    -----
    The attribute ``version`` is the version of this package.
    """
    made = labelled(xr.Dataset(dict(variables), coords=dict(coords or {})))
    made.attrs = {"method": method, "version": __version__, **dict(attrs or {})}
    made.attrs["warnings"] = joined_warnings(warnings)
    return made


def joined_warnings(sentences: Iterable[str]) -> str:
    """Return sentences as the attribute ``warnings`` keeps them: a line each, each once, none empty."""
    return "\n".join(dict.fromkeys(sentence for sentence in sentences if sentence))


def warnings_of(*datasets: xr.Dataset) -> tuple[str, ...]:
    """Return the warnings of the Datasets, in order, each once."""
    lines = (line for one in datasets for line in str(one.attrs.get("warnings", "")).split("\n"))
    return tuple(dict.fromkeys(line for line in lines if line))


def axis_label(variable: xr.DataArray) -> str:
    """Return 'name symbol [unit]' for an axis."""
    attrs = variable.attrs
    words = f"{attrs.get('long_name', variable.name)} {attrs.get('symbol', '')}".strip()
    unit = attrs.get("units", "1")
    return words if unit == "1" else f"{words} [{unit}]"
