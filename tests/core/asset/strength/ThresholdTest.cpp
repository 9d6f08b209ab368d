#include "core/asset/strength/Threshold.h"

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
    asset.shape = Prism{{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}}, {}}, 0.1};
    asset.threshold = 55.0;
    return asset;
}

Asset derivedWall() {
    Asset asset = wall();
    deriveThreshold(asset);
    return asset;
}

bool isNear(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

/// The ratio of strength times squared thickness to force of a plate whose radius is `ratio` times its thickness.
double bendingRatioOf(double ratio) {
    const double poisson = 0.25;
    return (1.0 + poisson) * (0.485 * std::log(ratio) + 0.52) + 0.48;  // Timoshenko, Woinowsky-Krieger, (97)
}

}  // namespace

class ThresholdTest : public QObject {
    Q_OBJECT
private slots:
    void typedThresholdIsUsedWithoutContactTime() {
        QCOMPARE(thresholdOf(wall(), strongMaterial()), 55.0);
        QVERIFY(!derivedThreshold(wall(), strongMaterial()));
    }
    void bendingRatioFollowsFromTheTheoryOfPlates() {
        QVERIFY(std::abs(bendingRatioOf(kBendingRadius) - kBendingRatio) < 0.02);
        QVERIFY(bendingRatioOf(kBendingRadius / 2.0) > 1.85 && bendingRatioOf(2.0 * kBendingRadius) < 2.75);
    }
    void platesBreakInBendingWhileTheContactLasts() {
        // 2 MPa times 0.01 m² / 2.3 are 8.7 kN; half a sine wave of 1 ms with that peak is an impulse of 5.5 N·s.
        const double expected = 2e6 * 0.01 / 2.3 * 2.0 / std::numbers::pi * 1e-3;
        QVERIFY(isNear(thresholdOf(derivedWall(), strongMaterial()), expected));
        Asset longer = derivedWall();
        longer.contactTime = 0.0025;
        QVERIFY(isNear(thresholdOf(longer, strongMaterial()), 2.5 * expected));
        Asset thicker = derivedWall();
        thicker.prism().depth = 0.2;
        QVERIFY(isNear(thresholdOf(thicker, strongMaterial()), 4.0 * expected));
    }
    void heavyWallsBreakByTheImpulseThatTheirInertiaTakes() {
        Material stiff = strongMaterial();
        stiff.density = 2000.0;
        stiff.youngsModulus = 2e9;  // sound goes at 1 km/s: through 0.1 m in 0.1 ms
        const BendingStrength thin = *bendingStrength(derivedWall(), stiff);
        QVERIFY(thin.isByInertia);
        QVERIFY2(std::abs(thin.duration / 0.1e-3 - 33.8) < 0.1, QByteArray::number(thin.duration));
        Asset thick = derivedWall();
        thick.prism().depth = 0.2;  // four times the force for twice as long: it goes with the mass of a part
        QVERIFY(isNear(thresholdOf(thick, stiff), 8.0 * thin.threshold()));
        // As an effective mass that reaches the velocity strength / sqrt(E rho): 14.7 rho t^3.
        const double speed = 2e6 / std::sqrt(2e9 * 2000.0);
        QVERIFY(std::abs(thin.threshold() / speed / (2000.0 * 1e-3) - 14.7) < 0.05);
        Asset pane = derivedWall();
        pane.prism().depth = 0.008;
        QVERIFY(!bendingStrength(pane, stiff)->isByInertia);
    }
    void thicknessIsTheLeastExtentThroughTheCentre() {
        QCOMPARE(thicknessOf(wall().prism()), 0.1);
        QCOMPARE(thicknessOf({unitSquare(), 4.0}), 1.0);
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
        QCOMPARE(thresholdOf(other, strongMaterial()), thresholdOf(derivedWall(), strongMaterial()));
    }
    void enteredThresholdsReplaceDerivedOnes() {
        Asset entered = derivedWall();
        enterThreshold(entered, 12.0);
        QCOMPARE(thresholdOf(entered, strongMaterial()), 12.0);
        Asset expected = wall();
        expected.threshold = 12.0;
        QVERIFY(entered == expected);
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
                     fault.ends_with("e-11, but it must be from 1e-09 to 1e+24."),
                 fault.c_str());
    }
};

RUBBLE_TEST(ThresholdTest)
#include "ThresholdTest.moc"
