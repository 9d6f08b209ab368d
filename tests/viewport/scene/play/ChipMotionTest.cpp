// Tests viewport/scene/play/ChipMotion.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/ChipMotion.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

constexpr double kChipStep = 1.0 / 60.0;  // s
const ParticleWorld kEarth{.gravity = {0.0, -10.0, 0.0}, .ground = 0.0, .origin = Vec3(0.0), .stepLength = kChipStep};

/// A chip of 2 cm that comes off 1.259 m above where it lies, at 2 m/s along x.
const ChipStart kFalling{.from = {0.0, 1.259, 0.0},
                         .velocity = {2.0, 0.0, 0.0},
                         .radius = 0.02,
                         .lifetime = 5.0,
                         .spin = 10.0,
                         .seed = 0.25};
const double kFall = std::sqrt(0.25);  // s: 1.25 m at 10 m/s²

Vec3 placeAt(const ChipStart& start, double age) { return Vec3(glm::vec3(chipAt(start, age, kEarth).position)); }

}  // namespace

class ChipMotionTest : public QObject {
    Q_OBJECT
private slots:
    void fliesInAParabola() {
        const Vec3 position = placeAt(kFalling, 0.4);
        QVERIFY(glm::distance(position, Vec3(0.8, 1.259 - 0.8, 0.0)) < 1e-6);
    }
    /// It meets the ground at 5 m/s and leaves it at 0.28 times that: up to 9.8 cm, and for 0.28 s.
    void bouncesTwiceAndLies() {
        double highest = 0.0;
        for (double age = kFall + 0.01; age < kFall + 0.28; age += 0.01) {
            highest = std::max(highest, placeAt(kFalling, age).y);
        }
        QVERIFY2(std::abs(highest - 0.009 - 0.098) < 0.001, qPrintable(QString::number(highest)));
        const double second = kFall + 0.28;
        highest = 0.0;
        for (double age = second + 0.001; age < second + 0.0784; age += 0.001) {
            highest = std::max(highest, placeAt(kFalling, age).y);
        }
        QVERIFY2(std::abs(highest - 0.009 - 0.0077) < 0.0005, qPrintable(QString::number(highest)));
        for (double age = second + 0.079; age < 4.2; age += 0.1) {
            QVERIFY(std::abs(placeAt(kFalling, age).y - lyingHeight(kFalling)) < 1e-6);
        }
    }
    void isNeverBelowWhereItLies() {
        for (double age = 0.0; age < 5.0; age += 0.003) QVERIFY(placeAt(kFalling, age).y > 0.009 - 1e-6);
        ChipStart buried = kFalling;
        buried.from.y = -0.3;
        for (double age = 0.0; age < 5.0; age += 0.01) QVERIFY(placeAt(buried, age).y > -0.3 - 1e-6);
    }
    void pathHasNoSteps() {
        Vec3 before = placeAt(kFalling, 0.0);
        for (double age = 0.001; age < 4.9; age += 0.001) {
            const Vec3 now = placeAt(kFalling, age);
            QVERIFY(glm::distance(before, now) < 0.0062);  // at 6 m/s at most
            before = now;
        }
    }
    void slidesAndStays() {
        QVERIFY(placeAt(kFalling, 1.2).x > placeAt(kFalling, 0.9).x + 0.003);
        QVERIFY(glm::distance(placeAt(kFalling, 4.0), placeAt(kFalling, 3.5)) < 0.005);
    }
    /// So that a flat one does not stand on its edge.
    void liesUnrotated() {
        QVERIFY(std::abs(chipAt(kFalling, 0.2, kEarth).rotation.w) > 0.1f);
        const Chip lying = chipAt(kFalling, 2.0, kEarth);
        QCOMPARE(lying.rotation.w, 0.0f);
        QCOMPARE(lying.previousOffset.w, 0.0f);
    }
    void shrinksAwayAtTheEnd() {
        QCOMPARE(chipAt(kFalling, 4.2, kEarth).position.w, 0.02f);
        QVERIFY(std::abs(chipAt(kFalling, 4.65, kEarth).position.w - 0.01f) < 1e-6f);
        QVERIFY(chipAt(kFalling, 4.999, kEarth).position.w < 1e-4f);
    }
    void fallsOnWithoutGroundOrGravity() {
        ParticleWorld world = kEarth;
        world.ground = -1e9;
        QVERIFY(std::abs(chipAt(kFalling, 2.0, world).position.y - (1.259f - 20.0f)) < 1e-4f);
        world.gravity = Vec3(0.0);
        QVERIFY(std::abs(chipAt(kFalling, 2.0, world).position.y - 1.259f) < 1e-6f);
        world.gravity = {0.0, 3.0, 0.0};
        QVERIFY(chipAt(kFalling, 2.0, world).position.y > 7.0f);
    }
    /// Without gravity it meets the ground once and floats away from it: all that is drawn stays a number.
    void floatsAwayAfterABounce() {
        ParticleWorld space = kEarth;
        space.gravity = Vec3(0.0);
        ChipStart down = kFalling;
        down.velocity = {0.5, -2.0, 0.0};
        for (double age = 0.05; age < 4.9; age += 0.05) {
            const Chip chip = chipAt(down, age, space);
            for (const glm::vec4& numbers : {chip.position, chip.rotation})
                for (int k = 0; k < 4; ++k) QVERIFY(std::isfinite(numbers[k]));
        }
    }
    void previousOffsetMatchesTheStepBefore() {
        for (double age = kChipStep; age < 3.0; age += kChipStep) {
            const Chip now = chipAt(kFalling, age, kEarth), before = chipAt(kFalling, age - kChipStep, kEarth);
            const glm::vec3 earlier = glm::vec3(now.position + now.previousOffset);
            QVERIFY(glm::distance(earlier, glm::vec3(before.position)) < 1e-5f);
            const float apart = std::remainder(now.rotation.w + now.previousOffset.w - before.rotation.w, 6.2831853f);
            QVERIFY(std::abs(apart) < 1e-4f);
        }
    }
    void shapeAndSeedShareANumber() {
        ChipStart start = kFalling;
        for (const ChipShape shape : {ChipShape::Angular, ChipShape::Flat, ChipShape::Long}) {
            start.shape = shape;
            for (const double seed : {0.0, 0.5, 0.99999999999}) {
                start.seed = seed;
                QCOMPARE(chipAt(start, 0.1, kEarth).shape(), shape);
            }
        }
    }
};

RUBBLE_TEST_WITH(ChipMotionTest, QCoreApplication)
#include "ChipMotionTest.moc"
