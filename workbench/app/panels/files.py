"""Data: everything as files."""

from collections.abc import Callable
from html import escape

import ipywidgets as widgets

from workbench.app import exports
from workbench.app.job import Job
from workbench.app.model import Model
from workbench.app.panels.panel import Panel, card
from workbench.files import design_to_toml

SendFile = Callable[[str, str, bytes], None]

CSV, NETCDF, HTML = "text/csv", "application/x-netcdf", "text/html"


class FilesPanel(Panel):
    """Buttons that save files; one that cannot yet says why."""

    title = "Data"

    def __init__(
        self, model: Model, post: Callable[[], None], send_file: SendFile, wants_scene: Callable[[], None]
    ) -> None:
        super().__init__(model, post)
        self.send_file, self.wants_scene = send_file, wants_scene
        self.film_job = Job("film")

    def build(self):
        """Make the buttons, by what they are for."""
        groups = (
            ("Design and inputs",
             "The design opens again in this page and in the command line; the inputs are those of the page.",
             (("Design (TOML)", self._design), ("Inputs (JSON)", self._inputs))),
            ("Motions", "All six motions at all computed headings.",
             (("Motions (CSV)", self._motions_csv), ("Motions (netCDF)", self._motions_netcdf))),
            ("Slamming", "Statistics at every point of the deck; each slam that was counted.",
             (("Slamming (CSV)", self._slamming_csv), ("Slamming (netCDF)", self._slamming_netcdf),
              ("Counted slams (CSV)", self._events_csv))),
            ("Animation", "One file that plays in any browser, without this program and without a network; "
             "or a film of the hardest slam, for slides.",
             (("Animation (HTML)", self._animation), ("Film (MP4)", self._film))),
        )  # fmt: skip
        boxes = []
        for heading, words, buttons in groups:
            row = widgets.HBox([self._button(label, action) for label, action in buttons])
            row.add_class("wb-button-row")
            box = widgets.VBox([widgets.HTML(f"<h2>{heading}</h2><p class='wb-note'>{words}</p>"), row])
            box.add_class("wb-card")
            boxes.append(box)
        holder = widgets.Box(boxes)
        holder.add_class("wb-grid")
        self.answer = card()
        self.answer.add_class("wb-answer")
        self.film_job.observe(self._film_failed, names=["state"])
        figures = card("<h2>Figures</h2><p class='wb-note'>Each figure has PNG and SVG beside its title.</p>")
        holder.children = (*holder.children, figures)
        return [holder, self.answer]

    def _button(self, label: str, action: Callable[[], str]) -> widgets.Button:
        button = widgets.Button(description=label, tooltip=f"Save: {label}")
        button.add_class("wb-data-button")

        def clicked(_):
            try:
                self._say(action())
            except Exception as error:
                self._say(f"{label} could not be made: {type(error).__name__}.")

        button.on_click(clicked)
        return button

    def _send(self, name: str, mime: str, content: bytes) -> str:
        self.send_file(name, mime, content)
        size = f"{len(content) / 1e6:.1f} MB" if len(content) > 1e6 else f"{len(content) / 1e3:.0f} kB"
        return f"{name} was saved ({size})."

    @property
    def _stem(self) -> str:
        return "".join(
            letter if letter.isalnum() or letter in "-_" else "-" for letter in self.model.base.name
        )

    def _ready(self):
        """Return the case and the findings that fit it, or a sentence why there are none."""
        case = self.model.case()
        if case is None:
            return None, " ".join(self.model.blockers)
        found = self.model.findings
        if found is None or found.case.slamming_key != case.slamming_key:
            return None, "The results for the present inputs are still being computed; try again in a moment."
        return found, ""

    def _design(self) -> str:
        case = self.model.case()
        if case is None:
            return " ".join(self.model.blockers)
        return self._send(f"{self._stem}.toml", "application/toml", design_to_toml(case.design).encode())

    def _inputs(self) -> str:
        return self._send(
            f"{self._stem}-inputs.json", "application/json", exports.inputs_file(self.model.state())
        )

    def _with_headings(self):
        """Return the findings once all headings are computed, or a sentence why they are not."""
        found, reason = self._ready()
        if found and found.ship.motions.sizes["wave_direction"] == 1:
            return None, "The other headings are still being computed; try again in a moment."
        return found, reason

    def _motions_csv(self) -> str:
        found, reason = self._with_headings()
        if not found:
            return reason
        return self._send(
            f"{self._stem}-motions.csv", CSV, exports.csv_file(exports.motion_table(found), found.case)
        )

    def _motions_netcdf(self) -> str:
        found, reason = self._with_headings()
        if not found:
            return reason
        return self._send(
            f"{self._stem}-motions.nc", NETCDF, exports.netcdf_file(exports.motion_table(found), found.case)
        )

    def _slamming_csv(self) -> str:
        found, reason = self._with_deck()
        if not found:
            return reason
        return self._send(
            f"{self._stem}-slamming.csv", CSV, exports.csv_file(exports.slamming_table(found), found.case)
        )

    def _slamming_netcdf(self) -> str:
        found, reason = self._with_deck()
        if not found:
            return reason
        content = exports.netcdf_file(exports.slamming_table(found), found.case)
        return self._send(f"{self._stem}-slamming.nc", NETCDF, content)

    def _with_deck(self):
        found, reason = self._ready()
        if found and found.slam is None:
            return None, "This design has no wet deck, so there is no slamming to save."
        return found, reason

    def _events_csv(self) -> str:
        found, reason = self._with_deck()
        if not found:
            return reason
        counted = self.model.counted
        if counted is None or counted.key != found.case.counting_key:
            self.wants_scene()
            return "The slams are being counted for this; press again in some seconds."
        return self._send(f"{self._stem}-slams.csv", CSV, exports.csv_file(counted.events, found.case))

    def _with_scene(self):
        """Return the findings if there is an animation that fits them, or a sentence why there is none."""
        found, reason = self._with_deck()
        if found and (self.model.scene is None or self.model.scene_key != found.case.scene_key):
            self.wants_scene()
            return None, "The animation is being built for this; press again in some seconds."
        return found, reason

    def _film(self) -> str:
        from workbench.scene.stills import rendering_obstacle

        obstacle = rendering_obstacle()
        if obstacle:
            return obstacle
        found, reason = self._with_scene()
        if not found:
            return reason
        scene, name = self.model.scene, f"{self._stem}-film.mp4"

        def done(content: bytes) -> None:
            self._say(self._send(name, "video/mp4", content))

        self.film_job.start(found.case.counting_key, lambda _: exports.film_file(scene), done)
        return "The film is being painted, which takes about a minute; it is saved when it is ready."

    def _film_failed(self, change) -> None:
        if change.new == "failed":
            self._say(f"The film could not be made: {self.film_job.error}")

    def _say(self, sentence: str) -> None:
        self.answer.value = f"<p role='status'>{escape(sentence)}</p>"

    def _animation(self) -> str:
        found, reason = self._with_scene()
        if not found:
            return reason
        from workbench.scene.standalone import standalone_html

        return self._send(f"{self._stem}-animation.html", HTML, standalone_html(self.model.scene).encode())

    def reason(self) -> str:
        """Have something to save as soon as there are results."""
        return (
            ""
            if self.model.findings
            else "There is nothing to save yet: the first results are being computed."
        )
