#pragma once

#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/panels/Units.h"

#include <QStringList>
#include <QWidget>

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
