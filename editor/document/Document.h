#pragma once

#include "editor/document/Edit.h"

#include <QObject>
#include <QUndoStack>

namespace rubble {

/// The one owner of a project that is being edited, and of what can be undone. Everybody else reads `project()`, makes an
/// Edit and pushes it; whatever way a project changes, `changed` tells it once it is done.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(Project project, QObject* parent = nullptr);

    const Project& project() const { return m_project; }
    /// Undo and redo; its clean state is what lies on disk.
    QUndoStack& undoStack() { return m_undoStack; }

    /// Carries an edit out as one step that can be undone, or as a part of the step before where both belong to one
    /// stroke. An edit that changes nothing makes no step; a stroke that comes back to where it began leaves none.
    void push(Edit edit);
    /// A number for the edits of one drag.
    quint64 newStroke() { return ++m_lastStroke; }
    /// Puts another project in place of this one: what was read from disk. Nothing can be undone then.
    void replace(Project project);

    /// What is on disk is not what is edited.
    bool isModified() const { return !m_undoStack.isClean() || m_isUnsaved; }
    /// The project was saved as it is.
    void setSaved();
    /// The project is nowhere on disk as it is: a restored backup, say.
    void setUnsaved();

signals:
    void changed(const rubble::Changes& changes);
    void modifiedChanged(bool isModified);

private:
    class Command;
    void apply(Edit& edit, bool isStepTaken);

    Project m_project;
    QUndoStack m_undoStack;
    quint64 m_lastStroke = 0;
    bool m_isUnsaved = false;
};

}  // namespace rubble
