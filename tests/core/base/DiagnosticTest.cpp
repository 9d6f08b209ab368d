#include "core/base/Diagnostic.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>
#include <string>

using namespace rubble;

class DiagnosticTest : public QObject {
    Q_OBJECT
private slots:
    void codesHaveNamesOfTheirOwn() {
        std::set<std::string> names;
        for (int code = 0; code < kDiagnosticCodes; ++code) names.insert(nameOf(DiagnosticCode(code)));
        QCOMPARE(names.size(), std::size_t{kDiagnosticCodes});
        QCOMPARE(nameOf(DiagnosticCode::FaultyOutline), "FaultyOutline");
        QCOMPARE(nameOf(DiagnosticCode::Sliver), "Sliver");
        QCOMPARE(nameOf(DiagnosticCode::RepeatedPoint), "RepeatedPoint");
    }
    void onlyAFaultyOutlineIsAnError() {
        int errors = 0;
        for (int code = 0; code < kDiagnosticCodes; ++code)
            errors += defaultSeverity(DiagnosticCode(code)) == Severity::Error ? 1 : 0;
        QCOMPARE(errors, 1);
        QVERIFY(defaultSeverity(DiagnosticCode::FaultyOutline) == Severity::Error);
        QVERIFY(defaultSeverity(DiagnosticCode::MergedPiece) == Severity::Note);
        QVERIFY(defaultSeverity(DiagnosticCode::LostPiece) == Severity::Warning);
    }
    void diagnosticHasTheSeverityOfItsCode() {
        const Diagnostic gap = diagnostic(DiagnosticCode::Gap, {.asset = 3}, "A gap.", 0.5, 0.1);
        QVERIFY(gap.severity == Severity::Note);
        QCOMPARE(gap.place.asset, 3u);
        QCOMPARE(gap.message, "A gap.");
        QCOMPARE(gap.value, 0.5);
        QCOMPARE(gap.limit, 0.1);
    }
};

RUBBLE_TEST(DiagnosticTest)
#include "DiagnosticTest.moc"
