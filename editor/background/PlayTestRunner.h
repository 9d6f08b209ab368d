#pragma once

#include "core/play/session/PlayTestRun.h"
#include "editor/background/Derived.h"
#include "editor/document/DocumentFile.h"

#include <map>

namespace rubble {

/// Runs play-tests of a document on request and keeps their outcomes until the document changes.
class PlayTestRunner : public Derived<std::map<Id, PlayTestOutcome>> {
    Q_DECLARE_TR_FUNCTIONS(rubble::PlayTestRunner)
public:
    /// `file` is the document's: states that tests start from lie beside it.
    PlayTestRunner(const Document& document, const DocumentFile& file, const Bakes& bakes, QObject* parent = nullptr);

    /// Runs tests of the project, one after the other; cancels a run in progress. Earlier outcomes are
    /// kept until theirs are there, one by one. The run fails at the first test that cannot be played.
    void run(std::vector<Id> tests);
    /// Null if the test was not run on the current document.
    const PlayTestOutcome* outcomeOf(Id test) const;
    int passedCount() const;
    int failedCount() const { return static_cast<int>(value().size()) - passedCount(); }

private:
    const DocumentFile& m_file;
    const Bakes& m_bakes;
};

}  // namespace rubble
