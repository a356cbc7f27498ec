import json
import subprocess
import sys

import numpy as np
import pytest

from workbench import radiation_store
from workbench.app.control import slider_step
from workbench.app.deck_pressure_inputs import DECK_PRESSURE_DEFAULTS
from workbench.app.inputs import inputs_for
from workbench.app.method_inputs import METHOD_DEFAULTS, SHORTEST_WAVE, panel_method_acts
from workbench.app.model import LOADED, Model
from workbench.app.notes import notes_under
from workbench.app.reading import Problems, case_of, uploaded_design, usual_inputs
from workbench.app.ship_inputs import inputs_of
from workbench.conventions import GRAVITY, KNOT
from workbench.damping.sail_damping import SailDampingSettings
from workbench.errors import InputError
from workbench.files import design_to_toml
from workbench.hulls import library
from workbench.hydrodynamics.high_speed_settings import HighSpeedSettings
from workbench.hydrodynamics.recommended import RecommendedSettings
from workbench.hydrodynamics.settings import PotentialFlowSettings
from workbench.hydrodynamics.strip_settings import StripSettings
from workbench.running_state import RunningState
from workbench.wet_deck_pressure.settings import ATMOSPHERE, DeckPressureSettings


@pytest.fixture
def model():
    return Model()


@pytest.mark.parametrize("name", library.names())
def test_page_shows_each_design_of_the_library_without_changing_it(name):
    design = library.design(name)
    case = case_of(design, usual_inputs(design) | inputs_of(design))
    assert case.design == design
    names = {one.name for one in inputs_for(design)}
    assert set(inputs_of(design)) <= names
    for one in inputs_for(design):
        if one.kind == "number" and one.low is not None:
            assert one.low < one.high
            assert one.step > 0


def test_units_of_the_page(model):
    model.change("speed_knots", 20)
    model.change("heading_degrees", 150)
    model.change("mass", 1300)
    case = model.case()
    assert case.condition.speed == pytest.approx(20 * KNOT)
    assert case.condition.wave_direction == pytest.approx(np.radians(150))
    assert case.design.masses.mass == pytest.approx(1.3e6)
    model.change("centre_height", 7.0)
    height = model.case().design.masses.centre_of_gravity[2]
    assert height == pytest.approx(7.0 - model.base.hull.shape.draught)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("clearance", -1, "clearance"), ("clearance", "high", "number"), ("wave_height", 0, "> 0"),
        ("period", 1.0, "steeper waves break"), ("speed_knots", -3, "speed"), ("heading_degrees", 400, "360"),
        ("criterion", 0, "criterion"), ("hours", "nan", "number"), ("seed", 1.5, "whole number"),
        ("spacing", 3.0, "touch"), ("mass", 0, "mass"), ("pitch_gyradius", 500, "gyradius"),
        ("deck_fore", -50, "fore end"), ("deck_width", 90, "width"), ("corner_radius", 50, "corner radius"),
        ("camber", -1, "camber"), ("trim_degrees", 11, "degrees"), ("heel_degrees", 31, "degrees"),
        ("deck_trim_degrees", -11, "wet deck trim"), ("sinkage", 90, "sinkage"), ("heel_degrees", "x", "number"),
        ("centre_bow_depth", 1, "both be 0"), ("roll_damping_ratio", 2, "roll damping"),
        ("running_trim_degrees", 11, "running trim"), ("running_sinkage", 90, "running sinkage"),
        ("running_sinkage", "deep", "number"),
    ],
)  # fmt: skip
def test_refused_input_is_a_sentence_at_its_control(model, name, value, words):
    model.change(name, value)
    assert model.case() is None
    assert list(model.problems) == [name]
    assert words in model.problems[name].lower().replace("_", " ")
    assert model.blockers == tuple(model.problems.values())
    model.change(name, Model().inputs[name])
    assert model.case() is not None
    assert model.problems == {}


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("tunnel_damping", 0.3, "tunnel damping"), ("panels", 100, ">= 200"), ("panels", 5000, "4000"),
        ("panels", 500.5, "whole number"),
    ],
)  # fmt: skip
def test_choices_of_the_panel_method_are_refused_where_they_act_alone(model, name, value, words):
    model.change(name, value)
    assert model.case() is not None
    model.change("theory", "potential-flow")
    assert model.case() is None
    assert list(model.problems) == [name]
    assert words in model.problems[name].lower().replace("_", " ")
    model.change("theory", "strip")
    assert model.case() is not None
    model.change("theory", "recommended")
    model.change("speed_knots", 3)
    assert model.case() is None


