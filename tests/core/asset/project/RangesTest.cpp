#include "core/asset/project/Ranges.h"

#include "core/asset/project/Project.h"
#include "core/asset/strength/Threshold.h"
#include "tests/support/TestProgram.h"

#include <cmath>
#include <limits>

using namespace rubble;

namespace {

double defaultOf(ProjectNumber number) { return rangeOf(number).defaultValue; }

}  // namespace

class RangesTest : public QObject {
    Q_OBJECT
private slots:
    void everyRangeIsFiniteAndHoldsItsDefault() {
        for (int k = 0; k < kProjectNumbers; ++k) {
            const NumberRange& range = rangeOf(static_cast<ProjectNumber>(k));
            QVERIFY(std::isfinite(range.min) && std::isfinite(range.max) && range.min < range.max);
            QVERIFY2(range.contains(range.defaultValue), range.name);
            QVERIFY(std::string(range.name) != "" && std::string(range.reason) != "");
        }
    }
    void defaultsAreThoseOfTheProject() {
        const Material material;
        QCOMPARE(defaultOf(ProjectNumber::Density), material.density);
        QCOMPARE(defaultOf(ProjectNumber::Friction), material.friction);
        QCOMPARE(defaultOf(ProjectNumber::Restitution), material.restitution);
        QCOMPARE(defaultOf(ProjectNumber::ColourChannel), material.outside.red);
        const Asset asset;
        QCOMPARE(defaultOf(ProjectNumber::Threshold), asset.threshold);
        QCOMPARE(defaultOf(ProjectNumber::InsideUvScale), asset.insideUvScale);
        QCOMPARE(defaultOf(ProjectNumber::ContactTime), kDefaultContactTime);
        QCOMPARE(defaultOf(ProjectNumber::Gap), asset.shaping.gap);
        QCOMPARE(defaultOf(ProjectNumber::RoughnessAmplitude), asset.shaping.roughness.amplitude);
        QCOMPARE(defaultOf(ProjectNumber::RoughnessFrequency), asset.shaping.roughness.frequency);
        QCOMPARE(defaultOf(ProjectNumber::RoughnessOctaves), static_cast<double>(asset.shaping.roughness.octaves));
        QCOMPARE(defaultOf(ProjectNumber::MinimumVolume), Level().minimumVolume);
        QCOMPARE(defaultOf(ProjectNumber::ImpactFragments), static_cast<double>(CutAtImpact().fragments));
        QCOMPARE(defaultOf(ProjectNumber::ImpactFalloffRadius), CutAtImpact().falloffRadius);
        QCOMPARE(defaultOf(ProjectNumber::DropHeight), DropRequirement().height);
        QCOMPARE(defaultOf(ProjectNumber::HitSpeed), HitRequirement().speed);
        const Project project;
        QCOMPARE(defaultOf(ProjectNumber::Gravity), project.gravity.y);
        QCOMPARE(defaultOf(ProjectNumber::GroundHeight), project.ground.height);
        QCOMPARE(defaultOf(ProjectNumber::DebrisFade), project.debris.fade);
        QCOMPARE(defaultOf(ProjectNumber::EventEnergy), project.events.leastEnergy);
        QCOMPARE(defaultOf(ProjectNumber::EventRecords), static_cast<double>(project.events.maxRecords));
        QCOMPARE(defaultOf(ProjectNumber::ProjectileSize), Throw().size.x);
        QCOMPARE(defaultOf(ProjectNumber::Mass), Throw().mass);
        QCOMPARE(defaultOf(ProjectNumber::ProjectileSpeed), Throw().speed);
        QCOMPARE(defaultOf(ProjectNumber::BlastImpulse), Blast().impulse);
        QCOMPARE(defaultOf(ProjectNumber::BlastRadius), Blast().radius);
        QCOMPARE(defaultOf(ProjectNumber::ShotTime), Shot().time);
        QCOMPARE(defaultOf(ProjectNumber::TestDuration), PlayTest().duration);
        QCOMPARE(defaultOf(ProjectNumber::InstanceVariant), static_cast<double>(Instance().variant));
        QCOMPARE(defaultOf(numberOf(SmallPieces().measure)), SmallPieces().limit);
    }
    void defaultsOfBondsAreThoseOfTheProject() {
        const Bonding bonding;
        QCOMPARE(defaultOf(ProjectNumber::BondLoadRadius), bonding.radius);
        QCOMPARE(defaultOf(ProjectNumber::BondDamageFrom), bonding.damageFrom);
        QCOMPARE(defaultOf(ProjectNumber::BondSpan), bonding.span);
        QCOMPARE(defaultOf(ProjectNumber::BondCollapseDelay), bonding.collapseDelay);
        QCOMPARE(defaultOf(ProjectNumber::BondMinimumIsland), static_cast<double>(bonding.minimumIsland));
        QCOMPARE(defaultOf(ProjectNumber::BondClusterLevel), static_cast<double>(FragmentCluster().level));
        QCOMPARE(defaultOf(ProjectNumber::BondBrushRadius), BondStroke().radius);
        QCOMPARE(defaultOf(ProjectNumber::BondStrengthHeight), HeightStrength().height);
        for (const double factor : {Level().bondStrength, Instance().bondStrength, BondStroke().strength,
                                    HeightStrength().factor, StrengthImage().brightest})
            QCOMPARE(defaultOf(ProjectNumber::BondStrength), factor);
        QCOMPARE(defaultOf(ProjectNumber::BondImpulse), Mortar().impulsePerArea);
        QCOMPARE(defaultOf(ProjectNumber::MortarTolerance), Mortar().tolerance);
        QCOMPARE(defaultOf(ProjectNumber::MortarLeastArea), Mortar().leastArea);
    }
    void valuesOfExpectationsHaveTheirOwnRanges() {
        const auto rangeOfKind = [](ExpectationKind kind) { return rangeOf(numberOf(kind)); };
        QVERIFY(!rangeOfKind(ExpectationKind::StandsUntouched).contains(-1.0));
        QVERIFY(!rangeOfKind(ExpectationKind::BreaksIntoAtLeast).contains(-1.0));
        QVERIFY(!rangeOfKind(ExpectationKind::NothingFaster).contains(-1.0));
        QVERIFY(rangeOfKind(ExpectationKind::NothingAbove).contains(-1.0));
        QVERIFY(rangeOfKind(ExpectationKind::StaysUp).contains(1.0));
        QVERIFY(!rangeOfKind(ExpectationKind::StaysUp).contains(1.1));
        QVERIFY(rangeOfKind(ExpectationKind::HoleAtMost).contains(0.0));
        QVERIFY(!rangeOfKind(ExpectationKind::HoleAtMost).contains(-0.1));
    }
    void endsOfRanges() {
        QVERIFY(!rangeOf(ProjectNumber::Density).contains(0.0));
        QVERIFY(rangeOf(ProjectNumber::Density).contains(1e-3));
        QVERIFY(!rangeOf(ProjectNumber::Density).contains(std::nextafter(1e-3, 0.0)));
        QVERIFY(rangeOf(ProjectNumber::Gap).contains(0.0));
        QVERIFY(rangeOf(ProjectNumber::Gap).contains(1e-6));
        QVERIFY(!rangeOf(ProjectNumber::Gap).contains(1e-300));
        QVERIFY(rangeOf(ProjectNumber::Friction).contains(0.0));
        QVERIFY(!rangeOf(ProjectNumber::Friction).contains(-5e-324));
        QVERIFY(rangeOf(ProjectNumber::Restitution).contains(1.0));
        QVERIFY(!rangeOf(ProjectNumber::Restitution).contains(std::nextafter(1.0, 2.0)));
        for (int k = 0; k < kProjectNumbers; ++k) {
            const NumberRange& range = rangeOf(static_cast<ProjectNumber>(k));
            QVERIFY(!range.contains(std::nan("")));
            QVERIFY(!range.contains(std::numeric_limits<double>::infinity()));
        }
    }
    void faultsAreSentences() {
        QCOMPARE(rangeFault("Material 1 \"brick\"", {{ProjectNumber::Density, 0.0}}).value(),
                 std::string("Material 1 \"brick\": the density is 0, but it must be from 0.001 to 1000000."));
        QCOMPARE(rangeFault("The ground", {{ProjectNumber::Friction, 0.5}, {ProjectNumber::Restitution, 2.0}}).value(),
                 std::string("The ground: the restitution is 2, but it must be from 0 to 1."));
        QCOMPARE(rangeFault("Shot 1", ProjectNumber::ShotPosition, {0.0, std::nan(""), 1.0}, "start").value(),
                 std::string("Shot 1: the start is (0, nan, 1), but it must be from -100000 to 100000."));
        QVERIFY(!rangeFault("Shot 1", {{ProjectNumber::ShotTime, 0.0}}));
        QCOMPARE(rangeText(rangeOf(ProjectNumber::StepLength)), std::string("from 0.00001 to 0.1"));
        QCOMPARE(rangeText(rangeOf(ProjectNumber::SmallPieceFraction)), std::string("above 0 and at most 1"));
    }
};

RUBBLE_TEST(RangesTest)
#include "RangesTest.moc"
