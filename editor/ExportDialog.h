#pragma once

#include "core/io/PackMeshes.h"
#include "editor/Workspace.h"
#include "editor/document/Messages.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace rubble {

/// What an export writes and where.
struct ExportChoice {
    QString folder;
    std::optional<std::vector<Id>> assets;  // none: all there are when it is carried out
    MeshOptions meshes;
};

/// How the project was exported last; kept beside the preferences, by the project's path. None where it never was. Of
/// chosen assets those that are still there.
std::optional<ExportChoice> lastExport(Workspace& workspace);

/// Exports, with progress and a way to cancel, and keeps the choice as the project's last. Gives a sentence that says what
/// was done or why not; faults go to the user in a box, and all of it to the messages.
QString exported(Workspace& workspace, const ExportChoice& choice, Messages& messages, QWidget* parent);

/// Asks what to export, and shows what will be written.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(Workspace& workspace, QWidget* parent);
    ExportChoice choice() const;

private:
    void makeFields();
    void fill(const ExportChoice& choice);
    void browse();
    std::vector<Id> chosenAssets() const;
    void update();

    Workspace& m_workspace;
    QListWidget* m_assets;
    QLineEdit* m_folder;
    QCheckBox* m_obj;
    QCheckBox* m_glb;
    QComboBox* m_split;
    QComboBox* m_place;
    QComboBox* m_faces;
    QLabel* m_summary;
    QPushButton* m_export = nullptr;
};

}  // namespace rubble
