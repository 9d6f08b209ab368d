// Tests core/io/exchange/GlbWriter.cpp, core/io/exchange/GlbJson.cpp, core/io/exchange/GlbBuffer.cpp and
// core/io/exchange/GlbElements.cpp.
#include "core/io/exchange/GlbWriter.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshParts.h"
#include "tests/support/files/GlbReading.h"
#include "tests/support/files/Locales.h"
#include "tests/support/geometry/Meshes.h"

#include <QTest>

using namespace rubble;

namespace {

const MeshMaterials kGlbMaterials{{{"brick_outside", {0.5, 0.04, 1.0}}}, {"brick_inside", {0.0, 1.0, 0.25}}};

std::string glbBytes(const std::vector<MeshPart>& parts, PartPlacement place = PartPlacement::Assembled) {
    return glbFile(parts, kGlbMaterials, place).value();
}

Glb opened(const std::string& bytes) {
    Glb glb;
    const std::string fault = openGlb(bytes, glb);
    if (!fault.empty()) qWarning("%s", fault.c_str());
    return glb;
}

/// Returns the first violation of glTF's rules on accessors in views and views in buffers.
QString accessorFault(const Glb& glb, const nlohmann::json& accessor, std::size_t elementSize, int target) {
    const nlohmann::json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = accessor["byteOffset"], begin = view["byteOffset"], length = view["byteLength"];
    if (offset % 4 != 0 || begin % 4 != 0) return "is not aligned";
    if (begin + length > glb.binary.size()) return "has a view beyond the buffer";
    if (offset + accessor["count"].get<std::size_t>() * elementSize > length) return "goes beyond its view";
    if (view["target"] != target) return "has a view for another use";
    const bool isVertices = target == 34962;
    if (view.contains("byteStride") != isVertices) return "has a stride, or lacks it";
    if (isVertices && view["byteStride"] != elementSize) return "has another stride";
    return {};
}

}  // namespace

