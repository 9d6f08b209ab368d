// Tests core/io/play/ReplayFile.cpp and PlayInputJson.cpp.
#include "core/io/play/ReplayFile.h"
#include "tests/support/TestProgram.h"

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
                     {3, ShotInput{"bomb", Explosion{{1, 2, 3}, 50.0, 2.0}}},
                     {4, ThresholdInput{2, 9, 70.5}},
                     {5, MaterialInput{{.id = 4, .name = "lead", .density = 11000.0}}},
                     {6, BreakInput{12}},
                     {7, GravityInput{{0, -1, 0}}},
                     {8, DestructionInput{false}},
                     {9, GrabInput{3, {1, 1, 1}, 500.0}},
                     {10, DragInput{{2, 2, 2}}},
                     {11, ReleaseInput{}}};
    replay.steps = {{.hash = 0xfedcba9876543210, .moved = {{1, 99}, {7, 0xffffffff}}}, {.hash = 5}};
    replay.keyframes = {{.step = 60, .bodies = {{.number = 3, .pose = {{0.1, 0.2, 0.3}, {0.5, 0.5, 0.5, 0.5}}}}}};
    return replay;
}

QString faultOf(std::string text, const std::string& what, const std::string& with) {
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
    void replayIsSavedAndLoaded() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("a.replay").toStdString();
        QVERIFY(saveReplay(path, replayOfAll()).hasValue());
        QVERIFY(*loadReplay(path) == replayOfAll());
        QVERIFY(!loadReplay(path + "x"));
    }
    void modifiedListsAreReported() {
        const std::string text = replayText(replayOfAll());
        QCOMPARE(faultOf(text, "\"mass\": 7", "\"mass\": 8"),
                 QString("inputsSeal: the inputs were changed after the recording."));
        QCOMPARE(faultOf(text, "fedcba9876543210", "fedcba9876543211"),
                 QString("stepsSeal: the steps were changed after the recording."));
        QCOMPARE(faultOf(text, "\"body\": 3, \"position\"", "\"body\": 4, \"position\""),
                 QString("keyframesSeal: the keyframes were changed after the recording."));
    }
    void invalidTextIsRejected() {
        const std::string text = replayText(replayOfAll());
        QVERIFY(faultOf(text, "rubble-replay", "rubble-project").contains("rubble-project"));
        QVERIFY(faultOf(text, "\"version\": 1", "\"version\": 2").contains("newer"));
        QCOMPARE(faultOf(text, "fedcba9876543210", "fedcba987654321"),
                 QString("steps[0].hash: expected sixteen hexadecimal digits."));
        QCOMPARE(faultOf(text, "0123456789abcdef", "x123456789abcdef"),
                 QString("project: expected thirty-two hexadecimal digits."));
        QVERIFY(faultOf(text, "\"letGo\"", "\"leave\"").startsWith("inputs[10].input: "));
        QVERIFY(faultOf(text, "\"dt\": 0.008333333333333333", "\"dt\": 0").startsWith("dt: "));
    }
};

RUBBLE_TEST(ReplayFileTest)
#include "ReplayFileTest.moc"
