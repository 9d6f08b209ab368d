#pragma once

#include "editor/commands/ProblemEdits.h"
#include "editor/document/Document.h"

#include <QObject>
#include <QThreadPool>

#include <vector>

namespace rubble {

/// Carries out fixes of problems as single steps of a document: those that bake in the background, one at a time. A fix is given up
/// where the project changes meanwhile, as it was made for another one.
class FixRunner : public QObject {
    Q_OBJECT
public:
    explicit FixRunner(Document& document, QObject* parent = nullptr);
    ~FixRunner() override;

    bool isBusy() const { return m_isBusy; }
    /// What is being carried out, where one is busy.
    ProblemFix fix() const { return m_fix; }
    /// Takes the place of what is being carried out.
    void start(std::vector<Problem> problems, ProblemFix fix);
    /// Nothing of it stays.
    void cancel();

signals:
    void changed();
    void said(const QString& sentence);

private:
    void giveUp();
    void take(Edit edit);

    Document& m_document;
    QThreadPool m_thread;
    CancelToken m_cancel;
    int m_run = 0;  // what is of an earlier one comes too late
    bool m_isBusy = false;
    ProblemFix m_fix = ProblemFix::CutApart;
};

}  // namespace rubble
