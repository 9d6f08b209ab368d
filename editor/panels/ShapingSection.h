#pragma once

#include "editor/panels/Form.h"
#include "editor/panels/Section.h"
#include "editor/panels/Units.h"

namespace rubble {

class Selection;

/// What is done to the pieces of the asset at hand: small ones, the gap between them, rough cuts.
class ShapingSection : public Section {
    Q_OBJECT
public:
    ShapingSection(Document& document, const Selection& selection, QWidget* parent = nullptr);

    void refresh();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    std::vector<Asset> chosen() const;
    void buildSmallPieces();
    void buildRoughness();
    void showUsed();

    Document& m_document;
    const Selection& m_selection;
    Units m_units;
    Form<Asset> m_form;
    QComboBox* m_measure = nullptr;
    NumberField* m_limit = nullptr;
    SliderField* m_part = nullptr;
    NumberField* m_gap = nullptr;
    NumberField* m_amplitude = nullptr;
    std::vector<QWidget*> m_ofRoughness;  // rows that count where cuts are rough
};

}  // namespace rubble
