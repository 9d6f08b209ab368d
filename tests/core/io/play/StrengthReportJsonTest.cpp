#include "core/io/play/StrengthReportJson.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

/// An asset that must survive 10 N·s and break at 40 N·s.
StrengthReport report(double threshold) {
    StrengthReport made;
    made.asset.name = "front";
    made.asset.requirements = {{RequirementOutcome::Survives, ImpulseRequirement{10.0}},
                               {RequirementOutcome::Breaks, ImpulseRequirement{40.0}}};
    made.strength = threshold;
    made.interval = {.low = 10.0, .high = 40.0, .lowRequirement = 0, .highRequirement = 1, .impulses = {10.0, 40.0}};
    return made;
}

nlohmann::json reportJson(const StrengthReport& one) {
    return nlohmann::json::parse(strengthReportJson(std::vector{one}))["assets"][0];
}

}  // namespace

class StrengthReportJsonTest : public QObject {
    Q_OBJECT
private slots:
    void boundsAndSuggestionAreWritten() {
        const nlohmann::json front = reportJson(report(20.0));
        QCOMPARE(front["name"].get<std::string>(), "front");
        QCOMPARE(front["threshold"].get<double>(), 20.0);
        QCOMPARE(front["above"].get<double>(), 10.0);
        QCOMPARE(front["atMost"].get<double>(), 40.0);
        QCOMPARE(front["suggested"].get<double>(), 20.0);  // the geometric mean
        QCOMPARE(front["isSatisfied"].get<bool>(), true);
        QVERIFY(front["conflict"].is_null());
        QCOMPARE(front["intents"].size(), std::size_t{2});
        QCOMPARE(front["intents"][1]["impulse"].get<double>(), 40.0);
        QVERIFY(!front["intents"][1]["sentence"].get<std::string>().empty());
        QCOMPARE(reportJson(report(50.0))["isSatisfied"].get<bool>(), false);
    }
    void missingBoundIsNull() {
        StrengthReport one = report(20.0);
        one.asset.requirements.pop_back();
        one.interval = {.low = 10.0, .lowRequirement = 0, .impulses = {10.0}};
        QVERIFY(reportJson(one)["atMost"].is_null());
        QCOMPARE(reportJson(one)["suggested"].get<double>(), 12.5);
    }
    void bondedAssetHasImpulsesPerArea() {
        StrengthReport one = report(20.0);
        one.interval.isPerArea = true;
        const nlohmann::json front = reportJson(one);
        QVERIFY(!front.contains("threshold") && front["impulsePerArea"].get<double>() == 20.0);
        QCOMPARE(front["intents"][0]["impulsePerArea"].get<double>(), 10.0);
        QCOMPARE(front["isSatisfied"].get<bool>(), true);
        std::swap(one.asset.requirements[0].outcome, one.asset.requirements[1].outcome);
        one.interval = {.low = 40.0,
                        .high = 10.0,
                        .lowRequirement = 1,
                        .highRequirement = 0,
                        .impulses = {10.0, 40.0},
                        .isPerArea = true};
        QVERIFY(reportJson(one)["conflict"].get<std::string>().find("an impulse per area above 40 N·s/m²") !=
                std::string::npos);
    }
    void conflictIsASentence() {
        StrengthReport one = report(20.0);
        std::swap(one.asset.requirements[0].outcome, one.asset.requirements[1].outcome);
        one.interval = {.low = 40.0, .high = 10.0, .lowRequirement = 1, .highRequirement = 0, .impulses = {10.0, 40.0}};
        QVERIFY(reportJson(one)["conflict"].is_string());
        QVERIFY(reportJson(one)["suggested"].is_null());
    }
};

RUBBLE_TEST(StrengthReportJsonTest)
#include "StrengthReportJsonTest.moc"
