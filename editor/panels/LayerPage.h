#pragma once

#include "editor/panels/Form.h"
#include "editor/panels/LayerModel.h"
#include "editor/panels/Section.h"

#include <memory>

class QLabel;
class QPushButton;

namespace rubble {

class LayerRows;
class PictureField;

/// The parameters of one layer of a pattern.
class LayerPage : public QWidget {
    Q_OBJECT
public:
    explicit LayerPage(Document& document, QWidget* parent = nullptr);
    ~LayerPage() override;

    void setLayer(PatternPlace place, Id layer);
    void setUnits(const Units& units);
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    std::vector<PatternLayer> chosen() const;
    void push(std::vector<PatternLayer> layers, const QString& text, quint64 stroke);
    void buildRandomSeed();
    void buildPicture();
    void buildOverrides();
    double areaToFill() const;
    LayerRows& rowsOf(const PatternLayer& layer);
    void showOverrides(const PatternLayer& layer);

    Document& m_document;
    Units m_units;
    PatternPlace m_place;
    Id m_layer = 0;
    Form<PatternLayer> m_form;
    std::unique_ptr<LayerRows> m_rows;  // of the layer's kind
    Section* m_common;                  // rows that several kinds have
    RandomSeedField* m_randomSeed = nullptr;
    PictureField* m_picture = nullptr;
    QLabel* m_placed = nullptr;
    QWidget* m_overrides = nullptr;
    QLabel* m_overridesText = nullptr;
    QPushButton* m_restore = nullptr;
};

}  // namespace rubble
