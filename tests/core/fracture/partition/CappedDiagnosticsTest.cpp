#include "core/fracture/partition/CappedDiagnostics.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

Diagnostic numbered(DiagnosticCode code, int number) { return diagnostic(code, {}, std::to_string(number)); }

}  // namespace

class CappedDiagnosticsTest : public QObject {
    Q_OBJECT
private slots:
    void theFirstAreKeptAndTheOthersCounted() {
        CappedDiagnostics found(2);
        for (int number = 1; number <= 5; ++number) found.add(numbered(DiagnosticCode::Sliver, number));
        found.add(numbered(DiagnosticCode::TinyPiece, 6));
        found.addUnmade(DiagnosticCode::Sliver, 10);
        const std::vector<Diagnostic> list = std::move(found).list({.asset = 7});
        QCOMPARE(list.size(), std::size_t{4});
        QCOMPARE(list[0].message, std::string("1"));
        QCOMPARE(list[1].message, std::string("2"));
        QCOMPARE(list[2].message, std::string("6"));
        QCOMPARE(list[3].message, std::string("13 more messages of this kind (Sliver) left out."));
        QCOMPARE(list[3].place.asset, 7u);
        QCOMPARE(list[3].value, 13.0);
    }
    void whatIsTooMuchIsNotMade() {
        CappedDiagnostics found(1);
        int made = 0;
        for (int number = 0; number < 3; ++number) {
            found.add(DiagnosticCode::Sliver, [&] { return numbered(DiagnosticCode::Sliver, ++made); });
        }
        QCOMPARE(made, 1);
        QVERIFY(!found.hasRoom(DiagnosticCode::Sliver) && found.hasRoom(DiagnosticCode::TinyPiece));
    }
};

RUBBLE_TEST(CappedDiagnosticsTest)
#include "CappedDiagnosticsTest.moc"
