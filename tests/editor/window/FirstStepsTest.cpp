// Tests editor/views/FirstSteps.cpp.
#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"

#include <QToolButton>

using namespace rubble;

class FirstStepsTest : public EditorStory {
    Q_OBJECT
private slots:
    void init() { open(emptyProject()); }
    void cleanup() { close(); }

    void emptyProjectOffersFirstSteps() {
        QVERIFY(steps().isVisible());
        QVERIFY(canvas().rect().contains(steps().geometry()));
        QCOMPARE(steps().findChildren<QToolButton*>().size(), 5);
        canvas().resize(canvas().width() - 100, canvas().height());
        QVERIFY(std::abs((steps().geometry().center() - canvas().rect().center()).x()) <= 1);
    }
    void firstStepsHideWhileAnOutlineIsDrawn() {
        click("Draw Outline…");
        QVERIFY(!steps().isVisible());
        for (const Vec2 corner : {Vec2(-0.4, -0.4), Vec2(0.4, -0.4), Vec2(0.4, 0.4), Vec2(-0.4, 0.4)}) {
            QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels(corner));
        }
        QTest::keyClick(&canvas(), Qt::Key_Return);
        QCOMPARE(project().assets.size(), std::size_t{1});
        canvas().setTool(CanvasToolKind::Seeds);
        QVERIFY(!steps().isVisible());
        stack().undo();
        QVERIFY(steps().isVisible());
    }

private:
    QWidget& steps() { return *window().findChild<QWidget*>("first-steps"); }
    void click(const QString& text) {
        for (QToolButton* button : steps().findChildren<QToolButton*>()) {
            if (button->defaultAction()->text().remove('&') == text) {
                return QTest::mouseClick(button, Qt::LeftButton);
            }
        }
        QFAIL(qPrintable(text));
    }
};

RUBBLE_TEST_WITH(FirstStepsTest, QApplication)
#include "FirstStepsTest.moc"