class GlbWriterTest : public QObject {
    Q_OBJECT
private slots:
    void eachPartIsANodeAtItsOffset() {
        const nlohmann::json file = opened(glbBytes(halves())).json;
        QVERIFY(file["asset"]["version"] == "2.0");
        QVERIFY(file["scenes"][0]["nodes"] == (nlohmann::json{0, 1}));
        QVERIFY(file["nodes"][0] == nlohmann::json::parse(R"({"name":"wall0","mesh":0,"translation":[0.25,0.5,0]})"));
        QVERIFY(file["nodes"][1] == nlohmann::json::parse(R"({"name":"wall1","mesh":1,"translation":[0.75,0.5,0]})"));
        QVERIFY(file["meshes"][1]["name"] == "wall1");
    }
    void centredPartsHaveNoTranslation() {
        const nlohmann::json file = opened(glbBytes(halves(), PartPlacement::Centred)).json;
        QVERIFY(!file["nodes"][0].contains("translation"));
    }
    void accessorsAreAlignedAsRequired() {
        const Glb glb = opened(glbBytes(halves()));
        QVERIFY(glb.json["buffers"].size() == 1);
        QVERIFY(glb.json["buffers"][0]["byteLength"] == glb.binary.size());
        const nlohmann::json& accessors = glb.json["accessors"];
        QCOMPARE(accessors.size(), std::size_t{2 * 2 * 4});
        for (std::size_t i = 0; i < accessors.size(); ++i) {
            const std::size_t size[] = {12, 12, 8, 4};
            const nlohmann::json& accessor = accessors[i];
            QVERIFY(accessor["componentType"] == (i % 4 < 3 ? 5126 : 5125));
            QCOMPARE(accessorFault(glb, accessor, size[i % 4], i % 4 < 3 ? 34962 : 34963), QString());
        }
    }
    void boundsAreThoseOfTheWrittenFloats() {
        std::vector<MeshPart> parts{{"box", boxMesh(), {}}};
        for (Vec3& position : parts[0].mesh.positions) position *= 0.1;
        const nlohmann::json positions = opened(glbBytes(parts)).json["accessors"][0];
        const double tenth = 0.1f;  // not 0.1
        QVERIFY((positions["min"] == nlohmann::json{-tenth, -tenth, -tenth}));
        QVERIFY((positions["max"] == nlohmann::json{tenth, tenth, tenth}));
    }
    void indicesAreInRange() {
        const Glb glb = opened(glbBytes(halves()));
        for (std::size_t i = 3; i < glb.json["accessors"].size(); i += 4) {
            const std::size_t vertices = glb.json["accessors"][i - 3]["count"];
            for (const std::uint32_t index : numbersOf<std::uint32_t>(glb, glb.json["accessors"][i]))
                QVERIFY(index < vertices);
        }
    }
    void everyPartReadsBackClosedWithItsVolume() {
        const Glb glb = opened(glbBytes(halves()));
        for (const nlohmann::json& node : glb.json["nodes"]) {
            const Mesh mesh = meshOfNode(glb, node);
            QCOMPARE(QString::fromStdString(verifyMesh(mesh, 1.0).value_or("")), QString());
        }
    }
    void cornersOfOneFaceShareAVertex() {
        // The box: each cap has four triangles around a fifth vertex, each side four corners.
        const Glb glb = opened(glbBytes({{"box", boxMesh(), {}}}));
        QVERIFY(glb.json["accessors"][0]["count"] == 5 + 5 + 4 + 4);
        QVERIFY(glb.json["accessors"][3]["count"] == 3 * (4 + 4 + 2 + 2));
        QVERIFY(glb.json["accessors"][4]["count"] == 4 + 4);
    }
    void insideFacesHaveTheLastMaterial() {
        std::vector<MeshPart> parts{{"box", boxMesh(), {}}};
        parts[0].mesh.faces[3].material = 1;
        const MeshMaterials materials{{{"plaster", {}}, {"paint", {}}}, {"inside", {}}};
        const nlohmann::json file = opened(glbFile(parts, materials, PartPlacement::Assembled).value()).json;
        const nlohmann::json& primitives = file["meshes"][0]["primitives"];
        QCOMPARE(primitives.size(), std::size_t{3});
        QVERIFY(primitives[0]["material"] == 0 && primitives[1]["material"] == 1 && primitives[2]["material"] == 2);
        QVERIFY(file["materials"][2]["name"] == "inside");
    }
    void coloursAreLinear() {
        const nlohmann::json file = opened(glbBytes(halves())).json;
        const nlohmann::json& colour = file["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
        QVERIFY(std::abs(colour[0].get<double>() - 0.21404114048223255) < 1e-15);  // ((0.5 + 0.055) / 1.055)^2.4
        QVERIFY(std::abs(colour[1].get<double>() - 0.04 / 12.92) < 1e-17);
        QCOMPARE(colour[2].get<double>(), 1.0);
        QCOMPARE(colour[3].get<double>(), 1.0);
    }
    void textureCoordinatesPointDown() {
        const Glb glb = opened(glbBytes(halves()));
        const auto uvs = numbersOf<float>(glb, glb.json["accessors"][2]);
        // The first triangle of the front: its centre (0.25, 0.5), then the corner (0, 0), which is v = 1 in glTF.
        QVERIFY((std::vector<float>(uvs.begin(), uvs.begin() + 4) == std::vector<float>{0.25f, 0.5f, 0.0f, 1.0f}));
    }
    void namesAreEscaped() {
        std::vector<MeshPart> parts{{"a\"b", boxMesh(), {}}};
        QVERIFY(opened(glbBytes(parts)).json["nodes"][0]["name"] == "a\"b");
    }
    void outputIsIndependentOfTheLocale() {
        const std::string before = glbBytes(halves());
        const CommaLocale german;
        QVERIFY(glbBytes(halves()) == before);
    }
    void filesAboveTheFormatsLimitAreRejected() {
        Mesh mesh;
        mesh.corners.resize(100'000);
        mesh.faces.assign(1000, {0, 100'000, 0, 0, FaceSide::Outside});
        const auto file = glbFile(std::vector<MeshPart>{{"huge", mesh, {}}}, kGlbMaterials, PartPlacement::Assembled);
        QCOMPARE(file.error().code, ErrorCode::Limit);
        QCOMPARE(file.error().message,
                 std::string("1 bodies exceed 4 GiB, the maximum of a GLB file; export one file per "
                             "fragment."));
    }
    void transparentMaterialsAreBlended() {
        const MeshMaterials glass{{{"glass_outside", {0.5, 0.25, 1.0}, 0.25}}, {"glass_inside", {0.0, 1.0, 0.125}}};
        const nlohmann::json file = opened(glbFile(halves(), glass, PartPlacement::Assembled).value()).json;
        QVERIFY(file["materials"][0]["alphaMode"] == "BLEND");
        QVERIFY(file["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3] == 0.25);
        QVERIFY(!file["materials"][1].contains("alphaMode"));
    }
};

RUBBLE_TEST(GlbWriterTest)
#include "GlbWriterTest.moc"
