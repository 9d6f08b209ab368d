#pragma once

#include "core/asset/AssetImport.h"
#include "core/base/Result.h"
#include "editor/document/Edit.h"
#include "editor/document/Messages.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble {

class OutlinePreview;

/// Shows what a mesh file holds and what of it would become assets: outlines, depths, axes, unit and tolerance; and asks
/// how it is to be taken.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const QString& path, const Project& project, QWidget* parent);

    /// Reads the file, with progress. False where it could not be read, which the user has been told, or was cancelled.
    bool read();
    /// What an accepted dialog does to the project.
    Edit edit() const;
    Id firstAsset() const;
    /// What was merged, turned or left out, and what was refused.
    std::vector<Message> messages() const;

private:
    void makeFields();
    ImportOptions options() const;
    /// Takes the scene anew by the options.
    void update();
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
    OutlinePreview* m_preview;
    QLabel* m_notes;    // on the row's asset
    QLabel* m_refused;  // what does not come through
    QPushButton* m_import = nullptr;
};

}  // namespace rubble
