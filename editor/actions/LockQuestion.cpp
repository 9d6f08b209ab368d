#include "editor/actions/LockQuestion.h"

#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>

namespace rubble {

namespace {

struct LockQuestionTexts {
    Q_DECLARE_TR_FUNCTIONS(LockQuestion)
};

Question baseQuestion(const QString& path, const LockHolder& holder) {
    return {.text = LockQuestionTexts::tr("\"%1\" is open in %2.").arg(fileNameText(path), holderText(holder)),
            .informativeText = LockQuestionTexts::tr(
                "Rubble cannot tell whether that program is still running. Take the lock over only if it has ended.")};
}

Question questionAbout(const QString& path, const LockHolder& holder) {
    Question question = baseQuestion(path, holder);
    question.answers = {{LockQuestionTexts::tr("Open Read-Only"), QMessageBox::AcceptRole},
                        {LockQuestionTexts::tr("Cancel"), QMessageBox::RejectRole}};
    if (holder.isRunningHere) {
        question.informativeText = LockQuestionTexts::tr("Close it there first, or open it read-only here.");
    } else {
        question.answers.push_back({LockQuestionTexts::tr("Take Over Lock"), QMessageBox::DestructiveRole});
    }
    return question;
}

}  // namespace

std::optional<ProjectAccess> askForAccess(const QString& path, QWidget* parent) {
    enum Answer : std::size_t { kReadOnly, kCancel, kTakeOver };
    ProjectAccess access = accessProject(path);
    while (access.holder) {
        const std::size_t answer = ask(parent, questionAbout(path, *access.holder));
        if (answer == kCancel) return std::nullopt;
        if (answer == kReadOnly) break;
        access = accessProject(path, LockTakeover::Any);
    }
    return access;
}

std::optional<ProjectAccess> askToSave(const QString& path, QWidget* parent) {
    enum Answer : std::size_t { kTakeOver, kCancel };
    ProjectAccess access = accessProject(path);
    while (access.holder && !access.holder->isRunningHere) {
        Question question = baseQuestion(path, *access.holder);
        question.answers = {{LockQuestionTexts::tr("Take Over Lock"), QMessageBox::DestructiveRole},
                            {LockQuestionTexts::tr("Cancel"), QMessageBox::RejectRole}};
        question.defaultAnswer = kCancel;
        if (ask(parent, question) == kCancel) return std::nullopt;
        access = accessProject(path, LockTakeover::Any);
    }
    return access;
}

}  // namespace rubble
