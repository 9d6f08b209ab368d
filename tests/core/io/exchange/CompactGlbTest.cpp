// Tests core/io/exchange/CompactGlb.cpp and core/io/exchange/GlbContainer.cpp.
#include "core/io/exchange/CompactGlb.h"

#include "core/base/Random.h"
#include "core/io/exchange/GlbBuffer.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/GlbReading.h"

#include <QTest>

#include <meshoptimizer.h>

using namespace rubble;

namespace {

Glb opened(const Result<std::string>& bytes) {
    Glb glb;
    const std::string fault = openGlb(*bytes, glb);
    if (!fault.empty()) qFatal("%s", fault.c_str());
    return glb;
}

/// The elements of an accessor, decoded.
template <class T>
std::vector<T> elements(const Glb& glb, std::size_t accessor) {
    const nlohmann::json& view = glb.json["bufferViews"][accessor]["extensions"]["EXT_meshopt_compression"];
    const auto* bytes =
        reinterpret_cast<const unsigned char*>(glb.binary.data()) + view["byteOffset"].get<std::size_t>();
    const std::size_t count = view["count"], size = view["byteLength"];
    if (view["byteStride"] != sizeof(T)) qFatal("stride");
    std::vector<T> list(count);
    const int failed = view["mode"] == "TRIANGLES"
                           ? meshopt_decodeIndexBuffer(list.data(), count, sizeof(T), bytes, size)
                           : meshopt_decodeVertexBuffer(list.data(), count, sizeof(T), bytes, size);
    if (failed != 0) qFatal("not decoded");
    return list;
}

/// A closed box with a corner at a place, outside but for one face.
MeshPart boxPart(const std::string& name, Vec3 size, Vec3 offset) {
    MeshPart part{.name = name, .mesh = {}, .offset = offset};
    part.mesh.uvs = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    part.mesh.normals = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
    for (int k = 0; k < 8; ++k)
        part.mesh.positions.push_back({k & 1 ? size.x : -size.x, k & 2 ? size.y : -size.y, k & 4 ? size.z : -size.z});
    constexpr std::uint32_t kFaces[6][4]{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto first = static_cast<std::uint32_t>(part.mesh.corners.size());
        for (std::uint32_t k = 0; k < 4; ++k) part.mesh.corners.push_back({kFaces[face][k], k});
        part.mesh.faces.push_back({.firstCorner = first,
                                   .cornerCount = 4,
                                   .normal = face,
                                   .side = face == 5 ? FaceSide::Inside : FaceSide::Outside});
    }
    return part;
}

MeshMaterials brickMaterials() {
    return {.outside = {{.name = "brick_outside", .colour = {0.8, 0.4, 0.2}}},
            .inside = {.name = "brick_inside", .colour = {0.1, 0.2, 0.3}},
            .image = nullptr,
            .imageFile = {}};
}

}  // namespace

