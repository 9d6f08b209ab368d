#include "editor/widgets/ScreenFit.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QScreen>
#include <QWidget>

using namespace rubble;

class ScreenFitTest : public QObject {
    Q_OBJECT
private slots:
    void windowsAreNoLargerThanTheScreen() {
        const QSize screen = QApplication::primaryScreen()->availableSize();
        QWidget window;
        resizeWithinScreen(window, {300, 200});
        QCOMPARE(window.size(), QSize(300, 200));
        resizeWithinScreen(window, {300, 100'000});
        QCOMPARE(window.width(), 300);
        QVERIFY(window.height() < screen.height() && window.height() > screen.height() / 2);
    }
};

RUBBLE_TEST_WITH(ScreenFitTest, QApplication)
#include "ScreenFitTest.moc"
