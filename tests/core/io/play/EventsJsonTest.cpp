#include "core/io/play/EventsJson.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"

#include <QTest>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace rubble;

namespace {

EventReport fullReport() {
    EventReport report;
    report.records = {{.step = 12,
                       .kind = EventKind::Impact,
                       .body = 3,
                       .other = 0,
                       .instance = 7,
                       .fragment = "5.17.1/9.2",
                       .point = {1.0, 2.0, 3.0},
                       .normal = {0.0, 1.0, 0.0},
                       .impulse = 40.0,
                       .speed = 4.0,
                       .energy = 80.5,
                       .materials = {1, 0},
                       .box = {{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}},
                      {.step = 12,
                       .kind = EventKind::Broken,
                       .body = 4,
                       .energy = 2.0,
                       .area = 0.5,
                       .mass = 100.0,
                       .count = 12,
                       .materials = {1, 2},
                       .box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}},
                      {.step = 12,
                       .kind = EventKind::Removed,
                       .body = 5,
                       .mass = 1.0,
                       .box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}},
                       .reason = RemovalReason::LeftWorld}};
    report.omitted[0] = {41, 12.5};
    report.restEnergy = 3.25;
    return report;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

class EventsJsonTest : public QObject {
    Q_OBJECT
private slots:
    void linesHaveAllMembers() {
        const std::vector<std::string> lines = linesOf(eventLines(12, fullReport()));
        QCOMPARE(lines.size(), std::size_t{4});
        QCOMPARE(lines[0],
                 std::string(R"({"step":12,"kind":"impact","body":3,"other":0,"instance":7,"fragment":"5.17.1/9.2",)"
                             R"("point":[1,2,3],"normal":[0,1,0],"impulse":40,"speed":4,"energy":80.5,)"
                             R"("materials":[1,0],"box":[[1,2,3],[1,2,3]]})"));
        QVERIFY(lines[1].find(R"("area":0.5,"mass":100,"count":12)") != std::string::npos);
        QVERIFY(lines[1].find("other") == std::string::npos && lines[1].find("reason") == std::string::npos);
        QVERIFY(lines[2].find(R"("reason":"leftWorld")") != std::string::npos);
        QVERIFY(lines[2].find("energy") == std::string::npos);
        QCOMPARE(lines[3], std::string(R"({"step":12,"kind":"sums","omitted":{"impact":{"count":41,"energy":12.5}},)"
                                       R"("restEnergy":3.25})"));
    }
    void linesFitTheSchema() {
        const test::Schema schema("event.schema.json");
        for (const std::string& line : linesOf(eventLines(12, fullReport()))) {
            nlohmann::json json = nlohmann::json::parse(line);
            QCOMPARE(schema.fault(json), std::string());
            json["another"] = 1;
            QVERIFY(!schema.fault(json).empty());
        }
    }
    void nothingIsNoLine() { QVERIFY(eventLines(1, {}).empty()); }
};

RUBBLE_TEST(EventsJsonTest)
#include "EventsJsonTest.moc"
