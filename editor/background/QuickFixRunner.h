#pragma once

#include "editor/commands/QuickFixes.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <vector>

namespace rubble {

/// Applies quick fixes of problems as undoable edits of a document, one at a time; those that have to bake run in the
/// background. A running fix is cancelled if the document changes, since it was computed for its earlier state.
class QuickFixRunner : public QObject {
    Q_OBJECT
public:
    explicit QuickFixRunner(Document& document, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    /// The last fix started.
    QuickFix fix() const { return m_fix; }
    /// Replaces a running fix.
    void start(std::vector<Diagnostic> problems, QuickFix fix);
    /// The document stays unchanged.
    void cancel();

signals:
    /// isBusy() changed.
    void changed();
    void statusMessage(const QString& sentence);

private:
    void cancelOutdated();
    void apply(Edit edit);

    Document& m_document;
    BackgroundJob m_job;
    QuickFix m_fix = QuickFix::SplitFragment;
};

}  // namespace rubble
