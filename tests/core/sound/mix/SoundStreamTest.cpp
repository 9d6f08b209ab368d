// Tests core/sound/mix/SoundStream.cpp, core/sound/mix/SoundCue.cpp and core/sound/synthesis/SampleCache.cpp.
#include "core/sound/mix/SoundStream.h"

#include "core/sound/mix/SoundTrack.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace rubble;

namespace {

const Listener kListener{.position = {0.5, 1.0, 4.0}};

SoundCue cueAt(double time, double energy, SoundMaterial material = SoundMaterial::Stone) {
    return {.time = time, .first = material, .second = material, .energy = energy, .mass = 3.0};
}

/// Some that overlap, of which the third is turned down.
std::vector<SoundCue> someCues() {
    std::vector<SoundCue> cues{cueAt(0.0, 50.0), cueAt(0.12, 300.0, SoundMaterial::Glass), cueAt(0.3, 1e6),
                               cueAt(0.31, 20.0, SoundMaterial::Metal)};
    cues[2].kind = CueKind::Broken;
    return cues;
}

/// The next samples of a stream, asked for in blocks.
std::vector<std::int16_t> mixed(SoundStream& stream, std::size_t frames, std::size_t block = 480) {
    std::vector<std::int16_t> samples(2 * frames);
    for (std::size_t k = 0; k < frames; k += block) {
        stream.mix(std::span(samples).subspan(2 * k, 2 * std::min(block, frames - k)));
    }
    return samples;
}

void addTo(SoundStream& stream, const std::vector<SoundCue>& cues) {
    SampleCache cache;
    for (std::size_t k = 0; k < cues.size(); ++k) stream.add(cues[k], kListener, sampleOf(cues[k], k, cache));
}

int peakOf(std::span<const std::int16_t> samples) {
    int peak = 0;
    for (const std::int16_t sample : samples) peak = std::max(peak, std::abs(int{sample}));
    return peak;
}

}  // namespace

class SoundStreamTest : public QObject {
    Q_OBJECT
private slots:
    void streamIsTheTrackLater() {
        const std::vector<SoundCue> cues = someCues();
        const StereoTrack track = *mixedTrack(cues, 1.0, kListener);
        for (const std::size_t block : {std::size_t{1}, std::size_t{97}, std::size_t{4800}}) {
            SoundStream stream;
            addTo(stream, cues);
            const std::vector<std::int16_t> samples = mixed(stream, 48000 + Limiter::kDelay, block);
            QCOMPARE(peakOf(std::span(samples).first(2 * Limiter::kDelay)), 0);
            QVERIFY(std::ranges::equal(std::span(samples).subspan(2 * Limiter::kDelay), track.samples));
            QCOMPARE(stream.position(), std::uint64_t{48000 + Limiter::kDelay});
        }
    }
    void lateCueSoundsAtOnce() {
        SoundStream stream;
        mixed(stream, 24000);
        addTo(stream, {cueAt(0.1, 100.0)});
        const std::vector<std::int16_t> late = mixed(stream, 4800);
        SoundStream fresh;
        addTo(fresh, {cueAt(0.0, 100.0)});
        QVERIFY(mixed(fresh, 4800) == late);
        QVERIFY(peakOf(std::span(late).first(2 * (Limiter::kDelay + 96))) > 100);  // 22 ms
    }
    void silenceFadesWithinMilliseconds() {
        SoundStream stream;
        addTo(stream, {cueAt(0.0, 1000.0, SoundMaterial::Metal), cueAt(0.5, 1000.0)});
        mixed(stream, 2000);
        stream.silence();
        const std::vector<std::int16_t> rest = mixed(stream, 48000);
        QVERIFY(stream.isSilent());
        const std::size_t faded = 2 * (480 + Limiter::kDelay);  // 30 ms
        QVERIFY(peakOf(std::span(rest).first(faded)) > 100);
        QCOMPARE(peakOf(std::span(rest).subspan(faded)), 0);
        // It does not end at once, which would be heard as a click.
        const std::span<const std::int16_t> fade = std::span(rest).subspan(2 * Limiter::kDelay, 960);
        QVERIFY(peakOf(fade.first(200)) > 100 && 3 * peakOf(fade.last(200)) < peakOf(fade.first(200)));
    }
    void volumeScales() {
        const std::vector<SoundCue> cues{cueAt(0.1, 100.0)};
        SoundStream loud, half, mute;
        half.setVolume(0.5);
        mute.setVolume(0.0);
        for (SoundStream* stream : {&loud, &half, &mute}) addTo(*stream, cues);
        const std::vector<std::int16_t> all = mixed(loud, 24000), some = mixed(half, 24000);
        for (std::size_t k = 0; k < all.size(); ++k) QVERIFY(std::abs(2 * some[k] - all[k]) <= 2);
        QCOMPARE(peakOf(mixed(mute, 24000)), 0);
    }
    void loudestVoicesWin() {
        SoundStream crowded, alone;
        std::vector<SoundCue> cues(SoundStream::kMaxVoices, cueAt(0.0, 0.0));
        addTo(crowded, cues);
        addTo(crowded, {cueAt(0.0, 400.0)});
        addTo(alone, {cueAt(0.0, 400.0)});
        addTo(crowded, cues);  // these are quieter than all
        QVERIFY(mixed(crowded, 4800) == mixed(alone, 4800));
    }
    void neverExceedsTheCeiling() {
        SoundStream stream;
        std::vector<SoundCue> cues;
        for (int k = 0; k < 300; ++k) cues.push_back(cueAt(0.01 * k, 1e7));
        addTo(stream, cues);
        QVERIFY(peakOf(mixed(stream, 48000)) <= static_cast<int>(kCeiling * 32767.0) + 1);
    }
    void levelsFallWithTheDistanceAndPan() {
        SoundCue cue = cueAt(0.0, 100.0);
        cue.point = {0.0, 0.0, -2.0};
        const std::array<double, 2> near = levelsOf(cue, {});
        cue.point.z = -4.0;
        const std::array<double, 2> far = levelsOf(cue, {});
        QVERIFY(std::abs(near[0] - 2.0 * far[0]) < 1e-12 && std::abs(near[0] - near[1]) < 1e-12);
        cue.point = {3.0, 0.0, 0.0};
        QVERIFY(levelsOf(cue, {})[0] < 1e-12 && levelsOf(cue, {.right = {-1.0, 0.0, 0.0}})[1] < 1e-12);
    }
    void samplesAreMadeOnce() {
        SampleCache cache;
        const SoundCue cue = cueAt(0.0, 1.0);
        QVERIFY(sampleOf(cue, 0, cache) == sampleOf(cue, 4, cache));  // of four takes
        QVERIFY(*sampleOf(cue, 0, cache) != *sampleOf(cue, 1, cache));
        SoundCue heavier = cue;
        heavier.mass = 3.9;  // within the same powers of two
        QVERIFY(sampleOf(heavier, 0, cache) == sampleOf(cue, 0, cache));
        heavier.mass = 4.1;
        QVERIFY(sampleOf(heavier, 0, cache) != sampleOf(cue, 0, cache));
    }
};

RUBBLE_TEST(SoundStreamTest)
#include "SoundStreamTest.moc"
