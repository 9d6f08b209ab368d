#pragma once

#include "core/base/OutOfMemory.h"
#include "core/base/TaskContext.h"

#include <QProgressDialog>
#include <QString>

#include <functional>
#include <optional>

namespace rubble {

/// Runs a long task on its own thread and shows its progress with a Cancel button. The parent window keeps painting but
/// accepts no input from the start, although short tasks show no dialog.
class TaskDialog : public QProgressDialog {
    Q_OBJECT
public:
    TaskDialog(const QString& label, QWidget* parent);

    /// Cancels the task instead: hidden, the dialog would let its window be closed while the task uses it.
    void done(int result) override;

    /// Returns what `task` returns, a Result; outOfMemory() where memory runs out. Cancel is signalled to the task by
    /// its TaskContext.
    template <class Outcome>
    Outcome run(std::function<Outcome(const TaskContext&)> task) {
        std::optional<Outcome> outcome;
        runAndWait([&](const TaskContext& context) {
            outcome.emplace(orOutOfMemory("working in the background", [&] { return task(context); }));
        });
        return std::move(*outcome);
    }

private:
    void runAndWait(const std::function<void(const TaskContext&)>& task);
    void appear();
};

}  // namespace rubble
