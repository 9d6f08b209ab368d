// Tests core/sound/mix/SoundTrack.cpp and core/sound/mix/Limiter.cpp.
#include "core/sound/mix/SoundTrack.h"

#include "tests/support/TestProgram.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryFile>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace rubble;

namespace {

StereoTrack trackOf(const std::vector<SoundCue>& cues, double seconds = 2.0) {
    Result<StereoTrack> track = mixedTrack(cues, seconds, {});
    if (!track) qFatal("%s", track.error().message.c_str());
    return std::move(*track);
}

/// The sum of squares of one side.
double energyOf(const StereoTrack& track, std::size_t side) {
    double sum = 0.0;
    for (std::size_t k = side; k < track.samples.size(); k += 2) sum += double{1} * track.samples[k] * track.samples[k];
    return sum;
}

int peakOf(const StereoTrack& track) {
    int peak = 0;
    for (const std::int16_t sample : track.samples) peak = std::max(peak, std::abs(int{sample}));
    return peak;
}

SoundCue impactAt(double time, double energy, Vec3 point = {0.0, 0.0, -2.0}) {
    return {.time = time, .energy = energy, .mass = 5.0, .point = point};
}

std::uint32_t littleEndian(const std::string& bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int k = 0; k < count; ++k) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)])} << (8 * k);
    }
    return value;
}

}  // namespace

