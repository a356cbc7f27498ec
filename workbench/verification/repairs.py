"""Equations that K. Grande's thesis prints wrong or damaged: what was done about each, where, and what proves it.

The thesis: K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, Curtin University of
Technology, 2002. Each is either a *switch* between the printed and the repaired form, or a *choice* of the
repaired form, whose derivation a test repeats; one is *not used*.
"""

from dataclasses import dataclass
from typing import Any

from workbench.errors import checked_choice

STANDINGS = ("switch", "choice", "not used")


@dataclass(frozen=True, kw_only=True)
class Repair:
    """One or more equations with the same repair.

    Parameters
    ----------
    equations : their numbers in the thesis.
    repair : what is printed or wrong, and what is right.
    standing : one of `STANDINGS`.
    where : module, and after a colon the name in it, that holds the repaired form; several by semicolons.
    tests : that prove it, as file::name in the source checkout.
    """

    equations: tuple[str, ...]
    repair: str
    standing: str
    where: str
    tests: tuple[str, ...]

    def __post_init__(self) -> None:
        checked_choice(f"standing of the repair of {', '.join(self.equations)}", self.standing, STANDINGS)

    def as_dict(self) -> dict[str, Any]:
        """Return the row as plain values."""
        return {
            "equations": ", ".join(self.equations),
            "repair": self.repair,
            "standing": self.standing,
            "where": self.where,
            "tests": list(self.tests),
        }


_DERIVED = "tests/hydrodynamics/test_repaired_equations.py::test_"
_STRIP = "tests/hydrodynamics/test_strip_theory.py::test_"
_SAILS = "tests/damping/test_sail_damping.py::test_"
_POINTS = "tests/records/test_point_motion.py::test_"
_COUNTS = "tests/slamming/test_statistics.py::test_"
_HYDRO = "workbench.hydrodynamics"


def _choice(equations: str, repair: str, where: str, *tests: str, standing: str = "choice") -> Repair:
    return Repair(
        equations=tuple(equations.split()), repair=repair, standing=standing, where=where, tests=tests
    )


