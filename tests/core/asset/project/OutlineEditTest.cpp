#include "core/asset/project/OutlineEdit.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class OutlineEditTest : public QObject {
    Q_OBJECT
private slots:
    void layersKeepTheFirstOutlineUntilItIsBack() {
        Asset asset = boxAsset(2, 3, UniformScatter{});
        asset.pattern.layers.push_back({.id = 4, .parameters = RadialPattern{}});
        asset.prism().outline = unitSquare();
        const Asset larger = withOutline(asset, {rectangle({0.0, 0.0}, {2.0, 1.0}), {}});
        QVERIFY(larger.pattern.layers[0].scatteredIn == unitSquare());
        QVERIFY(!larger.pattern.layers[1].scatteredIn);
        const Asset largest = withOutline(larger, {rectangle({0.0, 0.0}, {3.0, 1.0}), {}});
        QVERIFY(largest.pattern.layers[0].scatteredIn == unitSquare());
        QVERIFY(withOutline(largest, {reversed(unitSquare().outer), {}}).prism().outline.outer.size() == 4);
        QVERIFY(withOutline(largest, unitSquare()) == asset);
    }
};

RUBBLE_TEST(OutlineEditTest)
#include "OutlineEditTest.moc"
