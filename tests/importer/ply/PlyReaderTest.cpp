// Tests app/importer/ply/*.cpp and app/importer/files/PolygonTriangles.cpp.
#include "core/io/mesh/MeshImport.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/MeshCases.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

const std::string kPoint = "property float x\nproperty float y\nproperty float z\n";
const std::string kFace = "property list uchar int vertex_indices\n";

std::string ply(const std::string& format, const std::string& elements, const std::string& data) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + data;
}

Result<SourceScene> imported(const std::string& bytes) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("wall.ply").toStdString();
    std::ofstream(file, std::ios::binary) << bytes;
    return importMesh(file, RUBBLE_IMPORTER, {});
}

/// The reason why a file is rejected.
QString reasonOf(const std::string& bytes) {
    const Result<SourceScene> scene = imported(bytes);
    const QString start = "\"wall.ply\" cannot be read as PLY: ";
    const QString message = scene ? "read" : QString::fromStdString(scene.error().message);
    return message.startsWith(start) ? message.mid(start.size()) : message;
}

template <class Number>
std::string bytesOf(Number number, bool isBigEndian) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (isBigEndian) std::ranges::reverse(bytes);
    return bytes;
}

/// A triangle with texture coordinates.
std::string binaryTriangle(bool isBigEndian) {
    const float values[3][5] = {{0, 0, 0, 0, 0}, {1, 0, 0, 0.5f, 0}, {0, 2, 0, 0, 0.25f}};
    std::string data;
    for (const auto& point : values)
        for (const float value : point) data += bytesOf(value, isBigEndian);
    data += '\3';
    for (const int corner : {0, 1, 2}) data += bytesOf(corner, isBigEndian);
    return ply(isBigEndian ? "binary_big_endian" : "binary_little_endian",
               "element vertex 3\n" + kPoint + "property float s\nproperty float t\nelement face 1\n" + kFace, data);
}

std::string textTriangle(const std::string& points, const std::string& face) {
    return ply("ascii", "element vertex 3\n" + kPoint + "element face 1\n" + kFace, points + face);
}

const std::string kPoints = "0 0 0\n1 0 0\n0 2 0\n";

}  // namespace

