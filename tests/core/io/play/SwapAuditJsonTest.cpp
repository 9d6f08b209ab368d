#include "core/io/play/SwapAuditJson.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

class SwapAuditJsonTest : public QObject {
    Q_OBJECT
private slots:
    void measurementsAreWritten() {
        SwapAudit audit;
        audit.fragments = 12;
        audit.contacts = 20;
        audit.contactPoints = 80;
        audit.deepestOverlap = 0.25;
        audit.resting = {.fragment = "front/5.17", .speed = 0.5};
        audit.lying.fragment = "front/5.18";
        audit.exported = {.fragment = "front/5.19", .place = {}, .gap = 0.0625};
        audit.massDrift = 0.125;
        audit.energyGain = -0.5;
        audit.diagnostics = {diagnostic(DiagnosticCode::GapVolume, {}, "A gap."),
                             diagnostic(DiagnosticCode::PushedPiece, {}, "A push.")};
        const auto json = nlohmann::json::parse(swapAuditJson(std::vector<NamedAudit>{{"front", audit}}));
        const nlohmann::json& front = json["assets"][0];
        QCOMPARE(front["name"].get<std::string>(), "front");
        QCOMPARE(front["pieces"].get<int>(), 12);
        QCOMPARE(front["contacts"].get<int>(), 20);
        QCOMPARE(front["contactPoints"].get<int>(), 80);
        QCOMPARE(front["deepestOverlap"].get<double>(), 0.25);
        QVERIFY(front["resting"] == (nlohmann::json{{"piece", "front/5.17"}, {"speed", 0.5}}));
        QCOMPARE(front["lying"]["piece"].get<std::string>(), "front/5.18");
        QVERIFY(front["exported"] == (nlohmann::json{{"piece", "front/5.19"}, {"gap", 0.0625}}));
        QCOMPARE(front["massDrift"].get<double>(), 0.125);
        QCOMPARE(front["energyGain"].get<double>(), -0.5);
        QVERIFY(front["notices"] == nlohmann::json{"A gap."});
        QVERIFY(front["faults"] == nlohmann::json{"A push."});
        QCOMPARE(front["isClean"].get<bool>(), audit.isClean());
    }
    void assetThatDoesNotBreakHasNoMeasurements() {
        const auto json = nlohmann::json::parse(swapAuditJson(std::vector<NamedAudit>{{"post", std::nullopt}}));
        QVERIFY(json["assets"][0] == (nlohmann::json{{"name", "post"}, {"pieces", 0}}));
    }
};

RUBBLE_TEST(SwapAuditJsonTest)
#include "SwapAuditJsonTest.moc"
