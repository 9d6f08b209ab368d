#include "core/asset/SurfaceUv.h"

#include <QTest>

using namespace rubble;

namespace {

/// Two triangles that make the unit square at z = 0, facing +z; the second one's material and textures are others.
Surface squareOfTwo() {
    Surface surface;
    surface.triangles = {
        {{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}}, {Vec2{0, 0}, Vec2{10, 0}, Vec2{10, 10}}, 1},
        {{Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}, {Vec2{0.5, 0.5}, Vec2{0.5, 0.5}, Vec2{0.5, 0.5}}, 2}};
    return surface;
}

const Vec3 kUp{0.0, 0.0, 1.0};

}  // namespace

class SurfaceUvTest : public QObject {
    Q_OBJECT
private slots:
    void aMapIsAffine() { QVERIFY(mapped({{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}}, {10.0, 100.0}) == Vec2(213.0, 546.0)); }
    void insideATriangleTexturesAreBlended() {
        const SurfaceLook look = surfaceLook(squareOfTwo(), {0.75, 0.25, 0.0}, {0.75, 0.25, 0.0}, kUp);
        QVERIFY(glm::distance(look.uv, Vec2(7.5, 2.5)) < 1e-14);
        QCOMPARE(look.material, 1u);
    }
    void onASeamTheFacesCentreDecides() {
        const Vec3 seam{0.5, 0.5, 0.0};
        QVERIFY(glm::distance(surfaceLook(squareOfTwo(), seam, {0.9, 0.1, 0.0}, kUp).uv, Vec2(5.0, 5.0)) < 1e-14);
        QCOMPARE(surfaceLook(squareOfTwo(), seam, {0.1, 0.9, 0.0}, kUp).material, 2u);
    }
    void outsideNothingIsExtrapolated_data() {
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
    void outsideNothingIsExtrapolated() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, u);
        QFETCH(double, v);
        Surface surface = squareOfTwo();
        surface.triangles.pop_back();
        QVERIFY(glm::distance(surfaceLook(surface, {x, y, 0.0}, {x, y, 0.0}, kUp).uv, Vec2(u, v)) < 1e-14);
    }
    void trianglesThatFaceAwayAreOtherFaces() {
        const SurfaceLook look = surfaceLook(squareOfTwo(), {0.5, 0.2, 0.0}, {0.5, 0.2, 0.0}, -kUp);
        QVERIFY(look.uv == Vec2(0.0, 0.0));
        QCOMPARE(look.material, 0u);
    }
};

QTEST_APPLESS_MAIN(SurfaceUvTest)
#include "SurfaceUvTest.moc"
