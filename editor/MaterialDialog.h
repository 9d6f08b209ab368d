#pragma once

#include "core/io/MaterialFile.h"
#include "editor/commands/MaterialEdits.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace rubble {

class PatternPreview;

/// Where a user's own presets lie.
QString materialFolder();

/// The library of materials: what the program brings and what lies in a folder, with figures and sources. What is chosen is used for the
/// asset at hand, or added to the project.
class MaterialDialog : public QDialog {
    Q_OBJECT
public:
    MaterialDialog(Document& document, Selection& selection, const QString& folder, QWidget* parent = nullptr);

private:
    QWidget* makeChoices();
    void fill();
    void show(int row);
    void use();
    void add();
    const LibraryMaterial* chosen() const;
    const Asset* asset() const;

    Document& m_document;
    Selection& m_selection;
    MaterialLibrary m_library;
    QString m_folder;
    QListWidget* m_list;
    QTextBrowser* m_sheet;
    PatternPreview* m_preview;
    QCheckBox* m_takesPattern = nullptr;
    QCheckBox* m_derives = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_add = nullptr;
};

}  // namespace rubble
