// Tests the events in docs/formats/rubble_pack.hpp, and cue_sheet_example.cpp.
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/TestProgram.h"
#include "tests/support/files/WrongValues.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <sstream>

using namespace rubble;
using EventJson = nlohmann::json;

namespace {

constexpr const char* kHouseEvents = RUBBLE_SOURCE_DIR "/tests/cli/cases/simulate-events-version-1/after/house.jsonl";
constexpr const char* kHouseStream = RUBBLE_SOURCE_DIR "/tests/cli/cases/simulate-events/after/house.jsonl";
constexpr const char* kEventKindNames[] = {"impact", "bonds", "detached", "broken", "settled", "removed"};
constexpr const char* kEventReasons[] = {"", "lifetime", "budget", "leftWorld"};

std::string houseEvents() {
    std::ostringstream text;
    text << std::ifstream(kHouseEvents, std::ios::binary).rdbuf();
    return text.str();
}

EventJson vectorJson(const rubble_pack::Vec3& vector) { return {vector.x, vector.y, vector.z}; }

/// A record as the file has it: with the keys of `like`.
EventJson eventJson(const rubble_pack::Event& event, const EventJson& like) {
    EventJson made{{"step", event.step},
                   {"kind", kEventKindNames[static_cast<std::size_t>(event.kind)]},
                   {"body", event.body},
                   {"other", event.other},
                   {"instance", event.instance},
                   {"fragment", event.fragment},
                   {"point", vectorJson(event.point)},
                   {"normal", vectorJson(event.normal)},
                   {"impulse", event.impulse},
                   {"speed", event.speed},
                   {"energy", event.energy},
                   {"area", event.area},
                   {"mass", event.mass},
                   {"count", event.count},
                   {"materials", event.materials},
                   {"box", {vectorJson(event.box.min), vectorJson(event.box.max)}},
                   {"reason", kEventReasons[static_cast<std::size_t>(event.reason)]}};
    for (auto member = made.begin(); member != made.end();) {
        member = like.contains(member.key()) ? std::next(member) : made.erase(member);
    }
    return made;
}

EventJson sumsJson(const rubble_pack::EventSums& sums) {
    EventJson omitted = EventJson::object();
    for (std::size_t kind = 0; kind < std::size(kEventKindNames); ++kind) {
        const rubble_pack::OmittedEvents& of = sums.omitted[kind];
        if (of.count > 0) omitted[kEventKindNames[kind]] = {{"count", of.count}, {"energy", of.energy}};
    }
    return {{"step", sums.step}, {"kind", "sums"}, {"omitted", omitted}, {"restEnergy", sums.restEnergy}};
}

std::string eventsFault(std::string_view lines) {
    rubble_pack::EventLog log;
    std::string fault;
    return rubble_pack::parseEvents(lines, log, fault) ? "" : fault;
}

const EventJson kBreakEvent{
    {"step", 3},      {"kind", "broken"}, {"body", 1},           {"other", 2},
    {"instance", 4},  {"fragment", ""},   {"point", {0, 1, 2}},  {"normal", {0, 1, 0}},
    {"impulse", 5.5}, {"speed", 2},       {"energy", 7},         {"area", 0.5},
    {"mass", 10},     {"count", 3},       {"materials", {1, 2}}, {"box", {{0, 0, 0}, {1, 1, 1}}}};

}  // namespace

class EventsHeaderTest : public QObject {
    Q_OBJECT

