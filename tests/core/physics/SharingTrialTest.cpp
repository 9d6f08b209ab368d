#include "core/physics/SharingTrial.h"

#include <QTest>

using namespace rubble;

namespace {

/// How many of so many steps are shared out, where they take these times.
int sharedOf(SharingTrial& trial, int steps, double alone, double shared) {
    int count = 0;
    for (int step = 0; step < steps; ++step) {
        const bool isShared = trial.isShared();
        count += isShared ? 1 : 0;
        trial.note(isShared ? shared : alone);
    }
    return count;
}

}  // namespace

/// Steps are shared out where that is quicker, as far as can be told, and told again.
class SharingTrialTest : public QObject {
    Q_OBJECT
private slots:
    void stepsThatAreQuickerTogetherAreShared() {
        SharingTrial trial;
        QVERIFY(sharedOf(trial, 2560, 1.0, 0.6) >= 2560 - 100);
    }
    void stepsThatAreSlowerTogetherAreNot() {
        SharingTrial trial;
        QVERIFY(sharedOf(trial, 2560, 1.0, 1.5) <= 16 + 50);
    }
    void aMachineThatChangesIsNoticed() {
        SharingTrial trial;
        sharedOf(trial, 2560, 1.0, 1.5);
        sharedOf(trial, 256, 1.0, 0.6);
        QVERIFY(sharedOf(trial, 256, 1.0, 0.6) >= 240);
    }
    void bodiesThatGatherSpeedDoNotDecide() {
        // Every step takes longer than the one before, shared or not, and shared two tenths longer.
        SharingTrial trial;
        double alone = 1.0;
        int shared = 0;
        for (int step = 0; step < 256; ++step, alone *= 1.05) {
            shared += trial.isShared() ? 1 : 0;
            trial.note(trial.isShared() ? 1.2 * alone : alone);
        }
        QVERIFY(shared <= 16 + 4 * 3);
    }
};

QTEST_APPLESS_MAIN(SharingTrialTest)
#include "SharingTrialTest.moc"
