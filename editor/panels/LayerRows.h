#pragma once

#include "core/fracture/PatternKind.h"
#include "editor/panels/Form.h"
#include "editor/panels/Section.h"

namespace rubble {

/// A row a parameter of one kind of layer, made of what the kind tells of them.
class LayerRows : public Section {
    Q_OBJECT
public:
    using LayerForm = Form<PatternLayer>;

    LayerRows(const PatternKind& kind, Document& document, const LayerForm::Chosen& chosen, const LayerForm::Push& push,
              QWidget* parent = nullptr);

    const PatternKind& kind() const { return m_kind; }
    void setUnits(const Units& units);
    /// Shows a layer of the kind, which `chosen` gives, too, and which is to fill an area of so many m².
    void refresh(const PatternLayer& layer, double area);

signals:
    void refused(const QString& sentence);

private:
    void addParameter(const LayerParameter& parameter);
    QWidget* addNumber(const LayerParameter& parameter, const QString& step);
    template <class Control, class Read, class Write>
    void bindNumber(Control* control, Quantity quantity, const QString& step, Read read, Write write);
    QWidget* addChoice(const LayerParameter& parameter, const QString& step);
    void addCount(const LayerParameter& parameter, const QString& step);
    void addPoint(const LayerParameter& parameter, const QString& step);

    const PatternKind& m_kind;
    LayerForm m_form;
    double m_area = 1.0;  // m^2
    std::vector<std::function<void(const Units&)>> m_takeUnits;
    std::vector<std::function<void(const PatternLayer&)>> m_showUsed;
};

}  // namespace rubble
