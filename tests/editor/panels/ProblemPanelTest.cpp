#include "editor/panels/ProblemPanel.h"

#include "tests/support/Combs.h"

#include <QTest>
#include <QToolButton>
#include <QTreeView>

using namespace rubble;

namespace {

constexpr int kPatience = 60000;  // ms, for baking on a busy machine

}  // namespace

class ProblemPanelTest : public QObject {
    Q_OBJECT
private slots:
    void aLongFixIsCancelledByItsButton() {
        Document document(test::combProject());
        Selection selection;
        Bakes bakes;
        const ProblemWatch watch(document, bakes);
        ProblemPanel panel(document, selection, watch);
        const auto asset = std::make_shared<const Asset>(document.project().assets[0]);
        bakes.set(2, std::make_shared<const BakedAsset>(
                         BakedAsset{.asset = asset, .bake = std::make_shared<const Bake>(*bake(*asset))}));
        QTRY_VERIFY_WITH_TIMEOUT(panel.model().rowCount() > 0, kPatience);
        panel.show();
        panel.view().selectAll();
        auto* cancel = panel.findChild<QToolButton*>("fix-cancel");
        QVERIFY(cancel->isHidden());
        QToolButton* cutApart = buttonNamed(panel, "Cut Apart");
        QVERIFY(cutApart->isVisible());

        QTest::mouseClick(cutApart, Qt::LeftButton);
        QVERIFY(cancel->isVisible() && cutApart->isHidden());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(cancel->isHidden() && cutApart->isVisible());
        QCOMPARE(document.undoStack().count(), 0);

        QTest::mouseClick(cutApart, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(cancel->isHidden(), kPatience);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.undoStack().text(0), QString("Cut Apart"));
    }

private:
    static QToolButton* buttonNamed(ProblemPanel& panel, const QString& text) {
        for (QToolButton* button : panel.findChildren<QToolButton*>()) {
            if (button->text() == text) return button;
        }
        return nullptr;
    }
};

QTEST_MAIN(ProblemPanelTest)
#include "ProblemPanelTest.moc"
