#include "core/asset/strength/BondStrength.h"

#include "core/asset/project/Ranges.h"
#include "tests/support/TestProgram.h"

using namespace rubble;

class BondStrengthTest : public QObject {
    Q_OBJECT
private slots:
    void followsFromTheStrengthAndTheContactTime() {
        Asset asset;
        QCOMPARE(bondImpulseOf(asset, Material{}), 500.0);
        const Material brick{.tensileStrength = 2e6};
        QCOMPARE(bondImpulseOf(asset, brick), 2000.0);  // for the default of a millisecond
        asset.contactTime = 0.5;
        QCOMPARE(bondImpulseOf(asset, brick), 1e6);
    }
    void whatIsEnteredCounts() {
        Asset asset;
        asset.bonding.impulsePerArea = 7.0;
        QCOMPARE(bondImpulseOf(asset, Material{}), 7.0);
        QCOMPARE(bondImpulseOf(asset, Material{.tensileStrength = 2e6}), 7.0);
        QCOMPARE(derivedBondImpulse(asset, Material{.tensileStrength = 2e6}), std::optional(2000.0));
    }
    void derivedImpulsesAreInTheirRange() {
        const NumberRange &strength = rangeOf(ProjectNumber::TensileStrength),
                          &time = rangeOf(ProjectNumber::ContactTime);
        Asset asset;
        for (const auto& [pascals, seconds] : {std::pair(strength.min, time.min), std::pair(strength.max, time.max)}) {
            asset.contactTime = seconds;
            const double derived = derivedBondImpulse(asset, {.tensileStrength = pascals}).value();
            QVERIFY(rangeOf(ProjectNumber::BondImpulse).contains(derived));
        }
    }
};

RUBBLE_TEST(BondStrengthTest)
#include "BondStrengthTest.moc"
