#include "editor/panels/docks/ChangesPanel.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/BakedAssets.h"
#include "tests/support/editor/FailingWork.h"

#include <QListWidget>
#include <QTest>

using namespace rubble;

namespace {

/// The panel with the comparison of a box.
struct ChangesDesk {
    Document document{boxProject(UniformScatter{.count = 8})};
    Selection selection;
    Bakes bakes;
    StateComparison comparison{document, selection, bakes};
    ChangesPanel panel{comparison, selection, document};

    ChangesDesk() {
        selection.setAsset(document.project().assets[0].id);
        test::bakeAll(document.project(), bakes);
    }
    void begin(double depth) {
        Project earlier = document.project();
        earlier.assets[0].prism().depth = depth;
        comparison.begin(std::make_shared<const Project>(std::move(earlier)), "an earlier state");
    }
    QString firstRow() { return panel.list().count() > 0 ? panel.list().item(0)->text() : QString(); }
};

}  // namespace

class ChangesPanelTest : public QObject {
    Q_OBJECT
private slots:
    void changesAreListed() {
        ChangesDesk desk;
        desk.begin(0.5 * desk.document.project().assets[0].prism().depth);
        QCOMPARE(desk.firstRow(), "Comparing…");
        QTRY_VERIFY_WITH_TIMEOUT(desk.firstRow().contains("depth"), kPatience);
    }
    void comparisonThatFailsIsExplained() {
        ChangesDesk desk;
        desk.begin(-1.0);
        QTRY_VERIFY_WITH_TIMEOUT(desk.firstRow().contains("depth is -1"), kPatience);
        QCOMPARE(desk.panel.list().count(), 1);
        test::runOutOfMemory(desk.comparison);
        QTRY_VERIFY_WITH_TIMEOUT(desk.firstRow().startsWith(test::kOutOfMemory), kPatience);
    }
    /// Once, it was being compared for ever.
    void assetThatCannotBeBakedIsExplained() {
        ChangesDesk desk;
        const Asset& asset = desk.document.project().assets[0];
        desk.bakes.set(asset.id, std::make_shared<const BakedAsset>(
                                     BakedAsset{std::make_shared<const Asset>(asset),
                                                nullptr,
                                                Error{ErrorCode::Crossing, "The outline crosses itself."},
                                                {}}));
        desk.begin(1.0);
        QCOMPARE(desk.firstRow(), "The outline crosses itself.");
    }
};

RUBBLE_TEST_WITH(ChangesPanelTest, QApplication)
#include "ChangesPanelTest.moc"
