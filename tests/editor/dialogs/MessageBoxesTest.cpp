#include "editor/dialogs/MessageBoxes.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"

using namespace rubble;

class MessageBoxesTest : public QObject {
    Q_OBJECT
private slots:
    void errorIsShown() {
        QString shown;
        answer(shown, Qt::Key_Return);
        showIfError(nullptr, Error{ErrorCode::Io, "The disk is full."});
        QCOMPARE(shown, QString("The disk is full."));
    }
    void successShowsNothing() {
        showIfError(nullptr, success());
        QVERIFY(!QApplication::activeModalWidget());
    }
    void enterGivesTheDefaultAnswer() {
        QString shown;
        answer(shown, Qt::Key_Return);
        QCOMPARE(ask(nullptr, saveQuestion()), std::size_t{0});
        QCOMPARE(shown, QString("Save?"));
    }
    void escapeGivesTheRejectingAnswer() {
        QString shown;
        answer(shown, Qt::Key_Escape);
        QCOMPARE(ask(nullptr, saveQuestion()), std::size_t{2});
    }
    void enterDoesNotConfirmALoss() {
        QString shown;
        answer(shown, Qt::Key_Return);
        QVERIFY(!confirmLoss(nullptr, "Discard all changes?", "Discard", "Cancel"));
    }
    void eachAnswerHasAMnemonicOfItsOwn() {
        QStringList keys;
        test::onNextDialog<QMessageBox>([&keys](QMessageBox& box) {
            for (const QAbstractButton* button : box.buttons())
                keys << QKeySequence::mnemonic(button->text()).toString();
            QTest::keyClick(&box, Qt::Key_A, Qt::AltModifier);  // the second answer
        });
        const std::size_t answer = ask(nullptr, {.text = "Save?",
                                                 .answers = {{"Save All", QMessageBox::AcceptRole},
                                                             {"Ask for Each", QMessageBox::AcceptRole},
                                                             {"Discard All", QMessageBox::DestructiveRole},
                                                             {"Cancel", QMessageBox::RejectRole},
                                                             {"All", QMessageBox::AcceptRole},
                                                             {"?", QMessageBox::AcceptRole}}});
        QCOMPARE(answer, std::size_t{1});
        keys.sort();
        QCOMPARE(keys, (QStringList{"", "Alt+A", "Alt+C", "Alt+D", "Alt+L", "Alt+S"}));
    }
    void enterClosesAnOffer() {
        QWidget window;
        int opened = 0;
        offer(&window, "Exported 2 assets.", "Open Folder", [&] { ++opened; });
        auto* box = window.findChild<QMessageBox*>();
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_VERIFY(!window.findChild<QMessageBox*>());
        QCOMPARE(opened, 0);
    }
    void offerDoesNotBlock() {
        QWidget window;
        int opened = 0;
        offer(&window, "Exported 2 assets.", "Open Folder", [&] { ++opened; });
        auto* box = window.findChild<QMessageBox*>();
        QVERIFY(box && !QApplication::activeModalWidget());
        QCOMPARE(box->text(), QString("Exported 2 assets."));
        for (QAbstractButton* button : box->buttons()) {
            if (button->text() == "Open Folder") button->click();
        }
        QCOMPARE(opened, 1);
        QTRY_VERIFY(!window.findChild<QMessageBox*>());
    }
    void anOfferReplacesTheOneBefore() {
        QWidget window;
        for (const char* sentence : {"Exported for Unity.", "Exported for Blender."}) {
            offer(&window, sentence, "Open Folder", [] {});
            QVERIFY(window.findChildren<QMessageBox*>().back()->testAttribute(Qt::WA_ShowWithoutActivating));
        }
        QTRY_COMPARE(window.findChildren<QMessageBox*>().size(), 1);
        QCOMPARE(window.findChild<QMessageBox*>()->text(), QString("Exported for Blender."));
    }

private:
    static Question saveQuestion() {
        return {.text = "Save?",
                .answers = {{"Save", QMessageBox::AcceptRole},
                            {"Discard", QMessageBox::DestructiveRole},
                            {"Cancel", QMessageBox::RejectRole}}};
    }
    /// Stores the text of the next message box and presses a key in it.
    static void answer(QString& shown, Qt::Key key) {
        test::onNextDialog<QMessageBox>([&shown, key](QMessageBox& box) {
            shown = box.text();
            QTest::keyClick(&box, key);
        });
    }
};

RUBBLE_TEST_WITH(MessageBoxesTest, QApplication)
#include "MessageBoxesTest.moc"
