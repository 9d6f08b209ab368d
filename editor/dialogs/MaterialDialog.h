#pragma once

#include "core/io/project/MaterialPresetFile.h"
#include "editor/commands/MaterialEdits.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/widgets/numbers/Units.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace rubble {

class MaterialPictures;
class PatternPreview;

/// Returns the folder of the user's presets.
QString materialFolder();

/// The material library: the built-in presets and those of a folder, with properties and sources. Applies a preset to
/// the active asset, or adds it to the project.
/// Presets have their colours, and pictures once there are some.
class MaterialDialog : public QDialog {
    Q_OBJECT
public:
    MaterialDialog(Document& document, Selection& selection, MaterialPictures& pictures, const QString& folder,
                   const Units& units, QWidget* parent = nullptr);

private:
    QWidget* createOptions();
    void fill();
    void showPictures();
    void showSelected();
    void showThreshold();
    QString thresholdNote(const Asset& asset, const MaterialPreset& preset) const;
    void applyToAsset();
    void addToProject();
    const LibraryMaterial* selected() const;
    const Asset* asset() const;

    Document& m_document;
    Selection& m_selection;
    MaterialPictures& m_pictures;
    MaterialLibrary m_library;
    QString m_folder;
    Units m_units;
    QListWidget* m_list;
    QTextBrowser* m_summary;
    PatternPreview* m_preview;
    QCheckBox* m_appliesPattern = nullptr;
    QCheckBox* m_derivesThreshold = nullptr;
    QLabel* m_thresholdNote = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_add = nullptr;
};

}  // namespace rubble
