// Tests editor/sound/SoundPlayer.cpp, editor/sound/SoundStreamDevice.cpp and editor/sound/AudioOutput.cpp.
#include "editor/sound/SoundPlayer.h"

#include "core/sound/mix/SoundTrack.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <thread>

using namespace rubble;

namespace {

constexpr qint64 kFrame = 4;  // bytes

SoundCue cueAt(double time, double energy = 200.0) {
    return {.time = time, .first = SoundMaterial::Stone, .second = SoundMaterial::Stone, .energy = energy, .mass = 3.0};
}

/// What an audio device would play of the next seconds, asked for in parts of some bytes.
QByteArray heard(SoundStreamDevice& stream, double seconds, qint64 part = 1920) {
    const auto bytes = static_cast<qint64>(seconds * kSampleRate) * kFrame;
    QByteArray all;
    while (all.size() < bytes) all += stream.read(std::min(part, bytes - all.size()));
    return all;
}

bool isSilent(const QByteArray& bytes) {
    return std::ranges::all_of(bytes, [](char byte) { return byte == 0; });
}

}  // namespace

class SoundPlayerTest : public QObject {
    Q_OBJECT
private slots:
    /// There is no sound server at this address, whatever this machine has.
    void initTestCase() { qputenv("PULSE_SERVER", "unix:/nonexistent"); }

