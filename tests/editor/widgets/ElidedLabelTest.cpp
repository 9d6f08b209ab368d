#include "editor/widgets/ElidedLabel.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QHelpEvent>
#include <QTest>
#include <QToolTip>

using namespace rubble;

class ElidedLabelTest : public QObject {
    Q_OBJECT
private slots:
    void textWithoutRoomIsElidedAndInTheToolTip() {
        ElidedLabel label("Click: select a fragment · Drag elsewhere: box select");
        label.resize(label.sizeHint());
        QVERIFY(!label.isElided());
        const QImage whole = label.grab().toImage();
        QVERIFY(label.minimumSizeHint().width() < 40);
        label.resize(120, label.height());
        QVERIFY(label.isElided());
        QVERIFY(label.grab().toImage() != whole.copy(0, 0, 120, label.height()));  // it ends with an ellipsis
        label.show();
        QHelpEvent help(QEvent::ToolTip, {5, 5}, label.mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(&label, &help);
        QCOMPARE(QToolTip::text(), label.text());
    }
};

RUBBLE_TEST_WITH(ElidedLabelTest, QApplication)
#include "ElidedLabelTest.moc"
