"""Runs import_into_unreal.py of an export against a substitute for the few names of Unreal's Python API that it uses:
python3 unreal.py EXPORT. The substitute reads the GLB files as the documentation of Unreal says: centimetres, y and z
exchanged, a static mesh for each mesh, moved by its node or not. It shows that the script finds every fragment and puts
it where the pack has it, not that it runs in Unreal Engine.
"""
import json
import math
import os
import struct
import sys
import types

EXPORT = os.path.abspath(sys.argv[1])
TOLERANCE = 1e-3  # cm


class Vector:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __sub__(self, other):
        return Vector(self.x - other.x, self.y - other.y, self.z - other.z)

    def __add__(self, other):
        return Vector(self.x + other.x, self.y + other.y, self.z + other.z)

    def length(self):
        return math.sqrt(self.x**2 + self.y**2 + self.z**2)


class Quat:
    def __init__(self, x, y, z, w):
        self.x, self.y, self.z, self.w = x, y, z, w

    def rotator(self):
        return self

    def rotated(self, v):
        """v + 2 w (q x v) + 2 q x (q x v), which has this form in either handedness."""
        q = (self.x, self.y, self.z)
        cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        t = tuple(2 * c for c in cross(q, (v.x, v.y, v.z)))
        u = cross(q, t)
        return Vector(v.x + self.w * t[0] + u[0], v.y + self.w * t[1] + u[1], v.z + self.w * t[2] + u[2])


class Named:
    def get_name(self):
        return self.name


class StaticMesh(Named):
    def __init__(self, name, middle):
        self.name, self.middle = name, middle

    def get_bounds(self):
        return types.SimpleNamespace(origin=self.middle)


class GeometryCollection(Named):
    def __init__(self, name, parts):
        self.name, self.parts, self.properties = name, parts, {}

    def set_editor_property(self, name, value):
        self.properties[name] = value


class AssetImportTask:
    def __init__(self):
        self.properties = {}

    def set_editor_property(self, name, value):
        self.properties[name] = value


class Component:
    def __init__(self):
        self.properties = {}

    def set_editor_property(self, name, value):
        self.properties[name] = value


class Actor:
    def __init__(self, asset, location, rotation=None):
        self.asset, self.location, self.rotation, self.label = asset, location, rotation, None
        self.component = Component()

    def set_actor_label(self, label):
        self.label = label

    def get_editor_property(self, name):
        assert name == "geometry_collection_component", name
        return self.component


assets = {}
level, selected = [], []
is_moved_into_mesh = False


def import_glb(task):
    with open(task.properties["filename"], "rb") as file:
        data = file.read()
    size = struct.unpack_from("<I", data, 12)[0]
    gltf = json.loads(data[20:20 + size])
    for node in gltf["nodes"]:
        mesh = gltf["meshes"][node["mesh"]]
        bounds = [gltf["accessors"][primitive["attributes"]["POSITION"]] for primitive in mesh["primitives"]]
        low = [min(bound["min"][axis] for bound in bounds) for axis in range(3)]
        high = [max(bound["max"][axis] for bound in bounds) for axis in range(3)]
        shift = node["translation"] if is_moved_into_mesh else [0, 0, 0]
        x, y, z = ((low[axis] + high[axis]) / 2 + shift[axis] for axis in range(3))
        path = f"{task.properties['destination_path']}/{mesh['name']}"
        assets[path] = StaticMesh(mesh["name"], Vector(100 * x, 100 * z, 100 * y))


class Library:
    list_assets = staticmethod(lambda folder, recursive: [path for path in assets if path.startswith(folder + "/")])
    load_asset = staticmethod(lambda path: assets[path])
    does_asset_exist = staticmethod(lambda path: path in assets)
    delete_asset = staticmethod(lambda path: assets.pop(path))
    rename_asset = staticmethod(lambda old, new: assets.__setitem__(new, assets.pop(old)))
    save_asset = staticmethod(lambda path: assets[path])


class Actors:
    def spawn_actor_from_object(self, asset, location, rotation=None):
        level.append(Actor(asset, location, rotation))
        return level[-1]

    def set_selected_level_actors(self, actors):
        selected[:] = actors

    def destroy_actor(self, actor):
        level.remove(actor)


def console_command(world, command):
    assert command == "GeometryCollection.CreateFromSelectedActors", command
    parts = {actor.asset.name: actor.location + actor.asset.middle for actor in selected}
    assets["/Game/NewCollection"] = GeometryCollection("NewCollection", parts)


