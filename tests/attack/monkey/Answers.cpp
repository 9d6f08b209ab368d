#include "tests/attack/monkey/Answers.h"

#include "editor/window/MainWindow.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMessageBox>
#include <QTimer>

namespace rubble::attack {
namespace {

constexpr std::chrono::milliseconds kAnswerPause{10};

QAbstractButton* buttonOf(const QMessageBox& box, const QString& text) {
    for (QAbstractButton* button : box.buttons()) {
        if (button->text().remove('&') == text) return button;
    }
    return nullptr;
}

}  // namespace

BackupAnswers::BackupAnswers(JournalWriter& journal, std::function<void()> restored)
    : m_journal(journal), m_restored(std::move(restored)) {
    answer();
}

/// What is posted now comes after the function that offers backups, which only returns to the event loop in dialogs.
void BackupAnswers::expectOffers() {
    QTimer::singleShot(0, this, [this] { m_areOffersPosted = true; });
}

void BackupAnswers::answer() {
    const QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog && m_areOffersPosted) return m_restored();
    QTimer::singleShot(kAnswerPause, this, &BackupAnswers::answer);
    if (!dialog) return;
    const auto* box = qobject_cast<const QMessageBox*>(dialog);
    QAbstractButton* restore = box ? buttonOf(*box, "Restore") : nullptr;
    if (!restore) {
        m_journal.fail("At the start a dialog was shown that offers no backup: " +
                       (box ? box->text() : dialog->windowTitle()).toStdString());
    }
    m_journal.note("offer", {box->text().toStdString()});
    restore->click();
}

void Closing::begin() {
    QApplication::setQuitOnLastWindowClosed(true);
    closeNext();
}

/// A box asks in a nested event loop, so the next step is planned before each.
void Closing::closeNext() {
    QTimer::singleShot(kAnswerPause, this, &Closing::closeNext);
    if (QWidget* popup = QApplication::activePopupWidget()) {
        popup->close();
    } else if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        QAbstractButton* discard = buttonOf(*box, "Discard");
        if (!discard) discard = buttonOf(*box, "Close Window");  // a video is being exported
        discard ? discard->click() : box->reject();
    } else if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        dialog->reject();
    } else {
        QApplication::closeAllWindows();
    }
}

}  // namespace rubble::attack
