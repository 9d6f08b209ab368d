#pragma once

#include "editor/panels/LayerPage.h"

class QListView;
class QToolButton;

namespace rubble {

/// The recipe by which an asset breaks: the layers of seeds of the whole and of each level below, and the parameters of
/// the current layer.
class PatternEditor : public QWidget {
    Q_OBJECT
public:
    explicit PatternEditor(Document& document, QWidget* parent = nullptr);

    QListView& view() { return *m_view; }
    LayerPage& page() { return *m_page; }
    void setUnits(const Units& units);
    /// Shows an asset's patterns as they are now: first that of the whole, or that which breaks the fragment one goes into.
    void refresh(Id asset, const FragmentPath& inside);

    /// Adds a layer behind the others and makes it the current one.
    void addLayer(const LayerParameters& parameters);
    /// Makes a layer the current one.
    void showLayer(Id layer);

signals:
    void refused(const QString& sentence);

private:
    QWidget* levelRow();
    QWidget* buttonRow();
    void addMove(Qt::Key key, int by);
    void showLevels();
    void showCurrent();
    void setLevel(std::size_t level);
    void showPlace();
    std::vector<Asset> chosen() const;

    Document& m_document;
    PatternPlace m_place;
    std::size_t m_insideLevel = 0;  // the place of the pattern that the canvas shows
    Id m_layer = 0;
    LayerModel* m_model;
    QComboBox* m_levels;
    QToolButton* m_removeLevel = nullptr;
    Form<Asset> m_form;
    Section* m_ofLevel;
    NumberField* m_minimumVolume;
    QListView* m_view;
    LayerPage* m_page;
};

}  // namespace rubble