def test_two_problems_stand_at_two_controls(model):
    model.change("wave_height", -1)
    model.change("spacing", 0)
    assert model.case() is None
    assert set(model.problems) == {"wave_height", "spacing"}


def test_angles_are_typed_in_degrees(model):
    for name, value in (("trim_degrees", 1), ("heel_degrees", -2), ("deck_trim_degrees", "0.5")):
        model.change(name, value)
    design = model.case().design
    assert np.degrees([design.hull.trim, design.hull.heel]) == pytest.approx([1, -2])
    assert np.degrees(design.wet_deck.trim) == pytest.approx(0.5)
    assert inputs_of(design)["heel_degrees"] == -2


def test_sinkage_centre_bow_and_roll_damping_reach_the_design(model):
    bow = {"centre_bow_length": 12.0, "centre_bow_depth": 1.2, "centre_bow_width": 6.0}
    for name, value in {**bow, "sinkage": 0.2, "roll_damping_ratio": 0.1}.items():
        model.change(name, value)
    design = model.case().design
    assert {name: getattr(design.wet_deck, name) for name in bow} == bow
    assert (design.hull.sinkage, design.masses.roll_damping_ratio) == (0.2, 0.1)


def test_method_is_the_recommended_one_until_it_is_changed(model):
    assert model.case().theory == RecommendedSettings(quick=True)
    usual = model.case().response_key
    model.change("theory", "potential-flow")
    changes = {"interaction": "on", "wave_field": "incident", "tunnel_damping": 0.03, "panels": 600}
    for name, value in changes.items():
        before = model.case().response_key
        model.change(name, value)
        assert model.case().response_key != before
    assert model.case().theory == PotentialFlowSettings(**changes)
    assert isinstance(model.case().theory.panels, int)
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.case() == model.case()
    model.change("theory", "strip")
    assert model.case().theory == StripSettings(interaction="on")
    model.change("theory", "high-speed")
    assert model.case().theory == HighSpeedSettings(interaction="on")
    for name, value in METHOD_DEFAULTS.items():
        model.change(name, value)
    assert model.case().response_key == usual


def test_method_offers_what_there_is_and_outlasts_the_ship(model):
    model.change("panels", 600)
    model.change("theory", "potential-flow")
    model.choose("cofea")
    assert model.inputs["panels"] == 600
    assert "interaction" not in model.inputs
    assert model.case().theory.panels == 600
    model.choose("austal-63")
    assert model.inputs["interaction"] == "auto"
    assert {one.name for one in inputs_for(model.base) if one.group == "method"} == set(METHOD_DEFAULTS)


def test_choices_of_the_pressure_over_the_deck_reach_the_case_and_go_round(model):
    first = model.case()
    assert first.deck_pressure == DeckPressureSettings()
    changes = {
        "deck_strips": "across",
        "deck_model": "logvinovich",
        "deck_suction": "atmosphere",
        "deck_reduction": "pabst",
        "averaging": "value",
    }
    for name, value in {**changes, "averaging_time": 4}.items():
        model.change(name, value)
    case = model.case()
    assert case.deck_pressure == DeckPressureSettings(
        direction="across", pressure="logvinovich", suction=ATMOSPHERE, reduction="pabst", time_step=0.004
    )
    assert case.deck_pressure_key != first.deck_pressure_key
    assert case.scene_key != first.scene_key
    assert (case.counting_key, case.slamming_key) == (first.counting_key, first.slamming_key)
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.case() == case
    model.change("averaging_time", 0.5)
    assert model.case() is None
    assert "2" in model.problems["averaging_time"]
    model.choose("cofea")
    assert not set(DECK_PRESSURE_DEFAULTS) & set(model.inputs)
    assert model.case().deck_pressure == DeckPressureSettings()


def test_pressures_are_computed_in_an_hour_at_most_and_follow_the_seed(model):
    model.change("hours", 2.5)
    case = model.case()
    assert (case.realisation.hours, case.pressure_realisation.hours) == (2.5, 1.0)
    model.change("hours", 2)
    assert model.case().deck_pressure_key == case.deck_pressure_key
    model.change("seed", 7)
    assert model.case().deck_pressure_key != case.deck_pressure_key


