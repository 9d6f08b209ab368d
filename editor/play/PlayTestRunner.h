#pragma once

#include "core/base/TaskContext.h"
#include "core/play/PlayTestRun.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"

#include <QObject>
#include <QThreadPool>

#include <map>

namespace rubble {

/// Runs play-tests of a document in the background, and keeps what came of each as long as the document stays as it is.
class PlayTestRunner : public QObject {
    Q_OBJECT
public:
    PlayTestRunner(const Document& document, const Bakes& bakes, QObject* parent = nullptr);
    ~PlayTestRunner() override;

    bool isBusy() const { return m_isBusy; }
    /// Runs these tests of the project, one after the other. What runs already goes on to its end first.
    void run(std::vector<Id> tests);
    void cancel();
    /// Null where the test was not run on the document as it is.
    const PlayTestOutcome* outcomeOf(Id test) const;
    int passed() const;
    int failed() const;

signals:
    /// Something was begun, done or forgotten.
    void changed();
    /// How much of what was asked for is done, in [0, 1].
    void progressed(double fraction);
    void said(const QString& sentence);

private:
    void forget();
    void take(int run, const Result<PlayTestOutcome>& outcome);
    void finish(int run);

    const Document& m_document;
    const Bakes& m_bakes;
    QThreadPool m_thread;
    CancelToken m_cancel;
    int m_run = 0;  // what is of an earlier one comes too late
    bool m_isBusy = false;
    std::map<Id, PlayTestOutcome> m_outcomes;
};

}  // namespace rubble
