#include "core/physics/state/VerifyBody.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <limits>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

BodyDefinition goodBody() { return {.shape = boxShape(Vec3(1.0))}; }

/// What is said of a definition with one change.
template <class Change>
std::string faultOf(const Change& change) {
    BodyDefinition definition = goodBody();
    change(definition);
    return verifyBodyDefinition(definition).value_or("");
}

}  // namespace

class VerifyBodyTest : public QObject {
    Q_OBJECT
private slots:
    void goodBodiesHaveNoFault() {
        QCOMPARE(verifyBodyDefinition(goodBody()).value_or(""), "");
        // The limits themselves are valid.
        QCOMPARE(faultOf([](BodyDefinition& body) {
                     body.pose.position = {kMaxCoordinate, -kMaxCoordinate, 0.0};
                     body.velocity.x = -kMaxSpeed;
                     body.angularVelocity.y = kMaxSpeed;
                     body.friction = body.linearDamping = body.angularDamping = 0.0;
                     body.restitution = 1.0;
                     body.pose.orientation = {1.0009, 0.0, 0.0, 0.0};
                 }),
                 "");
    }
    void coordinatesAreWithinTheLimitOnEveryAxis() {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double wrong : {1.0001, -1.0001, kInfinite, std::nan("")}) {
                Vec3 v(0.0);
                v[axis] = wrong;
                QVERIFY(!isWithin(v, 1.0));
            }
        }
        QVERIFY(isWithin(Vec3(1.0, -1.0, 0.0), 1.0));
    }
    void faultsAreNamed() {
        QCOMPARE(faultOf([](BodyDefinition& body) { body.shape = nullptr; }), "A body needs a shape.");
        QCOMPARE(faultOf([](BodyDefinition& body) { body.pose.position.z = 1.1e5; }),
                 "The position of a body must be within 100 km of the origin.");
        for (const double wrong : {0.998, 1.002, kInfinite, std::nan("")}) {
            QCOMPARE(faultOf([&](BodyDefinition& body) {
                         body.pose.orientation = {0.0, 0.0, 0.0, wrong};
                     }),
                     "The orientation of a body must be a quaternion of length 1.");
        }
        QCOMPARE(faultOf([](BodyDefinition& body) { body.velocity.y = 1.1e4; }),
                 "The velocity of a body must be below 10 km/s.");
        QCOMPARE(faultOf([](BodyDefinition& body) { body.angularVelocity.y = 1.1e4; }),
                 "The angular velocity of a body must be below 10,000 rad/s.");
        for (const double wrong : {0.0, -1.0, kInfinite, std::nan("")}) {
            QCOMPARE(faultOf([&](BodyDefinition& body) { body.density = wrong; }),
                     "The density of a body must be positive.");
        }
        for (const double wrong : {-0.1, kInfinite, std::nan("")}) {
            QCOMPARE(faultOf([&](BodyDefinition& body) { body.friction = wrong; }),
                     "The friction of a body must not be negative.");
            QCOMPARE(faultOf([&](BodyDefinition& body) { body.linearDamping = wrong; }),
                     "The damping of a body must not be negative.");
            QCOMPARE(faultOf([&](BodyDefinition& body) { body.angularDamping = wrong; }),
                     "The damping of a body must not be negative.");
        }
        for (const double wrong : {-0.1, 1.1, std::nan("")}) {
            QCOMPARE(faultOf([&](BodyDefinition& body) { body.restitution = wrong; }),
                     "The restitution of a body must lie between 0 and 1.");
        }
    }
    void massOfADynamicBodyIsWithinSinglePrecision() {
        const auto massive = [](BodyKind kind, double density) {
            return faultOf([&](BodyDefinition& body) {
                body.kind = kind;
                body.density = density;
            });
        };
        QVERIFY(massive(BodyKind::Dynamic, 2e37).ends_with("too small or too large for single precision."));
        QVERIFY(massive(BodyKind::Dynamic, 1e-38).ends_with("too small or too large for single precision."));
        QCOMPARE(massive(BodyKind::Static, 2e37), "");
        QCOMPARE(massive(BodyKind::Kinematic, 1e-38), "");
        QCOMPARE(massive(BodyKind::Dynamic, 1e30), "");
    }
    /// The inertia counts as the mass does: here its inverse is 12 · 10²⁰ / 10⁻¹⁸.
    void inertiaIsWithinSinglePrecision() {
        MassProperties mass = massOf(boxOf(Vec3(1.0)));
        mass.inertia = Mat3(1e-20);
        BodyDefinition body = goodBody();
        body.shape = *makeShape(std::vector{boxOf(Vec3(1.0))}, mass);
        body.density = 1e-18;
        QVERIFY(verifyBodyDefinition(body).has_value());
        body.density = 1e-15;
        QVERIFY(!verifyBodyDefinition(body).has_value());
    }
};

RUBBLE_TEST(VerifyBodyTest)
#include "VerifyBodyTest.moc"
