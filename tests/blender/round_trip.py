"""Imports mesh files into Blender, each into an empty scene, and prints a line of JSON for each.

blender --background --factory-startup --python round_trip.py -- FILE...
"""
import json
import sys

import bmesh
import bpy
import numpy

numpy.bool = bool  # Blender 3.4's importer of glTF uses this name, which numpy 1.24 no longer has


def open_file(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)  # converts y up to z up
    else:
        bpy.ops.import_scene.gltf(filepath=path)


def weld(shape):
    """Welds vertices at exactly the same position: in glTF, faces with different normals share none."""
    first = {}
    doubles = {vertex: first.setdefault(tuple(vertex.co), vertex) for vertex in shape.verts}
    bmesh.ops.weld_verts(shape, targetmap={vertex: other for vertex, other in doubles.items() if vertex is not other})


def volume(mesh):
    """In double precision, which bmesh's own sum is not."""
    mesh.calc_loop_triangles()
    total = 0.0
    for triangle in mesh.loop_triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (tuple(mesh.vertices[i].co) for i in triangle.vertices)
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6.0


def described(thing, path):
    shape = bmesh.new()
    shape.from_mesh(thing.data)
    if path.endswith(".glb"):
        weld(shape)
    result = {
        "name": thing.name,
        "closed": all(edge.is_manifold and edge.is_contiguous for edge in shape.edges),
        "manifold": all(vertex.is_manifold for vertex in shape.verts),
        "volume": volume(thing.data),
        "materials": [slot.material.name for slot in thing.material_slots],
        "uvs": len(thing.data.uv_layers),
    }
    shape.free()
    return result


def image_size(material):
    """Of the image that the base colour is multiplied by or is; None without one."""
    for node in material.node_tree.nodes:
        if node.type == "TEX_IMAGE" and node.outputs["Color"].is_linked:
            return list(node.image.size)
    return None


for path in sys.argv[sys.argv.index("--") + 1:]:
    open_file(path)
    things = [described(thing, path) for thing in bpy.data.objects if thing.type == "MESH"]
    corners = [thing.matrix_world @ vertex.co for thing in bpy.data.objects if thing.type == "MESH"
               for vertex in thing.data.vertices]
    highest = [max(corner[axis] for corner in corners) for axis in range(3)]
    textured = {material.name: image_size(material) for material in bpy.data.materials
                if material.use_nodes and image_size(material)}
    print("ROUND TRIP", json.dumps({"file": path, "objects": things, "highest": highest, "textured": textured}))
