#include "editor/widgets/numbers/RoundStep.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class RoundStepTest : public QObject {
    Q_OBJECT
private slots:
    void roundStepsAreOneTwoOrFive() {
        for (const auto& [minimum, step] : {std::pair(0.03, 0.05), {0.1, 0.1}, {1.1, 2.0}, {2.0, 2.0}, {6.0, 10.0}}) {
            QVERIFY(std::abs(roundStep(minimum) - step) < 1e-12);
        }
    }
};

RUBBLE_TEST(RoundStepTest)
#include "RoundStepTest.moc"
