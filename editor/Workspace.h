#pragma once

#include "editor/Baker.h"
#include "editor/document/Autosave.h"
#include "editor/document/DocumentFile.h"
#include "editor/document/ProblemWatch.h"
#include "editor/play/AssetTrials.h"
#include "editor/play/FilmMaker.h"
#include "editor/play/PlayController.h"
#include "editor/play/PlayTestRunner.h"

namespace rubble {

/// All that one window works on: a document with where it lies, its backup, what is chosen in it,
/// what was baked of it, what of that is to be looked at, and how it plays.
class Workspace : public QObject {
    Q_OBJECT
public:
    /// `backups`: the folder for the document's backup.
    Workspace(Project project, const QString& backups, QObject* parent = nullptr);

    Document& document() { return m_document; }
    const Project& project() const { return m_document.project(); }
    DocumentFile& file() { return m_file; }
    Autosave& autosave() { return m_autosave; }
    Selection& selection() { return m_selection; }
    Bakes& bakes() { return m_bakes; }
    ProblemWatch& problems() { return m_problems; }
    Baker& baker() { return m_baker; }
    PlayController& play() { return m_play; }
    PlayTestRunner& playTests() { return m_playTests; }
    FilmMaker& films() { return m_films; }
    AssetTrials& trials() { return m_trials; }

    /// The asset at hand; null where there is none.
    const Asset* asset() const { return findAsset(project(), m_selection.asset()); }

private:
    Document m_document;
    DocumentFile m_file;
    Autosave m_autosave;
    Selection m_selection;
    Bakes m_bakes;
    ProblemWatch m_problems;
    Baker m_baker;
    PlayController m_play;
    PlayTestRunner m_playTests;
    AssetTrials m_trials;
    FilmMaker m_films;
};

}  // namespace rubble
