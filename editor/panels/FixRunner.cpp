#include "editor/panels/FixRunner.h"

#include <QMetaObject>
#include <QThread>

#include <algorithm>
#include <utility>

namespace rubble {

FixRunner::FixRunner(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    m_thread.setMaxThreadCount(1);
    connect(&document, &Document::changed, this, &FixRunner::giveUp);
}

FixRunner::~FixRunner() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void FixRunner::start(std::vector<Problem> problems, ProblemFix fix) {
    cancel();
    m_fix = fix;
    if (!isLong(fix)) return take(fixed(m_document.project(), problems, fix));
    m_cancel = {};
    m_isBusy = true;
    emit changed();
    const TaskContext task{.cancel = m_cancel, .threads = std::max(1, QThread::idealThreadCount())};
    m_thread.start([this, run = ++m_run, project = m_document.project(), problems = std::move(problems), fix, task] {
        QMetaObject::invokeMethod(this, [this, run, edit = fixed(project, problems, fix, task)] {
            if (run != m_run) return;
            m_isBusy = false;
            take(edit);
            emit changed();
        });
    });
}

void FixRunner::take(Edit edit) {
    if (edit.isEmpty() || isNoChange(m_document.project(), edit)) {
        return emit said(tr("%1 changes nothing there.").arg(textOf(m_fix)));
    }
    m_document.push(std::move(edit));
}

void FixRunner::cancel() {
    if (!m_isBusy) return;
    m_cancel.cancel();
    ++m_run;
    m_isBusy = false;
    emit changed();
}

void FixRunner::giveUp() {
    if (!m_isBusy) return;
    cancel();
    emit said(tr("%1 was given up: the project changed meanwhile.").arg(textOf(m_fix)));
}

}  // namespace rubble
