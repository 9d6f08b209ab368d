#include "editor/background/MortarWatch.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/BakedAssets.h"
#include "tests/support/play/MortarPortal.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// The portal with its mortar, whose joints are watched.
struct WatchedPortal {
    Document document{test::mortarPortal()};
    Bakes bakes;
    MortarWatch watch{document, bakes};
    Id mortar = document.project().mortars[0].id;

    void pushMortar(double tolerance) {
        Mortar changed = document.project().mortars[0];
        changed.tolerance = tolerance;
        document.push(modify("Change", changed));
    }
};

}  // namespace

class MortarWatchTest : public QObject {
    Q_OBJECT
private slots:
    void jointsAreFoundOnceAllIsBaked() {
        WatchedPortal portal;
        QVERIFY(!portal.watch.isCurrent() && !portal.watch.find(portal.mortar));
        test::bakeAll(portal.document.project(), portal.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(portal.watch.isCurrent(), kPatience);
        const JoinedMortar* joined = portal.watch.find(portal.mortar);
        QVERIFY(joined && joined->isHeld && !joined->joints.empty());
    }
    void editsInvalidateThem() {
        WatchedPortal portal;
        test::bakeAll(portal.document.project(), portal.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(portal.watch.isCurrent(), kPatience);
        Instance beam = portal.document.project().instances[2];
        beam.pose.position.y += 0.01;  // farther than the widest joint
        portal.document.push(modify("Lift", beam));
        QVERIFY(!portal.watch.isCurrent());
        QTRY_VERIFY_WITH_TIMEOUT(portal.watch.isCurrent(), kPatience);
        QVERIFY(portal.watch.find(portal.mortar)->joints.empty());
        portal.pushMortar(0.02);
        QTRY_VERIFY_WITH_TIMEOUT(portal.watch.isCurrent(), kPatience);
        QVERIFY(!portal.watch.find(portal.mortar)->joints.empty());
    }
    void deletedMortarsAreForgotten() {
        WatchedPortal portal;
        test::bakeAll(portal.document.project(), portal.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(portal.watch.isCurrent(), kPatience);
        QSignalSpy changes(&portal.watch, &MortarWatch::changed);
        portal.document.push(removeMortar(portal.mortar));
        QTRY_COMPARE_WITH_TIMEOUT(changes.count(), 1, kPatience);
        QVERIFY(!portal.watch.find(portal.mortar));
    }
};

RUBBLE_TEST_WITH(MortarWatchTest, QCoreApplication)
#include "MortarWatchTest.moc"
