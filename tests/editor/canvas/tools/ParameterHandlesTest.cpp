#include "editor/canvas/tools/ParameterHandles.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// A square of 2 m with its centre at (1, 1).
Asset wallOfTwoMetres(LayerParameters parameters) {
    Asset asset = boxAsset(2, 3, std::move(parameters));
    asset.prism().outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}};
    return asset;
}

}  // namespace

class ParameterHandlesTest : public QObject {
    Q_OBJECT
private slots:
    void radialLayerHasAHandleAtItsCentre() {
        const auto handles = parameterHandles(wallOfTwoMetres(RadialPattern{.centre = {0.5, 0.25}}));
        QCOMPARE(handles.size(), std::size_t{1});
        QCOMPARE(handles[0].position, Vec2(0.5, 0.25));
        QVERIFY(!handles[0].pivot);
    }
    void grainHasAHandleInItsDirection() {
        const auto handles = parameterHandles(wallOfTwoMetres(Grain{.angle = 0.0}));
        QCOMPARE(handles.size(), std::size_t{1});
        QCOMPARE(handles[0].pivot.value(), Vec2(1.0, 1.0));
        QVERIFY(handles[0].position.x > 1.0);
        QCOMPARE(handles[0].position.y, 1.0);
    }
    void disabledLayersAndScattersHaveNone() {
        Asset asset = wallOfTwoMetres(RadialPattern{});
        asset.pattern.layers[0].isOn = false;
        QVERIFY(parameterHandles(asset).empty());
        QVERIFY(parameterHandles(wallOfTwoMetres(UniformScatter{})).empty());
    }
};

RUBBLE_TEST(ParameterHandlesTest)
#include "ParameterHandlesTest.moc"
