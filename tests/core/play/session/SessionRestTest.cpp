// Tests core/play/session/Session.cpp and core/play/session/SessionInputs.cpp: when nothing changes any more, and how
// much may start in one place.
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

class SessionRestTest : public QObject {
    Q_OBJECT
private slots:
    /// Five thousand in one place would need 40 GB for their contacts.
    void throwsIntoOnePlaceAreLimited() {
        Session session = test::sessionOf(test::floatingBlock());
        for (int k = 0; k < 300; ++k) {
            Throw thrown = test::throwAtBlock(3.0, 10.0);
            thrown.from.z += 1e-4 * k;
            test::addInput(session, ShotInput{"throw", thrown});
        }
        session.step();
        QCOMPARE(test::countOf(session, PlayRole::Projectile), 64u);
        const std::vector<Diagnostic>& reported = session.events().diagnostics;
        QCOMPARE(reported.size(), std::size_t{236});
        QVERIFY2(reported[0].message.find("64 bodies are in its place already") != std::string::npos,
                 reported[0].message.c_str());
    }
    void sessionIsAtRestUntilTheNextInput() {
        Project project = test::floatingBlock();
        project.gravity = {0.0, -9.81, 0.0};
        Session session = test::sessionOf(project);
        const auto stepUntilRest = [&session] {
            for (int steps = 0; !session.isAtRest() && steps < 100'000; ++steps) session.step();
            return session.isAtRest();
        };
        QVERIFY(!session.isAtRest());
        QVERIFY(stepUntilRest());
        test::addInput(session, ShotInput{"throw", test::throwAtBlock(3.0, 80.0)});
        QVERIFY(!session.isAtRest());  // the input waits
        session.step();
        QVERIFY(!session.isAtRest());
        QVERIFY(stepUntilRest());
        const ContentHash hash = session.world().hash();
        for (int k = 0; k < 120; ++k) {
            session.step();
            QVERIFY(session.isAtRest());
        }
        QVERIFY(session.world().hash() == hash);
    }
    void debrisThatWillFadeIsNotAtRest() {
        Project project = test::floatingBlock();
        project.gravity = {0.0, -9.81, 0.0};
        project.debris.lifetime = 60.0;
        Session session = test::sessionOf(project);
        test::addInput(session, ShotInput{"throw", test::throwAtBlock(3.0, 80.0)});
        for (int k = 0; k < 3599; ++k) {
            session.step();
            QVERIFY(!session.isAtRest());
        }
        for (int k = 0; !session.isAtRest() && k < 100'000; ++k) session.step();
        QVERIFY(session.isAtRest());
        QCOMPARE(test::countOf(session, PlayRole::Debris), 0u);
    }
};

RUBBLE_TEST(SessionRestTest)
#include "SessionRestTest.moc"
