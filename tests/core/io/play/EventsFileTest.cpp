#include "core/io/play/EventsFile.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"

#include <QTest>
#include <nlohmann/json.hpp>

#include <map>
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

std::string textOf(const EventReport& report, EventsFormat format) {
    EventsText text(format);
    text.add(12, report);
    return std::move(text).finished();
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

class EventsFileTest : public QObject {
    Q_OBJECT
private slots:
    void linesHaveAllMembers() {
        const std::vector<std::string> lines = linesOf(textOf(fullReport(), EventsFormat::JsonLines));
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
        for (const std::string& line : linesOf(textOf(fullReport(), EventsFormat::JsonLines))) {
            nlohmann::json json = nlohmann::json::parse(line);
            QCOMPARE(schema.fault(json), std::string());
            json["another"] = 1;
            QVERIFY(!schema.fault(json).empty());
        }
    }
    void nothingIsNoLine() {
        QVERIFY(textOf({}, EventsFormat::JsonLines).empty());
        QCOMPARE(linesOf(textOf({}, EventsFormat::Csv)).size(), std::size_t{1});  // the header
    }
    void rowsHaveTheValuesOfLines() {
        const std::vector<std::string> lines = linesOf(textOf(fullReport(), EventsFormat::JsonLines));
        const std::vector<std::string> rows = linesOf(textOf(fullReport(), EventsFormat::Csv));
        QCOMPARE(rows.size(), lines.size() + 1);
        QCOMPARE(rows[1], std::string("12,impact,3,0,7,5.17.1/9.2,1,2,3,0,1,0,40,4,80.5,,,,1,0,1,2,3,1,2,3,,"
                                      ",,,,,,,,,,,,"));
        QCOMPARE(rows[4], std::string("12,sums,,,,,,,,,,,,,,,,,,,,,,,,,,41,12.5,,,,,,,,,,,3.25"));
        const std::vector<std::string> names = fieldsOf(rows[0]);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            std::map<std::string, std::string> values;
            collect(nlohmann::json::parse(lines[k]), {}, values);
            const std::vector<std::string> fields = fieldsOf(rows[k + 1]);
            QCOMPARE(fields.size(), names.size());
            for (std::size_t column = 0; column < names.size(); ++column) {
                if (!fields[column].empty()) QCOMPARE(fields[column], values[names[column]]);
                values.erase(names[column]);
            }
            std::erase_if(values, [](const auto& value) { return value.second.empty(); });
            QVERIFY(values.empty());  // each has a column
        }
    }
    void formatsAreThoseOfNames() {
        QCOMPARE(eventsFormatOf("a/house.csv"), EventsFormat::Csv);
        QCOMPARE(eventsFormatOf("HOUSE.CSV"), EventsFormat::Csv);
        QCOMPARE(eventsFormatOf("house.jsonl"), EventsFormat::Stream);
        QCOMPARE(eventsFormatOf("csv"), EventsFormat::Stream);
    }

private:
    static std::vector<std::string> fieldsOf(const std::string& row) {
        std::vector<std::string> fields;
        std::istringstream stream(row + ',');
        for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
        return fields;
    }
    /// The numbers and texts of a JSON value by their places.
    static void collect(const nlohmann::json& json, const std::string& place,
                        std::map<std::string, std::string>& values) {
        if (json.is_object()) {
            for (const auto& [key, member] : json.items()) {
                collect(member, place.empty() ? key : place + '.' + key, values);
            }
        } else if (json.is_array()) {
            for (std::size_t k = 0; k < json.size(); ++k)
                collect(json[k], place + '[' + std::to_string(k) + ']', values);
        } else {
            values[place] = json.is_string() ? json.get<std::string>() : json.dump();
        }
    }
};

RUBBLE_TEST(EventsFileTest)
#include "EventsFileTest.moc"
