// Tests editor/actions/LockQuestion.cpp.
#include "editor/actions/LockQuestion.h"

#include "core/io/project/ProjectLock.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"

#include <QFile>
#include <QMessageBox>
#include <QTemporaryDir>

using namespace rubble;

class LockQuestionTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_shown.clear(); }

    void freeProjectAsksNothing() {
        const std::optional<ProjectAccess> access = askForAccess(path("free.rubble"), nullptr);
        QVERIFY(access && !access->isReadOnly());
    }
    void enterOpensReadOnly() {
        writeLock("locked.rubble", "4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
        answer(Qt::Key_Return);
        const std::optional<ProjectAccess> access = askForAccess(path("locked.rubble"), nullptr);
        QVERIFY(access && access->isReadOnly());
        QVERIFY2(
            m_shown.startsWith("\"locked.rubble\" is open in rubble on \"render01\" (user bob, process 4711) since "),
            qPrintable(m_shown));
        QCOMPARE(m_answers, (QStringList{"Open Read-Only", "Cancel", "Take Over Lock"}));
    }
    void emptyLockIsNamedAsUnknown() {
        writeLock("empty.rubble", "");
        answer(Qt::Key_Escape);
        QVERIFY(!askForAccess(path("empty.rubble"), nullptr));
        QVERIFY2(m_shown.startsWith("\"empty.rubble\" is open in an unknown program since "), qPrintable(m_shown));
        QVERIFY(m_answers.contains("Take Over Lock"));
    }
    void lockOfARunningProgramIsNotOffered() {
        const ProjectAccess held = accessProject(path("held.rubble"));
        answer(Qt::Key_Escape);
        QVERIFY(!askForAccess(path("held.rubble"), nullptr));
        QCOMPARE(m_answers, (QStringList{"Open Read-Only", "Cancel"}));
    }
    void foreignLockIsTakenOverForSaving() {
        writeLock("saved.rubble", "4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
        answer(Qt::Key_Return);
        QVERIFY(!askToSave(path("saved.rubble"), nullptr));
        QVERIFY2(m_shown.contains("on \"render01\" (user bob, process 4711)"), qPrintable(m_shown));
        QCOMPARE(m_answers, (QStringList{"Cancel", "Take Over Lock"}));
        test::onNextDialog<QMessageBox>([](QMessageBox& box) {
            for (QAbstractButton* button : box.buttons()) {
                if (button->text().remove('&') == "Take Over Lock") return button->click();
            }
        });
        const std::optional<ProjectAccess> access = askToSave(path("saved.rubble"), nullptr);
        QVERIFY(access && !access->isReadOnly());
        const std::optional<ProjectAccess> held = askToSave(path("saved.rubble"), nullptr);  // asks nothing
        QVERIFY(held && held->isReadOnly());
    }

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    void writeLock(const QString& name, const QByteArray& text) const {
        QFile file(fromPath(lockPathOf(toPath(path(name)))));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    void answer(Qt::Key key) {
        test::onNextDialog<QMessageBox>([this, key](QMessageBox& box) {
            m_shown = box.text();
            m_answers.clear();
            for (const QAbstractButton* button : box.buttons()) m_answers += button->text().remove('&');
            std::ranges::sort(m_answers, [](const QString& a, const QString& b) { return order(a) < order(b); });
            QTest::keyClick(&box, key);
        });
    }
    /// The box sorts its buttons as the desktop does.
    static int order(const QString& answer) { return answer == "Open Read-Only" ? 0 : answer == "Cancel" ? 1 : 2; }

    QTemporaryDir m_folder;
    QString m_shown;
    QStringList m_answers;
};

RUBBLE_TEST_WITH(LockQuestionTest, QApplication)
#include "LockQuestionTest.moc"
