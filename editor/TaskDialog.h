#pragma once

#include "core/base/TaskContext.h"

#include <QProgressDialog>
#include <QString>

#include <functional>
#include <optional>

namespace rubble {

/// Carries out long work on a thread of its own, with progress and a button that cancels it; the window behind answers
/// meanwhile but takes no input. The dialog shows itself only where the work takes longer than a moment.
class TaskDialog : public QProgressDialog {
    Q_OBJECT
public:
    TaskDialog(const QString& label, QWidget* parent);

    /// Gives what `work` gives. The work hears of the button by its TaskContext.
    template <class Outcome>
    Outcome run(std::function<Outcome(const TaskContext&)> work) {
        std::optional<Outcome> outcome;
        runAndWait([&](const TaskContext& task) { outcome.emplace(work(task)); });
        return std::move(*outcome);
    }

private:
    void runAndWait(const std::function<void(const TaskContext&)>& work);
};

}  // namespace rubble
