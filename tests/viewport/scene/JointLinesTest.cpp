#include "viewport/scene/JointLines.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

using namespace rubble;

namespace {

/// A face of 2 x 0.5 m, rotated from the xz plane.
MortarJoint rectangularJoint(Quat rotation) {
    const double area = 1.0;
    const Mat3 axes = glm::mat3_cast(rotation);
    Mat3 moments(0.0);
    moments[0][0] = area * 2.0 * 2.0 / 12.0;
    moments[2][2] = area * 0.5 * 0.5 / 12.0;
    return {.first = 1,
            .second = 2,
            .area = area,
            .centroid = {3.0, 1.0, 0.0},
            .normal = axes[1],
            .moments = axes * moments * glm::transpose(axes)};
}

}  // namespace

class JointLinesTest : public QObject {
    Q_OBJECT
private slots:
    void cornersAreThoseOfTheFace() {
        for (const Quat rotation : {Quat(1.0, 0.0, 0.0, 0.0), glm::angleAxis(0.7, glm::normalize(Vec3(1.0, 2.0, 3.0))),
                                    glm::angleAxis(2.5, Vec3(0.0, 1.0, 0.0))}) {
            const MortarJoint joint = rectangularJoint(rotation);
            for (const Vec3& corner : jointCorners(joint)) {
                const Vec3 local = glm::conjugate(rotation) * (corner - joint.centroid);
                QVERIFY(std::abs(std::abs(local.x) - 1.0) < 1e-12);
                QVERIFY(std::abs(local.y) < 1e-12);
                QVERIFY(std::abs(std::abs(local.z) - 0.25) < 1e-12);
            }
        }
    }
    void outlineIsClosed() {
        RenderScene scene;
        scene.origin = {3.0, 1.0, 0.0};
        const MortarJoint joint = rectangularJoint({1.0, 0.0, 0.0, 0.0});
        addJointLines(scene, {&joint, 1});
        QCOMPARE(scene.lines.size(), std::size_t{4});
        glm::vec3 sum(0.0f);
        double length = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(glm::vec3(scene.lines[k].to) == glm::vec3(scene.lines[(k + 1) % 4].from));
            sum += glm::vec3(scene.lines[k].from);
            length += glm::distance(glm::vec3(scene.lines[k].from), glm::vec3(scene.lines[k].to));
        }
        QVERIFY(glm::length(sum) < 1e-6f);  // relative to the scene's origin
        QVERIFY(std::abs(length - 5.0) < 1e-5);
    }
};

RUBBLE_TEST(JointLinesTest)
#include "JointLinesTest.moc"
