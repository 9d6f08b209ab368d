#include "core/physics/shape/Shape.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <limits>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A box between two corners.
Polytope boxBetween(Vec3 low, Vec3 high) {
    return extruded(std::vector<Vec2>{{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z,
                    high.z);
}

/// Two cubes of 1 m beside each other: together 2 x 1 x 1 m about the origin.
std::vector<Polytope> twoCubes() {
    return {boxBetween({-1.0, -0.5, -0.5}, {0.0, 0.5, 0.5}), boxBetween({0.0, -0.5, -0.5}, {1.0, 0.5, 0.5})};
}

}  // namespace

class ShapeTest : public QObject {
    Q_OBJECT
private slots:
    /// A needle of 1 m has moments (w² + w²) m / 12 and (1 + w²) m / 12: as they are down to 1 : 40, but not below
    /// about 1e-4 of their sum.
    void slenderShapesHaveALeastMoment() {
        for (const double width : {0.2, 0.025, 0.005, 1e-4, 1e-6}) {
            const std::shared_ptr<const Shape> shape = *makeShape(std::vector{boxOf({1.0, width, width})});
            const double mass = width * width, own = mass * 2.0 * width * width / 12.0;
            const Mat3& inertia = shape->inertia;
            if (width >= 0.025) QVERIFY(std::abs(inertia[0][0] - own) < 1e-9 * own);
            QVERIFY(inertia[0][0] >= 0.99e-4 * (inertia[0][0] + inertia[1][1] + inertia[2][2]));
            QVERIFY(std::abs(inertia[1][1] - mass * (1.0 + width * width) / 12.0) < 3e-4 * inertia[1][1]);
            QVERIFY(std::abs(shape->inverseInertia[0][0] * inertia[0][0] - 1.0) < 1e-9);
            QVERIFY(std::abs(shape->mass.inertia[0][0] - own) < 1e-9 * own);
        }
    }
    /// What is thinner than 1 : 100 rotates slower once it is a body of its own: by its angular momentum, in its axes.
    void slenderPartsKeepTheirAngularMomentum() {
        for (const double width : {0.2, 1e-4}) {
            const std::shared_ptr<const Shape> shape = *makeShape(std::vector{boxOf({1.0, width, width})});
            const Quat turned = glm::angleAxis(1.1, glm::normalize(Vec3(1.0, 2.0, -3.0)));
            const Vec3 own(900.0, 20.0, -5.0);
            const Vec3 spin = glm::conjugate(turned) * spinOfPart(*shape, turned, turned * own);
            const Vec3 difference = shape->inertia * spin - shape->mass.inertia * own;
            QVERIFY(glm::length(difference) < 1e-12 * glm::length(shape->mass.inertia * own));
            if (width == 0.2) QVERIFY(glm::length(spin - own) < 1e-12 * glm::length(own));
            QVERIFY(glm::dot(spin, shape->inertia * spin) <= (1.0 + 1e-12) * glm::dot(own, shape->mass.inertia * own));
        }
    }
    void measuresOfTwoCubes() {
        const std::shared_ptr<const Shape> shape = *makeShape(twoCubes());
        QCOMPARE(shape->hulls.size(), std::size_t{2});
        QVERIFY(std::abs(shape->mass.volume - 2.0) < 1e-12);
        QVERIFY(std::abs(shape->mass.inertia[0][0] - 2.0 / 12.0 * 2.0) < 1e-12);  // m (1² + 1²) / 12
        QVERIFY(std::abs(shape->mass.inertia[1][1] - 2.0 / 12.0 * 5.0) < 1e-12);  // m (2² + 1²) / 12
        QVERIFY(std::abs(shape->inverseInertia[1][1] - 1.2) < 1e-9);
        QVERIFY(std::abs(shape->boundingRadius - std::sqrt(1.5f)) < 1e-6f);
        QVERIFY(length(shape->extents - Vec3f(1.0f, 0.5f, 0.5f)) < 1e-6f);
        QCOMPARE(shape->minWidth, 1.0f);
    }
    void extentsAreThoseOfTheFartherSide() {
        MassProperties mass = massOf(boxOf(Vec3(2.0)));
        mass.centre = {0.5, 0.0, 0.0};
        const std::shared_ptr<const Shape> shape = *makeShape(std::vector{boxOf(Vec3(2.0))}, mass);
        QVERIFY(length(shape->extents - Vec3f(1.5f, 1.0f, 1.0f)) < 1e-6f);
    }
    void compoundSharesTheHullsOfItsParts() {
        const std::shared_ptr<const Shape> cube = *makeShape(std::vector{boxOf(Vec3(1.0))});
        const std::vector<CompoundPart> parts{{cube.get(), {-0.5, 0.0, 0.0}}, {cube.get(), {0.5, 0.0, 0.0}}};
        const std::shared_ptr<const Shape> exact = *makeShape(twoCubes());
        const auto shape = compoundShape(parts, exact->mass, cube);
        QVERIFY(shape.hasValue());
        QCOMPARE((*shape)->hulls.size(), std::size_t{2});
        QVERIFY((*shape)->hulls[0].hull == cube->hulls[0].hull && (*shape)->hulls[1].hull == cube->hulls[0].hull);
        QVERIFY(length((*shape)->hulls[1].offset - Vec3f(0.5f, 0.0f, 0.0f)) < 1e-6f);
        QVERIFY(length((*shape)->extents - exact->extents) < 1e-6f);
        QVERIFY((*shape)->boundingRadius >= exact->boundingRadius);
        QCOMPARE((*shape)->minWidth, 1.0f);
        QVERIFY((*shape)->inverseInertia == exact->inverseInertia);
    }
    void remainingHullsStayInPlace() {
        const std::shared_ptr<const Shape> whole = *makeShape(twoCubes());
        const std::shared_ptr<const Shape> shape = remainingShape(*whole, std::vector<std::uint32_t>{1});
        QCOMPARE(shape->hulls.size(), std::size_t{1});
        QVERIFY(shape->hulls[0].hull == whole->hulls[1].hull && shape->hulls[0].offset == whole->hulls[1].offset);
        QVERIFY(shape->owner == whole->owner);
        QVERIFY(shape->mass.centre == whole->mass.centre && shape->mass.volume == whole->mass.volume);
        QVERIFY(shape->inverseInertia == whole->inverseInertia);
        QCOMPARE(shape->boundingRadius, whole->boundingRadius);
        QVERIFY(shape->extents == whole->extents);
        QCOMPARE(shape->minWidth, whole->minWidth);
    }
    void compoundWithoutPartsIsRefused() {
        const auto shape = compoundShape({}, massOf(boxOf(Vec3(1.0))), nullptr);
        QVERIFY(!shape);
        QCOMPARE(shape.error().message, "A body needs at least one hull.");
    }
    void shapesWithoutHullsAreRefused() {
        const auto shape = makeShape(std::vector<Polytope>{}, massOf(boxOf(Vec3(1.0))));
        QVERIFY(!shape);
        QCOMPARE(shape.error().message, "A body needs at least one hull.");
    }
    void massPropertiesMustBePositiveAndFinite() {
        const MassProperties good = massOf(boxOf(Vec3(1.0)));
        const auto isRefused = [](const MassProperties& mass) {
            const auto shape = makeShape(std::vector{boxOf(Vec3(1.0))}, mass);
            return !shape && shape.error().code == ErrorCode::BadInput &&
                   shape.error().message == "The volume and inertia of a body must be positive and finite.";
        };
        QVERIFY(!isRefused(good));
        for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
            MassProperties mass = good;
            mass.volume = wrong;
            QVERIFY(isRefused(mass));
            for (int k = 0; k < 3; ++k) {
                mass = good;
                mass.inertia[k][k] = wrong;
                QVERIFY(isRefused(mass));
            }
        }
        MassProperties mass = good;
        mass.centre.y = std::nan("");
        QVERIFY(isRefused(mass));
        mass = good;
        mass.inertia[0][1] = mass.inertia[1][0] = 1.0;  // the determinant is negative
        QVERIFY(isRefused(mass));
    }
    void faultsOfHullsArePassedOn() {
        Polytope flat = boxOf(Vec3(1.0));
        flat.vertices.resize(3);
        const auto shape = makeShape(std::vector{flat}, massOf(boxOf(Vec3(1.0))));
        QVERIFY(!shape);
        QCOMPARE(shape.error().code, ErrorCode::Degenerate);
    }
};

RUBBLE_TEST(ShapeTest)
#include "ShapeTest.moc"
