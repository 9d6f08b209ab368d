#include "core/asset/project/AssetShape.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/MeshAsset.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

class AssetShapeTest : public QObject {
    Q_OBJECT
private slots:
    void prismsHaveTheBoxOfTheirOutline() {
        const Asset asset = assetOf({rectangle({-1.0, 0.0}, {3.0, 2.0}), {}}, 0.5);
        QCOMPARE(boundsOf(asset), (Box3{{-1.0, 0.0, -0.25}, {3.0, 2.0, 0.25}}));
        QCOMPARE(sizeOf(asset), Vec3(4.0, 2.0, 0.5));
        QCOMPARE(volumeOf(asset), 4.0);
        QCOMPARE(planeBoundsOf(asset).max, Vec2(3.0, 2.0));
    }
    void meshesHaveTheirOwn() {
        const Asset asset = meshAsset(cubes({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}}), 5);
        QCOMPARE(sizeOf(asset), Vec3(1.0, 2.0, 2.0));
        QVERIFY(std::abs(volumeOf(asset) - 3.0) < 1e-12);
        QCOMPARE(planeBoundsOf(asset).size(), Vec2(1.0, 2.0));
        QVERIFY(!asset.isPrism() && asset.mesh());
    }
    void assetsOfEqualMeshesAreEqual() {
        const Asset one = meshAsset(bumpySphere(8), 5), other = meshAsset(bumpySphere(8), 5);
        QVERIFY(one.mesh() != other.mesh());
        QVERIFY(one == other && isSameShape(one, other));
        QVERIFY(!isSameShape(one, meshAsset(bumpySphere(9), 5)));
        QVERIFY(!isSameShape(one, assetOf(unitSquare(), 1.0)));
    }
};

RUBBLE_TEST(AssetShapeTest)
#include "AssetShapeTest.moc"
