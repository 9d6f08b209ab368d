// Tests core/physics/solver/EnergyKernels.h.
#include "core/base/Random.h"
#include "core/physics/solver/SolverKernels.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

using namespace rubble;

namespace {

constexpr Vec3 kGravity{0.5, -9.81, 1.0};

/// A body in a step: what the solver has of it, and its inertia.
struct RandomBody {
    StartMotion start;
    BodyMotion now;
    BodyPose pose;
    double mass = 0.0;
    Mat3 inertia{0.0};  // kg·m², in world axes

    explicit RandomBody(Random& random) {
        const auto vector = [&](double size) {
            return Vec3(random.between(-size, size), random.between(-size, size), random.between(-size, size));
        };
        mass = std::pow(10.0, random.between(-6.0, 9.0));  // kg
        const double size = std::pow(10.0, random.between(-2.0, 2.0));
        const Quat rotation = glm::normalize(Quat(random.between(-1.0, 1.0), random.between(-1.0, 1.0),
                                                  random.between(-1.0, 1.0), random.between(0.1, 1.0)));
        Vec3 moments;
        for (int axis = 0; axis < 3; ++axis) moments[axis] = mass * size * std::pow(10.0, random.between(-3.0, 0.0));
        const Mat3 axes = glm::mat3_cast(rotation);
        const auto turned = [&](Vec3 diagonal) {
            return axes * Mat3(diagonal.x, 0, 0, 0, diagonal.y, 0, 0, 0, diagonal.z) * glm::transpose(axes);
        };
        inertia = turned(moments);
        const Mat3 inverse = turned(1.0 / moments);
        const auto single = [](double value) { return static_cast<float>(value); };
        pose.inverseInertia = {single(inverse[0][0]), single(inverse[0][1]), single(inverse[0][2]),
                               single(inverse[1][1]), single(inverse[1][2]), single(inverse[2][2])};
        start.velocity = toFloat(vector(10.0));
        start.angularVelocity = toFloat(vector(10.0));
        now.velocity = start.velocity + toFloat(vector(1.0));
        now.angularVelocity = start.angularVelocity + toFloat(vector(1.0));
        now.deltaPosition = toFloat(vector(0.1));
        now.inverseMass = start.inverseMass = single(1.0 / mass);
    }

    double energy(Vec3f velocity, Vec3f angularVelocity) const {
        const Vec3 v = toDouble(velocity), w = toDouble(angularVelocity);
        return 0.5 * mass * glm::dot(v, v) + 0.5 * glm::dot(w, inertia * w);
    }
    double lost() const {
        return energy(start.velocity, start.angularVelocity) - energy(now.velocity, now.angularVelocity) +
               mass * glm::dot(kGravity, toDouble(now.deltaPosition));
    }
    /// What rounding may be of: the parts of the energy that change.
    double scale() const {
        const Vec3 w = toDouble(now.angularVelocity);
        return mass * 10.0 + std::sqrt(glm::dot(inertia * w, inertia * w));
    }
};

}  // namespace

class EnergyKernelsTest : public QObject {
    Q_OBJECT
private slots:
    /// Of any mass and inertia, slender ones too, at all widths: what double precision says, and the same bits.
    void lossesAreThoseOfTheMotions() {
        constexpr std::uint64_t kSeed = 3;
        std::printf("random seed %d\n", static_cast<int>(kSeed));
        Random random(kSeed);
        for (int round = 0; round < 300; ++round) {
            const std::size_t count = 1 + random.below(20);
            std::vector<RandomBody> bodies;
            std::vector<StartMotion> starts(1);
            std::vector<BodyMotion> motions(1);  // body 0 never moves
            std::vector<BodyPose> poses(1);
            for (std::size_t k = 0; k < count; ++k) {
                const RandomBody& body = bodies.emplace_back(random);
                starts.push_back(body.start);
                motions.push_back(body.now);
                poses.push_back(body.pose);
            }
            std::vector<std::uint32_t> numbers(count);
            std::iota(numbers.begin(), numbers.end(), 1u);
            const SolverStep step{.motions = motions.data(),
                                  .poses = poses.data(),
                                  .dt = 1.0f / 60.0f,
                                  .subStep = 1.0f / 240.0f,
                                  .gravity = toFloat(kGravity)};
            std::vector<BodyLoss> first;
            for (const SimdWidth width : availableSimdWidths()) {
                std::vector<BodyLoss> losses(count + 1);
                kernelsOf(width).findLosses(numbers, step, starts.data(), losses.data());
                if (first.empty()) first = losses;
                for (std::size_t k = 0; k < count; ++k) {
                    QCOMPARE(losses[k + 1].energy, first[k + 1].energy);
                    QCOMPARE(losses[k + 1].mayBeFree, first[k + 1].mayBeFree);
                    const double error = std::abs(losses[k + 1].energy - bodies[k].lost());
                    QVERIFY2(error < 1e-3 * bodies[k].scale(),
                             qPrintable(QString("round %1: %2").arg(round).arg(error)));
                }
            }
        }
    }
    void bodiesThatFlyFreelyAreReported() {
        std::vector<StartMotion> starts(3);
        std::vector<BodyMotion> motions(3);
        std::vector<BodyPose> poses(3);
        for (BodyMotion& motion : motions) motion.inverseMass = 1.0f;
        for (BodyPose& pose : poses) pose.inverseInertia = {1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f};
        motions[0].velocity = toFloat(kGravity / 60.0);
        motions[2].inverseMass = 0.0f;  // not dynamic
        motions[2].deltaPosition = Vec3f(1.0f);
        const SolverStep step{
            .motions = motions.data(), .poses = poses.data(), .dt = 1.0f / 60.0f, .gravity = toFloat(kGravity)};
        const std::vector<std::uint32_t> numbers{0, 1, 2};
        for (const SimdWidth width : availableSimdWidths()) {
            std::vector<BodyLoss> losses(3);
            kernelsOf(width).findLosses(numbers, step, starts.data(), losses.data());
            QVERIFY(losses[0].mayBeFree && !losses[1].mayBeFree && !losses[2].mayBeFree);
            QCOMPARE(losses[1].energy, 0.0f);  // it rests on something
            QCOMPARE(losses[2].energy, 0.0f);
        }
    }
};

RUBBLE_TEST(EnergyKernelsTest)
#include "EnergyKernelsTest.moc"
