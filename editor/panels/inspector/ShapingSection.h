#pragma once

#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/numbers/Units.h"

namespace rubble {

class Selection;

/// The shaping of the active asset's fragments: small ones, the gap between them, rough fracture surfaces.
class ShapingSection : public Section {
    Q_OBJECT
public:
    ShapingSection(Document& document, const Selection& selection, QWidget* parent = nullptr);

    void refresh();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    std::vector<Asset> selected() const;
    void buildSmallPieces();
    void buildRoughness();
    void updateRows();

    Document& m_document;
    const Selection& m_selection;
    Units m_units;
    Form<Asset> m_form;
    QComboBox* m_measure = nullptr;
    NumberField* m_limit = nullptr;
    SliderField* m_fraction = nullptr;
    NumberField* m_gap = nullptr;
    NumberField* m_amplitude = nullptr;
    std::vector<QWidget*> m_roughnessRows;  // shown if the roughness is not 0
};

}  // namespace rubble
