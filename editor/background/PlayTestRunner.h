#pragma once

#include "core/play/session/PlayTestRun.h"
#include "editor/document/Bakes.h"
#include "editor/document/DocumentFile.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <map>
#include <vector>

namespace rubble {

/// Runs play-tests of a document in the background and keeps their outcomes until the document changes.
class PlayTestRunner : public QObject {
    Q_OBJECT
public:
    /// `file` is the document's: states that tests start from lie beside it.
    PlayTestRunner(const Document& document, const DocumentFile& file, const Bakes& bakes, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    /// Runs tests of the project, one after the other; cancels a run in progress.
    void run(std::vector<Id> tests);
    void cancel();
    /// Null if the test was not run on the current document.
    const PlayTestOutcome* outcomeOf(Id test) const;
    int passed() const;
    int failed() const;

signals:
    /// isBusy() or an outcome changed.
    void changed();
    /// The fraction of the run that is done, in [0, 1].
    void progressed(double fraction);
    void statusMessage(const QString& sentence);

private:
    void discard();
    void add(const Result<PlayTestOutcome>& outcome);

    const Document& m_document;
    const DocumentFile& m_file;
    const Bakes& m_bakes;
    BackgroundJob m_job;
    std::map<Id, PlayTestOutcome> m_outcomes;
};

}  // namespace rubble
