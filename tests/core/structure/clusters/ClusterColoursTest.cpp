#include "core/structure/clusters/ClusterColours.h"

#include "core/asset/project/FragmentColours.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"

#include <QTest>

using namespace rubble;

namespace {

std::vector<std::uint32_t> coloursOf(const Asset& asset) {
    std::vector<std::uint32_t> colours;
    for (const Colour& colour : clusterColours(asset, *bake(asset), 0)) colours.push_back(packed(colour));
    return colours;
}

}  // namespace

class ClusterColoursTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentsOfAClusterHaveOneColour() {
        const auto colours = coloursOf(test::clusteredRow({{0, {"3.0", "3.1"}}, {0, {"3.2", "3.3"}}}));
        QCOMPARE(colours.size(), std::size_t{8});
        QCOMPARE(colours[0], colours[1]);
        QCOMPARE(colours[2], colours[3]);
        QVERIFY(colours[0] != colours[2]);
        QCOMPARE(colours[4], packed(kUnclusteredColour));
        QVERIFY(colours[0] != colours[4] && colours[2] != colours[4]);
    }
    void deeperClustersAreLighterOrDarker() {
        const auto colours = coloursOf(
            test::clusteredRow({{0, {"3.0", "3.1", "3.2", "3.3"}}, {1, {"3.0", "3.1"}}, {1, {"3.2", "3.3"}}}));
        QCOMPARE(colours[0], colours[1]);
        QVERIFY(colours[1] != colours[2]);
        QCOMPARE(coloursOf(test::rowOfEight()), std::vector<std::uint32_t>(8, packed(kUnclusteredColour)));
    }
};

RUBBLE_TEST(ClusterColoursTest)
#include "ClusterColoursTest.moc"
