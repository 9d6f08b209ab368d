#pragma once

#include "editor/dialogs/ProjectExport.h"

#include <QDialog>

#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace rubble {

class ExportTree;
struct ExportFormat;
struct ExportOption;

/// Asks what to export, and shows what will be written.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(Workspace& workspace, QWidget* parent);
    ExportOptions options() const;

private:
    void addFields();
    void addForm();
    void addOptions(QFormLayout& form);
    QWidget* createTargets();
    void listTargets();
    void forgetTarget();
    QGridLayout* createFormats() const;
    void showOptions(const ExportOptions& options);
    void showFiles(const PackOptions& pack);
    void browse();
    std::vector<Id> selectedAssets() const;
    bool isOfOtherProgram(const QString& folder, const ExportTarget* target) const;
    QString folderFor(const ExportTarget* target) const;
    void applyTarget();
    void refresh();

    Workspace& m_workspace;
    std::vector<ExportOptions> m_targets;  // of earlier exports
    QComboBox* m_targetList = nullptr;
    QListWidget* m_assets;
    QLineEdit* m_folder;
    QComboBox* m_contents;
    QComboBox* m_target;
    QLabel* m_description;
    std::vector<std::pair<const ExportFormat*, QCheckBox*>> m_formats;
    std::vector<std::pair<const ExportOption*, QComboBox*>> m_options;  // those with a caption
    QCheckBox* m_onSave;
    ExportTree* m_tree;
    QLabel* m_problem;
    QPushButton* m_export = nullptr;
};

}  // namespace rubble
