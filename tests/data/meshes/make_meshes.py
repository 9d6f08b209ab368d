"""Makes the meshes beside this script as an artist would, and exports them with Blender's own exporters.

    blender --background --factory-startup --python tests/data/meshes/make_meshes.py

(with python3-numpy, which its glTF exporter needs).

Debian 12's Blender 3.4 made the files that are kept. Blender is z up; GLB, OBJ and FBX are written y up, STL and PLY as
they are. Lengths are metres.
"""

import math
import os

import bpy

FOLDER = os.path.dirname(os.path.abspath(__file__))


def start():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def add(name, points, faces):
    """An object of its own, with faces that look outward."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.validate()
    made = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(made)
    return made


def prism(name, outline, depth, shift=(0.0, 0.0), inset=0.0):
    """An outline in the xz plane, extruded along y; the back is shifted, or drawn in towards the middle."""
    count = len(outline)
    middle = [sum(point[k] for point in outline) / count for k in (0, 1)]
    points = [(x, -depth / 2, z) for x, z in outline]
    for x, z in outline:
        x, z = [p + (m - p) * inset + s for p, m, s in zip((x, z), middle, shift)]
        points.append((x, depth / 2, z))
    faces = [list(range(count)), list(range(2 * count - 1, count - 1, -1))]
    for i in range(count):
        j = (i + 1) % count
        faces.append([j, i, i + count, j + count])
    return add(name, points, faces)


def box(name, low, high):
    made = prism(name, [(low[0], low[2]), (high[0], low[2]), (high[0], high[2]), (low[0], high[2])], high[1] - low[1])
    made.location.y = (low[1] + high[1]) / 2
    return made


def wall():
    return box("Wall", (0.0, -0.25, 0.0), (1.0, 0.25, 1.0))


def window():
    """A wall of 3 x 2.5 x 0.3 with a window cut by a Boolean modifier."""
    made = box("Window", (0.0, -0.15, 0.0), (3.0, 0.15, 2.5))
    cutter = box("Cutter", (1.0, -1.0, 0.9), (2.0, 1.0, 2.1))
    modifier = made.modifiers.new("Cut", "BOOLEAN")
    modifier.object = cutter
    bpy.context.view_layer.objects.active = made
    bpy.ops.object.modifier_apply(modifier=modifier.name)
    bpy.data.objects.remove(cutter)
    return made


def gable():
    return prism("Gable", [(-2.5, 0.0), (2.5, 0.0), (0.0, 1.45)], 0.5)


def l_shape():
    """Turned so that no face looks along an axis, and moved away from the origin."""
    made = prism("Corner", [(0, 0), (2, 0), (2, 0.5), (0.5, 0.5), (0.5, 1.5), (0, 1.5)], 0.75)
    made.location = (3.0, -2.0, 1.0)
    made.rotation_euler = [math.radians(angle) for angle in (20.0, 35.0, 50.0)]
    return made


def textured(is_warped=False):
    """A wall with plaster on its caps and brick on its sides; textures in metres, unless the front's are warped."""
    made = wall()
    for name, colour in (("Plaster", (0.9, 0.8, 0.3, 1.0)), ("Brick", (0.6, 0.15, 0.1, 1.0))):
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = colour
        material.diffuse_color = colour
        made.data.materials.append(material)
    layer = made.data.uv_layers.new(name="UV")
    for face in made.data.polygons:
        is_cap = abs(face.normal.y) > 0.5
        face.material_index = 0 if is_cap else 1
        for loop in face.loop_indices:
            point = made.data.vertices[made.data.loops[loop].vertex_index].co
            layer.data[loop].uv = (point.x, point.z) if is_cap else (point.x + point.z, point.y)
            if is_warped and is_cap and point.x > 0.5 and point.z > 0.5:
                layer.data[loop].uv = (0.7, 0.9)
    return made


def sphere():
    bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=12, radius=0.5)
    bpy.context.object.name = "Ball"


def opened():
    made = wall()
    faces = [list(face.vertices) for face in made.data.polygons][:-1]
    points = [tuple(point.co) for point in made.data.vertices]
    bpy.data.objects.remove(made)
    return add("Open", points, faces)


def rounded():
    """A slab with rounded corners: a curved outline, yet a prism."""
    bpy.ops.mesh.primitive_cylinder_add(vertices=48, radius=0.6, depth=0.2)
    bpy.context.object.name = "Disc"


EXPORTS = {
    "glb": lambda path: bpy.ops.export_scene.gltf(filepath=path, export_format="GLB"),
    "gltf": lambda path: bpy.ops.export_scene.gltf(filepath=path, export_format="GLTF_EMBEDDED"),
    "obj": lambda path: bpy.ops.wm.obj_export(filepath=path),
    "fbx": lambda path: bpy.ops.export_scene.fbx(filepath=path),
    "stl": lambda path: bpy.ops.export_mesh.stl(filepath=path),
    "ply": lambda path: bpy.ops.export_mesh.ply(filepath=path),
}


def make(name, formats, build):
    start()
    build()
    for ending in formats:
        EXPORTS[ending](os.path.join(FOLDER, name + "." + ending))


def pair():
    wall()
    gable().location = (0.5, 0.0, 1.0)


make("wall", ["glb", "gltf", "obj", "fbx", "stl", "ply"], wall)
make("window", ["glb", "stl"], window)
make("gable", ["obj", "ply"], gable)
make("corner", ["fbx", "glb", "obj"], l_shape)
make("pair", ["glb", "obj", "fbx", "stl"], pair)
make("textured", ["glb", "obj", "fbx"], textured)
make("warped", ["glb"], lambda: textured(is_warped=True))
make("disc", ["glb"], rounded)
make("shifted", ["stl"], lambda: prism("Shifted", [(0, 0), (1, 0), (1, 1), (0, 1)], 0.5, shift=(0.0024, 0.0032)))
make("leaning", ["ply"], lambda: prism("Leaning", [(0, 0), (1, 0), (1, 1), (0, 1)], 0.5, inset=0.0716778))
make("open", ["obj"], opened)
make("sphere", ["glb"], sphere)
