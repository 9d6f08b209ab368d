#include "core/physics/narrowphase/Manifold.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr float kMargin = 0.02f;  // m

Mat3f aboutZ(float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {Vec3f(c, s, 0.0f), Vec3f(-s, c, 0.0f), Vec3f(0.0f, 0.0f, 1.0f)};
}

SeparatingAxis faceOf(const Hull& hull, Vec3f direction, AxisKind kind = AxisKind::FirstFace) {
    const auto face = static_cast<std::uint16_t>(hull.faceAlong(direction));
    return {.kind = kind, .first = face, .second = face};
}

/// The manifold of a hull on a table, which is 4 m wide with its top at y = 0.5.
Manifold onTable(const Hull& hull, const RelativePose& pose, float margin = kMargin) {
    const Hull table = hullOf(boxOf({4.0, 1.0, 4.0}));
    return manifoldAlong(faceOf(table, Vec3f(0.0f, 1.0f, 0.0f)), table, hull, pose, margin);
}

std::span<const Manifold::Point> pointsOf(const Manifold& manifold) {
    return {manifold.points.data(), static_cast<std::size_t>(manifold.count)};
}

bool hasPoint(const Manifold& manifold, Vec3f position, float separation) {
    return std::ranges::any_of(pointsOf(manifold), [&](const Manifold::Point& point) {
        return length(point.position - position) < 1e-5f && std::abs(point.separation - separation) < 1e-5f;
    });
}

std::set<std::uint32_t> featuresOf(const Manifold& manifold) {
    std::set<std::uint32_t> features;
    for (const Manifold::Point& point : pointsOf(manifold)) features.insert(point.feature);
    return features;
}

/// A square prism of 2 m with edges at half a diagonal from its axis, which is x or z.
Hull prismAlong(int axis) {
    std::vector<Vec3> corners;
    for (const double end : {-1.0, 1.0}) {
        for (const auto& [u, v] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
            const double a = u * std::sqrt(0.5), b = v * std::sqrt(0.5);
            corners.push_back(axis == 0 ? Vec3(end, a, b) : Vec3(a, b, end));
        }
    }
    return hullOf(*convexHull(corners));
}

/// A prism along z crosses over one along x at their edges, `separation` apart.
struct CrossedPrisms {
    Hull first = prismAlong(0), second = prismAlong(2);
    RelativePose pose;
    SeparatingAxis axis;

    explicit CrossedPrisms(float separation) : pose{{}, Vec3f(0.2f, std::sqrt(2.0f) + separation, 0.3f)} {
        axis = separatingAxis(first, second, pose, 1e30f, {});
    }
};

}  // namespace

