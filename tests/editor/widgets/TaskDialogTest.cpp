#include "editor/widgets/TaskDialog.h"

#include "core/base/Result.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <semaphore>

using namespace rubble;

namespace {

/// Presses and releases the left mouse button as the window system reports it, so that modal dialogs are respected.
void clickAsUser(QWidget& widget) {
    QTest::mouseClick(widget.window()->windowHandle(), Qt::LeftButton, {}, widget.rect().center());
    QCoreApplication::processEvents();
}

/// Runs a task that ends once `during(dialog)` was called from the event loop, after `delay`.
void runTask(QWidget& parent, std::chrono::milliseconds delay, const std::function<void(TaskDialog&)>& during) {
    TaskDialog dialog("Reading", &parent);
    std::binary_semaphore isDone(0);
    QTimer::singleShot(delay, &dialog, [&] {
        during(dialog);
        isDone.release();
    });
    const Status status = dialog.run<Status>([&](const TaskContext&) {
        isDone.acquire();
        return success();
    });
    QVERIFY(status);
}

}  // namespace

class TaskDialogTest : public QObject {
    Q_OBJECT
private slots:
    void windowTakesNoInputFromTheStart() {
        QPushButton button("Close");
        int clicks = 0;
        connect(&button, &QPushButton::clicked, &button, [&] { ++clicks; });
        button.show();
        QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience));
        clickAsUser(button);
        QCOMPARE(clicks, 1);
        bool wasOnScreen = true;
        runTask(button, std::chrono::milliseconds(0), [&](TaskDialog& dialog) {
            wasOnScreen = !dialog.testAttribute(Qt::WA_DontShowOnScreen);
            clickAsUser(button);
        });
        QVERIFY(!wasOnScreen);
        QCOMPARE(clicks, 1);
        clickAsUser(button);
        QCOMPARE(clicks, 2);
    }
    void longTaskShowsTheDialog() {
        QPushButton button("Close");
        button.show();
        QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience));
        bool wasOnScreen = false;
        runTask(button, std::chrono::milliseconds(400), [&](TaskDialog& dialog) {
            wasOnScreen = dialog.isVisible() && !dialog.testAttribute(Qt::WA_DontShowOnScreen);
        });
        QVERIFY(wasOnScreen);
        QVERIFY(!QApplication::activeModalWidget());
    }
    void closedDialogBlocksTheWindowUntilTheTaskEnds_data() {
        QTest::addColumn<bool>("isClosed");
        QTest::newRow("closed") << true;
        QTest::newRow("rejected") << false;
    }
    void closedDialogBlocksTheWindowUntilTheTaskEnds() {
        QFETCH(const bool, isClosed);
        QPushButton button("Close");
        button.show();
        QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience));
        bool wasVisible = false, wasCancelled = false;
        runTask(button, std::chrono::milliseconds(400), [&](TaskDialog& dialog) {
            for (int time = 0; time < 2; ++time) isClosed ? static_cast<void>(dialog.close()) : dialog.reject();
            wasVisible = dialog.isVisible() && QApplication::activeModalWidget() == &dialog;
            wasCancelled = dialog.wasCanceled();
        });
        QVERIFY(wasVisible);
        QVERIFY(wasCancelled);
        QVERIFY(!QApplication::activeModalWidget());
    }
};

RUBBLE_TEST_WITH(TaskDialogTest, QApplication)
#include "TaskDialogTest.moc"
