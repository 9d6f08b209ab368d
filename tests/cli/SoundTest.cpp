// Tests --wav of app/cli/verbs/SimulateVerb.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/RunProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace rubble;

class SoundTest : public QObject {
    Q_OBJECT
private slots:
    void soundOfAThrowIsAsLongAsTheSimulation() {
        const QTemporaryDir folder;
        const auto soundBy = [&](const QString& threads) {
            const QString path = folder.filePath(threads + ".wav");
            const ProgramOutcome run =
                runProgram(RUBBLE_CLI, {"simulate", RUBBLE_SOURCE_DIR "/projects/house.rubble", "--steps", "90",
                                        "--shot", "box at the door", "--threads", threads, "--wav", path});
            if (run.exit != 0) qFatal("%s", qPrintable(run.error));
            return bytesOfFile(path);
        };
        const QByteArray sound = soundBy("1");
        QCOMPARE(sound.size(), 44 + 288000);  // 1.5 s of 48,000 frames of four bytes
        QVERIFY(sound.startsWith("RIFF"));
        const auto isSilent = [](const QByteArray& bytes) {
            return std::ranges::all_of(bytes, [](char byte) { return byte == 0; });
        };
        QVERIFY(isSilent(sound.mid(44, 90000)));  // the box is thrown after half a second
        QVERIFY(!isSilent(sound.mid(44 + 96000)));
        QVERIFY(soundBy("3") == sound);
    }
};

RUBBLE_TEST(SoundTest)
#include "SoundTest.moc"