REPAIRS: tuple[Repair, ...] = (
    _choice(
        "A1.56",
        "the incident potential lacks its i and has the wrong sign across; crest at the origin, phase by sin(beta)",
        f"{_HYDRO}.incident_wave:incident_potential; {_HYDRO}.high_speed_march:incident_potential",
        f"{_DERIVED}incident_potential_belongs_to_the_wave",
    ),
    _choice(
        "A1.58 A1.102",
        "potential of the steady wave in both terms; U^2 phi_xx + g phi_z = 0, orders of derivatives swapped in print",
        f"{_HYDRO}.cross_plane:passage; {_HYDRO}.own_wave:own_wave",
        f"{_DERIVED}free_water_of_the_march_obeys_its_surface_condition",
    ),
    _choice(
        "A1.63",
        "normals said to point into the fluid, forces printed for the other way; here into the fluid, signs with it",
        f"{_HYDRO}.section_waves:froude_krylov_density; {_HYDRO}.sections:sectional_matrix",
        f"{_DERIVED}speed_does_not_enter_the_froude_krylov_force",
        "tests/hydrodynamics/test_oscillating_sections.py::test_froude_krylov_force_of_a_long_wave_is_the_change_of_buoyancy",
    ),
    _choice(
        "A1.65 A1.71 A1.74 A1.86",
        "omega for omega_e, n for n_j, ds for dl; the hydrostatic pressure is in the stiffness",
        f"{_HYDRO}.speed_terms:with_speed",
        f"{_DERIVED}speed_terms_follow_from_their_derivation",
    ),
    _choice(
        "A1.87",
        "signs of U/(i omega_e) T0_2k in T_6k and T0_j2 in T_j6 are those of m_6 = -n_2",
        f"{_HYDRO}.speed_terms:with_speed",
        f"{_DERIVED}speed_terms_follow_from_their_derivation",
        f"{_STRIP}identities_of_the_cross_couplings",
    ),
    _choice(
        "A1.93",
        "Froude-Krylov force at the wave's own frequency: terms of speed cancel",
        f"{_HYDRO}.section_waves:froude_krylov_density",
        f"{_DERIVED}speed_does_not_enter_the_froude_krylov_force",
    ),
    _choice(
        "A1.95 A1.96",
        "phase across by k y sin(beta), printed cos(beta); the sign goes with i N_3 - N_2 sin(beta)",
        f"{_HYDRO}.section_waves:orbital_decay; {_HYDRO}.section_waves:haskind_density",
        f"{_DERIVED}the_phase_across_goes_with_the_sine_of_the_heading",
        "tests/hydrodynamics/test_oscillating_sections.py::test_haskind_forces_are_those_of_the_diffraction_problem",
    ),
    _choice(
        "A1.100",
        "exp(-i (omega_e/U) x) taken out of the potential, which still varies along the ship",
        f"{_HYDRO}.high_speed_march:sectional",
        f"{_DERIVED}wave_flow_of_the_march_is_the_gradient_of_its_potential_and_turns_with_the_wave_frequency",
    ),
    _choice(
        "A1.101",
        "Laplace's equation across, in y and z, printed in y and x",
        f"{_HYDRO}.cross_plane:Water",
        f"{_DERIVED}water_of_the_march_is_harmonic_in_its_cross_plane",
    ),
    _choice(
        "A1.103",
        "n_j for n; i omega_e n_j - U m_j with x aft, here x forward",
        f"{_HYDRO}.high_speed_march:sectional",
        f"{_DERIVED}hull_flow_of_the_march_is_the_derivative_past_the_hull",
    ),
    _choice(
        "A1.104",
        "i n_2 sin(beta) for i n_1, exponent i (omega/U) x for i (omega/U)",
        f"{_HYDRO}.high_speed_march:incident_normal_velocity",
        f"{_DERIVED}wave_flow_of_the_march_is_the_gradient_of_its_potential_and_turns_with_the_wave_frequency",
    ),
    _choice(
        "tau",
        "U omega_e/g, printed with omega",
        f"{_HYDRO}.high_speed_settings:tau",
        f"{_DERIVED}tau_goes_with_the_frequency_of_encounter",
    ),
    _choice(
        "2.1",
        "equation of motion at the encounter frequency",
        "workbench.motions:motions",
        f"{_DERIVED}equation_of_motion_is_at_the_frequency_of_encounter",
    ),
    _choice(
        "2.2",
        "gyradii squared; m z_G stands between surge and pitch, -m x_G between heave and pitch; the printed matrix "
        "mixes units, so that nothing can be computed with it",
        "workbench.motions:mass_matrix",
        f"{_DERIVED}mass_matrix_is_that_of_the_kinetic_energy_of_point_masses",
        "tests/test_motions.py::test_mass_matrix_is_the_repaired_one",
    ),
    _choice(
        "2.13",
        "omega_e in the speed term of the pitch moment; the lever is in f_5 and h_5",
        f"{_HYDRO}.speed_terms:force_with_speed",
        f"{_DERIVED}speed_terms_of_the_diffraction_force_follow_from_their_derivation",
    ),
    _choice(
        "2.15 2.20",
        "transom terms with U/omega_e^2 and U^2/omega_e^2, squares lost in print; B_53 and B_44 misnamed",
        f"{_HYDRO}.speed_terms:with_speed; {_HYDRO}.speed_terms:force_with_speed",
        f"{_STRIP}transom_terms_are_those_of_the_published_table",
        f"{_STRIP}a_print_without_the_square_would_not_pass",
        f"{_STRIP}transom_terms_of_the_wave_force",
        f"{_STRIP}a_heeled_twin_is_the_sum_of_the_heave_of_its_hulls",
    ),
    _choice(
        "2.18",
        "t_jk = omega_e^2 a_jk - i omega_e b_jk, printed with a twice",
        f"{_HYDRO}.speed_terms:with_speed",
        f"{_DERIVED}speed_terms_follow_from_their_derivation",
        f"{_STRIP}transom_terms_are_those_of_the_published_table",
    ),
    _choice(
        "2.19",
        "roll and pitch coupled at speed by U/omega_e^2, printed U/omega_e",
        f"{_HYDRO}.speed_terms:with_speed",
        f"{_STRIP}a_heeled_twin_is_the_sum_of_the_heave_of_its_hulls",
    ),
    _choice(
        "2.32",
        "a_54 = a_45, b_54 = b_45, printed as c_45",
        f"{_HYDRO}.strip_forces:lever_matrix",
        f"{_STRIP}a_heeled_twin_is_the_sum_of_the_heave_of_its_hulls",
    ),
    _choice(
        "2.35 2.36",
        "velocities i omega_e eta z at the encounter frequency, printed without i and with omega",
        "workbench.damping.sail_damping:root_mean_square",
        f"{_SAILS}root_mean_square_is_that_of_the_moments_themselves",
        f"{_SAILS}root_mean_square_follows_the_encounter_frequency",
    ),
    _choice(
        "2.45 2.46",
        "root mean square of the fluctuating moment; with the mean, as printed, it grows without limit: mean_moment",
        "workbench.damping.sail_damping:SailDampingSettings",
        f"{_SAILS}printed_forms_grow_without_limit_or_with_frequency",
        f"{_SAILS}closed_form_is_the_limit_of_the_root_mean_square",
        standing="switch",
    ),
    _choice(
        "2.47 2.48 2.49 2.50",
        "a damping is a moment over a velocity amplitude, printed over a motion amplitude: divisor",
        "workbench.damping.sail_damping:SailDampingSettings",
        f"{_SAILS}printed_forms_grow_without_limit_or_with_frequency",
        f"{_SAILS}closed_form_gives_the_numbers_of_the_formulas",
        standing="switch",
    ),
    _choice(
        "4.1",
        "sigma_r^2 and sigma_v^2 are the variances, the text says sigma",
        "workbench.slamming.statistics:slamming_statistics",
        f"{_COUNTS}ochis_probability_and_hourly_number",
    ),
    _choice(
        "4.2 4.3",
        "responses are per wave amplitude, zeta, printed per relative motion, xi",
        "workbench.slamming.statistics:response_moments",
        f"{_COUNTS}moments_of_a_flat_band_are_closed_form",
    ),
    _choice(
        "4.8",
        "central difference of neighbours m - 1 and m + 1, printed n - 1 and n + 1",
        "workbench.records.point_motion:rate_of",
        f"{_POINTS}differences_are_of_second_order",
    ),
    _choice(
        "4.9",
        "derivative of 4.5, or the sine of angular rates as printed: form",
        "workbench.records.point_motion:point_velocity",
        f"{_POINTS}exact_form_is_the_derivative_and_printed_form_is_not",
        standing="switch",
    ),
    _choice(
        "4.16",
        "omega_e inside the cosine, printed omega",
        "workbench.records.point_motion:point_motion",
        f"{_POINTS}material_velocity_is_the_derivative_following_the_water",
        f"{_POINTS}small_motions_equal_the_linear_closed_form",
    ),
    _choice(
        "6.4",
        "glyph of the normal, n for h; water entry by boundary elements is not in this package",
        "",
        standing="not used",
    ),
)
"""In the order of the appendix, then of the chapters."""


def rows() -> list[dict[str, Any]]:
    """Return the table as plain values."""
    return [repair.as_dict() for repair in REPAIRS]
