#pragma once

#include "core/asset/AssetImport.h"
#include "core/base/Result.h"
#include "editor/Preferences.h"
#include "editor/document/Edit.h"
#include "editor/document/Messages.h"

#include <QDialog>

#include <filesystem>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble {

class ImportView;
class OutlinePreview;

/// Shows what a mesh file holds and what of it would become assets: the meshes and the prisms found in them, outlines,
/// depths, axes, unit and tolerance; and asks how it is to be taken.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const QString& path, const Project& project, const Preferences& preferences, QWidget* parent);

    /// Reads the file by the importer's program, with progress. False where it could not be read, which the user has been told, or was cancelled.
    bool read(const std::filesystem::path& importer);
    /// What an accepted dialog does to the project.
    Edit edit() const;
    Id firstAsset() const;
    /// What was merged, turned or left out, and what was refused.
    std::vector<Message> messages() const;

private:
    void makeFields();
    QWidget* makeOptions();
    ImportOptions options() const;
    double metresPerUnit() const;
    /// Takes the scene anew by the options.
    void update();
    void showMesh();
    void showFound(const Result<ImportOutcome>& outcome);
    void fillTable();
    void showRow(int row);

    QString m_path;
    const Project& m_project;
    SourceScene m_scene;
    std::optional<ImportOutcome> m_outcome;
    QLabel* m_found;
    QComboBox* m_unit;
    QComboBox* m_up;
    QComboBox* m_axis;
    QComboBox* m_fallback;
    QTableWidget* m_table;
    ImportView* m_view;
    OutlinePreview* m_preview;
    QLabel* m_notes;    // on the row's asset
    QLabel* m_refused;  // what does not come through
    QPushButton* m_import = nullptr;
};

}  // namespace rubble