messages = []
sys.modules["unreal"] = types.SimpleNamespace(
    Vector=Vector, Quat=Quat, StaticMesh=StaticMesh, GeometryCollection=GeometryCollection,
    ObjectStateTypeEnum=types.SimpleNamespace(CHAOS_OBJECT_KINEMATIC="kinematic"),
    AssetImportTask=AssetImportTask, EditorAssetLibrary=Library, EditorActorSubsystem=Actors,
    get_editor_subsystem=lambda kind: kind(), log=messages.append,
    SystemLibrary=types.SimpleNamespace(execute_console_command=console_command),
    AssetToolsHelpers=types.SimpleNamespace(get_asset_tools=lambda: types.SimpleNamespace(
        import_asset_tasks=lambda tasks: [import_glb(task) for task in tasks])))


def converted(point):
    return Vector(100 * point[0], 100 * point[2], 100 * point[1])


def rotated_in_rubble(q, v):
    x, y, z, w = q
    return [(1 - 2 * (y * y + z * z)) * v[0] + 2 * (x * y - z * w) * v[1] + 2 * (x * z + y * w) * v[2],
            2 * (x * y + z * w) * v[0] + (1 - 2 * (x * x + z * z)) * v[1] + 2 * (y * z - x * w) * v[2],
            2 * (x * z - y * w) * v[0] + 2 * (y * z + x * w) * v[1] + (1 - 2 * (x * x + y * y)) * v[2]]


def check_collections():
    count = 0
    for folder in sorted(os.listdir(EXPORT)):
        if not os.path.isfile(os.path.join(EXPORT, folder, "pack.json")):
            continue
        with open(os.path.join(EXPORT, folder, "pack.json"), encoding="utf-8") as file:
            pack = json.load(file)
        collection = assets[f"/Game/Rubble/{folder}/{folder}_collection"]
        leaves = [body for body in pack["fragments"] if body["childCount"] == 0]
        assert len(collection.parts) == len(leaves), folder
        for body in leaves:
            low, high = body["bounds"]["min"], body["bounds"]["max"]
            there = converted([body["offset"][axis] + (low[axis] + high[axis]) / 2 for axis in range(3)])
            error = (collection.parts[body["name"]] - there).length()
            assert error < TOLERANCE, f"{body['name']} is off by {error} cm"
            hulls = [path for path in assets if path.startswith(f"/Game/Rubble/{folder}/UCX_{body['name']}_")]
            assert len(hulls) == len(body["hulls"]), f"{body['name']} has {len(hulls)} hulls"
            count += 1
        [threshold] = collection.properties["damage_threshold"]
        if "bonding" in pack:
            bonds = [bond["capacity"] for fracture in pack["bonding"]["fractures"] for bond in fracture["bonds"]]
            stronger = sum(100 * bond >= threshold for bond in bonds if bond)
            assert abs(2 * stronger - len(bonds)) <= len(bonds) / 10, folder
        else:
            assert threshold == 100 * pack["whole"]["threshold"]
    return count


def check_instances():
    with open(os.path.join(EXPORT, "scene.json"), encoding="utf-8") as file:
        instances = json.load(file)["instances"]
    assert [actor.label for actor in level] == [instance["name"] for instance in instances]
    for actor, instance in zip(level, instances):
        is_held = bool(instance.get("fixed") or instance.get("anchors") or instance.get("holdsHeaviest"))
        assert (actor.component.properties.get("object_type") == "kinematic") == is_held, instance["name"]
        for corner in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
            turned = rotated_in_rubble(instance["rotation"], corner)
            there = converted([instance["position"][axis] + turned[axis] for axis in range(3)])
            here = actor.location + actor.rotation.rotated(converted(corner))
            assert (here - there).length() < TOLERANCE, instance["name"]
    return len(instances)


for is_moved_into_mesh in (False, True):
    assets.clear()
    level.clear()
    with open(os.path.join(EXPORT, "import_into_unreal.py"), encoding="utf-8") as file:
        source = file.read()
    exec(compile(source, "import_into_unreal.py", "exec"),
         {"__name__": "__main__", "__file__": os.path.join(EXPORT, "import_into_unreal.py")})
    print(f"{check_collections()} fragments and {check_instances()} instances are where the export has them, with nodes "
          f"{'moved into meshes' if is_moved_into_mesh else 'apart'}")
print(messages[-1])
