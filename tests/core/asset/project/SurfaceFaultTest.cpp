#include "core/asset/project/SurfaceFault.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace rubble;

namespace {

/// The fault of a triangle of one material after a change.
QString faultAfter(const std::function<void(Surface&)>& change) {
    Surface surface{.materials = {"stone"}, .triangles = {{.corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}}};
    change(surface);
    return QString::fromStdString(surfaceFault("Asset 2 \"gate\"", surface).value_or(""));
}

}  // namespace

class SurfaceFaultTest : public QObject {
    Q_OBJECT
private slots:
    void validSurfaceHasNoFault() {
        QCOMPARE(faultAfter([](Surface&) {}), QString());
        QCOMPARE(faultAfter([](Surface& surface) { surface.materials.clear(); }), QString());  // one without a name
    }
    void materialsMustExist() {
        QCOMPARE(faultAfter([](Surface& surface) { surface.triangles[0].material = 1; }),
                 QString("Asset 2 \"gate\": triangle 0 of the surface refers to a material that does not exist."));
        QCOMPARE(faultAfter([](Surface& surface) { surface.front.material = 1; }),
                 QString("Asset 2 \"gate\": the surface's front cap refers to a material that does not exist."));
        QCOMPARE(faultAfter([](Surface& surface) { surface.back.material = 1; }),
                 QString("Asset 2 \"gate\": the surface's back cap refers to a material that does not exist."));
        QCOMPARE(faultAfter([](Surface& surface) { surface.materials[0] = "\xff"; }),
                 QString("Asset 2 \"gate\": a material of the surface has a name that is not text in UTF-8."));
    }
    void numbersMustBeInTheirRanges() {
        const QString corner = faultAfter([](Surface& surface) { surface.triangles[0].corners[1].y = 1e30; });
        QVERIFY2(corner.startsWith("Asset 2 \"gate\": triangle 0 of the surface"), qPrintable(corner));
        QVERIFY2(corner.contains("corner"), qPrintable(corner));
        const QString uv = faultAfter([](Surface& surface) { surface.triangles[0].uvs[1].y = HUGE_VAL; });
        QVERIFY2(uv.contains("texture coordinate v"), qPrintable(uv));
        const QString map = faultAfter([](Surface& surface) { surface.back.map.coefficients[4] = HUGE_VAL; });
        QVERIFY2(map.startsWith("Asset 2 \"gate\": the surface's back cap"), qPrintable(map));
    }
};

RUBBLE_TEST(SurfaceFaultTest)
#include "SurfaceFaultTest.moc"
