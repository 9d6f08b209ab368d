#pragma once

#include "editor/document/Selection.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

#include <array>

class QPushButton;

namespace rubble {

/// The inspector's page for the selected instances. Properties that differ between them are shown as mixed.
class InstancePage : public QWidget {
    Q_OBJECT
public:
    InstancePage(Document& document, Selection& selection, QWidget* parent = nullptr);
    void refresh();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    std::vector<Instance> selected() const;
    void buildInstance(Section& section);
    void buildTransform(Section& section);
    void buildStrength(Section& section);
    void buildBonds(Section& section);
    QCheckBox* addCheckBox(Section& section, const QString& label, const QString& hint, const QString& step,
                           bool Instance::*member);
    bool isBonded(const Instance& instance) const;
    Vec3 degreesOf(const Instance& instance) const;
    void rotate(Instance& instance, int axis, double degrees);

    Document& m_document;
    Selection& m_selection;
    Form<Instance> m_form;
    Section* m_instance;
    QLineEdit* m_name = nullptr;
    QComboBox* m_asset = nullptr;
    QPushButton* m_editAsset = nullptr;
    std::array<NumberField*, 3> m_position{};
    QCheckBox* m_hasThreshold = nullptr;
    SliderField* m_threshold = nullptr;
    Section* m_strength;
    QCheckBox* m_anchored = nullptr;
    SliderField* m_bondStrength = nullptr;
    Quat m_typedOrientation{1.0, 0.0, 0.0,
                            0.0};  // the last typed angles and their orientation, since angles are not unique
    Vec3 m_typedDegrees{0.0, 0.0, 0.0};
};

}  // namespace rubble
