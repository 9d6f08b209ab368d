#include "editor/commands/ClusterEdits.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"
#include "tests/support/editor/EditedProject.h"

#include <QCoreApplication>

using namespace rubble;

namespace {

using ClusterList = std::vector<FragmentCluster>;

/// A row of eight fragments with clusters, and a selection of some of them.
struct EditedRow {
    Asset asset;
    Bake baked = *bake(asset);

    explicit EditedRow(ClusterList clusters = {}) : asset(test::clusteredRow(std::move(clusters))) {}

    static FragmentSelection selection(std::initializer_list<std::uint32_t> seeds) {
        FragmentSelection selected;
        for (const std::uint32_t seed : seeds) selected.seeds.insert({3, seed});
        return selected;
    }
    /// The clusters after a command; those before, if it is refused, whose sentence is kept.
    ClusterList after(ClusterCommand command, std::initializer_list<std::uint32_t> seeds, std::uint32_t level = 0) {
        Project project = boxProject(UniformScatter{});
        project.assets = {asset};
        const Result<Edit> edit = clusterEdit(asset, baked, selection(seeds), command, level);
        refusal = edit ? QString() : QString::fromStdString(edit.error().message);
        if (!edit) return asset.bonding.clusters;
        text = edit->text;
        const Project edited = test::editedProject(project, *edit);
        if (verifyProject(edited)) qFatal("%s", verifyProject(edited)->c_str());
        return edited.assets[0].bonding.clusters;
    }
    QString refusal, text;
};

}  // namespace

class ClusterEditsTest : public QObject {
    Q_OBJECT
private slots:
    void clustersAreMadeOfTheSelection() {
        EditedRow row;
        QCOMPARE(row.after(ClusterCommand::Make, {1, 2, 4}), (ClusterList{{0, {"3.1", "3.2", "3.4"}}}));
        QCOMPARE(row.text, QString("Make Cluster"));
        QCOMPARE(row.after(ClusterCommand::Make, {5, 6}, 3), (ClusterList{{3, {"3.5", "3.6"}}}));
        row.after(ClusterCommand::Make, {5});
        QCOMPARE(row.refusal, QString("One fragment is selected. A cluster has two at least."));
        row.after(ClusterCommand::Make, {});
        QCOMPARE(row.refusal, QString("No fragment is selected. Select fragments first."));
    }
    void clustersStayWithinCoarserOnes() {
        EditedRow row({{0, {"3.0", "3.1", "3.2"}}, {0, {"3.3", "3.4"}}});
        QCOMPARE(row.after(ClusterCommand::Make, {0, 1}, 1).size(), std::size_t{3});
        row.after(ClusterCommand::Make, {2, 3}, 1);
        QCOMPARE(row.refusal, QString("The selected fragments are in different coarser clusters. Select fragments of "
                                      "one of them."));
        EditedRow deep({{0, {"3.0", "3.1"}}, {0, {"3.2", "3.3"}}, {1, {"3.0", "3.1"}}, {1, {"3.2", "3.3"}}});
        deep.after(ClusterCommand::Merge, {0, 3}, 1);
        QCOMPARE(deep.refusal, QString("The selected clusters are in different coarser clusters. Merge these first."));
    }
    void clustersAreChanged() {
        EditedRow row({{0, {"3.1", "3.2"}}, {0, {"3.4", "3.5", "3.6", "3.7"}}});
        QCOMPARE(row.after(ClusterCommand::Grow, {1}),
                 (ClusterList{{0, {"3.0", "3.1", "3.2", "3.3"}}, {0, {"3.4", "3.5", "3.6", "3.7"}}}));
        QCOMPARE(row.text, QString("Grow Cluster"));
        QCOMPARE(row.after(ClusterCommand::Merge, {1, 4}),
                 (ClusterList{{0, {"3.1", "3.2", "3.4", "3.5", "3.6", "3.7"}}}));
        QCOMPARE(row.text, QString("Merge Clusters"));
        QCOMPARE(row.after(ClusterCommand::Split, {7}),
                 (ClusterList{{0, {"3.1", "3.2"}}, {0, {"3.4", "3.5"}}, {0, {"3.6", "3.7"}}}));
        QCOMPARE(row.text, QString("Split Clusters"));
        QCOMPARE(row.after(ClusterCommand::Remove, {1, 7}), (ClusterList{{0, {"3.4", "3.5", "3.6"}}}));
        QCOMPARE(row.text, QString("Remove from Clusters"));
    }
    void commandsThatDoNotApplyAreRefused() {
        EditedRow row({{0, {"3.0", "3.1", "3.2", "3.3", "3.4", "3.5", "3.6", "3.7"}}});
        for (const ClusterCommand command :
             {ClusterCommand::Grow, ClusterCommand::Merge, ClusterCommand::Split, ClusterCommand::Remove}) {
            row.after(command, {0, 1}, 2);
            QCOMPARE(row.refusal, QString("None of the selected fragments is in a cluster of level 2."));
        }
        row.after(ClusterCommand::Grow, {0});
        QCOMPARE(row.refusal, QString("The clusters have no neighbours that are in no other cluster."));
        row.after(ClusterCommand::Merge, {0, 7});
        QCOMPARE(row.refusal,
                 QString("The selected fragments are in one cluster. Select fragments of the clusters to merge."));
    }
    void proposalsAndClearing() {
        const EditedRow row({{1, {"3.0", "3.1"}}});
        Project project = boxProject(UniformScatter{});
        project.assets = {row.asset};
        const Result<Edit> proposed = proposeClusters(row.asset, row.baked, {}, 0, {.value = 2});
        QVERIFY(proposed);
        QCOMPARE(proposed->text, QString("Propose Clusters"));
        const Project edited = test::editedProject(project, *proposed);
        QCOMPARE(edited.assets[0].bonding.clusters.size(), std::size_t{3});
        const std::optional<Edit> cleared = clearClusters(edited.assets[0], {}, 0);
        QCOMPARE(test::editedProject(edited, *cleared).assets[0].bonding.clusters, row.asset.bonding.clusters);
        QVERIFY(!clearClusters(row.asset, {}, 0) && !clearClusters(row.asset, "3.1", 1));
        const Result<Edit> none = proposeClusters(row.asset, row.baked, "3.1", 0, {});
        QVERIFY(!none);
        QCOMPARE(none.error().message, std::string("There are fewer than two fragments to put into clusters."));
    }
    void clustersCanBeSelected() {
        const EditedRow row;
        QVERIFY(selectionOfCluster(row.baked, {0, {"3.1", "3.4", "3.99"}}, {}) == EditedRow::selection({1, 4}));
    }
};

RUBBLE_TEST_WITH(ClusterEditsTest, QCoreApplication)
#include "ClusterEditsTest.moc"
