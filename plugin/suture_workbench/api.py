# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command of the workbench as a function, with or without a window.

    import FreeCAD
    from suture_workbench import api
    part = FreeCAD.openDocument("part.FCStd").Objects[0]
    for hole in api.find_holes(part).report.holes:
        print(hole.id, hole.kind, hole.edges)
    filled = api.fill(part, edges=[9], method="mvs")
    face = api.fill_border([(sketch, [1, 2, 3]), (part, [4])])
    print(api.check(filled).verdict)

Every failure is a SutureError, whose text is a sentence and whose `edges` are those that it names.
"""

from pathlib import Path

import FreeCAD as App

from . import exporter, feature, places, tasks, waiting, words
from .compat import translate
from .errors import NothingToDo, SutureError
from .options import CheckOptions, FillOptions
from .reports import FILLABLE
from .sources import Sources


def find_holes(obj):
    """tasks.Found of an object: the loops of its shape, holes first; none is no failure."""
    try:
        return waiting.run(tasks.FindHoles(places.local_shape(obj)))
    except NothingToDo:
        return tasks.Found(None, places.local_shape(obj), None)


def edges_for(obj, edges=(), faces=()):
    """One edge of each hole that has one of the edges, or one of the faces as a neighbour."""
    if not faces:
        return list(edges)
    found = find_holes(obj)
    holes = found.report.holes if found.report else []
    wanted = list(edges)
    for hole in holes:
        if hole.kind == FILLABLE and set(hole.faces) & set(faces):
            numbers = [number for number in map(found.number, hole.edges) if number]
            if numbers and not set(numbers) & set(wanted):
                wanted.append(numbers[0])
    if not wanted:
        names = ", ".join(f"Face{face}" for face in faces)
        raise SutureError(translate("No hole lies beside {}.").format(names))
    return wanted


def fill(obj, edges=(), faces=(), through=(), **options):
    """A parametric object in which holes of `obj` are filled; without edges and faces all of them.

    through   [(object, ("Edge1", "Vertex2", "Face3")), ...] that the new face passes through; it is
              tangent to faces among them where the edges and vertices lie on them
    options   those of FillOptions: method, continuity, sides, points, gap, angle, curvature,
              own, recognise, effort, one_face, all_loops; merge=True, split="auto" or "3,7", grow=True;
              planar=True, larger=2, smaller=9, corners=4: only holes like that
    """
    base = places.base_of(obj)
    chosen = FillOptions(edges_for(base, edges, faces), **options)
    request = feature.Request(base, chosen.with_points(places.points_through(through, base)))
    return keep(request, waiting.run(request.task()), chosen, through)


def fill_border(chosen, through=(), **options):
    """A parametric object with one new face whose border chosen edges are, in any order.

    chosen    [(object, edge numbers), ...]; the edges may have a face, which the new one joins, or none
    options   those of FillOptions, such as connect=True: bridge gaps between the edges by curves, with
              tension=1.5 for longer; supports={3: 7}: tangent to face 7 at edge 3
    """
    return _over_edges("Boundary", chosen, through, options)


def bridge(chosen, through=(), **options):
    """A parametric object with a new face between two edges, or chains of edges, or closed rims.

    chosen    [(object, edge numbers), ...] of both sides together
    """
    return _over_edges("Bridge", chosen, through, options)


def replace_faces(obj, faces, through=(), **options):
    """A parametric object in which faces have gone, and what they left is filled anew."""
    return _without_faces("Replace", obj, faces, through, options)


def remove_faces(obj, faces, **options):
    """A parametric object in which faces have gone, and their neighbours have grown together; where
    they cannot, it is filled, and the object's Verdict says so."""
    return _without_faces("Remove", obj, faces, (), options)


def _over_edges(task, chosen, through, options):
    chosen = [(places.base_of(obj), edges) for obj, edges in chosen]
    sources = Sources([obj for obj, _ in chosen])
    edges = [sources.number(obj, edge) for obj, numbers in chosen for edge in numbers]
    options = FillOptions(edges, task=task, **options)
    return _made(sources, options, through)


