// Tests core/physics/solver/SoftContactKernels.h, core/physics/solver/SolverKernels.cpp,
// Tests core/physics/solver/ScalarKernels.cpp, core/physics/solver/FourLaneKernels.cpp and
// Tests core/physics/solver/EightLaneKernels.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

#include <algorithm>
#include <cstring>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The contact with an impulse of 0.5 N·s and a speed of -1/16 m/s, below those of impacts.
OneContact pressed(const SolverKernels& kernels, float separation) {
    OneContact contact({kUnderCentre});
    contact.cube().velocity.y = -0.0625f;
    contact.impulse(0) = 0.5f;
    contact.prepare(kernels, separation);
    return contact;
}

/// The impulse that solve() leaves of it, N·s.
float solved(OneContact contact, const SolverKernels& kernels) {
    contact.apply(kernels.solve);
    return contact.impulse(0);
}

/// Whether all words are equal, but for the sign of zeros, as in World::hash(): lanes that get no impulse may add one
/// of 0 N·s.
template <class T>
bool areSameBits(const T& a, const T& b) {
    constexpr std::uint32_t kSign = 1u << 31;
    std::array<std::uint32_t, sizeof(T) / 4> wordsA, wordsB;
    std::memcpy(wordsA.data(), &a, sizeof a);
    std::memcpy(wordsB.data(), &b, sizeof b);
    return std::equal(wordsA.begin(), wordsA.end(), wordsB.begin(), [](std::uint32_t one, std::uint32_t other) {
        return one == other || ((one | other) & ~kSign) == 0;
    });
}

}  // namespace

