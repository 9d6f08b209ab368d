#include "core/asset/import/SurfaceFit.h"
#include "core/asset/mesh/SurfaceUv.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

using namespace rubble;

namespace {

const Prism kRing{squareRing(), 1.0};
constexpr double kTolerance = 1e-5;

/// The square ring's mesh; texture coordinates are a map of x and y, shifted by z on its sides.
std::vector<SurfaceTriangle> ringTriangles() {
    const TriangleMesh solid = prismSolid(kRing.outline, kRing.depth);
    std::vector<SurfaceTriangle> triangles;
    for (const auto& corners : solid.triangles) {
        SurfaceTriangle& triangle = triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const Vec3 point = triangle.corners[k] = solid.points[corners[k]];
            triangle.uvs[k] = {0.25 * point.x - point.y + 3.0, 2.0 * point.y};
        }
    }
    return triangles;
}

FittedSurface fitted(const std::vector<SurfaceTriangle>& triangles, bool hasUvs = true) {
    return fittedSurface(triangles, hasUvs, {"unused", "Brick", "Plaster"}, kRing, kTolerance);
}

bool isFront(const SurfaceTriangle& triangle) {
    return triangle.corners[0].z + triangle.corners[1].z + triangle.corners[2].z == 1.5;
}

}  // namespace

class SurfaceFitTest : public QObject {
    Q_OBJECT
private slots:
    void affineCapUvsAreFittedExactly() {
        const FittedSurface fit = fitted(ringTriangles());
        QVERIFY(fit.surface->front.isAffine && fit.surface->back.isAffine);
        QVERIFY((fit.surface->front.map == AffineUv{{0.25, -1.0, 3.0, 0.0, 2.0, 0.0}}));
        QVERIFY(*fit.front.deviation < 1e-12);
        QCOMPARE(fit.front.triangles, std::size_t{8});
        QCOMPARE(fit.surface->triangles.size(), std::size_t{16});  // a map says all that the caps' triangles do
    }
    void affineFitToleratesSinglePrecision() {
        std::vector<SurfaceTriangle> triangles = ringTriangles();
        for (SurfaceTriangle& triangle : triangles)
            for (Vec2& uv : triangle.uvs) uv = {static_cast<float>(uv.x * 1.1), static_cast<float>(uv.y / 3.0)};
        QVERIFY(fitted(triangles).surface->front.isAffine);
    }
    void nonAffineCapsKeepTheirTriangles() {
        std::vector<SurfaceTriangle> triangles = ringTriangles();
        const auto front = std::ranges::find_if(triangles, isFront);
        front->uvs[0].x += 0.5;
        const FittedSurface fit = fitted(triangles);
        QVERIFY(!fit.surface->front.isAffine && fit.surface->back.isAffine);
        QVERIFY(*fit.front.deviation > 0.1);
        QCOMPARE(fit.surface->triangles.size(), std::size_t{24});
        const Vec3 middle = (front->corners[0] + front->corners[1] + front->corners[2]) / 3.0;
        const Vec2 expected = (front->uvs[0] + front->uvs[1] + front->uvs[2]) / 3.0;
        QVERIFY(glm::distance(SurfaceIndex(*fit.surface).sample(middle, middle, {0, 0, 1}).uv, expected) < 1e-12);
    }
    void capTakesTheMaterialWithTheLargestArea() {
        std::vector<SurfaceTriangle> triangles = ringTriangles();
        for (SurfaceTriangle& triangle : triangles) triangle.material = 2;
        std::ranges::find_if(triangles, isFront)->material = 1;
        const FittedSurface fit = fitted(triangles);
        QVERIFY(!fit.surface->front.isAffine);
        QCOMPARE(fit.front.materials, std::size_t{2});
        QCOMPARE(fit.surface->materials, (std::vector<std::string>{"Brick", "Plaster"}));
        QCOMPARE(fit.surface->front.material, 1u);
    }
    void noSurfaceWithoutUvsAndMaterials() { QVERIFY(fitted(ringTriangles(), false).surface == nullptr); }
    void withoutUvsTheOutlineGivesThem() {
        std::vector<SurfaceTriangle> triangles = ringTriangles();
        for (SurfaceTriangle& triangle : triangles) triangle.material = isFront(triangle) ? 1 : 2;
        const FittedSurface fit = fitted(triangles, false);
        QVERIFY((fit.surface->front.map == AffineUv{{1.0, 0.0, 0.0, 0.0, 1.0, 0.0}}));
        // The first outer edge runs along y = 0 from (0, 0): its length is x.
        const SurfaceSample sample = SurfaceIndex(*fit.surface).sample({1.5, 0.0, 0.25}, {1.5, 0.0, 0.25}, {0, -1, 0});
        QVERIFY(glm::distance(sample.uv, Vec2(1.5, 0.25)) < 1e-12);
        QCOMPARE(sample.material, 1u);
    }
};

RUBBLE_TEST(SurfaceFitTest)
#include "SurfaceFitTest.moc"