def _without_faces(task, obj, faces, through, options):
    sources = Sources([places.base_of(obj)])
    return _made(sources, FillOptions(task=task, faces=faces, **options), through)


def _made(sources, options, through):
    base, *others = sources.objects
    points = places.points_through(through, base)
    request = feature.Request(base, options.with_points(points), sources.shape, others)
    return keep(request, waiting.run(request.task()), options, through)


def sew(obj):
    """An object beside `obj`: its shape with the loose faces sewn, in one step of undo. It does not
    follow `obj`. NothingToDo if no face is loose."""
    base = places.base_of(obj)
    shape, sewing = waiting.run(tasks.SewFaces(places.local_shape(base)))
    document = base.Document
    document.openTransaction(translate("Sew faces"))
    try:
        sewn = document.addObject("Part::Feature", "Sewn")
        home = places.home_for_result(base)
        if home is not None:
            home.addObject(sewn)
        sewn.Label = translate("{} sewn").format(base.Label)
        sewn.Shape = shape
        sewn.Placement = places.frame(sewn).inverse().multiply(places.to_document(base))
        hide(base)
        document.recompute()
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    App.Console.PrintMessage(f"{sewn.Label}: {words.sewn(sewing)}\n")
    return sewn


def patch(file, document=None, **own):
    """An object with the smooth many-sided patch of a control mesh in an OBJ file.

    own   options of `suture patch`: k, aperture, tolerance, exact=True, quads=True
    """
    return keep_surface(*waiting.run(tasks.MakeSurface("patch", Path(file), own)), file, document)


def algebraic(file, document=None):
    """An object with the surface that polynomials in a JSON file describe."""
    return keep_surface(*waiting.run(tasks.MakeSurface("algebraic", Path(file))), file, document)


def keep_surface(shape, answer, file, document=None):
    """Makes a surface an object of a document, by default the active one, in one step of undo."""
    document = document or App.ActiveDocument or App.newDocument()
    document.openTransaction(words.surface_name(answer["command"]))
    obj = document.addObject("Part::Feature", "Surface")
    obj.Label = Path(file).stem
    obj.Shape = shape
    document.recompute()
    document.commitTransaction()
    App.Console.PrintMessage(f"{obj.Label}: {words.surface_summary(answer)[0]}\n")
    return obj


def keep(request, filled, options, through=(), edited=None):
    """Makes what was filled an object, or `edited` one, in one step of undo.

    options   those of the request without the points of `through`
    """
    document = request.base.Document
    document.openTransaction(words.task_name(options.task))
    try:
        obj = edited or feature.make(request.base, options.task)
        feature.set_options(obj, options, through, request.others)
        feature.store(obj, request, filled)
        for source in (request.base, *request.others):
            hide(source)
        document.recompute()
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    return obj


def hide(obj):
    """The base disappears behind its result, as in FreeCAD's own features."""
    if getattr(obj, "ViewObject", None) is not None:
        obj.ViewObject.Visibility = False


def check(obj, html=None, **options):
    """reports.Check of an object; options are those of CheckOptions, `html` a file to write too."""
    chosen = CheckOptions(**options)
    report, _ = waiting.run(tasks.CheckContinuity(places.local_shape(obj), chosen, html))
    return report


def convert(source, target, fill_holes=False, sew=False, **options):
    """Converts a file without opening it; with fill_holes its holes are filled on the way.

    Result   the program's document (docs/json.md)
    """
    chosen = FillOptions(**options) if fill_holes else None
    return waiting.run(tasks.ConvertFile(Path(source), Path(target), chosen, sew))


def export(objects, filename):
    """Writes objects as STEP or IGES with their holes filled. Result   the program's verdict."""
    return exporter.export(objects, filename)
