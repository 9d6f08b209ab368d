#include "viewport/render/light/ToneMapping.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// The curve as Khronos publishes it.
Vec3 published(Vec3 colour) {
    const double startCompression = 0.8 - 0.04, desaturation = 0.15;
    const double x = std::min({colour.x, colour.y, colour.z});
    colour -= x < 0.08 ? x - 6.25 * x * x : 0.04;
    const double peak = std::max({colour.x, colour.y, colour.z});
    if (peak < startCompression) return colour;
    const double d = 1.0 - startCompression;
    const double newPeak = 1.0 - d * d / (peak + d - startCompression);
    colour *= newPeak / peak;
    const double g = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
    return colour * (1.0 - g) + Vec3(newPeak) * g;
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

const Vec3 kRadiances[] = {{0.0, 0.0, 0.0}, {0.02, 0.05, 0.01}, {0.2, 0.1, 0.3}, {0.7, 0.75, 0.6},
                           {0.8, 0.8, 0.8}, {1.5, 0.9, 0.2},    {8.0, 2.0, 1.0}, {0.08, 0.08, 0.08}};

}  // namespace

class ToneMappingTest : public QObject {
    Q_OBJECT
private slots:
    void transferIsThatOfTheStandard() {
        QVERIFY(std::abs(linearOf(0.5) - 0.21404114) < 1e-7);
        QVERIFY(std::abs(linearOf(0.04) - 0.04 / 12.92) < 1e-12);
        for (int k = 0; k <= 255; ++k) QVERIFY(std::abs(srgbOf(linearOf(k / 255.0)) - k / 255.0) < 1e-7);
    }
    void curveIsThePublishedOne() {
        for (const Vec3 radiance : kRadiances) QVERIFY(largest(toneMapped(radiance) - published(radiance)) < 1e-12);
    }
    void curveNeverReachesWhite() {
        QVERIFY(toneMapped(Vec3(50.0)).x < 1.0);
        QVERIFY(toneMapped(Vec3(50.0)).x > 0.99);
    }
    void inverseGivesTheRadiance() {
        for (const Vec3 radiance : kRadiances) {
            const Vec3 back = radianceShownAs(toneMapped(radiance));
            QVERIFY2(largest(back - radiance) < 1e-6 * (1.0 + largest(radiance)), qPrintable(QString::number(back.x)));
        }
    }
};

RUBBLE_TEST(ToneMappingTest)
#include "ToneMappingTest.moc"
