#pragma once

#include "core/fracture/pattern/PatternKind.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

namespace rubble {

/// The parameters of one kind of layer, one per row, built from the kind's description.
class LayerSection : public Section {
    Q_OBJECT
public:
    using LayerForm = Form<PatternLayer>;

    LayerSection(const PatternKind& kind, Document& document, const LayerForm::Selected& selected,
                 const LayerForm::Push& push, QWidget* parent = nullptr);

    const PatternKind& kind() const { return m_kind; }
    void setUnits(const Units& units);
    /// Shows a layer of this kind, the one that `selected` returns. `size`: what it fills, m² of an outline or m³ of
    /// a mesh.
    void refresh(const PatternLayer& layer, double size, SeedSpace space);

signals:
    void refused(const QString& sentence);

private:
    void addParameter(const LayerParameter& parameter);
    QWidget* addNumber(const LayerParameter& parameter, const QString& step);
    template <class Control, class Read, class Write>
    void bindNumber(Control* control, Quantity quantity, const QString& step, Read read, Write write);
    QWidget* addOption(const LayerParameter& parameter, const QString& step);
    void addCount(const LayerParameter& parameter, const QString& step);
    void addPoint(const LayerParameter& parameter, const QString& step);

    const PatternKind& m_kind;
    LayerForm m_form;
    double m_size = 1.0;  // m² or m³
    SeedSpace m_space = SeedSpace::Plane;
    std::vector<std::function<void(const Units&)>> m_unitSetters;
    std::vector<std::function<void(const PatternLayer&)>> m_rowUpdates;
};

}  // namespace rubble
