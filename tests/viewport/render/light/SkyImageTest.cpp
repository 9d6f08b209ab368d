// Tests viewport/render/light/SkyImage.cpp.
#include "viewport/render/light/SkyImage.h"

#include "tests/support/TestProgram.h"
#include "tests/support/viewport/SkyImages.h"

#include <QTest>
#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

/// A grey sky with a disc of light.
RadianceImage skyWithDisc(std::uint32_t width, Vec3 direction, double radius, double radiance) {
    return test::skyImage(width,
                          [=](Vec3 d) { return Vec3(0.5 + radiance * test::discCover(width, d, direction, radius)); });
}

double meanLuminance(const RadianceImage& image) { return luminance(meanRadiance(image)); }

}  // namespace

class SkyImageTest : public QObject {
    Q_OBJECT
private slots:
    void placesOfDirections() {
        QCOMPARE(placeInSky({0.0, 0.0, -1.0}), Vec2(0.5, 0.5));
        QCOMPARE(placeInSky({1.0, 0.0, 0.0}), Vec2(0.75, 0.5));
        QCOMPARE(placeInSky({0.0, 1.0, 0.0}).y, 0.0);
        QCOMPARE(placeInSky({0.0, -1.0, 0.0}).y, 1.0);
        for (int k = 1; k < 200; ++k) {
            const Vec2 place(0.005 * k, std::fmod(0.37 * k, 1.0));
            QVERIFY(glm::length(placeInSky(directionInSky(place)) - place) < 1e-12);
        }
    }
    void solidAnglesAreThoseOfASphere() {
        const RadianceImage image{64, 32, {}};
        double sum = 0.0;
        for (std::uint32_t row = 0; row < 32; ++row) sum += 64 * solidAngle(image, row);
        QVERIFY(std::abs(sum - 4.0 * M_PI) < 1e-12);
    }
    void meanIsOfTheUpperHalf() {
        const RadianceImage image = test::skyImage(128, [](Vec3 d) { return d.y > 0.0 ? Vec3(d.y) : Vec3(9.0); });
        QVERIFY(std::abs(meanLuminance(image) - 0.5) < 1e-3);
    }
    void samplesAreInterpolatedAndKeepTheLight() {
        const auto radiance = [](Vec3 d) { return Vec3(1.0 + 0.5 * d.x, 1.0 + 0.5 * d.y, 1.0 - 0.5 * d.z); };
        const SkySampler sample(test::skyImage(512, radiance), 128);
        for (int k = 0; k < 100; ++k) {
            const Vec3 direction = directionInSky({0.01 * k, 0.004 * k + 0.02});
            QVERIFY(glm::length(sample(direction) - radiance(direction)) < 0.02);
        }
        const SkySampler below(test::skyImage(64, [](Vec3 d) { return Vec3(d.y > 0.0 ? 1.0 : 7.0); }), 64);
        QCOMPARE(below({0.0, -1.0, 0.0}), Vec3(1.0));
        QCOMPARE(below(glm::normalize(Vec3(1.0, 0.001, 0.0))), Vec3(1.0));
    }
    void sunIsTakenOut_data() {
        QTest::addColumn<double>("azimuth");
        QTest::addColumn<double>("elevation");
        QTest::newRow("in the middle") << 0.3 << 0.6;
        QTest::newRow("at the edge") << M_PI << 0.4;
        QTest::newRow("near the zenith") << 1.0 << 1.5;
        QTest::newRow("low") << 2.0 << 0.06;
    }
    void sunIsTakenOut() {
        QFETCH(double, azimuth);
        QFETCH(double, elevation);
        const Vec3 direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                             -std::cos(elevation) * std::cos(azimuth));
        constexpr double kRadius = 0.02, kRadiance = 2000.0;
        RadianceImage image = skyWithDisc(1024, direction, kRadius, kRadiance);
        const auto sun = takeKeyLight(image);
        QVERIFY(sun.has_value());
        QVERIFY2(glm::length(sun->direction - direction) < 5e-4,
                 qPrintable(QString::number(glm::length(sun->direction - direction))));
        QVERIFY2(std::abs(sun->radius / kRadius - 1.0) < 0.1, qPrintable(QString::number(sun->radius)));
        const double expected = kRadiance * kRadius * kRadius;  // radiance times solid angle, by pi
        QVERIFY2(std::abs(sun->light.y / expected - 1.0) < 0.06, qPrintable(QString::number(sun->light.y)));
        for (const auto& pixel : image.pixels)
            QVERIFY(static_cast<double>(pixel[1]) < 0.5 + 1e-3 * kRadiance);  // of blurred edges
    }
    /// What is taken out and what is left are what was there.
    void lightIsKept() {
        RadianceImage image = skyWithDisc(512, glm::normalize(Vec3(1.0, 1.0, 0.2)), 0.05, 300.0);
        const double before = meanLuminance(image);
        const auto sun = takeKeyLight(image);
        QVERIFY(std::abs(meanLuminance(image) + 0.5 * luminance(sun->light) - before) < 1e-5 * before);
    }
    void dimAndBroadLightsStay() {
        const Vec3 direction = glm::normalize(Vec3(1.0, 1.0, 0.2));
        const auto stays = [&](const RadianceImage& sky) {
            RadianceImage image = sky;
            return !takeKeyLight(image) && image == sky;
        };
        QVERIFY(stays(test::skyImage(256, [](Vec3) { return Vec3(0.7); })));
        QVERIFY(stays(test::skyImage(256, [](Vec3 d) { return Vec3(0.3 + d.y); })));
        QVERIFY(stays(skyWithDisc(512, direction, 0.02, 100.0)));  // a tenth of the light
        QVERIFY(!stays(skyWithDisc(512, direction, 0.02, 1000.0)));
        QVERIFY(stays(skyWithDisc(512, direction, 0.3, 50.0)));
        QVERIFY(stays(skyWithDisc(512, -direction, 0.02, 1e5)));  // below the horizon
        QVERIFY(stays(skyWithDisc(2, direction, 2.0, 1e5)));
    }
};

RUBBLE_TEST_WITH(SkyImageTest, QCoreApplication)
#include "SkyImageTest.moc"
