// Tests core/io/exchange/ObjFile.cpp and core/io/exchange/ObjWriter.cpp.
#include "core/base/Random.h"
#include "core/io/exchange/ObjFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshParts.h"
#include "tests/support/files/Locales.h"
#include "tests/support/files/ObjReading.h"
#include "tests/support/geometry/Meshes.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

const MeshMaterials kObjMaterials{{{"brick_outside", {0.5, 0.25, 1.0}}}, {"brick_inside", {0.0, 1.0, 0.125}}};

std::string assembled(const std::vector<MeshPart>& parts) {
    return objFile(parts, kObjMaterials, PartPlacement::Assembled, "wall.mtl");
}

/// Returns the lines from the first that starts with `from` to the next that starts with `to`, exclusive.
QString linesBetween(const std::string& text, const char* from, const char* to) {
    const std::size_t begin = text.find(from);
    return QString::fromStdString(text.substr(begin, text.find(to, begin) - begin));
}

}  // namespace

class ObjFileTest : public QObject {
    Q_OBJECT
private slots:
    void frameSetsUnitAndUpAxis() {
        const auto positions = [](const ObjFrame& frame) {
            const std::string text = objFile(halves(), kObjMaterials, PartPlacement::Assembled, "wall.mtl", frame);
            std::vector<Vec3> all;
            for (const ObjObject& object : readObj(text)) {
                if (volumeOf(object.mesh) <= 0.0) qWarning("turned inside out");
                all.insert(all.end(), object.mesh.positions.begin(), object.mesh.positions.end());
            }
            return all;
        };
        const std::vector<Vec3> metres = positions({}), zUp = positions({UpAxis::Z, ObjUnit::Centimetre});
        const std::vector<Vec3> millimetres = positions({UpAxis::Y, ObjUnit::Millimetre});
        QCOMPARE(metres[0], Vec3(0.0, 0.0, 1.0));
        QCOMPARE(zUp[0], Vec3(0.0, -100.0, 0.0));
        QCOMPARE(metres[2], Vec3(0.5, 1.0, 1.0));
        QCOMPARE(zUp[2], Vec3(50.0, -100.0, 100.0));
        for (std::size_t k = 0; k < metres.size(); ++k) {
            QCOMPARE(zUp[k], 100.0 * Vec3(metres[k].x, -metres[k].z, metres[k].y));
            QCOMPARE(millimetres[k], 1000.0 * metres[k]);
        }
    }
    void headerNamesTheFrame() {
        const ObjFrame frame{UpAxis::Z, ObjUnit::Centimetre};
        const std::string text = objFile(halves(), kObjMaterials, PartPlacement::Assembled, "wall.mtl", frame);
        QVERIFY(text.starts_with("# Rubble 1: centimetres, z up\n") && text.find("vn 0 -1 0\n") != std::string::npos);
    }
    void cubeCutInTwoHasTheseBytes() {
        const std::string text = assembled(halves());
        QCOMPARE(linesBetween(text, "# ", "o wall1"), QString(R"(# Rubble 1: metres, y up
mtllib wall.mtl
s off
o wall0
g wall0
v 0 0 1
v 0.5 0 1
v 0.5 1 1
v 0 1 1
v 0 0 -1
v 0.5 0 -1
v 0.5 1 -1
v 0 1 -1
vt 0 0
vt 0.5 0
vt 0.5 1
vt 0 1
vt 0 1
vt 0 -1
vt 0.5 1
vt 0.5 -1
vt 2.5 1
vt 2.5 -1
vt 3 1
vt 3 -1
vt 3 1
vt 3 -1
vt 4 1
vt 4 -1
vt 0 1
vt 0 -1
vt 1 1
vt 1 -1
vn 0 0 1
vn 0 0 -1
vn 0 -1 0
vn 0 1 0
vn -1 0 0
vn 1 0 0
usemtl brick_outside
f 1/1/1 2/2/1 3/3/1 4/4/1
f 8/4/2 7/3/2 6/2/2 5/1/2
f 1/5/3 5/6/3 6/8/3 2/7/3
f 3/9/4 7/10/4 8/12/4 4/11/4
f 4/13/5 8/14/5 5/16/5 1/15/5
usemtl brick_inside
f 2/17/6 6/18/6 7/20/6 3/19/6
)"));
        // Indices continue in the second object.
        QCOMPARE(linesBetween(text, "o wall1", "v "), QString("o wall1\ng wall1\n"));
        QVERIFY(text.ends_with("usemtl brick_inside\nf 12/37/12 16/38/12 13/40/12 9/39/12\n"));
    }
    void centredPartsAreAtTheOrigin() {
        const std::string text = objFile(halves(), kObjMaterials, PartPlacement::Centred, "wall.mtl");
        QCOMPARE(linesBetween(text, "v ", "v 0.25 0.5"), QString("v -0.25 -0.5 1\nv 0.25 -0.5 1\n"));
    }
    void trianglesStayTriangles() {
        const std::string text = assembled({{"box", triangulated(boxMesh()), {}}});
        const std::vector<ObjObject> objects = readObj(text);
        QCOMPARE(objects[0].mesh.faces.size(), std::size_t{4 + 4 + 4 * 2});
        QCOMPARE(QString::fromStdString(verifyMesh(objects[0].mesh, 8.0).value_or("")), QString());
    }
    void everyPartReadsBackClosedWithItsVolume() {
        const std::vector<ObjObject> objects = readObj(assembled(halves()));
        QCOMPARE(objects.size(), std::size_t{2});
        double volume = 0.0;
        for (const ObjObject& object : objects) {
            QCOMPARE(QString::fromStdString(verifyMesh(object.mesh, 1.0).value_or("")), QString());
            QCOMPARE(object.name, object.group);
            QVERIFY((object.materials == std::vector<std::string>{"brick_outside", "brick_inside"}));
            volume += volumeOf(object.mesh);
        }
        QCOMPARE(volume, 2.0);
    }
    void eachMaterialHasOneRunOfFaces() {
        std::vector<MeshPart> parts{{"box", boxMesh(), {}}};
        parts[0].mesh.faces[2].material = parts[0].mesh.faces[3].material = 1;
        const MeshMaterials materials{{{"plaster", {}}, {"paint", {}}}, {"inside", {}}};
        const std::vector<ObjObject> objects = readObj(objFile(parts, materials, PartPlacement::Assembled, "box.mtl"));
        QVERIFY((objects[0].materials == std::vector<std::string>{"plaster", "paint", "inside"}));
        QCOMPARE(objects[0].mesh.faces[2].material, 1u);
        QCOMPARE(objects[0].mesh.faces[4].material, 2u);
    }
    void numbersRoundTrip() {
        const std::uint64_t seed = 3;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        MeshPart part{"box", boxMesh(), {}};
        for (int round = 0; round < 1000; ++round) {
            const double scale = std::pow(10.0, 40.0 * random.unit() - 20.0);
            for (Vec3& position : part.mesh.positions)
                position = {scale * random.unit(), -random.unit(), random.unit() / scale};
            for (Vec2& uv : part.mesh.uvs) uv = {scale * random.unit(), random.unit()};
            for (Vec3& normal : part.mesh.normals)
                normal = glm::normalize(Vec3{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5});
            const Mesh read = readObj(assembled({part}))[0].mesh;
            QVERIFY(read.positions == part.mesh.positions);
            QVERIFY(read.uvs == part.mesh.uvs);
            for (std::size_t i = 0; i < read.normals.size(); ++i)
                QVERIFY(glm::distance(read.normals[i], part.mesh.normals[i]) < 1e-7);  // rounding
        }
    }
    void longNamesAndManyFacesExceedTheBlock() {
        Mesh fan;
        fan.uvs = {{0.0, 0.0}};
        fan.normals = {{0.0, 0.0, 1.0}};
        fan.faces = {{0, 5000, 0, 0, FaceSide::Outside}};
        for (std::uint32_t i = 0; i < 5000; ++i) {
            fan.positions.push_back({1.0 / (i + 1.0), 1e-300 / (i + 3.0), -1e300 / (i + 7.0)});
            fan.corners.push_back({i, 0});
        }
        const std::string name(20000, 'n');
        const std::vector<ObjObject> objects = readObj(assembled({{name, fan, {}}}));
        QCOMPARE(objects[0].name, name);
        QVERIFY(objects[0].mesh.positions == fan.positions);
        QCOMPARE(objects[0].mesh.corners.back().position, 4999u);
    }
    void outputIsIndependentOfTheLocale() {
        const std::string before = assembled(halves()) + mtlFile(kObjMaterials);
        const CommaLocale german;
        QCOMPARE(assembled(halves()) + mtlFile(kObjMaterials), before);
    }
    void materialsAreListedWithTheirColours() {
        QCOMPARE(mtlFile(kObjMaterials), std::string("# Rubble 1\n"
                                                     "newmtl brick_outside\nKd 0.5 0.25 1\nillum 1\n"
                                                     "newmtl brick_inside\nKd 0 1 0.125\nillum 1\n"));
    }
    void transparentMaterialsHaveAnOpacity() {
        const MeshMaterials glass{{{"glass_outside", {0.5, 0.25, 1.0}, 0.25}}, {"glass_inside", {0.0, 1.0, 0.125}}};
        QVERIFY(mtlFile(glass).find("newmtl glass_outside\nKd 0.5 0.25 1\nd 0.25\nillum 1\n") != std::string::npos);
    }
};

RUBBLE_TEST(ObjFileTest)
#include "ObjFileTest.moc"
