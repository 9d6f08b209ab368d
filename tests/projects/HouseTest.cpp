#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/geometry/hull/HullOverlap.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Resting.h"

#include <QTest>

#include <algorithm>
#include <map>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The seeds of an asset's first level on its outline.
std::vector<Vec2> seedsOfAsset(const Asset& asset) { return seedsOf(asset.pattern, asset.prism().outline)->positions; }

/// An instance with its body in its own frame. The house's prisms are convex.
struct Placed {
    const Instance* instance = nullptr;
    Polytope body;
};

std::vector<Placed> placedBodies(const Project& project) {
    std::vector<Placed> bodies;
    for (const Instance& instance : project.instances) {
        const Prism& prism = findAsset(project, instance.asset)->prism();
        bodies.push_back({&instance, extruded(prism.outline.outer, -prism.depth / 2.0, prism.depth / 2.0)});
    }
    return bodies;
}

std::string sentence(const Placed& first, const Placed& second, double depth) {
    return first.instance->name + " and " + second.instance->name + ": depth " + std::to_string(depth * 1e12) + "e-12";
}

bool isWall(const Project& project, const Instance& instance) {
    return findAsset(project, instance.asset)->name == "wall";
}

}  // namespace

/// projects/house.rubble is built by tests/support/asset/House.h; ProjectFilesTest compares the two.
class HouseTest : public QObject {
    Q_OBJECT
    const Project m_house = house();
    const std::vector<Placed> m_bodies = placedBodies(m_house);

private slots:
    void isAValidProjectOf77Bodies() {
        QCOMPARE(verifyProject(m_house).value_or(""), std::string());
        std::map<std::string, int> counts;
        for (const Instance& instance : m_house.instances) ++counts[findAsset(m_house, instance.asset)->name];
        QCOMPARE(counts, (std::map<std::string, int>{{"gable", 2}, {"roof", 4}, {"wall", 71}}));
    }
    void hasTheThesisDimensions() {
        const Ring& gable = findAsset(m_house, "gable")->prism().outline.outer;
        QCOMPARE(glm::distance(gable[0], gable[1]), 5.0);
        QVERIFY(std::abs(glm::distance(gable[1], gable[2]) - 2.89) < 1e-15);
        QVERIFY(std::abs(glm::distance(gable[2], gable[0]) - 2.89) < 1e-15);
        QCOMPARE(findAsset(m_house, "gable")->prism().depth, 0.5);
        QCOMPARE(boundsOf(findAsset(m_house, "wall")->prism().outline.outer).size(), Vec2(1.0, 1.0));
        QCOMPARE(findAsset(m_house, "wall")->prism().depth, 0.5);
        QCOMPARE(boundsOf(findAsset(m_house, "roof")->prism().outline.outer).size(), Vec2(3.5, 3.0));
        QCOMPARE(findAsset(m_house, "roof")->prism().depth, 0.25);
    }
    void largerAssetsHaveMoreSeeds() {
        const std::size_t wall = seedsOfAsset(*findAsset(m_house, "wall")).size();
        const std::size_t gable = seedsOfAsset(*findAsset(m_house, "gable")).size();
        const std::size_t roof = seedsOfAsset(*findAsset(m_house, "roof")).size();
        QVERIFY(wall < gable && gable < roof && roof < 10);
    }
    /// In the walls and gables not by a bit; the roof stands off, though not every axis sees the whole of kRoofGap.
    void noTwoBodiesOverlap() {
        for (std::size_t a = 0; a < m_bodies.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const Pose& first = m_bodies[a].instance->pose;
                const Pose& second = m_bodies[b].instance->pose;
                const double depth = hullOverlap(m_bodies[a].body, first, m_bodies[b].body, second).depth;
                const double gap = m_bodies[a].instance->name.starts_with("roof") ? kRoofGap / 2.0 : 0.0;
                QVERIFY2(depth <= -gap, sentence(m_bodies[a], m_bodies[b], depth).c_str());
            }
        }
    }
    void noBodyIsBelowTheGround() {
        for (const Placed& placed : m_bodies) {
            for (const Vec3& vertex : placed.body.vertices) {
                const Pose& pose = placed.instance->pose;
                QVERIFY2((pose.position + pose.orientation * vertex).y >= 0.0, placed.instance->name.c_str());
            }
        }
    }
    /// The centre of mass lies above what the body rests on, and not at its rim.
    void everyBodyIsSupported() {
        constexpr double kReach = 1e-9;
        for (const Placed& upper : m_bodies) {
            const Pose& pose = upper.instance->pose;
            std::vector<Vec2> resting;
            for (const Vec3& vertex : upper.body.vertices) {
                const Vec3 corner = pose.position + pose.orientation * vertex;
                if (corner.y <= m_house.ground.height + kReach) resting.emplace_back(corner.x, corner.z);
            }
            for (const Placed& lower : m_bodies) {
                if (&lower == &upper) continue;
                const auto points = restingPoints(upper.body, pose, lower.body, lower.instance->pose, kReach);
                resting.insert(resting.end(), points.begin(), points.end());
            }
            const Vec3 centre = pose.position + pose.orientation * massOf(upper.body).centre;
            const double depth = depthInside(resting, {centre.x, centre.z});
            QVERIFY2(depth > 0.2, (upper.instance->name + ": " + std::to_string(depth) + " m inside").c_str());
        }
    }
    /// An opening is open to its top: no block stands where the one below it was left out.
    void everyBlockRestsOnABlock() {
        const auto stands = [&](Vec3 position) {
            return std::ranges::any_of(m_house.instances, [&](const Instance& instance) {
                return isWall(m_house, instance) && instance.pose.position == position;
            });
        };
        for (const Instance& instance : m_house.instances) {
            const Vec3 position = instance.pose.position;
            if (!isWall(m_house, instance) || position.y == 0.5) continue;
            QVERIFY2(stands(position - Vec3(0.0, 1.0, 0.0)), instance.name.c_str());
        }
    }
    void everySeedGivesOneFragment() {
        for (const Asset& asset : m_house.assets) {
            const Result<Bake> baked = bake(asset);
            QVERIFY2(baked.hasValue(), asset.name.c_str());
            QCOMPARE(verifyBake(*baked, asset).value_or(""), std::string());
            QCOMPARE(std::size_t{baked->fragmentCount()}, seedsOfAsset(asset).size());
            QVERIFY(baked->diagnostics.empty());
        }
    }
    void roofIsHeldByFriction() {
        for (const Material& material : m_house.materials) QCOMPARE(material.friction, 0.8);
        QVERIFY(gableHeight() / (kGableBase / 2.0) < 0.8);
    }
};

RUBBLE_TEST(HouseTest)
#include "HouseTest.moc"
