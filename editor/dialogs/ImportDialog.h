#pragma once

#include "core/asset/import/AssetImport.h"
#include "core/base/Result.h"
#include "editor/document/Edit.h"
#include "editor/document/Messages.h"
#include "editor/workspace/Preferences.h"

#include <QDialog>

#include <filesystem>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble {

class ImportView;
class OutlinePreview;

/// Asks how to import a mesh file, and shows the meshes, the prisms fitted to them and why objects are refused.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const QString& path, const Project& project, const Preferences& preferences, QWidget* parent);

    /// Reads the file with the importer program and shows progress. Returns false if it cannot be read, after showing
    /// the error, or if the user cancels.
    bool read(const std::filesystem::path& importer);
    /// The edit that imports, once the dialog was accepted.
    Edit edit() const;
    Id firstAsset() const;
    /// What was merged, flipped, omitted or refused.
    std::vector<Message> messages() const;

private:
    void createFields();
    QWidget* createOptions();
    ImportOptions options() const;
    double fileUnit() const;
    void updateMesh();
    void updateOutcome();
    void updateSummary(const Result<ImportOutcome>& outcome);
    void fillTable();
    void showRow(int row);

    QString m_path;
    const Project& m_project;
    SourceScene m_scene;
    std::optional<ImportOutcome> m_outcome;
    QLabel* m_summary;
    QComboBox* m_unit;
    QComboBox* m_up;
    QComboBox* m_axis;
    QComboBox* m_fallback;
    QTableWidget* m_table;
    ImportView* m_view;
    OutlinePreview* m_preview;
    QLabel* m_notes;    // about the asset of the current row
    QLabel* m_refused;  // the objects that cannot be imported
    QPushButton* m_import = nullptr;
};

}  // namespace rubble
