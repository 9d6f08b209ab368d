#include "editor/panels/inspector/InstancePage.h"

#include "core/asset/checks/VerifyProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QCheckBox>

using namespace rubble;
using test::InspectorDesk;

class InstancePageTest : public QObject {
    Q_OBJECT
private slots:
    void editChangesAllSelectedInstances() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QVERIFY(desk.control<NumberField>("Position x").isMixed());
        desk.type("Position x", "3");
        for (const Instance& instance : desk.document.project().instances) QCOMPARE(instance.pose.position.x, 3.0);
        QCOMPARE(desk.document.undoStack().count(), 1);
        auto& fixed = *[&] {
            for (QCheckBox* box : desk.inspector.page().findChildren<QCheckBox*>()) {
                if (box->text() == "Fixed") return box;
            }
            qFatal("There is no check box \"Fixed\".");
        }();
        QCOMPARE(fixed.checkState(), Qt::PartiallyChecked);
        fixed.setFocus();
        QTest::keyClick(&fixed, Qt::Key_Space);
        QVERIFY(desk.document.project().instances[0].isFixed == desk.document.project().instances[1].isFixed);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void fixedAndUnbreakableAreTwoCheckBoxes() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20});
        const Instance& instance = desk.document.project().instances[0];
        const auto press = [&](const char* text) {
            for (QCheckBox* box : desk.inspector.page().findChildren<QCheckBox*>()) {
                if (box->text() == text) return box->click();
            }
            qFatal("There is no check box \"%s\".", text);
        };
        press("Unbreakable");
        QVERIFY(instance.isUnbreakable && !instance.isFixed);
        press("Fixed");
        QVERIFY(instance.isUnbreakable && instance.isFixed);
        press("Unbreakable");
        QVERIFY(!instance.isUnbreakable && instance.isFixed);
        QCOMPARE(desk.document.undoStack().count(), 3);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void bondsAreShownForInstancesOfBondedAssets() {
        InspectorDesk desk;
        const auto& instances = desk.document.project().instances;
        desk.selection.setInstances(desk.document.project(), {21});  // of a box that breaks whole
        const auto anchored = [&] {
            for (QCheckBox* box : desk.inspector.page().findChildren<QCheckBox*>()) {
                if (box->text() == "Anchored Where It Touches") return box;
            }
            qFatal("There is no check box for anchored instances.");
        };
        const auto hasThreshold = [&] { return desk.control<NumberField>("Threshold").isVisible(); };
        QVERIFY(!anchored()->isVisible() && !desk.control<NumberField>("Bond strength").isVisible() && hasThreshold());
        desk.selection.setInstances(desk.document.project(), {20});  // of a bonded wall
        QVERIFY(anchored()->isVisible() && !hasThreshold());
        anchored()->click();
        desk.type("Bond strength", "2.5");
        QVERIFY(instances[0].isAnchored && instances[0].bondStrength == 2.5);
        desk.type("Bond strength", "-1");
        QCOMPARE(instances[0].bondStrength, 2.5);
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QVERIFY(desk.control<NumberField>("Bond strength").isMixed() && hasThreshold());
        desk.type("Bond strength", "0.5");
        QVERIFY(instances[0].bondStrength == 0.5 && instances[1].bondStrength == 0.5);
        QCOMPARE(desk.document.undoStack().count(), 3);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void rotationsStayAsTyped() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20});
        desk.type("Rotation y", "100");
        desk.type("Rotation x", "30");
        QCOMPARE(desk.control<NumberField>("Rotation y").value(), 100.0);
        QCOMPARE(desk.control<NumberField>("Rotation x").value(), 30.0);
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(InstancePageTest, QApplication)
#include "InstancePageTest.moc"