class SoundTrackTest : public QObject {
    Q_OBJECT
private slots:
    void noCuesAreSilence() {
        const StereoTrack track = trackOf({}, 0.5);
        QCOMPARE(track.frames(), 24000u);
        QCOMPARE(peakOf(track), 0);
        QCOMPARE(peakOf(trackOf({impactAt(0.1, 0.0)})), 0);
    }
    void moreEnergyIsLouder() {
        double before = 0.0;
        for (const double energy : {1.0, 10.0, 100.0, 1000.0, 1e4, 1e6}) {
            const double now = energyOf(trackOf({impactAt(0.1, energy)}), 0);
            QVERIFY(now > before);
            before = now;
        }
        // Below the limiter four times the energy is twice the amplitude.
        const int one = peakOf(trackOf({impactAt(0.1, 100.0)})), four = peakOf(trackOf({impactAt(0.1, 400.0)}));
        QVERIFY(std::abs(four - 2 * one) <= 2);
    }
    void soundBeginsWithinAMillisecondOfItsCue() {
        for (const double time : {0.0, 0.25, 1.0003}) {
            const StereoTrack track = trackOf({impactAt(time, 500.0)});
            const auto first = std::ranges::find_if(track.samples, [](std::int16_t value) { return value != 0; });
            const double onset = static_cast<double>((first - track.samples.begin()) / 2) / kSampleRate;
            QVERIFY(onset >= time - 0.5 / kSampleRate && onset < time + 1e-3);
        }
    }
    void nothingClips() {
        std::vector<SoundCue> cues;
        for (int k = 0; k < 300; ++k) cues.push_back(impactAt(0.004 * k, 1e7));
        const int peak = peakOf(trackOf(cues));
        QVERIFY(peak <= 31785);  // 0.97 of full scale
        QVERIFY(peak > 30000);
    }
    void limiterLeavesDistantTimesAsTheyWere() {
        const StereoTrack quiet = trackOf({impactAt(0.1, 50.0)}),
                          both = trackOf({impactAt(0.1, 50.0), impactAt(1.5, 1e8)});
        QVERIFY(std::equal(quiet.samples.begin(), quiet.samples.begin() + 2 * 70000, both.samples.begin()));
    }
    void sidesAndDistanceFollowThePoint() {
        const StereoTrack left = trackOf({impactAt(0.1, 100.0, {-3.0, 0.0, 0.0})});
        QVERIFY(energyOf(left, 0) > 1000.0 * energyOf(left, 1));
        const StereoTrack right = trackOf({impactAt(0.1, 100.0, {3.0, 0.0, -1.0})});
        QVERIFY(energyOf(right, 1) > 10.0 * energyOf(right, 0));
        const StereoTrack near = trackOf({impactAt(0.1, 100.0, {0.0, 0.0, -2.0})});
        QVERIFY(std::abs(energyOf(near, 0) - energyOf(near, 1)) < 1e-3 * energyOf(near, 0));
        const StereoTrack far = trackOf({impactAt(0.1, 100.0, {0.0, 0.0, -8.0})});
        QVERIFY(std::abs(peakOf(near) - 4 * peakOf(far)) <= 4);
    }
    void sameCuesAreTheSameBytes() {
        std::vector<SoundCue> cues;
        for (int k = 0; k < 40; ++k) {
            cues.push_back({.time = 0.03 * k,
                            .kind = static_cast<CueKind>(k % 3),
                            .first = static_cast<SoundMaterial>(k % kSoundMaterials),
                            .second = static_cast<SoundMaterial>(k / 2 % kSoundMaterials),
                            .energy = 10.0 * k,
                            .mass = 0.5 + k,
                            .point = {k - 20.0, 1.0, -5.0}});
        }
        QVERIFY(wavFile(trackOf(cues)) == wavFile(trackOf(cues)));
    }
    void headerOfAWavFileFitsItsData() {
        const std::string file = wavFile(trackOf({impactAt(0.0, 10.0)}, 0.25));
        QCOMPARE(file.substr(0, 4), std::string("RIFF"));
        QCOMPARE(littleEndian(file, 4, 4), file.size() - 8);
        QCOMPARE(file.substr(8, 8), std::string("WAVEfmt "));
        QCOMPARE(littleEndian(file, 20, 2), 1u);
        QCOMPARE(littleEndian(file, 22, 2), 2u);
        QCOMPARE(littleEndian(file, 24, 4), 48000u);
        QCOMPARE(littleEndian(file, 28, 4), 192000u);
        QCOMPARE(littleEndian(file, 34, 2), 16u);
        QCOMPARE(littleEndian(file, 40, 4), 48000u);  // bytes: 12,000 frames of four
        QCOMPARE(file.size(), 44u + 48000u);
    }
    void ffprobeReadsTheFile() {
        const QString ffprobe = QStandardPaths::findExecutable("ffprobe");
        if (ffprobe.isEmpty()) QSKIP("ffprobe is not installed.");
        QTemporaryFile file;
        QVERIFY(file.open());
        const std::string bytes = wavFile(trackOf({impactAt(0.0, 10.0)}, 0.25));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        QProcess process;
        process.start(ffprobe, {"-v", "error", "-show_entries", "stream=codec_name,sample_rate,channels", "-of",
                                "csv=p=0", file.fileName()});
        QVERIFY(process.waitForFinished(kPatience));
        QCOMPARE(process.readAllStandardOutput().trimmed(), QByteArray("pcm_s16le,48000,2"));
    }
    void cuesOutOfRangeAreRefused() {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        std::vector<SoundCue> cues(4, impactAt(0.0, 1.0));
        const auto messageFor = [&](const SoundCue& cue) {
            cues[2] = cue;
            return QString::fromStdString(mixedTrack(cues, 1.0, {}).error().message);
        };
        QCOMPARE(messageFor(impactAt(-1.0, 1.0)), "Sound cue 2 is refused: its time is not within the longest track.");
        QCOMPARE(messageFor(impactAt(0.0, kNan)), "Sound cue 2 is refused: its energy is negative or not finite.");
        QCOMPARE(messageFor(impactAt(0.0, 1.0, Vec3(kNan))), "Sound cue 2 is refused: its point is not finite.");
        SoundCue weightless = impactAt(0.0, 1.0);
        weightless.mass = 0.0;
        QCOMPARE(messageFor(weightless), "Sound cue 2 is refused: its mass is not positive and finite.");
        QCOMPARE(mixedTrack({}, 3601.0, {}).error().message,
                 "A sound track is at most 3600 s long; export a shorter part.");
    }
};

RUBBLE_TEST(SoundTrackTest)
#include "SoundTrackTest.moc"
