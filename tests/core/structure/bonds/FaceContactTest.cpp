#include "core/structure/bonds/FaceContact.h"

#include "tests/support/Closeness.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/PlacedBoxes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;
using namespace rubble::test;

namespace {

const Polytope kCube = boxBetween({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
constexpr double kJoint = 0.005;  // m

Pose turnedAboutX(double degrees, Vec3 position = Vec3{0.0}) {
    const double half = degrees * std::numbers::pi / 360.0;
    return {position, Quat(std::cos(half), std::sin(half), 0.0, 0.0)};
}

bool areNear(const Mat3& a, const Mat3& b, double distance) {
    return isWithinDistance(a[0], b[0], distance) && isWithinDistance(a[1], b[1], distance) &&
           isWithinDistance(a[2], b[2], distance);
}

}  // namespace

class FaceContactTest : public QObject {
    Q_OBJECT
private slots:
    // On the cube's side x = 1 lies a box, over y from 0.5 to 1 and z from 0.25 to 1.
    void offsetBoxesShareARectangle() {
        const auto contact = faceContact(kCube, boxBetween({1.0, 0.5, 0.25}, {3.0, 2.0, 4.0}), kJoint, 0.0);
        QVERIFY(contact);
        QVERIFY(isNear(contact->area, 0.5 * 0.75));
        QVERIFY(isWithinDistance(contact->centroid, {1.0, 0.75, 0.625}, 1e-12));
        QVERIFY(isWithinDistance(contact->normal, {1.0, 0.0, 0.0}, 1e-12));
        Mat3 moments{0.0};
        moments[1].y = 0.375 * 0.5 * 0.5 / 12.0;  // area * side² / 12
        moments[2].z = 0.375 * 0.75 * 0.75 / 12.0;
        QVERIFY(areNear(contact->moments, moments, 1e-12));
    }
    void gapsUpToTheToleranceAreBridged() {
        const auto across = [](double gap) {
            return faceContact(kCube, boxBetween({1.0 + gap, 0.0, 0.0}, {2.0, 1.0, 1.0}), kJoint, 0.0);
        };
        QVERIFY(across(0.0049));
        QVERIFY(isWithinDistance(across(0.004)->centroid, {1.002, 0.5, 0.5}, 1e-12));  // in the middle of the joint
        QVERIFY(!across(0.0051));
        QVERIFY(across(-0.0049));  // a little inside each other
        QVERIFY(!across(-0.0051));
        QVERIFY(!across(1.0));
    }
    void smallContactsAreNone() {
        const Polytope beside = boxBetween({1.0, 0.9, 0.0}, {2.0, 2.0, 1.0});  // on 0.1 m²
        QVERIFY(faceContact(kCube, beside, kJoint, 0.0999));
        QVERIFY(!faceContact(kCube, beside, kJoint, 0.1001));
        QVERIFY(!faceContact(kCube, boxBetween({1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}), kJoint, 0.0));  // along an edge
        QVERIFY(!faceContact(kCube, boxBetween({1.0, 1.1, 0.0}, {2.0, 2.0, 1.0}), kJoint, 0.0));
    }
    // A square of the same size, turned by 45 degrees in the plane: what is left is a regular octagon.
    void turnedSquaresShareAnOctagon() {
        const Pose turn{{0.5, 0.5, 1.5},
                        Quat(std::cos(std::numbers::pi / 8), 0.0, 0.0, std::sin(std::numbers::pi / 8))};
        const Polytope turned = placed(boxBetween({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), turn);
        const auto contact = faceContact(kCube, turned, kJoint, 0.0);
        QVERIFY(contact);
        QVERIFY(isNear(contact->area, 2.0 * (std::sqrt(2.0) - 1.0)));  // 2 tan(22.5°) a², a: 1 m between sides
        QVERIFY(isWithinDistance(contact->centroid, {0.5, 0.5, 1.0}, 1e-12));
        QVERIFY(isWithinDistance(contact->normal, {0.0, 0.0, 1.0}, 1e-12));
        QVERIFY(isNear(contact->moments[0].x, contact->moments[1].y));
    }
    void facesWithinOneDegreeLieAgainstEachOther() {
        const Polytope above = boxBetween({-0.5, -0.5, 0.0}, {0.5, 0.5, 1.0});
        QVERIFY(faceContact(kCube, placed(above, turnedAboutX(0.99, {0.5, 0.5, 1.0})), kJoint, 0.0));
        QVERIFY(!faceContact(kCube, placed(above, turnedAboutX(1.01, {0.5, 0.5, 1.0})), kJoint, 0.0));
        QVERIFY(!faceContact(kCube, placed(above, turnedAboutX(45.0, {0.5, 0.5, 1.0})), kJoint, 0.0));
    }
    void farSidesOfThinPlatesDoNotCount() {
        const Polytope plate = boxBetween({0.0, 0.0, 0.0}, {1.0, 1.0, 0.001}),
                       above = boxBetween({0.0, 0.0, 0.001}, {1.0, 1.0, 0.002});
        const auto contact = faceContact(plate, above, kJoint, 0.0);
        QVERIFY(contact);
        QVERIFY(isNear(contact->area, 1.0));
        QVERIFY(isWithinDistance(contact->normal, {0.0, 0.0, 1.0}, 1e-12));
    }
    // The roof of a prism breaks by less than a degree; both halves lie under the box.
    void facetsOfOneSolidAreSummed() {
        const Ring roof{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.999}, {1.0, 1.0}, {0.0, 0.999}};
        const auto contact =
            faceContact(extruded(roof, 0.0, 1.0), boxBetween({0.0, 1.0, 0.0}, {2.0, 2.0, 1.0}), kJoint, 0.0);
        QVERIFY(contact);
        QVERIFY(isNear(contact->area, 2.0, 1e-5));
        QVERIFY(isWithinDistance(contact->normal, {0.0, 1.0, 0.0}, 1e-9));
        QVERIFY(isNear(contact->moments[0].x, 2.0 * 4.0 / 12.0, 1e-5));  // of 2 m x 1 m
        QVERIFY(isNear(contact->moments[2].z, 2.0 * 1.0 / 12.0, 1e-5));
    }
    void contactsAreSymmetricAndMoveWithTheirSolids() {
        int found = 0;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            const double gap = random.between(-0.006, 0.006);
            const Vec3 corner{1.0 + gap, random.between(-0.5, 0.9), random.between(-0.5, 0.9)};
            const Polytope other = boxBetween(corner, corner + Vec3{random.between(0.1, 2.0)});
            const auto contact = faceContact(kCube, other, kJoint, 1e-6);
            const Pose pose = randomPose(random);
            const auto moved = faceContact(placed(kCube, pose), placed(other, pose), kJoint, 1e-6);
            const auto swapped = faceContact(placed(other, pose), placed(kCube, pose), kJoint, 1e-6);
            QVERIFY2(contact.has_value() == moved.has_value() && contact.has_value() == swapped.has_value(),
                     qPrintable(faultOfSeed(seed, "a contact is missing")));
            if (!contact) continue;
            ++found;
            const Mat3 turn = glm::mat3_cast(pose.orientation);
            const Vec3 centroid = pose.position + turn * contact->centroid;
            const Mat3 moments = turn * contact->moments * glm::transpose(turn);
            const bool isSame = std::abs(moved->area - contact->area) <= 1e-12 &&
                                std::abs(swapped->area - contact->area) <= 1e-12 &&
                                isWithinDistance(moved->centroid, centroid, 1e-11) &&
                                isWithinDistance(swapped->centroid, centroid, 1e-11) &&
                                isWithinDistance(moved->normal, turn * contact->normal, 1e-12) &&
                                isWithinDistance(swapped->normal, -(turn * contact->normal), 1e-12) &&
                                areNear(moved->moments, moments, 1e-12) && areNear(swapped->moments, moments, 1e-12);
            QVERIFY2(isSame, qPrintable(faultOfSeed(seed, "the contact differs")));
        }
        QVERIFY(found > 500);
    }
    void sumsAreByTheParallelAxisTheorem() {
        Mat3 square{0.0};
        square[0].x = square[1].y = 1.0 / 12.0;
        const FaceContact left{1.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, square},
            right{1.0, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, square};
        const auto both = combinedContact(std::vector{left, right});
        QCOMPARE(both->area, 2.0);
        QCOMPARE(both->centroid, Vec3(0.5, 0.0, 0.0));
        QVERIFY(isNear(both->moments[0].x, 8.0 / 12.0));  // a rectangle of 2 m x 1 m
        QVERIFY(isNear(both->moments[1].y, 2.0 / 12.0));
        QVERIFY(!combinedContact({}));
        FaceContact back = right;
        back.normal = -back.normal;
        QCOMPARE(combinedContact(std::vector{left, back})->normal, left.normal);
    }
};

RUBBLE_TEST(FaceContactTest)
#include "FaceContactTest.moc"
