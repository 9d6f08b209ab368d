#pragma once

#include "editor/panels/models/LayerModel.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

#include <memory>

class QLabel;
class QPushButton;

namespace rubble {

class LayerSection;
class PictureField;

/// The inspector's page for one layer of a pattern.
class LayerPage : public QWidget {
    Q_OBJECT
public:
    explicit LayerPage(Document& document, QWidget* parent = nullptr);
    ~LayerPage() override;

    void setLayer(PatternRef pattern, Id layer);
    void setUnits(const Units& units);
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    std::vector<PatternLayer> selected() const;
    void push(std::vector<PatternLayer> layers, const QString& text, quint64 mergeKey);
    void buildRandomSeed();
    void buildPicture();
    void buildOverrides();
    SeedSpace space() const;
    double domainSize(const PatternLayer& layer) const;
    LayerSection& sectionFor(const PatternLayer& layer);
    void showOverrides(const PatternLayer& layer);

    Document& m_document;
    Units m_units;
    PatternRef m_pattern;
    Id m_layer = 0;
    Form<PatternLayer> m_form;
    std::unique_ptr<LayerSection> m_parameters;  // of the layer's kind
    Section* m_common;                           // rows that several kinds share
    RandomSeedField* m_randomSeed = nullptr;
    PictureField* m_picture = nullptr;
    QLabel* m_placed = nullptr;
    QWidget* m_overrides = nullptr;
    QLabel* m_overridesText = nullptr;
    QPushButton* m_restore = nullptr;
    QPushButton* m_scatterAnew = nullptr;
};

}  // namespace rubble
