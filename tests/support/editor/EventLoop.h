#pragma once

#include "tests/support/Patience.h"

#include <QCoreApplication>
#include <QTest>
#include <QTimer>

namespace rubble::test {

/// Runs the event loop until a timer of so many milliseconds that starts now has fired. All timers that were due before
/// it have fired then, in order, however slow the machine is: for tests of what must not happen after a delay.
inline void runTimersDueWithin(int milliseconds) {
    bool hasFired = false;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, QCoreApplication::instance(), [&hasFired] { hasFired = true; });
    QVERIFY(QTest::qWaitFor([&hasFired] { return hasFired; }, milliseconds + kPatience));
}

}  // namespace rubble::test
