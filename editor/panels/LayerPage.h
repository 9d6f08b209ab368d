#pragma once

#include "editor/panels/Form.h"
#include "editor/panels/LayerModel.h"
#include "editor/panels/Section.h"

class QLabel;
class QPushButton;

namespace rubble {

/// The parameters of one layer of a pattern.
class LayerPage : public QWidget {
    Q_OBJECT
public:
    explicit LayerPage(Document& document, QWidget* parent = nullptr);

    void setLayer(PatternPlace place, Id layer);
    void setUnits(const Units& units) { m_distance->setFormat(units.lengths()); }
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    std::vector<PatternLayer> chosen() const;
    void push(std::vector<PatternLayer> layers, const QString& text, quint64 stroke);
    void buildScatters();
    void buildOverrides();
    void showOverrides(const PatternLayer& layer);

    Document& m_document;
    PatternPlace m_place;
    Id m_layer = 0;
    Form<PatternLayer> m_form;
    Section* m_rows;
    SliderField* m_count = nullptr;
    SliderField* m_distance = nullptr;
    NumberField* m_most = nullptr;
    QComboBox* m_domain = nullptr;
    SliderField* m_rounds = nullptr;
    RandomSeedField* m_randomSeed = nullptr;
    QLabel* m_placed = nullptr;
    QWidget* m_overrides = nullptr;
    QLabel* m_overridesText = nullptr;
    QPushButton* m_restore = nullptr;
};

}  // namespace rubble
