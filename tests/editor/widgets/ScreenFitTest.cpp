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
    void windowsAreCascadedWithinTheScreen() {
        const QRect screen(0, 0, 1280, 720), first(100, 50, 800, 600), second(130, 80, 800, 600);
        const QSize least(400, 300);
        QCOMPARE(cascaded({800, 600}, least, first, {first}, screen), QRect(130, 80, 800, 600));
        QCOMPARE(cascaded({800, 600}, least, first, {first, second}, screen), QRect(160, 110, 800, 600));
        QCOMPARE(cascaded({800, 600}, least, {100, 110, 800, 600}, {}, screen), QRect(130, 140, 800, 580));
        QCOMPARE(cascaded(screen.size(), least, screen, {screen}, screen), QRect(30, 30, 1250, 690));
        QCOMPARE(cascaded(screen.size(), {1280, 300}, screen, {screen}, screen), QRect(0, 30, 1280, 690));
        QCOMPARE(cascaded({800, 600}, least, {700, 300, 800, 600}, {}, screen), QRect(0, 0, 800, 600));
    }
};

RUBBLE_TEST_WITH(ScreenFitTest, QApplication)
#include "ScreenFitTest.moc"