class CompactGlbTest : public QObject {
    Q_OBJECT
private slots:
    /// The vertices and triangles are those of the plain file, but for rounding; each is bound to its part.
    void partsAreThoseOfThePlainFile() {
        constexpr std::uint64_t kSeed = 5;
        Random random(kSeed);
        std::vector<MeshPart> parts;
        for (int k = 0; k < 50; ++k) {
            const auto length = [&] { return random.between(0.01, 0.5); };
            parts.push_back(boxPart("box_" + std::to_string(k), {length(), length(), length()},
                                    {random.between(-5.0, 5.0), 0.0, 1.0 / 3.0}));
        }
        double scale = 0.0;
        for (const MeshPart& part : parts)
            for (const Vec3 position : part.mesh.positions)
                scale = std::max({scale, position.x, position.y, position.z});
        const Glb glb = opened(compactGlbFile(parts, brickMaterials(), PartPlacement::Assembled, "wall"));
        QCOMPARE(glb.json["meshes"].size(), std::size_t{1});
        QCOMPARE(glb.json["meshes"][0]["primitives"].size(), std::size_t{1});  // drawn at once
        const auto positions = elements<std::array<std::int16_t, 4>>(glb, 0);
        const auto normals = elements<std::array<std::int8_t, 4>>(glb, 1);
        const auto joints = elements<std::array<std::uint16_t, 4>>(glb, 2);
        const auto weights = elements<std::array<std::uint8_t, 4>>(glb, 3);
        const auto colours = elements<std::array<std::uint16_t, 4>>(glb, 4);
        const auto indices = elements<std::uint32_t>(glb, 5);
        std::size_t vertex = 0, triangles = 0;
        for (std::uint16_t part = 0; part < parts.size(); ++part) {
            GlbBuffer plain;
            for (const GlbPrimitive& primitive : plain.add(parts[part].mesh)) {
                const bool isInside = primitive.material == GlbBuffer::kInside;
                triangles += primitive.indexCount / 3;
                for (std::uint32_t k = 0; k < primitive.vertexCount; ++k, ++vertex) {
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        const double exact = plain.positions()[primitive.firstVertex + k][axis];
                        QVERIFY(std::abs(positions[vertex][axis] / 32767.0 * scale - exact) <= scale / 65534.0 + 1e-7);
                        QCOMPARE(float(normals[vertex][axis]),
                                 127.0f * plain.normals()[primitive.firstVertex + k][axis]);
                    }
                    QCOMPARE(joints[vertex], (std::array<std::uint16_t, 4>{part, 0, 0, 0}));
                    QCOMPARE(weights[vertex], (std::array<std::uint8_t, 4>{255, 0, 0, 0}));
                    const Vec3 colour =
                        linearColour(isInside ? brickMaterials().inside.colour : brickMaterials().outside[0].colour);
                    QVERIFY(std::abs(colours[vertex][0] / 65535.0 - colour.x) < 1e-5);
                }
            }
            const nlohmann::json& joint = glb.json["nodes"][1 + part];
            QCOMPARE(joint["name"].get<std::string>(), parts[part].name);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(std::abs(joint["translation"][axis].get<double>() - parts[part].offset[axis]) <= 0.5e-7);
        }
        QCOMPARE(positions.size(), vertex);
        QCOMPARE(indices.size(), 3 * triangles);
        // The same triangles as before, which may begin at another corner.
        for (std::size_t k = 0; k < indices.size(); k += 3) QCOMPARE(joints[indices[k]], joints[indices[k + 2]]);
        const auto matrices = elements<std::array<float, 16>>(glb, 6);
        QCOMPARE(matrices.size(), parts.size());
        for (const auto& matrix : matrices)
            QCOMPARE(matrix, (std::array<float, 16>{float(scale), 0, 0, 0, 0, float(scale), 0, 0, 0, 0, float(scale), 0,
                                                    0, 0, 0, 1}));
    }
    void centredPartsHaveNoPlace() {
        const std::vector<MeshPart> parts{boxPart("box", Vec3(1.0), {1.0, 2.0, 3.0})};
        const Glb glb = opened(compactGlbFile(parts, brickMaterials(), PartPlacement::Centred, "wall"));
        QVERIFY(!glb.json["nodes"][1].contains("translation"));
        QVERIFY(glb.json["extensionsRequired"] == nlohmann::json({"KHR_mesh_quantization", "EXT_meshopt_compression"}));
    }
    /// A skin has at most 65,536 joints.
    void manyPartsAreSeveralMeshes() {
        const MeshPart one = boxPart("box", Vec3(0.1), {});
        const std::vector<MeshPart> parts(65'537, one);
        const std::string bytes = *compactGlbFile(parts, brickMaterials(), PartPlacement::Assembled, "wall");
        const Glb glb = opened(bytes);
        QCOMPARE(glb.json["meshes"].size(), std::size_t{2});
        QCOMPARE(glb.json["skins"][0]["joints"].size(), std::size_t{65'536});
        QVERIFY(glb.json["skins"][1]["joints"] == nlohmann::json({65'537}));
        QVERIFY((elements<std::array<std::uint16_t, 4>>(glb, 2).back()[0] == 65'535));
        QVERIFY((elements<std::array<std::uint16_t, 4>>(glb, 8).back()[0] == 0));
        QVERIFY(bytes == *compactGlbFile(parts, brickMaterials(), PartPlacement::Assembled, "wall"));
        QVERIFY2(bytes.size() < 250 * parts.size(), qPrintable(QString::number(bytes.size() / parts.size())));
    }
};

RUBBLE_TEST(CompactGlbTest)
#include "CompactGlbTest.moc"
