#pragma once

#include "core/base/Result.h"

#include <QMessageBox>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace rubble {

/// Shows an error until the user closes it; `details` are folded away, one line each.
void showError(QWidget* parent, const QString& text, const QStringList& details = {});
void showError(QWidget* parent, const Error& error);
/// Shows the status's error, if any.
void showIfError(QWidget* parent, const Status& status);

/// A question with one button per answer.
struct Question {
    struct Answer {
        QString text;                  // without a mnemonic
        QMessageBox::ButtonRole role;  // RejectRole: the answer of Escape and of closing the box
    };
    QString text;
    QString informativeText = {};
    std::vector<Answer> answers;
    std::size_t defaultAnswer = 0;  // index of the button that Enter presses
};

/// Returns the index of the answer; closing the box gives the one with the RejectRole. Each button has a mnemonic of
/// its own.
std::size_t ask(QWidget* parent, const Question& question);

/// Asks before data is lost; returns whether the user pressed the button named `action`. Enter presses `reject`.
bool confirmLoss(QWidget* parent, const QString& text, const QString& action, const QString& reject);

/// Says what was done, without blocking the window, and offers to do `action` with it.
void offer(QWidget* parent, const QString& text, const QString& action, std::function<void()> perform);
/// Says what was written, and offers to open the folder in which it is.
void offerFolder(QWidget* parent, const QString& text, const QString& folder);

}  // namespace rubble