    void deviceReadsTheTrackOfTheCommandLine() {
        const std::vector<SoundCue> cues{cueAt(0.0), cueAt(0.1, 1e6), cueAt(0.25, 20.0)};
        const Listener listener{.position = {1.0, 2.0, 5.0}, .right = {0.6, 0.0, 0.8}};
        const std::string wav = wavFile(*mixedTrack(cues, 1.0, listener));
        const QByteArray track = QByteArray::fromStdString(wav.substr(44));
        for (const qint64 part : {kFrame, qint64{1000}, qint64{1 << 16}}) {
            SoundStreamDevice stream;
            stream.setListener(listener);
            SampleCache cache;
            for (std::size_t k = 0; k < cues.size(); ++k) stream.add(cues[k], sampleOf(cues[k], k, cache));
            const QByteArray delay = heard(stream, 0.02, part);
            QVERIFY(isSilent(delay));
            QVERIFY(heard(stream, 1.0, part) == track);
        }
    }
    void onlyWholeFramesAreRead() {
        SoundStreamDevice stream;
        QVERIFY(stream.isOpen() && stream.isSequential() && !stream.isWritable());
        QCOMPARE(stream.read(7).size(), 4);
        QVERIFY(stream.bytesAvailable() > 4800 * kFrame);
    }
    void cueIsHeardWithinAHundredMilliseconds() {
        SoundPlayer player;
        player.setHearing(true);
        QVERIFY(isSilent(heard(player.stream(), 0.5)));
        player.play({cueAt(77.0)}, 0.0);  // its time in the simulation does not matter
        player.finishSamples();
        QVERIFY(!isSilent(heard(player.stream(), 0.025)));  // and 50 ms in the buffer of the device
    }
    void cueOfSlowMotionIsHeardWithItsPicture() {
        SoundPlayer player;
        player.setHearing(true);
        player.play({cueAt(0.0)}, 5.0);
        player.finishSamples();
        QVERIFY(isSilent(heard(player.stream(), 1.0)));
        QVERIFY(!isSilent(heard(player.stream(), 4.1)));
    }
    void nothingIsHeardInPauses() {
        SoundPlayer player;
        player.play({cueAt(0.0)}, 0.0);
        player.finishSamples();
        QVERIFY(isSilent(heard(player.stream(), 1.0)));
        player.setHearing(true);
        player.play({cueAt(0.0, 1e4), cueAt(0.0, 1e4)}, 0.0);
        player.finishSamples();
        heard(player.stream(), 0.03);
        player.setHearing(false);
        QVERIFY(!isSilent(heard(player.stream(), 0.03)));  // it fades out
        QVERIFY(isSilent(heard(player.stream(), 1.0)));
        player.setHearing(true);
        QVERIFY(isSilent(heard(player.stream(), 1.0)));  // what was heard before does not come back
    }
    void volumeIsHeard() {
        SoundPlayer player;
        player.setHearing(true);
        player.setVolume(0.0);
        heard(player.stream(), 0.1);
        player.play({cueAt(0.0)}, 0.0);
        player.finishSamples();
        QVERIFY(isSilent(heard(player.stream(), 1.0)));
    }
    /// Sounds of what is long over would be noise.
    void oldestOfTooManyCuesAreDropped() {
        SoundPlayer player;
        player.setHearing(true);
        std::vector<SoundCue> cues(5000, cueAt(0.0, 0.0));
        for (std::size_t k = cues.size() - 10; k < cues.size(); ++k) cues[k].energy = 500.0;
        player.play(cues, 0.0);
        player.finishSamples();
        QVERIFY(!isSilent(heard(player.stream(), 0.1)));
    }
    void missingDeviceIsExplained() {
        SoundPlayer player;
        const QString fault = player.output().fault();
        QVERIFY2(fault.startsWith("There is no audio device.") || fault.startsWith("This program was built without"),
                 qPrintable(fault));
        player.output().start(player.stream());
        player.setHearing(true);
        player.play({cueAt(0.0)}, 0.0);
        player.output().start(player.stream());
        player.output().stop();
        player.output().stop();
        player.output().start(player.stream());  // and ends while it waits for a device
    }
    void deviceStopsAfterASecondOfSilence() {
        SoundPlayer player;
        const auto isRunning = [&player] {
            player.finishSamples();
            QCoreApplication::sendPostedEvents(&player);
            return player.output().isStarted();
        };
        player.setHearing(true);
        QVERIFY(!isRunning());
        player.setOutputUse(OutputUse::WhileHeard);
        QVERIFY(!isRunning());  // nothing has sounded yet
        player.play({cueAt(0.0)}, 0.0);
        QVERIFY(isRunning());
        player.setHearing(false);
        heard(player.stream(), 0.9);
        QVERIFY(isRunning());
        heard(player.stream(), 0.2);
        QVERIFY(!isRunning());
        QVERIFY(isSilent(heard(player.stream(), 1.0)));
        player.setHearing(true);
        player.play({cueAt(0.0)}, 0.0);
        QVERIFY(isRunning());
        player.setOutputUse(OutputUse::Never);
        QVERIFY(!isRunning());
        player.setOutputUse(OutputUse::Always);
        heard(player.stream(), 20.0);
        QVERIFY(isRunning());
        player.setOutputUse(OutputUse::WhileHeard);
        QVERIFY(!isRunning());
    }
    /// Nothing is read until the device runs.
    void beginningIsHeardAfterSilence() {
        SoundPlayer ready, stopped;
        for (SoundPlayer* player : {&ready, &stopped}) {
            player->setHearing(true);
            player->setOutputUse(OutputUse::WhileHeard);
        }
        heard(stopped.stream(), 3.0);
        for (SoundPlayer* player : {&ready, &stopped}) {
            player->play({cueAt(0.0)}, 0.0);
            player->finishSamples();
        }
        const QByteArray expected = heard(ready.stream(), 0.5);
        QVERIFY(!isSilent(expected));
        QVERIFY(heard(stopped.stream(), 0.5) == expected);
    }
    void deviceReadsWhileOthersAdd() {
        SoundPlayer player;
        player.setHearing(true);
        std::jthread device([&] { heard(player.stream(), 20.0, 960); });
        for (int k = 0; k < 200; ++k) {
            player.play({cueAt(0.0, 10.0 + k)}, 0.0);
            player.setListener({.position = {0.1 * k, 0.0, 0.0}});
            if (k % 50 == 49) player.setHearing(k % 100 != 49);
        }
        device.join();
        player.play({cueAt(0.0)}, 0.0);
        player.finishSamples();
        QVERIFY(!isSilent(heard(player.stream(), 0.1)));
    }
};

RUBBLE_TEST_WITH(SoundPlayerTest, QGuiApplication)
#include "SoundPlayerTest.moc"
