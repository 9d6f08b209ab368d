#pragma once

#include "editor/document/Document.h"
#include "tests/attack/monkey/Journal.h"

#include <QObject>

#include <map>
#include <string>
#include <vector>

namespace rubble {
class MainWindow;
class PreferenceStore;
}  // namespace rubble

namespace rubble::attack {

/// Notes every state of every document in the journal, and the times at which the event loop ran. Fails if a project
/// becomes invalid, or if undo and redo do not restore what was there.
class Recorder : public QObject {
public:
    Recorder(PreferenceStore& preferences, JournalWriter& journal);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    enum class Step { None, Edit, UndoOrRedo };
    struct Recorded {
        int number = 0;
        std::vector<std::string> hashes;  // of the project at each index of the undo stack
        Step step = Step::None;           // the change since the undo stack's last signal
    };

    void attach(MainWindow& window);
    void noteChange(MainWindow& window, const Changes& changes);
    void noteIndex(MainWindow& window);
    void note(MainWindow& window);

    JournalWriter& m_journal;
    std::map<const QObject*, Recorded> m_documents;  // by window
    int m_count = 0;
};

}  // namespace rubble::attack
