// Tests core/io/project/MeshFile.cpp and core/geometry/mesh/MeshHash.h.
#include "core/io/project/MeshFile.h"

#include "core/base/Random.h"
#include "core/geometry/mesh/MeshHash.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/Compression.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>

using namespace rubble;

namespace {

constexpr std::size_t kVersionAt = 8, kPointsAt = 12, kTrianglesAt = 16, kSizeAt = 20, kHashAt = 24, kHeaderBytes = 40;

std::shared_ptr<const ClosedMesh> closed(TriangleMesh mesh) { return closedMesh(std::move(mesh)).value(); }

bool isSame(const TriangleMesh& a, const TriangleMesh& b) {
    const auto isSameBits = [](const Vec3& p, const Vec3& q) { return std::memcmp(&p, &q, sizeof(p)) == 0; };
    return std::ranges::equal(a.points, b.points, isSameBits) && a.triangles == b.triangles;
}

std::string withNumber(std::string bytes, std::size_t at, std::uint32_t number) {
    std::memcpy(bytes.data() + at, &number, sizeof(number));
    return bytes;
}

/// A file of any content.
std::string fileOf(const TriangleMesh& mesh, const ContentHash& hash) {
    ClosedMesh any;
    any.mesh = mesh;
    any.hash = hash;
    return meshBytes(any);
}

}  // namespace