class PlyReaderTest : public QObject {
    Q_OBJECT
private slots:
    void everyMeshIsWhatItsValuesSay_data() { test::addMeshCases({".ply"}); }
    void everyMeshIsWhatItsValuesSay() {
        QFETCH(const QString, file);
        test::compareMeshCase(file.toStdString());
    }
    void textAndBinaryAreRead_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("little-endian") << QByteArray::fromStdString(binaryTriangle(false));
        QTest::newRow("big-endian") << QByteArray::fromStdString(binaryTriangle(true));
        std::string text =
            ply("ascii", "element vertex 3\n" + kPoint + "property float u\nproperty float v\nelement face 1\n" + kFace,
                "0 0 0 0 0\n1 0 0 0.5 0\n+0 2e0 0 0 .25\n3 0 1 2");
        QTest::newRow("text") << QByteArray::fromStdString(text);
        QTest::newRow("text with CR LF") << QByteArray::fromStdString(text).replace('\n', "\r\n");
    }
    void textAndBinaryAreRead() {
        QFETCH(const QByteArray, bytes);
        const Result<SourceScene> scene = imported(bytes.toStdString());
        QVERIFY2(scene.hasValue(), scene ? "" : scene.error().message.c_str());
        QCOMPARE(scene->objects.size(), std::size_t{1});
        const SourceObject& object = scene->objects[0];
        QVERIFY((object.points == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
        QVERIFY(object.hasUvs);
        QVERIFY(object.triangles.at(0).uvs[1] == Vec2(0.5, 0));
        QVERIFY(object.triangles[0].uvs[2] == Vec2(0, 0.25));
    }
    void otherElementsAndPropertiesAreSkipped() {
        const Result<SourceScene> scene = imported(ply(
            "ascii",
            "comment\nobj_info made by hand\nelement edge 1\nproperty list int short ends\nelement nothing 4000000000\n"
            "element vertex 3\nproperty uchar red\n" +
                kPoint + "element face 1\nproperty list uint8 float64 weights\n" + kFace,
            "2 8 9\n255 0 0 0\n0 1 0 0\n0 0 2 0\n1 0.5 3 0 1 2\n"));
        QVERIFY2(scene.hasValue(), scene ? "" : scene.error().message.c_str());
        QVERIFY(scene->objects[0].points[2] == Vec3(0, 2, 0));
        QCOMPARE(scene->objects[0].triangles.size(), std::size_t{1});
    }
    void polygonsAndStripsAreTriangulated() {
        const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
        const auto area = [&](const std::string& element, const std::string& list) {
            const Result<SourceScene> scene =
                imported(ply("ascii", "element vertex 4\n" + kPoint + element + kFace, square + list));
            double sum = 0.0;
            for (const SourceTriangle& triangle : scene->objects[0].triangles) {
                const auto& points = scene->objects[0].points;
                const Vec3 a = points[triangle.points[0]];
                sum += glm::cross(points[triangle.points[1]] - a, points[triangle.points[2]] - a).z / 2.0;
            }
            return sum;
        };
        QCOMPARE(area("element face 1\n", "4 0 1 2 3\n"), 1.0);
        QCOMPARE(area("element face 2\n", "0\n4 0 1 2 3\n"), 1.0);  // the first has no corners
        QCOMPARE(area("element tristrips 1\n", "4 0 1 3 2\n"), 1.0);
        QCOMPARE(area("element tristrips 1\n", "8 0 1 3 -1 1 2 3 -1\n"), 1.0);  // -1: a new strip
    }
    void cornersHaveTextureCoordinatesOfTheirOwn() {
        const Result<SourceScene> scene = imported(
            ply("ascii",
                "element vertex 4\n" + kPoint + "element face 2\n" + kFace + "property list uchar float texcoord\n",
                "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 5 5 6 6 5 6\n"));
        const SourceObject& object = scene->objects[0];
        QVERIFY(object.triangles[0].uvs[0] == Vec2(0, 0));
        QVERIFY(object.triangles[1].uvs[0] == Vec2(5, 5));
        QVERIFY(object.points[object.triangles[1].points[0]] == Vec3(0, 0, 0));
    }
    void namesOfProgramsInTheHeaderAreSkipped() {
        std::string bytes = textTriangle(kPoints, "3 0 1 2\n");
        QVERIFY(imported(bytes.insert(bytes.find("element"), "Created by Blender3D 247\n")).hasValue());
    }
    void damagedFilesAreRejectedWithTheirPlace_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        const auto add = [](const char* name, const std::string& bytes, const char* reason) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << reason;
        };
        const std::string face = "3 0 1 2\n";
        add("other file", "solid wall\n", "the file does not begin with \"ply\".");
        // assimp's own reader runs on for ever.
        add("header without end", "ply\nformat ascii 1.0\nelement vertex 3\n",
            "the header has no line \"end_header\".");
        add("header without format", "ply\nend_header\n",
            "the header does not say whether the file is text or binary.");
        add("damaged property", ply("ascii", "element vertex 3\nperty float x\n", kPoints),
            "line 4 of the header, \"perty float x\", is invalid.");
        add("unknown type", ply("ascii", "element vertex 3\nproperty half x\n", kPoints),
            "line 4 of the header, \"property half x\", is invalid.");
        add("count that is no number", ply("ascii", "element vertex 3x\n", ""),
            "line 3 of the header, \"element vertex 3x\", is invalid.");
        add("list without whole size", ply("ascii", "element vertex 3\nproperty list float int x\n", ""),
            "line 4 of the header, \"property list float int x\", is invalid.");
        add("missing element", textTriangle(kPoints, ""), "the file ends in \"face\" 1 of 1.");
        add("word", textTriangle("0 0 0\n1 0 O\n0 2 0\n", face), "a number is invalid in \"vertex\" 2 of 3.");
        add("huge list", textTriangle(kPoints, "4000000000 0 1 2"), "the file ends in \"face\" 1 of 1.");
        add("list of negative size", textTriangle(kPoints, "-1 0 1 2"),
            "the size of a list is invalid in \"face\" 1 of 1.");
        // assimp's own reader crashes.
        add("missing point", textTriangle(kPoints, "5 0 1 77 2 1\n"), "a face refers to point 77 of 3.");
        add("negative point", textTriangle(kPoints, "3 0 -1 2\n"),
            "the number of a point is invalid in \"face\" 1 of 1.");
        add("fraction of a point", textTriangle(kPoints, "3 0 1.5 2\n"),
            "the number of a point is invalid in \"face\" 1 of 1.");
        std::string binary = binaryTriangle(false);
        binary.resize(binary.size() - 1);
        // assimp's own reader reads bytes that are not there.
        add("truncated", binary, "the file ends in \"face\" 1 of 1.");
    }
    void damagedFilesAreRejectedWithTheirPlace() {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, reason);
        QCOMPARE(reasonOf(bytes.toStdString()), reason);
    }
    void hugeCountsTakeNoMemory() {
        QCOMPARE(reasonOf(ply("ascii", "element vertex 18446744073709551615\n" + kPoint, kPoints)),
                 "the file ends in \"vertex\" 4 of 18446744073709551615.");
    }
};

RUBBLE_TEST(PlyReaderTest)
#include "PlyReaderTest.moc"
