// Tests core/asset/project/FragmentLevels.cpp and core/asset/strength/FragmentThresholds.cpp.
#include "core/asset/project/FragmentLevels.h"
#include "core/asset/strength/FragmentThresholds.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// Two levels; one fragment has a level of its own, and one is not fractured.
Asset asset() {
    Asset made;
    made.levels = {{.minimumVolume = 0.1, .threshold = 7.0}, {.minimumVolume = 0.2}};
    made.fragmentLevels = {{"1.2", Level{.minimumVolume = 0.3, .threshold = 9.0}}, {"1.4", std::nullopt}};
    made.fragmentThresholds = {{"1.1", 5.0}, {"1.4", 6.0}};
    return made;
}

}  // namespace

class FragmentLevelsTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentFollowsItsLevel() {
        const Asset made = asset();
        QCOMPARE(levelFor(made, "1.3", 0), &made.levels[0]);
        QCOMPARE(levelFor(made, "1.3/2.5", 1), &made.levels[1]);
        QVERIFY(!levelFor(made, "1.3/2.5/3.1", 2));
    }
    void ownSettingPrecedesThatOfTheLevel() {
        const Asset made = asset();
        QCOMPARE(levelFor(made, "1.2", 0)->minimumVolume, 0.3);
        QVERIFY(!levelFor(made, "1.4", 0));
    }
    void thresholdIsItsOwnOrThatOfItsLevel() {
        const Asset made = asset();
        QVERIFY(fragmentThreshold(made, "1.1", 0) == 5.0);
        QVERIFY(fragmentThreshold(made, "1.2", 0) == 9.0);
        QVERIFY(fragmentThreshold(made, "1.3", 0) == 7.0);
        QVERIFY(!fragmentThreshold(made, "1.3/2.5", 1));  // follows from its volume
        QVERIFY(!fragmentThreshold(made, "1.4", 0));      // is not fractured
        QVERIFY(ownThreshold(made, "1.4") == 6.0);
        QVERIFY(!ownThreshold(made, "1.3"));
    }
    void scaleIsThatOfAreas() {
        QCOMPARE(thresholdScaleOf(1.0), 1.0);
        QCOMPARE(thresholdScaleOf(0.125), 0.25);
        QVERIFY(std::abs(thresholdScaleOf(0.5) - std::pow(0.5, 2.0 / 3.0)) < 1e-15);
    }
};

RUBBLE_TEST(FragmentLevelsTest)
#include "FragmentLevelsTest.moc"
