#include "editor/background/QuickFixRunner.h"

#include <utility>

namespace rubble {

QuickFixRunner::QuickFixRunner(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::changed, this, &QuickFixRunner::cancelOutdated);
    connect(&m_job, &BackgroundJob::failed, this, [this](const QString& sentence) {
        emit changed();
        emit statusMessage(sentence);
    });
}

void QuickFixRunner::start(std::vector<Diagnostic> problems, QuickFix fix) {
    cancel();
    m_fix = fix;
    if (!isSlow(fix)) return apply(applyFix(m_document.project(), problems, fix));
    m_job.start([project = m_document.project(), problems = std::move(problems),
                 fix](const TaskContext& task) { return applyFix(project, problems, fix, task); },
                [this](Edit edit) {
                    apply(std::move(edit));
                    emit changed();
                });
    emit changed();
}

void QuickFixRunner::apply(Edit edit) {
    if (edit.isEmpty() || isNoChange(m_document.project(), edit)) {
        return emit statusMessage(tr("%1 has no effect here.").arg(textOf(m_fix)));
    }
    m_document.push(std::move(edit));
}

void QuickFixRunner::cancel() {
    if (!isBusy()) return;
    m_job.cancel();
    emit changed();
}

void QuickFixRunner::cancelOutdated() {
    if (!isBusy()) return;
    cancel();
    emit statusMessage(tr("%1 was cancelled: the project changed meanwhile.").arg(textOf(m_fix)));
}

}  // namespace rubble

#include "moc_QuickFixRunner.cpp"