class MeshFileTest : public QObject {
    Q_OBJECT
private slots:
    void meshesComeBackBitForBit() {
        TriangleMesh zero = test::cubes({{0, 0, 0}});
        for (Vec3& point : zero.points) point -= Vec3(1.0, 0.0, 0.5);
        zero.points[0].y = -0.0;
        for (const TriangleMesh& mesh : {test::bumpySphere(12), test::mengerSponge(1), zero}) {
            const auto before = closed(mesh);
            const std::string bytes = meshBytes(*before);
            const auto after = readMeshBytes(bytes, before->hash);
            QVERIFY2(after, after ? "" : after.error().message.c_str());
            QVERIFY(isSame((*after)->mesh, before->mesh) && isSame((*after)->mesh, mesh));
            QVERIFY((*after)->hash == before->hash && hashOf(mesh) == before->hash);
            QCOMPARE((*after)->mass.volume, before->mass.volume);
            QCOMPARE(meshBytes(**after), bytes);
        }
    }
    void everyCutIsRefused() {
        const auto mesh = closed(test::torus(8, 6));
        const std::string bytes = meshBytes(*mesh);
        for (std::size_t size = 0; size < bytes.size(); ++size)
            QVERIFY(!readMeshBytes(std::string_view(bytes).substr(0, size), mesh->hash));
        QVERIFY(errorText(readMeshBytes(bytes.substr(0, 100), mesh->hash)).find("it is cut off;") != std::string::npos);
        QCOMPARE(errorText(readMeshBytes(bytes + "x", mesh->hash)),
                 std::string("The mesh cannot be read: bytes follow its end; restore the file from a copy of the "
                             "project."));
    }
    void everyFlippedBitIsRefused() {
        const auto mesh = closed(test::cubes({{0, 0, 0}, {1, 0, 0}}));
        const std::string bytes = meshBytes(*mesh);
        for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
            std::string other = bytes;
            other[bit / 8] = static_cast<char>(other[bit / 8] ^ (1 << bit % 8));
            const auto read = readMeshBytes(other, mesh->hash);
            if (!read) {
                QVERIFY(read.error().message.ends_with('.'));
            } else {  // a bit of zlib that means nothing
                QVERIFY(isSame((*read)->mesh, mesh->mesh));
            }
        }
    }
    void randomBytesAreRefused() {
        Random random(5);
        const auto mesh = closed(test::bumpySphere(5));
        const std::string bytes = meshBytes(*mesh);
        for (int k = 0; k < 3000; ++k) {
            std::string other = bytes;
            const std::size_t changes = 1 + random.below(20);
            for (std::size_t n = 0; n < changes; ++n)
                other[random.below(other.size())] = static_cast<char>(random.below(256));
            const auto read = readMeshBytes(other, mesh->hash);
            QVERIFY(!read || isSame((*read)->mesh, mesh->mesh));
        }
    }
    void wrongHeadersAreRefused() {
        const auto mesh = closed(test::bumpySphere(5));
        const std::string bytes = meshBytes(*mesh);
        const auto fault = [&](const std::string& other) { return errorText(readMeshBytes(other, mesh->hash)); };
        QVERIFY(fault("solid cube").find("the file is not a mesh of Rubble;") != std::string::npos);
        QCOMPARE(readMeshBytes(withNumber(bytes, kVersionAt, 2), mesh->hash).error().code, ErrorCode::Unsupported);
        QVERIFY(!readMeshBytes(withNumber(bytes, kVersionAt, 0), mesh->hash));
        const auto points = static_cast<std::uint32_t>(mesh->mesh.points.size());
        QVERIFY(fault(withNumber(bytes, kPointsAt, points + 1)).find("compressed part") != std::string::npos);
        QVERIFY(fault(withNumber(bytes, kPointsAt, points - 1)).find("compressed part") != std::string::npos);
        QVERIFY(fault(withNumber(bytes, kTrianglesAt, 1)).find("compressed part") != std::string::npos);
        QVERIFY(fault(withNumber(bytes, kPointsAt, kMaxMeshFilePoints)).find("its size is wrong") != std::string::npos);
        QVERIFY(fault(withNumber(bytes, kSizeAt, 10)).find("bytes follow its end") != std::string::npos);
        for (const std::size_t at : {kPointsAt, kTrianglesAt})
            QCOMPARE(readMeshBytes(withNumber(bytes, at, ~0u), mesh->hash).error().code, ErrorCode::Limit);
        QVERIFY(fault(withNumber(bytes, kHashAt, 7)).find("it is another one") != std::string::npos);
        QVERIFY(bytes.size() > kHeaderBytes);
    }
    void anotherMeshIsRefused() {
        const auto sphere = closed(test::bumpySphere(5)), torus = closed(test::torus(8, 6));
        QVERIFY(errorText(readMeshBytes(meshBytes(*torus), sphere->hash))
                    .find("of the hash " + torus->hash.hex() + " instead of " + sphere->hash.hex()) !=
                std::string::npos);
        const std::string renamed = fileOf(torus->mesh, sphere->hash);
        QVERIFY(errorText(readMeshBytes(renamed, sphere->hash)).find("its bytes were changed;") != std::string::npos);
    }
    void meshesThatCannotBeCutAreRefused() {
        TriangleMesh open = test::bumpySphere(5);
        open.triangles.pop_back();
        QCOMPARE(readMeshBytes(fileOf(open, hashOf(open)), hashOf(open)).error().code, ErrorCode::Degenerate);
        TriangleMesh unknown = test::bumpySphere(5);
        unknown.triangles[3][1] = 1'000'000;
        QVERIFY(!readMeshBytes(fileOf(unknown, hashOf(unknown)), hashOf(unknown)));
        const TriangleMesh none;
        QVERIFY(!readMeshBytes(fileOf(none, hashOf(none)), hashOf(none)));
    }
    void tooLargeMeshesAreRefused() {
        QVERIFY(checkMeshSize(kMaxMeshFilePoints, kMaxMeshFileTriangles));
        QCOMPARE(errorText(checkMeshSize(4, kMaxMeshFileTriangles + 1)),
                 std::string("The mesh has 2000001 triangles, but at most 2000000 are kept in a file; simplify it."));
        QCOMPARE(checkMeshSize(kMaxMeshFilePoints + 1, 4).error().code, ErrorCode::Limit);
    }
    void filesAreKnownByHeaderAndSize() {
        const QTemporaryDir folder;
        const auto path = std::filesystem::path(folder.path().toStdString()) / "a.mesh";
        const auto mesh = closed(test::bumpySphere(5));
        const std::string bytes = meshBytes(*mesh);
        QVERIFY(!isMeshFileOf(path, *mesh) && !isMeshFileOf(path.parent_path(), *mesh));
        for (const std::string& other : {std::string(), bytes.substr(0, 20), bytes.substr(0, bytes.size() - 1),
                                         bytes + "x", withNumber(bytes, kPointsAt, 3)}) {
            QVERIFY(writeFileAtomically(path, other));
            QVERIFY(!isMeshFileOf(path, *mesh));
        }
        QVERIFY(writeFileAtomically(path, bytes));
        QVERIFY(isMeshFileOf(path, *mesh) && !isMeshFileOf(path, *closed(test::torus(8, 6))));
    }
    void timeOfAMillionTriangles() {
        if (qEnvironmentVariableIsEmpty("RUBBLE_LONG")) QSKIP("with RUBBLE_LONG only");
        const auto mesh = closed(test::bumpySphere(708));
        QElapsedTimer timer;
        timer.start();
        const std::string bytes = meshBytes(*mesh);
        const qint64 written = timer.restart();
        QVERIFY(hashOf(mesh->mesh) == mesh->hash);
        const qint64 hashed = timer.restart();
        QVERIFY(closedMesh(mesh->mesh));
        const qint64 judged = timer.restart();
        QVERIFY(readMeshBytes(bytes, mesh->hash));
        qInfo("%zu triangles, %zu bytes: written in %lld ms, hashed in %lld ms, judged in %lld ms, read in %lld ms",
              mesh->mesh.triangles.size(), bytes.size(), written, hashed, judged, timer.elapsed());
    }
};

RUBBLE_TEST(MeshFileTest)
#include "MeshFileTest.moc"
