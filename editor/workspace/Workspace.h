#pragma once

#include "editor/background/Baker.h"
#include "editor/background/MortarWatch.h"
#include "editor/background/PlayTestRunner.h"
#include "editor/background/ProblemWatch.h"
#include "editor/background/SectionUpdater.h"
#include "editor/background/SwapAuditRunner.h"
#include "editor/background/VideoExporter.h"
#include "editor/commands/BondPainter.h"
#include "editor/document/Autosave.h"
#include "editor/document/DocumentFile.h"
#include "editor/play/PlayController.h"

namespace rubble {

/// The model behind one window: the document with its file and backup, the selection and the brush, the bakes and
/// diagnostics, and the simulation.
class Workspace : public QObject {
    Q_OBJECT
public:
    /// Backups of the document are written to the folder `backups`.
    Workspace(Project project, const QString& backups, QObject* parent = nullptr);

    Document& document() { return m_document; }
    const Project& project() const { return m_document.project(); }
    DocumentFile& file() { return m_file; }
    Autosave& autosave() { return m_autosave; }
    Selection& selection() { return m_selection; }
    BondPainter& bondPainter() { return m_bondPainter; }
    Bakes& bakes() { return m_bakes; }
    Sections& sections() { return m_sections; }
    ProblemWatch& problems() { return m_problems; }
    MortarWatch& mortars() { return m_mortars; }
    Baker& baker() { return m_baker; }
    PlayController& play() { return m_play; }
    PlayTestRunner& playTests() { return m_playTests; }
    VideoExporter& videos() { return m_videos; }
    SwapAuditRunner& swapAudits() { return m_swapAudits; }

    /// Returns the active asset, or null if there is none.
    const Asset* asset() const { return findAsset(project(), m_selection.asset()); }

private:
    Document m_document;
    DocumentFile m_file;
    Autosave m_autosave;
    Selection m_selection;
    BondPainter m_bondPainter;
    Bakes m_bakes;
    Sections m_sections;
    SectionUpdater m_sectionUpdater;
    ProblemWatch m_problems;
    MortarWatch m_mortars;
    Baker m_baker;
    PlayController m_play;
    PlayTestRunner m_playTests;
    SwapAuditRunner m_swapAudits;
    VideoExporter m_videos;
};

}  // namespace rubble
