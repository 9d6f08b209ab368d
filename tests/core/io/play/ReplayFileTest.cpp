// Tests core/io/play/ReplayFile.cpp and core/io/play/PlayInputJson.cpp.
#include "core/io/play/ReplayFile.h"
#include "tests/support/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

/// A replay with an input of every kind.
Replay replayOfAll() {
    Replay replay{.program = "1.2", .project = {0x0123456789abcdef, 42}, .dt = 1.0 / 120.0, .sleeping = false};
    const Throw thrown{.kind = ProjectileKind::Ball, .size = Vec3(0.3), .mass = 7.0, .speed = 0.1};
    replay.inputs = {{0, ShotInput{"a \"ball\"", thrown}},
                     {0, ShotInput{"blow", Hammer{{1, 2, 3}, {4, 5, 6}}}},
                     {3, ShotInput{"bomb", Blast{{1, 2, 3}, 50.0, 2.0}}},
                     {4, ThresholdInput{2, 9, 70.5}},
                     {5, MaterialInput{{.id = 4, .name = "lead", .density = 11000.0}}},
                     {6, BreakInput{12}},
                     {7, GravityInput{{0, -1, 0}}},
                     {8, DestructionInput{false}},
                     {9, GrabInput{3, {1, 1, 1}, 500.0}},
                     {10, DragInput{{2, 2, 2}}},
                     {11, ReleaseInput{}},
                     {12, RemoveInput{{9, {"5.1", "5.2"}}}},
                     {12, RemoveInput{{10, {}}}}};
    replay.steps = {{.hash = 0xfedcba9876543210, .moved = {{1, 99, {0.5, -9.81, 0}}, {7, 0xffffffff, {}}}, .events = 1},
                    {.hash = 5, .broke = {{7, 1320.5}, {9, 0.0}}, .events = 0xabcdef},
                    {.hash = 6, .events = 0}};
    replay.keyframes = {{.step = 60, .bodies = {{.number = 3, .pose = {{0.1, 0.2, 0.3}, {0.5, 0.5, 0.5, 0.5}}}}}};
    return replay;
}

QString replayFault(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) return "not found";
    text.replace(at, what.size(), with);
    const Result<Replay> replay = readReplayText(text);
    return replay ? QString() : QString::fromStdString(replay.error().message);
}

}  // namespace

