#include "editor/widgets/Section.h"

#include "editor/widgets/ElidedLabel.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QComboBox>
#include <QFormLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

using namespace rubble;

class SectionTest : public QObject {
    Q_OBJECT
private slots:
    void rowsNameTheirControls() {
        Section section("shape", "Shape");
        const auto* line = section.addRow("Name", new QLineEdit, "Name of the asset");
        QCOMPARE(line->accessibleName(), "Name");
        QCOMPARE(line->toolTip(), "Name of the asset");
        QCOMPARE(line->statusTip(), "Name of the asset");
    }
    void collapsedSectionHidesItsRows() {
        Section section("shape", "Shape");
        auto* line = section.addRow("Name", new QLineEdit, "Name of the asset");
        section.show();
        QVERIFY(line->isVisible());
        section.findChild<QToolButton*>()->click();
        QVERIFY(section.isCollapsed() && !line->isVisible());
        section.setCollapsed(false);
        QVERIFY(line->isVisible());
    }
    void rowIsHiddenWithItsLabelAndRenamed() {
        Section section("shape", "Shape");
        auto* line = section.addRow("Width", new QLineEdit, "Width");
        section.setRowLabel(line, "Diameter");
        QCOMPARE(line->accessibleName(), "Diameter");
        const auto* label = section.findChild<QLabel*>();
        QCOMPARE(label->text(), "Diameter");
        section.setRowVisible(line, false);
        QVERIFY(line->isHidden() && label->isHidden());
    }
    /// A QFormLayout of Qt 6.4 keeps the places of rows that are hidden, and writes there, beyond those of the rows
    /// that are shown, when a text in it wraps: the heap was damaged.
    void hiddenRowsHaveNoPlace() {
        Section section("shape", "Shape");
        auto* wrapped = new QLabel(QString("word ").repeated(100));
        wrapped->setWordWrap(true);
        section.addWide(wrapped);
        std::vector<QLineEdit*> lines;
        for (int k = 0; k < 10; ++k) lines.push_back(section.addRow(QString::number(k), new QLineEdit, ""));
        section.resize(300, 100);
        section.show();
        const int shown = section.sizeHint().height();
        for (std::size_t k = 1; k < lines.size(); ++k) section.setRowVisible(lines[k], false);
        QCoreApplication::sendPostedEvents();  // of the layouts
        QVERIFY(section.sizeHint().height() < shown - 8 * lines.front()->sizeHint().height());
        QVERIFY(section.findChildren<QFormLayout*>().isEmpty());
    }
    void wheelScrollsThePanelUnlessTheBoxHasTheFocus() {
        Section section("shape", "Shape");
        auto* box = section.addRow("Kind", new QComboBox, "Kind");
        box->addItems({"a", "b", "c"});
        box->setCurrentIndex(1);
        section.show();
        QWheelEvent wheel({}, {}, {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(box, &wheel);
        QCOMPARE(box->currentIndex(), 1);
        QVERIFY(!wheel.isAccepted());
    }
    void pageScrollsVerticallyOnly() {
        const std::unique_ptr<QScrollArea> area(verticalScrollArea(new QWidget));
        QVERIFY(area->widgetResizable());
        QCOMPARE(area->horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
    }
    void pageKeepsItsWidthWhenItMustScroll() {
        auto* page = new QWidget;
        const std::unique_ptr<QScrollArea> area(verticalScrollArea(page));
        area->resize(200, 100);
        area->show();
        const auto bar = [&] { return area->verticalScrollBar()->grab().toImage(); };
        const int width = page->width();
        const QImage empty = bar();
        page->setMinimumHeight(400);
        for (int k = 0; k < 3; ++k) QCoreApplication::processEvents();
        QVERIFY(area->verticalScrollBar()->maximum() > 0);
        QCOMPARE(page->width(), width);
        QVERIFY(bar() != empty);  // which is not painted
    }
    void longLabelsAreElidedInANarrowSection() {
        Section section("mortar", "Mortar");
        section.addRow("Impulse per square metre of area", new QLineEdit, "Set the impulse");
        auto* label = section.findChild<ElidedLabel*>();
        section.resize(600, 80);
        section.show();
        QVERIFY(label && !label->isElided());
        section.resize(220, 80);
        QCoreApplication::sendPostedEvents();
        QVERIFY(label->isElided());
        QHelpEvent help(QEvent::ToolTip, {5, 5}, label->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(label, &help);
        QVERIFY(QToolTip::text().contains(label->text()) && QToolTip::text().contains("Set the impulse"));
    }
};

RUBBLE_TEST_WITH(SectionTest, QApplication)
#include "SectionTest.moc"
