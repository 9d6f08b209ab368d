#include "editor/widgets/ComboBox.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QSignalSpy>

#include <memory>

using namespace rubble;

class ComboBoxTest : public QObject {
    Q_OBJECT
private slots:
    void storedIndexIsLimitedToTheItems() {
        const std::unique_ptr<QComboBox> box(comboBox({"metres", "feet"}, "Unit"));
        QCOMPARE(box->toolTip(), "Unit");
        restoreIndex(*box, 7);
        QCOMPARE(box->currentIndex(), 1);
        restoreIndex(*box, -1);
        QCOMPARE(box->currentIndex(), 0);
    }
    void storedIndexOfABoxWithoutItemsIsNone() {
        QComboBox box;
        restoreIndex(box, 2);
        QCOMPARE(box.currentIndex(), -1);
        restoreIndex(box, -1);
        QCOMPARE(box.currentIndex(), -1);
    }
    void equalItemsAreNotReplaced() {
        QComboBox box;
        const std::vector<ComboItem> items{{1, "stone", Colour{}}, {2, "glass"}};
        setItems(box, items);
        QCOMPARE(box.count(), 2);
        QCOMPARE(box.itemData(1).toUInt(), 2u);
        QVERIFY(!box.itemIcon(0).isNull() && box.itemIcon(1).isNull());
        const QSignalSpy changed(&box, &QComboBox::currentIndexChanged);
        box.setCurrentIndex(1);
        setItems(box, items);
        QCOMPARE(box.currentIndex(), 1);
        QCOMPARE(changed.count(), 1);
        setItems(box, {{1, "stone", Colour{}}, {2, "wood"}});
        QCOMPARE(box.itemText(1), "wood");
    }
};

RUBBLE_TEST_WITH(ComboBoxTest, QApplication)
#include "ComboBoxTest.moc"
