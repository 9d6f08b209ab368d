#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/widgets/numbers/Units.h"

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
class MortarWatch;
class ScenePage;

/// The dock with the properties of what was selected last: an asset, a material, instances or the scene.
class Inspector : public QWidget {
    Q_OBJECT
public:
    Inspector(Document& document, Selection& selection, const Bakes& bakes, const MortarWatch& joints,
              QWidget* parent = nullptr);

    void setUnits(const Units& units);
    /// Sets the actions shown as buttons: both on a material's page, that for the library on an asset's page.
    void setMaterialActions(QAction* library, QAction* save);
    /// The object names of the collapsed sections, to be saved with the window's layout.
    QStringList collapsedSections() const;
    void setCollapsedSections(const QStringList& names);
    /// The visible page.
    QWidget& page();

signals:
    /// An edit was refused; the sentence says why.
    void refused(const QString& sentence);

private:
    QWidget& pageOf(Part subject);
    void showPage();
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
