#include "viewport/scene/MortarFaces.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "viewport/scene/AssetModel.h"

#include <QTest>

#include <algorithm>
#include <memory>

using namespace rubble;

namespace {

constexpr double kJoint = 0.01, kDepth = 0.12;  // m

Asset brickWall() {
    Asset wall{.id = 1, .name = "wall", .material = 1, .shape = Prism{{rectangle({0.0, 0.0}, {2.0, 1.0}), {}}, kDepth}};
    wall.pattern.layers = {{.id = 2, .parameters = BrickBond{.mortar = kJoint}}};
    return wall;
}

/// The area of a convex face, m².
double areaOf(const PlainFace& face) {
    Vec3 sum(0.0);
    for (std::size_t k = 2; k < face.corners.size(); ++k)
        sum += glm::cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
    return glm::dot(sum, face.normal) / 2.0;
}

}  // namespace

class MortarFacesTest : public QObject {
    Q_OBJECT
private slots:
    void mortarFillsTheJointsBehindTheFaces() {
        const Asset wall = brickWall();
        const Bake baked = bake(wall).value();
        const MortarFaces mortar(wall);
        QVERIFY(mortar.isThere());
        double front = 0.0;
        for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
            const BakedFragment brick = baked.fragment(k);
            const Vec3 offset = brick.solid.offset();
            Vec3 sum(0.0);
            for (const PlainFace& face : mortar.around(brick)) {
                QVERIFY(areaOf(face) > 0.0);  // wound as its normal says
                sum += areaOf(face) * face.normal;
                if (face.normal.z > 0.5) front += areaOf(face);
                for (const Vec3 corner : face.corners) {
                    const Vec3 at = corner + offset;
                    const double inside = std::min({at.x, 2.0 - at.x, at.y, 1.0 - at.y});
                    QVERIFY(inside > 0.2 * kJoint && std::abs(at.z) < kDepth / 2.0 - 0.2 * kJoint);
                }
            }
            QVERIFY(glm::length(sum) < 1e-9);  // closed
        }
        QVERIFY2(front > 1.95 && front < 2.0, std::to_string(front).c_str());  // without gaps
    }
    void patternsWithoutJointsHaveNone() {
        Asset wall = brickWall();
        wall.pattern.layers = {{.id = 2, .parameters = UniformScatter{}}};
        wall.shaping.gap = kJoint;
        QVERIFY(!MortarFaces(wall).isThere());
        QVERIFY(MortarFaces(wall).around(bake(wall)->fragment(0)).empty());
    }
    void piecesThatAreNotConvexHaveMortar() {
        Asset wall = brickWall();
        wall.prism().outline.holes = {rectangle({0.7, 0.3}, {1.3, 0.7})};
        std::ranges::reverse(wall.prism().outline.holes[0]);
        const Bake baked = bake(wall).value();
        const MortarFaces mortar(wall);
        bool hasOther = false;
        for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
            const BakedFragment brick = baked.fragment(k);
            hasOther = hasOther || !isConvex(brick.solid.extruded()->cell().outer);
            const std::vector<PlainFace> faces = mortar.around(brick);
            QVERIFY(!faces.empty());
            for (const PlainFace& face : faces) QVERIFY(areaOf(face) > 0.0);
        }
        QVERIFY(hasOther);
    }
    void wholeWallsHaveTheirJointsInPlay() {
        const Asset wall = brickWall();
        const auto baked = std::make_shared<const Bake>(bake(wall).value());
        const AssetModel model = playModelOf(wall, baked, {});
        const auto isMortarOf = [](std::uint32_t solid) {
            return [solid](const SceneVertex& vertex) {
                return vertex.solid == solid && vertex.side == VertexSide::Mortar;
            };
        };
        const std::vector<SceneVertex>& vertices = model.geometry->vertices;
        const auto ofWhole = std::ranges::count_if(vertices, isMortarOf(0));
        std::ptrdiff_t ofBricks = 0;
        for (std::uint32_t k = 1; k <= baked->fragmentCount(); ++k)
            ofBricks += std::ranges::count_if(vertices, isMortarOf(k));
        QVERIFY(ofWhole > 0);
        QCOMPARE(ofWhole, ofBricks);
    }
};

RUBBLE_TEST(MortarFacesTest)
#include "MortarFacesTest.moc"
