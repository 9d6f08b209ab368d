#pragma once

#include "editor/panels/inspector/LayerPage.h"

class QListView;
class QToolButton;

namespace rubble {

/// Edits the patterns of an asset: a box that selects one of them, its layers, and the parameters of the current layer.
class PatternEditor : public QWidget {
    Q_OBJECT
public:
    explicit PatternEditor(Document& document, QWidget* parent = nullptr);

    QListView& view() { return *m_view; }
    LayerPage& page() { return *m_page; }
    void setUnits(const Units& units);
    /// Shows an asset's patterns; switches to the pattern of the entered fragment when that changes.
    void refresh(Id asset, const FragmentPath& enteredFragment);

    /// Appends a layer and makes it the current one.
    void addLayer(const LayerParameters& parameters);
    /// Makes a layer the current one.
    void showLayer(Id layer);

signals:
    void refused(const QString& sentence);

private:
    void buildView();
    void buildLevelSettings();
    QWidget* patternRow();
    QWidget* buttonRow();
    void addMoveShortcut(Qt::Key key, int by);
    void showPatternList();
    void showCurrent();
    void setPattern(std::size_t index);
    void showPattern();
    std::vector<Asset> selected() const;
    std::optional<double> levelThreshold(const Asset& asset) const;

    Document& m_document;
    PatternRef m_pattern;
    std::size_t m_enteredPattern = 0;  // index of the pattern of the entered fragment
    Id m_layer = 0;
    LayerModel* m_model;
    QComboBox* m_patterns;
    QToolButton* m_removeLevel = nullptr;
    Form<Asset> m_form;
    Section* m_levelSettings;
    NumberField* m_minimumVolume;
    QCheckBox* m_hasThreshold;
    SliderField* m_threshold;
    SliderField* m_bondStrength;
    QListView* m_view;
    LayerPage* m_page;
};

}  // namespace rubble
