#include "editor/panels/docks/ProblemPanel.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Combs.h"
#include "tests/support/editor/FailingWork.h"

#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

using namespace rubble;

namespace {

/// The panel with the problems of an asset with narrow fragments.
struct CombDesk {
    Document document{test::combProject()};
    Selection selection;
    Bakes bakes;
    ProblemWatch watch{document, bakes};
    ProblemPanel panel{document, selection, watch};

    CombDesk() {
        const auto asset = std::make_shared<const Asset>(document.project().assets[0]);
        bakes.set(2, std::make_shared<const BakedAsset>(
                         BakedAsset{.asset = asset, .bake = std::make_shared<const Bake>(*bake(*asset))}));
    }
};

}  // namespace

class ProblemPanelTest : public QObject {
    Q_OBJECT
private slots:
    void cancelButtonStopsALongFix() {
        CombDesk desk;
        auto& [document, selection, bakes, watch, panel] = desk;
        QTRY_VERIFY_WITH_TIMEOUT(panel.view().model()->rowCount() > 0, kPatience);
        panel.show();
        panel.view().selectAll();
        auto* cancel = panel.findChild<QToolButton*>("fix-cancel");
        QVERIFY(cancel->isHidden());
        QToolButton* split = buttonNamed(panel, "Split Fragment");
        QVERIFY(split->isVisible());

        QTest::mouseClick(split, Qt::LeftButton);
        QVERIFY(cancel->isVisible() && split->isHidden());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(cancel->isHidden() && split->isVisible());
        QCOMPARE(document.undoStack().count(), 0);

        QTest::mouseClick(split, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(cancel->isHidden(), kPatience);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.undoStack().text(0), QString("Split Fragment"));
    }
    void searchThatFailsIsExplained() {
        CombDesk desk;
        auto& [document, selection, bakes, watch, panel] = desk;
        panel.show();
        const auto says = [&panel](const QString& text) {
            const QList<QLabel*> labels = panel.findChildren<QLabel*>();
            return std::ranges::any_of(
                labels, [&](QLabel* label) { return label->isVisible() && label->text().startsWith(text); });
        };
        QVERIFY(says("Looking for problems") && !says("No problems"));
        QTRY_VERIFY_WITH_TIMEOUT(panel.view().model()->rowCount() > 0, kPatience);
        test::runOutOfMemory(watch);
        QTRY_VERIFY_WITH_TIMEOUT(says(test::kOutOfMemory), kPatience);
        QVERIFY(says("Problems unknown") && !says("No problems"));
        test::failWith(watch, "The support cannot be computed.");
        QTRY_VERIFY_WITH_TIMEOUT(says("The support cannot be computed."), kPatience);
    }
    void descriptionIsShownInFull() {
        CombDesk desk;
        auto& [document, selection, bakes, watch, panel] = desk;
        QTRY_VERIFY_WITH_TIMEOUT(panel.view().model()->rowCount() > 0, kPatience);
        panel.resize(400, 300);
        panel.show();
        const auto* description = panel.findChild<QLabel*>("problem-description");
        QVERIFY(description->isHidden());
        panel.view().setCurrentIndex(panel.view().model()->index(0, 0));
        QVERIFY(description->isVisible());
        QCOMPARE(description->text(), panel.view().model()->index(0, ProblemModel::kText).data().toString());
        QCoreApplication::processEvents();
        QTRY_VERIFY(description->height() >= description->heightForWidth(description->width()));
    }

private:
    static QToolButton* buttonNamed(ProblemPanel& panel, const QString& text) {
        for (QToolButton* button : panel.findChildren<QToolButton*>()) {
            if (button->text() == text) return button;
        }
        return nullptr;
    }
};

RUBBLE_TEST_WITH(ProblemPanelTest, QApplication)
#include "ProblemPanelTest.moc"
