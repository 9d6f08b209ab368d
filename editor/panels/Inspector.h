#pragma once

#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/panels/Units.h"

#include <QList>
#include <QStringList>
#include <QWidget>

class QAction;
class QScrollArea;
class QStackedWidget;

namespace rubble {

class AssetPage;
class InstancePage;
class MaterialPage;
class ScenePage;

/// The dock with all numbers of what was chosen last: an asset, a material, instances, or the scene.
class Inspector : public QWidget {
    Q_OBJECT
public:
    Inspector(Document& document, Selection& selection, QWidget* parent = nullptr);

    void setUnits(const Units& units);
    /// What is offered as buttons: on the page of a material all, on that of an asset the first, the library.
    void setMaterialActions(const QList<QAction*>& actions);
    /// The names of the sections that are folded; kept by whoever keeps the window's layout.
    QStringList folded() const;
    void setFolded(const QStringList& names);
    /// The page that is shown.
    QWidget& page();

signals:
    /// Something was not taken, and why.
    void refused(const QString& sentence);

private:
    void showSubject();
    void refresh();

    Document& m_document;
    Selection& m_selection;
    AssetPage* m_asset;
    MaterialPage* m_material;
    InstancePage* m_instance;
    ScenePage* m_scene;
    QStackedWidget* m_pages;
};

}  // namespace rubble
