#include "editor/TaskDialog.h"

#include <QEventLoop>
#include <QThread>

#include <algorithm>
#include <memory>

namespace rubble {

namespace {

constexpr int kPatienceMilliseconds = 300;  // shorter work shows no dialog
constexpr int kSteps = 1000;

}  // namespace

TaskDialog::TaskDialog(const QString& label, QWidget* parent)
    : QProgressDialog(label, tr("Cancel"), 0, kSteps, parent) {
    setWindowModality(Qt::WindowModal);
    setMinimumDuration(kPatienceMilliseconds);
    setAutoReset(false);
    setAutoClose(false);
    setValue(0);
}

void TaskDialog::runAndWait(const std::function<void(const TaskContext&)>& work) {
    TaskContext task;
    task.threads = std::max(1, QThread::idealThreadCount());
    task.progress = [this](double fraction) {
        QMetaObject::invokeMethod(this, [this, fraction] { setValue(static_cast<int>(fraction * kSteps)); });
    };
    connect(this, &QProgressDialog::canceled, this, [this, cancel = task.cancel] {
        cancel.cancel();
        setLabelText(tr("Cancelling…"));
        show();  // until the work has put everything back
    });
    QEventLoop loop;
    const std::unique_ptr<QThread> thread(QThread::create([&] { work(task); }));
    connect(thread.get(), &QThread::finished, &loop, &QEventLoop::quit);
    thread->start();
    loop.exec();
    thread->wait();
    hide();
}

}  // namespace rubble
