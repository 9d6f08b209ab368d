"""Breaks a box or a mesh by Blender's Cell Fracture and says how long the operator alone kept the processor busy.

blender --background --factory-startup --python cell_fracture.py -- INPUT.json...

Each file holds seeds in the plane of a 1 x 1 x 0.5 m box as [[x, y], ...], x and y in [0, 1]; or a mesh with seeds in
space as {"points": [[x, y, z], ...], "triangles": [[a, b, c], ...], "seeds": [[x, y, z], ...]}. Prints a line
"cell_fracture SEEDS SECONDS CELLS VOLUME" for each.
"""
import json
import sys
import time

import addon_utils
import bmesh
import bpy

DEPTH = 0.5


def mesh_object(name, vertices, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def box():
    corners = [(x, y, z) for z in (-DEPTH / 2, DEPTH / 2) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    return mesh_object("whole", corners, faces)


def volume_of(thing):
    shape = bmesh.new()
    shape.from_mesh(thing.data)
    volume = shape.calc_volume()
    shape.free()
    return volume


def fracture(given):
    bpy.ops.wm.read_homefile(use_empty=True)
    addon_utils.enable("object_fracture_cell")
    is_mesh = isinstance(given, dict)
    whole = mesh_object("whole", given["points"], given["triangles"]) if is_mesh else box()
    seeds = given["seeds"] if is_mesh else [(x, y, 0.0) for x, y in given]
    points = mesh_object("seeds", seeds, [])
    points.parent = whole
    whole.select_set(True)
    bpy.context.view_layer.objects.active = whole
    start = time.process_time()
    bpy.ops.object.add_fracture_cell_objects(source={"VERT_CHILD"}, source_limit=0, recursion=0)
    seconds = time.process_time() - start
    cells = [thing for thing in bpy.data.objects if thing.name.startswith("whole_cell")]
    return len(seeds), seconds, len(cells), sum(volume_of(cell) for cell in cells)


for path in sys.argv[sys.argv.index("--") + 1:]:
    with open(path, encoding="utf-8") as file:
        print("cell_fracture", *fracture(json.load(file)), flush=True)
