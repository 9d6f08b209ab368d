#include "core/asset/checks/VerifyMeshes.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"

#include <QTest>

#include <limits>

using namespace rubble;

class VerifyMeshesTest : public QObject {
    Q_OBJECT
private slots:
    void meshesOfABakeHaveNoFault() {
        Asset asset = ringAsset();
        const Result<Bake> smooth = bake(asset);
        QVERIFY(smooth);
        QCOMPARE(verifyMeshes(*smooth, asset).value_or(""), "");
        asset.shaping.roughness.amplitude = 0.02;
        const Result<Bake> rough = bake(asset);
        QVERIFY(rough);
        QCOMPARE(verifyMeshes(*rough, asset).value_or(""), "");
    }
    void volumeOfTheWholeIsCompared() {
        const Asset asset = ringAsset();
        Bake changed = *bake(asset);
        changed.whole.volume *= 2.0;
        const std::string fault = verifyMeshes(changed, asset).value_or("");
        QVERIFY2(fault.starts_with("Asset \"old ring\": the mesh of the whole: The volume is "), fault.c_str());
    }
    void faultyFragmentIsNamed() {
        const Asset asset = ringAsset();
        Bake changed = *bake(asset);
        Fragments& fragments = changed.fractures[0].fragments;
        fragments.extruded()->records[fragments.extruded()->pieceOfFragment[2]].moments.centre.x =
            std::numeric_limits<double>::quiet_NaN();
        const std::string start = "Asset \"old ring\": the mesh of fragment " + changed.fragmentId(2) + ": ";
        const std::string fault = verifyMeshes(changed, asset).value_or("");
        QVERIFY2(fault.starts_with(start), fault.c_str());
    }
};

RUBBLE_TEST(VerifyMeshesTest)
#include "VerifyMeshesTest.moc"