class ReplayFileTest : public QObject {
    Q_OBJECT
private slots:
    void replayRoundTrips() {
        const Replay replay = replayOfAll();
        const Result<Replay> read = readReplayText(replayText(replay));
        QVERIFY2(read.hasValue(), read ? "" : read.error().message.c_str());
        QVERIFY(*read == replay);
        QCOMPARE(replayText(*read), replayText(replay));
    }
    /// Recordings without events stay of version 2.
    void recordingsWithoutEventsAreReadAndWritten() {
        Replay replay = replayOfAll();
        for (ReplayStep& step : replay.steps) step.events.reset();
        const std::string text = replayText(replay);
        QVERIFY(text.find("\"version\": 2") != std::string::npos && text.find("events") == std::string::npos);
        const Result<Replay> read = readReplayText(text);
        QVERIFY2(read.hasValue(), read ? "" : read.error().message.c_str());
        QVERIFY(*read == replay);
    }
    void replayIsSavedAndLoaded() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("a.replay").toStdString();
        QVERIFY(saveReplay(path, replayOfAll()).hasValue());
        QVERIFY(*loadReplay(path) == replayOfAll());
        QVERIFY(!loadReplay(path + "x"));
    }
    void changedElementsAreNamed() {
        const std::string text = replayText(replayOfAll());
        const QString reason = ": changed after the recording, or what was here was removed.";
        QCOMPARE(replayFault(text, "\"mass\": 7", "\"mass\": 8"), "inputs[0]" + reason);
        QCOMPARE(replayFault(text, "\"gravity\": [0, -1, 0]", "\"gravity\": [0, -2, 0]"), "inputs[6]" + reason);
        QCOMPARE(replayFault(text, "fedcba9876543210", "fedcba9876543211"), "steps[0]" + reason);
        QCOMPARE(replayFault(text, "1320.5", "1320.6"), "steps[1]" + reason);
        QCOMPARE(replayFault(text, "\"body\": 3, \"position\"", "\"body\": 4, \"position\""), "keyframes[0]" + reason);
    }
    void removedElementsAreNamed() {
        const std::string text = replayText(replayOfAll());
        const std::string second = R"(    {"hash": "0000000000000005", "moved": [], "broke": [7, 1320.5, 9, 0], )"
                                   R"("events": "0000000000abcdef"},)";
        const std::string third =
            ",\n"
            R"(    {"hash": "0000000000000006", "moved": [], "broke": [], "events": "0000000000000000"})";
        QCOMPARE(replayFault(text, second + '\n', ""),
                 QString("steps[1]: changed after the recording, or what was here was removed."));
        QCOMPARE(replayFault(text, third, ""),
                 QString("steps: elements were removed from the end after the recording."));
    }
    void version1IsRead() {
        Replay replay = replayOfAll();
        replay.isDetailed = false;
        const std::string text = replayText(replay);
        QVERIFY(QString::fromStdString(text).contains("\"version\": 1"));
        for (ReplayStep& step : replay.steps) {
            step.broke.clear();
            step.events.reset();
            for (BodyCheck& check : step.moved) check.velocity = Vec3(0.0);
        }
        QVERIFY(*readReplayText(text) == replay);
        QCOMPARE(replayFault(text, "fedcba9876543210", "fedcba9876543211"),
                 QString("stepsSeal: the steps were changed after the recording."));
    }
    void inputsThatAreNoneAreRejected() {
        const std::string text = replayText(replayOfAll());
        const std::string letGo = "{\n      \"step\": 11,\n      \"input\": \"letGo\"\n    }";
        QCOMPARE(replayFault(text, letGo, "{\"input\": \"letGo\"}"),
                 QString("inputs[10]: the key \"step\" is missing."));
        QCOMPARE(replayFault(text, letGo, "{\"step\": 11}"), QString("inputs[10]: the key \"input\" is missing."));
        QCOMPARE(replayFault(text, letGo, "[]"), QString("inputs[10]: expected an object, found an array of 0."));
        QCOMPARE(replayFault(text, letGo, "7"), QString("inputs[10]: expected an object, found 7."));
    }
    void recordingEndsBeforeItsLimit() {
        Replay replay = replayOfAll();
        replay.steps.clear();
        ReplaySize size;
        while (replay.steps.size() < 500) {
            ReplayStep step{.hash = replay.steps.size(), .broke = {{1, 2.5}}};
            step.moved.assign(20, {4000000000, 4000000000, {-1.000001, 0.1, 123.456789}});
            replay.steps.push_back(step);
            QVERIFY(size.add(replay).hasValue());
        }
        const std::size_t written = replayText(replay).size();
        QVERIFY2(size.bytes() >= written && size.bytes() < written + written / 10,
                 qPrintable(QString("%1 against %2").arg(size.bytes()).arg(written)));
        ReplaySize small(1 << 16);
        replay.steps.resize(1);
        while (small.add(replay)) replay.steps.push_back(replay.steps[0]);
        const QString message = QString::fromStdString(small.add(replay).error().message);
        QVERIFY2(message.contains("record at most "), qPrintable(message));
        replay.steps.pop_back();
        QVERIFY(replayText(replay).size() <= 1 << 16);
    }
    void replayTooLargeToBeReadIsNotWritten() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("a.replay").toStdString();
        const Replay replay = replayOfAll();
        const std::size_t size = replayText(replay).size();
        QCOMPARE(saveReplay(path, replay, size - 1).error().code, ErrorCode::Limit);
        QVERIFY(!QFile::exists(QString::fromStdString(path)));
        QVERIFY(saveReplay(path, replay, size).hasValue());
    }
    void invalidTextIsRejected() {
        const std::string text = replayText(replayOfAll());
        QVERIFY(replayFault(text, "rubble-replay", "rubble-project").contains("rubble-project"));
        QVERIFY(replayFault(text, "\"version\": 3", "\"version\": 4").contains("newer"));
        QCOMPARE(replayFault(text, "fedcba9876543210", "fedcba987654321"),
                 QString("steps[0].hash: expected sixteen hexadecimal digits."));
        QCOMPARE(replayFault(text, "0123456789abcdef", "x123456789abcdef"),
                 QString("project: expected thirty-two hexadecimal digits."));
        QVERIFY(replayFault(text, "\"letGo\"", "\"leave\"").startsWith("inputs[10].input: "));
        QVERIFY(replayFault(text, "\"dt\": 0.008333333333333333", "\"dt\": 0").startsWith("dt: "));
    }
};

RUBBLE_TEST(ReplayFileTest)
#include "ReplayFileTest.moc"
