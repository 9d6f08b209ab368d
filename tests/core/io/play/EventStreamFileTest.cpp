// Tests EventStreamFile.h, and what slides: core/play/events/MovingContacts.cpp.
#include "core/io/play/EventStreamFile.h"

#include "core/io/project/ProjectFile.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

#include <sstream>

using namespace rubble;

namespace {

Project demo(const char* name) {
    Result<Project> project = loadProject(std::string(RUBBLE_SOURCE_DIR "/projects/") + name);
    if (!project) qFatal("%s", project.error().message.c_str());
    return std::move(*project);
}

/// The events of a demo, in which all of its shots are fired and an instance is taken away.
std::string eventsOf(const Project& project, int steps) {
    Session session = test::sessionOf(project);
    for (const Shot& shot : project.shots)
        if (!session.add(shot)) qFatal("the shot cannot be fired");
    if (!session.add(TimedInput{20, RemoveInput{{project.instances.back().id, {}}}})) qFatal("it cannot be removed");
    EventStreamText text(session);
    for (int k = 0; k < steps; ++k) {
        session.step();
        text.add(session);
    }
    return text.take();
}

}  // namespace

class EventStreamFileTest : public QObject {
    Q_OBJECT
private slots:
    void linesFitTheSchema_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"house.rubble", "two-storey-house.rubble", "dam.rubble"}) QTest::newRow(name) << name;
    }
    void linesFitTheSchema() {
        QFETCH(const QString, name);
        const test::Schema schema("event-stream.schema.json");
        std::istringstream lines(eventsOf(demo(qPrintable(name)), 120));
        std::set<std::string> kinds;
        for (std::string line; std::getline(lines, line);) {
            nlohmann::json json = nlohmann::json::parse(line);
            QVERIFY2(schema.fault(json).empty(), (schema.fault(json) + ": " + line).c_str());
            kinds.insert(json.value("kind", "introduction"));
            json["another"] = 1;
            QVERIFY(!schema.fault(json).empty());
        }
        for (const char* kind : {"introduction", "born", "damaged", "removed", "impact"})
            QVERIFY2(kinds.contains(kind), kind);
    }
    void nothingIsAddedWhereNothingHappens() {
        Session session = test::sessionOf(demo("house.rubble"));
        EventStreamText text(session);
        const std::string introduction = text.take();
        QCOMPARE(std::ranges::count(introduction, '\n'), std::ptrdiff_t{1});
        QVERIFY(text.take().empty());
    }
    void playingOnWritesTheSame() {
        const Project project = demo("two-storey-house.rubble");
        Session session = test::sessionOf(project);
        std::vector<TimedInput> inputs{{20, RemoveInput{{project.instances.back().id, {}}}}};
        for (const Shot& shot : project.shots)
            inputs.push_back({stepOf(shot.time, session.stepLength()), ShotInput{shot.name, shot.action}});
        std::ranges::stable_sort(inputs, {}, &TimedInput::step);
        const Result<std::string> text = eventStream(std::move(session), std::move(inputs), 60);
        QVERIFY(text.hasValue() && *text == eventsOf(project, 60));
    }
    void slidingBlockIsReported() {
        // A block of 100 kg, slid over the ground at 3 m/s with the friction of both.
        Project project = demo("house.rubble");
        project.instances.clear();
        project.mortars.clear();
        project.playTests.clear();
        Throw block{.kind = ProjectileKind::Box, .size = {0.6, 0.2, 0.6}, .mass = 100.0, .speed = 3.0};
        block.from = {0.0, project.ground.height + 0.1, 0.0};
        block.to = block.from + Vec3(5.0, 0.0, 0.0);
        Session session = test::sessionOf(project);
        test::addInput(session, ShotInput{"block", block});
        EventStreamText text(session);
        for (int k = 0; k < 10; ++k) {
            session.step();
            text.add(session);
        }
        rubble_pack::EventLog log;
        std::string fault;
        QVERIFY2(rubble_pack::parseEvents(text.take(), log, fault), fault.c_str());
        const rubble_pack::Event& last = log.events.back();
        QVERIFY(last.kind == rubble_pack::EventKind::Sliding);
        QCOMPARE(last.step, std::uint64_t{10});
        const PlayBody& body = session.bodies().back();
        QCOMPARE(last.body, body.number);
        QCOMPARE(last.other, 0u);
        QVERIFY2(std::abs(last.load - 100.0 * 9.81) < 0.1 * 981.0, qPrintable(QString::number(last.load)));
        const double speed = glm::length(session.world().state(body.body).velocity);
        QVERIFY2(std::abs(last.speed - speed) < 0.02 * speed, qPrintable(QString::number(last.speed)));
        QVERIFY(speed < 3.0);
    }
};

RUBBLE_TEST_WITH(EventStreamFileTest, QCoreApplication)
#include "EventStreamFileTest.moc"
