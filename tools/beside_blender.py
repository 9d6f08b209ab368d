"""Renders a scene of Rubble in Blender, from a GLB animation, with the camera of rubble-cli render.

blender -b --python tools/beside_blender.py -- GLB PICTURE eevee|workbench AZIMUTH ELEVATION WIDTH HEIGHT FRAME [BOX]

Angles in degrees; BOX: what is framed, [[x, y, z], [x, y, z]] in m, y up; otherwise all that there is in frame 0.
"""

import json
import math
import sys

import numpy

numpy.bool = bool  # which Blender's reader of glTF still calls so

import bpy
from mathutils import Matrix, Vector

FIELD_OF_VIEW, MARGIN = 0.6, 1.08  # as in viewport/scene/Camera
GROUND = (0.6, 0.6, 0.57, 1.0)


def axes(azimuth, elevation):
    """Right, up and back of a camera, y up."""
    back = Vector((math.sin(azimuth) * math.cos(elevation), math.sin(elevation), math.cos(azimuth) * math.cos(elevation)))
    right = Vector((math.cos(azimuth), 0.0, -math.sin(azimuth)))
    return right, back.cross(right), back


def framing(low, high, camera_axes, aspect):
    """The eye from which a box fills the image."""
    right, up, back = camera_axes
    centre, tangent, distance = (low + high) / 2, math.tan(FIELD_OF_VIEW / 2), 0.0
    for corner in range(8):
        arm = Vector([(high if corner >> k & 1 else low)[k] for k in range(3)]) - centre
        across = max(abs(arm.dot(right)) / aspect, abs(arm.dot(up)))
        distance = max(distance, MARGIN * across / tangent + arm.dot(back))
    return centre + distance * back


def z_up(v):
    return Vector((v[0], -v[2], v[1]))


def box_of(scene):
    corners = [o.matrix_world @ Vector(c) for o in scene.objects if o.type == "MESH" for c in o.bound_box]
    points = [(p.x, p.z, -p.y) for p in corners]
    return [Vector([choose(p[k] for p in points) for k in range(3)]) for choose in (min, max)]


def add_camera(scene, eye, camera_axes):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle, camera.clip_start, camera.clip_end = "VERTICAL", FIELD_OF_VIEW, 0.01, 1000.0
    placed = bpy.data.objects.new("camera", camera)
    scene.collection.objects.link(placed)
    columns = [z_up(axis) for axis in camera_axes] + [z_up(eye)]
    placed.matrix_world = Matrix([[column[row] for column in columns] for row in range(3)] + [[0, 0, 0, 1]])
    scene.camera = placed


def add_ground():
    bpy.ops.mesh.primitive_plane_add(size=400)
    material = bpy.data.materials.new("ground")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = material.diffuse_color = GROUND
    surface.inputs["Roughness"].default_value = 0.9
    bpy.context.object.data.materials.append(material)


def show_colours_in_workbench():
    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else []:
            if node.type == "BSDF_PRINCIPLED":
                material.diffuse_color = node.inputs["Base Color"].default_value


def add_light(scene):
    """A bluish sky and a sun, from where the key light of Rubble's studio is."""
    world = scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    sky = world.node_tree.nodes["Background"].inputs
    sky[0].default_value, sky[1].default_value = (0.85, 0.9, 1.0, 1.0), 0.6
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.angle = 4.5, 0.08
    placed = bpy.data.objects.new("sun", sun)
    placed.rotation_euler = (math.radians(40), math.radians(-25), 0.0)
    scene.collection.objects.link(placed)


def use_eevee(scene):
    scene.render.engine = "BLENDER_EEVEE"
    scene.eevee.use_gtao, scene.eevee.gtao_distance, scene.eevee.taa_render_samples = True, 1.0, 32
    scene.eevee.use_soft_shadows, scene.eevee.shadow_cascade_size = True, "2048"
    scene.view_settings.look = "Medium High Contrast"


def use_workbench(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    shading = scene.display.shading
    shading.light, shading.color_type = "STUDIO", "MATERIAL"
    shading.show_cavity, shading.cavity_type, shading.show_shadows = True, "BOTH", True
    scene.display.render_aa, scene.view_settings.view_transform = "16", "Standard"


def main():
    glb, picture, engine, azimuth, elevation, width, height, frame, *box = sys.argv[sys.argv.index("--") + 1 :]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=glb)
    scene = bpy.context.scene
    scene.frame_set(0)
    low, high = [Vector(corner) for corner in json.loads(box[0])] if box else box_of(scene)
    scene.frame_set(int(frame))
    camera_axes = axes(math.radians(float(azimuth)), math.radians(float(elevation)))
    add_camera(scene, framing(low, high, camera_axes, int(width) / int(height)), camera_axes)
    add_ground()
    show_colours_in_workbench()
    add_light(scene)
    {"eevee": use_eevee, "workbench": use_workbench}[engine](scene)
    scene.render.resolution_x, scene.render.resolution_y, scene.render.filepath = int(width), int(height), picture
    bpy.ops.render.render(write_still=True)


main()
