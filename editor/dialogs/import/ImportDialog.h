#pragma once

#include "core/asset/import/AssetImport.h"
#include "editor/document/Edit.h"
#include "editor/document/Messages.h"
#include "editor/document/jobs/BackgroundJob.h"
#include "editor/workspace/Preferences.h"

#include <QDialog>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QSpinBox;
class QTableWidget;

namespace rubble {

class ImportView;
class OutlinePreview;

/// Asks how to import a mesh file, and shows the meshes, the prisms or closed meshes that they become, why objects
/// are refused and where they cannot be cut, and a button for each fallback that imports some of these. All this is
/// searched for in the background, again after each change of the options.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const QString& path, const Project& project, const Preferences& preferences, QWidget* parent);

    /// Reads the file with the importer program and shows progress. Returns false if it cannot be read, after showing
    /// the error, or if the user cancels.
    bool read(const std::filesystem::path& importer);
    /// The edit that performs the import, once the dialog has been accepted.
    Edit edit() const;
    /// The imported assets.
    std::vector<Id> assets() const;
    /// Messages about merged, flipped, omitted and refused elements.
    std::vector<Message> messages() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Found;

    void createFields();
    void createRefused();
    QWidget* createOptions();
    ImportOptions options() const;
    double fileUnit() const;
    void updateOptions();
    void showSummary();
    void updateMesh();
    void search();
    void apply(Found found);
    void showRefused(const QStringList& sentences);
    void showProblems();
    void frameNextProblem();
    void fitRefused();
    void offerFallbacks();
    void use(const WorkingFallback& fallback);
    void fillTable();
    void fitTable();
    void showOutline(const ImportedAsset* imported);
    void showRow(int row);

    QString m_path;
    Units m_units;
    const Project& m_project;
    std::shared_ptr<const SourceScene> m_scene;
    bool m_isModelOutdated = true;  // the meshes shown have another unit or up axis
    std::optional<ImportOutcome> m_outcome;
    QLabel* m_summary;
    QComboBox* m_unit;
    QComboBox* m_up;
    QComboBox* m_as;
    QComboBox* m_axis;
    QComboBox* m_fallback;
    QCheckBox* m_mergeEqual;
    QSpinBox* m_fragments;  // of each asset, about
    QTableWidget* m_table;
    ImportView* m_view;
    QLabel* m_previewTitle;
    OutlinePreview* m_preview;
    QLabel* m_notes;    // about the asset of the current row
    QLabel* m_refused;  // the objects that cannot be imported, and why
    QScrollArea* m_refusedArea;
    QPushButton* m_showProblem;      // where one of them cannot be cut
    std::size_t m_problemCount = 0;  // of these
    std::size_t m_nextProblem = 0;   // to be framed
    QWidget* m_fallbacks;            // a button for each that imports some of them
    QHBoxLayout* m_fallbackRow;
    QProgressBar* m_progress;  // visible during a search
    QPushButton* m_import = nullptr;
    BackgroundJob m_job;
};

}  // namespace rubble
