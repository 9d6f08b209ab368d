#include "editor/document/Document.h"

#include "editor/document/EditFault.h"

#include <QScopeGuard>
#include <QScopedValueRollback>
#include <QUndoCommand>

#include <memory>
#include <new>
#include <utility>

namespace rubble {

/// An undo step: undo and redo are the same exchange of values.
class Document::Command : public QUndoCommand {
public:
    Command(Document& document, Edit edit) : QUndoCommand(edit.text), m_document(document), m_edit(std::move(edit)) {}
    ~Command() override {
        if (m_document.m_pushed == this) m_document.m_pushed = nullptr;
    }

    void undo() override {
        m_document.apply(m_edit, true);
        m_isDone = false;
    }
    void redo() override {
        m_document.apply(m_edit, std::exchange(m_wasDone, true));
        m_isDone = true;
    }
    bool isDone() const { return m_isDone; }
    /// Undoes it where there may be no memory: receivers are notified later.
    void takeBack() {
        revertEdit(m_document.m_project, m_edit);
        m_document.m_repeat.start(0);
    }

    int id() const override { return m_edit.mergeKey == 0 ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override {
        auto& later = const_cast<Command&>(static_cast<const Command&>(*other));  // Qt deletes it after this
        if (later.m_edit.mergeKey != m_edit.mergeKey) return false;
        merge(m_edit, std::move(later.m_edit));
        setObsolete(isNoChange(m_document.project(), m_edit));
        return true;
    }

private:
    Document& m_document;
    Edit m_edit;
    bool m_wasDone = false;  // ever
    bool m_isDone = false;   // now
};

Document::Document(Project project, QObject* parent) : QObject(parent), m_project(std::move(project)) {
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, [this] { emit modifiedChanged(isModified()); });
    m_repeat.setSingleShot(true);
    connect(&m_repeat, &QTimer::timeout, this, [this] { notify({{}, true}); });
}

/// The undo stack clears itself when it is destroyed, which must not be reported: what belongs to the document, such as
/// its file, is gone by then.
Document::~Document() { m_undoStack.disconnect(this); }

bool Document::push(Edit edit) {
    if (m_isNotifying) return false;
    if (edit.isEmpty() || isNoChange(m_project, edit)) return true;
    if (const std::optional<std::string> fault = editFault(m_project, edit)) {
        emit refused(QString::fromStdString(*fault));
        return false;
    }
    m_pushed = new Command(*this, std::move(edit));
    const auto forget = qScopeGuard([this] { m_pushed = nullptr; });
    try {
        m_undoStack.push(m_pushed);
    } catch (...) {
        takeBackPushed();
        throw;
    }
    return true;
}

/// Whether the last step, or the last part of the step that pushTogether() is making, is a command.
bool Document::isLastStep(const Command* command) const {
    if (m_undoStack.count() == 0) return false;
    const QUndoCommand* step = m_undoStack.command(m_undoStack.count() - 1);
    return step == command || (step->childCount() > 0 && step->child(step->childCount() - 1) == command);
}

/// After an exception: takes back an edit that did not become a step or part of one.
void Document::takeBackPushed() {
    if (m_pushed == nullptr || isLastStep(m_pushed)) return;
    const std::unique_ptr<Command> command(m_pushed);
    if (command->isDone()) command->takeBack();
}

void Document::pushTogether(const QString& text, const std::function<void()>& pushes) {
    const int before = m_undoStack.index();
    m_undoStack.beginMacro(text);
    try {
        pushes();
    } catch (...) {
        m_undoStack.endMacro();
        m_undoStack.undo();
        const_cast<QUndoCommand*>(m_undoStack.command(before))->setObsolete(true);
        m_undoStack.redo();  // removes it
        throw;
    }
    m_undoStack.endMacro();
    auto* step = const_cast<QUndoCommand*>(m_undoStack.command(before));  // Qt lets only its owner make it obsolete
    if (step->childCount() > 0) return;
    step->setObsolete(true);
    m_undoStack.undo();  // removes it
}

void Document::replace(Project project) { clear(std::move(project), true); }

void Document::replaceUnsaved(Project project) { clear(std::move(project), false); }

/// Starts anew with a project and no undo steps.
void Document::clear(Project project, bool isSaved) {
    m_project = std::move(project);
    m_undoStack.clear();  // which keeps the clean state of an empty stack
    isSaved ? m_undoStack.setClean() : m_undoStack.resetClean();
    notify({{}, true});
    emit modifiedChanged(isModified());
}

void Document::setSaved() { m_undoStack.setClean(); }

void Document::setUnsaved() {
    m_undoStack.resetClean();
    emit modifiedChanged(isModified());
}

void Document::notify(const Changes& changes) {
    const QScopedValueRollback notifying(m_isNotifying, true);
    emit changed(changes);
}

void Document::apply(Edit& edit, bool isUndoOrRedo) {
    Changes changes = applyEdit(m_project, edit);
    changes.isUndoOrRedo = isUndoOrRedo;
    try {
        notify(changes);
    } catch (const std::bad_alloc&) {  // receivers after the one without memory have missed it
        m_repeat.start(0);
        emit memoryRanOut();
    }
}

}  // namespace rubble

#include "moc_Document.cpp"
