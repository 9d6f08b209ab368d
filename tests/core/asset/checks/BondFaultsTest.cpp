// Tests core/asset/checks/BondFaults.cpp, what core/asset/checks/VerifyProject.cpp checks of mortars, and
// core/asset/project/Bonding.cpp.
#include "core/asset/checks/BondFaults.h"

#include "core/asset/checks/VerifyProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/BondedProject.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace rubble;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

struct BondChange {
    std::function<void(Project&)> apply;
};

Bonding& bondsOf(Project& project) { return project.assets[0].bonding; }

}  // namespace
Q_DECLARE_METATYPE(BondChange)

class BondFaultsTest : public QObject {
    Q_OBJECT

    static void row(const char* sentence, const std::function<void(Project&)>& change) {
        QTest::newRow(sentence) << BondChange{change};
    }

private slots:
    void validBondsHaveNoFault() {
        QCOMPARE(verifyProject(bondedProject()).value_or("no fault"), std::string("no fault"));
        QVERIFY(!bondFault(Asset{}) && !faultOf(Mortar{}));
    }
    void equalBondsHaveEqualPictures() {
        const Bonding bonding = everyBonding("3");
        Bonding other = everyBonding("3");  // with a picture of its own
        QVERIFY(bonding == other);
        auto picture = std::make_shared<GreyImage>(*other.strengthImage->image);
        picture->grey[0] = 1;
        other.strengthImage->image = picture;
        QVERIFY(bonding != other);
        other.strengthImage->image = nullptr;
        QVERIFY(bonding != other);
    }
    void clustersAreSorted() {
        std::vector<FragmentCluster> clusters{{1, {"3.4", "3.1"}}, {0, {}}, {0, {"3.7"}}, {0, {"3.5", "3.6"}}};
        sortClusters(clusters);
        QCOMPARE(clusters, (std::vector<FragmentCluster>{{0, {"3.5", "3.6"}}, {0, {"3.7"}}, {1, {"3.1", "3.4"}}}));
    }
    void endsOfRangesAreAccepted() {
        Project project = bondedProject();
        Bonding& bonding = bondsOf(project);
        bonding.impulsePerArea = 1e-9;
        bonding.damageFrom = 1.0;
        bonding.span = bonding.collapseDelay = 0.0;
        bonding.minimumIsland = ~std::uint32_t{0};
        bonding.strokes = {{.strength = 0.0, .points = {{1e5, -1e5}}}};
        bonding.heightStrengths = {{.height = 0.0, .factor = 0.0}};
        bonding.strengthImage = StrengthImage{.darkest = 0.0, .brightest = 0.0, .image = nullptr};
        bonding.neverBreaks.clear();
        bonding.clusters = {{.level = 9, .fragments = {"3.1"}}};
        project.mortars[0] = {.id = project.mortars[0].id, .name = "all", .tolerance = 0.0, .leastArea = 0.0};
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string("no fault"));
    }
    void faultsOfAssetsAreNamed_data() {
        QTest::addColumn<BondChange>("change");
        row("Asset 2 \"box\": the impulse per area of bonds is 0, but it must be from 1e-09 to 1e+15.",
            [](Project& p) { bondsOf(p).impulsePerArea = 0.0; });
        row("Asset 2 \"box\": the radius of hits on bonds is 0, but it must be from 0.001 to 100000.",
            [](Project& p) { bondsOf(p).radius = 0.0; });
        row("Asset 2 \"box\": the load that leaves damage is 0, but it must be above 0 and at most 1.",
            [](Project& p) { bondsOf(p).damageFrom = 0.0; });
        row("Asset 2 \"box\": the span of bonds is -1, but it must be from 0 to 100000.",
            [](Project& p) { bondsOf(p).span = -1.0; });
        row("Asset 2 \"box\": the collapse delay is nan, but it must be from 0 to 100000.",
            [](Project& p) { bondsOf(p).collapseDelay = kNoNumber; });
        row("Asset 2 \"box\": the least island is 0, but it must be from 1 to 4294967295.",
            [](Project& p) { bondsOf(p).minimumIsland = 0; });
        row("Asset 2 \"box\": bond stroke 1: the bond strength is -1, but it must be from 0 to 1000000.",
            [](Project& p) { bondsOf(p).strokes[1].strength = -1.0; });
        row("Asset 2 \"box\": bond stroke 1: the brush radius is 0, but it must be from 0.00001 to 10000.",
            [](Project& p) { bondsOf(p).strokes[1].radius = 0.0; });
        row("Asset 2 \"box\": bond stroke 1 has no points, but it must have at least one.",
            [](Project& p) { bondsOf(p).strokes[1].points.clear(); });
        row("Asset 2 \"box\": bond stroke 1: the y of point 1 is nan, but it must be from -100000 to 100000.",
            [](Project& p) { bondsOf(p).strokes[1].points[1].y = kNoNumber; });
        row("Asset 2 \"box\": the height of a bond strength is -1, but it must be from 0 to 10000.",
            [](Project& p) { bondsOf(p).heightStrengths[0].height = -1.0; });
        row("Asset 2 \"box\": the bond strength at height 0.5 is -1, but it must be from 0 to 1000000.",
            [](Project& p) { bondsOf(p).heightStrengths[1].factor = -1.0; });
        row("Asset 2 \"box\": the bond strength at height 0.5 comes after that at height 0.5; heights must ascend.",
            [](Project& p) { bondsOf(p).heightStrengths[0].height = 0.5; });
        row("Asset 2 \"box\": the strength image: the bond strength where it is black is -1, but it must be from 0 to "
            "1000000.",
            [](Project& p) { bondsOf(p).strengthImage->darkest = -1.0; });
        row("Asset 2 \"box\": the strength image: the bond strength where it is white is nan, but it must be from 0 to "
            "1000000.",
            [](Project& p) { bondsOf(p).strengthImage->brightest = kNoNumber; });
        row("Asset 2 \"box\": the strength image: the image has 3 values for 2 x 2 pixels.", [](Project& p) {
            auto image = std::make_shared<GreyImage>(*bondsOf(p).strengthImage->image);
            image->grey.pop_back();
            bondsOf(p).strengthImage->image = image;
        });
        row("Asset 2 \"box\": \"3.x\" is not a fragment path.", [](Project& p) { bondsOf(p).neverBreaks[0] = "3.x"; });
        row("Asset 2 \"box\": fragment 3.4, which never breaks, comes after 3.4; paths must ascend.",
            [](Project& p) { bondsOf(p).neverBreaks[0] = "3.4"; });
        row("Asset 2 \"box\": cluster 1: the level of a cluster is 10, but it must be from 0 to 9.",
            [](Project& p) { bondsOf(p).clusters[1].level = 10; });
        row("Asset 2 \"box\": cluster 0 has no fragments, but it must have at least one.",
            [](Project& p) { bondsOf(p).clusters[0].fragments.clear(); });
        row("Asset 2 \"box\": cluster 0: \"3.x\" is not a fragment path.",
            [](Project& p) { bondsOf(p).clusters[0].fragments[0] = "3.x"; });
        row("Asset 2 \"box\": cluster 0: fragment 3.2 comes after 3.2; paths must ascend.",
            [](Project& p) { bondsOf(p).clusters[0].fragments[0] = "3.2"; });
        row("Asset 2 \"box\": cluster 0: fragments 3.1 and 3.2/4.0 have different parents.",
            [](Project& p) { bondsOf(p).clusters[0].fragments[1] = "3.2/4.0"; });
        row("Asset 2 \"box\": cluster 1: fragment 3.2 is in another cluster of level 0 already.",
            [](Project& p) { bondsOf(p).clusters[1].level = 0; });
        row("Asset 2 \"box\": cluster 1 is out of order; clusters must ascend by level, then by fragments.",
            [](Project& p) { std::swap(bondsOf(p).clusters[0], bondsOf(p).clusters[1]); });
        row("Asset 2 \"box\": the bond strength is -1, but it must be from 0 to 1000000.",
            [](Project& p) { p.assets[0].levels[0].bondStrength = -1.0; });
    }
    void faultsOfAssetsAreNamed() { changeIsReported(); }

    void faultsOfInstancesAndMortarsAreNamed_data() {
        QTest::addColumn<BondChange>("change");
        row("Instance 10 \"wall\": the bond strength is -1, but it must be from 0 to 1000000.",
            [](Project& p) { p.instances[0].bondStrength = -1.0; });
        row("Mortar 30 \"joints\": the widest joint is -1, but it must be from 0 to 1.",
            [](Project& p) { p.mortars[0].tolerance = -1.0; });
        row("Mortar 30 \"joints\": the least area is nan, but it must be from 0 to 100000000.",
            [](Project& p) { p.mortars[0].leastArea = kNoNumber; });
        row("Mortar 31 \"glue\": the impulse per area is 0, but it must be from 1e-09 to 1e+15.",
            [](Project& p) { p.mortars[1].impulsePerArea = 0.0; });
        row("Mortar 30 \"joints\" refers to instance 9, which does not exist.", [](Project& p) {
            p.mortars[0].instances = {9, 10};
        });
        row("Mortar 30 \"joints\": instance 10 comes after instance 11; ids must ascend.", [](Project& p) {
            p.mortars[0].instances = {11, 10};
        });
        row("Mortar 30 \"joints\": instance 10 comes after instance 10; ids must ascend.", [](Project& p) {
            p.mortars[0].instances = {10, 10};
        });
        row("Mortar 30 \"joints\" comes after the one with id 31; ids must ascend.",
            [](Project& p) { std::swap(p.mortars[0], p.mortars[1]); });
        row("Mortar 31 \"joints\" has a name that is already taken.", [](Project& p) { p.mortars[1].name = "joints"; });
        row("Mortar 30 has no name.", [](Project& p) { p.mortars[0].name.clear(); });
        row("Mortar 31 \"glue\" has an id that is not below the project's next id, 31.",
            [](Project& p) { p.nextId = 31; });
        row("Instance 11 \"pier\" and Mortar 11 \"joints\" have the same id.",
            [](Project& p) { p.mortars[0].id = 11; });
    }
    void faultsOfInstancesAndMortarsAreNamed() { changeIsReported(); }

private:
    void changeIsReported() {
        QFETCH(BondChange, change);
        Project project = bondedProject();
        change.apply(project);
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string(QTest::currentDataTag()));
    }
};

RUBBLE_TEST(BondFaultsTest)
#include "BondFaultsTest.moc"
