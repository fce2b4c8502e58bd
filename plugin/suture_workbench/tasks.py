# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program is asked for: each task is a few runs, made one after the other.

A task's `steps` yields the arguments of a run and gets its answer back; `Task` carries it through
without blocking. `run` in waiting.py waits for one.
"""

import shutil
import tempfile
import time
from collections import namedtuple
from pathlib import Path

from . import exchange, reports, settings
from .compat import translate
from .errors import NothingToDo, SutureError
from .job import Job

Filled = namedtuple("Filled", "shape report new_faces origins")


class Found(namedtuple("Found", "report shape edges")):
    """The loops of a shape. `shape` is what the report's numbers belong to: the shape itself, or, if
    faces were loose, the sewn one; `edges` has the numbers in the shape itself then, else None."""

    def number(self, edge):
        """The shape's own number of an edge of the report; None if sewing has made it."""
        return edge if self.edges is None else self.edges.get(edge)


class Task:
    """Runs its steps; ask `running` again and again, then `result`."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="suture-"))
        self._steps = self.steps()
        self._job = None
        self._outcome = None
        self._error = None
        self._finished = False
        self._began = time.monotonic()
        self._timed_out = False

    def steps(self):
        raise NotImplementedError

    def start(self):
        """Begins; a program that is missing raises here."""
        self._advance(None)
        if self._error:
            raise self._error
        return self

    def started(self):
        return self._job is not None or self._finished

    def running(self):
        if self._finished:
            return False
        limit = settings.time_limit()
        if limit and not self._timed_out and time.monotonic() - self._began > limit:
            self._timed_out = True
            self.cancel()
        if self._job.running():
            return True
        try:
            answer = self._job.document()
        except SutureError as error:
            if self._timed_out:
                error = SutureError(
                    translate("Given up after {} s, the limit set in the preferences.").format(
                        limit
                    )
                )
            self._end(error)
            return False
        self._advance(answer)
        return not self._finished

    def progress(self):
        return self._job.progress() if self._job and not self._finished else (0.0, "")

    @property
    def pid(self):
        return self._job.pid

    def cancel(self):
        """Returns at once; the processes are gone within two seconds if `running` is asked."""
        if self._job and not self._finished:
            self._job.cancel()

    def kill(self):
        """Ends it before it returns."""
        if self._job and not self._finished:
            self._job.kill()
            self.running()

    def result(self):
        if self._error:
            raise self._error
        return self._outcome

    def _advance(self, answer):
        try:
            arguments = self._steps.send(answer)
            self._job = Job(arguments, self.folder)
        except StopIteration as end:
            self._outcome = end.value
            self._end(None)
        except Exception as error:  # handed on by result()
            self._end(error)

    def _end(self, error):
        self._error = error
        self._finished = True
        self._steps.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _input(self, shape):
        path = self.folder / ("in" + exchange.SUFFIX)
        exchange.write_shape(shape, path)
        return path

    def _numbers(self, source, named):
        """The program's number of an edge of ours: another one where faces are loose."""
        if not named or not exchange.loose_faces(self.shape):
            return lambda edge: edge
        sewn, tolerance = yield from self._sew(source)
        found = exchange.same_edges(named, self.shape, sewn, tolerance)

        def number(edge):
            if edge not in found:
                raise SutureError(
                    translate("Edge{} is gone after the loose faces were sewn.").format(edge),
                    [edge],
                )
            return found[edge]

        return number

    def _sew(self, source):
        """The shape with its loose faces sewn, as the program numbers it, and at which tolerance."""
        path = self.folder / ("sewn" + exchange.SUFFIX)
        document = yield ["convert", source, path, "--sew"]
        return exchange.read_shape(path), float(document["sewing"]["tolerance"])


class FindHoles(Task):
    """The holes of a shape. Result   Found"""

    def __init__(self, shape):
        self.shape = shape
        super().__init__()

    def steps(self):
        source = self._input(self.shape)
        report = reports.holes((yield ["inspect", source]))
        if not report.sewn:
            return Found(report, self.shape, None)
        shape, tolerance = yield from self._sew(source)
        numbers = sorted({edge for hole in report.holes for edge in hole.edges})
        return Found(report, shape, exchange.same_edges(numbers, shape, self.shape, tolerance))


class SewFaces(Task):
    """A shape whose loose faces are sewn. Result   (shape, `sewing` of docs/json.md)"""

    def __init__(self, shape):
        self.shape = shape
        super().__init__()

    def steps(self):
        path = self.folder / ("sewn" + exchange.SUFFIX)
        document = yield ["convert", self._input(self.shape), path, "--sew"]
        sewing = document.get("sewing") or {}
        if not sewing.get("changed"):
            raise NothingToDo(translate("There is no loose face to sew."))
        return exchange.unwrapped(exchange.read_shape(path)), sewing


