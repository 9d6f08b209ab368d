"""Writes the meshes of this folder, which are boxes of 2 x 1 x 0.25 m unless cases.json says otherwise, and cases.json,
what each must be read as. The numbers follow from how a mesh is made; none comes from Rubble.

python3 make.py

The files in compressed/ are boxes of the same kind, compressed by gltfpack 1.3 with the options in their names, and by
gltf-pipeline 4.3, and four of glTF-Transform 4.5; they stay as they are.
"""
import base64
import json
import math
import os
import random
import struct

FOLDER = os.path.dirname(os.path.abspath(__file__))
SIZE = (2.0, 1.0, 0.25)
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]  # outwards
cases = {}


def write(name, content):
    path = os.path.join(FOLDER, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def asset(name, at, size=SIZE, copies=0):
    volume = size[0] * size[1] * size[2]
    return {"name": name, "volume": volume, "at": list(at), "instances": 1 + copies}


def case(name, content, assets=None, error=None, rejected=None, notes=None):
    write(name, content)
    expected = {"error": error} if error else {"assets": assets or []}
    if rejected:
        expected["rejected"] = rejected
    if notes:
        expected["notes"] = notes
    cases[name] = expected


def corners(at=(0, 0, 0), size=SIZE):
    """The corners of a box around a centre."""
    return [tuple(at[k] + (bits >> k & 1) * size[k] - size[k] / 2 for k in range(3)) for bits in range(8)]


def triangles():
    return [t for a, b, c, d in FACES for t in ((a, b, c), (a, c, d))]


# glTF

INDICES = struct.pack("<36H", *[i for t in triangles() for i in t])


def positions(at=(0, 0, 0), size=SIZE):
    return b"".join(struct.pack("<3f", *corner) for corner in corners(at, size))


def gltf(data=None, uri=None, **changes):
    """A box whose positions are view 0 and accessor 0, and whose indices are view 1 and accessor 1."""
    data = positions() + INDICES if data is None else data
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "Wall", "mesh": 0}],
        "meshes": [{"name": "box", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": len(data), "uri": uri or data_uri(data)}]}
    for key, value in changes.items():
        if value is None:
            del document[key]
        else:
            document[key] = value
    return document


def data_uri(data):
    return "data:application/octet-stream;base64," + base64.b64encode(data).decode()


def text(document):
    return json.dumps(document)


def glb(document, binary, padding=b" "):
    body = json.dumps(document).encode()
    body += padding * (-len(body) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(body), 0x4e4f534a) + body + struct.pack("<II", len(binary), 0x004e4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def more(data, accessors):
    """Changes that put more accessors behind the box: pairs of an accessor's values and its bytes."""
    document = gltf()
    views, all_accessors = document["bufferViews"], document["accessors"]
    for values, content in accessors:
        data += b"\0" * (-len(data) % 4)
        all_accessors.append({"bufferView": len(views), **values})
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
        data += content
    return {"data": data, "accessors": all_accessors, "bufferViews": views}


WALL = [asset("Wall", (0, 0, 0))]
BOX = positions() + INDICES


def links():
    """URIs, which are decoded once."""
    for title, uri, file in [
            ("space", "my%20wall.bin", "my wall.bin"), ("raw space", "my wall.bin", None),
            ("umlaut", "w%C3%A4nde.bin", "w\u00e4nde.bin"), ("raw umlaut", "w\u00e4nde.bin", None),
            ("percent", "100%25.bin", "100%.bin"), ("twice", "my%2520wall.bin", "my%20wall 2.bin"),
            ("folder", "parts/wall%201.bin", "parts/wall 1.bin"), ("slash", "parts%2Fwall%201.bin", None),
            ("dot", "./parts/../my%20wall.bin", None), ("hash", "wall%231.bin", "wall#1.bin"),
            ("lower", "w%c3%a4nde.bin", None), ("backslash", "parts\\\\wall 1.bin".replace("\\\\", "\\"), None),
            ("plus", "a+b.bin", "a+b.bin"), ("invalid escape", "50%zz.bin", "50%zz.bin")]:
        if title == "twice":
            file = "my%20wall.bin.2"
            uri = "my%2520wall.bin.2"
        if file:
            write("links/" + file, BOX)
        case("links/" + title + ".gltf", text(gltf(uri=uri)), WALL)
    write("links/raw%20name.bin", BOX)
    case("links/raw name wins.gltf", text(gltf(uri="raw%20name.bin")), WALL)
    write("links/wall.bin", BOX)
    outside = ', which lies outside its folder; only files in the folder of a mesh and below are read.'
    for title, uri, why in [
            ("missing folder", "none/wall.bin", ", which does not exist."),
            ("missing", "lost.bin", ", which does not exist."),
            ("missing with escape", "lost%20wall.bin", ", which does not exist."),
            ("decoded once only", "my%252520wall.bin", ", which does not exist."),
            ("null", "wall.bin%00.png", ", which does not exist."),
            ("a folder", "parts", ", which is no file that can be read."),
            ("escaped parent", "..%2Fwall.bin", outside), ("escaped parents", "%2e%2e/%2e%2e/wall.bin", outside),
            ("parent", "../wall.bin", outside), ("escaped root", "%2Fetc%2Fpasswd", outside),
            ("root", "/etc/passwd", outside), ("address", "https://example.org/wall.bin", outside)]:
        name = title + ".gltf"
        case("links/" + name, text(gltf(uri=uri)), error='"%s" refers to "%s"%s' % (name, uri, why))


def extensions():
    """Required and used extensions."""
    for extension in ["ACME_warp", "CESIUM_RTC", "KHR_meshopt_compression", "MSFT_lod", "EXT_mesh_manifold",
                      "KHR_implicit_shapes", "MPEG_media", "KHR_gaussian_splatting",
                      "ADOBE_materials_thin_transparency", "khr_mesh_quantization"]:
        name = "required " + extension + ".gltf"
        case("extensions/" + name, text(gltf(extensionsUsed=[extension], extensionsRequired=[extension])),
             error='"%s" requires the glTF extension "%s", which is not supported.' % (name, extension))
    for extension in ["KHR_materials_unlit", "KHR_materials_transmission", "KHR_lights_punctual", "KHR_texture_basisu",
                      "EXT_texture_webp", "KHR_texture_transform", "KHR_mesh_quantization", "KHR_node_visibility",
                      "KHR_materials_variants", "KHR_xmp_json_ld", "KHR_materials_pbrSpecularGlossiness"]:
        case("extensions/harmless " + extension + ".gltf",
             text(gltf(extensionsUsed=[extension], extensionsRequired=[extension])), WALL)
    for extension in ["ACME_warp", "MSFT_lod"]:
        case("extensions/used " + extension + ".gltf", text(gltf(extensionsUsed=[extension])), WALL)


def quantized():
    """Positions as integers: KHR_mesh_quantization."""
    required = {"extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]}
    for title, kind, letter, most, normalized in [
            ("byte", 5120, "b", 127, False), ("unsigned byte", 5121, "B", 254, False),
            ("short", 5122, "h", 32766, False), ("unsigned short", 5123, "H", 65534, False),
            ("normalized byte", 5120, "b", 127, True), ("normalized unsigned byte", 5121, "B", 255, True),
            ("normalized short", 5122, "h", 32767, True), ("normalized unsigned short", 5123, "H", 65535, True)]:
        for stride in (0, 4 if letter in "bB" else 8):
            signed = letter in "bh"
            low, high = (-most, most) if signed else (0, most)
            values = [[high if bits >> k & 1 else low for k in range(3)] for bits in range(8)]
            pad = stride - 3 * struct.calcsize(letter) if stride else 0
            data = b"".join(struct.pack("<3" + letter, *value) + b"\7" * pad for value in values)
            size = len(data)
            data += b"\0" * (-len(data) % 4)
            span = (2.0 if signed else 1.0) if normalized else float(high - low)
            views = [{"buffer": 0, "byteOffset": 0, "byteLength": size},
                     {"buffer": 0, "byteOffset": len(data), "byteLength": 72}]
            if stride:
                views[0]["byteStride"] = stride
            accessors = [{"bufferView": 0, "componentType": kind, "count": 8, "type": "VEC3"},
                         {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]
            if normalized:
                accessors[0]["normalized"] = True
            nodes = [{"name": "Wall", "mesh": 0, "scale": [side / span for side in SIZE],
                      "translation": [0, 0, 0] if signed else [-side / 2 for side in SIZE]}]
            case("quantized/%s%s.gltf" % (title, " padded" if stride else ""),
                 text(gltf(data + INDICES, bufferViews=views, accessors=accessors, nodes=nodes, **required)), WALL)


def instances():
    """EXT_mesh_gpu_instancing"""
    def build(name, count, assets, required=True, node=None, **attributes):
        kinds = {"TRANSLATION": "VEC3", "ROTATION": "VEC4", "SCALE": "VEC3"}
        values = [({"componentType": 5126, "count": count, "type": kinds[key]},
                   struct.pack("<%df" % len(numbers), *numbers)) for key, numbers in attributes.items()]
        extension = {"attributes": {key: 2 + i for i, key in enumerate(attributes)}}
        used = {"extensionsUsed": ["EXT_mesh_gpu_instancing"]}
        if required:
            used["extensionsRequired"] = used["extensionsUsed"]
        nodes = [{"name": "Wall", "mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": extension}, **(node or {})}]
        case("instances/" + name, text(gltf(**more(BOX, values), nodes=nodes, **used)), assets)
    half = 0.5 ** 0.5
    three = [0, 0, 0, 4, 0, 0, 8, 0, 0]
    build("three.gltf", 3, [asset("Wall", (0, 0, 0), copies=2)], TRANSLATION=three)
    build("only used.gltf", 3, [asset("Wall", (0, 0, 0), copies=2)], required=False, TRANSLATION=three)
    build("one.gltf", 1, [asset("Wall", (5, 0, 0))], TRANSLATION=[5, 0, 0])
    build("rotated.gltf", 2, [asset("Wall", (0, 0, 0), copies=1)], TRANSLATION=[0, 0, 0, 4, 0, 0],
          ROTATION=[0, 0, 0, 1, 0, half, 0, half])
    build("rotations alone.gltf", 2, [asset("Wall", (0, 0, 0), copies=1)], ROTATION=[0, 0, 0, 1, 0, half, 0, half])
    build("scaled alike.gltf", 2, [asset("Wall", (0, 0, 0), (4, 2, 0.5), copies=1)], TRANSLATION=[0, 0, 0, 9, 0, 0],
          SCALE=[2] * 6)
    build("scaled.gltf", 2, [asset("Wall", (0, 0, 0)), asset("Wall 2", (9, 0, 0), (4, 2, 0.5))],
          TRANSLATION=[0, 0, 0, 9, 0, 0], SCALE=[1, 1, 1, 2, 2, 2])
    build("two sizes in turn.gltf", 4,
          [asset("Wall", (0, 0, 0), copies=1), asset("Wall 2", (9, 0, 0), (4, 2, 0.5), copies=1)],
          TRANSLATION=[0, 0, 0, 9, 0, 0, 20, 0, 0, 30, 0, 0], SCALE=[1, 1, 1, 2, 2, 2, 1, 1, 1, 2, 2, 2])
    build("mirrored.gltf", 2, [asset("Wall", (0, 0, 0)), asset("Wall 2", (4, 0, 0))], TRANSLATION=[0, 0, 0, 4, 0, 0],
          SCALE=[1, 1, 1, -1, 1, 1])
    build("in a moved node.gltf", 2, [asset("Wall", (0, 3, 0), copies=1)], node={"translation": [0, 3, 0]},
          TRANSLATION=[0, 0, 0, 4, 0, 0])
    build("in a scaled node.gltf", 2, [asset("Wall", (0, 0, 0), (4, 2, 0.5), copies=1)], node={"scale": [2, 2, 2]},
          TRANSLATION=[0, 0, 0, 4, 0, 0])


def morphs_and_skins():
    thicker = b"".join(struct.pack("<3f", 0, 0, 0.5 if bits & 4 else 0) for bits in range(8))
    wider = b"".join(struct.pack("<3f", 1 if bits & 1 else 0, 0, 0) for bits in range(8))
    target = {"componentType": 5126, "count": 8, "type": "VEC3"}
    data = more(BOX, [(target, thicker), (target, wider)])

    def build(name, assets, weights=None, node=None, notes=None, **changes):
        mesh = {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
                                "targets": [{"POSITION": 2}, {"POSITION": 3}]}]}
        if weights:
            mesh["weights"] = weights
        case("morphs/" + name, text(gltf(**data, meshes=[mesh], nodes=[{"name": "Wall", "mesh": 0, **(node or {})}],
                                         **changes)), assets, notes=notes)
    thick, wide = asset("Wall", (0, 0, 0.25), (2, 1, 0.75)), asset("Wall", (0.5, 0, 0), (3, 1, 0.25))
    build("no weights.gltf", WALL)
    build("zero weights.gltf", WALL, [0, 0])
    build("first.gltf", [thick], [1, 0])
    build("second.gltf", [wide], [0, 1])
    build("both.gltf", [asset("Wall", (0.5, 0, 0.25), (3, 1, 0.75))], [1, 1])
    build("half.gltf", [asset("Wall", (0, 0, 0.125), (2, 1, 0.5))], [0.5, 0])
    build("node weights.gltf", [wide], [1, 0], {"weights": [0, 1]})
    build("node without mesh weights.gltf", [thick], node={"weights": [1, 0]})
    build("negative.gltf", [asset("Wall", (0, 0, -0.05), (2, 1, 0.15))], [-0.2, 0])
    build("moved.gltf", [asset("Wall", (0, 5, 0.25), (2, 1, 0.75))], [1, 0], {"translation": [0, 5, 0]})
    build("animated.gltf", [thick], [1, 0], notes=["The animations of the file are not read."],
          animations=[{"channels": [], "samplers": []}])

    joints = b"".join(struct.pack("<4B", 1 if bits & 1 else 0, 0, 0, 0) for bits in range(8))
    weights = struct.pack("<4f", 1, 0, 0, 0) * 8
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    shifted = identity[:12] + [-1, 0, 0, 1]
    skins = more(BOX, [({"componentType": 5121, "count": 8, "type": "VEC4"}, joints),
                       ({"componentType": 5126, "count": 8, "type": "VEC4"}, weights),
                       ({"componentType": 5126, "count": 2, "type": "MAT4"}, struct.pack("<32f", *identity, *shifted))])
    mesh = {"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}, "indices": 1}]}

    def skinned(name, assets, second, node=None):
        nodes = [{"name": "Wall", "mesh": 0, "skin": 0, **(node or {})}, {"children": [2]}, {"translation": second}]
        case("skins/" + name, text(gltf(**skins, meshes=[mesh], nodes=nodes, scenes=[{"nodes": [0, 1]}],
                                        skins=[{"joints": [1, 2], "inverseBindMatrices": 4}])), assets)
    skinned("bind pose.gltf", WALL, [1, 0, 0])
    skinned("stretched.gltf", [asset("Wall", (0.5, 0, 0), (3, 1, 0.25))], [2, 0, 0])
    skinned("squeezed.gltf", [asset("Wall", (-0.5, 0, 0), (1, 1, 0.25))], [0, 0, 0])
    skinned("node is ignored.gltf", WALL, [1, 0, 0], {"translation": [50, 0, 0]})


def nodes():
    """Names, transforms and scenes."""
    def build(name, assets, notes=None, **changes):
        case("nodes/" + name, text(gltf(**changes)), assets, notes=notes)
    nameless = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]
    build("without names.gltf", [asset("without names", (0, 0, 0))], nodes=[{"mesh": 0}], meshes=nameless)
    build("name of the mesh.gltf", [asset("box", (0, 0, 0))], nodes=[{"mesh": 0}])
    build("empty names.gltf", [asset("empty names", (0, 0, 0))], nodes=[{"mesh": 0, "name": ""}],
          meshes=[{"name": "", **nameless[0]}])
    build("same names.gltf", [asset("A", (0, 0, 0)), asset("A 2", (5, 0, 0))], scenes=[{"nodes": [0, 1]}],
          nodes=[{"name": "A", "mesh": 0}, {"name": "A", "mesh": 0, "translation": [5, 0, 0]}])
    build("same names and their numbers.gltf",
          [asset("A", (0, 0, 0)), asset("A 3", (5, 0, 0)), asset("A 2", (10, 0, 0)), asset("a 4", (15, 0, 0))],
          scenes=[{"nodes": [0, 1, 2, 3]}],
          nodes=[{"name": name, "mesh": 0, "translation": [5 * i, 0, 0]} for i, name in enumerate(["A", "A", "A 2", "a"])])
    hidden, visible = ({"KHR_node_visibility": {"visible": value}} for value in (False, True))
    parts = [{"children": [1, 3, 4]}, {"name": "A", "mesh": 0, "children": [2], "extensions": hidden},
             {"name": "B", "mesh": 0, "extensions": visible}, {"name": "C", "mesh": 0},
             {"name": "D", "mesh": 0, "translation": [5, 0, 0], "extensions": visible}]
    build("hidden.gltf", [asset("C", (0, 0, 0)), asset("D", (5, 0, 0))],
          ['Hidden in the file and not imported: "A", "B".'], nodes=parts, extensionsUsed=["KHR_node_visibility"])
    build("hidden without a mesh.gltf", [asset("A", (0, 0, 0))], scenes=[{"nodes": [0, 1]}],
          nodes=[{"name": "A", "mesh": 0}, {"name": "B", "extensions": hidden}])
    case("nodes/all hidden.gltf", text(gltf(nodes=[{"name": "A", "mesh": 0, "extensions": hidden}])),
         error='"all hidden.gltf" has only hidden objects; show what to import in the program that made it.')
    build("spaces.gltf", [asset("wall left", (0, 0, 0)), asset("wall right", (2, 0, 0))], scenes=[{"nodes": [0, 1]}],
          nodes=[{"name": "wall left", "mesh": 0}, {"name": "wall right", "mesh": 0, "translation": [2, 0, 0]}])
    build("name of the parent.gltf", [asset("Wall", (0, 0, 0))], meshes=nameless,
          nodes=[{"name": "Wall", "children": [1]}, {"mesh": 0}])
    build("two without names.gltf", [asset("two without names", (0, 0, 0)), asset("two without names 2", (5, 0, 0))],
          scenes=[{"nodes": [0, 1]}], nodes=[{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}], meshes=nameless)
    build("children.gltf", [asset("Wall", (1, 2, 0), (4, 2, 0.5))],
          nodes=[{"translation": [1, 2, 0], "children": [1]}, {"name": "Wall", "mesh": 0, "scale": [2, 2, 2]}])
    build("matrix.gltf", [asset("Wall", (1, 2, 3))],
          nodes=[{"name": "Wall", "mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]}])
    case("nodes/enormous.gltf", text(gltf(nodes=[{"name": "Wall", "mesh": 0, "scale": [1e200, 1e200, 1e200]}])),
         rejected=['"Wall": Point 0 of the mesh is out of range: 1e30 m or more from the origin.'])
    build("mirrored.gltf", WALL, nodes=[{"name": "Wall", "mesh": 0, "scale": [-1, 1, 1]}])
    build("no scene.gltf", WALL, scenes=None, scene=None)
    build("two scenes.gltf", [asset("B", (5, 0, 0))],
          ["The file has 2 scenes; only the one that it shows is read."], scene=1,
          scenes=[{"nodes": [0]}, {"nodes": [1]}],
          nodes=[{"name": "A", "mesh": 0}, {"name": "B", "mesh": 0, "translation": [5, 0, 0]}])
    body = gltf()
    body["buffers"] = [{"byteLength": len(BOX)}]
    case("nodes/binary.glb", glb(body, BOX), WALL)
    case("nodes/binary padded with nulls.glb", glb(body, BOX, b"\0"), WALL)
    for size in (1, 2, 3):  # as trimesh 2 wrote them: the first chunk is not padded
        odd = json.dumps(body).encode() + b" " * (-len(json.dumps(body)) % 4 + size)
        chunks = struct.pack("<II", len(odd), 0x4e4f534a) + odd + struct.pack("<II", len(BOX), 0x004e4942) + BOX
        case("nodes/binary %d behind a multiple of four.glb" % size,
             b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks, WALL)
    strip = struct.pack("<14H", 4, 5, 6, 7, 3, 5, 1, 4, 0, 6, 2, 3, 0, 1)
    build("strip.gltf", WALL, data=positions() + strip,
          meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 5}]}],
          accessors=[gltf()["accessors"][0], {"bufferView": 1, "componentType": 5123, "count": 14, "type": "SCALAR"}],
          bufferViews=[gltf()["bufferViews"][0], {"buffer": 0, "byteOffset": 96, "byteLength": 28}])
    sparse = {"count": 4, "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 3}}
    lifted = b"".join(struct.pack("<3f", x, y, z + 0.5) for x, y, z in corners()[4:])
    build("sparse.gltf", [asset("Wall", (0, 0, 0.25), (2, 1, 0.75))], data=BOX + b"\4\5\6\7" + lifted,
          accessors=[{**gltf()["accessors"][0], "sparse": sparse}, gltf()["accessors"][1]],
          bufferViews=gltf()["bufferViews"] + [{"buffer": 0, "byteOffset": 168, "byteLength": 4},
                                               {"buffer": 0, "byteOffset": 172, "byteLength": 48}])


# OBJ

def obj_points(at=(0, 0, 0), size=SIZE):
    return "".join("v %g %g %g\n" % corner for corner in corners(at, size))


def obj_faces(first=1, faces=range(6)):
    return "".join("f " + " ".join(str(first + i) for i in FACES[k]) + "\n" for k in faces)


def obj_box(at=(0, 0, 0), number=0, size=SIZE):
    return obj_points(at, size) + obj_faces(1 + 8 * number)


def objects():
    def build(name, assets, content):
        case("objects/" + name, content, assets)

    def several(name, *names, keyword="o", expected=None):
        """Boxes that touch each other, so that merged ones would be no solids."""
        content = "".join("%s %s\n%s" % (keyword, n, obj_box((2 * i, 0, 0), i)) for i, n in enumerate(names))
        build(name, [asset(n, (2 * i, 0, 0)) for i, n in enumerate(expected or names)], content)
    several("two words.obj", "wall left", "wall right", "wall top")
    several("three words.obj", "my wall left", "my wall right")
    several("number behind.obj", "wall 1", "wall 2", "wall 3", "wall 10")
    several("repeated.obj", "A", "B", "A", expected=["A", "B", "A 2"])
    several("all the same.obj", "A", "A", "A", expected=["A", "A 2", "A 3"])
    several("repeated with words.obj", "a wall", "a wall", expected=["a wall", "a wall 2"])
    several("umlauts.obj", "W\u00e4nde links", "W\u00e4nde rechts")
    several("punctuation.obj", "wall#1", "wall.001", "wall/a", "wall|b")
    several("groups as objects.obj", "wall left", "wall right", keyword="g")
    several("spaces around.obj", "  wall left  ", "\twall right", expected=["wall left", "wall right"])
    build("no names.obj", [asset("no names", (0, 0, 0))], obj_box())
    build("o without a name.obj", [asset("o without a name", (0, 0, 0))], "o\n" + obj_box())
    build("faces before the first object.obj",
          [asset("faces before the first object", (0, 0, 0)), asset("B", (2, 0, 0))],
          obj_box() + "o B\n" + obj_box((2, 0, 0), 1))
    build("empty object.obj", [asset("B", (0, 0, 0))], "o A\no B\n" + obj_box())
    cube = (1, 1, 1)
    for title, second in (("an edge", (1, 1, 0)), ("a corner", (1, 1, 1)), ("a face", (1, 0, 0))):
        places = [(0, 0, 0), second]
        points = sorted(set(corner for place in places for corner in corners(place, cube)))
        lines = "".join("v %g %g %g\n" % point for point in points)
        for place in places:
            own = corners(place, cube)
            lines += "".join("f " + " ".join(str(points.index(own[k]) + 1) for k in face) + "\n" for face in FACES)
        build("two that share %s.obj" % title, [asset("A", places[0], cube), asset("A 2", places[1], cube)],
              "o A\n" + lines)
    build("points first.obj", [asset("A", (0, 0, 0)), asset("B", (2, 0, 0))],
          obj_points() + obj_points((2, 0, 0)) + "o A\n" + obj_faces() + "o B\n" + obj_faces(9))


def groups():
    def build(name, assets, content):
        case("groups/" + name, content, assets)
    three = "g front\n" + obj_faces(1, [0]) + "g back\n" + obj_faces(1, [1]) + "g sides\n" + obj_faces(1, [2, 3, 4, 5])
    build("three in an object.obj", WALL, "o Wall\n" + obj_points() + three)
    build("six in an object.obj", WALL, "o Wall\n" + obj_points() +
          "".join("g side %d\n" % k + obj_faces(1, [k]) for k in range(6)))
    build("no object.obj", [asset("no object", (0, 0, 0))], obj_points() + three)
    build("same groups in two objects.obj", [asset("A", (0, 0, 0)), asset("B", (9, 0, 0))],
          "o A\n" + obj_points() + three + "o B\n" + obj_points((9, 0, 0)) + "g front\n" + obj_faces(9, [0]) +
          "g back\n" + obj_faces(9, [1]) + "g sides\n" + obj_faces(9, [2, 3, 4, 5]))
    build("closed and open.obj", [asset("whole", (9, 0, 0)), asset("front", (0, 0, 0))],
          "g whole\n" + obj_points((9, 0, 0)) + obj_faces() + obj_points() + "g front\n" + obj_faces(9, [0]) +
          "g rest\n" + obj_faces(9, range(1, 6)))
    build("two closed that touch.obj", [asset("A", (0, 0, 0)), asset("B", (2, 0, 0))],
          "g A\n" + obj_box() + "g B\n" + obj_box((2, 0, 0), 1))
    build("two open pairs.obj", [asset("A1", (0, 0, 0)), asset("B1", (9, 0, 0))],
          obj_points() + obj_points((9, 0, 0)) + "g A1\n" + obj_faces(1, [0, 1]) + "g A2\n" +
          obj_faces(1, range(2, 6)) + "g B1\n" + obj_faces(9, [0, 1]) + "g B2\n" + obj_faces(9, range(2, 6)))
    build("resumed.obj", [asset("A", (0, 0, 0)), asset("B", (9, 0, 0))],
          obj_points() + obj_points((9, 0, 0)) + "g A\n" + obj_faces(1, [0, 1, 2]) + "g B\n" + obj_faces(9) +
          "g A\n" + obj_faces(1, [3, 4, 5]))
    build("group around objects.obj", [asset("A", (0, 0, 0)), asset("B", (2, 0, 0))],
          "g all\no A\n" + obj_box() + "o B\n" + obj_box((2, 0, 0), 1))
    build("points of their own.obj", [asset("points of their own", (0, 0, 0))],
          "g front\n" + obj_points() + obj_faces(1, [0, 1, 2]) + "g back\n" + obj_points() + obj_faces(9, [3, 4, 5]))
    build("smoothing and materials.obj", WALL, "o Wall\n" + obj_points() + "s 1\nusemtl a\n" + obj_faces(1, [0, 1]) +
          "s off\nusemtl b\n" + obj_faces(1, range(2, 6)))
    build("group with several names.obj", [asset("group with several names", (0, 0, 0))],
          obj_points() + "g front wall\n" + obj_faces(1, [0]) + "g back wall\n" + obj_faces(1, range(1, 6)))


def obj_text():
    """What else OBJ allows."""
    def build(name, content, assets=None, error=None):
        case("obj-text/" + name, content, assets or (None if error else WALL), error=error)
    head = "o Wall\n"
    points, faces = obj_points(), obj_faces()
    build("comments after faces.obj", head + points + faces.replace("\n", "   # end\n"))
    build("comments without a space.obj", head + points + faces.replace("\n", " #end\n"))
    build("comments after points.obj", head + points.replace("\n", " # corner\n") + faces)
    build("colours.obj", head + points.replace("\n", " 0.5 0.25 1\n") + faces)
    build("weights.obj", head + points.replace("\n", " 1.0\n") + faces)
    build("continued lines.obj", head + points +
          "".join("f %d %d \\\n%d %d\n" % tuple(i + 1 for i in f) for f in FACES))
    build("continued twice.obj", head + points +
          "".join("f %d \\\r\n %d \\\r\n%d %d\r\n" % tuple(i + 1 for i in f) for f in FACES))
    build("crlf.obj", (head + points + faces).replace("\n", "\r\n"))
    build("cr.obj", (head + points + faces).replace("\n", "\r"))
    build("tabs.obj", (head + points + faces).replace("v ", "v\t").replace(" ", "\t").replace("o\t", "o "))
    build("no last line end.obj", (head + points + faces)[:-1])
    build("empty lines.obj", "\n\n" + (head + points + faces).replace("\n", "\n\n"))
    build("negative indices.obj", head + points + "".join("f " + " ".join(str(i - 8) for i in f) + "\n" for f in FACES))
    build("empty texture and normal.obj", head + points + "vn 0 0 1\n" + "".join(
        "f " + " ".join("%d//1" % (i + 1) for i in f) + "\n" for f in FACES))
    build("trailing slashes.obj", head + points + "".join(
        "f " + " ".join("%d//" % (i + 1) for i in f) + "\n" for f in FACES))
    build("plus signs.obj", head + "".join("v %+g %+g %+g\n" % corner for corner in corners()) + faces)
    build("exponents.obj", head + "".join("v %e %E %e\n" % corner for corner in corners()) + faces)
    build("indented.obj", "".join("   " + line + "\n" for line in (head + points + faces).splitlines()))
    build("byte order mark.obj", b"\xef\xbb\xbf" + (head + points + faces).encode())
    build("lines and points.obj", head + points + "l 1 2 3\np 1\n" + faces)
    build("unknown words.obj", head + points + "lod 3\nbevel on\nshadow_obj x\nfoo\n" + faces)
    build("missing materials.obj", "mtllib lost.mtl\n" + head + points + "usemtl Brick\n" + faces)
    cases["obj-text/missing materials.obj"]["notes"] = ["The file refers to \"lost.mtl\", which does not exist."]
    build("triangles.obj", head + points + "".join("f %d %d %d\n" % tuple(i + 1 for i in t) for t in triangles()))
    build("concave polygon.obj", "o Wall\n" + "".join("v %g %g %g\n" % (x, y, z) for z in (0, 1) for x, y in (
        (0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3))) + "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n" + "".join(
            "f %d %d %d %d\n" % (i + 1, (i + 1) % 6 + 1, (i + 1) % 6 + 7, i + 7) for i in range(6)),
          [{"name": "Wall", "volume": 5.0, "at": [1.5, 1.5, 0.5], "instances": 1}])
    for title, line, why in [
            ("missing point", "f 1 2 9", "refers to point 9 of 8"),
            ("point zero", "f 0 1 2", "refers to point 0 of 8"),
            ("missing point from the end", "f 1 2 -9", "refers to point -9 of 8"),
            ("no corner", "f one two three", "has an invalid corner")]:
        name = "error " + title + ".obj"
        build(name, head + points + line + "\n",
              error='"%s" cannot be read as OBJ: line 10, "%s", %s.' % (name, line, why))
    build("missing texture coordinates.obj", head + points + "".join(
        "f " + " ".join("%d/%d" % (i + 1, i + 1) for i in f) + "\n" for f in FACES))
    cases["obj-text/missing texture coordinates.obj"]["notes"] = [
        "The file refers to texture coordinates that it does not have."]
    build("error number.obj", head + "v 1 x 2\n" + faces,
          error='"error number.obj" cannot be read as OBJ: line 2, "v 1 x 2", has an invalid number.')
    build("error too few numbers.obj", head + "v 1 2\n" + faces,
          error='"error too few numbers.obj" cannot be read as OBJ: line 2, "v 1 2", has too few numbers.')


def maze(size, seed):
    """The outline of the corridors of a maze: squares that form a tree, with points on straight edges."""
    choice = random.Random(seed)
    squares, path = {(0, 0)}, [(0, 0)]
    while path:
        x, y = path[-1]
        free = [(dx, dy) for dx, dy in ((2, 0), (-2, 0), (0, 2), (0, -2))
                if 0 <= x + dx < 2 * size and 0 <= y + dy < 2 * size and (x + dx, y + dy) not in squares]
        if not free:
            path.pop()
            continue
        dx, dy = free[int(choice.random() * len(free))]
        squares |= {(x + dx // 2, y + dy // 2), (x + dx, y + dy)}
        path.append((x + dx, y + dy))
    after = {}
    for x, y in squares:
        for start, end, neighbour in [((x, y), (x + 1, y), (x, y - 1)), ((x + 1, y), (x + 1, y + 1), (x + 1, y)),
                                      ((x + 1, y + 1), (x, y + 1), (x, y + 1)), ((x, y + 1), (x, y), (x - 1, y))]:
            if neighbour not in squares:
                after[start] = end
    ring = [min(after)]
    while after[ring[-1]] != ring[0]:
        ring.append(after[ring[-1]])
    return ring


def polygons():
    """Prisms whose caps are one concave polygon each, counter-clockwise from above."""
    teeth = 12
    comb = [(0, 0), (2 * teeth, 0)] + [p for k in reversed(range(teeth)) for p in (
        (2 * k + 2, 3), (2 * k + 1, 3), (2 * k + 1, 1), (2 * k, 1))]
    spiral = [(0, 0), (9, 0), (9, 9), (0, 9), (0, 2), (7, 2), (7, 7), (2, 7), (2, 4), (5, 4), (5, 5), (3, 5), (3, 6),
              (6, 6), (6, 3), (1, 3), (1, 8), (8, 8), (8, 1), (0, 1)]
    star = [((3 if k % 2 == 0 else 1) * math.cos(math.pi * k / 9), (3 if k % 2 == 0 else 1) * math.sin(math.pi * k / 9))
            for k in range(18)]
    points_on_edges = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (2, 1), (1, 1), (1, 2), (1, 3), (0, 3), (0, 2), (0, 1)]
    arrow = [(0, 0), (4, 2), (0, 4), (3, 2)]
    for name, outline in [("comb", comb), ("spiral", spiral), ("star", star), ("arrow", arrow),
                          ("points on edges", points_on_edges), ("maze of 9", maze(3, 1)), ("maze of 25", maze(5, 1)),
                          ("maze of 64", maze(8, 2))]:
        count = len(outline)
        area = sum(outline[i - 1][0] * outline[i][1] - outline[i][0] * outline[i - 1][1] for i in range(count)) / 2
        at = [(min(p[k] for p in outline) + max(p[k] for p in outline)) / 2 for k in range(2)] + [1.0]
        # Those without an edge along an axis are turned, and so is the box whose centre is their origin.
        solid = {"volume": 2 * area, "instances": 1, **({} if name in ("star", "arrow") else {"at": at})}
        points = [(x, y, z) for z in (0, 2) for x, y in outline]
        for first in (0, 1, count // 2):  # where the polygons begin
            ring = [(i + first) % count for i in range(count)]
            faces = [ring[::-1], [i + count for i in ring]] + [[i, (i + 1) % count, (i + 1) % count + count, i + count]
                                                               for i in range(count)]
            title = "polygons/%s from %d" % (name, first)
            named = [{**solid, "name": "%s from %d" % (name, first)}]
            case(title + ".obj", "".join("v %.9g %.9g %.9g\n" % p for p in points) +
                 "".join("f " + " ".join(str(i + 1) for i in f) + "\n" for f in faces), named)
            case(title + ".ply", "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                 "property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
                 % (len(points), len(faces)) + "".join("%.9g %.9g %.9g\n" % p for p in points) +
                 "".join("%d " % len(f) + " ".join(map(str, f)) + "\n" for f in faces), named)


def far():
    def build(name, at, expected, size=SIZE, unit="obj"):
        content = "o Wall\n" + "".join("v %.6f %.6f %.6f\n" % corner for corner in corners(at, size)) + obj_faces()
        case("far/" + name, content, [asset("Wall", at, size)] if expected is None else [],
             rejected=None if expected is None else [
                 '"Wall": The mesh lies far away from the origin, at (%s) m, and %s; %smove it to the origin in the '
                 'program that made it.' % (*expected, "set its unit, or " if size[0] > 200 else "")])
    beyond = "positions go up to 100000 m"
    build("national grid.obj", (431235.5, 5765432.75, 120.125), ("431236, 5765433, 120.1", beyond))
    build("500 km along x.obj", (500000, 0, 0), ("500000, 0, 0", beyond))
    build("along minus y.obj", (0, -500000, 0), ("0, -500000, 0", beyond))
    build("along z.obj", (0, 0, 1e8), ("0, 0, 100000000", beyond))
    build("just beyond.obj", (100001, 0, 0), ("100001, 0, 0", beyond))
    build("just within.obj", (99000, 0, 0), ("99000, 0, 0", "its size of 225 mm is lost in single precision there"),
          (0.2, 0.1, 0.025))
    build("a small mesh at 5 km.obj", (5000, 0, 0),
          ("5000, 0, 0", "its size of 22.5 mm is lost in single precision there"), (0.02, 0.01, 0.0025))
    build("in millimetres.obj", (500000, 0, 0), ("500000, 0, 0", beyond), (2000, 1000, 250))
    build("at 1 km.obj", (1000, 0, 0), None)
    build("at 10 km.obj", (10000, 2000, 0), None)
    build("on a mountain.obj", (0, 2962, 0), None)
    build("a large mesh at 90 km.obj", (90000, 0, 0), None, (200, 100, 25))


# Rounding

def rotated(size, at, axis, degrees, outline=None):
    """The points of a box, or of the prism of an outline along z, rotated about an axis through the origin."""
    outline = outline or [(-size[0] / 2, -size[1] / 2), (size[0] / 2, -size[1] / 2), (size[0] / 2, size[1] / 2),
                          (-size[0] / 2, size[1] / 2)]
    length = math.sqrt(sum(a * a for a in axis))
    x, y, z = (a / length for a in axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    rows = [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]
    flat = [(px, py, pz) for pz in (-size[2] / 2, size[2] / 2) for px, py in outline]
    return [tuple(at[k] + sum(rows[k][i] * p[i] for i in range(3)) for k in range(3)) for p in flat]


def prism_faces(count):
    """The polygons of the prism of an outline with so many corners."""
    return ([list(range(count))[::-1], list(range(count, 2 * count))] +
            [[i, (i + 1) % count, count + (i + 1) % count, count + i] for i in range(count)])


def rounding():
    """Prisms in any direction whose points the file rounds, so that no cap is flat."""
    def expect(name, content, volume, at, **more):
        write("rounding/" + name, content)
        cases["rounding/" + name] = {"assets": [{"name": "Wall", "volume": volume, "at": list(at), "instances": 1}],
                                     "tolerance": 2e-3, **more}

    def obj(points, number, count=4):
        return ("o Wall\n" + "".join("v %s %s %s\n" % tuple(number % k for k in p) for p in points) +
                "".join("f " + " ".join(str(k + 1) for k in face) + "\n" for face in prism_faces(count)))
    wall = rotated((1, 0.8, 0.1), (3, 1, 2), (1, 2, 0.5), 40)
    for digits in (4, 5, 6):
        expect("%d decimals.obj" % digits, obj(wall, "%%.%df" % digits), 0.08, (3, 1, 2))
    expect("five significant digits.obj", obj(wall, "%.5g"), 0.08, (3, 1, 2))
    expect("exponents.obj", obj(wall, "%.4e"), 0.08, (3, 1, 2))
    # Half a millimetre at each end of 25 m: a tilt of 0.0023 degrees.
    large = rotated((25, 24, 16.385), (30, 10, 5), (2, 1, 3), 25)
    expect("a tilt of 0.0023 degrees.obj", obj(large, "%.3f"), 9831.0, (30, 10, 5))
    corner = [(-0.5, -0.5), (0.5, -0.5), (0.5, -0.2), (-0.2, -0.2), (-0.2, 0.5), (-0.5, 0.5)]
    shape = rotated((1, 1, 0.3), (0, 0, 0), (0, 1, 0), 30, corner)
    low = [min(p[k] for p in shape) for k in range(3)]
    scale = max(max(p[k] for p in shape) - low[k] for k in range(3))
    for bits in (10, 12, 16):
        step = scale / (2 ** bits - 1)
        data = b"".join(struct.pack("<4H", *[round((p[k] - low[k]) / step) for k in range(3)], 0) for p in shape)
        caps = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
        indices = [i for t in caps for i in t[::-1]] + [i + 6 for t in caps for i in t]
        for i in range(6):
            k = (i + 1) % 6
            indices += [i, k, k + 6, i, k + 6, i + 6]
        size = len(data)
        data += struct.pack("<%dH" % len(indices), *indices)
        expect("%d bits.gltf" % bits, text(gltf(
            data, nodes=[{"name": "Wall", "mesh": 0, "scale": [step] * 3, "translation": low}],
            accessors=[{"bufferView": 0, "componentType": 5123, "count": 12, "type": "VEC3"},
                       {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}],
            bufferViews=[{"buffer": 0, "byteLength": size, "byteStride": 8},
                         {"buffer": 0, "byteOffset": size, "byteLength": len(data) - size}],
            extensionsUsed=["KHR_mesh_quantization"], extensionsRequired=["KHR_mesh_quantization"])),
               0.51 * 0.3, (0, 0, 0), **({"tolerance": 0.01} if bits == 10 else {}))
    coarse = ("; the file rounds points by up to %s, too much to tell whether it is a prism: export it with more decimals "
              "or finer quantization.")
    case("rounding/2 decimals.obj", obj(wall, "%.2f"), rejected=[
        '"Wall": The top cap is shifted by 8.72 mm relative to the bottom, seen along the axis (0.585, -0.238, 0.776)'
        + coarse % "8.66 mm"])
    case("rounding/3 decimals of a thin wall.obj", obj(rotated((1, 0.8, 0.05), (3, 1, 2), (1, 2, 0.5), 40), "%.3f"),
         rejected=['"Wall": The mesh has no flat cap at either end of the y axis' + coarse % "0.866 mm"])


# STL

def stl_text(names, boxes=((0, 0, 0),), layout=None):
    text = ""
    for name, at in zip(names, boxes):
        text += "solid %s\n" % name
        for triangle in triangles():
            text += "  facet normal 0 0 0\n    outer loop\n"
            text += "".join("      vertex %e %e %e\n" % corners(at)[i] for i in triangle)
            text += "    endloop\n  endfacet\n"
        text += "endsolid %s\n" % name
    return text


def stl_binary(header=b"", count=None, behind=b"", colour=0):
    body = b"".join(struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *corners()[i]) for i in t) +
                    struct.pack("<H", colour) for t in triangles())
    return header.ljust(80, b"\0") + struct.pack("<I", 12 if count is None else count) + body + behind


def stl():
    def build(name, content, assets=None, error=None, notes=None):
        case("stl/" + name, content, assets or (None if error else WALL), error=error, notes=notes)
    plain = stl_text(["Wall"])
    build("lower.stl", plain)
    build("upper.stl", plain.upper().replace("WALL", "Wall"))
    build("capitals.stl", "\n".join(line[:len(line) - len(line.lstrip())] + line.lstrip().capitalize()
                                    if "olid" not in line else line.replace("solid", "Solid")
                                    for line in plain.splitlines()))
    build("mixed case.stl", plain.replace("solid", "sOLID").replace("vertex", "VerTex").replace("facet", "faCet"))
    build("leading blank lines.stl", "\n\n \n\r\n" + plain)
    build("leading spaces.stl", "   " + plain)
    build("crlf.stl", plain.replace("\n", "\r\n"))
    build("cr.stl", plain.replace("\n", "\r"))
    build("tabs.stl", plain.replace(" ", "\t"))
    build("blank lines between.stl", plain.replace("\n", "\n\n"))
    build("one line a facet.stl", plain.replace("\n    ", " ").replace("\n  endfacet", " endfacet"))
    build("words behind ends.stl", plain.replace("endfacet", "endfacet 7 of it").replace("endloop", "endloop here"))
    build("without end.stl", plain.replace("endsolid Wall\n", ""))
    build("without a name.stl", plain.replace(" Wall", ""), [asset("without a name", (0, 0, 0))])
    build("name with spaces.stl", plain.replace("Wall", "wall left"), [asset("wall left", (0, 0, 0))])
    build("two solids.stl", stl_text(["A", "B"], [(0, 0, 0), (2, 0, 0)]),
          [asset("A", (0, 0, 0)), asset("B", (2, 0, 0))])
    build("two of one name.stl", stl_text(["A", "A"], [(0, 0, 0), (2, 0, 0)]),
          [asset("A", (0, 0, 0)), asset("A 2", (2, 0, 0))])
    for title, stamp in [("Blender", "Exported from Blender-3.4.1"), ("OpenSCAD", "OpenSCAD_Model"), ("MeshLab", "vcg"),
                         ("ADMesh", "Processed by ADMesh version 0.98.4"), ("assimp", "AssimpScene")]:
        name = "name of " + title
        build(name + ".stl", plain.replace("Wall", stamp), [asset(name, (0, 0, 0))])
    build("not a number normals.stl", plain.replace("normal 0 0 0", "normal nan nan nan"))
    build("text behind.stl", plain + "\n\nend of file\n")

    def binary(name, content, error=None, notes=None):
        build(name, content, None if error else [asset(name[:-4], (0, 0, 0))], error=error, notes=notes)
    binary("binary.stl", stl_binary(b"made by hand"))
    binary("binary that begins with solid.stl", stl_binary(b"solid Wall"))
    binary("binary with text header.stl", stl_binary(b"solid " + b"x" * 74))
    binary("binary with colours.stl", stl_binary(b"COLOR=\1\2\3\4", colour=0x8421))
    for count in (1, 2, 7, 50, 51, 1000):
        binary("trailing %d.stl" % count, stl_binary(b"made by hand", behind=b"\0" * count), notes=[
            "The file has %d byte%s behind its last triangle, which are not read."
            % (count, "" if count == 1 else "s")])
    binary("trailing and solid.stl", stl_binary(b"solid Wall", behind=b"\r\n"),
           notes=["The file has 2 bytes behind its last triangle, which are not read."])
    binary("error count.stl", stl_binary(count=13), '"error count.stl" cannot be read as STL: its header counts 13 '
           'triangles, and the file ends after 12.')
    binary("error none.stl", stl_binary(count=0), '"error none.stl" cannot be read as STL: its header counts no '
           'triangles.')
    binary("error short.stl", b"short", '"error short.stl" cannot be read as STL: it has neither text nor the header '
           'of a binary file.')
    number, line = next((i + 1, line) for i, line in enumerate(plain.splitlines()) if "vertex 1.0" in line)
    build("error number.stl", plain.replace("vertex 1.0", "vertex one", 1),
          error='"error number.stl" cannot be read as STL: line %d, "%s", has an invalid number.'
          % (number, line.strip().replace("vertex 1.0", "vertex one")))
    build("error truncated.stl", plain[:plain.rindex("endloop")], error='"error truncated.stl" cannot be read as STL: '
          'the file ends in a facet.')


def compressed():
    """Rounded by the program that compressed them."""
    parts = [("yawed wall", 0.08), ("yawed wall 2", 0.08), ("yawed wall 3", 0.108), ("yawed wall 4", 0.108)]
    cases["compressed/gltf-transform optimize.glb"] = {
        "assets": [{"name": name, "volume": volume, "instances": 1} for name, volume in parts], "tolerance": 0.005}
    for name in sorted(os.listdir(os.path.join(FOLDER, "compressed"))):
        if name.startswith("gltf-transform"):
            continue
        if name.endswith((".glb", ".gltf")):
            at = (1, 2, 3) if name.startswith("draco") else (0, 0, 0)
            cases["compressed/" + name] = {"assets": [asset("Wall", at)],
                                           "tolerance": 0.02 if "-vp 8" in name else 0.002}


for kind in (links, extensions, quantized, instances, morphs_and_skins, nodes, objects, groups, obj_text, polygons,
             far, rounding, stl, compressed):
    kind()
with open(os.path.join(FOLDER, "cases.json"), "w", encoding="utf-8") as file:
    lines = ["  %s: %s" % (json.dumps(name), json.dumps(value)) for name, value in sorted(cases.items())]
    file.write("{\n" + ",\n".join(lines) + "\n}\n")
