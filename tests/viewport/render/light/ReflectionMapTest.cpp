// Tests viewport/render/light/ReflectionMap.cpp and viewport/render/light/SkyLight.cpp.
#include "viewport/render/light/ReflectionMap.h"

#include "tests/support/TestProgram.h"
#include "viewport/render/light/SkyLight.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

/// Directions spread over the sphere.
std::vector<Vec3> directions(int count) {
    std::vector<Vec3> spread;
    for (int k = 0; k < count; ++k) {
        const double height = 1.0 - 2.0 * (k + 0.5) / count, aside = std::sqrt(1.0 - height * height);
        spread.emplace_back(aside * std::cos(2.4 * k), height, aside * std::sin(2.4 * k));
    }
    return spread;
}

double difference(Vec3 a, Vec3 b) { return glm::length(a - b); }

/// The mean over the lobe of a surface seen along its normal, by integration.
double integrated(const std::function<double(Vec3)>& radiance, Vec3 n, double roughness) {
    const double square = std::pow(roughness, 4.0);
    double sum = 0.0, weights = 0.0;
    for (const Vec3 direction : directions(40'000)) {
        const double facing = std::max(glm::dot(direction, n), 0.0), half = 0.5 * (1.0 + facing);
        const double weight = facing / std::pow(half * (square - 1.0) + 1.0, 2.0);
        sum += weight * radiance(direction);
        weights += weight;
    }
    return sum / weights;
}

}  // namespace

class ReflectionMapTest : public QObject {
    Q_OBJECT
private slots:
    void placesAndDirectionsAreInverse() {
        for (const Vec3 direction : directions(500))
            QVERIFY(difference(directionInReflections(placeInReflections(direction)), direction) < 1e-9);
    }
    void uniformSkyIsReflectedUnchanged() {
        const ReflectionMap map = reflectionMap([](Vec3) { return Vec3(0.7, 0.5, 0.3); });
        for (const glm::vec3& texel : map.texels) QVERIFY(difference(Vec3(texel), {0.7, 0.5, 0.3}) < 1e-5);
    }
    void mirrorShowsTheRadiance() {
        const auto radiance = [](Vec3 d) { return Vec3(1.0 + d.x, 1.0 + d.y * d.z, 2.0 - d.z); };
        const ReflectionMap map = reflectionMap(radiance);
        double worst = 0.0;
        for (const Vec3 direction : directions(500))
            worst = std::max(worst, difference(reflected(map, direction, 0.0), radiance(direction)));
        QVERIFY2(worst < 0.03, qPrintable(QString::number(worst)));  // half a texel is 0.03 rad
    }
    void roughLobesAgreeWithIntegration() {
        const auto radiance = [](Vec3 d) { return 0.2 + (1.0 + d.x) * std::clamp(0.5 + 5.0 * d.y, 0.0, 1.0); };
        const ReflectionMap map = reflectionMap([&](Vec3 d) { return Vec3(radiance(d)); });
        for (const double roughness : {0.4, 0.6, 0.8, 1.0}) {
            for (const Vec3 direction : directions(30)) {
                const double seen = reflected(map, direction, roughness).x;
                const double expected = integrated(radiance, direction, roughness);
                QVERIFY2(std::abs(seen - expected) < 0.05,
                         qPrintable(QString("%1 for %2 at %3").arg(seen).arg(expected).arg(roughness)));
            }
        }
    }
    /// Across the edges of the square, and over the poles, filtered values have no step.
    void filteredValuesHaveNoSeams() {
        const SkyLight light = skyLightOf(skyOf(SkyPreset::Evening, Theme::Light));
        const Vec3 seams[] = {{1.0, -1.0, 0.0}, {0.0, -1.0, 1.0},  {-1.0, -0.5, 0.0}, {0.0, -0.5, -1.0},
                              {0.0, -1.0, 0.0}, {-1.0, -2.0, 0.0}, {0.3, -1.0, 0.0},  {1.0, 0.0, 0.0}};
        for (const Vec3 seam : seams) {
            for (const double roughness : {0.0, 0.3, 0.8}) {
                for (const Vec3 aside : {Vec3(1e-4, 0.0, 0.0), Vec3(0.0, 0.0, 1e-4), Vec3(0.0, 1e-4, 0.0)}) {
                    const double step =
                        difference(reflected(light.reflections, glm::normalize(seam + aside), roughness),
                                   reflected(light.reflections, glm::normalize(seam - aside), roughness));
                    QVERIFY2(step < 2e-3, qPrintable(QString::number(step)));
                }
            }
        }
    }
    void groundReflectsSunAndSky() {
        Sky sky{.sunDirection = {0.0, 1.0, 0.0},
                .sunLight = Vec3(0.5),
                .zenith = Vec3(1.0),
                .horizon = Vec3(1.0),
                .groundAlbedo = Vec3(0.2)};
        const SkyLight light = skyLightOf(sky);
        QVERIFY(difference(light.sunOnGround, Vec3(0.5)) < 1e-9);
        QVERIFY(difference(light.skyOnGround, Vec3(1.0)) < 5e-3);
        QVERIFY(difference(light.ground, Vec3(0.5 * 0.2 * 1.5)) < 1e-3);
        QVERIFY(difference(reflected(light.reflections, {0.0, -1.0, 0.0}, 0.0), light.ground) < 1e-6);
    }
    void sameBitsEachTime() {
        const Sky sky = skyOf(SkyPreset::Morning, Theme::Light);
        QCOMPARE(skyLightOf(sky).reflections, skyLightOf(sky).reflections);
    }
};

RUBBLE_TEST(ReflectionMapTest)
#include "ReflectionMapTest.moc"
