"""Imports an export of Rubble into Unreal Engine 5: Tools > Execute Python Script...

NOT TESTED in Unreal Engine: it follows the documentation of its Python API.

Imports the GLB files of each pack into /Game/Rubble/<pack>, makes a Geometry Collection of the fragments that do not
break further, and places one for each instance of scene.json in the open level. Needs the plugins Python Editor Script
Plugin and Geometry Collection. Run again, it replaces the assets; delete the actors of the run before by hand.

Chaos has one damage threshold for a collection. Of an asset that breaks along bonds it is the median of what they take;
the bonds themselves, and mortar between instances, are in pack.json and scene.json only. What anchors hold is kinematic
until it breaks.
"""

import json
import os

import unreal

TARGET = "/Game/Rubble"
EXPORT = os.path.dirname(os.path.abspath(__file__))


def load(*path):
    with open(os.path.join(EXPORT, *path), encoding="utf-8") as file:
        return json.load(file)


def vector(point):
    """A position in m with y up, in Unreal's axes: cm, z up, left-handed."""
    return unreal.Vector(100.0 * point[0], 100.0 * point[2], 100.0 * point[1])


def rotator(quaternion):
    x, y, z, w = quaternion
    return unreal.Quat(-x, -z, -y, w).rotator()


def import_meshes(pack, folder):
    """The static meshes of the fragments that do not break further, by name."""
    target = f"{TARGET}/{folder}"
    tasks = []
    for mesh in pack["meshes"]:
        if not mesh["file"].endswith(".glb") or mesh["bodies"] == "whole" or mesh.get("level") is not None:
            continue
        task = unreal.AssetImportTask()
        task.set_editor_property("filename", os.path.join(EXPORT, folder, mesh["file"]))
        task.set_editor_property("destination_path", target)
        for name in ("automated", "replace_existing", "save"):
            task.set_editor_property(name, True)
        tasks.append(task)
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks(tasks)
    meshes = {}
    for path in unreal.EditorAssetLibrary.list_assets(target, recursive=True):
        asset = unreal.EditorAssetLibrary.load_asset(path)
        if isinstance(asset, unreal.StaticMesh) and not asset.get_name().startswith("UCX_"):
            meshes[asset.get_name()] = asset
    return meshes


def centre(body):
    """The centre of the bounds of a body in the asset's frame, m."""
    low, high = body["bounds"]["min"], body["bounds"]["max"]
    return [body["offset"][axis] + (low[axis] + high[axis]) / 2.0 for axis in range(3)]


def place(body, mesh, actors):
    """An actor with a fragment's mesh where the asset has it, whether or not the import moved it into the mesh."""
    location = vector(centre(body)) - mesh.get_bounds().origin
    return actors.spawn_actor_from_object(mesh, location)


def collections():
    paths = unreal.EditorAssetLibrary.list_assets("/Game", recursive=True)
    return {path for path in paths if isinstance(unreal.EditorAssetLibrary.load_asset(path), unreal.GeometryCollection)}


def threshold_of(pack):
    """N·s: of the whole, or the median of the bonds between its fragments; None if it never breaks."""
    if "bonding" not in pack:
        return pack["whole"].get("threshold")
    bonds = [bond for fracture in pack["bonding"]["fractures"] for bond in fracture["bonds"]]
    capacities = sorted(bond["capacity"] for bond in bonds if bond["capacity"])
    return capacities[len(capacities) // 2] if capacities else None


def hold(actor):
    """Keeps in place what is held by anchors, until it breaks."""
    component = actor.get_editor_property("geometry_collection_component")
    component.set_editor_property("object_type", unreal.ObjectStateTypeEnum.CHAOS_OBJECT_KINEMATIC)


def make_collection(pack, folder, actors):
    """A Geometry Collection of the fragments that do not break further."""
    meshes = import_meshes(pack, folder)
    leaves = [body for body in pack["fragments"] if body["childCount"] == 0]
    missing = [body["name"] for body in leaves if body["name"] not in meshes]
    if missing:
        raise RuntimeError(f"{folder}: the import made no static mesh {missing[0]}; is Combine Static Meshes off?")
    parts = [place(body, meshes[body["name"]], actors) for body in leaves]
    before = collections()
    actors.set_selected_level_actors(parts)
    unreal.SystemLibrary.execute_console_command(None, "GeometryCollection.CreateFromSelectedActors")
    made = collections() - before
    for actor in parts:
        actors.destroy_actor(actor)
    if len(made) != 1:
        raise RuntimeError(f"{folder}: no Geometry Collection was made; is its plugin enabled?")
    target = f"{TARGET}/{folder}/{folder}_collection"
    if unreal.EditorAssetLibrary.does_asset_exist(target):
        unreal.EditorAssetLibrary.delete_asset(target)
    unreal.EditorAssetLibrary.rename_asset(made.pop(), target)
    collection = unreal.EditorAssetLibrary.load_asset(target)
    threshold = threshold_of(pack)
    if threshold is not None:
        collection.set_editor_property("damage_threshold", [100.0 * threshold])  # N·s is 100 kg·cm/s
    unreal.EditorAssetLibrary.save_asset(target)
    return collection


def main():
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    folders = sorted(name for name in os.listdir(EXPORT) if os.path.isfile(os.path.join(EXPORT, name, "pack.json")))
    made = {}
    for folder in folders:
        made[folder] = make_collection(load(folder, "pack.json"), folder, actors)
    count = 0
    if os.path.isfile(os.path.join(EXPORT, "scene.json")):
        for instance in load("scene.json")["instances"]:
            actor = actors.spawn_actor_from_object(made[instance["pack"]], vector(instance["position"]),
                                                   rotator(instance["rotation"]))
            actor.set_actor_label(instance["name"])
            if instance.get("fixed") or instance.get("anchors") or instance.get("holdsHeaviest"):
                hold(actor)
            count += 1
    unreal.log(f"Rubble: {len(made)} Geometry Collections, {count} instances")


main()
