#include "editor/widgets/AccessibleRole.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QWidget>

using namespace rubble;

class AccessibleRoleTest : public QObject {
    Q_OBJECT
private slots:
    /// Also if an interface was made before, as by a name.
    void roleReplacesThatOfAnUnknownArea() {
        QWidget widget, other;
        widget.setAccessibleName("Timeline");
        QVERIFY(QAccessible::queryAccessibleInterface(&widget)->role() != QAccessible::Slider);
        setAccessibleRole(widget, QAccessible::Slider);
        QCOMPARE(QAccessible::queryAccessibleInterface(&widget)->role(), QAccessible::Slider);
        QCOMPARE(QAccessible::queryAccessibleInterface(&widget)->text(QAccessible::Name), "Timeline");
        QVERIFY(QAccessible::queryAccessibleInterface(&other)->role() != QAccessible::Slider);
    }
};

RUBBLE_TEST_WITH(AccessibleRoleTest, QApplication)
#include "AccessibleRoleTest.moc"