def test_panel_method_refines_where_it_is_recommended_and_only_when_asked(model):
    assert model.case().refinement is None
    model.refine()
    assert model.refined == ()
    model.change("speed_knots", 5)
    quick = model.case()
    assert quick.theory == RecommendedSettings(quick=True)
    assert quick.refinement == RecommendedSettings()
    model.refine()
    refined = model.case()
    assert refined.theory == RecommendedSettings()
    assert refined.response_key != quick.response_key
    assert refined.unrefined == quick
    model.change("clearance", 3.0)
    assert model.case().is_refined
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.case() == model.case()
    model.change("speed_knots", 4)
    assert not model.case().is_refined
    assert "refined" not in model.state()
    model.change("speed_knots", 5)
    assert model.case().is_refined
    model.change("panels", 800)
    assert not model.case().is_refined
    model.change("panels", 1000)
    model.leave_unrefined(model.case())
    assert not model.case().is_refined


def test_one_heading_is_enough_in_a_long_crested_sea_at_speed(model):
    assert model.case().lone_heading == pytest.approx(np.pi)
    model.change("spreading", "2")
    assert model.case().lone_heading is None
    model.change("spreading", "")
    model.change("speed_knots", 0)
    assert model.case().lone_heading is None
    model.change("speed_knots", 20)
    model.change("theory", "potential-flow")
    assert model.case().lone_heading is None


def test_attitude_at_speed_and_wind_reach_the_running_state(model):
    assert model.case().running_state == RunningState()
    assert "wind_knots" not in model.inputs
    usual = model.case().response_key
    model.change("running_trim_degrees", -1.5)
    model.change("running_sinkage", 0.1)
    state = model.case().running_state
    assert state == RunningState(running_trim=np.radians(-1.5), running_sinkage=0.1)
    assert model.case().response_key != usual
    model.choose("crowther-318")
    assert model.case().running_state == RunningState()
    still = model.case().response_key
    model.change("wind_knots", "many")
    assert model.case().response_key == still
    model.change("sail_damping", "on")
    assert model.case() is None
    assert list(model.problems) == ["wind_knots"]
    model.change("wind_knots", 120)
    assert model.case() is None
    assert "true wind speed" in model.problems["wind_knots"].lower()
    model.change("wind_knots", 20)
    wind = model.case().running_state.wind
    assert (wind.speed, wind.direction) == (pytest.approx(20 * KNOT), None)
    assert model.case().running_state.sails == SailDampingSettings()
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.case() == model.case()


def test_notes_say_what_the_automatic_choices_come_to(model):
    def notes(**inputs):
        return notes_under({**model.inputs, **inputs}, model.base)

    assert "high-speed theory" in notes(speed_knots=24)["theory"]
    assert "strip theory" in notes(speed_knots=24, heading_degrees=0)["theory"]
    assert "the panel method; strip theory first" in notes(speed_knots=5)["theory"]
    assert "rough guide above Fn 0.35" in notes(theory="strip")["theory"]
    assert "waves of the other" in notes(speed_knots=24)["interaction"]
    assert "Each hull alone" in notes(speed_knots=24, theory="strip")["interaction"]
    assert "Solved together" in notes(speed_knots=5)["interaction"]
    assert "own waves" in notes(speed_knots=0)["wave_field"]
    assert "Incident wave only" in notes(speed_knots=0, interaction="off")["wave_field"]
    assert "interaction" not in notes(interaction="on")
    assert "tames" in notes(interaction="on")["tunnel_damping"]
    assert "Acts only" in notes(interaction="off")["tunnel_damping"]
    assert "clearance of the wet deck" in notes()["running_sinkage"]
    assert "theory" not in notes(speed_knots="many")


def test_shortest_wave_is_that_of_the_motions():
    assert SHORTEST_WAVE == radiation_store.SHORTEST_WAVE


@pytest.mark.parametrize(("theory", "speed", "acts"), [
    ("recommended", 0.19, True), ("recommended", 0.21, False), ("potential-flow", 0.5, True), ("strip", 0.0, False),
])  # fmt: skip
def test_controls_of_the_panel_method_act_where_it_is_used(theory, speed, acts):
    assert panel_method_acts(theory, 40.0, speed * np.sqrt(GRAVITY * 40.0)) is acts


def test_numbers_with_a_comma_are_read(model):
    model.change("wave_height", "2,5")
    assert model.case().condition.sea_state.significant_wave_height == 2.5


