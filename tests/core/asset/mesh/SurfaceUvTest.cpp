#include "core/asset/mesh/SurfaceUv.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

/// Two triangles that make the unit square at z = 0, facing +z; with different materials and textures.
Surface squareOfTwo() {
    Surface surface;
    surface.triangles = {
        {{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}}, {Vec2{0, 0}, Vec2{10, 0}, Vec2{10, 10}}, 1},
        {{Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}, {Vec2{0.5, 0.5}, Vec2{0.5, 0.5}, Vec2{0.5, 0.5}}, 2}};
    return surface;
}

SurfaceSample sampleSquare(Vec3 point, Vec3 faceCentre, Vec3 normal) {
    const Surface surface = squareOfTwo();
    return SurfaceIndex(surface).sample(point, faceCentre, normal);
}

/// The sides of an extruded regular n-gon of radius 1 and depth 1, two triangles each, with z and the angle as texture.
Surface sidesOf(std::uint32_t corners) {
    Surface surface;
    const auto at = [&](std::uint32_t k, double z) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        return Vec3(std::cos(angle), std::sin(angle), z);
    };
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double from = k, to = k + 1.0;
        surface.triangles.push_back(
            {{at(k, -0.5), at(k + 1, -0.5), at(k + 1, 0.5)}, {Vec2{from, -0.5}, Vec2{to, -0.5}, Vec2{to, 0.5}}});
        surface.triangles.push_back(
            {{at(k, -0.5), at(k + 1, 0.5), at(k, 0.5)}, {Vec2{from, -0.5}, Vec2{to, 0.5}, Vec2{from, 0.5}}});
    }
    return surface;
}

const Vec3 kUp{0.0, 0.0, 1.0};

}  // namespace

class SurfaceUvTest : public QObject {
    Q_OBJECT
private slots:
    void capUvIsAffine() { QVERIFY(mapped({{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}}, {10.0, 100.0}) == Vec2(213.0, 546.0)); }
    void uvsAreInterpolatedInsideATriangle() {
        const SurfaceSample sample = sampleSquare({0.75, 0.25, 0.0}, {0.75, 0.25, 0.0}, kUp);
        QVERIFY(glm::distance(sample.uv, Vec2(7.5, 2.5)) < 1e-14);
        QCOMPARE(sample.material, 1u);
    }
    void faceCentreDecidesOnASeam() {
        const Vec3 seam{0.5, 0.5, 0.0};
        QVERIFY(glm::distance(sampleSquare(seam, {0.9, 0.1, 0.0}, kUp).uv, Vec2(5.0, 5.0)) < 1e-14);
        QCOMPARE(sampleSquare(seam, {0.1, 0.9, 0.0}, kUp).material, 2u);
    }
    void uvsAreNotExtrapolated_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("u");
        QTest::addColumn<double>("v");
        QTest::addRow("beyond a corner") << 3.0 << -3.0 << 10.0 << 0.0;
        QTest::addRow("beyond the first corner") << -3.0 << -4.0 << 0.0 << 0.0;
        QTest::addRow("beyond the third corner") << 3.0 << 4.0 << 10.0 << 10.0;
        QTest::addRow("beyond the first edge") << 0.25 << -3.0 << 2.5 << 0.0;
        QTest::addRow("beyond the second edge") << 3.0 << 0.25 << 10.0 << 2.5;
        QTest::addRow("beyond the third edge") << 0.0 << 0.5 << 2.5 << 2.5;
    }
    void uvsAreNotExtrapolated() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, u);
        QFETCH(double, v);
        Surface surface = squareOfTwo();
        surface.triangles.pop_back();
        QVERIFY(glm::distance(SurfaceIndex(surface).sample({x, y, 0.0}, {x, y, 0.0}, kUp).uv, Vec2(u, v)) < 1e-14);
    }
    void trianglesFacingAwayAreIgnored() {
        const SurfaceSample sample = sampleSquare({0.5, 0.2, 0.0}, {0.5, 0.2, 0.0}, -kUp);
        QVERIFY(sample.uv == Vec2(0.0, 0.0));
        QCOMPARE(sample.material, 0u);
    }
    void sidesAreFoundInFewVisits() {
        constexpr std::uint32_t kCorners = 16000;
        const Surface surface = sidesOf(kCorners);
        const SurfaceIndex index(surface);
        std::size_t visited = 0;
        for (std::uint32_t k = 0; k < kCorners; ++k) {
            const Vec3 middle = (surface.triangles[2 * k].corners[0] + surface.triangles[2 * k].corners[2]) / 2.0;
            const Vec3 normal = glm::normalize(Vec3(middle.x, middle.y, 0.0));
            const SurfaceSample sample = index.sample(middle, middle, normal, &visited);
            QVERIFY(glm::distance(sample.uv, Vec2(k + 0.5, 0.0)) < 1e-6);
        }
        QVERIFY2(visited < 32u * kCorners, qPrintable(QString::number(visited)));
    }
};

RUBBLE_TEST(SurfaceUvTest)
#include "SurfaceUvTest.moc"
