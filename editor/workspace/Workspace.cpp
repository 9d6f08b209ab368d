#include "editor/workspace/Workspace.h"

#include "editor/document/EnteredFragment.h"

namespace rubble {

Workspace::Workspace(Project project, const QString& backups, QObject* parent)
    : QObject(parent),
      m_document(std::move(project)),
      m_file(m_document),
      m_autosave(m_document, backups),
      m_bondPainter(m_document, m_selection),
      m_sectionUpdater(m_selection, m_sections, m_bakes),
      m_problems(m_document, m_bakes),
      m_mortars(m_document, m_bakes),
      m_baker(m_document, m_selection, m_bakes),
      m_play(m_document, m_bakes),
      m_playTests(m_document, m_file, m_bakes),
      m_swapAudits(m_document, m_bakes) {
    m_selection.prune(m_document.project());
    const auto exitRemoved = [this] { exitRemovedFragments(m_selection, m_document.project(), m_bakes); };
    connect(&m_document, &Document::changed, &m_selection, [this] { m_selection.prune(m_document.project()); });
    connect(&m_document, &Document::changed, &m_selection, exitRemoved);
    connect(&m_bakes, &Bakes::changed, &m_selection, exitRemoved);
    connect(&m_file, &DocumentFile::originChanged, &m_autosave, &Autosave::setOrigin);
}

}  // namespace rubble

#include "moc_Workspace.cpp"