def test_state_goes_round_through_json(model):
    changes = {"clearance": 3.1, "spectrum": "jonswap", "heading_degrees": 150, "camber": 0.2}
    for name, value in changes.items():
        model.change(name, value)
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.case() == model.case()
    assert other.state() == model.state()


def test_state_of_a_loaded_design_goes_round(model):
    text = design_to_toml(library.design("delft-372")).replace("Delft 372", "My own")
    model.load(text)
    assert model.design_name == LOADED
    model.change("clearance", 0.1)
    other = Model()
    assert other.restore(json.loads(json.dumps(model.state()))) == []
    assert other.base.title.startswith("My own")
    assert other.case() == model.case()


def test_state_from_elsewhere_is_checked(model):
    before = model.case()
    ignored = model.restore(
        {"design": "no-such-ship", "inputs": {"law": "magic", "os": "x", "hours": [1], "clearance": "3.3"}}
    )
    assert len(ignored) == 4
    assert model.base == before.design
    assert model.case().design.wet_deck.clearance == 3.3


def test_loading_rubbish_changes_nothing(model):
    before = model.case()
    for text in ("x = [", "name = 'a'", "\n", "x=1\n" * 2_000_000):
        model.load(text)
        assert "design" in model.problems
        assert model.case() == before


def test_uploaded_file_may_not_name_files_of_the_server():
    text = 'name = "x"\n[hull]\ncount = 1\n[hull.shape]\nkind = "offsets"\nfile = "/etc/passwd"\n'
    with pytest.raises(InputError, match="names another file"):
        uploaded_design(text)


def test_preset_sets_the_sea_and_a_change_makes_it_ones_own(model):
    model.change("preset", "Sea state 5")
    sea = model.case().condition.sea_state
    assert (sea.significant_wave_height, sea.peak_period) == (3.25, 9.7)
    model.change("wave_height", 3.0)
    assert model.inputs["preset"] == "own"


@pytest.mark.parametrize("kind", ["mean", "zero"])
def test_another_kind_of_period_is_the_same_sea(model, kind):
    peak = model.case().condition.sea_state.peak_period
    model.change("period_kind", kind)
    assert float(model.inputs["period"]) < peak
    assert model.case().condition.sea_state.peak_period == pytest.approx(peak, rel=1e-3)


def test_pierson_moskowitz_takes_its_own_period(model):
    model.change("spectrum", "pierson-moskowitz")
    model.change("wave_height", 2.0)
    assert model.case().condition.sea_state.peak_period == pytest.approx(5.0 * np.sqrt(2.0), rel=0.01)


def test_ship_of_another_size_gets_another_sea_and_one_alike_does_not(model):
    model.change("wave_height", 2.2)
    model.choose("incat-061")
    assert model.inputs["wave_height"] == 2.2
    assert model.notice == ""
    model.choose("delft-372")
    assert model.inputs["wave_height"] < 0.3
    assert "3 m" in model.notice


def test_design_without_wet_deck_has_no_controls_for_it(model):
    model.choose("cofea")
    assert "clearance" not in model.inputs
    assert model.case().design.wet_deck is None


def test_keys_say_what_must_be_computed_again(model):
    first = model.case()
    model.change("clearance", 3.0)
    raised = model.case()
    assert raised.plan_key == first.plan_key
    assert raised.counting_key != first.counting_key
    model.change("criterion", 10)
    assert model.case().counting_key == raised.counting_key
    assert model.case().slamming_key != raised.slamming_key
    model.change("deck_fore", 30)
    assert model.case().response_key == first.response_key
    assert model.case().plan_key != first.plan_key
    model.change("speed_knots", 18)
    assert model.case().response_key != first.response_key


def test_problems_are_an_exception_with_sentences(model):
    with pytest.raises(Problems, match="must be"):
        case_of(model.base, {**model.inputs, "wave_height": "x"})


@pytest.mark.parametrize(("span", "step"), [(1.0, 0.005), (10, 0.05), (40, 0.2), (300, 2), (0.1, 0.0005)])
def test_steps_of_sliders_are_round(span, step):
    assert slider_step(span) == pytest.approx(step)


def test_page_starts_without_the_heavy_packages():
    heavy = "capytaine", "pyvista", "vtk", "vtkmodules"
    code = f"import sys, workbench.app.main; print([m for m in {heavy} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
