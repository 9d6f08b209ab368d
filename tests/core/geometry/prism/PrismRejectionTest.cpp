#include "core/geometry/prism/PrismRejection.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// A square about the z axis.
struct Level {
    double z;
    double half;  // m: half its side
    double x = 0.0;
};

/// Appends the corners of a square, counter-clockwise from above.
std::uint32_t addCorners(TriangleMesh& mesh, const Level& level) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        mesh.points.emplace_back(level.x + level.half * corner.x, level.half * corner.y, level.z);
    return first;
}

/// Appends a square that faces up, or down at the bottom.
void addFace(TriangleMesh& mesh, std::uint32_t first) {
    const std::uint32_t second = first + (first == 0 ? 3 : 1), last = first + (first == 0 ? 1 : 3);
    mesh.triangles.push_back({first, second, first + 2});
    mesh.triangles.push_back({first, first + 2, last});
}

/// A tower of square cross-sections from the bottom to the top, with caps.
TriangleMesh tower(const std::vector<Level>& levels) {
    TriangleMesh mesh;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const std::uint32_t first = addCorners(mesh, levels[k]);
        if (k == 0 || k + 1 == levels.size()) addFace(mesh, first);
        for (std::uint32_t side = 0; side < 4 && k > 0; ++side) {
            const std::uint32_t a = first - 4 + side, b = first - 4 + (side + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
    }
    return mesh;
}

/// Level squares without sides.
TriangleMesh sheets(const std::vector<Level>& levels) {
    TriangleMesh mesh;
    for (const Level& level : levels) addFace(mesh, addCorners(mesh, level));
    return mesh;
}

QString rejection(const TriangleMesh& mesh, const ViewFrame& frame = {}) {
    constexpr double kRejectionTolerance = 1e-6;  // m
    return QString::fromStdString(
        prismRejection(viewAlong(mesh, frame, kRejectionTolerance), mesh, kRejectionTolerance));
}

}  // namespace

class PrismRejectionTest : public QObject {
    Q_OBJECT
private slots:
    void missingCapsAreNamed() {
        const TriangleMesh spire{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}}};
        QCOMPARE(rejection(spire), QString("The mesh has a flat cap at one end of the z axis only."));
        const TriangleMesh spindle{{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {1, 2, 3}}};
        QCOMPARE(rejection(spindle), QString("The mesh has no flat cap at either end of the z axis."));
    }
    void shiftOfTheTopCapIsMeasured() {
        QCOMPARE(rejection(tower({{0.0, 1.0}, {1.0, 1.0, 0.25}})),
                 QString("The top cap is shifted by 250 mm relative to the bottom, seen along the z axis."));
    }
    void tiltOfTheSidesIsMeasured() {
        QCOMPARE(rejection(tower({{0.0, 1.0}, {0.5, 0.5}})),
                 QString("The sides are tilted by 45 degrees from the z axis."));
        QCOMPARE(rejection(tower({{0.0, 1.0}, {0.5, 0.75, -0.25}})),  // upright at one side
                 QString("The sides are tilted by up to 45 degrees from the z axis."));
    }
    void bulgeBetweenTheCapsIsCurved() {
        QCOMPARE(rejection(tower({{0.0, 1.0}, {0.5, 1.5}, {1.0, 1.0}})),
                 QString("The mesh is curved or bent: between its caps, faces are tilted by up to 45 degrees from "
                         "the z axis."));
    }
    void stepIsMeasuredFromTheTop() {
        QCOMPARE(rejection(sheets({{0.0, 1.0}, {0.5, 1.0}, {0.75, 0.5}})),
                 QString("The mesh has a step: a face lies perpendicular to the z axis, 250 mm below the top cap."));
    }
    void differenceOfTheCapsIsMeasured() {
        QCOMPARE(rejection(sheets({{0.0, 1.0}, {1.0, 0.75}})),  // at their corners
                 QString("The caps perpendicular to the z axis differ by 354 mm."));
    }
    void obliqueAxisIsWrittenOut() {
        TriangleMesh turned = sheets({{0.0, 1.0}, {0.5, 1.0}, {0.75, 0.5}});
        const ViewFrame frame = frameAlong({0.6, 0.8, 0.0}, Vec3(0.0));
        for (Vec3& point : turned.points) point = point.x * frame.x + point.y * frame.y + point.z * frame.z;
        QCOMPARE(rejection(turned, frame), QString("The mesh has a step: a face lies perpendicular to the axis "
                                                   "(0.6, 0.8, 0), 250 mm below the top cap."));
    }
};

RUBBLE_TEST(PrismRejectionTest)
#include "PrismRejectionTest.moc"
