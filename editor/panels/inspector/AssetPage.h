#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/inspector/BondSection.h"
#include "editor/panels/inspector/ClusterSection.h"
#include "editor/panels/inspector/FragmentSection.h"
#include "editor/panels/inspector/OutlineEditor.h"
#include "editor/panels/inspector/PatternEditor.h"
#include "editor/panels/inspector/ShapingSection.h"

#include <array>

namespace rubble {

/// The inspector's page for the active asset: material and threshold, bonds, shape, fragments, pattern.
class AssetPage : public QWidget {
    Q_OBJECT
public:
    AssetPage(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    void refresh();
    /// Sets the action that opens the material library, shown as a button.
    void setLibraryAction(QAction* action);
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    std::vector<Asset> selected() const;
    QString faultOf(const Asset& asset) const;
    void buildAsset(Section& section);
    void buildThreshold(Section& section);
    void buildBreakAs(Section& section);
    void showWayToBreak(const Asset& asset);
    void buildShape(Section& section);
    QWidget* createTexture();
    void showTexture(const Asset& asset);
    void showThreshold(const Asset& asset);
    QString summary(const Asset& asset) const;

    Document& m_document;
    const Selection& m_selection;
    Units m_units;
    Form<Asset> m_form;
    QComboBox* m_material = nullptr;
    QComboBox* m_inside = nullptr;
    QLabel* m_breakNote = nullptr;
    SliderField* m_cutFragments = nullptr;
    SliderField* m_cutRadius = nullptr;
    QComboBox* m_sources = nullptr;  // of the threshold
    QWidget* m_texture = nullptr;
    QLabel* m_textureText = nullptr;
    Section* m_asset = nullptr;
    SliderField* m_threshold = nullptr;
    NumberField* m_contactTime = nullptr;
    QLabel* m_derivation = nullptr;  // formula of the derived threshold, or why there is none
    QLabel* m_summary = nullptr;
    std::array<NumberField*, 3> m_size{};
    BondSection* m_bonds = nullptr;
    ClusterSection* m_clusters = nullptr;
    FragmentSection* m_fragments = nullptr;
    OutlineEditor* m_outline = nullptr;
    ShapingSection* m_shaping = nullptr;
    PatternEditor* m_pattern = nullptr;
};

}  // namespace rubble
