// Tests core/sound/synthesis/SoundSample.cpp and core/sound/synthesis/SoundMaterial.cpp.
#include "core/sound/synthesis/SoundSample.h"

#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

std::vector<float> impactOf(SoundMaterial material, double mass = 1.0) {
    return synthesized({.first = material, .second = material, .mass = mass, .randomSeed = 5});
}

/// The power of a frequency in a sample.
double powerAt(const std::vector<float>& sample, double frequency) {
    double real = 0.0, imaginary = 0.0;
    for (std::size_t k = 0; k < sample.size(); ++k) {
        const double angle = kFullTurn * std::fmod(frequency * static_cast<double>(k) / kSampleRate, 1.0);
        real += sample[k] * std::cos(angle);
        imaginary += sample[k] * std::sin(angle);
    }
    return real * real + imaginary * imaginary;
}

/// The mean frequency of a sample by power, Hz, in steps of 100 Hz.
double spectralCentroid(const std::vector<float>& sample) {
    double sum = 0.0, weighted = 0.0;
    for (double frequency = 50.0; frequency < 16000.0; frequency += 100.0) {
        const double power = powerAt(sample, frequency);
        sum += power;
        weighted += power * frequency;
    }
    return weighted / sum;
}

}  // namespace

class SoundSampleTest : public QObject {
    Q_OBJECT
private slots:
    void lowestModeIsThatOfAPlate() {
        // A glass plate of 1 kg and 0.12 times as thick as long: l = (1 / (2500 · 0.12))^(1/3) = 0.149 m,
        // h = 0.0179 m, f = 13.5 / (2 pi · 3.3045) · h / l² · sqrt(70e9 / 2500) = 2763.9 Hz.
        const std::array<SoundMode, kSoundModes> modes = modesOf(SoundMaterial::Glass, 1.0, 0.0);
        QVERIFY(std::abs(modes[0].frequency - 2763.9) < 0.1);
        QVERIFY(std::abs(modes[1].frequency / modes[0].frequency - 19.8 / 13.5) < 1e-9);
        // Eight times the mass is twice the length, and half the frequency.
        QVERIFY(std::abs(modesOf(SoundMaterial::Glass, 8.0, 0.0)[0].frequency * 2.0 - modes[0].frequency) < 1e-6);
        // A chip of a gram is beyond hearing.
        QCOMPARE(modesOf(SoundMaterial::Stone, 1e-3, 0.0)[0].amplitude, 0.0);
        // Its amplitude is 1/e after Q / (pi f), where Q is the inverse of the loss factor.
        QVERIFY(std::abs(modes[0].decay - 500.0 / (3.14159 * modes[0].frequency)) < 1e-5);
    }
    void longBlowExcitesHighModesLess() {
        const auto sharp = modesOf(SoundMaterial::Wood, 20.0, 1e-5), dull = modesOf(SoundMaterial::Wood, 20.0, 1e-3);
        QVERIFY(dull.back().amplitude / dull[0].amplitude < sharp.back().amplitude / sharp[0].amplitude);
    }
    void everyPairAndKindHasAPeakOfOneAndEnds() {
        for (int pair = 0; pair < kSoundMaterials * kSoundMaterials; ++pair) {
            for (const CueKind kind : {CueKind::Impact, CueKind::Broken}) {
                const std::vector<float> sample =
                    synthesized({.kind = kind,
                                 .first = static_cast<SoundMaterial>(pair / kSoundMaterials),
                                 .second = static_cast<SoundMaterial>(pair % kSoundMaterials),
                                 .mass = 20.0});
                float peak = 0.0f;
                for (const float value : sample) peak = std::max(peak, std::abs(value));
                QVERIFY(peak > 0.9f && peak <= 1.0f);
                QVERIFY(sample.size() > 200 && sample.size() <= 72000);
                QVERIFY(std::abs(sample.back()) < 0.01f);
            }
        }
    }
    void onsetIsWithinAMillisecond() {
        for (int material = 0; material < kSoundMaterials; ++material) {
            const std::vector<float> sample = impactOf(static_cast<SoundMaterial>(material), 1000.0);
            const auto loud = std::ranges::find_if(sample, [](float value) { return std::abs(value) > 0.05f; });
            QVERIFY(loud - sample.begin() < kSampleRate / 1000);
        }
    }
    void glassIsBrighterThanConcrete() {
        for (const double mass : {0.1, 1.0, 30.0}) {
            const double glass = spectralCentroid(impactOf(SoundMaterial::Glass, mass));
            const double concrete = spectralCentroid(impactOf(SoundMaterial::Concrete, mass));
            QVERIFY2(glass > 1.3 * concrete, qPrintable(QString("%1 Hz, %2 Hz").arg(glass).arg(concrete)));
        }
    }
    void heavyIsLowerThanLight() {
        for (int material = 0; material < kSoundMaterials; ++material) {
            const auto one = static_cast<SoundMaterial>(material);
            const double heavy = spectralCentroid(impactOf(one, 100.0)), light = spectralCentroid(impactOf(one, 0.5));
            QVERIFY2(heavy < light, qPrintable(QString("%1: %2 Hz, %3 Hz").arg(material).arg(heavy).arg(light)));
        }
    }
    void breakLastsLongerThanAnImpact() {
        const SoundRecipe impact{.first = SoundMaterial::Brick, .second = SoundMaterial::Brick, .mass = 5.0};
        SoundRecipe broken = impact;
        broken.kind = CueKind::Broken;
        QVERIFY(synthesized(broken).size() > 2 * synthesized(impact).size());
    }
    void sameRecipeIsTheSameSample() {
        SoundRecipe recipe{.kind = CueKind::Broken, .first = SoundMaterial::Wood, .mass = 3.0, .randomSeed = 9};
        const std::vector<float> first = synthesized(recipe);
        QVERIFY(synthesized(recipe) == first);
        recipe.randomSeed = 10;
        QVERIFY(synthesized(recipe) != first);
    }
    void closestMaterialIsThatOfItsOwnProperties() {
        for (int material = 0; material < kSoundMaterials; ++material) {
            const auto one = static_cast<SoundMaterial>(material);
            const SoundProperties& properties = propertiesOf(one);
            QCOMPARE(closestSoundMaterial(properties.density, properties.youngsModulus), one);
            QCOMPARE(closestSoundMaterial(1.005 * properties.density, std::nullopt), one);
        }
        QCOMPARE(closestSoundMaterial(2500.0, 70e9), SoundMaterial::Glass);  // concrete weighs nearly the same
        QCOMPARE(closestSoundMaterial(19300.0, std::nullopt), SoundMaterial::Metal);
    }
    void materialsDiffer() {
        for (int one = 0; one < kSoundMaterials; ++one) {
            QVERIFY(!propertiesOf(static_cast<SoundMaterial>(one)).name.empty());
            for (int other = 0; other < one; ++other) {
                QVERIFY(impactOf(static_cast<SoundMaterial>(one)) != impactOf(static_cast<SoundMaterial>(other)));
            }
        }
    }
};

RUBBLE_TEST(SoundSampleTest)
#include "SoundSampleTest.moc"
