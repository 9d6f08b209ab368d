#include "editor/dialogs/MessageBoxes.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QPushButton>
#include <QUrl>

namespace rubble {

namespace {

struct MessageBoxTexts {
    Q_DECLARE_TR_FUNCTIONS(MessageBoxes)
};

/// The index of the first letter for which `isFree` holds, at the start of a word if there is one; -1 if there is none.
qsizetype freeLetter(const QString& text, const std::function<bool(QChar)>& isFree) {
    qsizetype inside = -1;
    for (qsizetype k = 0; k < text.size(); ++k) {
        if (!text[k].isLetter() || !isFree(text[k].toLower())) continue;
        if (k == 0 || !text[k - 1].isLetter()) return k;
        if (inside < 0) inside = k;
    }
    return inside;
}

/// Gives each text a mnemonic of its own.
QStringList withMnemonics(const std::vector<Question::Answer>& answers) {
    QStringList texts;
    QString taken;
    for (const Question::Answer& answer : answers) {
        texts << answer.text;
        const qsizetype at = freeLetter(answer.text, [&](QChar letter) { return !taken.contains(letter); });
        if (at < 0) continue;
        taken += answer.text[at].toLower();
        texts.back().insert(at, '&');
    }
    return texts;
}

}  // namespace

void showError(QWidget* parent, const QString& text, const QStringList& details) {
    QMessageBox box(QMessageBox::Warning, QApplication::applicationDisplayName(), text, QMessageBox::Ok, parent);
    box.setTextFormat(Qt::PlainText);  // names in files can look like HTML
    box.setDetailedText(details.join('\n'));
    box.exec();
}

void showError(QWidget* parent, const Error& error) { showError(parent, QString::fromStdString(error.message)); }

void showIfError(QWidget* parent, const Status& status) {
    if (!status) showError(parent, status.error());
}

std::size_t ask(QWidget* parent, const Question& question) {
    QMessageBox box(QMessageBox::Question, QApplication::applicationDisplayName(), question.text, QMessageBox::NoButton,
                    parent);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(question.informativeText);
    const QStringList texts = withMnemonics(question.answers);
    std::vector<QAbstractButton*> buttons;
    std::size_t rejected = question.defaultAnswer;
    for (std::size_t k = 0; k < question.answers.size(); ++k) {
        const QMessageBox::ButtonRole role = question.answers[k].role;
        QPushButton* button = box.addButton(texts[static_cast<qsizetype>(k)], role);
        buttons.push_back(button);
        if (role == QMessageBox::RejectRole) {
            rejected = k;
            box.setEscapeButton(button);
        }
        if (k == question.defaultAnswer) box.setDefaultButton(button);
    }
    box.exec();
    for (std::size_t k = 0; k < buttons.size(); ++k) {
        if (box.clickedButton() == buttons[k]) return k;
    }
    return rejected;
}

bool confirmLoss(QWidget* parent, const QString& text, const QString& action, const QString& reject) {
    return ask(parent, {.text = text,
                        .answers = {{action, QMessageBox::DestructiveRole}, {reject, QMessageBox::RejectRole}},
                        .defaultAnswer = 1}) == 0;
}

void offer(QWidget* parent, const QString& text, const QString& action, std::function<void()> perform) {
    const auto shown =
        parent ? parent->findChildren<QMessageBox*>("offer", Qt::FindDirectChildrenOnly) : QList<QMessageBox*>();
    for (QMessageBox* earlier : shown) earlier->close();
    auto* box = new QMessageBox(QMessageBox::Information, QApplication::applicationDisplayName(), text,
                                QMessageBox::Close, parent);
    box->setTextFormat(Qt::PlainText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->setObjectName("offer");
    box->setAttribute(Qt::WA_ShowWithoutActivating);  // the keys of the window go on working
    const QPushButton* button = box->addButton(action, QMessageBox::ActionRole);
    QObject::connect(button, &QPushButton::clicked, box, std::move(perform));
    box->setDefaultButton(QMessageBox::Close);  // Return is pressed without reading
    box->show();
}

void offerFolder(QWidget* parent, const QString& text, const QString& folder) {
    offer(parent, text, MessageBoxTexts::tr("&Open Folder"),
          [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
}

}  // namespace rubble
