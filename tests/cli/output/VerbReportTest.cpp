#include "app/cli/output/VerbReport.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/Schemas.h"

#include <QDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

using namespace rubble;

namespace {

const QString kRecordedCases = RUBBLE_SOURCE_DIR "/tests/cli/cases";

nlohmann::json documentOf(const VerbReport& report, const Status& status, const std::string& verb = "new") {
    return nlohmann::json::parse(reportJson(report, verb, status));
}

std::string textOf(const nlohmann::json& text) { return text.get<std::string>(); }

std::string faultOf(const nlohmann::json& document) {
    static const test::Schema schema("result.schema.json");
    return schema.fault(document);
}

}  // namespace

class VerbReportTest : public QObject {
    Q_OBJECT
private slots:
    void statusFollowsFromErrorAndConclusion() {
        VerbReport report;
        QCOMPARE(textOf(documentOf(report, success())["status"]), "ok");
        conclude(report, "1 of 2 tests failed.");
        QCOMPARE(textOf(documentOf(report, success())["status"]), "findings");
        QCOMPARE(textOf(documentOf(report, Error{ErrorCode::Io, "Disk full."})["status"]), "error");
        QCOMPARE(textOf(documentOf(report, Error{ErrorCode::Cancelled, "Cancelled."})["status"]), "cancelled");
    }
    void conclusionHasALineForEach() {
        VerbReport report;
        conclude(report, "a differs.");
        conclude(report, "b differs.");
        QCOMPARE(report.conclusion, "a differs.\nb differs.");
    }
    void errorIsAFindingOnce() {
        VerbReport report;
        const Error error{ErrorCode::NotFound, "There is no file."};
        nlohmann::json document = documentOf(report, error);
        QCOMPARE(document["findings"].size(), 1U);
        QCOMPARE(textOf(document["findings"][0]["code"]), "NotFound");
        QCOMPARE(textOf(document["findings"][0]["severity"]), "error");
        QCOMPARE(textOf(document["findings"][0]["message"]), error.message);
        report.findings.push_back(findingOf(error, {.file = "wall.rubble"}));
        report.hasErrorInFindings = true;
        document = documentOf(report, error);
        QCOMPARE(document["findings"].size(), 1U);
        QCOMPARE(document["findings"][0]["place"].dump(), R"({"file":"wall.rubble"})");
    }
    void placesOfDiagnosticsAreWritten() {
        VerbReport report;
        const DiagnosticPlace place{.level = 1, .path = "3.2", .layer = 3, .index = 2, .point = {{0.5, -0.25}}};
        report.findings.push_back(findingOf(diagnostic(DiagnosticCode::Sliver, place, "Thin."), "w.rubble", "wall"));
        const nlohmann::json document = documentOf(report, success());
        QCOMPARE(faultOf(document), "");
        const std::string expected =
            R"({"asset":"wall","file":"w.rubble","fragment":"3.2","index":2,"layer":3,"level":1,"point":[0.5,-0.25]})";
        QCOMPARE(document["findings"][0]["place"].dump(), expected);
    }
    void bytesThatAreNoTextStayJson() {
        VerbReport report;
        report.findings.push_back({Severity::Error, "Io", {.file = "\xff\x1b.rubble"}, "Cannot read \"\xff\"."});
        QCOMPARE(faultOf(documentOf(report, success())), "");
    }
    void errorOfEachCodeFitsTheSchema() {
        for (const ErrorCode code :
             {ErrorCode::BadInput, ErrorCode::Degenerate, ErrorCode::Crossing, ErrorCode::Unsupported,
              ErrorCode::NotFound, ErrorCode::Io, ErrorCode::Limit, ErrorCode::Cancelled, ErrorCode::Edited}) {
            QCOMPARE(faultOf(documentOf({}, Error{code, "A sentence."})), "");
        }
    }
    void summaryGivesWayToTheDocument() {
        std::ostringstream out, err;
        const CliContext context{.in = -1, .out = out, .err = err};
        QVERIFY(printSummary("wall: ok\n", {.isJson = true}, context));
        QCOMPARE(out.str(), "");
        QVERIFY(printSummary("wall: ok\n", {}, context));
        QCOMPARE(out.str(), "wall: ok\n");
    }
    /// Every document of the recorded cases; each verb that prints one has a case for success and one for failure.
    void recordedDocumentsFitTheSchema() {
        std::set<std::string> seen;
        for (const QString& name : QDir(kRecordedCases).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QByteArray out = bytesOfFile(kRecordedCases + '/' + name + "/stdout");
            if (!out.contains("\"rubble-result\"")) continue;
            const nlohmann::json document = nlohmann::json::parse(out.toStdString());
            QVERIFY2(faultOf(document).empty(), qPrintable(name + ": " + QString::fromStdString(faultOf(document))));
            const bool isGood = bytesOfFile(kRecordedCases + '/' + name + "/exit").trimmed() == "0";
            seen.insert(document["verb"].get<std::string>() + (isGood ? " succeeds" : " fails"));
        }
        for (const std::string verb : {"check", "export", "import", "new", "seeds", "test"}) {
            QVERIFY2(seen.contains(verb + " succeeds") && seen.contains(verb + " fails"), verb.c_str());
        }
    }
};

RUBBLE_TEST(VerbReportTest)
#include "VerbReportTest.moc"
