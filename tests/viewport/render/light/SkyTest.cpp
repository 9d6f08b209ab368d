#include "viewport/render/light/Sky.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

constexpr SkyPreset kPresets[] = {SkyPreset::Studio, SkyPreset::Overcast, SkyPreset::Morning, SkyPreset::Evening,
                                  SkyPreset::Night};

double brightness(Vec3 radiance) { return radiance.x + radiance.y + radiance.z; }

}  // namespace

class SkyTest : public QObject {
    Q_OBJECT
private slots:
    void directionsHaveUnitLengthAndSunIsUp() {
        for (const SkyPreset preset : kPresets) {
            const Sky sky = skyOf(preset, Theme::Light);
            QVERIFY(std::abs(glm::length(sky.sunDirection) - 1.0) < 1e-12);
            QVERIFY(sky.sunDirection.y > 0.1 && sky.sunRadius > 0.0);
            for (const SkyLamp& lamp : sky.lamps) QVERIFY(std::abs(glm::length(lamp.direction) - 1.0) < 1e-12);
        }
    }
    void onlyTheStudioFollowsTheTheme() {
        for (const SkyPreset preset : kPresets)
            QCOMPARE(skyOf(preset, Theme::Light) == skyOf(preset, Theme::Dark), preset != SkyPreset::Studio);
    }
    void skyGlowsAroundTheSun() {
        const Sky sky = skyOf(SkyPreset::Evening, Theme::Light);
        const Vec3 opposite(-sky.sunDirection.x, sky.sunDirection.y, -sky.sunDirection.z);
        QVERIFY(brightness(backgroundRadiance(sky, sky.sunDirection)) >
                1.5 * brightness(backgroundRadiance(sky, opposite)));
    }
    void lampsAreNotInTheBackground() {
        const Sky sky = skyOf(SkyPreset::Night, Theme::Light);
        const SkyLamp& lamp = sky.lamps.front();
        QCOMPARE(skyRadiance(sky, lamp.direction), backgroundRadiance(sky, lamp.direction) + lamp.radiance);
    }
};

RUBBLE_TEST(SkyTest)
#include "SkyTest.moc"
