// Tests editor/actions/ClusterActions.cpp, editor/dialogs/ClusterDialog.cpp and
// editor/panels/inspector/ClusterSection.cpp.
#include "editor/panels/inspector/ClusterSection.h"

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/dialogs/ClusterDialog.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"
#include "tests/support/editor/EditorStory.h"

#include <QComboBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>
#include <QTreeWidget>

using namespace rubble;

namespace {

Project rowProject() {
    Project project = boxProject(UniformScatter{});
    project.assets = {test::rowOfEight()};
    return project;
}

using ClusterList = std::vector<FragmentCluster>;

}  // namespace

/// Making and changing clusters by the menu and in the inspector.
class ClusterStoryTest : public EditorStory {
    Q_OBJECT

    const ClusterList& clusters() { return project().assets[0].bonding.clusters; }
    ClusterSection& section() { return *window().findChild<ClusterSection*>(); }
    QTreeWidget& list() { return *section().findChild<QTreeWidget*>(); }
    void select(std::initializer_list<std::uint32_t> seeds) {
        Selection::Seeds all;
        for (const std::uint32_t seed : seeds) all.insert({3, seed});
        selection().setSeeds(all);
    }
    QPushButton& button(const QString& text) {
        for (QPushButton* button : section().findChildren<QPushButton*>()) {
            if (button->text() == text) return *button;
        }
        qFatal("There is no button \"%s\".", qPrintable(text));
    }
    NumberField& field(const QString& name) {
        for (NumberField* field : section().findChildren<NumberField*>()) {
            if (field->accessibleName() == name) return *field;
        }
        qFatal("There is no field \"%s\".", qPrintable(name));
    }
    void type(NumberField& field, const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

private slots:
    void init() {
        openBaked(rowProject());
        selection().setAsset(2);
        canvas().setFocus();
    }
    void cleanup() { close(); }

    void menuMakesAndChangesClusters() {
        QVERIFY(!action("cluster-make")->isEnabled() && action("cluster-propose")->isEnabled());
        QCOMPARE(action("cluster-make")->statusTip(), QString("Select fragments first"));
        select({1, 2});
        QVERIFY(action("cluster-make")->isEnabled());
        action("cluster-make")->trigger();
        QCOMPARE(clusters(), (ClusterList{{0, {"3.1", "3.2"}}}));
        action("cluster-grow")->trigger();
        QCOMPARE(clusters(), (ClusterList{{0, {"3.0", "3.1", "3.2", "3.3"}}}));
        action("cluster-split")->trigger();
        QCOMPARE(clusters(), (ClusterList{{0, {"3.0", "3.1"}}, {0, {"3.2", "3.3"}}}));
        action("cluster-merge")->trigger();
        QCOMPARE(clusters(), (ClusterList{{0, {"3.0", "3.1", "3.2", "3.3"}}}));
        select({3});
        action("cluster-remove")->trigger();
        QCOMPARE(clusters(), (ClusterList{{0, {"3.0", "3.1", "3.2"}}}));
        action("cluster-remove")->trigger();
        QCOMPARE(window().statusBar()->currentMessage(),
                 QString("None of the selected fragments is in a cluster of level 0."));
        QCOMPARE(stack().count(), 5);
        while (stack().canUndo()) stack().undo();
        QCOMPARE(text(), m_before);
    }
    void dialogProposesClusters() {
        QTimer::singleShot(0, this, [] {
            auto* dialog = qobject_cast<ClusterDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            dialog->findChild<QComboBox*>()->setCurrentIndex(1);
            const QList<NumberField*> fields = dialog->findChildren<NumberField*>();
            fields[0]->setValue(4.0);
            fields[1]->setValue(2.0);
            QTest::keyClick(dialog, Qt::Key_Return);  // the button that proposes is the default one
        });
        action("cluster-propose")->trigger();
        QCOMPARE(clusters(), (ClusterList{{2, {"3.0", "3.1", "3.2", "3.3"}}, {2, {"3.4", "3.5", "3.6", "3.7"}}}));
        QCOMPARE(selection().clusterLevel(), 2u);
    }
    void wholeAssetsHaveNoClusters() {
        Asset asset = project().assets[0];
        asset.breakAs = BreakAs::Whole;
        window().workspace().document().push(Edit{.text = "Whole", .replacements = {Replacement<Asset>{2, asset}}});
        select({1, 2});
        QVERIFY(!action("cluster-make")->isEnabled() && !action("cluster-propose")->isEnabled());
        QVERIFY(action("cluster-make")->statusTip().startsWith("Only assets that break as bonded have clusters"));
        QVERIFY(!section().isVisibleTo(section().parentWidget()));
    }
    void inspectorListsAndEditsClusters() {
        QVERIFY(section().isVisibleTo(section().parentWidget()));
        type(field("Proposed value"), "2");
        button("Propose").click();
        QCOMPARE(clusters().size(), std::size_t{2});
        type(field("Cluster level"), "1");
        QCOMPARE(selection().clusterLevel(), 1u);
        type(field("Proposed value"), "4");
        button("Propose").click();
        QCOMPARE(clusters().size(), std::size_t{6});
        QCOMPARE(list().topLevelItemCount(), 2);
        QCOMPARE(list().topLevelItem(1)->text(0), QString("Level 1"));
        QCOMPARE(list().topLevelItem(1)->text(1), QString("4 clusters"));
        QCOMPARE(list().topLevelItem(0)->child(1)->text(0), QString("Cluster 2"));
        QCOMPARE(list().topLevelItem(0)->child(1)->text(1), QString("4"));
        QVERIFY(!button("Merge").isEnabled());
        list().setCurrentItem(list().topLevelItem(0)->child(0));
        QCOMPARE(selection().clusterLevel(), 0u);
        QCOMPARE(selection().seeds().size(), std::size_t{4});
        QVERIFY(button("Merge").isEnabled());
        list().topLevelItem(0)->child(1)->setSelected(true);
        QCOMPARE(selection().seeds().size(), std::size_t{8});
        button("Merge").click();
        QCOMPARE(clusters().size(), std::size_t{5});
        button("Make").click();
        QVERIFY(button("Clear").isEnabled());
        button("Clear").click();
        QCOMPARE(clusters().size(), std::size_t{4});
        QVERIFY(!button("Clear").isEnabled());
        while (stack().canUndo()) stack().undo();
        QCOMPARE(text(), m_before);
        QCOMPARE(list().topLevelItemCount(), 0);
    }
    void canvasColoursClusters() {
        const auto colour = [this](double x) {
            const QImage picture = canvas().grab().toImage();
            return picture.pixelColor(pixels({x, 0.8}) * picture.devicePixelRatio());
        };
        const QColor edge = canvasColours(canvas().palette()).cellEdge;
        CanvasOverlays overlays = canvas().overlays();
        overlays.hasGrid = false;
        overlays.colouring = CellColouring::Cluster;
        canvas().setOverlays(overlays);
        const QColor none = colour(0.5);
        QCOMPARE(colour(3.5), none);
        select({0, 1});
        action("cluster-make")->trigger();
        select({});
        QCOMPARE(colour(3.5), none);
        QVERIFY(colour(0.5) != none);
        QCOMPARE(colour(0.5), colour(1.5));
        const double pixel = 1.0 / canvas().view().scale;  // m
        const auto edgeWidth = [&](double x) {             // of the line there, in whole pixels
            int width = 0;
            for (int k = -4; k <= 4; ++k) width += colour(x + k * pixel) == edge ? 1 : 0;
            return width;
        };
        QVERIFY2(edgeWidth(2.0) >= 2 && edgeWidth(3.0) < 2, QByteArray::number(edgeWidth(2.0)));
        stack().undo();
        QCOMPARE(colour(0.5), none);
    }
};

RUBBLE_TEST_WITH(ClusterStoryTest, QApplication)
#include "ClusterStoryTest.moc"