/// The terms of the equation, one by one, with the numbers of OneContact. Each test runs at all widths.
class SoftContactKernelsTest : public QObject {
    Q_OBJECT
private slots:
    /// m (α v + α β s) + γ λ = 2 (0.75 · -0.0625 - 0.75 · 32 · 0.01) + 0.25 · 0.5 = -0.44875.
    void overlapIsResolvedSoftly() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact = pressed(kernels, -0.01f);
            contact.apply(kernels.solve);
            QVERIFY(isClose(contact.impulse(0), 0.94875f));
            QVERIFY(isClose(contact.cube().velocity.y, -0.0625f + 0.44875f / 2.0f));
            QVERIFY(contact.motions[OneContact::kGround].velocity == Vec3f(0.0f));
        }
    }
    /// A metre of overlap is resolved at 3 m/s: 2 (0.75 · -0.0625 - 3) + 0.25 · 0.5 = -5.96875.
    void biasIsAtMostThePushOutSpeed() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        QVERIFY(isClose(solved(pressed(kernels, -1.0f), kernels), 0.5f + 5.96875f));
    }
    /// The bias moves the bodies apart, but leaves no speed: relax() takes it back.
    void relaxingRemovesTheBias() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact = pressed(kernels, -0.01f);
            contact.apply(kernels.solve);
            contact.apply(kernels.relax);
            QVERIFY(isClose(contact.cube().velocity.y, 0.0f));
            QVERIFY(isClose(contact.impulse(0), 0.625f));  // 0.5, and 2 · 0.0625 that stop the cube
            QVERIFY(isClose(contact.stepImpulse(0), 0.625f));
        }
    }
    /// With a stiffening of 50/m the impulse is released as a whole up to 20 mm, half of it at 30 mm, nothing from 40.
    void deepContactsAreRigid() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        const auto released = [&](float separation) {
            OneContact contact = pressed(kernels, separation), rigid = contact;
            contact.block.stiffening[0] = rigid.block.stiffening[0] = 50.0f;
            rigid.step.againstFixed.impulseScale = 0.0f;
            return solved(rigid, kernels) - solved(contact, kernels);
        };
        QVERIFY(isClose(released(-0.01f), 0.125f));
        QVERIFY(isClose(released(-0.02f), 0.125f));
        QVERIFY(isClose(released(-0.03f), 0.0625f));
        QVERIFY(isClose(released(-0.04f), 0.0f));
        QVERIFY(isClose(released(-0.05f), 0.0f));
    }
    /// Apart by 0.1 mm: the gap may close at s/h = 0.0256 m/s, and 2 (-0.0625 + 0.0256) = -0.0738.
    void gapMayCloseWithinTheSubStep() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        QVERIFY(isClose(solved(pressed(kernels, 0.0001f), kernels), 0.5738f));
    }
    /// A contact only pushes: 2 (-0.0625 + 2.56) is more than there is.
    void impulseDoesNotPull() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = pressed(kernels, 0.01f);
        contact.apply(kernels.solve);
        QCOMPARE(contact.impulse(0), 0.0f);
        QVERIFY(isClose(contact.cube().velocity.y, -0.0625f - 0.25f));
    }
    /// 2 (0.5 · -0.0625 - 0.5 · 16 · 0.01) + 0.5 · 0.5 = 0.0275.
    void contactsOfTwoBodiesAreSofter() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = pressed(kernels, -0.01f);
        contact.block.againstFixed[0] = 0.0f;
        QVERIFY(isClose(solved(contact, kernels), 0.5f - 0.0275f));
    }
    /// 2 (0.25 · -0.0625 - 0.25 · 32 · 0.01) + 0.125 · 0.5 = -0.12875.
    void sharedSoftnessReplacesThatOfOneManifold() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = pressed(kernels, -0.01f);
        contact.block.sharedMassScale[0] = 0.25f;
        contact.block.sharedImpulseScale[0] = 0.125f;
        QVERIFY(isClose(solved(contact, kernels), 0.62875f));
    }
    /// The displacement of the sub-steps so far counts: 10 mm of gap less 20 mm are an overlap of 10 mm.
    void separationFollowsTheDisplacement() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = pressed(kernels, 0.01f);
        contact.cube().deltaPosition.y = -0.02f;
        QVERIFY(isClose(solved(contact, kernels), 0.94875f));
    }
    /// A point beside the centre sinks where the cube rotates: by 0.25 · sin(0.04), to first order.
    void separationFollowsTheRotation() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        const auto impulseAt = [&](float x, float angle, float separation) {
            OneContact contact({Vec3f(x, 0.0f, 0.0f)});
            contact.prepare(kernels, separation);
            contact.impulse(0) = 0.5f;
            contact.cube().deltaRotation = Quatf{0.0f, 0.0f, std::sin(angle / 2.0f), std::cos(angle / 2.0f)};
            return solved(contact, kernels);
        };
        // Against the level contact whose gap is as much smaller; the arm to B's centre, 0.5 m, adds s · (1 - cos).
        const float drop = 0.25f * std::sin(0.04f) - 0.5f * (1.0f - std::cos(0.04f));
        QVERIFY(isClose(impulseAt(-0.25f, 0.04f, 0.0f), impulseAt(-0.25f, 0.0f, -drop)));
    }
    /// A point that is apart and has no impulse is left to the next sub-step, which measures its impact.
    void idlePointsAreNotRelaxed() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact({kUnderCentre});
        contact.cube().velocity.y = -0.0625f;
        contact.prepare(kernels, 0.00003f);
        contact.apply(kernels.relax);
        QCOMPARE(contact.impulse(0), 0.0f);
        QCOMPARE(contact.cube().velocity.y, -0.0625f);
        contact.separation(0) = 0.00001f;  // rounding
        contact.apply(kernels.relax);
        QVERIFY(contact.impulse(0) > 0.1f);
    }
    /// An impulse at one corner changes the speed at the others: 3 N·s stop the cube, half at each of two corners.
    void pointsAreCoupled() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact(kTwoPoints);
        contact.cube().velocity.y = -0.09f;
        contact.prepare(kernels, 0.0f);
        for (int round = 0; round < 40; ++round) contact.apply(kernels.relax);
        QVERIFY(isClose(contact.cube().velocity.y, 0.0f));
        QVERIFY(isClose(contact.cube().angularVelocity.z, 0.0f));
        QVERIFY(std::abs(contact.impulse(0) - 0.09f) < 1e-5f && std::abs(contact.impulse(1) - 0.09f) < 1e-5f);
    }
    /// The impulses of the last sub-step: 0.5 N·s up, and 0.25 N·s along the second tangent, -z, at the bottom.
    void warmStartAppliesTheImpulses() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact({kUnderCentre});
            contact.prepare(kernels, 0.0f);
            contact.impulse(0) = 0.5f;
            contact.block.frictionY[0] = 0.25f;
            contact.block.torsionalImpulse[0] = 0.125f;
            contact.apply(kernels.warmStart);
            QVERIFY(contact.cube().velocity == Vec3f(0.0f, 0.25f, -0.125f));
            // r x J = (0, -0.5, 0) x (0, 0, -0.25) = (0.125, 0, 0), times 3; the torsional impulse, times 3.
            QVERIFY(contact.cube().angularVelocity == Vec3f(0.375f, 0.375f, 0.0f));
        }
    }
    void allWidthsGiveTheSameBits() {
        Random random(7);
        for (int round = 0; round < 300; ++round) {
            const RandomContacts start(random);
            std::vector<RandomContacts> results;
            for (const SimdWidth width : availableSimdWidths()) {
                const SolverKernels& kernels = kernelsOf(width);
                RandomContacts& contacts = results.emplace_back(start);
                contacts.prepare(kernels);
                const std::array<std::uint32_t, 16> bodies{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
                kernels.integrateVelocities(bodies, contacts.step);
                for (const auto pass : {kernels.warmStart, kernels.solve}) pass({&contacts.block, 1}, contacts.step);
                kernels.integratePositions(bodies, contacts.step);
                for (const auto pass : {kernels.relax, kernels.restitute}) pass({&contacts.block, 1}, contacts.step);
                QVERIFY(areSameBits(contacts.block, results[0].block));
                QVERIFY(areSameBits(contacts.motions, results[0].motions));
                QCOMPARE(kernels.staleLanes(contacts.block, contacts.reference, contacts.step),
                         kernelsOf(SimdWidth::Scalar).staleLanes(contacts.block, contacts.reference, contacts.step));
            }
        }
    }
};

RUBBLE_TEST(SoftContactKernelsTest)
#include "SoftContactKernelsTest.moc"
