#pragma once

#include "editor/document/Edit.h"

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include <functional>

namespace rubble {

/// Owns the project being edited and its undo stack. All other code reads project(), makes an Edit and pushes it.
/// `changed` is emitted after every change: an edit, undo, redo or replacement.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(Project project, QObject* parent = nullptr);
    ~Document() override;

    const Project& project() const { return m_project; }
    /// The undo stack; its clean state is the saved file. It has none while no state is saved.
    QUndoStack& undoStack() { return m_undoStack; }

    /// Applies an edit as one undo step, or merges it into the last step if both have the same merge key. An edit that
    /// changes nothing adds no step, and merged edits that cancel out leave none. An edit with an editFault() is not
    /// applied: `refused` is emitted, and the result is false. Nothing is applied either while `changed` is received: a
    /// field that loses the focus, because a change hides it, must not add a step to the one that is being made.
    ///
    /// Errors: throws std::bad_alloc if out of memory; the edit is then done whole, with its undo step, or not at all.
    bool push(Edit edit);
    /// Makes one undo step of all edits that `pushes` pushes; none if all of them are refused or change nothing, or if
    /// one throws.
    void pushTogether(const QString& text, const std::function<void()>& pushes);
    /// A fresh merge key, for the edits of one drag.
    quint64 newMergeKey() { return ++m_lastMergeKey; }
    /// Replaces the project, for example by one read from a file, and clears the undo stack.
    void replace(Project project);
    /// The same for a project that is in no file, such as a restored backup.
    void replaceUnsaved(Project project);

    /// Sets the project's identity, which is no edit and no change.
    void setIdentity(const std::string& identity) { m_project.identity = identity; }

    /// Whether the project differs from the saved file.
    bool isModified() const { return !m_undoStack.isClean(); }
    /// Marks the current state as saved.
    void setSaved();
    /// Marks the current state as never saved: its file was deleted, for example.
    void setUnsaved();

signals:
    void changed(const rubble::Changes& changes);
    void modifiedChanged(bool isModified);
    /// Memory ran out while `changed` was received. It will be emitted again, as a change of everything.
    void memoryRanOut();
    /// An edit was not applied; the sentence says why.
    void refused(const QString& sentence);

private:
    class Command;
    void apply(Edit& edit, bool isUndoOrRedo);
    bool isLastStep(const Command* command) const;
    void takeBackPushed();
    void clear(Project project, bool isSaved);
    void notify(const Changes& changes);

    Project m_project;
    QUndoStack m_undoStack;
    Command* m_pushed = nullptr;  // while it is pushed; null once it is deleted
    QTimer m_repeat;              // notifies again of what receivers had no memory for
    quint64 m_lastMergeKey = 0;
    bool m_isNotifying = false;  // of a change
};

}  // namespace rubble