class ManifoldTest : public QObject {
    Q_OBJECT
private slots:
    /// A cube sunk 10 mm into the table: its four corners, half of the depth above them.
    void boxStandsOnItsCorners() {
        const Manifold manifold = onTable(hullOf(boxOf(Vec3(1.0))), {{}, Vec3f(0.25f, 0.99f, 0.0f)});
        QCOMPARE(manifold.count, 4);
        QVERIFY(manifold.normal == Vec3f(0.0f, 1.0f, 0.0f));
        for (const float x : {-0.25f, 0.75f}) {
            for (const float z : {-0.5f, 0.5f}) QVERIFY(hasPoint(manifold, Vec3f(x, 0.495f, z), -0.01f));
        }
        QCOMPARE(featuresOf(manifold).size(), std::size_t{4});
    }
    /// Half of it is beyond the edge of the table: it stands on two corners, and on two points over the edge.
    void boxOverTheEdgeIsClipped() {
        const Manifold manifold = onTable(hullOf(boxOf(Vec3(1.0))), {{}, Vec3f(2.0f, 1.0f, 0.0f)});
        QCOMPARE(manifold.count, 4);
        for (const float x : {1.5f, 2.0f}) {
            for (const float z : {-0.5f, 0.5f}) QVERIFY(hasPoint(manifold, Vec3f(x, 0.5f, z), 0.0f));
        }
        QCOMPARE(featuresOf(manifold).size(), std::size_t{4});
    }
    /// Tilted by 0.1 rad, one edge is 10 cm lower than the other.
    void pointsBeyondTheMarginAreLeftOut() {
        const RelativePose tilted{aboutZ(0.1f), Vec3f(0.0f, 0.5f + 0.5f * (std::cos(0.1f) + std::sin(0.1f)), 0.0f)};
        const Manifold manifold = onTable(hullOf(boxOf(Vec3(1.0))), tilted);
        QCOMPARE(manifold.count, 2);
        for (const Manifold::Point& point : pointsOf(manifold)) {
            QVERIFY(std::abs(point.separation) < 1e-5f);
            QVERIFY(point.position.x < 0.0f);
        }
        const Manifold all = onTable(hullOf(boxOf(Vec3(1.0))), tilted, 1.0f);
        QCOMPARE(all.count, 4);
        for (const Manifold::Point& point : pointsOf(all)) {
            QVERIFY(std::abs(point.separation - (point.position.x > 0.0f ? std::sin(0.1f) : 0.0f)) < 1e-5f);
        }
        QCOMPARE(onTable(hullOf(boxOf(Vec3(1.0))), {{}, Vec3f(0.0f, 1.03f, 0.0f)}).count, 0);
    }
    /// A twelve-sided prism on its end: of twelve points four remain, which span more than 80 % of the largest square.
    void manyPointsAreReducedToFour() {
        std::vector<Vec3> corners;
        for (int k = 0; k < 12; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 12.0;
            for (const double y : {-0.5, 0.5}) corners.push_back({cosine(angle), y, sine(angle)});
        }
        const Manifold manifold = onTable(hullOf(*convexHull(corners)), {{}, Vec3f(0.0f, 1.0f, 0.0f)});
        QCOMPARE(manifold.count, 4);
        std::vector<float> angles;
        for (const Manifold::Point& point : pointsOf(manifold)) {
            QVERIFY(std::abs(length(point.position - Vec3f(0.0f, 0.5f, 0.0f)) - 1.0f) < 1e-5f);
            angles.push_back(std::atan2(point.position.z, point.position.x));
        }
        std::ranges::sort(angles);
        float area = 0.0f;
        for (std::size_t k = 0; k < 4; ++k) area += 0.5f * std::sin(angles[(k + 1) % 4] - angles[k]);
        QVERIFY(area > 0.8f * 2.0f);
    }
    /// The deepest point stays: the prism leans towards one of its corners by 20 mm.
    void deepestPointIsKept() {
        std::vector<Vec3> corners;
        for (int k = 0; k < 12; ++k) {
            const double angle = 2.0 * std::numbers::pi * (k + 0.3) / 12.0;
            for (const double y : {-0.5, 0.5}) corners.push_back({cosine(angle), y, sine(angle)});
        }
        const Manifold manifold = onTable(hullOf(*convexHull(corners)), {aboutZ(0.01f), Vec3f(0.0f, 1.0f, 0.0f)}, 1.0f);
        float deepest = 1.0f;
        for (const Manifold::Point& point : pointsOf(manifold)) deepest = std::min(deepest, point.separation);
        const float leaning = -0.01f * static_cast<float>(cosine(2.0 * std::numbers::pi * 0.3 / 12.0));
        QVERIFY(std::abs(deepest - leaning) < 1e-4f);
    }
    void featuresStayWithTheirPoints() {
        const Hull cube = hullOf(boxOf(Vec3(1.0)));
        const Manifold before = onTable(cube, {{}, Vec3f(1.9f, 1.0f, 0.0f)});
        const Manifold after = onTable(cube, {aboutZ(0.001f), Vec3f(1.95f, 0.999f, 0.01f)});
        QVERIFY(featuresOf(before) == featuresOf(after));
    }
    /// The same contact, of a face of the second hull: the same points, with features of their own.
    void facesOfTheSecondHull() {
        const Hull table = hullOf(boxOf({4.0, 1.0, 4.0})), cube = hullOf(boxOf(Vec3(1.0)));
        const Manifold under = manifoldAlong(faceOf(cube, Vec3f(-1.0f, 0.0f, 0.0f), AxisKind::SecondFace), table, cube,
                                             {aboutZ(0.5f * 3.14159265f), Vec3f(0.25f, 0.99f, 0.0f)}, kMargin);
        QCOMPARE(under.count, 4);
        QVERIFY(length(under.normal - Vec3f(0.0f, 1.0f, 0.0f)) < 1e-6f);
        for (const float x : {-0.25f, 0.75f}) {
            for (const float z : {-0.5f, 0.5f}) QVERIFY(hasPoint(under, Vec3f(x, 0.495f, z), -0.01f));
        }
        const auto others = featuresOf(onTable(cube, {{}, Vec3f(0.25f, 0.99f, 0.0f)}));
        for (const std::uint32_t feature : featuresOf(under)) QVERIFY(!others.contains(feature));
    }
    /// No face is within 37 degrees of the axis: the point between the edges, halfway.
    void crossedEdgesTouchAtOnePoint() {
        for (const float separation : {0.01f, -0.01f}) {
            const CrossedPrisms crossed(separation);
            QVERIFY(crossed.axis.kind == AxisKind::Edges);
            const Manifold manifold = manifoldAlong(crossed.axis, crossed.first, crossed.second, crossed.pose, kMargin);
            QCOMPARE(manifold.count, 1);
            QVERIFY(length(manifold.normal - Vec3f(0.0f, 1.0f, 0.0f)) < 1e-5f);
            QVERIFY(hasPoint(manifold, Vec3f(0.2f, std::sqrt(0.5f) + 0.5f * separation, 0.0f), separation));
        }
        const CrossedPrisms apart(0.03f);
        QCOMPARE(manifoldAlong(apart.axis, apart.first, apart.second, apart.pose, kMargin).count, 0);
    }
    void edgesThatPassEachOtherDoNotTouch() {
        CrossedPrisms crossed(0.01f);
        crossed.pose.offset.x = 1.5f;  // beyond the end of the first edge
        QCOMPARE(manifoldAlong(crossed.axis, crossed.first, crossed.second, crossed.pose, kMargin).count, 0);
        crossed.pose.offset.x = 0.2f;
        crossed.pose.offset.z = -1.5f;  // beyond the end of the second
        QCOMPARE(manifoldAlong(crossed.axis, crossed.first, crossed.second, crossed.pose, kMargin).count, 0);
    }
    void hullsThatTouchHaveAPoint() {
        const CrossedPrisms crossed(0.03f);
        const Manifold manifold = touchingManifold(crossed.axis, crossed.first, crossed.second, crossed.pose, kMargin);
        QCOMPARE(manifold.count, 1);
        QCOMPARE(manifold.points[0].separation, 0.0f);
        const Vec3f inSecond = manifold.points[0].position - crossed.pose.offset;
        QVERIFY(std::abs(inSecond.y + std::sqrt(0.5f)) < 1e-5f);  // a lowest corner of the second
    }
    void cornerOfTheFirstHullTouchesAFaceOfTheSecond() {
        const Hull prism = prismAlong(0), cube = hullOf(boxOf(Vec3(1.0)));
        SeparatingAxis axis = faceOf(cube, Vec3f(0.0f, -1.0f, 0.0f), AxisKind::SecondFace);
        axis.normal = Vec3f(0.0f, 1.0f, 0.0f);
        // Beyond the margin, so that clipping leaves nothing.
        const Manifold manifold = touchingManifold(axis, prism, cube, {{}, Vec3f(0.0f, 2.0f, 0.0f)}, kMargin);
        QCOMPARE(manifold.count, 1);
        QVERIFY(std::abs(manifold.points[0].position.y - std::sqrt(0.5f)) < 1e-6f);
        QVERIFY(std::abs(std::abs(manifold.points[0].position.x) - 1.0f) < 1e-6f);
    }
    void noAxisHasNoPoints() {
        const Hull cube = hullOf(boxOf(Vec3(1.0)));
        QCOMPARE(manifoldAlong({}, cube, cube, {{}, Vec3f(0.0f, 1.0f, 0.0f)}, kMargin).count, 0);
    }
};

RUBBLE_TEST(ManifoldTest)
#include "ManifoldTest.moc"