    /// Runs the example program.
    QProcess* example(const QStringList& arguments) {
        auto* program = new QProcess(this);
        program->start(RUBBLE_CUE_SHEET_EXAMPLE, arguments);
        program->waitForFinished(kPatience);
        return program;
    }

private slots:
    void eventsOfTheHouseAreRead() {
        rubble_pack::EventLog log;
        std::string fault;
        QVERIFY2(rubble_pack::loadEvents(kHouseEvents, log, fault), fault.c_str());
        QVERIFY(log.events.size() > 20);
        std::istringstream lines(houseEvents());
        std::size_t event = 0, sums = 0;
        for (std::string line; std::getline(lines, line);) {
            const EventJson expected = EventJson::parse(line);
            const bool isSums = expected["kind"] == "sums";
            const EventJson read = isSums ? sumsJson(log.sums.at(sums)) : eventJson(log.events.at(event), expected);
            QVERIFY2(read == expected, (line + " was read as " + read.dump()).c_str());
            ++(isSums ? sums : event);
        }
        QCOMPARE(event, log.events.size());
        QCOMPARE(sums, log.sums.size());
    }
    void everyKindAndReasonIsRead() {
        for (std::size_t kind = 0; kind < std::size(kEventKindNames); ++kind) {
            EventJson line = kBreakEvent;
            line["kind"] = kEventKindNames[kind];
            line["reason"] = kEventReasons[1 + kind % 3];
            rubble_pack::EventLog log;
            std::string fault;
            QVERIFY2(rubble_pack::parseEvents(line.dump(), log, fault), fault.c_str());
            QVERIFY(eventJson(log.events.at(0), line) == line);
        }
    }
    void missingKeysAreNone() {
        EventJson line = kBreakEvent;
        for (const char* key : {"other", "normal", "impulse", "speed", "energy", "area", "mass", "count"})
            line.erase(key);
        rubble_pack::EventLog log;
        std::string fault;
        QVERIFY2(rubble_pack::parseEvents(line.dump() + "\n", log, fault), fault.c_str());
        QCOMPARE(log.events.at(0).other, rubble_pack::kNone);
        QCOMPARE(log.events[0].energy, 0.0);
        QVERIFY(log.events[0].reason == rubble_pack::RemovalReason::None);
    }
    void wrongValuesAreReportedWithLineAndKey_data() {
        test::addWrongValueColumns();
        test::addWrongValue("Line 2: step: expected a step.", "/step", "1.5");
        test::addWrongValue("Line 2: kind: \"burst\" is not known to this reader.", "/kind", "\"burst\"");
        test::addWrongValue("Line 2: body: expected a whole number below 4294967295.", "/body", "-1");
        test::addWrongValue("Line 2: point: expected 3 numbers.", "/point", "[1, 2]");
        test::addWrongValue("Line 2: energy: expected a number.", "/energy", "\"7 J\"");
        test::addWrongValue("Line 2: materials: expected 2 materials.", "/materials", "[1]");
        test::addWrongValue("Line 2: box: expected 2 corners.", "/box", "[[0, 0, 0]]");
        test::addWrongValue("Line 2: reason: \"\" is not known to this reader.", "/reason", "\"\"");
    }
    void wrongValuesAreReportedWithLineAndKey() {
        EventJson line = kBreakEvent;
        line["reason"] = "budget";
        QCOMPARE(eventsFault(kBreakEvent.dump() + "\n" + test::withWrongValue(line)),
                 std::string(QTest::currentDataTag()));
    }
    void truncatedLinesAreRefusedAndTheLogIsKept() {
        const std::string line = kBreakEvent.dump();
        for (std::size_t size = 1; size < line.size(); ++size) {
            QVERIFY(eventsFault(line.substr(0, size)).starts_with("Line 1: The text is not JSON at byte "));
        }
        QCOMPARE(eventsFault("\n"), std::string("Line 1: The text is not JSON at byte 0: expected a value."));
        rubble_pack::EventLog log;
        log.events.resize(2);
        std::string fault;
        QVERIFY(!rubble_pack::parseEvents(line + "\n[]", log, fault));
        QCOMPARE(fault, std::string("Line 2: The document: expected an object."));
        QCOMPARE(log.events.size(), std::size_t{2});
        QVERIFY(!rubble_pack::loadEvents("none.jsonl", log, fault));
        QCOMPARE(fault, std::string("Cannot read \"none.jsonl\"."));
        QCOMPARE(eventsFault(""), std::string());
    }
    void cueSheetListsWhatIsHeard() {
        EventJson weak = kBreakEvent, rest = kBreakEvent, silent = kBreakEvent;
        weak["kind"] = "impact", weak["step"] = 6, weak["energy"] = 0.7;
        rest["kind"] = "settled";
        silent["energy"] = 7e-9;
        QTemporaryDir folder;
        const QString path = folder.filePath("events.jsonl");
        std::ofstream(path.toStdString(), std::ios::binary) << kBreakEvent << '\n'
                                                            << rest << '\n'
                                                            << silent << '\n'
                                                            << weak << '\n';
        QProcess* program = example({path});
        QCOMPARE(program->exitCode(), 0);
        QCOMPARE(program->readAllStandardOutput(),
                 QByteArray("      time  sound      gain        energy  place                 materials\n"
                            "   0.050 s  crack    0.0 dB           7 J    0.00   1.00   2.00  1 + 2\n"
                            "   0.100 s  hit    -10.0 dB         0.7 J    0.00   1.00   2.00  1 + 2\n"));
    }
    void cueSheetNamesMaterials() {
        const QByteArray sheet = example({kHouseStream})->readAllStandardOutput();
        QVERIFY2(sheet.contains("  yellow masonry + yellow masonry\n"), sheet);
        rubble_pack::EventLog log;
        std::string fault;
        QVERIFY2(rubble_pack::loadEvents(kHouseStream, log, fault), fault.c_str());
        const double seconds = sheet.mid(sheet.indexOf('\n') + 1).left(10).trimmed().split(' ').front().toDouble();
        const auto first = std::ranges::find_if(log.events, [](const auto& event) { return event.energy > 0.0; });
        QVERIFY(std::abs(seconds - static_cast<double>(first->step) * log.dt) < 1e-3);
    }
    void streamIsReadWholeAndAsItArrives() {
        rubble_pack::EventLog whole, pieces;
        std::string fault;
        QVERIFY2(rubble_pack::loadEvents(kHouseStream, whole, fault), fault.c_str());
        QCOMPARE(whole.version, 2u);
        QCOMPARE(whole.dt, 1.0 / 60.0);
        QCOMPARE(rubble_pack::materialName(whole, whole.materials.at(0).id), whole.materials[0].name);
        std::ifstream file(kHouseStream, std::ios::binary);
        for (std::string line; std::getline(file, line);) QVERIFY(rubble_pack::appendEvents(line, pieces, fault));
        QCOMPARE(pieces.events.size(), whole.events.size());
        QCOMPARE(pieces.sums.size(), whole.sums.size());
        const std::size_t before = whole.events.size();
        QVERIFY(!rubble_pack::appendEvents("{\"step\":1,\"kind\":\"sliding\"}", whole, fault));
        QCOMPARE(fault, std::string("Line 1: The document: the key \"body\" is missing."));
        QCOMPARE(whole.events.size(), before);
    }
    void bodiesOfTheHouseAreFollowed() {
        rubble_pack::EventLog log;
        std::string fault;
        QVERIFY2(rubble_pack::loadEvents(kHouseStream, log, fault), fault.c_str());
        rubble_pack::EventState state = rubble_pack::startOf(log);
        const std::size_t atFirst = state.bodies.size();
        QCOMPARE(state.bodies.at(0).name, std::string("ground"));
        rubble_pack::playTo(log, 60, state);
        QVERIFY(state.bodies.size() > atFirst && !state.damages.empty());
        const auto broken = std::ranges::find(log.events, rubble_pack::EventKind::Broken, &rubble_pack::Event::kind);
        QVERIFY(broken != log.events.end() && !state.bodies.contains(broken->body));
        std::uint32_t born = 0;
        for (const auto& [number, body] : state.bodies) born += body.from == broken->body ? 1 : 0;
        QCOMPARE(born, broken->count);
    }
    /// Of each bond the last damage is kept, and none of those that are broken.
    void damagesOfEventsAddUp() {
        rubble_pack::EventLog log;
        log.events.resize(3);
        for (rubble_pack::Event& event : log.events) event.kind = rubble_pack::EventKind::Damaged;
        log.events[0].damage = {{7}, {{3, 10}, {5, 20}, {3, 30}}, {}};
        log.events[1].damage = {{5}, {{2, 1}, {3, 40}}, {}};
        log.events[2].damage = {{}, {{7, 8}}, {}};
        rubble_pack::EventState state = rubble_pack::startOf(log);
        rubble_pack::playTo(log, 0, state);
        const rubble_pack::EventDamage& damage = state.damages.at(0);
        QVERIFY((damage.broken == std::vector<std::uint32_t>{5, 7}));
        QVERIFY((damage.weakened == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{2, 1}, {3, 40}}));
    }
    /// A file of a few megabytes must not take hours.
    void longDamagesAndPathsArePlayedAtOnce() {
        constexpr std::uint32_t kMany = 3000000;
        rubble_pack::EventLog log;
        log.assets.resize(1);
        log.assets[0].fragments = {"a"};
        log.bodies.resize(1);
        log.events.resize(2);
        log.events[0].kind = rubble_pack::EventKind::Damaged;
        for (std::uint32_t bond = 0; bond < kMany; ++bond) log.events[0].damage.weakened.push_back({bond, 1});
        log.events[1].kind = rubble_pack::EventKind::Removed;
        log.events[1].fragments = {std::string(kMany, '/')};
        rubble_pack::EventState state = rubble_pack::startOf(log);
        rubble_pack::playTo(log, 0, state);
        QCOMPARE(state.damages.at(0).weakened.size(), std::size_t{kMany});
        QVERIFY((state.bodies.at(0).fragments == std::vector<std::string>{"a"}));
    }
    void kindsOfVersion2NeedItsFirstLine() {
        QCOMPARE(eventsFault("{\"step\":1,\"kind\":\"born\",\"body\":2}"),
                 std::string("Line 1: The document: the kind is of version 2, which begins with a line for the whole "
                             "file."));
        QCOMPARE(eventsFault("{\"format\":\"rubble-events\",\"version\":3}"),
                 std::string("Line 1: version: this header reads version 2."));
    }
    void cueSheetReportsErrors() {
        QCOMPARE(example({"none.jsonl"})->readAllStandardError(), QByteArray("Cannot read \"none.jsonl\".\n"));
        QCOMPARE(example({"none.jsonl", "0"})->exitCode(), 2);
        QCOMPARE(example({})->exitCode(), 2);
    }
};

RUBBLE_TEST_WITH(EventsHeaderTest, QCoreApplication)
#include "EventsHeaderTest.moc"
