#include "core/asset/project/Threshold.h"

#include "core/asset/checks/VerifyProject.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

Material strongMaterial() { return {.id = 1, .name = "plaster", .tensileStrength = 2e6}; }

/// 3 x 2 m and 0.1 m thick: the smallest section is 2 m by 0.1 m.
Asset wall() {
    Asset asset{.id = 2, .name = "wall", .material = 1};
    asset.prism = {{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}}, {}}, 0.1};
    asset.threshold = 55.0;
    return asset;
}

Asset derivedWall() {
    Asset asset = wall();
    asset.contactTime = 0.001;
    return asset;
}

}  // namespace

class ThresholdTest : public QObject {
    Q_OBJECT
private slots:
    void typedThresholdIsUsedWithoutContactTime() {
        QCOMPARE(thresholdOf(wall(), strongMaterial()), 55.0);
        QVERIFY(!derivedThreshold(wall(), strongMaterial()));
    }
    void thresholdIsStrengthTimesSectionTimesTime() {
        // 2 MPa on 0.2 m^2 are 400 kN; for 1 ms they are 400 N·s.
        QCOMPARE(thresholdOf(derivedWall(), strongMaterial()), 400.0);
        Asset longer = derivedWall();
        longer.contactTime = 0.0025;
        QCOMPARE(thresholdOf(longer, strongMaterial()), 1000.0);
        Asset thicker = derivedWall();
        thicker.prism.depth = 0.2;
        QCOMPARE(thresholdOf(thicker, strongMaterial()), 800.0);
    }
    void columnHasItsSmallestSectionAcross() {
        Asset column = derivedWall();
        column.prism = {unitSquare(), 4.0};  // along z
        QCOMPARE(minimumCrossSection(column.prism), 1.0);
    }
    void transitionCrackLengthIsSquaredRatioByPi() {
        Material glass{.tensileStrength = 45e6, .fractureToughness = 0.75e6};
        QVERIFY(std::abs(*transitionCrackLength(glass) - 88.4e-6) < 0.1e-6);  // m: (1/60)^2 / 3.1416 by hand
        // A crack at which the stress K / sqrt(pi a) is the strength.
        const double stress = *glass.fractureToughness / std::sqrt(std::numbers::pi * *transitionCrackLength(glass));
        QVERIFY(std::abs(stress / *glass.tensileStrength - 1.0) < 1e-12);
        glass.fractureToughness.reset();
        QVERIFY(!transitionCrackLength(glass));
        QVERIFY(!transitionCrackLength({.fractureToughness = 1e6}));
    }
    void thresholdIsIndependentOfThePattern() {
        Asset other = derivedWall();
        other.pattern.layers = {{.id = 3, .parameters = UniformScatter{.count = 500}}};
        QCOMPARE(thresholdOf(other, strongMaterial()), 400.0);
    }
    void withoutStrengthTheEnteredThresholdIsUsed() {
        Material unknown = strongMaterial();
        unknown.tensileStrength.reset();
        QCOMPARE(thresholdOf(derivedWall(), unknown), 55.0);
        QVERIFY(lacksStrength(derivedWall(), unknown));
        QVERIFY(!lacksStrength(wall(), unknown) && !lacksStrength(derivedWall(), strongMaterial()));
    }
    void derivedThresholdOutOfRangeIsAFault() {
        Project project = fullProject();
        project.materials[0].tensileStrength = 1.0;
        project.assets[0].contactTime = 1e-9;
        const std::string fault = verifyProject(project).value_or("");
        QVERIFY2(fault.starts_with("Asset 3 \"wall\": the derived threshold is ") &&
                     fault.ends_with("e-10, but it must be from 1e-09 to 1e+24."),
                 fault.c_str());
    }
};

RUBBLE_TEST(ThresholdTest)
#include "ThresholdTest.moc"