class FillHoles(Task):
    """Fills holes of a shape, or does another of options.TASKS to it. Result   Filled."""

    def __init__(self, shape, options):
        self.shape = shape
        self.options = options
        super().__init__()

    def steps(self):
        source = self._input(self.shape)
        out = self.folder / ("out" + exchange.SUFFIX)
        options = self.options
        number = int  # chosen edges are those of the shape as it is: nothing is sewn
        if options.task not in ("Boundary", "Bridge"):
            number = yield from self._numbers(source, options.named_edges())
        arguments = ["bridge" if options.task == "Bridge" else "fill", source, "-o", out]
        if options.task == "Holes":
            arguments += yield from self._choice(source, number)
        else:
            arguments += self._elements()
        arguments += self.options.arguments(number)
        if self.options.points:
            arguments += ["--through", self._points_file()]
        report = reports.fill((yield arguments))
        if any(hole.status == "refused" for hole in report.holes):
            loops = {}
            if options.task == "Holes":
                loops = {h.id: h.edges for h in reports.holes((yield ["inspect", source])).holes}
            report = reports.with_edges(report, loops, options.edges)
            if not any(hole.status == "filled" for hole in report.holes):
                raise reports.refusal(report)
        shape = exchange.unwrapped(exchange.read_shape(out))
        new = sorted(face for hole in report.holes for face in hole.new_faces)
        origins = exchange.face_origins(
            new, len(self.shape.Faces), len(shape.Faces), self.options.faces
        )
        return Filled(shape, report, new, origins)

    def _choice(self, source, number):
        """--edges, or --hole where several loops bound one face."""
        if not self.options.edges:
            return []
        if not self.options.one_face:
            return ["--edges", ",".join(str(number(edge)) for edge in self.options.edges)]
        report = reports.holes((yield ["inspect", source]))
        ids = []
        for edge in self.options.edges:
            loops = [hole.id for hole in report.holes if number(edge) in hole.edges]
            if not loops:
                raise SutureError(translate("Edge{} bounds no hole.").format(edge), [edge])
            ids += [loop for loop in loops if loop not in ids]
        return ["--hole", "+".join(map(str, ids))]

    def _elements(self):
        """The edges of a border or of a bridge, or the faces that go."""
        options = self.options
        edges, faces = (",".join(map(str, n)) for n in (options.edges, options.faces))
        return {
            "Boundary": ["--boundary", edges, "--no-sew", *["--connect"][: options.connect]],
            "Bridge": ["--edges", edges, "--no-sew"],
            "Replace": ["--replace-faces", faces],
            "Remove": ["--remove-faces", faces],
        }[options.task]

    def _points_file(self):
        path = self.folder / "points.csv"
        lines = (",".join(map(repr, point)) + "\n" for point in self.options.points)
        path.write_text("".join(lines), encoding="ascii")
        return path


class CheckContinuity(Task):
    """How smoothly faces meet. Result   (report, the shape that its numbers belong to)."""

    def __init__(self, shape, options, html=None):
        self.shape = shape
        self.options = options
        self.html = html
        super().__init__()

    def steps(self):
        source = self._input(self.shape)
        shape = self.shape
        number = yield from self._numbers(source, self.options.edges)
        if exchange.loose_faces(shape):
            shape, _ = yield from self._sew(source)
        arguments = ["check", source, *self.options.arguments(number)]
        if self.html:
            arguments += ["--report", self.html]
        return reports.check((yield arguments)), shape


class MakeSurface(Task):
    """A surface made from what a file describes. Result   (shape, the program's document)

    command   one of options.SURFACES, `own` its options: {"k": 3}
    """

    def __init__(self, command, source, own=None):
        self.command, self.source, self.own = command, source, own or {}
        super().__init__()

    def steps(self):
        out = self.folder / ("out" + exchange.SUFFIX)
        arguments = []
        for key, value in self.own.items():
            arguments += [f"--{key}"] if value is True else [f"--{key}", value]
        document = yield [self.command, self.source, "-o", out, *arguments]
        return exchange.unwrapped(exchange.read_shape(out)), document


class ConvertFile(Task):
    """A file into another; with options filled on the way. Result   the program's document."""

    def __init__(self, source, target, options=None, sew=False):
        self.source, self.target = source, target
        self.options, self.sew = options, sew
        super().__init__()

    def steps(self):
        if self.options is None:
            sew = ["--sew"] if self.sew else []
            return (yield ["convert", self.source, self.target, *sew])
        arguments = self.options.arguments(lambda edge: edge)
        return (yield ["fill", self.source, "-o", self.target, *arguments])
