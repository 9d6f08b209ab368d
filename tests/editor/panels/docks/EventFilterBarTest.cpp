#include "editor/panels/docks/EventFilterBar.h"

#include "editor/widgets/ElidedLabel.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace rubble;

class EventFilterBarTest : public QObject {
    Q_OBJECT
private slots:
    void fieldsMakeAFilter() {
        EventFilterBar bar;
        bar.setMaterials({{.id = 3, .name = "stone"}, {.id = 5, .name = "wood"}});
        const QSignalSpy changes(&bar, &EventFilterBar::filterChanged);
        bar.show();
        QTest::mouseClick(button(bar, "event-settled"), Qt::LeftButton);
        QTest::keyClicks(bar.findChild<QLineEdit*>("event-text"), " front ");
        auto& energy = *bar.findChild<NumberField*>("event-energy");
        energy.selectAll();
        QTest::keyClicks(&energy, "2 kJ");
        QTest::keyClick(&energy, Qt::Key_Return);
        bar.findChild<QComboBox*>("event-material")->setCurrentIndex(2);
        EventFilter expected{.text = "front", .leastEnergy = 2000.0, .material = 5};
        expected.kinds[static_cast<std::size_t>(EventKind::Settled)] = false;
        QCOMPARE(bar.filter(), expected);
        QCOMPARE(changes.last().front().value<EventFilter>(), expected);
    }
    void energiesHaveARange() {
        EventFilterBar bar;
        const QSignalSpy refusals(&bar, &EventFilterBar::refused);
        auto& energy = *bar.findChild<NumberField*>("event-energy");
        bar.show();
        energy.selectAll();
        QTest::keyClicks(&energy, "-1");
        QTest::keyClick(&energy, Qt::Key_Return);
        QCOMPARE(refusals.size(), 1);
        QCOMPARE(bar.filter().leastEnergy, 0.0);
    }
    void showAllResetsTheFields() {
        EventFilterBar bar;
        bar.setMaterials({{.id = 3, .name = "stone"}});
        EventFilter filter{.text = "front", .leastEnergy = 5.0, .material = 3};
        filter.kinds[0] = false;
        bar.setFilter(filter);
        QVERIFY(!button(bar, "event-impact")->isChecked());
        QCOMPARE(bar.findChild<QLineEdit*>("event-text")->text(), "front");
        QCOMPARE(bar.findChild<NumberField*>("event-energy")->value(), 5.0);
        QCOMPARE(bar.findChild<QComboBox*>("event-material")->currentText(), "stone");
        const QSignalSpy changes(&bar, &EventFilterBar::filterChanged);
        auto* reset = bar.findChild<QToolButton*>("event-show-all");
        QVERIFY(reset->isEnabled());
        reset->click();
        QCOMPARE(changes.size(), 1);
        QCOMPARE(bar.filter(), EventFilter{});
        QVERIFY(button(bar, "event-impact")->isChecked() && !reset->isEnabled());
        QVERIFY(bar.findChild<QLineEdit*>("event-text")->text().isEmpty());
    }
    void aMaterialThatIsGoneIsDeselected() {
        EventFilterBar bar;
        bar.setMaterials({{.id = 3, .name = "stone"}, {.id = 5, .name = "wood"}});
        bar.setFilter({.material = 3});
        bar.setMaterials({{.id = 3, .name = "granite"}});
        QCOMPARE(bar.filter().material, 3u);
        const QSignalSpy changes(&bar, &EventFilterBar::filterChanged);
        bar.setMaterials({{.id = 5, .name = "wood"}});
        QCOMPARE(bar.filter().material, 0u);
        QCOMPARE(changes.size(), 1);
    }
    void energyIsLabelled() {
        EventFilterBar bar;
        const auto* energy = bar.findChild<NumberField*>("event-energy");
        for (const int width : {450, 900}) {
            bar.resize(width, 60);
            bar.show();
            QCoreApplication::sendPostedEvents();
            const auto* label = bar.findChild<ElidedLabel*>();
            QVERIFY(label && label->isVisible() && label->buddy() == energy && !label->isElided());
            QCOMPARE(label->text(), QString("Energy ≥"));
        }
    }
    void everyKindHasAButton() {
        EventFilterBar bar;
        bar.show();
        for (const char* name :
             {"event-impact", "event-bonds", "event-detached", "event-broken", "event-settled", "event-removed"}) {
            QVERIFY2(button(bar, name) && button(bar, name)->isVisible(), name);
        }
    }
    void aNarrowBarHasTwoRows() {
        EventFilterBar bar;
        bar.show();
        auto& energy = *bar.findChild<NumberField*>("event-energy");
        bar.resize(900, bar.sizeHint().height());
        QTRY_VERIFY(energy.y() < 20);
        bar.resize(340, 2 * bar.sizeHint().height());
        QTRY_VERIFY(energy.y() >= 20);
        QVERIFY2(bar.minimumSizeHint().width() <= 340, qPrintable(QString::number(bar.minimumSizeHint().width())));
    }

private:
    static QToolButton* button(const EventFilterBar& bar, const char* name) {
        return bar.findChild<QToolButton*>(name);
    }
};

RUBBLE_TEST_WITH(EventFilterBarTest, QApplication)
#include "EventFilterBarTest.moc"
