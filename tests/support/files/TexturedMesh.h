#pragma once

#include "core/io/text/Base64.h"
#include "tests/support/files/TestImages.h"

#include <QDir>
#include <QTemporaryDir>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace rubble {

/// A folder with wall.obj and wall.mtl: a cube of 1 m, its front (z = 0.5) of the material "Front", its back of "Back",
/// its sides of "Sides"; each face has the whole of the texture once.
class TexturedMesh {
public:
    /// Takes a line for each of the three materials, as "map_Kd a.png".
    explicit TexturedMesh(const std::string& front, const std::string& back = {}, const std::string& sides = {}) {
        write("wall.obj", R"(mtllib wall.mtl
o wall
v -0.5 -0.5 0.5
v 0.5 -0.5 0.5
v 0.5 0.5 0.5
v -0.5 0.5 0.5
v -0.5 -0.5 -0.5
v 0.5 -0.5 -0.5
v 0.5 0.5 -0.5
v -0.5 0.5 -0.5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl Front
f 1/1 2/2 3/3 4/4
usemtl Back
f 6/1 5/2 8/3 7/4
usemtl Sides
f 5/1 6/2 2/3 1/4
f 6/1 7/2 3/3 2/4
f 7/1 8/2 4/3 3/4
f 8/1 5/2 1/3 4/4
)");
        write("wall.mtl", "newmtl Front\n" + front + "\nnewmtl Back\nKd 1 1 1\n" + back + "\nnewmtl Sides\nKd 1 1 1\n" +
                              sides + "\n");
    }
    std::filesystem::path path(const std::string& name = "wall.obj") const {
        return m_root.path().toStdString() + "/mesh/" + name;
    }
    void write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories(path(name).parent_path());
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

private:
    QTemporaryDir m_root;
};

/// A glTF file of a cube whose material has this image; `view`: the bytes of its view.
inline std::string gltfWith(const std::string& image, const std::string& view) {
    std::string bytes;
    const auto add = [&](const auto& list) {
        bytes.append(reinterpret_cast<const char*>(std::data(list)), sizeof(list));
    };
    const float points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    const float uvs[] = {0, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1};
    const std::uint32_t corners[] = {4, 5, 7, 4, 7, 6, 0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4,
                                     1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};
    add(points);
    add(uvs);
    add(corners);
    bytes += view;
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + R"("}],"bufferViews":[
           {"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":64},
           {"buffer":0,"byteOffset":160,"byteLength":144},{"buffer":0,"byteOffset":304,"byteLength":)" +
           std::to_string(view.size()) + R"(}],"accessors":[
           {"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
           {"bufferView":1,"componentType":5126,"count":8,"type":"VEC2"},
           {"bufferView":2,"componentType":5125,"count":36,"type":"SCALAR"}],
           "images":[)" +
           image + R"(],"textures":[{"source":0}],
           "materials":[{"name":"Brick","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
           "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],
           "nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
}

}  // namespace rubble
