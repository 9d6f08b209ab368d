#include "viewport/render/light/SphericalHarmonics.h"

#include "tests/support/TestProgram.h"
#include "viewport/render/light/Sky.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// What a white surface reflects, by integration over the upper hemisphere.
Vec3 integrated(const std::function<Vec3(Vec3)>& radiance, Vec3 normal) {
    constexpr int kHeights = 200, kAzimuths = 400;
    Vec3 sum(0.0);
    for (int k = 0; k < kHeights; ++k) {
        const double height = (k + 0.5) / kHeights, aside = std::sqrt(1.0 - height * height);
        for (int j = 0; j < kAzimuths; ++j) {
            const double azimuth = 2.0 * kPi * (j + 0.5) / kAzimuths;
            const Vec3 direction(aside * std::cos(azimuth), height, aside * std::sin(azimuth));
            sum += std::max(glm::dot(direction, normal), 0.0) * radiance(direction);
        }
    }
    return 2.0 / (kHeights * kAzimuths) * sum;
}

const Vec3 kNormals[] = {{0.0, 1.0, 0.0}, {1.0, 0.0, 0.0},  {0.0, 0.0, -1.0},
                         {0.6, 0.8, 0.0}, {0.0, -1.0, 0.0}, {-0.48, 0.6, 0.64}};

}  // namespace

class SphericalHarmonicsTest : public QObject {
    Q_OBJECT
private slots:
    void uniformSkyIsExact() {
        const SphericalHarmonics light = diffuseLight([](Vec3) { return Vec3(1.0); });
        for (const Vec3 normal : kNormals) {
            const double expected = 0.5 + 0.5 * normal.y;
            QVERIFY2(std::abs(valueFor(light, normal).x - expected) < 2e-3,
                     qPrintable(QString::number(valueFor(light, normal).x)));
        }
    }
    /// Nine coefficients approximate any sky to a few percent of its light.
    void presetsAgreeWithIntegration() {
        for (const auto preset :
             {SkyPreset::Studio, SkyPreset::Overcast, SkyPreset::Morning, SkyPreset::Evening, SkyPreset::Night}) {
            const Sky sky = skyOf(preset, Theme::Light);
            const auto radiance = [&](Vec3 direction) { return skyRadiance(sky, direction); };
            const SphericalHarmonics light = diffuseLight(radiance);
            const double scale = integrated(radiance, {0.0, 1.0, 0.0}).y;
            for (const Vec3 normal : kNormals) {
                const Vec3 apart = valueFor(light, normal) - integrated(radiance, normal);
                QVERIFY2(glm::length(apart) < 0.08 * scale, qPrintable(QString::number(glm::length(apart) / scale)));
            }
        }
    }
};

RUBBLE_TEST(SphericalHarmonicsTest)
#include "SphericalHarmonicsTest.moc"
