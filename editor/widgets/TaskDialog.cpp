#include "editor/widgets/TaskDialog.h"

#include "core/base/Parallel.h"

#include <QEventLoop>
#include <QLabel>
#include <QThread>
#include <QTimer>

#include <chrono>
#include <memory>

namespace rubble {

namespace {

constexpr std::chrono::milliseconds kMinimumDuration{300};  // shorter tasks show no dialog
constexpr int kProgressSteps = 1000;

}  // namespace

TaskDialog::TaskDialog(const QString& label, QWidget* parent)
    : QProgressDialog(QString(), tr("Cancel"), 0, kProgressSteps, parent) {
    auto* plain = new QLabel(label);
    plain->setTextFormat(Qt::PlainText);
    plain->setAlignment(Qt::AlignCenter);
    setLabel(plain);
    setWindowModality(Qt::WindowModal);
    setAutoReset(false);
    setAutoClose(false);
    setValue(0);
}

void TaskDialog::done(int /*result*/) { emit canceled(); }

void TaskDialog::runAndWait(const std::function<void(const TaskContext&)>& task) {
    TaskContext context;
    context.threads = availableProcessors();
    context.progress = [this](double fraction) {
        QMetaObject::invokeMethod(this, [this, fraction] { setValue(static_cast<int>(fraction * kProgressSteps)); });
    };
    connect(this, &QProgressDialog::canceled, this, [this, cancel = context.cancel] {
        cancel.cancel();
        setLabelText(tr("Cancelling…"));
        appear();  // until the task has cleaned up
    });
    // A dialog that is shown off the screen blocks its parent like any other.
    setAttribute(Qt::WA_DontShowOnScreen);
    show();
    QTimer delay;
    delay.setSingleShot(true);
    connect(&delay, &QTimer::timeout, this, &TaskDialog::appear);
    delay.start(kMinimumDuration);
    QEventLoop loop;
    const std::unique_ptr<QThread> thread(QThread::create([&] { task(context); }));
    connect(thread.get(), &QThread::finished, &loop, &QEventLoop::quit);
    thread->start();
    const bool hasStarted = thread->isRunning() || thread->isFinished();
    if (hasStarted) {
        loop.exec();
    } else {
        task(context);  // the system allows no more threads
    }
    thread->wait();
    hide();
}

void TaskDialog::appear() {
    if (testAttribute(Qt::WA_DontShowOnScreen)) {
        hide();
        setAttribute(Qt::WA_DontShowOnScreen, false);
    }
    show();
}

}  // namespace rubble

#include "moc_TaskDialog.cpp"
