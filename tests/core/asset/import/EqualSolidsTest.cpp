#include "core/asset/import/EqualSolids.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <functional>

using namespace rubble;

namespace {

constexpr double kSolidTolerance = 1e-3;  // m

/// A square ring with one triangle of surface.
Surface surfaceOf() {
    return {.materials = {"stone"},
            .front = {.isAffine = true, .map = {{1.0, 0.0, 0.0, 0.0, 1.0, 0.0}}},
            .triangles = {{.corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                           .uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}}}};
}

Asset ring() {
    Asset asset;
    asset.shape = Prism{squareRing(), 1.0};
    asset.surface = std::make_shared<const Surface>(surfaceOf());
    return asset;
}

/// Whether the ring is equal to its solid after a change.
bool isEqualAfter(const std::function<void(ImportedSolid&, Surface&)>& change) {
    ImportedSolid solid{.prism = PrismFit{.outline = squareRing(), .depth = 1.0}};
    Surface surface = surfaceOf();
    change(solid, surface);
    solid.surface.surface = std::make_shared<const Surface>(surface);
    return isEqual(ring(), solid, kSolidTolerance);
}

}  // namespace

class EqualSolidsTest : public QObject {
    Q_OBJECT
private slots:
    void smallDifferencesAreAllowed() {
        QVERIFY(isEqualAfter([](ImportedSolid&, Surface&) {}));
        QVERIFY(isEqualAfter([](ImportedSolid& solid, Surface&) { solid.prism->depth += 0.5 * kSolidTolerance; }));
        QVERIFY(isEqualAfter(
            [](ImportedSolid& solid, Surface&) { solid.prism->outline.outer[1].x += 0.5 * kSolidTolerance; }));
        QVERIFY(isEqualAfter([](ImportedSolid&, Surface& surface) { surface.triangles[0].corners[2].z = 0.5e-3; }));
        QVERIFY(isEqualAfter([](ImportedSolid&, Surface& surface) { surface.triangles[0].uvs[2].x = 1e-6; }));
    }
    void otherPrismIsAnotherSolid() {
        QVERIFY(!isEqualAfter([](ImportedSolid& solid, Surface&) { solid.prism->depth += 2.0 * kSolidTolerance; }));
        QVERIFY(!isEqualAfter(
            [](ImportedSolid& solid, Surface&) { solid.prism->outline.outer[1].x += 2.0 * kSolidTolerance; }));
        QVERIFY(!isEqualAfter([](ImportedSolid& solid, Surface&) { solid.prism->outline.holes[0][0].y += 0.1; }));
        QVERIFY(!isEqualAfter([](ImportedSolid& solid, Surface&) { solid.prism->outline.holes.clear(); }));
    }
    void otherSurfaceIsAnotherSolid() {
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.materials[0] = "wood"; }));
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.front.isAffine = false; }));
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.front.map.coefficients[2] = 0.1; }));
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.triangles[0].material = 1; }));
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.triangles[0].uvs[2].x = 0.1; }));
        QVERIFY(!isEqualAfter([](ImportedSolid&, Surface& surface) { surface.triangles.clear(); }));
    }
    void solidWithoutASurfaceEqualsOnlyItsLike() {
        const ImportedSolid bare{.prism = PrismFit{.outline = squareRing(), .depth = 1.0}};
        QVERIFY(!isEqual(ring(), bare, kSolidTolerance));
        Asset plain = ring();
        plain.surface = nullptr;
        QVERIFY(isEqual(plain, bare, kSolidTolerance));
    }
};

RUBBLE_TEST(EqualSolidsTest)
#include "EqualSolidsTest.moc"
